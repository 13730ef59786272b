"""A box of bodies and rates: its middle, exactly, and its numbers with slopes."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce

from flint import arb, arb_mat

from rigidsym.inputs import Number, is_uncertain, middle, radius
from rigidsym.precise import balls
from rigidsym.precise.balls import ball
from rigidsym.precise.sensitivity.columns import INPUTS, Columns, axes_of, parameters
from rigidsym.precise.sensitivity.sloped import Sloped, power

STILL = tuple(map(arb, (1, 0, 0, 0)))


@dataclass(frozen=True)
class Box:
    """Inertia (3) and body rates (3), some of them uncertain; at the working precision."""

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]

    @cached_property
    def open(self) -> list[int]:
        """Which of the `INPUTS` are uncertain; one at least, be it exact."""
        return [k for k, x in enumerate(self._given) if radius(x)] or [0]

    @property
    def names(self) -> list[str]:
        """The same by their names."""
        return [INPUTS[k] for k in self.open]

    @cached_property
    def sides(self) -> arb_mat:
        """These inputs less their middles (n, 1)."""
        return arb_mat([[arb(0, ball(radius(self._given[k])).upper())] for k in self.open])

    @property
    def is_sphere(self) -> bool:
        """Whether all moments are one exact number."""
        return self._is_sphere_amid and not is_uncertain(*self.inertia)

    @property
    def _is_sphere_amid(self) -> bool:
        return len({*self._middles[0]}) == 1

    @cached_property
    def parameters(self) -> list[Fraction]:
        """p, r and p - r of the middle."""
        return parameters(*self._middles, self._axes)

    @cached_property
    def point(self) -> Columns:
        """The formulas for the middle."""
        inertia, omega0 = (list(map(ball, values)) for values in self._middles)
        functions = {"power": balls.power}
        return Columns(inertia, omega0, STILL, self._axes, functions, self._is_sphere_amid)

    @cached_property
    def whole(self) -> Columns:
        """The formulas for all of the box."""
        omega0, inertia = (list(map(self._sloped, places)) for places in (range(3), range(3, 6)))
        functions = {"power": power}
        product = self._product() if self._is_sphere_amid else None
        return Columns(inertia, omega0, STILL, self._axes, functions, self.is_sphere, product)

    def _product(self) -> arb:
        """Of all rates at any time, whose squares are at most |omega|^2/3 in the mean, and that
        the energy over the least moment."""
        omega, moments = (list(map(ball, x)) for x in (self.omega0, self.inertia))
        least = reduce(arb.min, moments)
        energy = sum((c * balls.power(w, 2) for c, w in zip(moments, omega, strict=True)), arb(0))
        return arb(0, ((energy / least / 3).sqrt() ** 3).upper())

    def _sloped(self, k: int) -> Sloped:
        slopes = arb_mat([[int(j == k) for j in self.open]])
        return Sloped(ball(middle(self._given[k])), slopes, ball(self._given[k]), self.sides)

    @property
    def _given(self) -> tuple[Number, ...]:
        return *self.omega0, *self.inertia

    @cached_property
    def _axes(self) -> Sequence[int]:
        return axes_of(*self._middles)

    @cached_property
    def _middles(self) -> tuple[list[Fraction], list[Fraction]]:
        return list(map(middle, self.inertia)), list(map(middle, self.omega0))
