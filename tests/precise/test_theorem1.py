"""Theorem 1 as mended against the balls: all axis orders and signs, long times, its domain."""

from itertools import permutations, product

import mpmath
import pytest

from rigidsym import InputError, PrecisionError, TorqueFreeMotion
from rigidsym.precise import _theorem1 as theorem1

MOMENTS = ("2.1", "3", "4.3")
RATES = {"largest": ("0.4", "0.3", "0.9"), "smallest": ("0.9", "0.3", "0.4")}
ATTITUDE = ("0.5", "-0.1", "0.7", "0.3")
PAPER = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))


def distance(motion, times, digits=30):
    """How far states by Theorem 1 are from those by theta functions, double cover included."""
    found, expected = (motion.precise(times, digits, method=m) for m in ("theorem1", "theta"))
    with mpmath.workdps(digits + 10):
        pairs = (zip(a.flat, b.flat, strict=True) for a, b in zip(found, expected, strict=True))
        return max(abs(x - y) for pair in pairs for x, y in pair)


@pytest.mark.parametrize("order", [*permutations(range(3))])
@pytest.mark.parametrize("circulation", RATES)
def test_every_order_of_axes_and_every_sign(order, circulation):
    for signs in product(("", "-"), repeat=3):
        rates = [sign + RATES[circulation][k] for sign, k in zip(signs, order, strict=True)]
        motion = TorqueFreeMotion([MOMENTS[k] for k in order], rates, ATTITUDE)
        assert distance(motion, ["17.3", "-41"]) < 1e-29


@pytest.mark.parametrize("time", ["1e12", "-12345.678"])
def test_long_times(time):
    assert distance(PAPER, time, 40) < 1e-39


@pytest.mark.parametrize("digits", [1, 15, 150])
def test_digits_from_one_to_hundreds(digits):
    assert distance(PAPER, [1, 180], digits) < mpmath.mpf(10) ** -(digits - 0.5)


@pytest.mark.parametrize(
    ("inertia", "omega", "said"),
    [
        ((1, 1, 2), (1, 0, 1), "symmetric"),
        ((1, 1, 1), (1, 2, 3), "spherical"),
        ((1, 2, "2.5"), (0, 1, 0), "spin"),
        ((1, 2, "2.5"), (0, 0, 0), "rest"),
        ((1, 2, "9/4"), (3, 1, 4), "separatrix"),
    ],
)
def test_motions_without_three_sines_are_refused(inertia, omega, said):
    motion = TorqueFreeMotion(inertia, omega)
    assert str(motion.regime).startswith(said)
    with pytest.raises(InputError, match=f"method = 'theorem1': has no sines.*{said}.*theta"):
        motion.precise(1, method="theorem1")


@pytest.mark.parametrize("omega", [("0.4", "0.3", 0), ("0.4", 0, "-0.9")])
def test_starts_at_which_it_divides_by_zero_are_refused(omega):
    with pytest.raises(InputError, match=r"omega0 = .*Theorem 1 divides by it"):
        TorqueFreeMotion(MOMENTS, omega).precise(1, method="theorem1")


def test_a_start_where_phi3_is_zero_is_none_of_them():
    assert distance(TorqueFreeMotion(MOMENTS, ("0.4", 0, "0.9")), ["1", "90"]) < 1e-29


def test_a_wrong_pi_is_seen_against_the_balls(monkeypatch):
    """Two precisions cannot see it, so that this test can fail where the formulas are wrong."""
    exact = theorem1._Lines._real_third_kind
    monkeypatch.setattr(
        theorem1._Lines,
        "_real_third_kind",
        lambda self, n, u, mc: exact(self, n, u, mc) * (1 + theorem1.CTX.mpf(10) ** -9),
    )
    assert distance(PAPER.replace(), "180") > 1e-12


def test_seconds_that_are_over():
    with pytest.raises(PrecisionError, match="digits were reached"):
        PAPER.precise(180, 4000, method="theorem1", max_seconds=0.2)
