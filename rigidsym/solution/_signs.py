"""The signs of a motion, by the rules of the theorem `start_signs` of the specification.

Its hypotheses say that sigma Omega_a, rho (c_a - c_d) and chi tau Omega_d are not negative; its
conclusion, that dn, cn and Delta of the formulas are not negative, either.  So a sign is that of
the factor it has there, and 1 where that factor is zero.
"""

from collections.abc import Iterable

from rigidsym.errors import LedgerError
from rigidsym.language._expression import Expression, Name, Operation, names, parse, put

# The theorem, and its signs in the order of evaluation; the first depends on the axes alone.
THEOREM = "start_signs"
SIGNS = ("epsilon", "sigma", "rho", "chi")
HANDEDNESS = "(axis_b - axis_a)*(axis_d - axis_a)*(axis_d - axis_b)/2"
_SIGN_OF = parse("choose(0, x, 1, -1)")


def handedness(a: int, b: int, d: int) -> int:
    """Return the Levi-Civita symbol of the axes 0, 1 and 2 in some order: HANDEDNESS."""
    return (b - a) * (d - a) * (d - b) // 2


def rules(nonnegative: Iterable[str]) -> dict[str, Expression]:
    """Return every sign but epsilon as an expression, from the theorem's nonnegative products."""
    products = [(next(names(product)), product) for product in map(parse, nonnegative)]
    found = {x: put(_SIGN_OF, {"x": _rest(product)}) for x, product in products if x in SIGNS}
    if {*found} != {*SIGNS[1:]}:
        raise LedgerError(f"ledger: {THEOREM} is not about {', '.join(SIGNS[1:])}")
    return {name: found[name] for name in SIGNS[1:]}


def _rest(product: Expression) -> Expression:
    """Return a product without its first factor."""
    match product:
        case Operation("*", Name(), right):
            return right
        case Operation("*", left, right):
            return Operation("*", _rest(left), right)
    raise LedgerError(f"ledger: {THEOREM}: it is no product that is not negative")
