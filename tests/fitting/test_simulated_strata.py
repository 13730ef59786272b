"""Simulated data sets of strata: estimates lie within their errors, and nothing is made up.

Truths lie within regions of confidence: what chi2 falls by, from the truth to the estimate, is chi2
of as many degrees of freedom as there are parameters, tested at 1 % for all data sets of a stratum
together.  Where the motion is linear in its parameters over the errors, so are the estimates in
units of theirs.  What cannot be told has to be said.  Some data sets of each by default, 1000 where
tests are slow.
"""

import numpy as np
import pytest
from scipy.stats import chi2
from simulated import at_epoch, attitudes, told

import rigidsym
from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.validate.strata import draw

SIGMA, LOOKS, TURNS = 1e-4, 40, 6.0
STRATA = ("uniform", "near separatrix", "separatrix", "symmetric", "near prolate", "near oblate",
          "sphere", "near sphere", "spin", "flat", "near spin, largest", "near spin, middle",
          "near spin, smallest")  # fmt: skip
# Near the others' edges errors that one direction has move others by more than their own.
LINEAR = ("uniform", "sphere", "near sphere")
# Of data sets: those of which it is said that there was no minimum, and those of which a quantity
# is further from the truth than FAR of its errors.
MOST_WITHOUT, MOST_FAR, FAR = 0.01, 0.02, 5.0
# Of the largest moment: what is left to bodies that end there, where a parameter less is free.
EDGE = 1e-8
CHANCE = 0.01


def motion(stratum, index):
    """One of a stratum, with rates of size 1 and a largest moment of 1; None at rest."""
    inertia, omega, attitude = (np.array(x, float) for x in draw(stratum, index, 23).exact)
    size = np.linalg.norm(omega)
    if not size:
        return None
    moments = inertia / inertia.max()
    return rigidsym.TorqueFreeMotion(moments.tolist(), (omega / size).tolist(), attitude.tolist())


def fitted(stratum, index):
    """The truth of a data set, and what is fitted to it."""
    truth = motion(stratum, index)
    if truth is None:
        return None
    random = np.random.default_rng([index, STRATA.index(stratum)])
    times = np.sort(random.uniform(0, 2 * np.pi * TURNS, LOOKS))
    seen = attitudes(truth, times, SIGMA, random)
    return truth, rigidsym.fit(times, attitudes=seen, sigma=SIGMA, guess=truth)


def fall(truth, fit):
    """Of chi2, from the truth to the estimate."""
    return np.sum(fit.problem.residuals(at_epoch(fit, truth)) ** 2) - fit.chi2


def agree(squares, least, most):
    """Whether a sum of squares is chi2 of so many degrees of freedom, at 1 %, on both sides."""
    least = max(least, 1)
    return chi2.sf(squares, most) > CHANCE / 2 and chi2.cdf(squares, least) > CHANCE / 2


def free(stratum, fit):
    """How many parameters chi2 falls by, at least and at most: those that are told, less one at
    the edge of what bodies can be, and all.  A wobble that a spin does not have makes it less."""
    if fit.spinning:
        return 4 if stratum == "spin" else 0, 4
    slack = np.sum(fit.moments) - 2 * np.max(fit.moments)
    return fit.observability.here.determined.shape[1] - bool(slack < EDGE * np.max(fit.moments)), 8


def apart(truth, fit):
    """The largest error of a quantity that has one, in units of it."""
    moments, omega, attitude = (np.array(x, float) for x in truth.exact.values())
    q, rates = fit.motion(0.0)
    turn = rotation_vectors(product(q, conjugate(attitude / np.linalg.norm(attitude))))
    unit = moments[np.argmax(fit.moments)]
    found = np.concatenate([turn, rates - omega, fit.moments - moments / unit])
    told = np.isfinite(fit.sigma) & (fit.sigma > 0)
    return np.max(np.abs(found[told]) / fit.sigma[told])


def examine(stratum, count):
    falls, least, most, squares, directions, without, far = 0.0, 0, 0, 0.0, 0, 0, 0
    for truth, fit in filter(None, (fitted(stratum, k) for k in range(count))):
        if not fit.converged:
            without += 1
            continue
        falls += fall(truth, fit)
        bounds = free(stratum, fit)
        least, most = least + bounds[0], most + bounds[1]
        far += apart(truth, fit) > FAR
        own = told(fit, truth)
        squares += own @ own
        directions += len(own)
        if fit.spinning:
            assert sum(x.startswith("moment") for x in fit.unobservable) == 2
        elif stratum in LINEAR:
            assert fit.unobservable == ()
        assert fit.spinning or stratum != "spin"
    assert without <= MOST_WITHOUT * count
    assert far <= MOST_FAR * count
    assert agree(falls, least, most), (falls, least, most)
    if stratum in LINEAR:
        assert agree(squares, directions, directions), (squares, directions)


@pytest.mark.parametrize("stratum", STRATA)
def test_estimates_lie_within_their_errors(stratum):
    examine(stratum, 4)


@pytest.mark.slow
@pytest.mark.parametrize("stratum", STRATA)
def test_a_thousand_estimates_lie_within_their_errors(stratum):
    examine(stratum, 1000)


def test_at_rest_no_ratio_is_told():
    times = np.linspace(0, 10, 20)
    still = rigidsym.TorqueFreeMotion((1, 0.8, 0.5), (0, 0, 0))
    seen = attitudes(still, times, SIGMA, np.random.default_rng(1))
    fit = rigidsym.fit(times, attitudes=seen, sigma=SIGMA, guess=still)
    assert fit.spinning
    assert sum(x.startswith("moment") for x in fit.unobservable) == 2
