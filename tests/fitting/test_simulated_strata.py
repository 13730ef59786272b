"""Simulated data sets of all strata: truths lie within the errors of the estimates.

The fall of chi2 from the truth to the estimate has the law of chi2 with as many degrees of freedom
as there are parameters.  It is tested at 1 % for all data sets of a stratum together.  Where the
motion is linear in its parameters over the errors, so are the estimates in units of their errors.
Unobservable quantities have to be named.  Slow tests take 1000 data sets of each stratum.
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
# The largest parts of data sets without a minimum, and with a quantity further from the truth than
# FAR of its errors.
MOST_WITHOUT, MOST_FAR, FAR = 0.01, 0.02, 5.0
# The slack of flat bodies, relative to the largest moment; they have a parameter less.
EDGE = 1e-8
CHANCE = 0.01


def motion(stratum, index):
    """Return a motion with rates of size 1 and a largest moment of 1; None at rest."""
    inertia, omega, attitude = (np.array(x, float) for x in draw(stratum, index, 23).exact)
    size = np.linalg.norm(omega)
    if not size:
        return None
    given = inertia / inertia.max(), omega / size, attitude
    return rigidsym.TorqueFreeMotion(*(x.tolist() for x in given))


def fitted(stratum, index):
    """Return the truth of a data set and its fit; None at rest."""
    truth = motion(stratum, index)
    if truth is None:
        return None
    random = np.random.default_rng([index, STRATA.index(stratum)])
    times = np.sort(random.uniform(0, 2 * np.pi * TURNS, LOOKS))
    seen = attitudes(truth, times, SIGMA, random)
    return truth, rigidsym.fit(times, attitudes=seen, sigma=SIGMA, guess=truth)


def agree(squares, least, most):
    """Return True if a sum of squares has the law of chi2, at 1 % on both sides.

    least, most: bounds of its degrees of freedom.
    """
    least = max(least, 1)
    return chi2.sf(squares, most) > CHANCE / 2 and chi2.cdf(squares, least) > CHANCE / 2


def free(stratum, fit):
    """Return bounds of the degrees of freedom by which chi2 falls.

    These are the number of observable parameters, less one for a flat body, and that of all.
    Spins have fewer, as they do not wobble.
    """
    if fit.spinning:
        return 4 if stratum == "spin" else 0, 4
    slack = np.sum(fit.moments) - 2 * np.max(fit.moments)
    return fit.observability.here.determined.shape[1] - bool(slack < EDGE * np.max(fit.moments)), 8


def apart(truth, fit):
    """Return the largest error of all quantities, in units of their standard deviations."""
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
        falls += np.sum(fit.problem.residuals(at_epoch(fit, truth)) ** 2) - fit.chi2
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


@pytest.mark.parametrize("count", [4, pytest.param(1000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("stratum", STRATA)
def test_estimates_lie_within_their_errors(stratum, count):
    examine(stratum, count)


def test_at_rest_no_ratio_is_told():
    times = np.linspace(0, 10, 20)
    still = rigidsym.TorqueFreeMotion((1, 0.8, 0.5), (0, 0, 0))
    seen = attitudes(still, times, SIGMA, np.random.default_rng(1))
    fit = rigidsym.fit(times, attitudes=seen, sigma=SIGMA, guess=still)
    assert fit.spinning
    assert sum(x.startswith("moment") for x in fit.unobservable) == 2
