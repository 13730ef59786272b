"""The NumPy target in every regime, at its edges, and what it refuses; as `test_c_target`."""

import math

import numpy as np
import pytest
from regimes import cases, errors

from rigidsym.generated import torque_free, torque_free_pi

BOUND = 2e-15
MOST = 1.7e308


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_states_are_right_in_every_regime_and_form(case):
    exact = case.exact()
    for module in (torque_free, torque_free_pi):
        prepared = module.prepare(case.inertia, case.omega0, case.attitude0)
        one_by_one = [module.states(prepared, float(t)) for t in case.times]
        together = module.states(prepared, np.array(case.times))
        for q, omega in (together, tuple(map(np.array, zip(*one_by_one, strict=True)))):
            angle, rate = errors(np.hstack((q, omega)), exact)
            assert angle <= BOUND
            assert rate <= BOUND


def test_many_bodies_are_each_right():
    """All regimes in one batch: they part inside and come back in their order."""
    listed = [case for case in cases() if 0 < max(map(abs, case.omega0)) < 1e3]
    assert len(listed) > 60
    given = ([getattr(c, f) for c in listed] for f in ("inertia", "omega0", "attitude0"))
    prepared = torque_free.prepare(*map(np.array, given))
    t = np.array([0.0, 0.7, -31.0])
    q, omega = torque_free.states(prepared, t)
    for k, case in enumerate(listed):
        one = torque_free.states(torque_free.prepare(case.inertia, case.omega0, case.attitude0), t)
        np.testing.assert_allclose(q[k], one[0], rtol=0, atol=2e-15)
        size = max(map(abs, case.omega0))
        np.testing.assert_allclose(omega[k], one[1], rtol=0, atol=4e-15 * size)


@pytest.mark.parametrize(
    ("message", "inertia", "omega0", "attitude0"),
    [
        ("omega0: every number must be finite", (1, 1, 1), (0, -math.inf, 1), (1, 0, 0, 0)),
        ("inertia: principal moments must be positive", (1, 1, 0), (0, 0, 1), (1, 0, 0, 0)),
        ("inertia: principal moments differ by", (1, 1, 2.0**-201), (0, 0, 1), (1, 0, 0, 0)),
        ("attitude0: a zero quaternion", (1, 1, 1), (0, 0, 1), (0, -0.0, 0, 0)),
        ("omega0: rates beyond what", (1, 2, 2.5), (MOST, MOST, MOST), (1, 0, 0, 0)),
    ],
)
def test_what_no_plan_is_made_of(message, inertia, omega0, attitude0):
    with pytest.raises(ValueError, match=message):
        torque_free.prepare(inertia, omega0, attitude0)


def test_faint_rates_are_there_at_the_start_whatever_the_largest():
    omega0 = (1e300, 1e-20, -3e-17)
    prepared = torque_free.prepare((1, 2, 2.5), omega0)
    assert torque_free.states(prepared, 0.0)[1].tolist() == list(omega0)
    assert torque_free.states(prepared, [0.0])[1].tolist() == [list(omega0)]


def test_a_body_at_rest_rests_for_ever():
    prepared = torque_free.prepare((1, 2, 2.5), (0, 0, 0), (0, 1, 0, 0))
    for t in (1e300, -MOST, 0.0):
        for found in (torque_free.states(prepared, t), torque_free.states(prepared, np.array(t))):
            assert found[0].tolist() == [0, 1, 0, 0]
            assert found[1].tolist() == [0, 0, 0]


def test_bodies_that_cannot_exist_are_refused_times_they_turn_too_often_by():
    prepared = torque_free.prepare((1.0, 2.0**-60, 2.0**-90), (1.0, 0.5, 0.1))
    for t in (2.0**40, [2.0**40]):
        with pytest.raises(ValueError, match="the angle is lost in binary64"):
            torque_free.states(prepared, t)
    q, _ = torque_free.states(prepared, 2.0**-40)
    assert abs(np.linalg.norm(q) - 1) < 1e-15
