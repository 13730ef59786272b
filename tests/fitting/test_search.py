"""Searches: from nothing but observations to all minima."""

import numpy as np
import pytest
from simulated import TUMBLING, attitudes, fitted, rates, told

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
    """Seventeen looks, each some 80 degrees after the last."""
    random = np.random.default_rng(1)
    t = np.sort(random.uniform(0, 24, 17))
    fit = fitted(TUMBLING, t, SIGMA, random, guess=None, starts=1000)
    assert fit.converged
    assert fit.probability > 1e-3
    assert np.sum(told(fit, TUMBLING) ** 2) < 30


def test_looks_at_equal_times_have_alternatives():
    """Nothing tells a turn from one that is whole turns more between looks."""
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
    random = np.random.default_rng(3)
    t = np.linspace(0, 20, 40)
    seen = rates(TUMBLING, t, SIGMA, random)
    fit = rigidsym.fit(t, rates=seen, sigma=SIGMA, starts=500)
    assert fit.moments == pytest.approx([1, 0.85, 0.4], abs=0.05)
    assert fit.probability > 1e-3


def test_two_stars_are_enough():
    random = np.random.default_rng(4)
    t = np.linspace(0, 12, 25)
    q, _ = TUMBLING(t)
    stars = np.array([[0.0, 0.6, 0.8], [1.0, 0.0, 0.0]])
    seen = [
        Directions(
            t, rotated(conjugate(q), star) + SIGMA * random.normal(size=(25, 3)), SIGMA, star
        )
        for star in stars
    ]
    fit = rigidsym.fit(vectors=seen, starts=2000, fastest=2.0)
    assert fit.probability > 1e-3
    assert np.sum(told(fit, TUMBLING) ** 2) < 30


def test_long_series_are_taken_by_stages():
    """Many turns: an arc first, whose periods the grid tells apart, then all."""
    random = np.random.default_rng(5)
    t = np.concatenate([np.linspace(0, 12, 30), np.linspace(300, 320, 20)])
    seen = attitudes(TUMBLING, t, SIGMA, random)
    steps = []
    fit = rigidsym.fit(
        t, attitudes=seen, sigma=SIGMA, starts=500, progress=lambda *at: steps.append(at)
    )
    assert fit.probability > 1e-3
    assert np.sum(told(fit, TUMBLING) ** 2) < 30
    assert steps[-1][0] == steps[-1][1]
    assert [x for x, _ in steps] == sorted(x for x, _ in steps)


def test_errors_do_not_lead_a_robust_search_astray():
    random = np.random.default_rng(6)
    t = np.linspace(0, 12, 30)
    seen = rates(TUMBLING, t, SIGMA, random)
    seen[7] = -seen[7]
    fit = rigidsym.fit(rates=Rates(t, seen, SIGMA), loss="cauchy", starts=200)
    assert fit.outliers == ((0, 7),)
    assert fit.moments == pytest.approx([1, 0.85, 0.4], abs=0.08)
