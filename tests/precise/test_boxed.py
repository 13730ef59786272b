"""Boxes of uncertain inputs: the flow and the mean value theorem hold every motion, and tightly."""

from fractions import Fraction
from itertools import permutations
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
    points,
    sharp,
    spread,
    widest,
)
from flint import arb, arb_mat, ctx

from rigidsym import InputError, TorqueFreeMotion
from rigidsym._inputs import middle, radius
from rigidsym.errors import PrecisionError
from rigidsym.precise import _flow as flow
from rigidsym.precise import _lohner as lohner
from rigidsym.precise._balls import ball, working
from rigidsym.precise._flow import rate_bounds

# Boxes across regimes, or next to another one.
BOXES = {
    "tilted spin": (BODY, ("0 +/- 1e-9", 0, "0.5"), ATTITUDE),
    "tilted spin about the middle": (BODY, ("0 +/- 1e-9", "0.5", "1e-10 +/- 1e-9"), ATTITUDE),
    "nearly a sphere": (("1 +/- 1e-9", 1, 1), (1, "0.5", "0.3"), ATTITUDE),
    "nearly symmetric": (("1 +/- 1e-4", 1, "1.5"), (1, 2, 3), ATTITUDE),
    "across the separatrix": ((4, 5, 9), (3, 1, "1 +/- 1e-6"), ATTITUDE),
    "across it, all uncertain": (
        ("4 +/- 1e-5", "5 +/- 1e-5", "9 +/- 1e-5"),
        ("-3 +/- 1e-5", "1 +/- 1e-5", "1 +/- 1e-5"),
        ("1 +/- 1e-5", "2 +/- 1e-5", -3, "0.5"),
    ),
    "about rest": (BODY, ("0 +/- 1e-3", "0 +/- 1e-3", 0), ATTITUDE),
    "axes not in order": (("1.001 +/- 0.01", 1, "1.5"), ("0.1 +/- 0.01", 1, "0.2"), ATTITUDE),
    "wide": (("1 +/- 0.2", "1 +/- 0.2", "1 +/- 0.2"), ("0.5 +/- 0.5", "0 +/- 1", 1), ATTITUDE),
    "regular": (
        ("0.0109 +/- 1e-6", "0.04", "0.0506"),
        ("0.05", "0.03 +/- 1e-5", "-0.02"),
        ATTITUDE,
    ),
    "needle": (("1e-9", "1e3 +/- 1e-3", "1e3"), ("1 +/- 1e-6", "1e-3", "1e-3"), ATTITUDE),
}


@pytest.mark.parametrize("box", BOXES)
@pytest.mark.parametrize("order", [*permutations(range(3))][::2])
def test_every_point_of_a_box_is_held(box, order):
    inertia, omega, attitude = BOXES[box]
    given = [inertia[k] for k in order], [omega[k] for k in order], attitude
    motion = TorqueFreeMotion(*given, allow_nonphysical=True)
    for time in ("0.7", -6, "1e9"):
        assert holds(numbers(motion.enclose(time, 15)), motion, time, 12), time


@pytest.mark.parametrize(
    ("box", "time"),
    [
        ("tilted spin", 1),
        ("tilted spin", 10),
        ("tilted spin", 100),
        ("nearly a sphere", 10),
        ("nearly symmetric", 4),
        ("across the separatrix", 3),
    ],
)
def test_balls_are_hardly_wider_than_what_the_inputs_leave_open(box, time):
    """Radii are compared with the distances of motions in corners of the box from its middle."""
    motion = TorqueFreeMotion(*BOXES[box])
    found = numbers(motion.enclose(time, 15))
    middle, *others = (sharp(point, time) for point in points(motion, 12))
    with working(200):
        true = [max(float(abs(x[k] - middle[k])) for x in others) for k in range(7)]
    for part in (slice(4), slice(4, 7)):
        assert widest(found[part]) < 1.05 * max(true[part])


def test_rates_of_a_tilted_spin_stay_certain_for_ever():
    q, omega = TorqueFreeMotion(*BOXES["tilted spin"]).enclose("1e12", 15, method="flow")
    assert widest(omega) < 2e-9
    assert all(x.contains(0) and x.rad() <= 1.01 for x in q)


@pytest.mark.parametrize("box", ["across the separatrix", "wide", "needle", "about rest"])
def test_bounds_hold_the_rates_of_all_times(box):
    motion = TorqueFreeMotion(*BOXES[box], allow_nonphysical=True)
    with working(80):
        moments, rates = (list(map(ball, x)) for x in (motion.inertia, motion.omega0))
        factors = [(moments[k - 2] - moments[k - 1]) / moments[k] for k in range(3)]
        limits = rate_bounds(moments, factors, rates)
    for exact in points(motion, 6):
        for time in (1, 17, -333, "1e6"):
            assert contain(limits, exact.enclose(time, 30)[1])


def column(*values):
    return arb_mat(len(values), 1, list(map(arb, values)))


def series(terms):
    """Return factors, and the series of the flow in a tube."""
    factors = [arb("-0.3"), arb("0.7"), arb("-0.5")]
    tube = arb_mat(7, 1, [arb(0, 1)] * 3 + [arb(0, 3)] * 4)
    return factors, flow.Flow(factors, tube, tube, terms)


def test_what_is_cut_off_is_less_than_the_remainder():
    """With few terms the balls of one step still hold the sums of many terms."""
    with working(200):
        start = column("0.3", "-0.5", "0.6", 1, 0, 0, 0)
        factors, fine = series(120)
        for terms, step in ((3, "0.1"), (5, "-0.5"), (8, "0.9")):
            _, rough = series(terms)
            for method, given in (("moved", (factors, start)), ("derivative", (start,))):
                few, many = (getattr(x, method)(*given, arb(step)) for x in (rough, fine))
                assert few.contains(many)
                assert not many.contains(few)


def test_the_derivative_is_what_differences_tend_to():
    with working(200):
        start = column("0.3", "-0.5", "0.6", "0.5", "0.5", "-0.5", "0.5")
        step, small = arb("0.5"), arb(2) ** -90
        factors, fine = series(100)
        whole, slopes = fine.moved(factors, start, step), fine.derivative(start, step)
        for j in range(10):
            moved = [x + small * (i == j) for i, x in enumerate([*start.entries(), *factors])]
            other = fine.moved(moved[7:], column(*moved[:7]), step)
            for i in range(7):
                assert abs((other[i, 0] - whole[i, 0]) / small - slopes[i, j]) < arb(2) ** -80


def test_starts_outside_of_the_box_says_nothing():
    unit = column(*[arb(0, 1)] * 7)
    small = flow.Flow([arb(1)] * 3, unit, unit, 20)
    moved = small.moved([arb(1)] * 3, column(*[2] * 7), arb("0.1"))
    assert not moved[0, 0].rad().is_finite()


def test_a_time_does_not_hang_on_others():
    motion = TorqueFreeMotion(*BOXES["regular"])
    alone = numbers(motion.enclose(50, 15, method="flow"))
    q, omega = TorqueFreeMotion(*BOXES["regular"]).enclose([3, 90, -20, 50], 15, method="flow")
    for one, other in zip(alone, (*q[3], *omega[3]), strict=True):
        assert (one.mid(), one.rad()) == (other.mid(), other.rad())


def test_the_start_is_itself():
    motion = TorqueFreeMotion(*BOXES["tilted spin"])
    q, omega = motion.enclose(0, 15)
    assert omega[0].contains(arb("0.99e-9"))
    assert omega[1].is_zero()
    assert all(
        abs(float(x.mid()) ** 2 - float(y) ** 2 / 14.25) < 1e-15
        for x, y in zip(q, ATTITUDE, strict=True)
    )


def test_time_limits_hold_and_precision_is_left_alone():
    before = ctx.prec
    motion = TorqueFreeMotion(*BOXES["nearly symmetric"])
    with pytest.raises(PrecisionError, match="t = 100: the time was over"):
        motion.enclose(100, 15, max_seconds=1e-9)
    assert ctx.prec == before


def test_time_limits_hold_within_a_step(processor_time):
    """A step of many bits takes minutes."""
    motion = TorqueFreeMotion(BODY, ("0 +/- 1e-1000", 0, "0.5"))
    start = processor_time()
    with pytest.raises(PrecisionError, match="t = 3: the time was over"):
        motion.enclose(3, 1000, method="flow", max_seconds=0.5)
    assert processor_time() - start < 1


def test_radii_far_below_the_formulas_rounding_are_left_to_the_formulas():
    motion = TorqueFreeMotion(BODY, ("0.05 +/- 1e-300", "0.03", "-0.02"))
    q, omega = motion.enclose(3, 300)
    assert max(float(x.rad() * arb(10) ** 300) for x in (*q, *omega)) < 1e4
    assert not motion._boxed._flows


def test_flow_is_for_uncertain_inputs():
    with pytest.raises(InputError, match="method = flow: is for uncertain inputs"):
        TorqueFreeMotion(BODY, (1, 2, 3)).enclose(1, method="flow")
    with pytest.raises(InputError, match="method = 'flow': must be one of: theta, carlson"):
        TorqueFreeMotion(BODY, (1, 2, 3)).precise(1, method="flow")


def test_moments_that_may_be_zero_are_refused():
    with pytest.raises(InputError, match=r"inertia\[0\] = 1 \+/- 1: .* must be positive"):
        TorqueFreeMotion(("1 +/- 1", 1, 1), (1, 2, 3))


def test_late_times_are_bounded_without_steps(monkeypatch):
    monkeypatch.setattr(lohner, "MOST_STEPS", 3)
    motion = TorqueFreeMotion(*BOXES["across the separatrix"])
    assert holds(numbers(motion.enclose(50, 15)), motion, 50, 3)


# By the mean value theorem.
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


def is_held(motion, time, random, count, method="mean"):
    """Return True if balls hold sampled motions; those of the mean value theorem may not exist."""
    try:
        found = numbers(motion.enclose(time, 15, method=method))
    except PrecisionError:
        return method == "mean"
    return holds(found, motion, time, count, random)


@pytest.mark.parametrize(
    ("motion", "times", "methods", "ratio"),
    [
        (TorqueFreeMotion(*BOXES["regular"]), (3, -150, 700), ("carlson",), 1.01),
        (boxed("paper", WIDE), (3, -150), ("carlson", "flow", "mean"), 1.02),
    ],
)
def test_balls_are_never_wider_than_those_of_one_method(motion, times, methods, ratio):
    for time in times:
        best = numbers(motion.enclose(time, 15))
        for method in methods:
            other = numbers(motion.enclose(time, 15, method=method))
            assert overlap(best, other)
            assert all(x.rad() <= ratio * y.rad() for x, y in zip(best, other, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("method", "seed", "widths", "moments", "late"),
    [(None, 8, (-12, 0), (0.7, 1.3), 1.5),
     *(("mean", seed, (-9, -1), (0.3, 1), 4) for seed in range(10))],
)  # fmt: skip
def test_random_boxes_of_every_width_hold_their_motions(method, seed, widths, moments, late):
    """The boxes have all regimes, and some exact numbers."""
    random = Random(seed)
    for _ in range(300):
        part = Fraction(10 ** random.uniform(*widths))

        def number(low, high, part=part):
            uniform = [random.uniform(low, high) for _ in range(2)]
            value = 0 if low < 0 and random.random() < 0.2 else random.choice((1, *uniform))
            return spread(value, part * Fraction(random.choice((0, 1, random.random()))))

        inertia, omega = ([number(*x) for _ in range(3)] for x in (moments, (-1, 1)))
        if min(middle(x) - radius(x) for x in inertia) < 0.1:
            continue
        attitude = [number(-1, 1) for _ in range(3)] if method else ATTITUDE[1:]
        motion = TorqueFreeMotion(inertia, omega, (1, *attitude), allow_nonphysical=True)
        time = Fraction(random.choice((-1, 1)) * 10 ** random.uniform(-1, late))
        assert is_held(motion, time, random, 3 if method else 10, method), (motion, time)


@pytest.mark.parametrize("kind", MOTIONS)
def test_every_motion_of_a_box_is_held(kind):
    random = Random(3)
    for part in (Fraction(1, 20), Fraction(1, 1000), Fraction(1, 10**7)):
        motion = boxed(kind, part, attitude=part)
        for time in ("0.7", -20, 500, "1e5"):
            assert is_held(motion, time, random, 4), (part, time)


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
