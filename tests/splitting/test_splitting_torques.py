"""Torques agree with their energies and axes; Kepler's orbits obey Newton's law."""

import math

import numpy as np
import pytest
from pushed_bodies import energy, gradient

from rigidsym.errors import InputError
from rigidsym.quaternions import of_rotation_vectors, product, rotated
from rigidsym.splitting import (
    ConstantInBody,
    ConstantInSpace,
    FieldPotential,
    GravityGradient,
    KeplerOrbit,
    Potential,
)
from rigidsym.splitting._orbits import elliptic_anomaly, hyperbolic_anomaly

INERTIA = np.array([[1.0, 2.0, 2.5], [4.0, 3.0, 2.0]])
Q = np.array([[0.1, -0.7, 0.5, 0.5], [0.5, 0.5, -0.5, 0.5]])
OMEGA = np.zeros((2, 3))
TILTED = {"inclination": 0.4, "node": 1.0, "argument": 2.0, "epoch": 0.5}


def slope(energy, t, q, small=1e-5):
    """Return how an energy falls with small rotations about the body's axes, (..., 3)."""
    turns = of_rotation_vectors(small * np.eye(3))
    ahead, back = (energy(t, product(q[..., None, :], x)) for x in (turns, turns * [1, -1, -1, -1]))
    return (back - ahead) / (2 * small)


@pytest.fixture(scope="module")
def unit():
    return Q / np.linalg.norm(Q, axis=-1, keepdims=True)


def test_a_potential_pushes_down_its_slope(unit):
    torque = Potential(gradient)(0.7, unit, OMEGA)
    assert np.allclose(torque, slope(energy, 0.7, unit), rtol=0, atol=1e-9)


@pytest.mark.parametrize("eccentricity", [0.0, 0.4, 2.0])
def test_gravity_pushes_down_its_slope(unit, eccentricity):
    orbit = KeplerOrbit(3.0, 1.5, eccentricity, **TILTED)
    tide = GravityGradient(INERTIA, orbit)
    per_body = GravityGradient(INERTIA[:, None], orbit)
    torque = tide(1.4, unit, OMEGA)
    assert np.max(np.abs(torque)) > 0.1
    assert np.allclose(torque, slope(per_body.energy, 1.4, unit), rtol=0, atol=1e-8)


def test_a_field_pushes_down_its_slope(unit):
    quadratic = np.array([[0.3, 0.1, 0.0], [0.1, -0.2, 0.4], [0.0, 0.4, 0.1]])
    field = FieldPotential((0.2, 0.3, 1.0), linear=(0.1, 0.2, 0.3), quadratic=quadratic)
    torque = field(0.0, unit, OMEGA)
    assert np.max(np.abs(torque)) > 0.1
    assert np.allclose(torque, slope(field.energy, 0.0, unit), rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("make", "line"),
    [
        (lambda: FieldPotential((1.0, 2.0)), r"field = an array of shape \(2,\)"),
        (lambda: FieldPotential((0, 0, 1), quadratic=np.zeros((2, 3))),
         r"quadratic = an array of shape \(2, 3\): must be \(..., 3, 3\)"),
        (lambda: FieldPotential((0, 0, 1), quadratic=np.triu(np.ones((3, 3)))),
         "quadratic = .*must be symmetric"),
        *((lambda x=x: x([1.0, 2.0]), r"torque = an array of shape \(2,\)")
          for x in (ConstantInBody, ConstantInSpace)),
        (lambda: KeplerOrbit(0.0, 1.0), "mu = 0.0: must be positive"),
        (lambda: KeplerOrbit(1.0, -1.0), "periapsis = -1.0: must be positive"),
        (lambda: KeplerOrbit(1.0, 1.0, 1.0), "eccentricity = 1.0: .*parabola"),
        (lambda: KeplerOrbit(1.0, 1.0, -0.1), "eccentricity = -0.1"),
        (lambda: KeplerOrbit(1.0, 1.0, node=math.nan), "node = nan: must be finite"),
    ],
)  # fmt: skip
def test_fields_torques_and_orbits_that_are_none_are_refused(make, line):
    with pytest.raises(InputError, match=f"^{line}"):
        make()


def test_a_sphere_feels_no_tide(unit):
    tide = GravityGradient((2.0, 2.0, 2.0), KeplerOrbit(1.0, 1.0, 0.3))
    assert np.array_equal(tide(0.3, unit, OMEGA), np.zeros((2, 3)))


def test_a_body_whose_axis_points_down_feels_no_tide():
    tide = GravityGradient(INERTIA[0], KeplerOrbit(1.0, 1.0))
    assert np.array_equal(tide(0.0, np.array([1.0, 0, 0, 0]), OMEGA[0]), np.zeros(3))


def test_constant_torques_are_constant_in_their_axes(unit):
    given = np.array([0.1, -0.2, 0.3])
    assert np.array_equal(ConstantInBody(given)(0.0, unit, OMEGA), [given, given])
    inertial = rotated(unit, ConstantInSpace(given)(0.0, unit, OMEGA))
    assert np.allclose(inertial, given, rtol=0, atol=1e-15)


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
