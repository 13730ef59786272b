"""SU(2) and its Lie algebra as two-by-two matrices over the complex numbers of a ring.

The basis is the paper's (4): [A1, A2] = A3 and cyclically.  Complex entries are pairs of ring
elements, so the kernel only ever sees real identities.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rigidsym.proof.kernel import Element, Ring


@dataclass(frozen=True, slots=True)
class Complex:
    """real + i imag, both from one ring."""

    real: Element
    imag: Element

    def __add__(self, other: "Complex") -> "Complex":
        return Complex(self.real + other.real, self.imag + other.imag)

    def __sub__(self, other: "Complex") -> "Complex":
        return Complex(self.real - other.real, self.imag - other.imag)

    def __neg__(self) -> "Complex":
        return self * -1

    def __mul__(self, other: "Complex | Element | int") -> "Complex":
        if not isinstance(other, Complex):
            return Complex(self.real * other, self.imag * other)
        return Complex(
            self.real * other.real - self.imag * other.imag,
            self.real * other.imag + self.imag * other.real,
        )

    def conjugate(self) -> "Complex":
        """real - i imag"""
        return Complex(self.real, self.imag * -1)

    def rate(self) -> "Complex":
        """The time derivative."""
        ring = self.real.ring
        return Complex(ring.rate(self.real), ring.rate(self.imag))


@dataclass(frozen=True, slots=True)
class Matrix:
    """((a, b), (c, d)) with complex entries; iterating gives its real and imaginary parts."""

    a: Complex
    b: Complex
    c: Complex
    d: Complex

    @property
    def entries(self) -> tuple[Complex, Complex, Complex, Complex]:
        """Row by row."""
        return self.a, self.b, self.c, self.d

    def __iter__(self) -> Iterator[Element]:
        return (part for entry in self.entries for part in (entry.real, entry.imag))

    def __add__(self, other: "Matrix") -> "Matrix":
        return Matrix(*(x + y for x, y in zip(self.entries, other.entries, strict=True)))

    def __sub__(self, other: "Matrix") -> "Matrix":
        return Matrix(*(x - y for x, y in zip(self.entries, other.entries, strict=True)))

    def __mul__(self, scalar: Element | int) -> "Matrix":
        return Matrix(*(entry * scalar for entry in self.entries))

    def __matmul__(self, other: "Matrix") -> "Matrix":
        return Matrix(
            self.a * other.a + self.b * other.c,
            self.a * other.b + self.b * other.d,
            self.c * other.a + self.d * other.c,
            self.c * other.b + self.d * other.d,
        )

    def inverse(self) -> "Matrix":
        """The adjugate: the inverse, where the determinant is 1."""
        return Matrix(self.d, -self.b, -self.c, self.a)

    def dagger(self) -> "Matrix":
        """The conjugate transpose."""
        return Matrix(*(entry.conjugate() for entry in (self.a, self.c, self.b, self.d)))

    def determinant(self) -> Complex:
        """a d - b c"""
        return self.a * self.d - self.b * self.c

    def rate(self) -> "Matrix":
        """The time derivative, entry by entry."""
        return Matrix(*(entry.rate() for entry in self.entries))


def commutator(x: Matrix, y: Matrix) -> Matrix:
    """[x, y] = x y - y x"""
    return x @ y - y @ x


def basis(ring: Ring) -> tuple[Matrix, Matrix, Matrix]:
    """The paper's A1, A2, A3 (4)."""
    zero, half = ring.element(0), ring.element(1) / 2
    nil, real, imaginary = Complex(zero, zero), Complex(half, zero), Complex(zero, half)
    return (
        Matrix(imaginary, nil, nil, -imaginary),
        Matrix(nil, real, -real, nil),
        Matrix(nil, imaginary, imaginary, nil),
    )


def combination(components: Sequence[Element]) -> Matrix:
    """x1 A1 + x2 A2 + x3 A3, the paper's (8)."""
    one, two, three = (a * x for x, a in zip(components, basis(components[0].ring), strict=True))
    return one + two + three


def from_quaternion(q: Sequence[Element]) -> Matrix:
    """The paper's map F of (1) and (2): q0 + q1 i + q2 j + q3 k -> ((z1, z2), (-z2*, z1*))."""
    z1, z2 = Complex(q[0], q[1]), Complex(q[2], q[3])
    return Matrix(z1, z2, -z2.conjugate(), z1.conjugate())


def exponential(axis: int, cosine: Element, sine: Element) -> Matrix:
    """exp(phi A_axis) from the cosine and sine of phi/2: its square is that of the matrix."""
    direction = [sine * (axis == k) for k in (1, 2, 3)]
    return from_quaternion((cosine, *direction))
