"""The verdict on each printed equation, computed from the facts of a ledger."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from rigidsym.proof.paper.equation import Equation, Reading
from rigidsym.proof.paper.equations import EQUATIONS
from rigidsym.view.html.printed import verdict_html

# What the paper assumes throughout: a body with inertia that moves.
STANDING = {"c1", "c2", "c3", "c_i", "c_j", "c_k", "c_a", "c_b", "c_d", "K"}
# Units that their contexts keep from zero: K and rho are nonnegative, |M_a| <= K, side is +-1.
NEVER_ZERO = {"nu", "K + sigma*c_a*Omega_a", "side", "1 + side*(cos_half**2 - sin_half**2)"}


class Ruling(StrEnum):
    """What a verdict can be."""

    HOLDS = "holds"
    CONDITIONAL = "holds if"
    MISPRINT = "misprint"
    AMBIGUOUS = "ambiguous"
    OPEN = "open"


@dataclass(frozen=True, slots=True)
class Verdict:
    """The ruling on one equation, with what belongs to it.

    `conditions` are those of the equation, or of its repair where it is a misprint; `points` gives
    the counterexample of each refuting fact, `repairs` what the repair search found.
    """

    equation: Equation
    ruling: Ruling
    conditions: tuple[str, ...] = ()
    points: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    repairs: tuple[str, ...] = ()
    mutants: Mapping[str, int] = field(default_factory=dict)

    @property
    def counterexample(self) -> Mapping[str, str] | None:
        """Where the equation as printed fails, in exact numbers."""
        return next((self.points.get(name) for name in self.equation.refuted_by), None)

    def to_json(self) -> dict[str, Any]:
        """Plain data for programs."""
        equation = self.equation
        return {
            "equation": equation.number,
            "latex": equation.latex,
            "reading": equation.reading,
            "verdict": self.ruling.value,
            "conditions": list(self.conditions),
            "repair": equation.repair,
            "repairs_found": list(self.repairs),
            "counterexample": self.counterexample,
            "proved_by": list(equation.proved_by),
            "refuted_by": list(equation.refuted_by),
            "needed_by": list(equation.needed_by),
            "conditions_needed_by": {c.text: list(c.needed_by) for c in equation.conditions},
            "readings": [self._reading(reading) for reading in equation.readings],
            "flaws": {flaw.value: text for flaw, text in equation.flaws.items()},
            "mutants": dict(self.mutants),
        }

    def _repr_latex_(self) -> str:
        return f"${self.equation.repair or self.equation.latex}$"

    def _repr_html_(self) -> str:
        return verdict_html(self)

    def _reading(self, reading: Reading) -> dict[str, Any]:
        return {
            "reading": reading.text,
            "implies": reading.implies,
            "holds": not reading.refuted_by,
            "proved_by": list(reading.proved_by),
            "refuted_by": list(reading.refuted_by),
            "counterexample": next((self.points.get(name) for name in reading.refuted_by), None),
        }


def verdicts(ledger: Mapping[str, Any]) -> list[Verdict]:
    """A verdict for every printed equation, from a ledger as it stands in JSON."""
    facts = {fact["id"]: fact for fact in ledger["facts"]}
    contexts = {context["name"]: context for context in ledger["contexts"]}
    ruled = [_verdict(equation, facts, contexts) for equation in EQUATIONS]
    published = ledger.get("published", {})
    mutants, found = published.get("mutants", {}), published.get("repairs", [])
    return [
        replace(
            verdict, mutants=_total(mutants, verdict.equation), repairs=_repairs(found, verdict)
        )
        for verdict in ruled
    ]


def _repairs(found: Iterable[Mapping[str, str]], verdict: Verdict) -> tuple[str, ...]:
    """The equations that a search found for a misprint."""
    misprints = verdict.equation.refuted_by if verdict.ruling == Ruling.MISPRINT else ()
    return tuple(f"{r['lhs']} = {r['rhs']}" for r in found if r["fact"] in misprints)


def _total(mutants: Mapping[str, Mapping[str, int]], equation: Equation) -> dict[str, int]:
    """The fates of the mutants of all that proves an equation, each with its count."""
    total = sum((Counter(mutants.get(name, {})) for name in equation.proved_by), Counter())
    return dict(sorted(total.items()))


def _verdict(equation: Equation, facts: Mapping[str, Any], contexts: Mapping[str, Any]) -> Verdict:
    """Open unless every fact that is named is there, proved, and of the kind it has to be."""
    sources = (equation, *equation.readings)
    proving = [name for source in sources for name in source.proved_by]
    refuting = [name for source in sources for name in source.refuted_by]
    sealed = (
        equation.proved_by
        and _proved(proving, facts, ("equal", "root"))
        and _proved(refuting, facts, ("unequal",))
        and _proved(equation.needed_by, facts, ("equal", "root", "unequal"))
    )
    if not sealed:
        return Verdict(equation, Ruling.OPEN)
    conditions = _conditions(equation, facts, contexts)
    points = {name: facts[name]["certificate"]["point"] for name in refuting}
    return Verdict(equation, ruling_of(equation, conditions), conditions, points)


def ruling_of(equation: Equation, conditions: Sequence[str]) -> Ruling:
    """Refuted and repaired is a misprint; readings that disagree are ambiguous."""
    if equation.refuted_by and equation.repair:
        return Ruling.MISPRINT
    fails = {bool(reading.refuted_by) for reading in equation.readings}
    if True in fails:
        return Ruling.AMBIGUOUS if False in fails else Ruling.OPEN
    return Ruling.CONDITIONAL if conditions else Ruling.HOLDS


def _proved(ids: Sequence[str], facts: Mapping[str, Any], kinds: Sequence[str]) -> bool:
    found = [facts[name] for name in ids if name in facts]
    return len(found) == len(ids) and all(
        fact["grade"] == "PROVED"
        and fact["kind"] in kinds
        and fact["id"].startswith(fact["context"] + ".")
        for fact in found
    )


def _conditions(
    equation: Equation, facts: Mapping[str, Any], contexts: Mapping[str, Any]
) -> tuple[str, ...]:
    """The stated conditions, and every unit of the proofs that none of them speaks for."""
    stated = tuple(condition.text for condition in equation.conditions)
    covered = {unit for condition in equation.conditions for unit in condition.units}
    units = needed_units(equation, facts, contexts)
    return stated + tuple(f"{unit} != 0" for unit in units if unit not in covered)


def needed_units(
    equation: Equation, facts: Mapping[str, Any], contexts: Mapping[str, Any]
) -> list[str]:
    """What the proofs of an equation divide by, beyond the standing assumptions."""
    named = sorted({facts[name]["context"] for name in equation.proved_by})
    units = dict.fromkeys(unit for name in named for unit in contexts[name]["units"])
    return [unit for unit in units if unit not in STANDING | NEVER_ZERO]
