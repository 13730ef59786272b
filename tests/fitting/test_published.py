"""Published observations and fits to them: Toutatis by radar, and the simulated T-handle."""

import numpy as np
import pytest

import rigidsym
from rigidsym.errors import InputError
from rigidsym.fitting import Attitudes, Rates
from rigidsym.fitting._files import load
from rigidsym.fitting._published import YEARS, toutatis
from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.solution._polhode import Mode

DAY = 86400.0
# Takahashi, Busch and Scheeres (2013), table 2: ratios to the smallest moment, rates in deg/d at
# 1992-11-09T17:49:47, moments in the order of the body's axes.
RATIOS = np.array([3.0836, 3.235, 1.0])
# Found with the angles alone, weighed by 5 deg, from which they scatter by that.
SCATTER = np.deg2rad(5)


@pytest.fixture(scope="module")
def looks():
    return toutatis()


@pytest.fixture(scope="module")
def found(looks):
    guess = rigidsym.TorqueFreeMotion(
        RATIOS, np.deg2rad([-21.0, 29.0, -99.5]) / DAY, [0.82, -0.5, 0.18, -0.22]
    )
    return rigidsym.fit(looks.times, attitudes=looks.q, sigma=SCATTER, guess=guess)


def test_angles_turn_as_spin_vectors_say():
    """This shows that angles and vectors are read along the same axes, in the same order."""
    looks = toutatis((1992, 1996))
    days = np.diff(looks.times)
    close = days < 1.2 * DAY
    turned = rotation_vectors(product(conjugate(looks.q[:-1]), looks.q[1:])) / days[:, None]
    mean = (looks.omega[:-1] + looks.omega[1:]) / 2
    apart = np.degrees(np.linalg.norm(turned - mean, axis=1))[close] * DAY
    assert close.sum() > 20
    assert np.median(apart) < 15


def test_years_are_chosen():
    assert [len(toutatis((year,)).times) for year in YEARS] == [17, 8, 2, 4, 2]
    assert toutatis(YEARS).sigma[[0, -1]] == pytest.approx(np.deg2rad([15, 20]))
    with pytest.raises(InputError, match="years = 1988: must be of: 1992"):
        toutatis((1988,))


def test_toutatis_of_1992_has_the_published_periods_and_ratios(found):
    assert found.mode is Mode.LONG_AXIS
    # Hudson and Ostro (1995): 5.41 d and 7.35 d; Zhao et al. (2015): 5.38 and 7.40 +- 0.03 d.
    assert found.periods.rotation / DAY == pytest.approx(5.38, abs=0.04)
    assert found.periods.precession / DAY == pytest.approx(7.40, abs=0.06)
    # The images of 1992 and the looks of twenty years are both within two errors.
    for rotation, precession in ((5.41, 7.35), (5.38, 7.40)):
        assert abs(found.periods.rotation - rotation * DAY) < 2 * found.periods_sigma.rotation
        assert abs(found.periods.precession - precession * DAY) < 2 * found.periods_sigma.precession
    assert found.periods_sigma.rotation < 0.05 * DAY
    ratios = RATIOS / RATIOS.max()
    apart = found.moments - ratios
    assert np.all(np.abs(apart) <= 3 * found.sigma[6:] + 1e-12)
    assert 0.05 < found.probability < 0.99


def test_each_look_is_predicted_from_the_others(found, looks):
    (missed,) = found.against_others
    assert np.all(missed < 16.3)  # chi2 of three degrees of freedom at 0.1 %
    one = found.problem.sets[0]
    kept = np.arange(17) != 16
    others = rigidsym.fit(
        attitudes=Attitudes(one.t[kept], one.seen[kept], SCATTER), guess=found.motion
    )
    predicted = others.predict(one.t[16])
    apart = rotation_vectors(product(conjugate(looks.q[16]), predicted.q))
    assert np.linalg.norm(apart) < 3 * np.hypot(predicted.attitude_sigma, np.sqrt(3) * SCATTER)


def test_1996_is_not_told_by_1992_but_shows_the_same_mode(found):
    """Errors of the periods make whole turns in four years, and tidal torques add to them."""
    later = toutatis((1996,))
    assert np.min(found.predict(later.times).attitude_sigma) > 1
    since = later.times - later.times[0]
    again = rigidsym.fit(since, attitudes=later.q, sigma=SCATTER, starts=500)
    assert again.mode is Mode.LONG_AXIS
    assert again.periods.rotation / DAY == pytest.approx(5.38, abs=0.15)


def test_the_handle_comes_back_from_its_rates():
    (seen,) = load("t-handle").observations["rates"]
    moments = np.array([193.75, 363.89, 545.14])
    truth = rigidsym.TorqueFreeMotion(moments, (0.006, 6.0, -0.004))
    scatter = (truth(seen.t)[1] - seen.seen) * seen.weights[:, 0]
    assert np.std(scatter) == pytest.approx(1, abs=0.1)
    assert isinstance(seen, Rates)
    fit = rigidsym.fit(rates=seen, guess=truth)
    assert fit.motion.parameter > 0.99999
    assert np.abs(fit.moments - moments / moments[2]) == pytest.approx(0, abs=4 * 5e-4)
    assert fit.unobservable == ("attitude 1", "attitude 2", "attitude 3")
    assert fit.probability > 0.01
