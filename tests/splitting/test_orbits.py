"""Kepler's orbits obey Newton's law."""

import math

import numpy as np
import pytest

from rigidsym.errors import InputError
from rigidsym.splitting._orbits import KeplerOrbit, elliptic_anomaly, hyperbolic_anomaly

TILTED = {"inclination": 0.4, "node": 1.0, "argument": 2.0, "epoch": 0.5}


@pytest.mark.parametrize("eccentricity", [0.0, 0.3, 0.9, 1.1, 4.0])
@pytest.mark.parametrize("t", [0.5, 0.9, -3.0, 40.0])
def test_it_falls_as_newton_says(eccentricity, t):
    orbit = KeplerOrbit(3.0, 1.5, eccentricity, **TILTED)
    h = 1e-3
    before, now, after = (orbit.position(t + k * h) for k in (-1, 0, 1))
    pulled = -orbit.mu * now / np.linalg.norm(now) ** 3
    assert np.allclose((before - 2 * now + after) / h**2, pulled, rtol=0, atol=1e-5)


@pytest.mark.parametrize("eccentricity", [0.0, 0.3, 1.1, 4.0])
def test_it_is_nearest_at_its_epoch(eccentricity):
    orbit = KeplerOrbit(3.0, 1.5, eccentricity, **TILTED)
    nearest = np.linalg.norm(orbit.position(0.5))
    assert nearest == pytest.approx(1.5, rel=1e-15)
    assert all(np.linalg.norm(orbit.position(0.5 + t)) >= nearest for t in (-0.1, 0.1))


def test_an_ellipse_comes_back_and_a_hyperbola_does_not():
    ellipse = KeplerOrbit(3.0, 1.5, 0.3)
    assert np.allclose(ellipse.position(ellipse.period), ellipse.position(0), rtol=0, atol=1e-14)
    assert KeplerOrbit(3.0, 1.5, 1.3).period == math.inf


@pytest.mark.parametrize("e", [0.0, 0.1, 0.9, 0.999999])
@pytest.mark.parametrize("mean", [0.0, 1e-12, 0.3, -2.0, math.pi])
def test_elliptic_anomalies_solve_keplers_equation(mean, e):
    E = elliptic_anomaly(mean, e)
    assert E - e * math.sin(E) == pytest.approx(mean, abs=1e-15)


@pytest.mark.parametrize("e", [1.000001, 1.1, 5.0])
@pytest.mark.parametrize("mean", [0.0, 1e-12, 0.3, -2.0, 1e6])
def test_hyperbolic_anomalies_solve_theirs(mean, e):
    F = hyperbolic_anomaly(mean, e)
    assert e * math.sinh(F) - F == pytest.approx(mean, rel=1e-14, abs=1e-15)


@pytest.mark.parametrize(
    ("changes", "line"),
    [
        ({"mu": 0.0}, "^mu = 0.0: must be positive"),
        ({"periapsis": -1.0}, "^periapsis = -1.0: must be positive"),
        ({"eccentricity": 1.0}, "^eccentricity = 1.0: .*parabola"),
        ({"eccentricity": -0.1}, "^eccentricity = -0.1"),
        ({"node": math.nan}, "^node = nan: must be finite"),
    ],
)
def test_orbits_that_are_none_are_refused(changes, line):
    with pytest.raises(InputError, match=line):
        KeplerOrbit(**{"mu": 1.0, "periapsis": 1.0, **changes})
