"""Equality of expressions as rational functions, decided in a ring of the kernel.

Function calls are names in this ring: equal calls have equal names.  A `Claim` is one such
decision.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import count
from math import isqrt

from rigidsym._codegen.ir import Let
from rigidsym.errors import InputError
from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    Operation,
    children,
    names,
    rebuild,
    to_text,
)
from rigidsym.proof.kernel import Context, KernelError, Ring

DIFFERS = "what is printed is not what was derived"


def is_equal(left: Expression, right: Expression) -> bool:
    """Return True if two expressions are equal as rational functions of names and calls."""
    if left == right:
        return True
    atoms: dict[Call, str] = {}
    left, right = (_by_names(expression, atoms) for expression in (left, right))
    generators = sorted({*names(left), *names(right)})
    units = {to_text(unit) for side in (left, right) for unit in _denominators(side)}
    try:
        ring = _ring(generators, tuple(sorted(units)))
        return not (ring.read(to_text(left)) - ring.read(to_text(right))).numerator
    except KernelError:
        return False


def _by_names(expression: Expression, atoms: dict[Call, str]) -> Expression:
    """Replace each function call in an expression by a name, equal calls by the same name."""
    parts = tuple(_by_names(part, atoms) for part in children(expression))
    match rebuild(expression, parts):
        case Call("neg", (operand,)):
            return Call("neg", (operand,))
        case Call() as call:
            return Name(_atom(call, atoms))
        case other:
            return other


def _atom(call: Call, atoms: dict[Call, str]) -> str:
    """Return the name that stands for a function call.

    Calls of one function with equal arguments share a name.
    """
    for other, name in atoms.items():
        alike = other.function == call.function and len(other.arguments) == len(call.arguments)
        if alike and all(map(is_equal, call.arguments, other.arguments)):
            return name
    return atoms.setdefault(call, f"call_{len(atoms)}")


def _denominators(expression: Expression) -> Iterable[Expression]:
    """Yield the factors of all denominators: the kernel takes c_a*c_d apart by c_a and c_d."""
    if isinstance(expression, Operation) and expression.operator == "/":
        yield from _factors(expression.right)
    for part in children(expression):
        yield from _denominators(part)


def _factors(expression: Expression) -> Iterable[Expression]:
    if isinstance(expression, Operation) and expression.operator == "*":
        yield from _factors(expression.left)
        yield from _factors(expression.right)
    else:
        yield expression


def _ring(generators: list[str], units: tuple[str, ...]) -> Ring:
    """Open a ring of the kernel with the given generators, and primes as its sample point."""
    primes = (n for n in count(101) if all(n % d for d in range(2, isqrt(n) + 1)))
    witness = dict(zip(generators, map(str, primes), strict=False))
    return Context("seal", tuple(generators), witness, units=units).open()


@dataclass(frozen=True, slots=True)
class Claim:
    """Claim that the printed form of a formula equals the derived form."""

    place: str
    formula: str
    derived: Expression
    printed: Expression

    def decide(self) -> None:
        """Raise InputError unless the printed form equals the derived form.

        The error names the place and the formula.
        """
        if not is_equal(self.derived, self.printed):
            raise InputError(self.place, self.formula, DIFFERS)


def formulas_of(lets: tuple[Let, ...]) -> dict[str, Expression]:
    """Map the target of each assignment to its expression.

    Assignments with several targets are left out.
    """
    return {let.targets[0]: let.expression for let in lets if len(let.targets) == 1}
