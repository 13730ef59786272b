"""Conditions under which a form holds, as the ledger's contexts and regimes have them."""

from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

from sympy import Eq, Ge, Gt, Ne
from sympy.logic.boolalg import Boolean

from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.language.expression import names, parse
from rigidsym.solution.symbolic.translation import sympified


@cache
def _contexts() -> dict[str, Mapping[str, Any]]:
    return {context["name"]: context for context in ledger_data(ledger_text())["contexts"]}


def of_context(
    context: str, known: Mapping[str, Any], given: Iterable[str] = ()
) -> tuple[Boolean, ...]:
    """Its units and signs of names that are known, and its relations between those given."""
    ledger, inputs = _contexts()[context], {*given}
    clauses = (("units", Ne, {*known}), ("nonnegative", Ge, {*known}), ("relations", Eq, inputs))
    found = (
        relation(sympified(parse(text), known), 0)
        for column, relation, about in clauses
        for text in ledger[column]
        if {*names(parse(text))} <= about
    )
    return told(found)


def choices(known: Mapping[str, Any]) -> tuple[Boolean, ...]:
    """What the signs sigma, rho and chi stand for: axes and the half of a period at the start."""
    texts = ("sigma*Omega_a", "rho*(c_a - c_d)", "chi*tau*Omega_d")
    return told(Ge(sympified(parse(text), known), 0) for text in texts)


def between(known: Mapping[str, Any]) -> tuple[Boolean, ...]:
    """0 < m < 1."""
    return told((Gt(known["m"], 0), Gt(known["m_1"], 0)))


def spheres(known: Mapping[str, Any]) -> tuple[Boolean, ...]:
    """Equal moments."""
    return told((Eq(known["c1"], known["c2"]), Eq(known["c2"], known["c3"])))


def told(conditions: Iterable[Any]) -> tuple[Boolean, ...]:
    """Those that are not true whatever their symbols, each once."""
    return tuple(dict.fromkeys(c for c in conditions if c is not True and c != True))  # noqa: E712
