"""States, and sensitivities, of all motions of a box by the mean value form, attitude and all."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from flint import arb, arb_mat

from rigidsym.inputs import Number, middle, radius
from rigidsym.precise.adaptive import AdaptivePrecision
from rigidsym.precise.balls import BITS_PER_DIGIT, ball, is_within, working
from rigidsym.precise.evaluation import State
from rigidsym.precise.motion import PreciseMotion
from rigidsym.precise.sensitivity.box import Box
from rigidsym.precise.sensitivity.columns import Named
from rigidsym.precise.sensitivity.mean_value import ONE, MeanValue
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

    def _middle_state(self, time: Fraction, bits: int) -> State:
        """The turn since t = 0, and the rates, of the middle."""
        digits = int(bits / BITS_PER_DIGIT)
        return self._middle.read(AdaptivePrecision(digits, is_within, None), time)

    @cached_property
    def _middle(self) -> PreciseMotion:
        moments, rates = (tuple(map(middle, values)) for values in (self.inertia, self.omega0))
        return PreciseMotion(moments, rates, tuple(map(Fraction, (1, 0, 0, 0))))

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
