"""Checks that a fit's errors agree with its covariance, or that the fit gives a warning.

Either the Mahalanobis distance of the true quantities is small by the covariance of the fit, or
the fit flags its covariance.  A share is the square of that distance over the value that chi2 of as
many degrees of freedom exceeds in one case of a thousand.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from random import Random

import numpy as np

from rigidsym.fitting import Fit, fit
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotation_vectors
from rigidsym.validate._applications import Application, Goal
from rigidsym.validate.strata import STRATA

SIGMA = 0.02
"Of simulated attitudes, rad about each axis."
_OBSERVATIONS, _TURNS = (20, 40), (4.0, 8.0)
_CHANCE = 1e-3
_STARTS, _FASTEST = 300, 2.0
# Of the largest eigenvalue of a correlation matrix: below it there is rounding.
_RANK = 1e-9


@dataclass(frozen=True, slots=True)
class Case:
    """A motion and simulated observations of its attitude.

    The rates are of size 1 and the largest moment is 1.  Attitudes (N, 4) are seen at times (N,),
    s, with errors of `SIGMA`.
    """

    truth: TorqueFreeMotion
    times: np.ndarray
    seen: np.ndarray


def simulated(stratum: str, random: Random) -> Case:
    """Draw a random motion of a stratum, and simulate observations of its attitude."""
    body = STRATA[stratum].body(random, random.randrange(100))
    inertia, omega = (np.array([float(x) for x in y]) for y in (body.inertia, body.omega0))
    moments, rates = inertia / np.max(inertia), omega / np.linalg.norm(omega)
    attitude = [random.gauss(0, 1) for _ in range(4)]
    truth = TorqueFreeMotion(moments.tolist(), rates.tolist(), attitude)
    numbers = np.random.default_rng(random.getrandbits(64))
    times = np.sort(
        numbers.uniform(0, 2 * np.pi * numbers.uniform(*_TURNS), random.randint(*_OBSERVATIONS))
    )
    q, _ = truth(times)
    errors = of_rotation_vectors(SIGMA * numbers.normal(size=(times.size, 3)))
    return Case(truth, times, product(q, errors))


def measured(case: Case) -> float | None:
    """Fit a case, and return the ratio of the fit's squared error to the allowed value.

    The error is the Mahalanobis distance of the true motion.  Returns None where the fit warns: by
    a flag, by residuals that are too large, or by other motions that fit as well.
    """
    found = fit(case.times, attitudes=case.seen, sigma=SIGMA, starts=_STARTS, fastest=_FASTEST)
    said = found.agreement.message or found.nonlinearity.flagged or found.alternatives
    if said or not found.converged:
        return None
    from scipy.stats import chi2

    square, freedom = distance(found, case.truth)
    return square / float(chi2.isf(_CHANCE, freedom)) if freedom else 0.0


def distance(found: Fit, truth: TorqueFreeMotion) -> tuple[float, int]:
    """Return the squared Mahalanobis distance of a fit from the truth.

    The second result is the number of degrees of freedom.  The distance is that of all quantities
    that have standard deviations.
    """
    moments, omega, attitude = (np.array(x, float) for x in truth.exact.values())
    q, rates = found.motion(0.0)
    turn = rotation_vectors(product(attitude / np.linalg.norm(attitude), conjugate(q)))
    unit = moments[np.argmax(found.moments)]
    apart = np.concatenate([turn, omega - rates, moments / unit - found.moments])
    told = np.isfinite(found.sigma) & (found.sigma > 0)
    sigma = found.sigma[told]
    correlation = found.covariance[np.ix_(told, told)] / np.outer(sigma, sigma)
    sizes, vectors = np.linalg.eigh(correlation)
    kept = sizes > _RANK * np.max(sizes, initial=0.0)
    along = (apart[told] / sigma) @ vectors[:, kept]
    return float(np.sum(along**2 / sizes[kept])), int(np.sum(kept))


# Any body and rates for comparison, and where linear errors may bend.
_STRATA = (
    *("uniform", "near separatrix", "separatrix", "near prolate", "near oblate", "symmetric"),
    *("near sphere", "near spin, middle", "near spin, smallest", "flat"),
)
_DRAWN: dict[str, Callable[[Random], Case]] = {x: partial(simulated, x) for x in _STRATA}
APPLICATION = Application(
    "fits", _DRAWN, measured, Goal(refused=1.0, most=1.0, part=0.99, worst=2.0)
)
