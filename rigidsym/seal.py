"""What is printed against what was derived: decided by the kernel, formula by formula.

Code generation shares, folds and multiplies out; each formula is put together again from the lines
that were printed, and the difference to the formula that the ledger proves, or a kernel states, has
to vanish in a ring of the kernel.  Calls are names there: equal ones have equal names.
"""

from collections.abc import Iterable, Iterator
from itertools import count

from rigidsym.codegen.attitude import folding
from rigidsym.codegen.functions import functions
from rigidsym.codegen.ir import Let
from rigidsym.codegen.passes import expand
from rigidsym.errors import InputError
from rigidsym.kernel import Context, KernelError, Ring
from rigidsym.solution import Solution
from rigidsym.solution.expression import (
    Call,
    Expression,
    Name,
    Operation,
    children,
    names,
    rebuild,
    to_text,
)


def seal(solution: Solution) -> int:
    """Decide every formula that generated code stands for; returns how many there were.

    Raises InputError, naming it, for the first that the lets do not give.
    """
    decided = 0
    for place, formula, printed in _pairs(solution):
        if not is_equal(formula.expression, printed):
            raise InputError(place, str(formula), "what is printed is not what was derived")
        decided += 1
    return decided


def _pairs(solution: Solution) -> Iterator[tuple[str, Let, Expression]]:
    """Where, the formula, and what is printed for it with all that was shared put back."""
    for formula, folded in folding(solution):
        yield "folding", formula, folded
    for function in functions(solution):
        printed = {let.targets: let.expression for let in expand(function.lets)}
        for formula in function.formulas:
            yield function.name, formula, printed[formula.targets]


def is_equal(left: Expression, right: Expression) -> bool:
    """Whether two expressions are equal as rational functions of names and calls."""
    if left == right:
        return True
    atoms: dict[Expression, str] = {}
    left, right = (_by_names(expression, atoms) for expression in (left, right))
    generators = sorted({*names(left), *names(right)})
    units = {to_text(unit) for side in (left, right) for unit in _denominators(side)}
    try:
        ring = _ring(generators, tuple(sorted(units)))
        return not (ring.read(to_text(left)) - ring.read(to_text(right))).numerator
    except KernelError:
        return False


def _by_names(expression: Expression, atoms: dict[Expression, str]) -> Expression:
    """The expression with a name for each call, the same for equal ones."""
    parts = tuple(_by_names(part, atoms) for part in children(expression))
    match rebuild(expression, parts):
        case Call("neg", (operand,)):
            return Call("neg", (operand,))
        case Call() as call:
            return Name(_atom(call, atoms))
        case other:
            return other


def _atom(call: Call, atoms: dict[Expression, str]) -> str:
    """The name of a call: that of another one with the same function and equal arguments."""
    for other, name in atoms.items():
        if isinstance(other, Call) and _are_same(call, other):
            return name
    return atoms.setdefault(call, f"call_{len(atoms)}")


def _are_same(one: Call, other: Call) -> bool:
    if one.function != other.function or len(one.arguments) != len(other.arguments):
        return False
    return all(map(is_equal, one.arguments, other.arguments))


def _denominators(expression: Expression) -> Iterable[Expression]:
    if isinstance(expression, Operation) and expression.operator == "/":
        yield expression.right
    for part in children(expression):
        yield from _denominators(part)


def _ring(generators: list[str], units: tuple[str, ...]) -> Ring:
    """A ring of the kernel: the witness is a point of primes, where the units do not vanish."""
    witness = dict(zip(generators, map(str, _primes(len(generators))), strict=True))
    return Context("seal", tuple(generators), witness, units=units).open()


def _primes(size: int) -> list[int]:
    found: list[int] = []
    for candidate in count(101):
        if len(found) == size:
            return found
        if all(candidate % d for d in range(2, 1 + int(candidate**0.5))):
            found.append(candidate)
    return found
