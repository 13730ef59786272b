"""States, and sensitivities, of all motions of a box by the mean value form, attitude and all."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial, reduce
from math import inf

import numpy as np
from flint import arb, arb_mat

from rigidsym.inputs import Number, middle, radius
from rigidsym.precise import balls
from rigidsym.precise.adaptive import SAYS_NOTHING, AdaptivePrecision
from rigidsym.precise.balls import BITS_PER_DIGIT, ball, difference, is_within, meeting, working
from rigidsym.precise.evaluation import State
from rigidsym.precise.motion import PreciseMotion
from rigidsym.precise.sensitivity.box import STILL, Box, Slab
from rigidsym.precise.sensitivity.columns import INPUTS, NUMBERS, Columns, Named
from rigidsym.precise.sensitivity.mean_value import ONE, MeanValue
from rigidsym.precise.sensitivity.parts import Part, parts_of
from rigidsym.precise.sensitivity.point import NAMES, STAYS, Point, listed
from rigidsym.precise.sensitivity.sloped import Sloped, power
from rigidsym.precise.shells import shells
from rigidsym.solution.formulas import AXES, sequence

# Precisions are multiples of this, so that few are kept; bits beyond those of the inputs' radii.
STEP, GUARD_BITS = 64, 128
_TINY = 1e-300


@dataclass(frozen=True)
class MeanStates:
    """Motions: inertia (3), body rates (3), attitude (4), some of these numbers uncertain; `bits`
    hold what their radii merit."""

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    attitude0: tuple[Number, ...]
    bits: int

    def state(self, time: Fraction, check: Callable[[], None]) -> tuple[State, bool]:
        """Return (q, omega) as balls, and whether every part of the box has an enclosure.

        Balls of a part without one are [-1, 1], and rates keep to energy and momentum.  `check` is
        called before each part and at the end; what it raises ends the work.
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
        """Enclose the states of what some slabs leave of the box; None for nothing."""
        check()
        bits = self._bits(time)
        with working(bits):
            mean = MeanValue(Box(self.inertia, self.omega0, slabs)) if slabs else self._at(bits)
            if mean.box.limits is None:
                return None
            t = ball(time)
            amid = mean.amid(t, *self._middle_state(mean.box, time, bits))
            turn, rates = mean.state(t, amid)
            found = [*(self._turned(turn) if turn else [None] * 4), *(rates or [None] * 3)]
            pairs = zip(found, self._limits, strict=True)
            ends = [_ends(mean.box, x, limit) for x, limit in pairs]
            return Part(
                slabs,
                [x for x, _ in ends],
                np.array([first for _, first in ends]),
                mean.bends(t, amid),
                np.array([float(x.rad()) for x in mean.box.sides.entries()]),
                mean.box.limits * mean.box.radii[:, None],
            )

    @cached_property
    def _limits(self) -> list[arb]:
        """What no state of the box leaves (7)."""
        factors = [
            difference(self.inertia[k - 2], self.inertia[k - 1]) / ball(self.inertia[k])
            for k in range(3)
        ]
        moments, rates = list(map(ball, self.inertia)), list(map(ball, self.omega0))
        return [*[ONE] * 4, *shells(moments, factors, rates)]

    def sensitivities(self, time: Fraction) -> list[arb] | None:
        """What `point.listed` lists, of all motions of the box; None where nothing is found."""
        bits = self._bits(time)
        if not any(self.omega0):
            with working(bits):
                return Point(*self._at(bits).box.middles, STILL).at(time, self._attitude())
        with working(bits):
            mean, t = self._at(bits), ball(time)
            moving = mean.moving(t, mean.amid(t, *self._middle_state(mean.box, time, bits)))
            if moving is None or moving.turn is None:
                return None
            seen = mean.box.whole.turned(t, moving.rates, moving.turn)
            known = {**moving.rates, **seen}
            found = {name: _ball(known[name]) for name in NAMES if name not in STAYS}
            numbers = listed(self._in_space(mean.box.point, found))
            return numbers if all(x.is_finite() for x in numbers) else None

    @property
    def reason(self) -> str:
        """Why nothing is found."""
        if self.holds_rest:
            return "the box holds a body at rest, whose momentum has no direction"
        return SAYS_NOTHING

    @property
    def holds_rest(self) -> bool:
        """Whether a body of the box may be at rest."""
        return all(ball(w).contains(0) for w in self.omega0)

    def _attitude(self) -> list[arb]:
        """At t = 0, of length one."""
        given = list(map(ball, self.attitude0))
        length = sum((balls.power(x, 2) for x in given), arb(0)).sqrt()
        return [(x / length).intersection(ONE) for x in given]

    def _in_space(self, columns: Columns, found: Named) -> Named:
        """Small turns seen from where the body was at t = 0, by the attitude that it had."""
        rotation = columns.rotation(self._attitude())
        turned = {
            f"eta{i}_by_{y}": sum(
                (rotation[f"R{i}{k}"] * found[f"eta{k}_by_{y}"] for k in NUMBERS), arb(0)
            )
            for i in NUMBERS
            for y in (*INPUTS, "t")
        }
        return {**found, **turned}

    def _middle_state(self, box: Box, time: Fraction, bits: int) -> State:
        """The turn since t = 0, and the rates, of the middle."""
        identity = tuple(map(Fraction, (1, 0, 0, 0)))
        inertia, omega0 = map(tuple, box.middles)
        middles = PreciseMotion(inertia, omega0, identity)
        digits = int(bits / BITS_PER_DIGIT)
        return middles.read(AdaptivePrecision(digits, is_within, None), time)

    def _bits(self, time: Fraction) -> int:
        """As many more as the angle has, twice over: sensitivities grow with it."""
        rate = max(abs(middle(w)) for w in self.omega0)
        more = int(abs(time) * rate).bit_length()
        return -(-(self.bits + GUARD_BITS + 2 * more) // STEP) * STEP

    def _at(self, bits: int) -> MeanValue:
        if bits not in self._kept:
            self._kept[bits] = MeanValue(Box(self.inertia, self.omega0))
        return self._kept[bits]

    @cached_property
    def _kept(self) -> dict[int, MeanValue]:
        return {}

    def _turned(self, turn: Sequence[Sloped]) -> list[Sloped]:
        """The attitude at t = 0, a unit quaternion, times a turn: over one box of all inputs."""
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
            unit = x / length
            known[f"p_{name}"] = Sloped.of(
                unit.middle, unit.slopes, unit.whole.intersection(ONE), box
            )
            known[f"qbar_{name}"] = Sloped(y.middle, slopes, y.whole, box)
        found = sequence("turned").evaluate(known, {"power": power})
        return [found[f"q_{name}"] for name in ("0", *AXES)]


def _ends(box: Box, value: Sloped | None, limit: arb) -> tuple[arb, tuple[float, float]]:
    """The ball of a number over a box, and both ends of what its first order gives."""
    if value is None or not all(x.is_finite() for x in (value.whole, *value.slopes.entries())):
        return limit, (inf, -inf)
    slopes, count = value.slopes.entries(), box.sides.nrows()
    others = value.box.entries()[count:]

    def reached(rows: Sequence[arb]) -> arb:
        rest = sum((x * y for x, y in zip(rows[count:], others, strict=True)), arb(0))
        return value.middle + box.reach(rows[:count]) + rest

    first = reached([x.mid() for x in slopes])
    known = meeting(meeting(reached(slopes), value.whole), limit)
    return known, (float(first.lower()), float(first.upper()))


def _ball(value: Sloped | arb | int) -> arb:
    return value.whole if isinstance(value, Sloped) else ball(value)
