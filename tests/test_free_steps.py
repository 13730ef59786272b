"""`rigidsym.step`: right in every stratum, from any state, in place, and refused by name."""

import math

import numpy as np
import pytest
from benchmarks.drift import drifts

import rigidsym
from rigidsym import InputError, TorqueFreeMotion
from rigidsym._engines import threads

BODY, RATES = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
START = (1.0, 0.0, 0.0, 0.0)


def bodies(count, seed=0):
    draw = np.random.default_rng(seed)
    x, y, z = draw.uniform(0.05, 1, (3, count))
    omega, q = draw.normal(size=(count, 3)), draw.normal(size=(count, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    return np.stack([y + z, z + x, x + y], -1), q, omega


def test_steps_of_both_engines_agree_and_so_do_motions():
    inertia, q, omega = bodies(200)
    dt = np.linspace(-2, 2, 200)
    ours = rigidsym.step(inertia, q, omega, dt)
    for found, expected in zip(ours, rigidsym.step(inertia, q, omega, dt, engine="c"), strict=True):
        np.testing.assert_allclose(found, expected, rtol=0, atol=5e-15)
    for k in (0, 77, 199):
        motion = TorqueFreeMotion(inertia[k], omega[k], q[k])
        np.testing.assert_allclose(ours[0][k], motion(dt[k])[0], rtol=0, atol=5e-15)
        np.testing.assert_allclose(ours[1][k], motion(dt[k])[1], rtol=0, atol=1e-14)


def test_leading_shapes_broadcast(engine):
    inertia, q, omega = bodies(5)
    dt = np.array([[0.5], [-1.0], [0.0]])
    after = rigidsym.step(inertia, q, omega, dt, engine=engine)
    assert [x.shape for x in after] == [(3, 5, 4), (3, 5, 3)]
    for place in ((0, 4), (1, 0), (2, 2)):
        k = place[1]
        alone = rigidsym.step(inertia[k], q[k], omega[k], dt[place[0], 0], engine=engine)
        for x, y in zip(after, alone, strict=True):
            np.testing.assert_array_equal(x[place], y)
    one = rigidsym.step(BODY, q, omega, 0.5, engine=engine)
    assert one[0].shape == (5, 4)
    assert rigidsym.step(BODY, np.empty((0, 4)), RATES, 0.5, engine=engine)[1].shape == (0, 3)


def test_a_body_has_the_same_bits_wherever_it_stands(monkeypatch):
    inertia, q, omega = bodies(40_000)
    whole = rigidsym.step(inertia, q, omega, 0.3, engine="c")
    for some in (slice(7, 8), slice(101, 250), slice(39_990, 40_000)):
        part = rigidsym.step(inertia[some], q[some], omega[some], 0.3, engine="c")
        assert all(np.array_equal(x[some], y) for x, y in zip(whole, part, strict=True))
    monkeypatch.setattr(threads, "processors", lambda: 3)
    again = rigidsym.step(inertia, q, omega, 0.3, engine="c")
    assert all(map(np.array_equal, whole, again))


def test_a_step_in_place(engine):
    inertia, q, omega = bodies(50)
    expected = rigidsym.step(inertia, q, omega, 0.4, engine=engine)
    found = rigidsym.step(inertia, q, omega, 0.4, engine=engine, out=(q, omega))
    assert found[0] is q
    assert found[1] is omega
    assert all(map(np.array_equal, found, expected))
    shared = np.zeros(400)
    out = shared[:200].reshape(50, 4), shared[199:349].reshape(50, 3)
    with pytest.raises(InputError, match=r"^out = as given: q and omega must not overlap"):
        rigidsym.step(inertia, q, omega, 0.4, engine=engine, out=out)


def test_what_does_not_turn_stays_as_it_is(engine):
    q = np.array([[0.5, 0.5, -0.5, 0.5]] * 3)
    omega = np.array([(0.0, 0.0, 0.0), RATES, (0.0, -0.0, 0.0)])
    after = rigidsym.step(BODY, q, omega, [3.0, 0.0, 1e300], engine=engine)
    np.testing.assert_array_equal(after[0], q)
    np.testing.assert_array_equal(after[1], omega)


@pytest.mark.parametrize("scale", [1e-250, 1e-80, 1e80, 1e250])
def test_units_do_not_matter(engine, scale):
    inertia, q, omega = bodies(30)
    powers = 2.0 ** round(math.log2(scale))
    expected = rigidsym.step(inertia, q, omega, 0.5, engine=engine)
    found = rigidsym.step(inertia * powers, q / powers, omega * powers, 0.5 / powers, engine=engine)
    np.testing.assert_array_equal(found[0], expected[0])
    np.testing.assert_array_equal(found[1] / powers, expected[1])


@pytest.mark.parametrize("steps", [2000, pytest.param(10**6, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", ["uniform", "separatrix", "near sphere", "rod", "flat"])
def test_energy_and_momentum_drift_no_faster_than_a_random_walk(kind, steps):
    """Near a sphere rates change by an ulp a step, and rounding to nearest erred one way."""
    for drift in drifts(steps, bodies=16, kinds=(kind,)):
        assert drift.rms[steps] <= 3 * math.sqrt(steps)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"inertia": (1, -2, 2)}, r"^inertia\[1\] = -2.0: principal moments must be positive"),
        ({"inertia": (1, 1, 5)}, r"^inertia = .*larger than the sum"),
        ({"q": [START, (0, 0, 0, 0)]}, r"^q\[1\] = .*a zero quaternion is no attitude"),
        ({"omega": [RATES, (1, math.nan, 0)]}, r"^omega\[1, 1\] = nan: must be finite"),
        ({"dt": [0.1, math.inf]}, r"^dt\[1\] = inf: must be finite"),
        ({"dt": [0.1, 300.0]}, r"^dt\[1\] = 300.0: \|omega dt\| must be at most 8 rad"),
        ({"omega": [RATES, (0, 90, 0)]}, r"^dt = 0.1: \|omega dt\| .* 8 rad \(body 1\)"),
        ({"dt": [0.1, 0.2, 0.3]}, r"^dt = an array of shape \(3,\): leading shape \(3,\)"),
        ({"q": np.zeros((2, 3))}, r"^q = an array of shape \(2, 3\): the last axis"),
        ({"engine": "fortran"}, r"^engine = 'fortran': must be one of: numpy, c"),
        ({"inertia": (1e-70, 1, 1)}, r"^inertia = .*differ by more than binary64"),
    ],
    ids=str,
)
def test_bad_input_is_one_line(engine, changes, message):
    given = {"inertia": BODY, "q": [START] * 2, "omega": [RATES] * 2, "dt": 0.1, "engine": engine}
    with pytest.raises(InputError, match=message):
        rigidsym.step(**given | changes)
