"""Uncertain inputs of any regime: the flow holds every motion of the box, and tightly."""

from itertools import permutations
from random import Random

import pytest
from boxes import ATTITUDE, BODY, contain, holds, numbers, overlap, points, sharp, spread, widest
from flint import arb, arb_mat, ctx

from rigidsym import InputError, TorqueFreeMotion
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


@pytest.mark.slow
def test_random_boxes_of_every_width_hold_their_points():
    random = Random(8)
    for _ in range(300):
        radius = 10 ** random.uniform(-12, 0)

        def number(low, high, radius=radius):
            exact = random.random() < 0.3
            middle = random.choice((*[0] * (low < 0), 1, random.uniform(low, high)))
            return middle, 0 if exact else radius * random.random()

        inertia = [number(0.7, 1.3) for _ in range(3)]
        if min(middle - radius for middle, radius in inertia) < 0.1:
            continue
        given = [[spread(*x) for x in v] for v in (inertia, [number(-1, 1) for _ in range(3)])]
        motion = TorqueFreeMotion(*given, ATTITUDE, allow_nonphysical=True)
        time = random.choice((-1, 1)) * 10 ** random.uniform(-1, 1.5)
        assert holds(numbers(motion.enclose(time, 15)), motion, time, 10), (given, time)


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


def test_it_is_never_wider_than_the_formulas_where_these_hold():
    motion = TorqueFreeMotion(*BOXES["regular"])
    for time in (3, -150, 700):
        found, formulas = (
            numbers(motion.enclose(time, 15, method=method)) for method in (None, "carlson")
        )
        assert overlap(found, formulas)
        assert all(x.rad() <= 1.01 * y.rad() for x, y in zip(found, formulas, strict=True))


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
