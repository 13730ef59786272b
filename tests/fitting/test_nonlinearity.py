"""Intervals by profile likelihood, and flags where the covariance is overconfident."""

import json
from random import Random

import numpy as np
import pytest
from simulated import TUMBLING, fitted, rates

import rigidsym
from rigidsym.errors import InputError
from rigidsym.fitting import Modelled
from rigidsym.validate._fits import SIGMA, distance, simulated

NORMAL = 1.959963984540054


def drawn(truth, scatter, seed, looks=40, span=38.0, **arguments):
    random = np.random.default_rng(seed)
    times = np.sort(random.uniform(0, span, looks))
    return fitted(truth, times, scatter, random, **arguments)


def values(fit):
    """Estimates in the order of names."""
    turns = np.zeros(3)
    omega = np.array([float(x) for x in fit.motion.exact["omega0"]])
    return np.concatenate([turns, omega, fit.moments, turns])[: len(fit.names)]


@pytest.fixture(scope="module")
def ordinary():
    return drawn(TUMBLING, 1e-3, 2)


@pytest.fixture(scope="module")
def wobbling():
    """Turning about an equator of a nearly symmetric body: a product of two quantities shows."""
    truth = rigidsym.TorqueFreeMotion((0.5644, 1.0, 0.56441), (-0.0816, 1e-7, 0.9967))
    return truth, drawn(truth, SIGMA, 5, 30, 50.0)


def test_intervals_of_an_ordinary_fit_are_those_of_its_errors(ordinary):
    assert not ordinary.nonlinearity.flagged
    assert ordinary.nonlinearity.message == ""
    assert ordinary.nonlinearity.beyond == ordinary.nonlinearity.off == 0
    for level, errors in ((0.95, NORMAL), (0.6826894921370859, 1.0)):
        ends = ordinary.intervals(level) - values(ordinary)[:, None]
        expected = errors * ordinary.sigma[:, None] * np.array([-1, 1])
        assert ends == pytest.approx(expected, rel=0.03, abs=1e-15)
    assert np.array(json.loads(ordinary.to_json())["intervals"]) == pytest.approx(
        ordinary.intervals()
    )


def test_chi2_at_an_end_is_its_quantile_above_the_least(wobbling):
    """A rate held at an end by an observation of its own."""
    _, fit = wobbling
    assert fit.nonlinearity.flagged
    (seen,) = fit.problem.sets
    for name in ("omega 1", "omega 2", "omega 3"):
        place = fit.names.index(name)
        for end in fit.intervals()[place]:
            held = Modelled([0.0], [end], 1e-5, lambda q, w, k=place - 3: w[..., k])
            best = rigidsym.fit(attitudes=seen, models=held, guess=fit.motion)
            assert best.chi2 - fit.chi2 == pytest.approx(NORMAL**2, abs=0.06)


def test_a_ratio_that_a_wobble_of_its_error_shows_has_no_standard_deviation(wobbling):
    truth, fit = wobbling
    square, _ = distance(fit, truth)
    assert square > 80
    assert fit.nonlinearity.single == ("moment 2",)
    assert "NONLINEAR: the standard deviation misleads for moment 2" in repr(fit).splitlines()[0]
    place = fit.names.index("moment 2")
    # The unit is the first moment, by which the truth is far away.
    lower, upper = fit.intervals()[place] - values(fit)[place]
    assert upper > 2 * NORMAL * fit.sigma[place]
    assert lower < 0


def test_next_to_the_separatrix_the_covariance_as_a_whole_is_flagged():
    flagged = []
    for seed in range(6):
        case = simulated("separatrix", Random(seed))
        fit = rigidsym.fit(case.times, attitudes=case.seen, sigma=SIGMA, guess=case.truth)
        square, _ = distance(fit, case.truth)
        assert square < 26.1 or fit.nonlinearity.flagged
        flagged += [fit] if fit.nonlinearity.beyond > 0.25 else []
    assert flagged
    for fit in flagged:
        assert fit.nonlinearity.joint
        assert f"overconfident along {' with '.join(fit.nonlinearity.joint)}" in repr(fit)
        data = json.loads(fit.to_json())["nonlinearity"]
        assert data["flagged"]
        assert data["joint"] == list(fit.nonlinearity.joint)


def test_intervals_of_a_spin_are_linear():
    truth = TUMBLING.replace(omega0=(0.0, 0.0, 1.0))
    fit = drawn(truth, 1e-3, 3)
    assert fit.spinning
    assert not fit.nonlinearity.flagged
    told = np.isfinite(fit.sigma)
    ends = fit.intervals() - values(fit)[:, None]
    assert ends[told, 1] == pytest.approx(NORMAL * fit.sigma[told])
    assert np.isinf(ends[~told]).all()


@pytest.mark.parametrize(
    "arguments",
    [
        {"inertia": "tensor"},
        {"inertia": "known", "moments": [1.0, 0.85, 0.4]},
        {"loss": "cauchy"},
        {"scale": 5.0},
        {"moments": [3.0, 2.55, 1.2], "sigma": {"attitudes": 1e-3, "moments": [0.01] * 3}},
    ],
)
def test_intervals_are_linear_whatever_is_estimated(arguments):
    fit = drawn(TUMBLING, 1e-3, 8, 60, **arguments)
    assert not fit.nonlinearity.flagged
    ends = fit.intervals() - values(fit)[:, None]
    expected = NORMAL * fit.sigma[:, None] * np.array([-1, 1])
    assert ends == pytest.approx(expected, rel=0.05, abs=1e-12)


def test_rates_alone_have_intervals_of_what_they_tell():
    random = np.random.default_rng(7)
    t = np.linspace(0, 20, 40)
    fit = rigidsym.fit(t, rates=rates(TUMBLING, t, 1e-3, random), sigma=1e-3, guess=TUMBLING)
    ends = fit.intervals()
    assert np.isinf(ends[:3]).all()
    assert np.isfinite(ends[3:]).all()
    assert not fit.nonlinearity.flagged


@pytest.mark.parametrize("level", [0, 1, -0.5, 95])
def test_a_level_is_a_chance(ordinary, level):
    with pytest.raises(InputError, match=f"level = {level}: must be between 0 and 1"):
        ordinary.intervals(level)


def test_cases_are_the_same_whenever_they_are_drawn():
    one, other = (simulated("separatrix", Random(3)) for _ in range(2))
    assert np.array_equal(one.seen, other.seen)
