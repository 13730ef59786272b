"""Interval arithmetic with slopes, for numbers that depend on a box of inputs.

A quantity f has its value at the middle of the box, the ball of its values, and slopes s with

    f(y) - f(middle)  in  s (y - middle)    for all y of the box

(Krawczyk and Neumaier, SIAM Journal on Numerical Analysis 22, 604-616, 1985).  Terms that are
proportional to the radii of the inputs keep their sign, so they cancel where they should.
"""

from dataclasses import dataclass
from typing import Union

from flint import arb, arb_mat

from rigidsym.precise import _balls as balls
from rigidsym.precise._balls import intersection

Operand = Union["Sloped", arb, int]


@dataclass(frozen=True, slots=True, eq=False)
class Sloped:
    """A number as a function of the inputs in a box, enclosed by its slopes.

    middle: its value at the middle of the box. slopes (1, n): by the inputs. whole: the ball of all
    values. box (n, 1): the inputs less their middles.
    """

    middle: arb
    slopes: arb_mat
    whole: arb
    box: arb_mat

    @classmethod
    def of(cls, middle: arb, slopes: arb_mat, whole: arb, box: arb_mat) -> "Sloped":
        """Create a number whose range is restricted to the values that its slopes allow."""
        return cls(middle, slopes, intersection(middle + (slopes * box)[0, 0], whole), box)

    def deviation(self) -> arb:
        """Return the range of deviations from the middle that the slopes allow."""
        return (self.slopes * self.box)[0, 0]

    def __neg__(self) -> "Sloped":
        return Sloped(-self.middle, -self.slopes, -self.whole, self.box)

    def __add__(self, other: Operand) -> "Sloped":
        if isinstance(other, Sloped):
            middle, slopes = self.middle + other.middle, self.slopes + other.slopes
            return self.of(middle, slopes, self.whole + other.whole, self.box)
        return Sloped(self.middle + other, self.slopes, self.whole + other, self.box)

    def __sub__(self, other: Operand) -> "Sloped":
        return self + -other

    def __rsub__(self, other: Operand) -> "Sloped":
        return -self + other

    def __mul__(self, other: Operand) -> "Sloped":
        if isinstance(other, Sloped):
            middle, slopes = (
                self.middle * other.middle,
                self.slopes * other.whole + other.slopes * self.middle,
            )
            return self.of(middle, slopes, self.whole * other.whole, self.box)
        return Sloped(self.middle * other, self.slopes * other, self.whole * other, self.box)

    def __truediv__(self, other: Operand) -> "Sloped":
        if isinstance(other, Sloped):
            middle = self.middle / other.middle
            slopes = (self.slopes - other.slopes * middle) / other.whole
            return self.of(middle, slopes, self.whole / other.whole, self.box)
        return Sloped(self.middle / other, self.slopes / other, self.whole / other, self.box)

    def __rtruediv__(self, other: arb | int) -> "Sloped":
        middle = other / self.middle
        return self.of(middle, self.slopes * -middle / self.whole, other / self.whole, self.box)

    __radd__, __rmul__ = __add__, __mul__

    def sqrt(self) -> "Sloped":
        """Return the square root of the number.

        It is NaN where the radicand may be negative.
        """
        middle, whole = self.middle.sqrt(), self.whole.sqrt()
        return self.of(middle, self.slopes / (middle + whole), whole, self.box)

    def square(self) -> "Sloped":
        """Return the square of the number, whose range is not negative."""
        slopes = self.slopes * (self.middle + self.whole)
        return self.of(self.middle * self.middle, slopes, balls.power(self.whole, 2), self.box)


def power(x: Operand, exponent: int) -> "Sloped | arb":
    """Compute a positive integer power by repeated squaring."""
    if not isinstance(x, Sloped):
        return balls.power(arb(x), exponent)
    if exponent == 1:
        return x
    half = power(x, exponent // 2)
    assert isinstance(half, Sloped)
    return half.square() * x if exponent % 2 else half.square()
