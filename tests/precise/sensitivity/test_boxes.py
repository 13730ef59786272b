"""Uncertain inputs by the theorem of the mean: every motion is held, and hardly more than these."""

from fractions import Fraction
from random import Random

import pytest
from boxes import holds, numbers, point_of
from flint import arb

from rigidsym import TorqueFreeMotion
from rigidsym._inputs import Uncertain, middle, radius
from rigidsym.errors import InputError, PrecisionError
from rigidsym.precise._balls import ball, working

BODY, ATTITUDE = ("0.0109", "0.04", "0.0506"), ("1", "2", "-3", "0.5")
# Moments and rates; of each box the motions are uncertain by a part of these.
MOTIONS = {
    "paper": (BODY, ("0.05", "0.03", "-0.02")),
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
    parts = 0 if "exact" in kind else part, part, attitude
    given = (inertia, omega, ATTITUDE)
    numbers = [
        tuple(
            Uncertain(Fraction(x), abs(Fraction(x)) * p) if p and Fraction(x) else x for x in values
        )
        for values, p in zip(given, parts, strict=True)
    ]
    return TorqueFreeMotion(*numbers, allow_nonphysical=True)


def effect(motion, time, corners=16):
    """How far corners of a box are from its middle, in attitude and rates; and how far that is from
    what the middle's sensitivities say."""
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
                sizes[k] = max(sizes[k], *(abs(float(x)) for x in gaps))
                curved[k] = max(
                    curved[k], *(abs(float(x - y)) for x, y in zip(gaps, by, strict=True))
                )
    return sizes, curved


def _half(p, q):
    """p q/2."""
    vector = [p[0] * q[k] + q[0] * p[k] + p[1 + k % 3] * q[1 + (k + 1) % 3]
              - p[1 + (k + 1) % 3] * q[1 + k % 3] for k in (1, 2, 3)]  # fmt: skip
    return [x / 2 for x in (p[0] * q[0] - sum(p[k] * q[k] for k in (1, 2, 3)), *vector)]


WIDE, NARROW = Fraction(1, 1000), Fraction(1, 10**6)


@pytest.mark.parametrize("kind", MOTIONS)
def test_balls_are_hardly_wider_than_what_inputs_leave_open(kind):
    """To twice, where the first order is right to a twentieth, whatever the time is."""
    seen = 0
    for part, time in ((WIDE, 1), (WIDE, -30), (WIDE, 300), (NARROW, 1000), (NARROW, -30_000)):
        motion = boxed(kind, part)
        sizes, curved = effect(motion, time)
        if all(bend < size / 20 for size, bend in zip(sizes, curved, strict=True)):
            found = numbers(motion.enclose(time, 15, method="mean"))
            for size, balls in zip(sizes, (found[:4], found[4:]), strict=True):
                assert max(float(x.rad()) for x in balls) < 2 * size, (part, time)
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
    """Of all widths and regimes, with what is exact now and then."""
    random = Random(seed)
    for _ in range(300):
        part = Fraction(10 ** random.uniform(-9, -1))

        def number(low, high, part=part):
            value = Fraction(
                random.choice((1, random.uniform(low, high), random.uniform(low, high)))
            )
            if low < 0 and random.random() < 0.2:
                value = Fraction(0)
            spread = part * Fraction(random.choice((0, 1, random.random())))
            return Uncertain(value, spread) if spread else value

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
            for one, other in zip(
                best, numbers(motion.enclose(time, 15, method=method)), strict=True
            ):
                assert one.rad() <= 1.02 * other.rad()
                assert one.overlaps(other)


def test_one_number_of_the_paper_is_as_certain_as_it_is():
    """1e-6 of the smallest moment: what formulas alone make 6e-4 of is 1.4e-8 after a second."""
    motion = TorqueFreeMotion(("0.0109 +/- 1e-6", *BODY[1:]), ("0.05", "0.03", "-0.02"))
    q, _ = motion.enclose(1, 15)
    formulas, _ = motion.enclose(1, 15, method="carlson")
    assert max(float(x.rad()) for x in q) < 1.5e-8
    assert max(float(x.rad()) for x in formulas) > 5e-4


def test_attitudes_of_late_times_are_certain_where_a_spin_is_tilted():
    motion = TorqueFreeMotion(BODY, ("0 +/- 1e-9", 0, "0.5"), ATTITUDE)
    found = numbers(motion.enclose("1e12", 15))
    assert max(float(x.rad()) for x in found) < 1e-6
    assert holds(found, motion, "1e12", 6, Random(4))


@pytest.mark.parametrize("kind", ["paper", "symmetric", "sphere, of exact moments", "sphere"])
def test_sensitivities_of_a_box_hold_those_of_its_motions(kind):
    random, motion = Random(6), boxed(kind, Fraction(1, 10**5), attitude=Fraction(1, 10**4))
    S = motion.enclose([3, -200], 15, sensitivity=True)[2]
    for _ in range(4):
        exact = point_of(motion, lambda: random.uniform(-1, 1)).enclose(
            [3, -200], 30, sensitivity=True
        )
        for name in ("attitude", "rates", "attitude_t", "rates_t"):
            pairs = zip(getattr(S, name).flat, getattr(exact[2], name).flat, strict=True)
            assert all(x.contains(y) for x, y in pairs)


def test_a_box_of_bodies_at_rest_has_what_each_of_them_has():
    rest = TorqueFreeMotion(("1 +/- 0.1", 2, 3), (0, 0, 0), ("1 +/- 1e-3", 2, 3, 4))
    found, exact = (
        motion.enclose(5, 15, sensitivity=True)[2]
        for motion in (rest, TorqueFreeMotion((1, 2, 3), (0, 0, 0), (1, 2, 3, 4)))
    )
    for name in ("attitude", "rates", "attitude_t", "rates_t"):
        pairs = zip(getattr(found, name).flat, getattr(exact, name).flat, strict=True)
        assert all(x.overlaps(y) and x.rad() < 0.01 for x, y in pairs)


@pytest.mark.parametrize(
    ("inertia", "omega", "reason"),
    [
        ((1, 2, "2.5"), ("0 +/- 1e-3", 0, 0), "holds a body at rest, whose momentum has no direc"),
        (("2 +/- 1e-3", 2, "2.0005"), (1, 2, 3), None),
        (("2 +/- 1e-3", 2, "2.0005 +/- 1e-3"), (1, 2, 3), None),
    ],
)
def test_boxes_that_have_no_sensitivities_say_why(inertia, omega, reason):
    motion = TorqueFreeMotion(inertia, omega)
    if reason is None:
        motion.enclose(1, 15, sensitivity=True)
        return
    for arguments in ({"sensitivity": True}, {"method": "mean"}):
        with pytest.raises(PrecisionError, match=f"t = 1: the box {reason}"):
            motion.enclose(1, 15, **arguments)
    motion.enclose(1, 15)


def test_what_cannot_be_said_is_refused():
    wide = TorqueFreeMotion((4, 5, 9), (3, 1, "1 +/- 1e-2"))
    for arguments in ({"method": "mean"}, {"sensitivity": True}):
        with pytest.raises(PrecisionError, match="t = 300: the inputs are too uncertain"):
            wide.enclose(300, 15, **arguments)
    exact = TorqueFreeMotion(BODY, (1, 2, 3))
    with pytest.raises(InputError, match="method = mean: is for uncertain inputs"):
        exact.enclose(1, method="mean")
    with pytest.raises(InputError, match=r"omega0\[2\] = .*is uncertain"):
        wide.precise(1, sensitivity=True)
    with pytest.raises(InputError, match="sensitivity = 1: must be true or false"):
        exact.enclose(1, sensitivity=1)
    for method in ("mpmath", "theorem1"):
        with pytest.raises(InputError, match=f"method = '{method}': has no error bounds"):
            exact.precise(1, method=method, sensitivity=True)
