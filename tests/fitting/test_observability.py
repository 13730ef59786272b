"""Errors that are not linear ones: what hardly shows is said to, and what shows keeps its error."""

import numpy as np
import pytest
from simulated import fitted

import rigidsym
from rigidsym.fitting._observability import is_bent

SIGMA = 1e-4


def symmetric(omega, inertia):
    truth = rigidsym.TorqueFreeMotion((0.458, 1.0, 1.0), omega)
    random = np.random.default_rng(3)
    return fitted(truth, np.sort(random.uniform(0, 38, 40)), SIGMA, random, inertia=inertia)


def test_a_ratio_that_only_a_wobble_of_its_error_shows_is_not_told():
    """Turning about an equator of a symmetric body, the rate about its axis within its error of
    zero: their product is what is seen."""
    fit = symmetric((1e-6, 1.0, 0.3), "ratios")
    assert abs(fit.motion.exact["omega0"][0]) < 4 * fit.sigma[3]
    place = fit.names.index("moment 1")
    assert fit.sigma[place] > 0.3
    kept = [k for k, x in enumerate(fit.names) if not x.startswith("moment")]
    assert np.all(fit.sigma[kept] < 10 * SIGMA)


def test_a_ratio_that_a_wobble_shows_is_told():
    fit = symmetric((0.3, 1.0, 0.3), "ratios")
    assert fit.unobservable == ()
    assert np.all(fit.sigma < 10 * SIGMA)


def test_axes_of_equal_moments_are_not_told():
    fit = symmetric((0.3, 1.0, 0.3), "tensor")
    assert fit.converged
    about = [x for x in fit.unobservable if x.startswith("axes")]
    assert about == ["axes 1"]
    assert np.all(fit.predict(fit.problem.times).attitude_sigma < 10 * SIGMA)


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
    """On a separatrix, where doubles at t = 0 are another motion when the last are seen."""
    random = np.random.default_rng(index)
    truth = rigidsym.TorqueFreeMotion((1.0, 0.75, 0.5), (0.5, 0.0, 1.0), (1, 0, 0, 0))
    fit = fitted(truth, np.sort(random.uniform(0, 60, 60)), SIGMA, random)
    assert fit.converged
    assert fit.probability > 1e-3
    q, omega = fit.motion(fit.problem.times)
    again = fit.problem.state_residuals(fit.point, q, omega)
    assert again @ again == pytest.approx(fit.chi2, rel=1e-3)
