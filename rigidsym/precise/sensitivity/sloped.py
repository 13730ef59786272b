"""Numbers over a box of inputs, with slopes: the mean value form, carried through arithmetic.

A quantity f has its value at the middle of the box, the ball of its values, and slopes s with

    f(y) - f(middle)  in  s (y - middle)    for all y of the box

(Krawczyk and Neumaier, SIAM Journal on Numerical Analysis 22, 604-616, 1985): what is proportional
to the radii of the inputs is as it is, so that terms which cancel do.
"""

from dataclasses import dataclass
from typing import Union

from flint import arb, arb_mat

from rigidsym.precise import balls
from rigidsym.precise.balls import meeting

Operand = Union["Sloped", arb, int]


@dataclass(frozen=True, slots=True, eq=False)
class Sloped:
    """middle, slopes (1, n), whole; `box` (n, 1) holds the inputs less their middles."""

    middle: arb
    slopes: arb_mat
    whole: arb
    box: arb_mat

    @classmethod
    def of(cls, middle: arb, slopes: arb_mat, whole: arb, box: arb_mat) -> "Sloped":
        """With the values that both the slopes and `whole` allow."""
        return cls(middle, slopes, meeting(middle + (slopes * box)[0, 0], whole), box)

    def apart(self) -> arb:
        """How far from its middle it may be, by the slopes."""
        return (self.slopes * self.box)[0, 0]

    def least(self) -> arb:
        """A radius that no ball of its values can be below: at a corner of the box, and the one
        across, all that slopes surely add up to is reached."""
        sure = arb_mat([[x.abs_lower() for x in self.slopes.entries()]])
        radii = arb_mat([[x.rad()] for x in self.box.entries()])
        return (sure * radii)[0, 0].lower()

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
        """Its square root; no number where it may be negative."""
        middle, whole = self.middle.sqrt(), self.whole.sqrt()
        return self.of(middle, self.slopes / (middle + whole), whole, self.box)

    def square(self) -> "Sloped":
        """Its square, which is not negative."""
        slopes = self.slopes * (self.middle + self.whole)
        return self.of(self.middle * self.middle, slopes, balls.power(self.whole, 2), self.box)


def power(x: Operand, exponent: int) -> "Sloped | arb":
    """A power by squares and products, of exponents that are positive."""
    if not isinstance(x, Sloped):
        return balls.power(arb(x), exponent)
    return _power(x, exponent)


def _power(x: Sloped, exponent: int) -> Sloped:
    if exponent == 1:
        return x
    square = _power(x, exponent // 2).square()
    return square * x if exponent % 2 else square
