"""The derived solution as data: the programmes of formulas that the ledger publishes.

The number wing starts here.  It reads ledger.json and nothing else of the proof wing; formulas
that are not backed by a proved fact, or that use a name before it is known, are refused.
"""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

from rigidsym.errors import LedgerError
from rigidsym.solution.expression import Call, Expression, complement, names, parse, to_text

AXES = ("a", "b", "d")
# What each programme is given; everything else it computes.
INPUTS = {
    "plan": (
        *(f"c_{x}" for x in AXES),
        *(f"Omega_{x}" for x in AXES),
        *("epsilon", "sigma", "rho", "chi"),
        *(f"q_{x}" for x in ("0", *AXES)),
        *("t", "cos_half_psi", "sin_half_psi"),
    ),
    "state": (
        *(f"c_{x}" for x in AXES),
        *("A_a", "A_b", "A_d", "K", "epsilon", "sigma", "tau", "chi", "k_1", "k_c", "m_c", "mu"),
        *("phase", "n", "psi_0", "kappa", "J_0", "p_0", "p_a", "p_b", "p_d", "t"),
    ),
    "steady": ("Omega1", "Omega2", "Omega3", "p0", "p1", "p2", "p3", "t"),
}
_OF_PARAMETER = {"jacobi_sn", "jacobi_cn", "jacobi_dn", "elliptic_j"}


@dataclass(frozen=True, slots=True)
class Formula:
    """name = expression, by a fact of the ledger; `source` lists the equations it comes from.

    Functions of a parameter m take its complement 1 - m as their last argument.
    """

    name: str
    expression: Expression
    fact: str
    source: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Solution:
    """The programmes by name, and a digest of all their statements."""

    programmes: Mapping[str, tuple[Formula, ...]]
    digest: str


def ledger_text() -> str:
    """The sealed ledger that came with this installation."""
    try:
        return resources.files("derivations").joinpath("ledger.json").read_text("utf-8")
    except (OSError, ModuleNotFoundError) as error:
        raise LedgerError(f"ledger: {error}: run `rigidsym derive` to write it") from None


@cache
def sealed() -> Solution:
    """The solution of the sealed ledger."""
    return load(ledger_text())


def load(text: str) -> Solution:
    """The solution that a ledger publishes; raises LedgerError where it proves less."""
    try:
        data = json.loads(text)
        facts = {fact["id"]: fact for fact in data["facts"]}
        contexts = {context["name"]: context for context in data["contexts"]}
        programmes = {
            name: tuple(_formula(entry, facts, contexts) for entry in entries)
            for name, entries in data["published"].items()
        }
    except (KeyError, TypeError, AttributeError, json.JSONDecodeError) as error:
        raise LedgerError(f"ledger: not readable as rigidsym.ledger/1: {error!r}") from None
    for name, formulas in programmes.items():
        _check_order(name, formulas)
    return Solution(programmes, _digest(programmes))


def _formula(entry: str, facts: Mapping[str, Any], contexts: Mapping[str, Any]) -> Formula:
    if ":" in entry:
        context, name, *source = entry.split(":")
        expression = _by_complement(parse(contexts[context]["reading"][name]))
        return Formula(name, expression, f"{context}.{name}", tuple(source))
    fact = facts[entry]
    proved = fact["grade"] == "PROVED" and fact["kind"] in ("equal", "root")
    if not proved or len(fact["lhs"]) != 1:
        raise LedgerError(f"ledger: {entry} is published but is not one proved formula")
    (name,), (text,) = fact["lhs"], fact["rhs"]
    expression = parse(text)
    if fact["kind"] == "root":
        expression = Call("sqrt", (expression,))
    return Formula(name, expression, entry, tuple(fact["source"]))


def _by_complement(expression: Expression) -> Expression:
    match expression:
        case Call(function, (*arguments, parameter)) if function in _OF_PARAMETER:
            return Call(function, (*arguments, complement(parameter)))
    return expression


def _check_order(programme: str, formulas: tuple[Formula, ...]) -> None:
    known = set(INPUTS.get(programme, ()))
    for formula in formulas:
        missing = sorted(set(names(formula.expression)) - known)
        if missing:
            raise LedgerError(f"ledger: {programme}: {formula.name} needs {', '.join(missing)}")
        known.add(formula.name)


def _digest(programmes: Mapping[str, tuple[Formula, ...]]) -> str:
    lines = [
        f"{name}: {formula.fact}: {formula.name} = {to_text(formula.expression)}"
        for name, formulas in programmes.items()
        for formula in formulas
    ]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()
