"""Derivation steps that solve linear equations, proved in both directions."""

from collections.abc import Sequence
from itertools import combinations
from typing import Any

import sympy
from sympy import Matrix
from sympy.polys.matrices import DomainMatrix
from sympy.solvers.solveset import NonlinearError

from rigidsym.proof.algebra._builder import Source
from rigidsym.proof.algebra._computation import Computation
from rigidsym.proof.steps._record import Step, StepError
from rigidsym.proof.steps._scope import Scope


def solve(
    scope: Scope,
    fact_id: str,
    equations: Sequence[tuple[sympy.Expr, sympy.Expr]],
    unknowns: Sequence[Any],
    why: str,
    source: Source = (),
) -> Step:
    """Solve linear equations that have exactly one solution.

    An equation is a pair of sides (left, right).
    With e = left - right, the kernel decides that each unknown minus its value is a combination of
    the e, so that there is no other solution, and that each e is a combination of these
    differences, so that it is a solution.  Raises StepError if there is none, or more than one.
    """
    word = scope.dictionary.named
    named = [(word(left), word(right)) for left, right in equations]
    asked = [word(unknown) for unknown in unknowns]
    system, constants = _system(fact_id, named, asked)
    inverse, rows = _inverse(scope, fact_id, system, asked)
    value = (inverse * constants[rows, :]).applyfunc(scope.reduced)
    there = scope.at(fact_id, *scope.divisors(*value, *inverse))
    lefts = [f"({there.text(x)}) - ({there.text(y)})" for x, y in named]
    gaps = [f"({there.text(x)} - ({there.text(v)}))" for x, v in zip(asked, value, strict=True)]
    pairs = [
        (gap[1:-1], _combination(there, inverse.row(k), lefts, rows)) for k, gap in enumerate(gaps)
    ]
    pairs += [
        (left, _combination(there, system.row(k), gaps, range(len(gaps))))
        for k, left in enumerate(lefts)
    ]
    fact = there.decide(fact_id, pairs, source, Computation(value, ("solve",)))
    meant = [scope.dictionary.meant(v) for v in value]
    found = dict(zip(map(scope.dictionary.meant, asked), meant, strict=True))
    return there.note("solve", why, found, found.items(), fact, scope.divisors(*meant))


def _system(
    fact_id: str, equations: Sequence[tuple[sympy.Expr, ...]], unknowns: Sequence[Any]
) -> tuple[Any, Any]:
    """Return the matrix and right side of linear equations."""
    try:
        return sympy.linear_eq_to_matrix([x - y for x, y in equations], list(unknowns))
    except NonlinearError:
        asked = ", ".join(map(str, unknowns))
        raise StepError(f"solve: {fact_id}: the equations are not linear in {asked}") from None


def _inverse(
    scope: Scope, fact_id: str, system: Any, unknowns: Sequence[Any]
) -> tuple[Any, list[int]]:
    """Select equations that determine the unknowns, and invert their matrix.

    Returns the inverse and the indices of the selected equations.
    """
    rows = list(_pivots(system.T))
    if len(rows) < len(unknowns):
        pivots = _pivots(system)
        free = ", ".join(str(x) for k, x in enumerate(unknowns) if k not in pivots)
        raise StepError(f"solve: {fact_id}: the equations leave {free} free")
    square = system[rows, :]
    determinant = scope.reduced(square.det(method="berkowitz"))
    if determinant == 0:
        raise StepError(f"solve: {fact_id}: the determinant is 0 by the relations of {scope.name}")
    adjugate = square.adjugate(method="berkowitz")
    return adjugate.applyfunc(lambda x: scope.reduced(x / determinant)), rows


def _pivots(system: Any) -> tuple[int, ...]:
    """Return the pivot columns of a matrix.

    The elimination is over the field of fractions of the entries.
    """
    return DomainMatrix.from_Matrix(system).to_field().rref()[1]


def _combination(scope: Scope, factors: Any, texts: Sequence[str], rows: Sequence[int]) -> str:
    terms = [
        f"({scope.text(factor)})*({texts[row]})"
        for factor, row in zip(factors, rows, strict=True)
        if factor != 0
    ]
    return " + ".join(terms) or "0"


def solve_family(
    scope: Scope,
    fact_id: str,
    equations: Sequence[tuple[sympy.Expr, sympy.Expr]],
    unknowns: Sequence[sympy.Symbol],
    parameter: sympy.Symbol,
    why: str,
    source: Source = (),
) -> Step:
    """Solve linear equations that have a one-parameter family of solutions.

    The solutions are particular + parameter * direction.
    The particular solution is the one without a denominator.  The kernel decides that the whole
    family solves the equations, and that every solution differs from the particular one by a
    multiple of the direction.  Raises StepError unless exactly one direction is free.
    """
    system, constants = _system(fact_id, equations, unknowns)
    free = system.nullspace()
    if len(free) != 1:
        raise StepError(f"solve: {fact_id}: {len(free)} directions are free, one was expected")
    below = sympy.lcm_list([sympy.denom(sympy.together(x)) for x in free[0]])
    whole = free[0].applyfunc(lambda x: sympy.cancel(x * below))
    direction: Any = whole / sympy.gcd_list(list(whole))  # without denominators or common factor
    particular: Any = _regular(system, constants, direction, unknowns)
    columns = zip(unknowns, particular, direction, strict=True)
    family: Any = {x: p + parameter * d for x, p, d in columns}
    pairs = [(scope.text(x.subs(family)), scope.text(y)) for x, y in equations]
    pairs += _parallel(scope, system, equations, unknowns, particular, direction)
    fact = scope.decide(fact_id, pairs, source, Computation(family, ("solve",)))
    choice = f"{parameter} is free"
    return scope.note("solve", why, family, family.items(), fact, choice=choice)


def _regular(
    system: Matrix, constants: Matrix, direction: Matrix, unknowns: Sequence[sympy.Symbol]
) -> Matrix:
    """Return a particular solution without denominators.

    It is found by choosing the value of the free unknown.
    """
    (solution,) = sympy.linsolve((system, constants), *unknowns)
    free = next(x for x, value in zip(unknowns, solution, strict=True) if x == value)
    below = sympy.lcm_list([sympy.denom(sympy.together(x)) for x in solution])
    at_pole = [sympy.numer(sympy.together(x)) for x in solution]
    for numerator in at_pole:
        # The numerator has to vanish where the denominator does.
        rest = sympy.expand(numerator.subs(dict.fromkeys(below.free_symbols, 0)))
        if rest.has(free):
            value = sympy.solve(rest, free)[0]
            return Matrix(solution).applyfunc(lambda x, v=value: sympy.cancel(x.subs(free, v)))
    return Matrix(solution)


def _parallel(
    scope: Scope,
    system: Matrix,
    equations: Sequence[tuple[sympy.Expr, sympy.Expr]],
    unknowns: Sequence[sympy.Symbol],
    particular: Matrix,
    direction: Matrix,
) -> list[tuple[str, str]]:
    """Return equations which state that all solutions differ by multiples of `direction`.

    They express the minors of (difference, direction) as combinations of `equations`.
    """
    size = len(unknowns)
    lefts = [f"({scope.text(x)}) - ({scope.text(y)})" for x, y in equations]
    found = []
    for i, j in combinations(range(size), 2):
        row = sympy.zeros(1, size)
        row[j], row[i] = direction[i], -direction[j]
        factors = _factors(system, row)
        one, two = (f"({scope.text(unknowns[k])} - ({scope.text(particular[k])}))" for k in (i, j))
        minor = f"({scope.text(direction[i])})*{two} - ({scope.text(direction[j])})*{one}"
        found.append((minor, _combination(scope, factors, lefts, range(len(lefts)))))
    return found


def _factors(system: Any, row: Any) -> Any:
    """Express a row vector as a linear combination of the rows of a matrix.

    One row is used if it suffices.
    """
    for k in range(system.rows):
        pairs = list(zip(row, system.row(k), strict=True))
        ratios = {sympy.cancel(x / y) for x, y in pairs if y != 0}
        if len(ratios) == 1 and all(x == 0 for x, y in pairs if y == 0):
            found = sympy.zeros(1, system.rows)
            found[k] = ratios.pop()
            return found
    factors, free = system.T.gauss_jordan_solve(row.T)
    return factors.subs(dict.fromkeys(free, 0)).applyfunc(sympy.cancel).T
