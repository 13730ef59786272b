"""Assumptions that each theorem of the specification rests on."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rigidsym.language._specification import Theorem, sequences, theorems


@dataclass(frozen=True, slots=True)
class Audit:
    """The assumptions of one theorem, grouped by kind."""

    theorem: str
    title: str
    trusted: Mapping[str, tuple[str, ...]]


def audit(specification: str, ledger: Mapping[str, Any]) -> list[Audit]:
    """List the assumptions of each theorem in the specification."""
    return [_audit(theorem, ledger) for theorem in theorems(specification).values()]


def totals(audits: Iterable[Audit]) -> dict[str, int]:
    """Count the distinct assumptions of each kind over all theorems."""
    found: dict[str, set[str]] = {}
    for one in audits:
        for kind, things in one.trusted.items():
            found.setdefault(kind, set()).update(things)
    return {kind: len(things) for kind, things in found.items()}


def _audit(theorem: Theorem, ledger: Mapping[str, Any]) -> Audit:
    """Collect the assumptions of one theorem from its statement and the ledger."""
    contexts = {context["name"]: context for context in ledger["contexts"]}
    rates = tuple(f"{name}' = {text}" for name, text in sorted((theorem.moving or {}).items()))
    trusted = {
        "hypotheses": (
            *(f"{text} = 0" for text in sorted(theorem.zero)),
            *(f"{text} != 0" for text in sorted(theorem.nonzero)),
            *(f"{text} >= 0" for text in sorted(theorem.nonnegative)),
        ),
        "rates": rates,
        "definitions": tuple(f"{name} = {text}" for name, text in sorted(theorem.let.items())),
        "readings": tuple(_readings(theorem, ledger, contexts)),
        "suppositions": tuple(_suppositions(theorem.name, ledger)),
    }
    return Audit(theorem.name, theorem.title, trusted)


def _readings(
    theorem: Theorem, ledger: Mapping[str, Any], contexts: Mapping[str, Any]
) -> list[str]:
    """List which standard function each symbol in a theorem's formulas denotes."""
    found = []
    for sequence, names in theorem.formulas:
        for entry in sequences(ledger)[sequence]:
            if (name := entry.get("reading")) and (not names or name in names):
                found.append(f"{name} is {contexts[entry['context']]['reading'][name]}")
    return list(dict.fromkeys(found))


def _suppositions(name: str, ledger: Mapping[str, Any]) -> list[str]:
    """List the unproved results from the literature that a theorem relies on.

    These results say that standard functions satisfy the theorem's hypotheses.
    """
    facts = ledger["facts"]
    resting = {
        fact["context"]
        for fact in facts
        if fact["kind"] == "model" and fact["rhs"] == [name] and fact["grade"] != "PROVED"
    }
    return [
        f"{lhs} = {rhs} ({fact['certificate']['reference']})"
        for fact in facts
        if fact["rule"] == "assumption" and fact["context"] in resting
        for lhs, rhs in zip(fact["lhs"], fact["rhs"], strict=True)
    ]
