"""The rules of inference: each checks one fact against its premises and its certificate.

It returns the grade that the rule itself gives, or raises; whoever proposes a fact may be lying.
"""

import ast
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from rigidsym.kernel.ring import KernelError, Ring, at
from rigidsym.kernel.statement import Context, Fact, Grade

if TYPE_CHECKING:
    from rigidsym.kernel.ledger import Ledger


def identity(ledger: "Ledger", fact: Fact) -> Grade:
    """
    numerator(lhs_k - rhs_k) = sum_j cofactor_kj * relation_j     for every component k
    -----------------------------------------------------------------------------------
    Gamma |- lhs = rhs

    If lhs >= 0 is visible, and with lhs**2 for lhs:    Gamma |- lhs = sqrt(rhs)
    If rhs >= 0 is visible:                             Gamma |- lhs = rhs >= 0
    """
    ring, signs = ledger.rings[fact.context], {"root": fact.lhs, "nonnegative": fact.rhs}
    _check_signs(signs.get(fact.kind, ()), ledger.contexts[fact.context])
    for rest, cofactors in zip(differences(ring, fact), fact.certificate["cofactors"], strict=True):
        for cofactor, relation in zip(cofactors, ring.relations, strict=True):
            rest -= ring.read(cofactor).over((0,) * len(ring.units)) * relation
        if rest:
            raise KernelError("the cofactors do not give lhs - rhs")
    return Grade.PROVED


def counterexample(ledger: "Ledger", fact: Fact) -> Grade:
    """
    a rational point of Gamma at which lhs differs from rhs
    -------------------------------------------------------
    Gamma |- lhs != rhs at some point
    """
    ring = ledger.rings[fact.context]
    point = ledger.contexts[fact.context].check_point(ring, fact.certificate["point"])
    if not any(at(difference, point) for difference in differences(ring, fact)):
        raise KernelError("both sides agree at this point")
    return Grade.PROVED


def model(ledger: "Ledger", fact: Fact) -> Grade:
    """
    every name of Gamma is a name of Delta, where, by the premises, the relations of Gamma vanish,
    its units are units, its signs are visible, its definitions hold and D reads the same
    ----------------------------------------------------------------------------------------------
    Delta |- model of Gamma
    """
    target, given = ledger.rings[fact.context], []
    for premise in (ledger.facts[name] for name in fact.premises):
        if (premise.kind, premise.context) != ("equal", fact.context):
            raise KernelError(f"{premise.id} is not an equation of {fact.context}")
        given += filter(None, differences(target, premise))
    (source,) = (ledger.contexts[name] for name in fact.lhs + fact.rhs)
    zeros = _zeros(source) - _zeros(ledger.contexts[fact.context])
    if any(target.reduce(target.read(text).numerator, *given)[1] for text in zeros):
        raise KernelError(f"a relation, definition or rate of {source.name} does not hold")
    for unit in source.units:
        target.inverse(target.read(unit))
    _check_signs(source.nonnegative, ledger.contexts[fact.context])
    return Grade.PROVED


def transfer(ledger: "Ledger", fact: Fact) -> Grade:
    """
    Gamma |- statement        Delta |- model of Gamma
    -------------------------------------------------
    Delta |- statement
    """
    there, bridge = (ledger.facts[premise] for premise in fact.premises)
    due = ("model", (there.context,), fact.context, fact.kind, fact.lhs, fact.rhs)
    if (bridge.kind, bridge.rhs, bridge.context, there.kind, there.lhs, there.rhs) != due:
        raise KernelError("the premises are not the same statement and a model of its context")
    return Grade.PROVED


def partition(ledger: "Ledger", fact: Fact) -> Grade:
    """
    Gamma, x = 0        Gamma, x > 0        Gamma, -x > 0 (not where x >= 0 is visible)
    -----------------------------------------------------------------------------------
    Gamma |- exactly one of these contexts, or of those that premises split them into
    """
    whole, (x,), cases = ledger.contexts[fact.context], fact.lhs, fact.certificate["cases"]
    _check_signs((x,) if len(cases) == 2 else (), whole)
    for name, sign in zip(cases, ("", x, f"-{x}"), strict=len(cases) != 2):
        more = {"units": (*whole.units, x), "nonnegative": (*whole.nonnegative, sign)}
        more = more if sign else {"relations": (*whole.relations, x)}
        part = ledger.contexts[name]
        if part != replace(whole, name=name, witness=part.witness, **more) or not x.isidentifier():
            raise KernelError(f"{name} is not this case of {whole.name}")
    given = (ledger.facts[name] for name in fact.premises)
    finer = {premise.context: premise.rhs for premise in given if premise.kind == "partition"}
    if fact.rhs != tuple(leaf for case in cases for leaf in finer.get(case, (case,))):
        raise KernelError("these are not the cases")
    return Grade.PROVED


def assumption(ledger: "Ledger", fact: Fact) -> Grade:
    """
    a reference that states it, and points where balls, if there are points, do not exclude it
    ------------------------------------------------------------------------------------------
    Gamma, read as its `reading` says |- statement        (grade ASSUMED, with points ENCLOSED)
    """
    context, points = ledger.contexts[fact.context], fact.certificate.get("points", ())
    differences(ledger.rings[fact.context], fact)
    agreed = not points or (ledger.encloses and ledger.encloses(context, fact, points))
    if not fact.certificate.get("reference") or not agreed:
        raise KernelError("an assumption needs a reference, and balls that agree at the points")
    return Grade.ENCLOSED if points else Grade.ASSUMED


RULES: dict[str, tuple[str, Callable[["Ledger", Fact], Grade]]] = {
    "identity": ("equal root nonnegative", identity),
    "counterexample": ("unequal", counterexample),
    "model": ("model", model),
    "transfer": ("equal root nonnegative", transfer),
    "partition": ("partition", partition),
    "assumption": ("equal", assumption),
}


def differences(ring: Ring, fact: Fact) -> list[Any]:
    """The numerators of lhs - rhs (of lhs**2 - rhs for a root): zero where the statement holds."""
    power = 2 if fact.kind == "root" else 1
    sides = zip(fact.lhs, fact.rhs, strict=True)
    return [(ring.read(lhs) ** power - ring.read(rhs)).numerator for lhs, rhs in sides]


def _zeros(context: Context) -> set[str]:
    """What a context says is zero, as texts."""
    rates = {**dict.fromkeys(context.generators, "0"), **(context.rates or {})}
    moving = rates.items() if context.rates is not None else ()
    zeros = [*context.relations, *(f"0*{name}" for name in context.generators)]
    zeros += [f"{name} - ({text})" for name, text in context.definitions.items()]
    return {*zeros, *(f"D({name}) - ({text})" for name, text in moving if text != "?")}


def _check_signs(texts: Iterable[str], context: Context) -> None:
    """Refuse what is not made of nonnegative things by + * /, and of anything by even powers."""
    waiting, done = [*texts], {*context.nonnegative}
    while waiting:
        if (text := waiting.pop()) in done or text.isdecimal():
            continue
        done.add(text)
        match ast.parse(text, mode="eval").body:
            case ast.Name(id=name) if name in context.definitions:
                waiting.append(context.definitions[name])
            case ast.BinOp(left=base, op=ast.Pow(), right=ast.Constant(value=int(exponent))):
                waiting += [ast.unparse(base)] * (exponent % 2)
            case ast.BinOp(left=left, op=ast.Add() | ast.Mult() | ast.Div(), right=right):
                waiting += [ast.unparse(left), ast.unparse(right)]
            case _:
                raise KernelError(f"{text} >= 0 is not visible in {context.name}")
