"""Simulated observations of known motions, and distances of fits from the truth."""

import numpy as np
import pytest

import rigidsym
from rigidsym.errors import InputError
from rigidsym.fitting._parameters import Point
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotation_vectors

# Long-axis mode, triaxial, of about two turns.
TUMBLING = rigidsym.TorqueFreeMotion((1.0, 0.85, 0.4), (0.3, -0.5, 1.1), (0.5, 0.1, -0.3, 0.8))


def attitudes(motion, times, sigma, random):
    """Return simulated quaternions (N, 4) of a motion, with random errors and signs."""
    q, _ = motion(times)
    turned = product(q, of_rotation_vectors(sigma * random.normal(size=(len(times), 3))))
    return turned * random.choice([-1.0, 1.0], size=(len(times), 1))


def rates(motion, times, sigma, random):
    """Return simulated rates (N, 3) of a motion, with random errors."""
    return motion(times)[1] + sigma * random.normal(size=(len(times), 3))


def fitted(truth, times, scatter, seed, **arguments):
    """Fit simulated attitudes, starting from the truth unless `guess` is given."""
    seen = attitudes(truth, times, scatter, np.random.default_rng(seed))
    arguments = {"sigma": scatter, "guess": truth, **arguments}
    return rigidsym.fit(times, attitudes=seen, **arguments)


def drawn(truth, scatter, seed, looks=40, span=38.0, **arguments):
    """Fit simulated attitudes at random times."""
    random = np.random.default_rng(seed)
    times = np.sort(random.uniform(0, span, looks))
    return fitted(truth, times, scatter, random, **arguments)


def at_epoch(fit, truth):
    """Return the true state at the epoch of a fit, as a point of its problem."""
    q, omega = truth(fit.problem.epoch)
    return Point(q, omega, np.array(truth.exact["inertia"], float), np.eye(4)[0])


def told(fit, truth):
    """Return the deviations (k,) of a fit from the truth, in standard errors.

    They are along all observable directions.
    """
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


def is_true(fit, most=30):
    """Return True if a fit of TUMBLING is probable and agrees with the truth within errors."""
    return fit.probability > 1e-3 and np.sum(told(fit, TUMBLING) ** 2) < most


def refused(make, message):
    """Check that a call raises an InputError of one line that contains a message."""
    with pytest.raises(InputError) as error:
        make()
    assert message in str(error.value)
    assert "\n" not in str(error.value)
