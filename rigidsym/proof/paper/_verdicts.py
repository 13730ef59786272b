"""Verdicts on the printed equations, computed from a ledger's facts."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from rigidsym.proof.paper._answers import Answer, Answers, Data, all_hold, ids
from rigidsym.proof.paper._counterexample import Counterexample, counterexample
from rigidsym.proof.paper._equation import Equation, Reading, Root, Sense
from rigidsym.proof.paper._proof import PROOF
from rigidsym.proof.paper._section2 import SECTION_2
from rigidsym.proof.paper._section3 import SECTION_3
from rigidsym.proof.paper._section4 import SECTION_4
from rigidsym.view._proofs import verdict_html

# All printed equations, misprints kept.
EQUATIONS: tuple[Equation, ...] = (*SECTION_2, *SECTION_3, *SECTION_4, *PROOF)
# Nonzero throughout the paper: moments of inertia, and the momentum.
STANDING = {"c1", "c2", "c3", "c_i", "c_j", "c_k", "c_a", "c_b", "c_d", "K"}
# Divisors that never vanish in their contexts: K and rho are nonnegative, |M_a| <= K, side is +-1.
NEVER_ZERO = {"nu", "K + sigma*c_a*Omega_a", "side", "1 + side*(cos_half**2 - sin_half**2)"}


class Ruling(StrEnum):
    """Kind of a verdict on a printed equation."""

    HOLDS = "holds"
    CONDITIONAL = "holds if"
    MISPRINT = "misprint"
    AMBIGUOUS = "ambiguous"
    OPEN = "open"


@dataclass(frozen=True, slots=True)
class Read:
    """The verdict on one interpretation of an ambiguous equation.

    `holds` says whether the print holds with this reading.
    """

    reading: Reading
    holds: bool | None
    proved_by: tuple[str, ...]
    refuted_by: tuple[str, ...]
    counterexample: Counterexample | None

    def to_json(self) -> dict[str, Any]:
        """Return the verdict on this interpretation as JSON data."""
        return {
            "reading": self.reading.text,
            "implies": self.reading.implies,
            "holds": self.holds,
            "proved_by": list(self.proved_by),
            "refuted_by": list(self.refuted_by),
            "counterexample": self.counterexample.to_json() if self.counterexample else None,
        }


@dataclass(frozen=True, slots=True)
class Verdict:
    """The verdict on one printed equation, with the facts that support it.

    `conditions` are those of the equation, or of its repair if it is a misprint; `readings` are
    decided one by one; `right_with` are other lines whose repair makes this one right as printed;
    `counterexample` is a point where it fails, or where it would fail without a condition;
    `repairs` are those that the search for repairs found.
    """

    equation: Equation
    ruling: Ruling
    conditions: tuple[str, ...] = ()
    proved_by: tuple[str, ...] = ()
    refuted_by: tuple[str, ...] = ()
    repaired_by: tuple[str, ...] = ()
    needed_by: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    readings: tuple[Read, ...] = ()
    right_with: tuple[str, ...] = ()
    counterexample: Counterexample | None = None
    repairs: tuple[str, ...] = ()
    mutants: Mapping[str, int] = field(default_factory=dict)

    @property
    def roots(self) -> tuple[Root, ...]:
        """The paper's independent errors that explain a misprint."""
        return self.equation.roots

    def to_json(self) -> dict[str, Any]:
        """Return the verdict as JSON data."""
        equation = self.equation
        return {
            "equation": equation.number,
            "latex": equation.latex,
            "reading": equation.reading,
            "verdict": self.ruling.value,
            "conditions": list(self.conditions),
            "root_causes": [root.value for root in equation.roots],
            "right_as_printed_with": list(self.right_with),
            "repair": equation.repair,
            "repairs_found": list(self.repairs),
            "counterexample": self.counterexample.to_json() if self.counterexample else None,
            "proved_by": list(self.proved_by),
            "refuted_by": list(self.refuted_by),
            "repaired_by": list(self.repaired_by),
            "conditions_needed_by": {text: list(by) for text, by in self.needed_by.items()},
            "readings": [read.to_json() for read in self.readings],
            "flaws": {flaw.value: text for flaw, text in equation.flaws.items()},
            "mutants": dict(self.mutants),
        }

    def facts(self) -> tuple[str, ...]:
        """Return the ids of all facts that the verdict rests on.

        No id is repeated.
        """
        found = [*self.proved_by, *self.refuted_by, *self.repaired_by]
        for read in self.readings:
            found += [*read.proved_by, *read.refuted_by]
        for names in self.needed_by.values():
            found += names
        return tuple(dict.fromkeys(found))

    def __repr__(self) -> str:
        conditional = self.ruling is Ruling.CONDITIONAL
        where = f" {' and '.join(self.conditions)}" if conditional else ""
        return f"<Verdict on ({self.equation.number}): {self.ruling}{where}>"

    def _repr_latex_(self) -> str:
        return f"${self.equation.repair or self.equation.latex}$"

    def _repr_html_(self) -> str:
        return verdict_html(self)


def verdicts(ledger: Data, equations: Sequence[Equation] = EQUATIONS) -> list[Verdict]:
    """Return the verdicts on all printed equations.

    The ledger is JSON data.
    Raises PrintError for a print that cannot be read.
    """
    answers = Answers(ledger, equations)
    return [verdict(equation, answers, ledger.get("published", {})) for equation in equations]


def verdict(equation: Equation, answers: Answers, published: Data) -> Verdict:
    """Decide one printed equation by the facts of a ledger.

    It is open unless everything about the line is decided and its repair, if any, holds.
    """

    def answered(senses: Iterable[Sense], latex: str = equation.latex) -> list[Answer]:
        return [answers.to(latex, sense) for sense in senses]

    def first_failure(found: Iterable[Answer]) -> Counterexample | None:
        points = (counterexample(answer, answers.contexts) for answer in found)
        return next(filter(None, points), None)

    here, mended = answered(equation.senses), answered(equation.mended, equation.repair)
    read = [(reading, answered(reading.senses)) for reading in equation.readings]
    needed = {each.text: answered(each.needed_by) for each in equation.conditions}
    supports = [answer for by in needed.values() for answer in by]
    readings = tuple(
        Read(
            reading,
            all_hold(found),
            ids(found, "equal"),
            ids(found, "unequal"),
            first_failure(found),
        )
        for reading, found in read
    )
    that_hold = [answer for _, found in read if all_hold(found) for answer in found]
    proofs = mended or [*here, *that_hold]
    covered = {unit for condition in equation.conditions for unit in condition.units}
    beyond = (f"{unit} != 0" for unit in needed_units(proofs, answers) if unit not in covered)
    conditions = (*needed, *beyond)
    ruling = ruling_of(
        all_hold(here),
        all_hold(mended) if mended else False,
        [each.holds for each in readings],
        conditions,
    )
    found = published.get("repairs", ()) if ruling == Ruling.MISPRINT else ()
    fates = published.get("mutants", {})
    cited = answers.citing(equation.number)
    mutants = sum((Counter(fates.get(name, {})) for name in cited), Counter())
    decided = all(answer.fact is not None for answer in supports)
    return Verdict(
        equation,
        ruling if decided else Ruling.OPEN,
        conditions,
        proved_by=ids(here, "equal"),
        refuted_by=ids(here, "unequal"),
        repaired_by=ids(mended, "equal"),
        needed_by={x: (*ids(by, "equal"), *ids(by, "unequal")) for x, by in needed.items()},
        readings=readings,
        right_with=tuple(x for x, y in equation.with_mended.items() if all_hold(answered(y))),
        counterexample=first_failure([*here, *supports]),
        repairs=tuple(f"{r['lhs']} = {r['rhs']}" for r in found if r["line"] == equation.number),
        mutants=dict(sorted(mutants.items())),
    )


def ruling_of(
    holds: bool | None,
    mended: bool | None,
    readings: Sequence[bool | None],
    conditions: Sequence[str],
) -> Ruling:
    """Return the kind of verdict that follows from decided equations.

    A refuted line with a repair is a misprint; readings that differ are ambiguous.
    `holds` says whether the line holds as it is printed, `mended` whether it has a repair that
    does; None where that is open.
    """
    if holds is None or mended is None or None in readings:
        return Ruling.OPEN
    if not holds and mended:
        return Ruling.MISPRINT
    if not all(readings):
        return Ruling.AMBIGUOUS if any(readings) else Ruling.OPEN
    if not holds:
        return Ruling.OPEN
    return Ruling.CONDITIONAL if conditions else Ruling.HOLDS


def needed_units(proofs: Iterable[Answer], answers: Answers) -> list[str]:
    """Return the quantities that proofs divide by and that may vanish."""
    named = {
        answer.question.context: None
        for answer in proofs
        if answer.holds and answer.question.context in answers.contexts
    }
    units = dict.fromkeys(unit for name in named for unit in answers.contexts[name]["units"])
    return [unit for unit in units if unit not in STANDING | NEVER_ZERO]
