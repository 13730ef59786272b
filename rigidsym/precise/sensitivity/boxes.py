"""States, and sensitivities, of all motions of a box by the mean value form, attitude and all."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations

from flint import arb, arb_mat

from rigidsym.inputs import Number, middle, radius
from rigidsym.precise import balls
from rigidsym.precise.adaptive import SAYS_NOTHING, AdaptivePrecision
from rigidsym.precise.balls import BITS_PER_DIGIT, ball, is_within, working
from rigidsym.precise.evaluation import State
from rigidsym.precise.motion import PreciseMotion
from rigidsym.precise.sensitivity.box import STILL, Box
from rigidsym.precise.sensitivity.columns import INPUTS, NUMBERS, Columns, Named
from rigidsym.precise.sensitivity.mean_value import ONE, MeanValue
from rigidsym.precise.sensitivity.point import NAMES, STAYS, Point, listed
from rigidsym.precise.sensitivity.sloped import Sloped, power
from rigidsym.solution.formulas import AXES, sequence

# Precisions are multiples of this, so that few are kept; bits beyond those of the inputs' radii.
STEP, GUARD_BITS = 64, 64
# Nothing is to be gained where a ball is at most so much wider than the values in it for sure.
NEARLY = arb("1.01")


@dataclass(frozen=True)
class MeanStates:
    """Motions: inertia (3), body rates (3), attitude (4), some of these numbers uncertain; `bits`
    hold what their radii merit."""

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    attitude0: tuple[Number, ...]
    bits: int

    def state(self, time: Fraction) -> tuple[State, bool] | None:
        """(q, omega) as balls, and whether they are hardly wider than they have to be.

        None where nothing is found.
        """
        bits = self._bits(time)
        turn, omega = self._middle_state(time, bits)
        with working(bits):
            found = self._at(bits).state(ball(time), turn, omega)
            if found is None:
                return None
            q, rates = self._turned(found[0]), found[1]
            known = [*q, *rates]
            if not all(x.whole.is_finite() for x in known):
                return None
            state = [x.whole.intersection(ONE) for x in q], [x.whole for x in rates]
            return state, all(map(self._is_narrow, known))

    def _is_narrow(self, value: Sloped) -> bool:
        rounding = arb(2) ** -self.bits
        return bool(value.whole.rad() <= NEARLY * value.least() + rounding)

    def sensitivities(self, time: Fraction) -> list[arb] | None:
        """What `point.listed` lists, of all motions of the box; None where nothing is found."""
        bits = self._bits(time)
        if not any(self.omega0):
            with working(bits):
                return Point(*self._middles, STILL).at(time, self._attitude())
        turn, _ = self._middle_state(time, bits)
        with working(bits):
            mean = self._at(bits)
            moving = mean.moving(ball(time), turn)
            if moving is None:
                return None
            seen = mean.box.whole.turned(ball(time), moving.rates, moving.turn)
            known = {**moving.rates, **seen}
            found = {name: _ball(known[name]) for name in NAMES if name not in STAYS}
            numbers = listed(self._in_space(mean.box.point, found))
            return numbers if all(x.is_finite() for x in numbers) else None

    @property
    def reason(self) -> str:
        """Why nothing is found."""
        if all(ball(w).contains(0) for w in self.omega0):
            return "the box holds a body at rest, whose momentum has no direction"
        moments = list(map(ball, self.inertia))
        if all(x.overlaps(y) for x, y in combinations(moments, 2)) and len({*self._middles[0]}) > 1:
            return "the box holds a sphere, and its middle is none"
        return SAYS_NOTHING

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

    def _middle_state(self, time: Fraction, bits: int) -> State:
        """The turn since t = 0, and the rates, of the middle."""
        digits = int(bits / BITS_PER_DIGIT)
        return self._middle.read(AdaptivePrecision(digits, is_within, None), time)

    @cached_property
    def _middle(self) -> PreciseMotion:
        return PreciseMotion(*self._middles, tuple(map(Fraction, (1, 0, 0, 0))))

    @property
    def _middles(self) -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]]:
        return tuple(map(middle, self.inertia)), tuple(map(middle, self.omega0))

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


def _ball(value: Sloped | arb | int) -> arb:
    return value.whole if isinstance(value, Sloped) else ball(value)
