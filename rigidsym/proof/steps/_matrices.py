"""Complex square matrices whose entries have names in a context.

An entry of a matrix R has up to two definitions in its context, such as R_11_re and R_11_im; parts
that are zero have none.  A symbol stands for a matrix of any size n, which its value in a context
has.  The kernel gets the entries of a product as unexpanded sums of products of these names, and
expands them.  The inverse is written as the conjugate transpose; `Scope.decide_matrices` checks
that an inverted matrix is unitary.
"""

from collections.abc import Callable, Mapping
from functools import reduce
from math import isqrt
from typing import Any, TypeAlias

import sympy
from sympy import (
    Identity,
    ImmutableMatrix,
    Inverse,
    MatAdd,
    MatMul,
    MatPow,
    MatrixExpr,
    MatrixSymbol,
    ZeroMatrix,
)
from sympy.matrices.expressions.adjoint import Adjoint
from sympy.printing.printer import Printer

from rigidsym.language._expression import Call, Expression, Name, Operation
from rigidsym.language._expression import Number as Whole
from rigidsym.proof.steps._record import StepError

# The size of the matrices that a symbol stands for.
SIZE = sympy.Symbol("n", integer=True, positive=True)
# The tree of a real number, None where it is zero; a complex number; a matrix by its indices.
Real: TypeAlias = Expression | None
Number: TypeAlias = tuple[Real, Real]
Entries: TypeAlias = Mapping[tuple[int, int], Number]


class Rate(MatrixExpr):
    """Time derivative of a matrix expression."""

    @property
    def shape(self) -> Any:
        """The shape of the differentiated matrix."""
        inner: Any = self.args[0]
        return inner.shape

    def _latex(self, printer: Printer) -> str:
        inner = printer._print(self.args[0])
        simple = isinstance(self.args[0], MatrixSymbol)
        return rf"\dot{{{inner}}}" if simple else rf"\frac{{d}}{{dt}}\left({inner}\right)"

    def _sympystr(self, printer: Printer) -> str:
        return f"D({printer._print(self.args[0])})"


def matrix(name: str) -> MatrixSymbol:
    """Return a symbol for a square matrix of any size with the given name."""
    return MatrixSymbol(name, SIZE, SIZE)


def indices(size: int) -> tuple[tuple[int, int], ...]:
    """Return the indices of a square matrix, row by row, from (1, 1)."""
    places = range(1, size + 1)
    return tuple((i, j) for i in places for j in places)


def size_of(values: Mapping[str, ImmutableMatrix]) -> int:
    """Return the size of the named matrices of a context."""
    return max((value.rows for value in values.values()), default=0)


def split(value: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
    """Split a polynomial in the imaginary unit into its real and imaginary parts.

    All symbols are real.
    """
    expanded = sympy.expand(value)
    imaginary = expanded.coeff(sympy.I)
    return expanded - sympy.expand(sympy.I * imaginary), imaginary


def part_name(name: str, index: tuple[int, int], part: int) -> str:
    """Return the name of the real or imaginary part of a matrix entry.

    R_12_im is the imaginary part of the upper right entry of R.
    """
    return f"{name}_{index[0]}{index[1]}_{('re', 'im')[part]}"


def explicit(
    expression: MatrixExpr,
    values: Mapping[str, ImmutableMatrix],
    rate: Callable[[sympy.Expr], sympy.Expr],
) -> ImmutableMatrix:
    """Multiply out an expression in named matrices with SymPy."""
    size = size_of(values)

    def of(node: Any) -> ImmutableMatrix:
        match node:
            case MatrixSymbol():
                return values[node.name]
            case ImmutableMatrix():
                return node
            case Identity():
                return ImmutableMatrix.eye(size)
            case ZeroMatrix():
                return ImmutableMatrix.zeros(size)
            case MatAdd():
                return sum(map(of, node.args[1:]), of(node.args[0]))
            case MatMul():
                scalar, factors = node.as_coeff_matrices()
                return (scalar * reduce(_product, map(of, factors))).applyfunc(sympy.expand)
            case Inverse() | Adjoint():
                return of(node.args[0]).H
            case MatPow() if node.exp.is_Integer and node.exp > 0:
                return reduce(_product, [of(node.base)] * int(node.exp))
            case Rate():
                parts = [*map(split, of(node.args[0]).flat())]
                return ImmutableMatrix(size, size, [rate(x) + sympy.I * rate(y) for x, y in parts])
        raise StepError(f"{node}: no matrix expression of this vocabulary")

    return of(expression)


def _product(left: ImmutableMatrix, right: ImmutableMatrix) -> ImmutableMatrix:
    return (left * right).applyfunc(sympy.expand)


def entries(
    expression: MatrixExpr,
    values: Mapping[str, ImmutableMatrix],
    scalar: Callable[[sympy.Expr], Expression],
) -> Entries:
    """Return the real and imaginary parts of a matrix expression's entries as syntax trees.

    Products are not multiplied out.
    `scalar` converts scalars: factors, and the entries of explicit matrices.
    """
    places = indices(size_of(values))

    def of(node: Any) -> Entries:
        match node:
            case MatrixSymbol():
                return _named(node.name, values[node.name])
            case ImmutableMatrix():
                return {(i, j): _parts(node[i - 1, j - 1], scalar) for i, j in places}
            case Identity():
                return {(i, j): (Whole(1) if i == j else None, None) for i, j in places}
            case ZeroMatrix():
                return dict.fromkeys(places, (None, None))
            case MatAdd():
                return reduce(_added, map(of, node.args))
            case MatMul():
                factor, matrices = node.as_coeff_matrices()
                whole = reduce(_multiplied, map(of, matrices))
                return whole if factor == 1 else _scaled(factor, scalar, whole)
            case Inverse() | Adjoint():
                inner = of(node.args[0])
                return {(i, j): (inner[j, i][0], _minus(None, inner[j, i][1])) for i, j in places}
            case MatPow() if node.exp.is_Integer and node.exp > 0:
                return reduce(_multiplied, [of(node.base)] * int(node.exp))
            case Rate():
                inner = of(node.args[0])
                return {index: (_derived(x), _derived(y)) for index, (x, y) in inner.items()}
        raise StepError(f"{node}: no matrix expression of this vocabulary")

    return of(expression)


def determinant(entry: Entries) -> Number:
    """Return the real and imaginary part of the determinant, expanded along the first row."""
    size = isqrt(len(entry))
    if size == 1:
        return entry[1, 1]
    real: Real = None
    imaginary: Real = None
    for column in range(1, size + 1):
        rest = [k for k in range(1, size + 1) if k != column]
        minor = {(i, j): entry[i + 1, rest[j - 1]] for i, j in indices(size - 1)}
        x, y = _complex_product(entry[1, column], determinant(minor))
        add = _plus if column % 2 else _minus
        real, imaginary = add(real, x), add(imaginary, y)
    return real, imaginary


def _complex_product(left: Number, right: Number) -> Number:
    (a, b), (c, d) = left, right
    return _minus(_times(a, c), _times(b, d)), _plus(_times(a, d), _times(b, c))


def _named(name: str, value: ImmutableMatrix) -> Entries:
    found = {}
    for i, j in indices(value.rows):
        parts = enumerate(split(value[i - 1, j - 1]))
        real, imaginary = (Name(part_name(name, (i, j), k)) if x else None for k, x in parts)
        found[i, j] = real, imaginary
    return found


def _parts(value: sympy.Expr, scalar: Callable[[sympy.Expr], Expression]) -> Number:
    real, imaginary = (scalar(x) if x else None for x in split(value))
    return real, imaginary


def _plus(left: Real, right: Real) -> Real:
    if left is None or right is None:
        return left if right is None else right
    if isinstance(right, Call) and right.function == "neg":
        return Operation("-", left, right.arguments[0])
    return Operation("+", left, right)


def _minus(left: Real, right: Real) -> Real:
    return left if right is None else _plus(left, _negative(right))


def _negative(tree: Expression) -> Expression:
    if isinstance(tree, Call) and tree.function == "neg":
        return tree.arguments[0]
    return Call("neg", (tree,))


def _times(left: Real, right: Real) -> Real:
    if left is None or right is None:
        return None
    signs, factors = 0, []
    for tree in (left, right):
        negative = isinstance(tree, Call) and tree.function == "neg"
        signs += negative
        factors += [_negative(tree)] if negative else [tree]
    found = [tree for tree in factors if tree != Whole(1)] or [Whole(1)]
    product = Operation("*", *found) if len(found) == 2 else found[0]
    return _negative(product) if signs == 1 else product


def _derived(real: Real) -> Real:
    return None if real is None or isinstance(real, Whole) else Call("D", (real,))


def _added(left: Entries, right: Entries) -> Entries:
    pairs = ((index, left[index], right[index]) for index in left)
    return {index: (_plus(a, c), _plus(b, d)) for index, (a, b), (c, d) in pairs}


def _scaled(
    factor: sympy.Expr, scalar: Callable[[sympy.Expr], Expression], whole: Entries
) -> Entries:
    """Multiply a matrix by a scalar expression.

    A minus sign of the factor is taken out.
    """
    negative = factor.could_extract_minus_sign()
    tree = scalar(-factor if negative else factor)
    by = _negative(tree) if negative else tree
    return {index: (_times(by, x), _times(by, y)) for index, (x, y) in whole.items()}


def _multiplied(left: Entries, right: Entries) -> Entries:
    found: dict[tuple[int, int], Number] = {}
    for i, j in left:
        real: Real = None
        imaginary: Real = None
        for k in range(1, isqrt(len(left)) + 1):
            x, y = _complex_product(left[i, k], right[k, j])
            real, imaginary = _plus(real, x), _plus(imaginary, y)
        found[i, j] = real, imaginary
    return found
