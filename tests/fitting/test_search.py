"""Searches for all minima, from observations alone."""

import numpy as np
import pytest
from simulated import TUMBLING, attitudes, drawn, fitted, is_true, rates

import rigidsym
from rigidsym.fitting import Directions, Rates
from rigidsym.fitting._starts import _FRAMES, tops
from rigidsym.quaternions import conjugate, rotated

SIGMA = 0.02


def test_tops_of_a_grid_have_the_rates_of_the_symmetric_body_seen():
    top = rigidsym.TorqueFreeMotion((3.1, 3.1, 1.0), (0.25, 0.58, -1.72))
    t = np.sort(np.random.default_rng(0).uniform(0, 16, 17))
    q, _ = top(t)
    momentum = np.linalg.norm([3.1 * 0.25, 3.1 * 0.58, 1.72])
    precession = momentum / 3.1
    found = tops(q, t, 3.0, _FRAMES, np.array([precession / 2, precession, 1.72 - 1.72 / 3.1]))
    best = int(np.argmin(found.misfit))
    assert found.misfit[best] < 1e-12
    assert found.axis[best] == 2
    assert found.ratio[best] == pytest.approx(3.1)
    assert found.omega[best] == pytest.approx(top(3.0)[1], abs=1e-9)


def test_sparse_attitudes_are_enough():
    """The body turns by some 80 degrees between observations."""
    fit = drawn(TUMBLING, SIGMA, 1, 17, 24, guess=None, starts=1000)
    assert fit.converged
    assert is_true(fit)


def test_looks_at_equal_times_have_alternatives():
    """Observations at equal times allow any number of whole turns between them."""
    asked = {"guess": None, "starts": 1000, "fastest": 4.0, "delta_chi2": 20}
    fit = fitted(TUMBLING, 2.0 * np.arange(14), SIGMA, 2, **asked)
    every = [fit, *fit.alternatives]
    assert len(every) > 1
    assert np.all(np.diff([one.chi2 for one in every]) > -1e-9)
    assert all(one.chi2 <= fit.chi2 + 20 for one in every)
    periods = [one.periods.rotation for one in every]
    assert min(abs(x - TUMBLING.period) for x in periods) < 0.1 * TUMBLING.period
    omega = [np.array(one.motion.omega0, float) for one in every]
    assert all(np.linalg.norm(a - b) > 1e-3 for k, a in enumerate(omega) for b in omega[:k])


def test_rates_need_no_attitudes():
    t = np.linspace(0, 20, 40)
    seen = rates(TUMBLING, t, SIGMA, np.random.default_rng(3))
    fit = rigidsym.fit(t, rates=seen, sigma=SIGMA, starts=500)
    assert fit.moments == pytest.approx([1, 0.85, 0.4], abs=0.05)
    assert fit.probability > 1e-3


def test_two_stars_are_enough():
    random = np.random.default_rng(4)
    t = np.linspace(0, 12, 25)
    q, _ = TUMBLING(t)
    sets = []
    for star in np.array([[0.0, 0.6, 0.8], [1.0, 0.0, 0.0]]):
        seen = rotated(conjugate(q), star) + SIGMA * random.normal(size=(25, 3))
        sets.append(Directions(t, seen, SIGMA, star))
    assert is_true(rigidsym.fit(vectors=sets, starts=2000, fastest=2.0))


def test_long_series_are_taken_by_stages():
    """Over many turns, the search starts from an arc in which the grid resolves the periods."""
    t = np.concatenate([np.linspace(0, 12, 30), np.linspace(300, 320, 20)])
    steps, seen = [], attitudes(TUMBLING, t, SIGMA, np.random.default_rng(5))
    fit = rigidsym.fit(
        t, attitudes=seen, sigma=SIGMA, starts=500, progress=lambda *at: steps.append(at)
    )
    assert is_true(fit)
    assert steps[-1][0] == steps[-1][1]
    assert [x for x, _ in steps] == sorted(x for x, _ in steps)


def test_errors_do_not_lead_a_robust_search_astray():
    t = np.linspace(0, 12, 30)
    seen = rates(TUMBLING, t, SIGMA, np.random.default_rng(6))
    seen[7] = -seen[7]
    fit = rigidsym.fit(rates=Rates(t, seen, SIGMA), loss="cauchy", starts=200)
    assert fit.outliers == ((0, 7),)
    assert fit.moments == pytest.approx([1, 0.85, 0.4], abs=0.08)
