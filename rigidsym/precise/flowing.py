"""Enclosures that know no regime: the equations of motion carried over the box of inputs.

They hold whatever the box is: across the separatrix, about spins, about symmetric bodies.  Of late
times, when nothing else is certain, they say what energy and momentum do: rates keep to shells.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import ceil

from flint import arb, arb_mat

from rigidsym.inputs import Number, middle, radius
from rigidsym.precise.balls import ball, bits_of, difference, dyadic, power, working
from rigidsym.precise.evaluation import State
from rigidsym.precise.flow import RATES, SIZE, Flow, max_of, multiplied, norm
from rigidsym.precise.lohner import Bodies, Cloud, start
from rigidsym.precise.shells import shells

MOST_STEPS = 2000
# Rates and turns are of size 1: a set as wide as this says nothing.
LOST = 1
# Beyond the bits of the finest radius; terms for each bit, for the least work.
GUARD_BITS, TERMS_PER_BIT = 32, 0.4
# What middles may miss of their bounds by rounding; the length of a quaternion in a box.
ROUNDING, WIDEST_TURN = 2.0**-20, 3


class Flowing:
    """States of all motions that start in a box, at a precision that its radii merit.

    `check` is what `state` has, too, for the work of getting ready.  Steps are counted from t = 0,
    so that what is said of a time does not hang on other times.
    """

    def __init__(
        self,
        inertia: Sequence[Number],
        omega0: Sequence[Number],
        attitude0: Sequence[Number],
        bits: int,
        check: Callable[[], None],
    ) -> None:
        self.bits, self._check = bits, check
        with working(self.bits):
            self.begin = _unit(list(map(ball, attitude0))), list(map(ball, omega0))
            moments, factors = list(map(ball, inertia)), [_factor(inertia, k) for k in range(RATES)]
            self.shells = shells(moments, factors, self.begin[1])
            self.scale = _scale(norm(self.shells))
            limits = [w / ball(self.scale) for w in self.shells]
            wider = [w.union(-w) + arb(0, ROUNDING) for w in limits]
            starts = arb_mat(SIZE, 1, [*wider, *[arb(0, 1 + ROUNDING)] * 4])
            reached = [*shells(moments, factors, wider), *[arb(0, WIDEST_TURN)] * 4]
            terms = ceil(self.bits * TERMS_PER_BIT)
            tube = arb_mat(SIZE, 1, reached)
            flow = Flow.within(factors, starts, tube, terms, lambda: self._check())
            self.bodies = _bodies(flow, inertia, omega0, limits, self.scale)
            self.step = dyadic(flow.step(self.bits).lower())
            first = start([ball(middle(x) / self.scale) for x in omega0])
        self._clouds: dict[int, list[Cloud]] = {side: [first] for side in (-1, 1)}

    def state(self, time: Fraction, check: Callable[[], None], most: int = MOST_STEPS) -> State:
        """(q, omega) as balls at one time, by so many steps at most; what `check` raises ends the
        work, any time."""
        self._check = check
        check()
        if time == 0:
            return self.begin
        with working(self.bits):
            cloud = self._cloud(time * self.scale, most)
            if cloud is None:
                return [arb(0, 1)] * 4, self.shells
            y = cloud.seen_by(multiplied(self.begin[0])).states(self.bodies).entries()
            rates = zip(y[:RATES], self.shells, strict=True)
            return y[RATES:], [(w * ball(self.scale)).intersection(limit) for w, limit in rates]

    def _cloud(self, time: Fraction, most: int) -> Cloud | None:
        """The set at a time, in units of the scale; None where it is lost."""
        side = 1 if time > 0 else -1
        whole = int(abs(time) / self.step)
        if whole > most:
            return None
        clouds = self._clouds[side]
        while len(clouds) <= whole:
            following = self._moved(clouds[-1], side * self.step)
            if following is None:
                return None
            clouds.append(following)
        return self._moved(clouds[whole], time - side * whole * self.step)

    def _moved(self, cloud: Cloud, time: Fraction) -> Cloud | None:
        """None where it says nothing any more."""
        try:
            after = cloud.moved(self.bodies, ball(time))
        except ZeroDivisionError:  # its frame has collapsed
            return None
        widest = max_of(after.apart(self.bodies).entries())
        return after if widest < LOST else None


def _bodies(
    flow: Flow,
    inertia: Sequence[Number],
    omega0: Sequence[Number],
    limits: Sequence[arb],
    scale: Fraction,
) -> Bodies:
    """The box, with rates in units of the scale."""
    radii = [radius(x) / scale for x in omega0] + [radius(c) for c in inertia]
    slopes = arb_mat(RATES, 2 * RATES)
    for k in range(RATES):
        c = ball(inertia[k])
        slopes[k, RATES + k] = -flow.factors[k] / c
        slopes[k, RATES + (k + 1) % 3], slopes[k, RATES + (k + 2) % 3] = 1 / c, -1 / c
    middles = list(map(middle, inertia))
    box = arb_mat(2 * RATES, 1, [arb(0, ball(x).upper()) for x in radii])
    return Bodies(flow, [_factor(middles, k) for k in range(RATES)], box, slopes, limits)


def bits_for(given: Sequence[Sequence[Number]], digits: int) -> int:
    """Bits that hold the finest radius, or the digits where it is finer still."""
    fineness = [0]
    for values in given:
        size = max(abs(middle(x)) + radius(x) for x in values)
        ratios = [radius(x) / size for x in values if radius(x)]
        fineness += [x.denominator.bit_length() - x.numerator.bit_length() for x in ratios]
    return GUARD_BITS + min(max(fineness), bits_of(digits))


def _factor(inertia: Sequence[Number], k: int) -> arb:
    """(c_i - c_j)/c_k of Euler's equations."""
    return difference(inertia[k - 2], inertia[k - 1]) / ball(inertia[k])


def _scale(size: arb) -> Fraction:
    """A short number not below a size, and hardly above; 1 for none."""
    mantissa, exponent = map(int, size.upper().man_exp())
    more = max(mantissa.bit_length() - 8, 0)
    return (1 + (mantissa >> more)) * Fraction(2) ** (exponent + more) if mantissa else Fraction(1)


def _unit(quaternion: Sequence[arb]) -> list[arb]:
    length = sum((power(x, 2) for x in quaternion), arb(0)).sqrt()
    return [(x / length).intersection(arb(0, 1)) for x in quaternion]
