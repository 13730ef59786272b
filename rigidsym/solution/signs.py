"""The signs of a motion, by the rules that the theorem `start_signs` of the specification has.

Under it sigma Omega_a, rho (c_a - c_d) and chi tau Omega_d are not negative; then dn, cn and Delta,
of which the formulas make the motion, are not, either.  So a sign is that of what it multiplies
there, and 1 where that is zero.
"""

from collections.abc import Iterable

from rigidsym.errors import LedgerError
from rigidsym.language.expression import (
    Expression,
    Name,
    Operation,
    names,
    parse,
    put,
)

# The theorem, and in which order its signs are known; the first is of the axes alone.
THEOREM = "start_signs"
SIGNS = ("epsilon", "sigma", "rho", "chi")
HANDEDNESS = "(axis_b - axis_a)*(axis_d - axis_a)*(axis_d - axis_b)/2"
_SIGN_OF = parse("choose(0, x, 1, -1)")


def handedness(a: int, b: int, d: int) -> int:
    """The Levi-Civita symbol of the axes 0, 1 and 2 in some order: HANDEDNESS."""
    return (b - a) * (d - a) * (d - b) // 2


def rules(nonnegative: Iterable[str]) -> dict[str, Expression]:
    """Each sign but epsilon by what it is the sign of, from what the theorem has not negative."""
    found = dict(filter(None, map(_rule, map(parse, nonnegative))))
    if {*found} != {*SIGNS[1:]}:
        raise LedgerError(f"ledger: {THEOREM} is not about {', '.join(SIGNS[1:])}")
    return {name: found[name] for name in SIGNS[1:]}


def _rule(product: Expression) -> tuple[str, Expression] | None:
    """The sign that a product begins with: that of the rest."""
    first = next(names(product))
    if first not in SIGNS:
        return None
    return first, put(_SIGN_OF, {"x": _rest(product)})


def _rest(product: Expression) -> Expression:
    """A product without its first factor."""
    match product:
        case Operation("*", Name(), right):
            return right
        case Operation("*", left, right):
            return Operation("*", _rest(left), right)
    raise LedgerError(f"ledger: {THEOREM}: it is no product that is not negative")
