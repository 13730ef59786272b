"""Uncertain inputs by the mean value theorem: every motion is held, and hardly more."""

from fractions import Fraction
from random import Random

import pytest
from boxes import (
    ATTITUDE,
    BODY,
    PAPER,
    contain,
    distance,
    holds,
    numbers,
    overlap,
    point_of,
    spread,
    widest,
)
from flint import arb

from rigidsym import TorqueFreeMotion
from rigidsym._inputs import middle, radius
from rigidsym.errors import InputError, PrecisionError
from rigidsym.precise._balls import ball, working

# Moments and rates, which are uncertain by a part of themselves.
MOTIONS = {
    "paper": PAPER,
    "larger axis": (BODY, ("0.05", "0.03", "-0.2")),
    "symmetric": (("2", "2", "3"), ("0.5", "-0.2", "0.7")),
    "sphere, of exact moments": (("2", "2", "2"), ("0.3", "0.4", "-0.1")),
    "sphere": (("2", "2", "2"), ("0.3", "0.4", "-0.1")),
    "spin": (BODY, ("0.4", "0", "0")),
    "near the separatrix": (("4", "5", "9"), ("3.001", "1", "1")),
    "across the separatrix": (("4", "5", "9"), ("3", "1", "1")),
    "axes not in order": (("0.853", "0.532", "0.611"), ("-0.23", "0.6", "0.8")),
}


def boxed(kind, part, attitude=0):
    inertia, omega = MOTIONS[kind]
    parts = (inertia, 0 if "exact" in kind else part), (omega, part), (ATTITUDE, attitude)
    given = ([spread(x, abs(Fraction(x)) * p) for x in values] for values, p in parts)
    return TorqueFreeMotion(*given, allow_nonphysical=True)


def effect(motion, time, corners=16):
    """Return the sizes of a box, and their differences from its sensitivities times its radii.

    Sizes are the largest distances of corners from the middle, in attitude and rates.
    """
    random = Random(1)
    center = point_of(motion, lambda: 0)
    q, omega, S = center.enclose(time, 30, sensitivity=True)
    shifts = [[random.choice((-1, 1)) for _ in range(6)] for _ in range(corners)]
    given = (*motion.omega0, *motion.inertia)
    sizes, curved = [0.0, 0.0], [0.0, 0.0]
    for signs in shifts:
        steps = [s * radius(x) for s, x in zip(signs, given, strict=True)]
        moved = [middle(x) + d for x, d in zip(given, steps, strict=True)]
        other = TorqueFreeMotion(moved[3:], moved[:3], center.attitude0, allow_nonphysical=True)
        far = other.enclose(time, 30)
        with working(120):
            column = [ball(x) for x in steps]
            turn, rates = (
                [sum(x * y for x, y in zip(row[3:], column, strict=True)) for row in part]
                for part in (S.attitude, S.rates)
            )
            by_turn = _half([arb(0), *turn], q)
            for k, (there, here, by) in enumerate(((far[0], q, by_turn), (far[1], omega, rates))):
                gaps = [x - y for x, y in zip(there, here, strict=True)]
                sizes[k] = max(sizes[k], float(distance(there, here)))
                curved[k] = max(curved[k], float(distance(gaps, by)))
    return sizes, curved


def _half(p, q):
    """Return half the product of two quaternions."""
    vector = [p[0] * q[k] + q[0] * p[k] + p[1 + k % 3] * q[1 + (k + 1) % 3]
              - p[1 + (k + 1) % 3] * q[1 + k % 3] for k in (1, 2, 3)]  # fmt: skip
    return [x / 2 for x in (p[0] * q[0] - sum(p[k] * q[k] for k in (1, 2, 3)), *vector)]


WIDE, NARROW = Fraction(1, 1000), Fraction(1, 10**6)


@pytest.mark.parametrize("kind", MOTIONS)
def test_balls_are_hardly_wider_than_what_inputs_leave_open(kind):
    """Radii are at most twice the size of a box whose first order is right to a twentieth."""
    seen = 0
    for part, time in ((WIDE, 1), (WIDE, -30), (WIDE, 300), (NARROW, 1000), (NARROW, -30_000)):
        motion = boxed(kind, part)
        sizes, curved = effect(motion, time)
        if all(bend < size / 20 for size, bend in zip(sizes, curved, strict=True)):
            found = numbers(motion.enclose(time, 15, method="mean"))
            for size, balls in zip(sizes, (found[:4], found[4:]), strict=True):
                assert widest(balls) < 2 * size, (part, time)
            seen += 1
    assert seen


def by_mean_holds(motion, time, random, count):
    """Return True if balls by the mean value theorem hold sampled motions, or there are none."""
    try:
        found = numbers(motion.enclose(time, 15, method="mean"))
    except PrecisionError:
        return True
    return holds(found, motion, time, count, random)


@pytest.mark.parametrize("kind", MOTIONS)
def test_every_motion_of_a_box_is_held(kind):
    random = Random(3)
    for part in (Fraction(1, 20), Fraction(1, 1000), Fraction(1, 10**7)):
        motion = boxed(kind, part, attitude=part)
        for time in ("0.7", -20, 500, "1e5"):
            assert by_mean_holds(motion, time, random, 4), (part, time)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_thousands_of_boxes_hold_their_motions(seed):
    """The boxes have all widths and regimes, and some exact numbers."""
    random = Random(seed)
    for _ in range(300):
        part = Fraction(10 ** random.uniform(-9, -1))

        def number(low, high, part=part):
            value = Fraction(
                random.choice((1, random.uniform(low, high), random.uniform(low, high)))
            )
            if low < 0 and random.random() < 0.2:
                value = Fraction(0)
            return spread(value, part * Fraction(random.choice((0, 1, random.random()))))

        inertia, omega = ([number(*x) for _ in range(3)] for x in ((0.3, 1), (-1, 1)))
        attitude = [number(-1, 1) for _ in range(3)]
        motion = TorqueFreeMotion(inertia, omega, (1, *attitude), allow_nonphysical=True)
        time = Fraction(random.choice((-1, 1)) * 10 ** random.uniform(-1, 4))
        assert by_mean_holds(motion, time, random, 3), (motion, time)


def test_the_meeting_is_never_wider_than_its_parts():
    motion = boxed("paper", Fraction(1, 1000))
    for time in (3, -150):
        best = numbers(motion.enclose(time, 15))
        for method in ("carlson", "flow", "mean"):
            other = numbers(motion.enclose(time, 15, method=method))
            assert overlap(best, other)
            assert all(x.rad() <= 1.02 * y.rad() for x, y in zip(best, other, strict=True))


def test_one_number_of_the_paper_is_as_certain_as_it_is():
    """An error of 1e-6 of a moment makes 1.4e-8 after a second, and 6e-4 by formulas alone."""
    motion = TorqueFreeMotion(("0.0109 +/- 1e-6", *BODY[1:]), PAPER[1])
    assert widest(motion.enclose(1, 15)[0]) < 1.5e-8
    assert widest(motion.enclose(1, 15, method="carlson")[0]) > 5e-4


def test_attitudes_of_late_times_are_certain_where_a_spin_is_tilted():
    motion = TorqueFreeMotion(BODY, ("0 +/- 1e-9", 0, "0.5"), ATTITUDE)
    found = numbers(motion.enclose("1e12", 15))
    assert widest(found) < 1e-6
    assert holds(found, motion, "1e12", 6, Random(4))


def derivatives(motion, times, digits):
    """Return all numbers of the sensitivities at some times."""
    S = motion.enclose(times, digits, sensitivity=True)[2]
    return [x for part in (S.attitude, S.rates, S.attitude_t, S.rates_t) for x in part.flat]


@pytest.mark.parametrize("kind", ["paper", "symmetric", "sphere, of exact moments", "sphere"])
def test_sensitivities_of_a_box_hold_those_of_its_motions(kind):
    random, motion = Random(6), boxed(kind, Fraction(1, 10**5), attitude=Fraction(1, 10**4))
    found = derivatives(motion, [3, -200], 15)
    for _ in range(4):
        point = point_of(motion, lambda: random.uniform(-1, 1))
        assert contain(found, derivatives(point, [3, -200], 30))


def test_a_box_of_bodies_at_rest_has_what_each_of_them_has():
    rest = TorqueFreeMotion(("1 +/- 0.1", 2, 3), (0, 0, 0), ("1 +/- 1e-3", 2, 3, 4))
    exact = TorqueFreeMotion((1, 2, 3), (0, 0, 0), (1, 2, 3, 4))
    found, expected = (derivatives(motion, 5, 15) for motion in (rest, exact))
    assert overlap(found, expected)
    assert widest(found) < 0.01


def test_a_box_with_a_body_at_rest_has_no_sensitivities():
    motion = TorqueFreeMotion((1, 2, "2.5"), ("0 +/- 1e-3", 0, 0))
    reason = "holds a body at rest, whose momentum has no direc"
    for arguments in ({"sensitivity": True}, {"method": "mean"}):
        with pytest.raises(PrecisionError, match=f"t = 1: the box {reason}"):
            motion.enclose(1, 15, **arguments)
    motion.enclose(1, 15)


@pytest.mark.parametrize("last", ["2.0005", "2.0005 +/- 1e-3"])
def test_boxes_of_nearly_equal_moments_have_sensitivities(last):
    TorqueFreeMotion(("2 +/- 1e-3", 2, last), (1, 2, 3)).enclose(1, 15, sensitivity=True)


def test_what_cannot_be_said_is_refused():
    wide, exact = (
        TorqueFreeMotion((4, 5, 9), (3, 1, "1 +/- 1e-2")),
        TorqueFreeMotion(BODY, (1, 2, 3)),
    )
    for arguments in ({"method": "mean"}, {"sensitivity": True}):
        with pytest.raises(PrecisionError, match="t = 300: the inputs are too uncertain"):
            wide.enclose(300, 15, **arguments)
    for ask, message in (
        (lambda: exact.enclose(1, method="mean"), "method = mean: is for uncertain inputs"),
        (lambda: wide.precise(1, sensitivity=True), r"omega0\[2\] = .*is uncertain"),
        (lambda: exact.enclose(1, sensitivity=1), "sensitivity = 1: must be true or false"),
        *((lambda x=x: exact.precise(1, method=x, sensitivity=True),
           f"method = '{x}': has no error bounds") for x in ("mpmath", "theorem1")),
    ):  # fmt: skip
        with pytest.raises(InputError, match=message):
            ask()
