"""Residuals of all kinds of observations with their derivatives, and input that is refused."""

import numpy as np
import pytest
from simulated import TUMBLING, refused

import rigidsym
from rigidsym.fitting._observations import Attitudes, Directions, Modelled, Rates
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotated

T = np.linspace(0.0, 9.0, 7)
Q, OMEGA = TUMBLING(T)
NEAR = product(of_rotation_vectors(np.full((7, 3), 0.3)), Q)
STAR, NONE = np.array([0.2, 0.3, 0.9]), np.zeros((7, 4))
SETS = {
    "attitudes": Attitudes(T, -NEAR * 3, 0.1),
    "attitudes with a covariance": Attitudes(T, NEAR, np.diag([1.0, 4.0, 9.0]) + 0.5),
    "rates": Rates(T, OMEGA + 0.1, np.full(7, 0.2)),
    "in the body": Directions(T, rotated(conjugate(NEAR), STAR), 0.1, STAR),
    "in space": Directions(T, rotated(NEAR, STAR), 0.1, STAR, "space"),
    "opposite": Directions(T, -rotated(conjugate(NEAR), STAR), 0.1, STAR),
    "exactly there": Directions(T, rotated(conjugate(Q), STAR), 0.1, STAR),
    "the axis of rotation": Directions(T, rotated(NEAR, OMEGA + 0.2), 0.1, "spin", "space"),
    "model": Modelled(T, T, 0.1, lambda q, w: q[..., 0] ** 2 + w[..., 1]),
}


@pytest.mark.parametrize("name", SETS)
def test_derivatives_are_those_of_the_residuals(name):
    one = SETS[name]
    here = one.residuals(Q, OMEGA)
    assert here.shape == (7, one.width)
    slopes = one.derivatives(Q, OMEGA, here)
    assert slopes.flags.writeable
    for k, step in enumerate(1e-6 * np.eye(6)):
        ahead, behind = (
            one.residuals(product(of_rotation_vectors(x[:3]), Q), OMEGA + x[3:])
            for x in (step, -step)
        )
        assert slopes[..., k] == pytest.approx((ahead - behind) / 2e-6, abs=1e-7)


def test_either_sign_of_a_quaternion_is_the_same_attitude():
    assert Attitudes(T, Q, 1.0).residuals(-Q, OMEGA) == pytest.approx(np.zeros((7, 3)), abs=1e-15)
    turned = product(Q, of_rotation_vectors(np.array([0.1, 0.0, 0.0])))
    assert Attitudes(T, -Q, 1.0).residuals(turned, OMEGA)[:, 0] == pytest.approx(np.full(7, 0.1))


def test_directions_miss_by_the_angle_between_them():
    away = Directions(T[:1], [[0, 0, 1]], 1.0, [np.sin(2.5), 0, np.cos(2.5)])
    missed = away.residuals(np.array([[1.0, 0, 0, 0]]), np.zeros((1, 3)))
    assert np.linalg.norm(missed) == pytest.approx(2.5)


def test_whitened_errors_are_independent():
    covariance = np.array([[2.0, 1.0, 0.0], [1.0, 3.0, 0.5], [0.0, 0.5, 1.0]])
    weights = Attitudes(T, Q, covariance).whitened(np.eye(3))
    assert weights[0] @ covariance @ weights[0].T == pytest.approx(np.eye(3))


def test_a_jacobian_of_the_user_is_taken():
    def jacobian(q, omega):
        found = np.zeros((*omega.shape[:-1], 1, 6))
        found[..., 0, 3] = 1.0
        return found

    own = Modelled(T, T, 0.1, lambda q, w: w[..., 0], jacobian)
    differences = Modelled(T, T, 0.1, lambda q, w: w[..., 0])
    here = own.residuals(Q, OMEGA)
    found = [one.derivatives(Q, OMEGA, here) for one in (own, differences)]
    assert found[0] == pytest.approx(found[1], abs=1e-8)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Attitudes([0, 0], Q[:2], 1), "attitudes.times[1] = 0.0: must be later than the"),
        (lambda: Attitudes([0, 1, 0.5], Q[:3], 1), "attitudes.times[2] = 0.5: must be later"),
        (lambda: Attitudes([], Q[:0], 1), "must be a list of at least one time"),
        (lambda: Attitudes(T, Q[:3], 1), "an array of shape (3, 4): must have the shape (7, 4)"),
        (lambda: Attitudes(T, NONE, 1), "attitudes[0] = [0.0, 0.0, 0.0, 0.0]: must not be zero"),
        (lambda: Attitudes(T, Q), "sigma.attitudes = missing: a standard deviation or a cov"),
        (lambda: Attitudes(T, Q, 0), "sigma.attitudes = 0.0: a standard deviation must be pos"),
        (lambda: Attitudes(T, Q, [1] * 6 + [-1]), "sigma.attitudes[6] = -1.0: a standard dev"),
        (lambda: Attitudes(T, Q, [1, 2]), "must have the shape (), (7,), (3, 3) or (7, 3, 3)"),
        (lambda: Attitudes(T, Q, np.diag([1, 1, -1])), "has the eigenvalue -1: a covariance must"),
        (lambda: Attitudes(T, Q, np.eye(3) + np.eye(3, k=1)), "a covariance is symmetric"),
        (lambda: Rates(T, OMEGA * np.nan, 1), "rates[0, 0] = nan: must be finite"),
        (lambda: Directions(T, OMEGA, 1, [0, 0, 0]), "vectors.known = [0.0, 0.0, 0.0]: must not"),
        (lambda: Directions(T, OMEGA, 1, [0, 0]), "must have the shape (3,) or (7, 3)"),
        (lambda: Directions(T, OMEGA, 1, STAR, "sky"), "'sky': must be 'body' or 'space'"),
        (lambda: Directions(T, OMEGA, 1, "pole"), "vectors.known = 'pole': must be numbers or 'sp"),
        (
            lambda: Directions(T, OMEGA, 1, "spin"),
            "vectors.seen_in = 'body': must be 'space' where",
        ),
        (lambda: Modelled(T, T, 1), "models.model = None: must be a function of q and omega"),
    ],
)
def test_observations_that_cannot_be_are_refused(make, message):
    refused(make, message)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "observations = none: give attitudes, rates, vectors, models, or some of them"),
        ({"attitudes": Q, "sigma": 1}, "times = missing: attitudes given as an array need them"),
        ({"times": T, "attitudes": Q}, "sigma.attitudes = missing: a standard deviation or"),
        ({"times": T, "attitudes": Q, "rates": OMEGA, "sigma": 1}, "give one for each of: att"),
        ({"times": T[:2], "attitudes": Q[:2], "sigma": 1},
         "observations = 6 numbers: are fewer than the 8 parameters"),
        ({"times": T[:3], "attitudes": Q[:3], "sigma": 1, "inertia": "tensor"},
         "observations = 9 numbers: are fewer than the 11 parameters"),
        ({"times": [1.0], "attitudes": Q[:1], "sigma": 1},
         "times = 1.0: all observations are at one time, and show no motion"),
        ({"attitudes": Attitudes([2], Q[:1], 1), "rates": Rates([2], OMEGA[:1], 1)},
         "times = 2.0: all observations are at one time"),
        ({"times": T, "attitudes": Q, "sigma": {"attitude": 1}}, "sigma = attitude: must be one"),
        ({"times": T, "attitudes": Q, "sigma": 1, "inertia": "some"}, "inertia = 'some': must be"),
        ({"times": T, "attitudes": Q, "sigma": 1, "inertia": "known"}, "moments = missing"),
        ({"times": T, "attitudes": Q, "sigma": 1, "moments": [1, 1, 3]}, "inertia = [1, 1, 3]"),
        ({"times": T, "attitudes": Q, "sigma": 1, "loss": "cubic"}, "loss = 'cubic': must be one"),
        ({"times": T, "attitudes": Q, "sigma": 1, "starts": 0}, "starts = 0: must be a whole"),
        ({"times": T, "attitudes": Q, "sigma": 1, "fastest": -1}, "fastest = -1: must be above"),
        ({"times": T, "attitudes": Q, "sigma": 1, "delta_chi2": 0}, "delta_chi2 = 0: must be"),
        ({"times": T, "attitudes": Q, "sigma": 1, "engine": "x"}, "engine = 'x': must be one of"),
        ({"attitudes": Rates(T, OMEGA, 1)}, "attitudes = Rates: must be Attitudes"),
        ({"vectors": OMEGA, "times": T, "sigma": 1}, "vectors = ndarray: must be"),
        ({"times": T, "attitudes": Q, "sigma": {"attitudes": 1, "moments": 1}},
         "sigma.moments = given: is about moments that are given"),
    ],
)  # fmt: skip
def test_arguments_that_cannot_be_are_refused(arguments, message):
    refused(lambda: rigidsym.fit(**arguments), message)
