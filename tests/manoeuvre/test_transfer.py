"""Tests of what transfers miss by: beside motions with the errors made, and where errors grow."""

import numpy as np
import pytest
from random_manoeuvres import BODY, START, manoeuvre, turn

from rigidsym import TorqueFreeMotion
from rigidsym.manoeuvre import plan, solve
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotation_vectors

INERTIA, STEP = np.array(BODY), 1e-6
SPIN = np.array([0.004, -0.002, 0.003])


@pytest.fixture(scope="module")
def best():
    return plan(BODY, START, (0.5, 0.5, 0.5, 0.5), 180, start_spin=SPIN).best


def turned(one, errors):
    """Return the rotation in space between the arrivals with two errors."""
    ends = []
    for error in errors:
        given = {"burst": np.zeros(3), "attitude": START, "inertia": INERTIA} | error
        rates = SPIN + (one.bursts[0] + given["burst"]) / given["inertia"]
        motion = TorqueFreeMotion(given["inertia"], rates.tolist(), given["attitude"])
        ends.append(motion(one.duration)[0])
    return rotation_vectors(product(ends[0], conjugate(ends[1])))


@pytest.mark.parametrize("k", range(3))
def test_by_burst_attitude_and_moments_as_differences_have_it(best, k):
    found, unit = best.sensitivity, np.eye(3)[k]
    size = STEP * np.linalg.norm(best.bursts[0])
    by_burst = turned(best, [{"burst": s * size * unit} for s in (1, -1)]) / (2 * size)
    assert by_burst == pytest.approx(found.by_burst[:, k], rel=1e-6, abs=1e-3)
    attitudes = [of_rotation_vectors(s * STEP * unit) for s in (1, -1)]
    by_attitude = turned(best, [{"attitude": q.tolist()} for q in attitudes]) / (2 * STEP)
    assert by_attitude == pytest.approx(found.by_attitude[:, k], abs=1e-8)
    moments = [{"inertia": INERTIA * (1 + s * STEP * unit)} for s in (1, -1)]
    by_moments = turned(best, moments) / (2 * STEP * BODY[k])
    assert by_moments == pytest.approx(found.by_moments[:, k], rel=1e-6, abs=1e-4)


def test_the_worst_direction_is_worse_than_any_and_is_reached(best):
    found, burst = best.sensitivity, best.bursts[0]
    axes = np.random.default_rng(3).normal(size=(4000, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    missed = np.linalg.norm(np.cross(axes, burst) @ found.by_burst.T, axis=1)
    assert 0.98 * found.direction < missed.max() <= found.direction * (1 + 1e-12)
    percent = turned(best, [{"burst": s * 1e-5 * burst} for s in (1, -1)]) / 2e-5
    assert np.linalg.norm(percent) / 100 == pytest.approx(found.size, rel=1e-6)


def test_turns_about_the_middle_axis_are_warned_of():
    found = plan((1, 2, 3), START, turn((0, 1, 0), 3.0), 10, families=40)
    spins = [one for one in found.transfers if one.growth_exponent]
    assert spins
    assert "errors grow by up to e^" in found.title
    for one in spins:
        assert one.missed.endswith("grows exponentially")
        assert abs(one.omega0[1]) > 0.9 * np.linalg.norm(one.omega0)
    assert solve(manoeuvre(0), 1).best.growth_exponent == 0


def test_the_exponent_is_that_of_the_linear_equations():
    """About the middle axis of (1, 2, 3) rates across it grow by lambda^2 = omega^2 / 3."""
    several = plan((1, 2, 3), START, (0, 0, 1, 0), 10, families=40).transfers
    one = max(several, key=lambda one: one.growth_exponent)
    assert one.growth_exponent == pytest.approx(10 * abs(one.omega0[1]) / 3**0.5, rel=0.02)


def test_data_and_text_have_the_miss(best):
    data = best.to_data()
    assert data["miss_burst_size"] == best.sensitivity.size
    assert data["miss_burst_direction"] == best.sensitivity.direction
    assert best.missed in repr(best)
    assert "burst 1 %, 1 deg off" in best._repr_html_()
