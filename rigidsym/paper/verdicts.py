"""The verdict on each printed equation, computed from the facts of a ledger."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from rigidsym.paper.equations import EQUATIONS, Equation

# What the paper assumes throughout: a body with inertia that moves.
STANDING = {"c1", "c2", "c3", "c_i", "c_j", "c_k", "K"}
# Contexts whose units are positive in every motion: K + sigma M_a never falls below K.
# half_angle_right supposes what the condition on (19) says.
_UNCONDITIONAL = {"attitude", "half_angle_right", "theorem1_phi1"}


class Ruling(StrEnum):
    """What a verdict can be."""

    HOLDS = "holds"
    CONDITIONAL = "holds if"
    MISPRINT = "misprint"
    OPEN = "open"


@dataclass(frozen=True, slots=True)
class Verdict:
    """The ruling on one equation, with the conditions and the counterexample that belong to it."""

    equation: Equation
    ruling: Ruling
    conditions: tuple[str, ...] = ()
    counterexample: Mapping[str, str] | None = None
    mutants: Mapping[str, int] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """Plain data for programs."""
        return {
            "equation": self.equation.number,
            "latex": self.equation.latex,
            "reading": self.equation.reading,
            "verdict": self.ruling.value,
            "conditions": list(self.conditions),
            "repair": self.equation.repair,
            "counterexample": self.counterexample,
            "proved_by": list(self.equation.proved_by),
            "refuted_by": list(self.equation.refuted_by),
            "needed_by": list(self.equation.needed_by),
            "mutants": dict(self.mutants),
        }


def verdicts(ledger: Mapping[str, Any]) -> list[Verdict]:
    """A verdict for every printed equation, from a ledger as it stands in JSON."""
    facts = {fact["id"]: fact for fact in ledger["facts"]}
    contexts = {context["name"]: context for context in ledger["contexts"]}
    ruled = [_verdict(equation, facts, contexts) for equation in EQUATIONS]
    counts = _mutants(ledger.get("published", {}).get("mutants", ()))
    return [replace(v, mutants=_total(counts, v.equation)) for v in ruled]


def _mutants(lines: Iterable[str]) -> dict[str, Counter[str]]:
    """The fate of each fact's mutants, from lines like "body.lax: 10 refuted, 2 equivalent"."""
    counts = {}
    for line in lines:
        fact, fates = line.split(": ")
        pairs = (fate.split() for fate in fates.split(", "))
        counts[fact] = Counter({fate: int(count) for count, fate in pairs})
    return counts


def _total(counts: Mapping[str, Counter[str]], equation: Equation) -> dict[str, int]:
    total = sum((counts.get(name, Counter()) for name in equation.proved_by), Counter())
    return dict(sorted(total.items()))


def _verdict(equation: Equation, facts: Mapping[str, Any], contexts: Mapping[str, Any]) -> Verdict:
    backing = equation.proved_by + equation.needed_by
    if not equation.proved_by or not _proved(backing, facts, ("equal", "root")):
        return Verdict(equation, Ruling.OPEN)
    point = None
    if equation.refuted_by:
        if not _proved(equation.refuted_by, facts, ("unequal",)):
            return Verdict(equation, Ruling.OPEN)
        point = facts[equation.refuted_by[0]]["certificate"]["point"]
        if equation.repair:
            return Verdict(equation, Ruling.MISPRINT, (), point)
    conditions = _conditions(equation, facts, contexts)
    ruling = Ruling.CONDITIONAL if conditions else Ruling.HOLDS
    return Verdict(equation, ruling, conditions, point)


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
    """What has to be nonzero beyond the standing assumptions, and the stated condition."""
    named = {facts[name]["context"] for name in equation.proved_by} - _UNCONDITIONAL
    units = dict.fromkeys(unit for name in sorted(named) for unit in contexts[name]["units"])
    found = [f"{unit} != 0" for unit in units if unit not in STANDING]
    return tuple(([equation.condition] if equation.condition else []) + found)
