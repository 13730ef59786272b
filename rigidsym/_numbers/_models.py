"""Solutions of differential equations with proved bounds, by Picard's iteration on Taylor models.

A `Model` is a polynomial of the time within a step, with a bound of its error there.  Where
y0 + integral of f(y) maps a model into itself, it contains the solution of y' = f(y).  The right
side f may be any function in the arithmetic of models.  Sources: Makino and Berz, International
Journal of Pure and Applied Mathematics 4 (2003), 379-456.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, arb_poly, arb_series, ctx

from rigidsym.errors import PrecisionError

TERMS = 16
# Tries to find a bound that Picard's iteration keeps.
TRIES, GROWTH = 24, arb(5) / 4
# The first try allows for this error.
FIRST = arb(2) ** -54


@dataclass(frozen=True, slots=True)
class Model:
    """A function of the time within a step: a polynomial, and a bound of its error there."""

    polynomial: arb_poly
    error: arb
    step: arb

    def __add__(self, other: "Model | arb | int") -> "Model":
        if not isinstance(other, Model):
            return Model(self.polynomial + other, self.error, self.step)
        error = (self.error + other.error).upper()
        return Model(self.polynomial + other.polynomial, error, self.step)

    __radd__ = __add__

    def __mul__(self, other: "Model | arb | int") -> "Model":
        if not isinstance(other, Model):
            factor = arb(other)
            error = (self.error * abs(factor)).upper()
            return Model(self.polynomial * factor, error, self.step)
        error = self.error * (other.size + other.error) + other.error * self.size
        return _cut(self.polynomial * other.polynomial, error, self.step)

    __rmul__ = __mul__

    def __neg__(self) -> "Model":
        return Model(-self.polynomial, self.error, self.step)

    def __sub__(self, other: "Model | arb | int") -> "Model":
        return self + -other

    def __rsub__(self, other: "arb | int") -> "Model":
        return -self + other

    def __truediv__(self, other: "Model | arb | int") -> "Model":
        return self * (other.inverse() if isinstance(other, Model) else 1 / arb(other))

    @property
    def size(self) -> arb:
        """An upper bound of the absolute value of the polynomial within the step."""
        return _size(self.polynomial, self.step)

    def inverse(self) -> "Model":
        """Return the reciprocal; its error is infinite where the function may be zero."""
        found = Model(arb_poly(list(1 / arb_series(self.polynomial.coeffs()))), arb(0), self.step)
        off = self * found - 1
        most = (off.size + off.error).upper()
        error = found.size * most / (1 - most) if most < 1 else arb.pos_inf()
        return Model(found.polynomial, error.upper(), self.step)

    def integral(self) -> "Model":
        """Return the integral from the beginning of the step."""
        return _cut(self.polynomial.integral(), self.error * abs(self.step), self.step)

    def end(self) -> arb:
        """Return an enclosure of the value at the end of the step."""
        return self.polynomial(self.step) + arb(0, self.error)


def _size(polynomial: arb_poly, step: arb) -> arb:
    return polynomial(arb(0, step.abs_upper())).abs_upper()


def _cut(polynomial: arb_poly, error: arb, step: arb) -> Model:
    """Return a model of a polynomial, without its terms beyond TERMS."""
    if polynomial.degree() >= TERMS:
        coefficients = polynomial.coeffs()
        error += _size(arb_poly(coefficients[TERMS:]), step) * abs(step) ** TERMS
        polynomial = arb_poly(coefficients[:TERMS])
    return Model(polynomial, error.upper(), step)


Right = Callable[[Sequence[Any], Sequence[Any]], Sequence[Any]]


def solve(
    right: Right, start: Sequence[arb], step: arb, known: Sequence[Model] = ()
) -> list[Model]:
    """Return models of the solution of y' = f(y, known) within a step.

    Raises PrecisionError for a step that is too long.
    """
    given = [arb_series(model.polynomial.coeffs()) for model in known]
    series = [arb_series([x.mid()]) for x in start]
    for ctx.cap in range(2, TERMS + 1):  # each round gives one more term
        rates = right(series, given)
        series = [x.mid() + rate.integral() for x, rate in zip(start, rates, strict=True)]
    polynomials = [arb_poly([x.mid() for x in s]) for s in series]
    errors = [4 * x.rad() + FIRST for x in start]
    for _ in range(TRIES):
        models = [Model(p, error, step) for p, error in zip(polynomials, errors, strict=True)]
        images = [
            begin + rate.integral() - model
            for begin, rate, model in zip(start, right(models, known), models, strict=True)
        ]
        # The difference of two models counts the error of the one that it is compared with.
        found = [
            (image.size + image.error - error).upper()
            for image, error in zip(images, errors, strict=True)
        ]
        if all(x <= error for x, error in zip(found, errors, strict=True)):
            return [Model(p, error, step) for p, error in zip(polynomials, found, strict=True)]
        errors = [(GROWTH * x).upper().max(error) for x, error in zip(found, errors, strict=True)]
    raise PrecisionError("a step is too long for a Taylor series")
