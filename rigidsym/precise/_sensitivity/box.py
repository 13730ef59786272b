"""Boxes of uncertain moments and rates, and regions that pairs of hyperplanes cut out of them.

Such a region, or part, is cut out by slabs: low <= g . (x - middle of the box) <= high for some
directions g.  With V the matrix of these directions and any W, the deviation of inputs from the
part's middle is

    d = W (V d) + (1 - W V) d,

so numbers have slopes by V d, which the slabs limit, and by d, which the box limits.  W is the
pseudoinverse of V: then (1 - W V) W = 0, and d may be taken from the middle of the whole box, where
it is least.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce
from itertools import combinations
from math import inf

import numpy as np
from flint import arb, arb_mat

from rigidsym._inputs import Number, is_uncertain, middle, radius
from rigidsym.precise import _balls as balls
from rigidsym.precise._balls import ball, intersection
from rigidsym.precise._sensitivity.columns import INPUTS, Columns, axes_of, parameters
from rigidsym.precise._sensitivity.sloped import Sloped, power

STILL = tuple(map(arb, (1, 0, 0, 0)))
# Steps towards the slabs' middles and back into the box.
_PROJECTIONS = 20
# Passes over the slabs; the least share of an input that is used; room for rounding.
_PASSES, _LEAST_SHARE, MARGIN = 2, 1e-3, 1e-9


@dataclass(frozen=True)
class Slab:
    """The region between two hyperplanes: low <= direction . d <= high for input deviations d.

    Its numbers are taken at their exact binary value.

    d: the open inputs (n) less their middles in the whole box.
    """

    direction: tuple[float, ...]
    low: float
    high: float


@dataclass(frozen=True)
class Box:
    """A box of uncertain moments and body rates, or a region that slabs cut out of it.

    There are three moments and three rates.

    All numbers have the working precision.  The open inputs are the n uncertain ones.  The sides of
    the part are its s slabs and the open inputs.
    """

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    slabs: tuple[Slab, ...] = ()

    @cached_property
    def open(self) -> list[int]:
        """The indices of the uncertain inputs, or of the first input if all are exact.

        They refer to `INPUTS`.
        """
        return [k for k, x in enumerate(self._given) if radius(x)] or [0]

    @property
    def names(self) -> list[str]:
        """The names of the open (uncertain) inputs."""
        return [INPUTS[k] for k in self.open]

    @cached_property
    def limits(self) -> np.ndarray | None:
        """The lower and upper limits (n, 2) of the uncertain inputs in this region of the box.

        None for an empty region.

        They are less the middles of the box, and in units of the inputs' radii.
        A slab and the ends of all other inputs limit each input.  `MARGIN` is far above the
        rounding errors of doubles here.
        """
        ends = np.tile([-1.0, 1.0], (len(self.open), 1))
        for slab in self.slabs * _PASSES:
            share = np.array(slab.direction) * self.radii
            terms = np.sort(ends * share[:, None], axis=1)
            least, most = slab.low - terms[:, 1].sum(), slab.high - terms[:, 0].sum()
            for k in np.flatnonzero(abs(share) > _LEAST_SHARE * abs(share).sum()):
                found = np.sort([(least + terms[k, 1]) / share[k], (most + terms[k, 0]) / share[k]])
                low, high = found + (-MARGIN, MARGIN)
                ends[k] = max(ends[k, 0], low), min(ends[k, 1], high)
                if not ends[k, 0] <= ends[k, 1]:
                    return None
        return ends

    @cached_property
    def shift(self) -> list[Fraction]:
        """The shift (n) from the midpoint of the box to the midpoint of this region.

        The latter is within the limits.
        """
        if self.limits is None or not self.slabs:
            return [Fraction(0)] * len(self.open)
        found = self.limits.mean(axis=1)
        scaled = np.array([slab.direction for slab in self.slabs]) * self.radii
        wanted = np.array([(slab.low + slab.high) / 2 for slab in self.slabs])
        inverse = np.linalg.pinv(scaled)
        for _ in range(_PROJECTIONS):
            found = np.clip(found + inverse @ (wanted - scaled @ found), *self.limits.T)
        return self._unscaled(found)

    @cached_property
    def inputs(self) -> arb_mat:
        """The ranges (n, 1) of the inputs' deviations, up to offsets along the slabs' normals."""
        off = arb_mat([[x] for x in self._left])
        if not self.slabs or self.limits is None:
            return off
        shift, center = (
            arb_mat([[ball(x)] for x in values])
            for values in (self.shift, self._unscaled(self.limits.mean(axis=1)))
        )
        return off - center - self._across * (shift - center)

    @cached_property
    def radii(self) -> np.ndarray:
        """The radii (n,) of the uncertain inputs, rounded to doubles.

        They are infinite beyond the range of doubles.
        """
        return np.array(list(map(_double, self._radii)))

    @cached_property
    def _radii(self) -> list[Fraction]:
        return [radius(self._given[k]) for k in self.open]

    @cached_property
    def _left(self) -> list[arb]:
        """The ranges left to uncertain inputs in this region, relative to the box's midpoint."""
        if self.limits is None or not self.slabs:
            return [arb(0, ball(r).upper()) for r in self._radii]
        low, high = map(self._unscaled, self.limits.T)
        return [ball(x).union(ball(y)) for x, y in zip(low, high, strict=True)]

    def _unscaled(self, values: np.ndarray) -> list[Fraction]:
        return [Fraction(x) * r for x, r in zip(values.tolist(), self._radii, strict=True)]

    @cached_property
    def along(self) -> arb_mat:
        """The ranges (s, 1) of deviations from this region's midpoint along each slab's normal."""
        shift = list(map(ball, self.shift))
        rows = []
        for slab in self.slabs:
            begin = sum((arb(g) * x for g, x in zip(slab.direction, shift, strict=True)), arb(0))
            # The middle is included, as straight lines from it must stay inside.
            rows.append([(arb(slab.low) - begin).union(arb(slab.high) - begin).union(arb(0))])
        return arb_mat(rows) if rows else arb_mat(0, 1)

    @cached_property
    def sides(self) -> arb_mat:
        """The ranges (s + n, 1) of the variables, called sides, for which numbers have slopes.

        They are the deviations of inputs along the slabs' directions, and those of all inputs.
        """
        return arb_mat([*self.along.tolist(), *self.inputs.tolist()])

    @cached_property
    def by_sides(self) -> arb_mat:
        """The matrix (n, s + n) that maps `sides` to deviations from this region's midpoint."""
        if not self.slabs:
            return self._across
        rows = zip(self._back.tolist(), self._across.tolist(), strict=True)
        return arb_mat([[*x, *y] for x, y in rows])

    @cached_property
    def _across(self) -> arb_mat:
        """The projection (n, n) of inputs onto the subspace orthogonal to the slabs' normals.

        It is 1 - W V.
        """
        unit = arb_mat(len(self.open), len(self.open), 1)
        return unit - self._back * self._directions if self.slabs else unit

    @cached_property
    def _back(self) -> arb_mat:
        """The pseudoinverse (n, s) of the matrix of the slabs' directions.

        It is W.  Inputs are in units of their radii.
        """
        rows = zip(self._directions.transpose().tolist(), self._radii, strict=True)
        weighted = arb_mat([[x * ball(r) ** 2 for x in row] for row, r in rows])
        return weighted * (self._directions * weighted).inv()

    @cached_property
    def directions(self) -> dict[str, list[arb]]:
        """The rows (s + n) of `by_sides`, by the names of the uncertain inputs."""
        return dict(zip(self.names, self.by_sides.tolist(), strict=True))

    def reach(self, slopes: Sequence[arb]) -> arb:
        """Return the range of a number over this region of the box from its slopes.

        The slopes (s + n) are those by the sides.

        A slope by the inputs may also be counted along the slabs, and the other way round.  The
        result is the intersection of the least range slab by slab and that by the inputs alone.
        """
        count = len(self.slabs)
        rest, plain = list(slopes[count:]), list(slopes[count:])
        found, alone = arb(0), arb(0)
        radii = [float(x.rad()) for x in self.inputs.entries()]
        for slab, slope, side, offset in zip(
            self.slabs, slopes[:count], self.along.entries(), self._offsets, strict=True
        ):
            direction = list(map(arb, slab.direction))
            part = _share([float(x.mid()) for x in rest], slab.direction, radii, slope, side)
            found += slope * side
            if part:
                found += part * (side + offset)
                rest = [x - part * g for x, g in zip(rest, direction, strict=True)]
            alone -= slope * offset
            plain = [x + slope * g for x, g in zip(plain, direction, strict=True)]
        for x, y, far in zip(rest, plain, self.inputs.entries(), strict=True):
            found, alone = found + x * far, alone + y * far
        return intersection(found, alone) if count else found

    @cached_property
    def _offsets(self) -> list[arb]:
        """The offsets along each slab's normal between the midpoints of `inputs` and `along`."""
        if self.limits is None:
            return []
        center = self._unscaled(self.limits.mean(axis=1))
        excess = [ball(x - y) for x, y in zip(self.shift, center, strict=True)]
        rows = (map(arb, slab.direction) for slab in self.slabs)
        return [sum((g * x for g, x in zip(row, excess, strict=True)), arb(0)) for row in rows]

    @property
    def _directions(self) -> arb_mat:
        """The matrix (s, n) whose rows are the slabs' directions, called V."""
        return arb_mat([list(slab.direction) for slab in self.slabs])

    @property
    def is_sphere(self) -> bool:
        """True if all moments are one exact number."""
        return self._is_sphere_amid and not is_uncertain(*self.inertia)

    @property
    def _is_sphere_amid(self) -> bool:
        return len({*self.middles[0]}) == 1

    @cached_property
    def parameters(self) -> list[Fraction]:
        """The parameters p, r, p - r of elliptic functions for the motion of the midpoint."""
        return parameters(*self.middles, self._axes)

    @cached_property
    def point(self) -> Columns:
        """The formulas of sensitivities for the motion of this region's midpoint."""
        inertia, omega0 = (list(map(ball, values)) for values in self.middles)
        functions = {"power": balls.power}
        return Columns(inertia, omega0, STILL, self._axes, functions, self._is_sphere_amid)

    @cached_property
    def whole(self) -> Columns:
        """The formulas of sensitivities that enclose all motions of this region."""
        omega0, inertia = (list(map(self._sloped, places)) for places in (range(3), range(3, 6)))
        functions = {"power": power}
        product, rates, moments = None, self._wholes[:3], self._wholes[3:]
        if all(x.overlaps(y) for x, y in combinations(moments, 2)):  # they may be a sphere's
            # The product of all rates is at most (|omega|^2/3)^(3/2) at any time, as the geometric
            # mean of the squares is at most their mean; and |omega|^2 is at most twice the energy
            # over the least moment.
            squares = zip(moments, (balls.power(w, 2) for w in rates), strict=True)
            energy = sum((c * square for c, square in squares), arb(0))
            mean = energy / reduce(arb.min, moments) / 3
            product = arb(0, (mean.sqrt() ** 3).upper())
        return Columns(inertia, omega0, STILL, self._axes, functions, self.is_sphere, product)

    def _sloped(self, k: int) -> Sloped:
        whole = self._wholes[k]
        if k not in self.open:
            zeros = arb_mat(1, self.sides.nrows())
            return Sloped(whole, zeros, whole, self.sides)
        row = arb_mat([self.by_sides.tolist()[self.open.index(k)]])
        return Sloped.of(ball(self._amid[k]), row, whole, self.sides)

    @cached_property
    def _wholes(self) -> list[arb]:
        """The balls that enclose the body rates and moments in this region."""
        wholes = [ball(middle(x)) for x in self._given]
        for k, left in zip(self.open, self._left, strict=True):
            wholes[k] += left
        return wholes

    @property
    def _given(self) -> tuple[Number, ...]:
        return *self.omega0, *self.inertia

    @cached_property
    def _axes(self) -> Sequence[int]:
        return axes_of(*self.middles)

    @property
    def middles(self) -> tuple[list[Fraction], list[Fraction]]:
        """The moments and the body rates at the midpoint of this region."""
        return self._amid[3:], self._amid[:3]

    @cached_property
    def _amid(self) -> list[Fraction]:
        """The body rates and moments at the midpoint of this region, as one list."""
        amid = list(map(middle, self._given))
        for k, x in zip(self.open, self.shift, strict=True):
            amid[k] += x
        return amid


def _share(
    slopes: Sequence[float],
    direction: Sequence[float],
    radii: Sequence[float],
    along: arb,
    side: arb,
) -> float:
    """Choose the share of a number's slopes to count along a slab, for the narrowest range.

    It is a multiple of the slab's direction, counted along the slab instead of in the slopes.

    It makes the range of the number least, at one of the corners of this piecewise linear function.
    """
    have, half = float(along.mid()), float(side.rad())
    corners = [0.0, *(x / g for x, g in zip(slopes, direction, strict=True) if g)]

    def size(part: float) -> float:
        rest = zip(slopes, direction, radii, strict=True)
        return abs(have + part) * half + sum(abs(x - part * g) * r for x, g, r in rest)

    return min([*corners, -have], key=size)


def _double(x: Fraction) -> float:
    try:
        return float(x)
    except OverflowError:
        return inf
