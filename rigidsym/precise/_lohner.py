"""Enclosures of all motions that start in a box of inputs, by Lohner's method.

The enclosures hold in all regimes: across the separatrix, about spins, about symmetric bodies.  At
late times, when nothing else is certain, the rates keep to the bounds by energy and momentum.

A set is  middle + spread r + frame e:  r is the box of uncertain inputs about their middles, the
same at all times; e holds all errors of rounding, truncation and curvature, in a frame that is
made orthogonal again at every step (Lohner, in: Computational Ordinary Differential Equations,
1992; Nedialkov, Jackson, Corliss, Applied Mathematics and Computation 105, 1999).  Each step is the
mean value theorem: with J the derivatives over the whole set, k the factors of Euler's equations,

    flow(y, k) lies in flow(middle, middle of k) + J_y (y - middle) + J_k (k - middle of k),

along the straight line in states and moments from the middle to a motion of the box: its points
start in the box around the set and the middle, with moments of the box, where the series hold.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil

from flint import arb, arb_mat

from rigidsym._inputs import middle, radius
from rigidsym.precise._balls import ball, bits_of, dyadic, unit, working
from rigidsym.precise._evaluation import State
from rigidsym.precise._flow import (
    RATES,
    SIZE,
    Flow,
    euler_factor,
    max_of,
    multiplied,
    norm,
    rate_bounds,
)
from rigidsym.precise._regime import MotionInputs

MOST_STEPS = 2000
# Rates and turns are of size 1: a set as wide as this is useless.
LOST = 1
# Bits beyond those of the finest radius; terms of the series for each bit, for the least work.
GUARD_BITS, TERMS_PER_BIT = 32, 0.4
# Room for the rounding of middles beyond their bounds; the length of a quaternion in a box.
ROUNDING, WIDEST_TURN = 2.0**-20, 3


@dataclass(frozen=True, slots=True)
class Bodies:
    """The set of all bodies and initial rates in a box, with its flow.

    They are deviations r (6) from the middle of the box.

    flow: the flow of all of them. middle: the factors (3) of the middle. box (6, 1): the ranges of
    the deviations. by_box: the derivatives (3, 6) of the factors by r. limits: bounds of the rates
    (3) at all times.
    """

    flow: Flow
    middle: Sequence[arb]
    box: arb_mat
    by_box: arb_mat
    limits: Sequence[arb]


@dataclass(frozen=True, slots=True)
class Cloud:
    """The set of all states of a box's motions after some time.

    A state (7, 1) has the rates and the turn since t = 0.
    """

    middle: arb_mat
    spread: arb_mat
    frame: arb_mat
    rest: arb_mat

    def deviation(self, bodies: Bodies) -> arb_mat:
        """Return the ranges of the states' deviations from the middle."""
        return self.spread * bodies.box + self.frame * self.rest

    def seen_by(self, turn: arb_mat) -> "Cloud":
        """Return the image of the set under a matrix (7, 7)."""
        return Cloud(turn * self.middle, turn * self.spread, turn * self.frame, self.rest)

    def states(self, bodies: Bodies) -> arb_mat:
        """Return a box that contains all states of the set.

        It keeps to the bounds of rates and of unit quaternions.
        """
        around = (self.middle + self.deviation(bodies)).entries()
        limits = [*bodies.limits, *[arb(0, 1)] * 4]
        return arb_mat(SIZE, 1, [x.intersection(y) for x, y in zip(around, limits, strict=True)])

    def moved(self, bodies: Bodies, step: arb) -> "Cloud":
        """Return the set of states after a time step."""
        middle = bodies.flow.moved(bodies.middle, self.middle, step)
        held = zip(self.states(bodies).entries(), self.middle.entries(), strict=True)
        whole = arb_mat(SIZE, 1, [x.union(y) for x, y in held])
        rows = bodies.flow.derivative(whole, step).tolist()
        by_state = arb_mat([row[:SIZE] for row in rows])
        by_factors = arb_mat([row[SIZE:] for row in rows])
        spread = by_state * self.spread + by_factors * bodies.by_box
        carried = by_state * self.frame
        frame = _orthogonal(carried.mid(), self.rest)
        back = frame.inv()
        lost = (spread - spread.mid()) * bodies.box + (middle - middle.mid())
        rest = (back * carried) * self.rest + back * lost
        return Cloud(middle.mid(), spread.mid(), frame, rest)


def _orthogonal(columns: arb_mat, rest: arb_mat) -> arb_mat:
    """Orthogonalise the columns of a matrix (7, 7) approximately by Gram-Schmidt.

    The column of the longest edge is first.

    Any frame with an inverse would do.
    """
    radii = [x.abs_upper() for x in rest.entries()]
    sides = zip(columns.transpose().tolist(), radii, strict=True)
    edges = [[x * r for x in column] for column, r in sides]
    order = sorted(range(SIZE), key=lambda j: -float(_dot(edges[j], edges[j]).mid()))
    found: list[list[arb]] = []
    for j in order:
        column = [row[j] for row in columns.tolist()]
        for other in found * 2:  # twice is enough (Kahan and Parlett)
            share = _dot(column, other)
            column = [(x - share * y).mid() for x, y in zip(column, other, strict=True)]
        length = _dot(column, column).sqrt()
        found.append([(x / length).mid() for x in column])
    return arb_mat(found).transpose()


def _dot(x: Sequence[arb], y: Sequence[arb]) -> arb:
    return sum((a * b for a, b in zip(x, y, strict=True)), arb(0)).mid()


class FlowEnclosure:
    """Enclosures of all motions that start in a box of inputs, by Taylor series of the flow.

    The precision fits the radii of the inputs.

    `check` is called during the preparation, as that of `state` is during a step.  Steps are
    counted from t = 0, so that the enclosure at a time does not depend on other times.
    """

    def __init__(self, given: MotionInputs, bits: int, check: Callable[[], None]) -> None:
        self.bits, self._check = bits, check
        inertia, omega0 = given.inertia, given.omega0
        with working(self.bits):
            self.begin = unit(list(map(ball, given.attitude0))), list(map(ball, omega0))
            moments = list(map(ball, inertia))
            factors = [euler_factor(inertia, k) for k in range(RATES)]
            self.limits = rate_bounds(moments, factors, self.begin[1])
            self.scale = _scale(norm(self.limits))
            limits = [w / ball(self.scale) for w in self.limits]
            wider = [w.union(-w) + arb(0, ROUNDING) for w in limits]
            starts = arb_mat(SIZE, 1, [*wider, *[arb(0, 1 + ROUNDING)] * 4])
            reached = [*rate_bounds(moments, factors, wider), *[arb(0, WIDEST_TURN)] * 4]
            terms = ceil(self.bits * TERMS_PER_BIT)
            tube = arb_mat(SIZE, 1, reached)
            flow = Flow(factors, starts, tube, terms, lambda: self._check())
            self.step = dyadic(flow.step(self.bits).lower())
            # Rates are in units of the scale.
            radii = [radius(x) / self.scale for x in omega0] + [radius(c) for c in inertia]
            slopes = arb_mat(RATES, 2 * RATES)
            for k in range(RATES):
                c = ball(inertia[k])
                slopes[k, RATES + k] = -factors[k] / c
                slopes[k, RATES + (k + 1) % 3], slopes[k, RATES + (k + 2) % 3] = 1 / c, -1 / c
            middles = list(map(middle, inertia))
            box = arb_mat(2 * RATES, 1, [arb(0, ball(x).upper()) for x in radii])
            central = [euler_factor(middles, k) for k in range(RATES)]
            self.bodies = Bodies(flow, central, box, slopes, limits)
            # At t = 0: the rates of the middle and no turn, the rest in the box.
            begin = [*(ball(middle(x) / self.scale) for x in omega0), arb(1), *[arb(0)] * 3]
            center = arb_mat(SIZE, 1, begin)
            spread = [int(i == j < RATES) for i in range(SIZE) for j in range(2 * RATES)]
            spreads, unit_frame = arb_mat(SIZE, 2 * RATES, spread), arb_mat(SIZE, SIZE, 1)
            first = Cloud(center.mid(), spreads, unit_frame, center - center.mid())
        self._clouds: dict[int, list[Cloud]] = {side: [first] for side in (-1, 1)}

    def state(self, time: Fraction, check: Callable[[], None], most: int = MOST_STEPS) -> State:
        """Return attitude and rates at one time as balls that enclose all motions.

        At most `most` steps are made.

        An exception that `check` raises ends the work, at any time.
        """
        self._check = check
        check()
        if time == 0:
            return self.begin
        with working(self.bits):
            cloud = self._cloud(time * self.scale, most)
            if cloud is None:
                return [arb(0, 1)] * 4, self.limits
            y = cloud.seen_by(multiplied(self.begin[0])).states(self.bodies).entries()
            rates = zip(y[:RATES], self.limits, strict=True)
            return y[RATES:], [(w * ball(self.scale)).intersection(limit) for w, limit in rates]

    def _cloud(self, time: Fraction, most: int) -> Cloud | None:
        """Return the set of states at a time.

        Time is in units of the scale.  Return None where the set is too wide.
        """
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
        """Return the set of states after one step.

        Return None where it is too wide.
        """
        try:
            after = cloud.moved(self.bodies, ball(time))
        except ZeroDivisionError:  # its frame has collapsed
            return None
        widest = max_of(after.deviation(self.bodies).entries())
        return after if widest < LOST else None


def bits_for(given: MotionInputs, digits: int) -> int:
    """Return the precision in bits that resolves the smallest radius of the inputs.

    It is at most that of the digits, and some guard bits.
    """
    fineness = [0]
    for values in (given.inertia, given.omega0, given.attitude0):
        size = max(abs(middle(x)) + radius(x) for x in values)
        ratios = [radius(x) / size for x in values if radius(x)]
        fineness += [x.denominator.bit_length() - x.numerator.bit_length() for x in ratios]
    return GUARD_BITS + min(max(fineness), bits_of(digits))


def _scale(size: arb) -> Fraction:
    """Round a size up to a number with few bits.

    Return 1 for zero.
    """
    mantissa, exponent = map(int, size.upper().man_exp())
    more = max(mantissa.bit_length() - 8, 0)
    return (1 + (mantissa >> more)) * Fraction(2) ** (exponent + more) if mantissa else Fraction(1)
