"""Fits of known motions: estimates, their errors, and unobservable quantities."""

import numpy as np
import pytest
from simulated import TUMBLING, attitudes, fitted, is_true, rates, told

import rigidsym
from rigidsym.fitting import Attitudes, Directions, Modelled, Rates, periods
from rigidsym.quaternions import conjugate, product, rotated

SIGMA = 1e-3
MOMENTS, OMEGA, ATTITUDE = (np.array(x, float) for x in TUMBLING.exact.values())


def times(count=30, span=12.0, seed=5):
    return np.sort(np.random.default_rng(seed).uniform(0, span, count))


@pytest.fixture(scope="module")
def found():
    return fitted(TUMBLING, times(), SIGMA, 2, guess=None, starts=300)


def test_the_motion_comes_back_within_its_errors(found):
    assert found.converged
    assert is_true(found, 26)
    assert found.degrees_of_freedom == 90 - 8
    assert found.unobservable == found.outliers == found.alternatives == ()
    assert np.all(found.sigma[:6] < 10 * SIGMA)
    assert found.moments.max() == 1
    assert found.sigma[6 + found.moments.argmax()] == pytest.approx(0, abs=1e-12)
    assert found.mode == TUMBLING.mode
    assert found.periods.rotation == pytest.approx(TUMBLING.period, rel=1e-3)
    assert found.periods.precession == pytest.approx(periods(TUMBLING).precession, rel=1e-3)
    assert len(found.motion.precise(1, 20)[0]) == 4


def test_errors_of_predictions_grow_as_the_time(found):
    later = np.array([0.0, 10.0, 1000.0, 2000.0])
    predicted = found.predict(later)
    q, omega = found.motion(later)
    assert predicted.q == pytest.approx(q)
    assert predicted.omega == pytest.approx(omega)
    assert predicted.covariance[0][:3, :3] == pytest.approx(found.covariance[:3, :3])
    assert predicted.attitude_sigma[3] == pytest.approx(2 * predicted.attitude_sigma[2], rel=0.1)
    assert found.predict(1000.0).covariance == pytest.approx(predicted.covariance[2])


def test_each_observation_is_predicted_from_the_others(found):
    (missed,) = found.against_others
    assert missed.shape == (30,)
    assert np.mean(missed) == pytest.approx(3, rel=0.4)
    one = found.problem.sets[0]
    kept = np.arange(30) != 11
    left = Attitudes(one.t[kept], one.seen[kept], SIGMA)
    predicted = rigidsym.fit(attitudes=left, guess=found.motion).predict(one.t[11])
    left = one.some(np.array([11])).residuals(predicted.q[None], predicted.omega[None])[0]
    # The rows of `body` are the inertial axes along those of the body, as the residual is.
    body = rotated(conjugate(predicted.q), np.eye(3))
    spread = body.T @ predicted.covariance[:3, :3] @ body + SIGMA**2 * np.eye(3)
    assert left @ np.linalg.solve(spread, left) == pytest.approx(missed[11], rel=0.02)


def test_all_kinds_together_tell_more(found):
    random = np.random.default_rng(3)
    t = times(12, seed=8)
    q, _ = TUMBLING(t)
    star, face = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.0, 0.0])
    noise = SIGMA * random.normal(size=(3, 12, 3))
    height = rotated(q, face)[:, 2] + noise[2, :, 0]
    both = rigidsym.fit(
        attitudes=found.problem.sets[0],
        rates=Rates(t, rates(TUMBLING, t, SIGMA, random), SIGMA),
        vectors=[
            Directions(t, rotated(conjugate(q), star) + noise[0], SIGMA, star),
            Directions(t, rotated(q, face) + noise[1], SIGMA, face, "space"),
        ],
        models=Modelled(t, height, SIGMA, lambda q, omega: rotated(q, face)[..., 2]),
        guess=found.motion,
    )
    assert both.problem.count == 90 + 36 + 48 + 12
    assert np.all(both.sigma[:6] < found.sigma[:6])
    assert is_true(both, 26)


def test_rates_alone_tell_no_attitude():
    t = times()
    seen = rates(TUMBLING, t, SIGMA, np.random.default_rng(7))
    fit = rigidsym.fit(t, rates=seen, sigma=SIGMA, guess=TUMBLING)
    assert fit.unobservable == ("attitude 1", "attitude 2", "attitude 3")
    assert np.isinf(fit.sigma[:3]).all()
    assert np.linalg.matrix_rank(fit.null_directions[:, :3]) == 3
    assert fit.null_directions[:, 3:] == pytest.approx(np.zeros((3, 5)), abs=1e-9)
    assert fit.predict(5.0).attitude_sigma > 0.9
    assert np.sum(told(fit, TUMBLING)[:5] ** 2) < 30


@pytest.mark.parametrize("axis", range(3))
def test_spin_tells_no_ratios(axis):
    spin = TUMBLING.replace(omega0=tuple(np.eye(3)[axis]))
    fit = fitted(spin, times(), SIGMA, 10 + axis)
    assert fit.spinning
    assert fit.motion.regime == spin.regime
    assert len([x for x in fit.unobservable if x.startswith("moment")]) == 2
    assert fit.sigma[3 + axis] < SIGMA
    assert np.linalg.matrix_rank(fit.null_directions[:, 6:]) == 2
    assert fit.probability > 1e-3


def test_a_wobble_that_shows_is_no_spin():
    fit = fitted(TUMBLING.replace(omega0=(0.02, 0.01, 1.0)), times(60, 40.0), SIGMA, 4)
    assert not fit.spinning
    assert fit.unobservable == ()


def test_known_moments_are_six_parameters():
    fit = fitted(TUMBLING, times(8), SIGMA, 9, inertia="known", moments=3 * MOMENTS)
    assert fit.moments == pytest.approx(3 * MOMENTS, rel=1e-15)
    assert fit.degrees_of_freedom == 24 - 6
    assert fit.sigma[6:] == pytest.approx(np.zeros(3))


def test_a_prior_on_moments_fixes_their_scale():
    errors = {"attitudes": SIGMA, "moments": [0.3, 0.3, 0.04]}
    fit = fitted(TUMBLING, times(), SIGMA, 9, sigma=errors, moments=[30, 25, 12.1])
    assert fit.scaled
    assert fit.moments == pytest.approx(30 * MOMENTS, rel=0.02)
    assert np.all((fit.sigma[6:] > 0.01) & (fit.sigma[6:] < 0.3))


def test_a_known_scale_is_the_largest_moment():
    ratios, sized = (fitted(TUMBLING, times(), SIGMA, 9, scale=x) for x in (None, 50.0))
    assert sized.moments == pytest.approx(50 * ratios.moments)
    assert sized.sigma[6:] == pytest.approx(50 * ratios.sigma[6:])
    assert (ratios.scaled, sized.scaled) == (False, True)


def test_unknown_axes_are_found():
    random = np.random.default_rng(12)
    t = times(40)
    body = rigidsym.principal_axes([[0.9, 0.1, 0.0], [0.1, 0.8, -0.15], [0.0, -0.15, 0.5]])
    omega, attitude = body.to_principal(OMEGA, [1, 0, 0, 0])
    motion = rigidsym.TorqueFreeMotion(body.moments, omega, attitude)
    seen = product(attitudes(motion, t, SIGMA, random), conjugate(body.quaternion))
    fit = rigidsym.fit(t, attitudes=seen, sigma=SIGMA, inertia="tensor", starts=500)
    assert fit.converged
    assert fit.probability > 1e-3
    truth = body.matrix @ np.diag(body.moments) @ body.matrix.T
    expected = truth / np.trace(truth)
    assert fit.tensor / np.trace(fit.tensor) == pytest.approx(expected, abs=0.01)
    q = fit.predict(0.0).q
    assert q * np.sign(q[0]) == pytest.approx([1, 0, 0, 0], abs=0.01)
    assert len(fit.names) == 12


def test_gross_errors_are_named_and_count_less():
    t = times()
    seen = attitudes(TUMBLING, t, SIGMA, np.random.default_rng(6))
    for k, turn in ((4, [1, 1, 0, 0]), (17, [1, 0, 0, 0.3])):
        seen[k] = product(seen[k], np.array(turn, float))
    fits = {
        loss: rigidsym.fit(t, attitudes=seen, sigma=SIGMA, loss=loss, guess=TUMBLING)
        for loss in ("linear", "cauchy")
    }
    assert fits["cauchy"].outliers == ((0, 4), (0, 17))
    apart = {loss: np.sum(told(fit, TUMBLING) ** 2) for loss, fit in fits.items()}
    assert apart["cauchy"] < 40 < apart["linear"]


def test_no_convergence_is_an_outcome():
    t = np.array([0.0, 1e13, 2e13, 3e13])
    seen = Attitudes(t, np.tile([1.0, 0, 0, 0], (4, 1)), SIGMA)
    fit = rigidsym.fit(attitudes=seen, guess=TUMBLING.replace(omega0=(100, 0, 100)))
    assert not fit.converged
    assert fit.reason == "the motion has no states at the times of observation"
    assert "NOT CONVERGED" in repr(fit)
