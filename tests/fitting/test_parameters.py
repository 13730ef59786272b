"""Parameters of motions: their derivatives, and shapes that bodies can have."""

import numpy as np
import pytest

from rigidsym.fitting._parameters import Parameters, Point, left_jacobian
from rigidsym.quaternions import (
    conjugate,
    inverse_left_jacobian,
    of_rotation_vectors,
    product,
    rotation_vectors,
)

POINT = Point(
    np.array([0.5, 0.5, -0.5, 0.5]),
    np.array([0.1, 0.2, -0.3]),
    np.array([0.6, 0.9, 1.0]),
    np.array([0.8, 0.0, 0.6, 0.0]),
)
ALL = (Parameters(), Parameters(shape=False), Parameters(True, True, True))


@pytest.mark.parametrize("parameters", ALL, ids=lambda x: str(x.count))
def test_derivatives_are_those_of_the_move(parameters):
    random = np.random.default_rng(4)
    x = 0.7 * random.normal(size=parameters.count)
    here = parameters.moved(POINT, x)
    own = parameters.derivatives(here, x)
    step = 1e-6
    for k, unit in enumerate(np.eye(parameters.count)):
        ahead, behind = (parameters.moved(POINT, x + sign * step * unit) for sign in (1, -1))
        turns = [
            rotation_vectors(product(a, conjugate(b)))
            for a, b in ((ahead.attitude, behind.attitude), (ahead.mount, behind.mount))
        ]
        found = [turns[0], ahead.omega - behind.omega, ahead.moments - behind.moments, turns[1]]
        assert own[:, k] == pytest.approx(np.concatenate(found) / (2 * step), abs=1e-8)


def test_every_choice_is_a_body_that_can_exist():
    shapes = np.zeros((200, 8))
    shapes[:, 6:] = np.random.default_rng(1).normal(scale=8, size=(200, 2))
    many = Point(*(np.broadcast_to(x, (200, x.size)) for x in
                   (POINT.attitude, POINT.omega, POINT.moments, POINT.mount)))  # fmt: skip
    low, middle, high = np.sort(Parameters().moved(many, shapes).moments, axis=1).T
    assert np.all(low > 0)
    assert np.all(low + middle >= high * (1 - 1e-12))
    assert np.ptp(low / high) > 0.5


@pytest.mark.parametrize("size", [1e-9, 1e-3, 0.2, 3.0])
def test_jacobians_of_rotation_vectors(size):
    vector = size * np.array([0.6, -0.48, 0.64])
    step = 1e-6
    for unit in np.eye(3):
        ahead = of_rotation_vectors(vector + step * unit)
        turn = product(ahead, conjugate(of_rotation_vectors(vector)))
        moved = rotation_vectors(turn) / step
        assert left_jacobian(vector) @ unit == pytest.approx(moved, abs=2e-6)
        turned = product(of_rotation_vectors(vector), of_rotation_vectors(step * unit))
        moved = (rotation_vectors(turned) - vector) / step
        assert inverse_left_jacobian(vector).T @ unit == pytest.approx(moved, abs=2e-6)
