"""Torques are what their energies and their axes say."""

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

INERTIA = np.array([[1.0, 2.0, 2.5], [4.0, 3.0, 2.0]])
Q = np.array([[0.1, -0.7, 0.5, 0.5], [0.5, 0.5, -0.5, 0.5]])
OMEGA = np.zeros((2, 3))


def slope(energy, t, q, small=1e-5):
    """How an energy falls with small rotations about the body's axes, (..., 3)."""
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
    orbit = KeplerOrbit(3.0, 1.5, eccentricity, inclination=0.4, node=1.0, argument=2.0)
    tide = GravityGradient(INERTIA, orbit)
    per_body = GravityGradient(INERTIA[:, None], orbit)
    torque = tide(0.9, unit, OMEGA)
    assert np.max(np.abs(torque)) > 0.1
    assert np.allclose(torque, slope(per_body.energy, 0.9, unit), rtol=0, atol=1e-8)


def test_a_field_pushes_down_its_slope(unit):
    quadratic = np.array([[0.3, 0.1, 0.0], [0.1, -0.2, 0.4], [0.0, 0.4, 0.1]])
    field = FieldPotential((0.2, 0.3, 1.0), linear=(0.1, 0.2, 0.3), quadratic=quadratic)
    torque = field(0.0, unit, OMEGA)
    assert np.max(np.abs(torque)) > 0.1
    assert np.allclose(torque, slope(field.energy, 0.0, unit), rtol=0, atol=1e-9)


BAD_FIELDS = {
    "a short field": (((1.0, 2.0),), {}, r"^field = an array of shape \(2,\)"),
    "a matrix of two rows": (
        ((0, 0, 1),),
        {"quadratic": np.zeros((2, 3))},
        r"^quadratic = an array of shape \(2, 3\): must be \(..., 3, 3\)",
    ),
    "a matrix that is not symmetric": (
        ((0, 0, 1),),
        {"quadratic": np.triu(np.ones((3, 3)))},
        "^quadratic = .*must be symmetric",
    ),
}


@pytest.mark.parametrize(("field", "more", "line"), BAD_FIELDS.values(), ids=BAD_FIELDS)
def test_a_field_that_is_none_is_refused(field, more, line):
    with pytest.raises(InputError, match=line):
        FieldPotential(*field, **more)


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


@pytest.mark.parametrize("make", [ConstantInBody, ConstantInSpace])
def test_a_vector_that_is_none_is_refused(make):
    with pytest.raises(InputError, match=r"^torque = an array of shape \(2,\)"):
        make([1.0, 2.0])
