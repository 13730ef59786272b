"""Intervals by profile likelihood, and errors that are not linear."""

import json
from random import Random

import numpy as np
import pytest
from simulated import TUMBLING, drawn, rates

import rigidsym
from rigidsym.errors import InputError
from rigidsym.fitting import Modelled
from rigidsym.fitting._observability import is_bent
from rigidsym.validate._fits import SIGMA, distance, simulated

NORMAL = 1.959963984540054
FINE = 1e-4


def values(fit):
    """Return the estimates in the order of `names`."""
    omega = np.array(fit.motion.exact["omega0"], float)
    return np.concatenate([np.zeros(3), omega, fit.moments, np.zeros(3)])[: len(fit.names)]


def ends(fit, level=0.95):
    """Return the ends of the intervals, less the estimates."""
    return fit.intervals(level) - values(fit)[:, None]


def linear(fit):
    """Return the ends by the standard deviations, less the estimates."""
    return NORMAL * fit.sigma[:, None] * np.array([-1, 1])


@pytest.fixture(scope="module")
def ordinary():
    return drawn(TUMBLING, 1e-3, 2)


@pytest.fixture(scope="module")
def wobbling():
    """Return a nearly symmetric body turning about its equator, which shows a product alone."""
    truth = rigidsym.TorqueFreeMotion((0.5644, 1.0, 0.56441), (-0.0816, 1e-7, 0.9967))
    return truth, drawn(truth, SIGMA, 5, 30, 50.0)


def test_intervals_of_an_ordinary_fit_are_those_of_its_errors(ordinary):
    assert not ordinary.nonlinearity.flagged
    assert ordinary.nonlinearity.message == ""
    assert ordinary.nonlinearity.beyond == ordinary.nonlinearity.off == 0
    for level, errors in ((0.95, NORMAL), (0.6826894921370859, 1.0)):
        expected = errors / NORMAL * linear(ordinary)
        assert ends(ordinary, level) == pytest.approx(expected, rel=0.03, abs=1e-15)
    written = json.loads(ordinary.to_json())["intervals"]
    assert np.array(written) == pytest.approx(ordinary.intervals())


def test_chi2_at_an_end_is_its_quantile_above_the_least(wobbling):
    """An observation of the rate holds it at the end of its interval."""
    _, fit = wobbling
    assert fit.nonlinearity.flagged
    (seen,) = fit.problem.sets
    for k, both in enumerate(fit.intervals()[3:6]):
        for end in both:
            held = Modelled([0.0], [end], 1e-5, lambda q, w, k=k: w[..., k])
            best = rigidsym.fit(attitudes=seen, models=held, guess=fit.motion)
            assert best.chi2 - fit.chi2 == pytest.approx(NORMAL**2, abs=0.06)


def test_a_ratio_that_a_wobble_of_its_error_shows_has_no_standard_deviation(wobbling):
    truth, fit = wobbling
    assert distance(fit, truth)[0] > 80
    assert fit.nonlinearity.single == ("moment 2",)
    assert "NONLINEAR: the standard deviation misleads for moment 2" in repr(fit).splitlines()[0]
    place = fit.names.index("moment 2")
    # The unit is the first moment, by which the truth is far away.
    lower, upper = ends(fit)[place]
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
    fit = drawn(TUMBLING.replace(omega0=(0.0, 0.0, 1.0)), 1e-3, 3)
    assert fit.spinning
    assert not fit.nonlinearity.flagged
    told = np.isfinite(fit.sigma)
    assert ends(fit)[told, 1] == pytest.approx(NORMAL * fit.sigma[told])
    assert np.isinf(ends(fit)[~told]).all()


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
    assert ends(fit) == pytest.approx(linear(fit), rel=0.05, abs=1e-12)


def test_rates_alone_have_intervals_of_what_they_tell():
    t = np.linspace(0, 20, 40)
    seen = rates(TUMBLING, t, 1e-3, np.random.default_rng(7))
    fit = rigidsym.fit(t, rates=seen, sigma=1e-3, guess=TUMBLING)
    assert np.isinf(fit.intervals()[:3]).all()
    assert np.isfinite(fit.intervals()[3:]).all()
    assert not fit.nonlinearity.flagged


@pytest.mark.parametrize("level", [0, 1, -0.5, 95])
def test_a_level_is_a_chance(ordinary, level):
    with pytest.raises(InputError, match=f"level = {level}: must be between 0 and 1"):
        ordinary.intervals(level)


def test_cases_are_the_same_whenever_they_are_drawn():
    one, other = (simulated("separatrix", Random(3)) for _ in range(2))
    assert np.array_equal(one.seen, other.seen)


def symmetric(omega, inertia):
    return drawn(rigidsym.TorqueFreeMotion((0.458, 1.0, 1.0), omega), FINE, 3, inertia=inertia)


def test_a_ratio_that_only_a_wobble_of_its_error_shows_is_not_told():
    """The body turns about its equator; its rate about the axis is zero within the error."""
    fit = symmetric((1e-6, 1.0, 0.3), "ratios")
    assert abs(fit.motion.exact["omega0"][0]) < 4 * fit.sigma[3]
    place = fit.names.index("moment 1")
    assert fit.sigma[place] > 0.3
    kept = [k for k, x in enumerate(fit.names) if not x.startswith("moment")]
    assert np.all(fit.sigma[kept] < 10 * FINE)


def test_a_ratio_that_a_wobble_shows_is_told():
    fit = symmetric((0.3, 1.0, 0.3), "ratios")
    assert fit.unobservable == ()
    assert np.all(fit.sigma < 10 * FINE)


def test_axes_of_equal_moments_are_not_told():
    fit = symmetric((0.3, 1.0, 0.3), "tensor")
    assert fit.converged
    about = [x for x in fit.unobservable if x.startswith("axes")]
    assert about == ["axes 1"]
    assert np.all(fit.predict(fit.problem.times).attitude_sigma < 10 * FINE)


def test_products_of_errors_count_where_they_are_larger():
    sigma = np.full(12, 1e-3)
    omega = np.array([1.0, 0.0, 0.0])
    assert not is_bent(sigma, omega).any()
    sigma[[10, 11]] = np.inf
    bent = is_bent(sigma, omega)
    assert np.flatnonzero(bent).tolist() == [0, 3, 9]
    assert is_bent(np.where(np.isinf(sigma), 0.05, sigma), omega)[3]


@pytest.mark.parametrize("index", [0, 1])
def test_a_motion_has_the_digits_that_observations_tell(index):
    """On a separatrix, a state at t = 0 in doubles leads to another motion in the end."""
    truth = rigidsym.TorqueFreeMotion((1.0, 0.75, 0.5), (0.5, 0.0, 1.0), (1, 0, 0, 0))
    fit = drawn(truth, FINE, index, 60, 60)
    assert fit.converged
    assert fit.probability > 1e-3
    q, omega = fit.motion(fit.problem.times)
    again = fit.problem.state_residuals(fit.point, q, omega)
    assert again @ again == pytest.approx(fit.chi2, rel=1e-3)
