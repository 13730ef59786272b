"""Complex numbers and two-by-two matrices whose parts are expression trees.

Products are expanded into real and imaginary parts without zeros and ones; the kernel expands
the rest.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import reduce
from itertools import product
from typing import TypeAlias

from rigidsym.language._expression import Call, Expression, Number, Operation
from rigidsym.proof.paper._printed.parser import PrintError

ZERO, ONE = Number(0), Number(1)


def plus(x: Expression, y: Expression) -> Expression:
    """Return the sum of two expressions, without a zero term."""
    return y if x == ZERO else x if y == ZERO else Operation("+", x, y)


def minus(x: Expression, y: Expression) -> Expression:
    """Return the difference of two expressions, without a zero term."""
    return x if y == ZERO else negative(y) if x == ZERO else Operation("-", x, y)


def times(x: Expression, y: Expression) -> Expression:
    """Return the product of two expressions, without a factor 1."""
    if ZERO in (x, y):
        return ZERO
    return y if x == ONE else x if y == ONE else Operation("*", x, y)


def over(x: Expression, y: Expression) -> Expression:
    """Return the quotient of two expressions, without a denominator 1."""
    return x if x == ZERO or y == ONE else Operation("/", x, y)


def negative(x: Expression) -> Expression:
    """Return the negative of an expression, without a double sign."""
    match x:
        case Number(0):
            return x
        case Call("neg", (inner,)):
            return inner
    return Call("neg", (x,))


@dataclass(frozen=True, slots=True)
class Complex:
    """A complex number whose real and imaginary parts are expressions."""

    real: Expression
    imag: Expression = ZERO

    def __iter__(self) -> Iterator[Expression]:
        return iter((self.real, self.imag))

    def __add__(self, other: "Complex") -> "Complex":
        return Complex(plus(self.real, other.real), plus(self.imag, other.imag))

    def __sub__(self, other: "Complex") -> "Complex":
        return Complex(minus(self.real, other.real), minus(self.imag, other.imag))

    def __mul__(self, other: "Complex") -> "Complex":
        return Complex(
            minus(times(self.real, other.real), times(self.imag, other.imag)),
            plus(times(self.real, other.imag), times(self.imag, other.real)),
        )

    def __truediv__(self, other: "Complex") -> "Complex":
        if other.imag == ZERO:
            return Complex(over(self.real, other.real), over(self.imag, other.real))
        above = self * other.conjugate()
        return Complex(over(above.real, other.square()), over(above.imag, other.square()))

    def conjugate(self) -> "Complex":
        """Return the complex conjugate."""
        return Complex(self.real, negative(self.imag))

    def square(self) -> Expression:
        """Return the square of the absolute value."""
        return plus(*(times(x, x) for x in self))

    def each(self, change: Callable[[Expression], Expression]) -> "Complex":
        """Apply a function to the real and the imaginary part."""
        return Complex(change(self.real), change(self.imag))


@dataclass(frozen=True, slots=True)
class Matrix:
    """A two-by-two matrix of complex numbers.

    Iteration gives the real and imaginary parts of its entries.
    """

    entries: tuple[Complex, Complex, Complex, Complex]

    def __iter__(self) -> Iterator[Expression]:
        return (part for entry in self.entries for part in entry)

    def __add__(self, other: "Matrix") -> "Matrix":
        return matrix(x + y for x, y in zip(self.entries, other.entries, strict=True))

    def __sub__(self, other: "Matrix") -> "Matrix":
        return matrix(x - y for x, y in zip(self.entries, other.entries, strict=True))

    def __matmul__(self, other: "Matrix") -> "Matrix":
        a, b = self.entries, other.entries
        rows, columns = (a[:2], a[2:]), (b[::2], b[1::2])
        return matrix(x[0] * y[0] + x[1] * y[1] for x, y in product(rows, columns))

    def scaled(self, factor: Complex) -> "Matrix":
        """Return the matrix times a number."""
        return matrix(factor * entry for entry in self.entries)

    def determinant(self) -> Complex:
        """Return the determinant of the matrix."""
        a, b, c, d = self.entries
        return a * d - b * c

    def adjugate(self) -> "Matrix":
        """Return the adjugate of the matrix.

        It is the inverse of a matrix with determinant 1.
        """
        a, b, c, d = self.entries
        return Matrix((d, Complex(ZERO) - b, Complex(ZERO) - c, a))

    def dagger(self) -> "Matrix":
        """Return the conjugate transpose of the matrix."""
        a, b, c, d = (entry.conjugate() for entry in self.entries)
        return Matrix((a, c, b, d))

    def each(self, change: Callable[[Expression], Expression]) -> "Matrix":
        """Apply a function to the real and imaginary parts of all entries."""
        return matrix(entry.each(change) for entry in self.entries)


Value: TypeAlias = Complex | Matrix


def matrix(entries: Iterator[Complex]) -> Matrix:
    """Build a two-by-two matrix from its four entries, row by row."""
    a, b, c, d = entries
    return Matrix((a, b, c, d))


IDENTITY = Matrix((Complex(ONE), Complex(ZERO), Complex(ZERO), Complex(ONE)))


def add(x: Value, y: Value) -> Value:
    """Return the sum of two numbers or matrices.

    A number added to a matrix is a multiple of the identity.
    """
    a, b = alike(x, y)
    return a + b  # ty: ignore[unsupported-operator]


def subtract(x: Value, y: Value) -> Value:
    """Return the difference of two numbers or matrices.

    A number beside a matrix is a multiple of the identity.
    """
    a, b = alike(x, y)
    return a - b  # ty: ignore[unsupported-operator]


def multiply(x: Value, y: Value) -> Value:
    """Return the product of two numbers or matrices."""
    match x, y:
        case Complex(), Complex():
            return x * y
        case Complex(), Matrix():
            return y.scaled(x)
        case Matrix(), Complex():
            return x.scaled(y)
        case Matrix(), Matrix():
            return x @ y
    raise PrintError("a product of neither numbers nor matrices")


def divide(x: Value, y: Value) -> Value:
    """Divide a number or a matrix by a number."""
    if isinstance(y, Matrix):
        raise PrintError("a matrix stands below a line")
    return x.scaled(Complex(ONE) / y) if isinstance(x, Matrix) else x / y


def power(x: Value, exponent: int) -> Value:
    """Return an integer power of a number or matrix."""
    if isinstance(x, Complex) and x.imag == ZERO and exponent > 0:
        return x if exponent == 1 else Complex(Operation("**", x.real, Number(exponent)))
    if exponent < 1:
        inverse = x.adjugate() if isinstance(x, Matrix) else Complex(ONE) / x
        return power(inverse, -exponent) if exponent else Complex(ONE)
    return reduce(multiply, [x] * exponent)


def alike(x: Value, y: Value) -> tuple[Value, Value]:
    """Convert two values to the same type, both to numbers or both to matrices.

    A number beside a matrix becomes a multiple of the identity.
    """
    if isinstance(x, Matrix) and isinstance(y, Complex):
        return x, IDENTITY.scaled(y)
    if isinstance(y, Matrix) and isinstance(x, Complex):
        return IDENTITY.scaled(x), y
    return x, y
