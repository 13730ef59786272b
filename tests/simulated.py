"""Observations of known motions, with errors drawn, and how far a fit is from the truth."""

import numpy as np

import rigidsym
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


def told(fit, truth):
    """How far a fit is from the truth in each direction it tells, in units of its error: (k,)."""
    moments, omega, attitude = (np.array(x, float) for x in truth.exact.values())
    turn = product(np.array(fit.motion.exact["attitude0"], float), conjugate(attitude))
    apart = np.empty(fit.problem.parameters.count)
    apart[:3] = rotation_vectors(turn / np.linalg.norm(turn))
    apart[3:6] = np.array(fit.motion.exact["omega0"], float) - omega
    across = fit.problem.parameters.linear(fit._point)[6:9, 6:8]
    scaled = fit.moments - moments * (fit.moments.max() / moments.max())
    apart[6:8] = np.linalg.lstsq(np.column_stack([across, fit.moments]), scaled, rcond=None)[0][:2]
    return np.linalg.lstsq(
        np.hstack([fit.observability.told, fit.observability.blind]), apart, rcond=None
    )[0][: fit.observability.told.shape[1]]
