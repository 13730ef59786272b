"""Arithmetic with slopes holds the values of all points of a box."""

from random import Random

from flint import arb, arb_mat

from rigidsym.precise import _balls as balls
from rigidsym.precise._sensitivity.sloped import Sloped, power

RADII, MIDDLES = (0.25, 0.5), (1.5, 4.0)


def inputs():
    box = arb_mat([[arb(0, x)] for x in RADII])
    for k, middle in enumerate(MIDDLES):
        slopes = arb_mat([[int(j == k) for j in range(2)]])
        yield Sloped(arb(middle), slopes, arb(middle, RADII[k]), box)


FORMULAS = {
    "sums": lambda x, y, f: 2 * x - (y + 1) + x - 3,
    "a product less itself": lambda x, y, f: x * y - y * x,
    "quotients": lambda x, y, f: x / y + 1 / x - y / 2,
    "powers": lambda x, y, f: f(x - 1, 2) + f(y, 5) - f(x, 1),
    "a root": lambda x, y, f: (x * x + y).sqrt(),
    "all": lambda x, y, f: (f(x, 3) - y) / (x + f(y, 2)).sqrt() - (-x) * y,
}


def test_values_and_slopes_hold_all_points():
    random = Random(2)
    for name, formula in FORMULAS.items():
        whole = formula(*inputs(), power)
        for _ in range(50):
            shifts = [random.choice((-1, 1, random.uniform(-1, 1))) * r for r in RADII]
            point = formula(
                *(arb(m) + arb(s) for m, s in zip(MIDDLES, shifts, strict=True)), balls.power
            )
            moved = whole.middle + (whole.slopes * arb_mat([[s] for s in shifts]))[0, 0]
            assert whole.whole.overlaps(point), name
            assert moved.overlaps(point), name


def test_what_cancels_does():
    x, _ = inputs()
    assert (x - x).whole.is_zero()


def test_nothing_finite_is_said_of_a_quotient_by_zero_or_a_root_below():
    x, y = inputs()
    assert not (y / (x - arb("1.5"))).whole.is_finite()
    assert not (x - 2).sqrt().whole.is_finite()
