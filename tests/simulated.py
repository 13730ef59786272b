"""Observations of known motions, with errors drawn, and how far a fit is from the truth."""

import numpy as np

import rigidsym
from rigidsym.fitting._parameters import Point
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotation_vectors

# Long-axis mode, triaxial, of about two turns.
TUMBLING = rigidsym.TorqueFreeMotion((1.0, 0.85, 0.4), (0.3, -0.5, 1.1), (0.5, 0.1, -0.3, 0.8))


def attitudes(motion, times, sigma, random):
    """Quaternions (N, 4) with errors, of either sign."""
    q, _ = motion(times)
    turned = product(q, of_rotation_vectors(sigma * random.normal(size=(len(times), 3))))
    return turned * random.choice([-1.0, 1.0], size=(len(times), 1))


def rates(motion, times, sigma, random):
    """(N, 3) with errors."""
    return motion(times)[1] + sigma * random.normal(size=(len(times), 3))


def fitted(truth, times, scatter, seed, **arguments):
    """The fit of attitudes with errors drawn, from the truth unless `guess` says otherwise."""
    seen = attitudes(truth, times, scatter, np.random.default_rng(seed))
    arguments = {"sigma": scatter, "guess": truth, **arguments}
    return rigidsym.fit(times, attitudes=seen, **arguments)


def at_epoch(fit, truth):
    """The truth as a point of the problem of a fit."""
    q, omega = truth(fit.problem.epoch)
    return Point(q, omega, np.array(truth.exact["inertia"], float), np.eye(4)[0])


def told(fit, truth):
    """How far a fit is from the truth in each direction it tells, in units of its error: (k,)."""
    there, here = at_epoch(fit, truth), fit.observability.here
    apart = np.empty(fit.problem.parameters.count)
    apart[:3] = rotation_vectors(product(fit.point.attitude, conjugate(there.attitude)))
    apart[3:6] = fit.point.omega - there.omega
    across = fit.problem.parameters.linear_derivatives(fit.point)[6:9, 6:8]
    scaled = fit.moments - there.moments * (fit.moments.max() / there.moments.max())
    apart[6:8] = np.linalg.lstsq(np.column_stack([across, fit.moments]), scaled, rcond=None)[0][:2]
    return np.linalg.lstsq(np.hstack([here.determined, here.undetermined]), apart, rcond=None)[0][
        : here.determined.shape[1]
    ]
