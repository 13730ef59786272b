"""Lists and counts of everything that each theorem of the specification takes on trust."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rigidsym.language._specification import Theorem, sequences, theorems


@dataclass(frozen=True, slots=True)
class Audit:
    """One theorem, and what it takes on trust, by kind, as text."""

    theorem: str
    title: str
    trusted: Mapping[str, tuple[str, ...]]


def audit(specification: str, ledger: Mapping[str, Any]) -> list[Audit]:
    """List everything that a reader of a proved ledger takes on trust, theorem by theorem."""
    return [_audit(theorem, ledger) for theorem in theorems(specification).values()]


def totals(audits: Iterable[Audit]) -> dict[str, int]:
    """Count the different trusted things of each kind."""
    found: dict[str, set[str]] = {}
    for one in audits:
        for kind, things in one.trusted.items():
            found.setdefault(kind, set()).update(things)
    return {kind: len(things) for kind, things in found.items()}


def _audit(theorem: Theorem, ledger: Mapping[str, Any]) -> Audit:
    """List hypotheses, rates and definitions of a theorem, and the rest from the ledger."""
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
    """List the standard functions that published names mean."""
    found = []
    for sequence, names in theorem.formulas:
        for entry in sequences(ledger)[sequence]:
            if (name := entry.get("reading")) and (not names or name in names):
                found.append(f"{name} is {contexts[entry['context']]['reading'][name]}")
    return list(dict.fromkeys(found))


def _suppositions(name: str, ledger: Mapping[str, Any]) -> list[str]:
    """List others' results by which standard functions satisfy a theorem's hypotheses."""
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
