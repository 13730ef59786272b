"""The rules of inference.  Each checks one fact against its premises and its certificate.

A checker gets the ledger so far and the fact; it returns the grade the rule itself gives, or
raises KernelError.  Whoever proposes a fact may be wrong or lying: nothing here trusts it.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rigidsym.kernel.fact import Fact, Grade
from rigidsym.kernel.ring import KernelError, Ring

if TYPE_CHECKING:
    from rigidsym.kernel.ledger import Ledger


def identity(ledger: "Ledger", fact: Fact) -> Grade:
    """
    numerator(lhs_k - rhs_k) = sum_j cofactor_kj * relation_j     for every component k
    -----------------------------------------------------------------------------------
    relations = 0, units != 0  |-  lhs = rhs
    """
    return _vanishes(ledger, _expect(fact, "equal", premises=0))


def root(ledger: "Ledger", fact: Fact) -> Grade:
    """
    numerator(x_k**2 - y_k) = sum_j cofactor_kj * relation_j        Gamma says x_k >= 0
    -----------------------------------------------------------------------------------
    Gamma |- x = sqrt(y)
    """
    if not set(fact.lhs) <= set(ledger.contexts[fact.context].nonnegative):
        raise KernelError("the left side is not declared nonnegative")
    return _vanishes(ledger, _expect(fact, "root", premises=0))


def counterexample(ledger: "Ledger", fact: Fact) -> Grade:
    """
    a rational point of Gamma at which lhs differs from rhs
    -------------------------------------------------------
    Gamma |- lhs != rhs at some point
    """
    ring = ledger.rings[_expect(fact, "unequal", premises=0).context]
    values = fact.certificate.get("point", {})
    point = ledger.contexts[fact.context].check_point(ring, values)
    if not any(difference.evaluate(point) for difference in differences(ring, fact)):
        raise KernelError("both sides agree at this point")
    return Grade.PROVED


def model(ledger: "Ledger", fact: Fact) -> Grade:
    """
    every name of Gamma is a name of Delta, where the relations of Gamma vanish, its units are
    units, its nonnegative names are nonnegative, its definitions hold and D reads the same
    -------------------------------------------------------------------------------------------
    Delta |- model of Gamma
    """
    target = ledger.rings[_expect(fact, "model", premises=0).context]
    (source,) = (ledger.contexts[name] for name in fact.lhs + fact.rhs)
    zeros = [target.read(t) for t in (*source.relations, *(f"0*{n}" for n in source.generators))]
    zeros += [target.read(f"{name} - ({text})") for name, text in source.definitions.items()]
    if source.rates is not None:
        rates = {name: source.rates.get(name, "0") for name in source.generators}
        known = [f"D({name}) - ({text})" for name, text in rates.items() if text != "?"]
        zeros += [target.read(text) for text in known]
    if any(target.reduce(zero.numerator)[1] for zero in zeros):
        raise KernelError(f"a relation, definition or rate of {source.name} does not hold")
    for unit in source.units:
        target.inverse(target.read(unit))
    if not set(source.nonnegative) <= set(ledger.contexts[fact.context].nonnegative):
        raise KernelError(f"a sign that {source.name} supposes is not declared")
    return Grade.PROVED


def transfer(ledger: "Ledger", fact: Fact) -> Grade:
    """
    Gamma |- statement        Delta |- model of Gamma
    -------------------------------------------------
    Delta |- statement
    """
    if len(fact.premises) != 2 or fact.kind not in ("equal", "root"):
        raise KernelError("transfer takes an equation and a model")
    there, bridge = (ledger.facts[premise] for premise in fact.premises)
    if (bridge.kind, bridge.rhs, bridge.context) != ("model", (there.context,), fact.context):
        raise KernelError(f"the second premise is not a model of {there.context}")
    if (there.kind, there.lhs, there.rhs) != (fact.kind, fact.lhs, fact.rhs):
        raise KernelError("transfer must keep the statement")
    return Grade.PROVED


def assumption(ledger: "Ledger", fact: Fact) -> Grade:
    """
    a reference that states it
    --------------------------
    Gamma |- statement                 (grade ASSUMED)
    """
    differences(ledger.rings[_expect(fact, "equal", premises=0).context], fact)
    if not fact.certificate.get("reference"):
        raise KernelError("an assumption needs a reference")
    return Grade.ASSUMED


RULES: dict[str, Callable[["Ledger", Fact], Grade]] = {
    rule.__name__: rule for rule in (identity, root, counterexample, model, transfer, assumption)
}


def differences(ring: Ring, fact: Fact) -> list[Any]:
    """The numerators of lhs - rhs (of lhs**2 - rhs for a root): zero where the statement holds."""
    power = 2 if fact.kind == "root" else 1
    sides = _pair(fact.lhs, fact.rhs)
    return [(ring.read(lhs) ** power - ring.read(rhs)).numerator for lhs, rhs in sides]


def _vanishes(ledger: "Ledger", fact: Fact) -> Grade:
    ring = ledger.rings[fact.context]
    for rest, cofactors in _pair(differences(ring, fact), fact.certificate.get("cofactors", ())):
        for cofactor, relation in _pair(cofactors, ring.relations):
            rest -= ring.read(cofactor).over((0,) * len(ring.units)) * relation
        if rest:
            raise KernelError("the cofactors do not give lhs - rhs")
    return Grade.PROVED


def _expect(fact: Fact, kind: str, premises: int) -> Fact:
    if fact.kind != kind or not fact.rhs or len(fact.premises) != premises:
        raise KernelError(f"rule {fact.rule} makes {kind!r} from {premises} premises")
    return fact


def _pair(left: Any, right: Any) -> list[tuple[Any, Any]]:
    if len(left) != len(right):
        raise KernelError(f"{len(left)} items do not match {len(right)}")
    return list(zip(left, right, strict=True))
