"""Repairs: refuted lines of the paper that one small edit mends.

A sign, index, power, factor, divisor or derivative is changed in what the paper prints; the edits
that agree at rational points are decided by the kernel.  The ledger keeps the shortest repairs
that are proved.  (14) for Lemma 1 is not found: it takes two edits at once.
"""

from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._repairs import repairs
from rigidsym.proof.paper import EQUATIONS
from rigidsym.proof.paper._answers import question, without_trivial

# A line, which of its equations fails, and where that holds what the paper prints: a side of it,
# or a definition.
PRINTED = (
    ("10", "Omega_i", "rhs"),
    ("11", "Omega_i", "rhs"),
    ("12", "sn", "rhs"),
    ("16", "D(Omega_i)", "rhs"),
    ("20", "D(phi1_printed)", "n_printed"),
    ("21", "D(phi1_printed)", "n_printed"),
    ("35", "dn**2", "rhs"),
    ("36", "dn**2", "rhs"),
    ("36", "D(D(phi1))", "lhs"),
    ("Remark 2", "y_star*cos_half", "y_star"),
)


def derive(builder: LedgerBuilder) -> None:
    """Search for repairs of refuted lines, and list them."""
    builder.ledger.published["repairs"] = [
        {"line": number, "fact": fact, "lhs": lhs, "rhs": rhs}
        for number, left, place in PRINTED
        for fact, component in _refuted(builder, number, left)
        for lhs, rhs in repairs(builder.ledger, fact, place, component)
    ]


def _refuted(builder: LedgerBuilder, number: str, left: str) -> list[tuple[str, int]]:
    """Return the facts that refute a line, with the place of the equation in each."""
    printed = {equation.number: equation for equation in EQUATIONS}
    asked = [question(printed[number].latex, sense, printed) for sense in printed[number].senses]
    told = [
        without_trivial(whole, context.definitions, context.rates or {})
        for whole in asked
        for context in [builder.ledger.contexts[whole.context]]
    ]
    said = {(whole.context, whole.lhs, whole.rhs) for whole in told if left in whole.lhs}
    return [
        (fact.id, fact.lhs.index(left))
        for fact in builder.ledger.facts.values()
        if fact.kind == "unequal" and (fact.context, fact.lhs, fact.rhs) in said
    ]
