"""States and sensitivities of all motions of a box, by mean value forms over its parts.

A box is cut into parts where the mean value form of the whole box is too wide.  The excess of the
form grows with the square of the box, so parts of it have less.  The part that reaches farthest
beyond its first order is cut next, into slabs across the direction in which the phases of the
motion change most.  The enclosure of each part is rigorous.  The choice of parts is made in
doubles: any parts that cover the box would do.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial, reduce
from itertools import pairwise
from math import ceil, inf

import numpy as np
from flint import arb, arb_mat

from rigidsym._inputs import middle, radius
from rigidsym.precise._balls import (
    BITS_PER_DIGIT,
    TOO_UNCERTAIN,
    AdaptivePrecision,
    ball,
    intersection,
    is_within,
    unit,
    working,
)
from rigidsym.precise._evaluation import State
from rigidsym.precise._flow import euler_factor, rate_bounds
from rigidsym.precise._motion import PreciseMotion
from rigidsym.precise._regime import MotionInputs
from rigidsym.precise._sensitivity.box import MARGIN, STILL, Box, Slab
from rigidsym.precise._sensitivity.columns import (
    INPUTS,
    NAMES,
    NUMBERS,
    STAYS,
    Named,
    Point,
    listed,
)
from rigidsym.precise._sensitivity.mean_value import ONE, MeanValue
from rigidsym.precise._sensitivity.sloped import Sloped, power
from rigidsym.solution._formulas import AXES, sequence

# Precisions are multiples of this, so that few are kept; bits beyond those of the inputs' radii.
STEP, GUARD_BITS = 64, 128
# The most parts that are enclosed, and the most directions that one part is cut across.
MOST_PARTS, MOST_SLABS = 32, 3
# After so many parts components that no part has enclosed are given up.
GIVE_UP = 20
# Aim at this change of the phases in a part, rad, and at no more pieces at once.
CHANGE, MOST_PIECES = 0.2, 20
# A part whose phases change by more is given up, as its pieces would be.
LOST = 6
# Stop where the balls reach beyond the first order by less than this part of its range.
NEARLY = 0.1
# Components that change by less than this part of the widest one need no parts of their own.
SMALL = 1e-3
_TINY, _HUGE = 1e-300, 1e100


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a box and the enclosure of its states.

    slabs: the slabs that cut the part out of the box.
    state: balls of the attitude and the rates (7).
    first: ends (7, 2) of the first order; (inf, -inf) where there is no enclosure.
    bends: change of phases (6, s + n) by the sides of the box, rad, as `MeanValue.bends` has it.
    reach: radii of these sides (s + n).
    ends: ends (n, 2) of the inputs, less the middles of the whole box.
    """

    slabs: tuple[Slab, ...]
    state: Sequence[arb]
    first: np.ndarray
    bends: np.ndarray
    reach: np.ndarray
    ends: np.ndarray

    @np.errstate(all="ignore")
    def pieces(self) -> list[tuple[Slab, ...]]:
        """Return the smaller pieces into which to cut the part, each as the slabs that bound it.

        There are none where cutting is no use.
        """
        count, radii = len(self.slabs), (self.ends[:, 1] - self.ends[:, 0]) / 2
        if not np.isfinite(radii).all():
            return []
        bends = np.clip(np.nan_to_num(self.bends), -_HUGE, _HUGE)
        if np.linalg.norm(bends[:-1] * self.reach, axis=0).max() > LOST:
            return []
        gains = np.linalg.norm(bends[:, :count], axis=0) * self.reach[:count]
        best = int(np.argmax(gains)) if count else -1
        if count < min(MOST_SLABS, len(radii)) and radii.min() > _TINY:
            found = np.linalg.svd(bends[:, count:] * radii)
            direction = found.Vh[0] / radii
            terms = np.sort(self.ends * direction[:, None], axis=1)
            # Above the rounding errors of the sums, so that the pieces cover the part.
            room = MARGIN * (1 + np.abs(terms).sum())
            low, high = (terms.sum(axis=0) + (-room, room)).tolist()
            gain = float(found.S[0]) * (high - low) / 2
            if not count or gain > gains[best]:
                whole = Slab(tuple(direction.tolist()), low, high)
                return [(*self.slabs, piece) for piece in _sliced(whole, gain)]
        if not count:
            return []
        before, after = self.slabs[:best], self.slabs[best + 1 :]
        pieces = _sliced(self.slabs[best], float(gains[best]))
        return [(*before, piece, *after) for piece in pieces]


def parts_of(enclose: Callable[[tuple[Slab, ...]], Part | None], least: float) -> list[Part]:
    """Cut a box into parts that are narrow enough for sharp enclosures.

    enclose: returns the part that some slabs cut out, and None for an empty one. least: a range
    that needs no parts.
    """
    parts, seen = [part for part in [enclose(())] if part], 1
    while seen < MOST_PARTS:
        worst = _worst(parts, least, seen > GIVE_UP)
        pieces = [] if worst is None else parts[worst].pieces()
        if worst is None or not pieces:
            break
        del parts[worst]
        parts += [part for part in map(enclose, pieces) if part]
        seen += len(pieces)
    return parts


@np.errstate(all="ignore")
def _worst(parts: Sequence[Part], least: float, gives_up: bool) -> int | None:
    """Return the index of the part whose enclosure exceeds its first-order range most.

    Return None if no part exceeds it.
    """
    first = np.array([part.first for part in parts])
    ends = np.array([[[float(x.lower()), float(x.upper())] for x in p.state] for p in parts])
    low, high = first[:, :, 0].min(axis=0), first[:, :, 1].max(axis=0)
    known = np.isfinite(low)
    size = np.where(known, high - low, 0)
    for part in (slice(4), slice(4, None)):
        size[part] = np.maximum(size[part], max(SMALL * size[part].max(), least))
    beyond = np.maximum(low - ends[:, :, 0], ends[:, :, 1] - high) / size
    beyond[:, ~known] = 0 if gives_up else np.inf
    worst = int(np.argmax(beyond.max(axis=1)))
    return worst if beyond[worst].max() > NEARLY else None


def _sliced(slab: Slab, gain: float) -> list[Slab]:
    count = ceil(min(max(gain / CHANGE, 2), MOST_PIECES))
    ends = np.linspace(slab.low, slab.high, count + 1).tolist()
    return [Slab(slab.direction, *pair) for pair in pairwise(ends)]


@dataclass(frozen=True)
class MeanStates(MotionInputs):
    """Enclosures of all motions of a box of inputs, by the mean value theorem.

    bits: a precision that fits the radii of the inputs.
    """

    bits: int

    def state(self, time: Fraction, check: Callable[[], None]) -> tuple[State, bool]:
        """Return attitude and rates at a time as balls that enclose all motions.

        Whether every part of the box has an enclosure is returned as well.

        Balls of a part without one are [-1, 1], and rates keep to energy and momentum.  `check` is
        called before each part and at the end; an exception that it raises ends the work.
        """
        rounding = max(2.0**-self.bits, _TINY)
        parts = parts_of(partial(self._part, time, check), rounding)
        check()
        with working(self._bits(time)):
            known = [reduce(arb.union, x) for x in zip(*(p.state for p in parts), strict=True)]
        return (known[:4], known[4:]), all(np.isfinite(part.first).all() for part in parts)

    def _part(
        self, time: Fraction, check: Callable[[], None], slabs: tuple[Slab, ...]
    ) -> Part | None:
        """Enclose the states of the part of the box that lies within all given slabs.

        Return None for an empty part.
        """
        check()
        bits = self._bits(time)
        with working(bits):
            box = Box(self.inertia, self.omega0, slabs) if slabs else self._box(bits)
            if box.limits is None:
                return None
            mean = self._mean(box, time, bits)
            turn, rates = mean.state()
            found = [*(self._turned(turn) if turn else [None] * 4), *(rates or [None] * 3)]
            ends = [_ends(box, x, limit) for x, limit in zip(found, self._limits, strict=True)]
            return Part(
                slabs,
                [x for x, _ in ends],
                np.array([first for _, first in ends]),
                mean.bends(),
                np.array([float(x.rad()) for x in box.sides.entries()]),
                box.limits * box.radii[:, None],
            )

    @cached_property
    def _limits(self) -> list[arb]:
        """Bounds of attitude and rates (7) at all times."""
        factors = [euler_factor(self.inertia, k) for k in range(3)]
        moments, rates = list(map(ball, self.inertia)), list(map(ball, self.omega0))
        return [*[ONE] * 4, *rate_bounds(moments, factors, rates)]

    def sensitivities(self, time: Fraction) -> list[arb] | None:
        """Return enclosures of the sensitivities of all motions of the box.

        They are the numbers of `listed`, or None if there is no enclosure.
        """
        bits = self._bits(time)
        if not any(self.omega0):
            with working(bits):
                return Point(*self._box(bits).middles, STILL).at(time, self._attitude)
        with working(bits):
            box = self._box(bits)
            mean = self._mean(box, time, bits)
            if mean.columns is None or mean.turned is None:
                return None
            seen = box.whole.turned(mean.t, mean.columns.rates, mean.turned[0])
            known = {**mean.columns.rates, **seen}
            values = {name: known[name] for name in NAMES if name not in STAYS}
            found = {k: x.whole if isinstance(x, Sloped) else ball(x) for k, x in values.items()}
            # Small turns in space, from those in the axes of the body at t = 0.
            rotation = box.point.rotation(self._attitude)
            for y in (*INPUTS, "t"):
                turn = [found[f"eta{k}_by_{y}"] for k in NUMBERS]
                for i in NUMBERS:
                    row = [rotation[f"R{i}{k}"] for k in NUMBERS]
                    products = (r * x for r, x in zip(row, turn, strict=True))
                    found[f"eta{i}_by_{y}"] = sum(products, arb(0))
            numbers = listed(found)
            return numbers if all(x.is_finite() for x in numbers) else None

    @property
    def reason(self) -> str:
        """The reason why there is no enclosure, as text."""
        if self.holds_rest:
            return "the box holds a body at rest, whose momentum has no direction"
        return TOO_UNCERTAIN

    @property
    def holds_rest(self) -> bool:
        """True if the box may contain a body at rest."""
        return all(ball(w).contains(0) for w in self.omega0)

    @property
    def _attitude(self) -> list[arb]:
        return unit(list(map(ball, self.attitude0)))

    def _mean(self, box: Box, time: Fraction, bits: int) -> MeanValue:
        """Return the mean value form of a part of the box at a time."""
        identity = tuple(map(Fraction, (1, 0, 0, 0)))
        inertia, omega0 = map(tuple, box.middles)
        digits = int(bits / BITS_PER_DIGIT)
        precision = AdaptivePrecision(digits, is_within, None)
        turn, omega = PreciseMotion(inertia, omega0, identity).read(precision, time)
        return MeanValue(box, ball(time), turn, omega)

    def _bits(self, time: Fraction) -> int:
        """Return the working precision, in bits, that the states at a time need.

        Sensitivities need twice the bits of the angle more.
        """
        rate = max(abs(middle(w)) for w in self.omega0)
        more = int(abs(time) * rate).bit_length()
        return -(-(self.bits + GUARD_BITS + 2 * more) // STEP) * STEP

    def _box(self, bits: int) -> Box:
        """Return the whole box, cached for each precision."""
        return self._kept.setdefault(bits, Box(self.inertia, self.omega0))

    @cached_property
    def _kept(self) -> dict[int, Box]:
        return {}

    def _turned(self, turn: Sequence[Sloped]) -> list[Sloped]:
        """Return the attitudes after a turn since t = 0, as functions on the box of all inputs."""
        open_ = [k for k, x in enumerate(self.attitude0) if radius(x)]
        body = turn[0].box.entries()
        spread = [ball(radius(self.attitude0[k])).upper() for k in open_]
        box = arb_mat([[x] for x in [*body, *(arb(0, r) for r in spread)]])
        given = [
            Sloped(
                ball(middle(x)),
                arb_mat([[0] * len(body) + [int(j == k) for j in open_]]),
                ball(x),
                box,
            )
            for k, x in enumerate(self.attitude0)
        ]
        length = sum((x.square() for x in given[1:]), given[0].square()).sqrt()
        known: Named = {"epsilon": 1}
        for name, x, y in zip(("0", *AXES), given, turn, strict=True):
            slopes = arb_mat([[*y.slopes.entries(), *[0] * len(open_)]])
            p = x / length
            known[f"p_{name}"] = Sloped.of(p.middle, p.slopes, p.whole.intersection(ONE), box)
            known[f"qbar_{name}"] = Sloped(y.middle, slopes, y.whole, box)
        found = sequence("turned").evaluate(known, {"power": power})
        return [found[f"q_{name}"] for name in ("0", *AXES)]


def _ends(box: Box, value: Sloped | None, limit: arb) -> tuple[arb, tuple[float, float]]:
    """Return the range of a number over a box, and both ends of its first-order range."""
    if value is None or not all(x.is_finite() for x in (value.whole, *value.slopes.entries())):
        return limit, (inf, -inf)
    slopes, count = value.slopes.entries(), box.sides.nrows()
    others = value.box.entries()[count:]

    def reached(rows: Sequence[arb]) -> arb:
        rest = sum((x * y for x, y in zip(rows[count:], others, strict=True)), arb(0))
        return value.middle + box.reach(rows[:count]) + rest

    first = reached([x.mid() for x in slopes])
    known = intersection(intersection(reached(slopes), value.whole), limit)
    return known, (float(first.lower()), float(first.upper()))
