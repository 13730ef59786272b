"""Mode, nutation and periods of a motion, and its states as tables."""

import math
import sys
from itertools import permutations

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion, fit, integrate
from rigidsym.quaternions import product
from rigidsym.solution._polhode import Mode

SHORT, LONG = Mode.SHORT_AXIS, Mode.LONG_AXIS
PAPER = TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
MODES = [
    ((1, 2, 2.5), (3, 1, 1), LONG),
    ((1, 2, 2.5), (1, 1, 3), SHORT),
    ((4, 5, 9), (3, 1, 1), None),
    ((1, 1, 1), (1, 2, 3), None),
    ((1, 2, 2.5), (0, 0, 0), None),
    ((1, 2, 2.5), (0, -1, 0), None),
    ((1, 2, 2.5), (0, 0, -1), SHORT),
    ((1, 2, 2.5), (-1, 0, 0), LONG),
    ((1, 2, 2), (1, 2, 3), LONG),
    ((1, 1, 2), (1, 2, 3), SHORT),
    ((1, 2, 2), (0, 2, 3), SHORT),
    ((1, 1, 2), (1, 1, 0), LONG),
]


@pytest.mark.parametrize(("body", "rates", "mode"), MODES)
def test_the_mode_is_decided_whatever_axis_is_called_first(body, rates, mode):
    for order in permutations(range(3)):
        motion = TorqueFreeMotion([body[k] for k in order], [rates[k] for k in order])
        assert motion.mode is mode


@pytest.mark.parametrize(("body", "rates", "mode"), [x for x in MODES if x[2] or x[0] == (4, 5, 9)])
def test_nutation_is_what_the_motion_does(body, rates, mode):
    motion = TorqueFreeMotion(body, rates)
    axis = int(np.argmin(body) if mode is LONG else np.argmax(body))
    if motion.regime.steady:
        assert motion.nutation == (0.0, 0.0)
        return
    t = np.linspace(-40, 40, 40001) if mode is None else np.linspace(0, 60, 200001)
    momentum = np.array(body) * motion(t)[1]
    along = np.abs(momentum[:, axis])
    angle = np.arctan2(np.linalg.norm(np.delete(momentum, axis, axis=1), axis=1), along)
    assert np.allclose(motion.nutation, (angle.min(), angle.max()), rtol=0, atol=1e-6)


def test_small_nutation_keeps_its_digits():
    low, high = TorqueFreeMotion((1, 2, 3), (1, 0, "1e-100")).nutation
    assert low == pytest.approx(3e-100, rel=1e-14)
    assert high == pytest.approx(12**0.5 * 1e-100, rel=1e-14)


MOVING = [x[:2] for x in MODES if x[0] in ((1, 2, 2), (1, 1, 2), (1, 2, 2.5)) and all(x[1])]
AT_LARGE = ("energy", "momentum", "parameter", "modulus", "period", "precession_rate",
            "phase_per_period", "circulation_rate")  # fmt: skip


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (1, 0, 2)])
@pytest.mark.parametrize(("body", "rates"), [*MOVING, ((1, 2, 3), (1, 1e-9, -1e-7))])
def test_after_a_period_rates_are_back_and_the_attitude_has_turned_by_the_phase(body, rates, order):
    motion = TorqueFreeMotion([body[k] for k in order], [rates[k] for k in order])
    (start, omega0), (q, omega) = motion(0.0), motion(motion.period)
    assert np.allclose(omega, omega0, rtol=0, atol=1e-14)
    axis = np.array([float(x) for x in motion.inertia]) * omega0 / motion.momentum
    half = motion.phase_per_period / 2
    turn = np.array([math.cos(half), *(math.sin(half) * axis)])
    assert np.allclose(q, product(turn, start), rtol=0, atol=2e-14)
    assert motion.phase_per_period == motion.precession_rate * motion.period
    # Before that they have not been back: the third of a period is none.
    assert not np.allclose(motion(motion.period / 3)[1], omega0, rtol=1e-9, atol=0)


@pytest.mark.parametrize(("body", "rates"), [MOVING[0], MOVING[2]])
def test_they_are_those_that_expressions_have(body, rates):
    motion = TorqueFreeMotion(body, rates)
    expressions = motion.symbolic().quantities
    for name in AT_LARGE:
        assert getattr(motion, name) == pytest.approx(float(expressions[name]), rel=1e-15)


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (1, 0, 2)])
@pytest.mark.parametrize(("body", "rates"), MOVING)
def test_mean_rates_are_those_of_the_motion(body, rates, order):
    """Sums over a period are exact means of periodic functions."""
    motion = TorqueFreeMotion([body[k] for k in order], [rates[k] for k in order])
    t = np.arange(400) * (motion.period / 400)
    assert np.allclose(motion(t)[1].mean(axis=0), motion.mean_rates, rtol=0, atol=2e-14)
    expressions = motion.symbolic().quantities
    mean = sum(motion.mean_rates)
    assert float(expressions["mean_circulation_rate"]) == pytest.approx(mean, rel=1e-14)
    assert motion.circulation_rate == pytest.approx(float(expressions["circulation_rate"]))


def test_mean_rates_of_the_edges():
    assert TorqueFreeMotion((4, 5, 9), (3, 1, 1)).mean_rates == (0.0, 0.0, 0.0)
    assert TorqueFreeMotion((4, 5, 9), (3, 1, 1)).circulation_rate == 0
    assert TorqueFreeMotion((1, 2, 2.5), (0, -2, 0)).mean_rates == (0.0, -2.0, 0.0)
    assert TorqueFreeMotion((1, 2, 2.5), (0, -2, 0)).circulation_rate is None


def test_the_separatrix_takes_forever():
    motion = TorqueFreeMotion((4, 5, 9), (3, 1, 1))
    assert motion.period == math.inf
    assert motion.parameter == motion.modulus == 1
    assert motion.precession_rate is None
    assert motion.phase_per_period is None


@pytest.mark.parametrize(("rates", "size"), [((0, -2, 0), 2.0), ((0, 0, 0), 0.0)])
def test_constant_rates_have_no_period(rates, size):
    motion = TorqueFreeMotion((1, 2, 2.5), rates)
    assert motion.period is motion.phase_per_period is motion.modulus is motion.parameter is None
    assert motion.precession_rate == size
    assert motion.energy == size**2
    assert motion.momentum == 2 * size


def test_quantities_of_extreme_sizes():
    """Squares of these quantities leave binary64."""
    motion = TorqueFreeMotion(("1e-100",) * 2 + ("1.5e-100",), ("1e-150", 0, "1e-150"))
    assert motion.momentum == pytest.approx(math.sqrt(3.25) * 1e-250, rel=1e-15, abs=0)
    assert motion.period == pytest.approx(2 * math.pi / 0.5e-150, rel=1e-14)


def test_uncertain_motions_have_a_mode_and_none_of_the_numbers():
    vague = PAPER.replace(omega0=("0.05 +/- 1e-9", 0.03, -0.02))
    assert vague.mode is PAPER.mode
    for name in ("nutation", "mean_rates", *AT_LARGE):
        with pytest.raises(InputError, match=r"omega0\[0\] = .* is uncertain, so that .* no one"):
            getattr(vague, name)


@pytest.mark.parametrize(("body", "rates", "mode"), [x for x in MODES if any(x[1])])
def test_a_mode_is_told_only_where_all_motions_within_the_radii_have_it(body, rates, mode):
    largest = max(range(3), key=lambda k: abs(rates[k]))
    vague = [f"{x} +/- 1e-30" if k == largest else x for k, x in enumerate(rates)]
    motion = TorqueFreeMotion(body, vague)
    if body == (4, 5, 9):
        with pytest.raises(InputError, match="may be zero or have either sign"):
            _ = motion.mode
    else:
        assert motion.mode is mode


def test_a_body_that_may_be_a_sphere_has_no_mode():
    with pytest.raises(InputError, match="may be zero or have either sign"):
        _ = TorqueFreeMotion((1, "1 +/- 1e-9", "1.2"), (1, 2, 3)).mode


@pytest.mark.parametrize("degrees", [False, True])
def test_a_dataframe_has_the_states(degrees):
    pandas = pytest.importorskip("pandas", reason="needs pandas (extra frames)")
    q, omega = PAPER([0.0, 90.0, 180.0])
    found = PAPER.to_dataframe([0.0, 90.0, 180.0], degrees=degrees)
    assert isinstance(found, pandas.DataFrame)
    assert found.index.name == "t"
    assert found.index.tolist() == [0.0, 90.0, 180.0]
    assert [*found] == ["q0", "q1", "q2", "q3", "omega1", "omega2", "omega3"]
    assert np.array_equal(found.to_numpy()[:, :4], q)
    assert np.array_equal(found.to_numpy()[:, 4:], np.rad2deg(omega) if degrees else omega)
    assert len(PAPER.to_dataframe(5)) == 1


@pytest.mark.parametrize(("degrees", "unit"), [(False, "rad/s"), (True, "deg/s")])
def test_a_dataset_has_the_states_and_says_units(degrees, unit):
    pytest.importorskip("xarray", reason="needs xarray (extra frames)")
    q, omega = PAPER([0.0, 90.0])
    found = PAPER.to_xarray([0.0, 90.0], degrees=degrees)
    assert found.q.dims == ("t", "component")
    assert found.omega.attrs["units"] == unit
    assert np.array_equal(found.q, q)
    assert np.array_equal(found.omega, np.rad2deg(omega) if degrees else omega)
    assert found.omega.sel(t=90.0, axis=2) == (np.rad2deg(omega) if degrees else omega)[1, 1]


def test_frames_of_dates_trajectories_and_predictions():
    pandas = pytest.importorskip("pandas", reason="needs pandas (extra frames)")
    dates = pandas.date_range("2026-01-01", periods=3, freq="90s", tz="Europe/Berlin", name="t")
    found = PAPER.to_dataframe(dates)
    assert found.index.equals(dates)
    assert found.to_numpy().tolist() == PAPER.to_dataframe([0.0, 90.0, 180.0]).to_numpy().tolist()
    assert PAPER.to_dataframe(dates - dates[0]).index.equals(dates - dates[0])
    bodies = [(1, 2, 2.5), (2, 3, 4)]
    run = integrate(bodies, (1, 0, 0, 0), (0.1, 0.2, 0.3), lambda t, q, w: 0 * w, [0, 1, 2], step=1)
    found = run.to_dataframe(degrees=True)
    assert found.index.names == ["body", "t"]
    assert found.loc[(1, 2.0), "omega2"] == np.rad2deg(run.omega[1, 2, 1])
    pytest.importorskip("xarray", reason="needs xarray (extra frames)")
    assert run.to_xarray().q.dims == ("body", "t", "component")
    assert np.array_equal(run.to_xarray().omega, run.omega)
    seen = np.linspace(0, 200, 15)
    fitted = fit(seen, attitudes=PAPER(seen)[0], sigma={"attitudes": 1e-3}, guess=PAPER)
    predicted = fitted.predict([0.0, 300.0])
    found = predicted.to_dataframe()
    assert found.index.tolist() == [0.0, 300.0]
    assert [*found][7:] == ["attitude_sigma", "omega1_sigma", "omega2_sigma", "omega3_sigma"]
    assert found.attitude_sigma.tolist() == predicted.attitude_sigma.tolist()
    assert found.omega2_sigma[300.0] == np.sqrt(predicted.covariance[1, 4, 4])
    assert len(fitted.predict(3.0).to_dataframe()) == 1
    for known in (run, fitted.predict):
        with pytest.raises(InputError, match=r"^t = dates: must be times since t = 0 \(subtract"):
            known(dates)


@pytest.mark.parametrize(("method", "package"), [("dataframe", "pandas"), ("xarray", "xarray")])
def test_what_is_missing_is_named(method, package, monkeypatch):
    monkeypatch.setitem(sys.modules, package, None)
    rule = rf"needs {package} \(extra frames\): pip install 'rigidsym\[frames\]'"
    with pytest.raises(ImportError, match=rule):
        getattr(PAPER, f"to_{method}")([0.0])


def test_bad_times_are_named():
    pytest.importorskip("pandas", reason="needs pandas (extra frames)")
    with pytest.raises(InputError, match=r"^t\[1\] = nan"):
        PAPER.to_dataframe([0.0, float("nan")])
    with pytest.raises(InputError, match="must be one-dimensional"):
        PAPER.to_dataframe([[0.0]])
