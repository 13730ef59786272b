"""Fits of data in other conventions or with other errors than stated, and their verdicts."""

import json

import numpy as np
import pytest
from simulated import TUMBLING, attitudes, rates

import rigidsym
from rigidsym._cli import main
from rigidsym.fitting import Directions
from rigidsym.fitting._agreement import Verdict
from rigidsym.quaternions import conjugate, product, rotated

SIGMA, SLOW = 0.02, 0.01
RANDOM = np.random.default_rng(5)
T = np.sort(RANDOM.uniform(0, 24, 40))
Q, OMEGA = TUMBLING(T)
SEEN, RATES = attitudes(TUMBLING, T, SIGMA, RANDOM), rates(TUMBLING, T, SLOW, RANDOM)
LAST = np.roll(SEEN, -1, axis=-1)
BOTH = {"attitudes": SIGMA, "rates": SLOW}
STARTS = 100


def fitted(times=T, sigma=SIGMA, **given):
    return rigidsym.fit(times, sigma=sigma, starts=STARTS, **given)


def names(fit):
    return {one.name for one in fit.agreement.readings}


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({"attitudes": LAST}, {"attitudes scalar last", "attitudes inertial to body"}),
        ({"attitudes": conjugate(SEEN)}, {"attitudes scalar last", "attitudes inertial to body"}),
        ({"attitudes": LAST, "rates": RATES, "sigma": BOTH}, {"attitudes scalar last"}),
        ({"attitudes": np.roll(conjugate(SEEN), -1, axis=-1), "rates": RATES, "sigma": BOTH},
         {"attitudes scalar last and inertial to body"}),
        ({"attitudes": SEEN, "rates": np.rad2deg(RATES), "sigma": BOTH}, {"rates in degrees"}),
        ({"attitudes": SEEN, "rates": np.rad2deg(RATES),
          "sigma": {"attitudes": SIGMA, "rates": np.rad2deg(SLOW)}}, {"rates in degrees"}),
        ({"attitudes": SEEN, "rates": rotated(Q, RATES), "sigma": BOTH},
         {"rates along inertial axes"}),
        ({"attitudes": SEEN, "rates": RATES, "times": T / 60, "sigma": BOTH}, {"times in min"}),
    ],
)  # fmt: skip
def test_the_convention_that_fits_is_named(arguments, expected):
    fit = fitted(**arguments)
    assert fit.agreement.verdict is Verdict.DISAGREE
    assert names(fit) == expected
    for one in fit.agreement.readings:
        assert one.chi2 < 300 < fit.chi2
        assert one.name in fit.agreement.message
    assert "MODEL AND DATA DISAGREE: the data fit when read as" in repr(fit).splitlines()[0]


def test_directions_the_other_way_round_are_named():
    stars = np.array([[0.0, 0.6, 0.8], [1.0, 0.0, 0.0]])
    seen = [rotated(conjugate(Q), x) + SIGMA * RANDOM.normal(size=(40, 3)) for x in stars]
    sets = [Directions(T, x, SIGMA, star, "space") for x, star in zip(seen, stars, strict=True)]
    fit = rigidsym.fit(vectors=sets, starts=500, fastest=2.0)
    assert names(fit) == {"vectors known and seen exchanged"}


def test_errors_of_a_motion_that_is_not_that_of_the_data_are_not_given():
    fit = fitted(attitudes=LAST)
    assert fit.agreement.hopeless
    for errors in (fit.covariance, fit.sigma, fit.intervals(), fit.predict(1.0).covariance):
        assert np.isnan(errors).all()
    assert fit.periods_sigma.rotation is None
    assert fit.unobservable == ()
    assert not fit.nonlinearity.flagged
    assert "not known" in repr(fit)
    data = json.loads(fit.to_json())
    assert data["agreement"]["verdict"] == "model and data disagree"
    assert data["covariance"] == [[None] * 9] * 9


def test_attitudes_by_no_convention_are_said_not_to_fit():
    fit = fitted(attitudes=RANDOM.normal(size=(40, 4)))
    assert fit.agreement.hopeless
    assert fit.agreement.readings == ()
    assert "no usual reading of the data fits" in repr(fit)


def test_a_torque_is_seen_in_residuals_that_go_with_the_next():
    """The rates decay by a small part."""
    many = np.linspace(0, 24, 200)
    slowed = TUMBLING(many)[1] * (1 - 0.002 * many[:, None]) + 1e-3 * RANDOM.normal(size=(200, 3))
    fit = rigidsym.fit(many, rates=slowed, sigma=1e-3, guess=TUMBLING)
    assert fit.agreement.hopeless
    assert "torques" in fit.agreement.message


@pytest.mark.parametrize(
    ("part", "verdict", "scale"),
    [
        (3**-0.5, Verdict.LARGER, 3**0.5),
        (0.1, Verdict.LARGER, 10.0),
        (1.0, Verdict.AGREE, 1.0),
        (5.0, Verdict.SMALLER, 0.2),
    ],
)
def test_errors_that_are_given_too_small_or_large_are_told_from_that(part, verdict, scale):
    fit = fitted(attitudes=SEEN, sigma=part * SIGMA)
    assert fit.agreement.verdict is verdict
    assert fit.agreement.scale == pytest.approx(scale, rel=0.15)
    assert fit.agreement.readings == ()
    # Standard deviations follow from the errors given.
    assert np.all(fit.sigma[:6] < part * SIGMA)
    assert fit.agreement.message in repr(fit).splitlines()[0]


def test_a_few_gross_errors_are_outliers():
    seen = SEEN.copy()
    for k, turn in ((4, [1, 1, 0, 0]), (17, [1, 0, 0, 0.3])):
        seen[k] = product(seen[k], np.array(turn, float))
    fit = fitted(attitudes=seen)
    assert fit.agreement.verdict is Verdict.OUTLIERS
    assert fit.agreement.message.startswith("2 outliers make chi2")
    assert np.isfinite(fit.sigma).all()


def test_a_normal_fit_searches_for_no_other_reading():
    fit = fitted(attitudes=SEEN)
    object.__setattr__(fit, "search", None)
    assert fit.agreement.verdict is Verdict.AGREE
    assert fit.agreement.message == ""


def test_the_command_says_so_and_exits_1(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    rows = [[t, *q] for t, q in zip(T.tolist(), LAST.tolist(), strict=True)]
    lines = ["t,q0,q1,q2,q3", *(",".join(map(repr, row)) for row in rows)]
    (tmp_path / "seen.csv").write_text("\n".join(lines))
    asked = ["fit", "seen.csv", "--sigma", f"attitudes={SIGMA}", "--starts", str(STARTS)]
    assert main(asked) == 1
    out, err = capsys.readouterr()
    assert "MODEL AND DATA DISAGREE" in out
    assert "to read attitudes scalar last, add --attitude quaternion-scalar-last\n" in err
    assert main([*asked, "--json"]) == 1
    out, err = capsys.readouterr()
    assert "MODEL AND DATA DISAGREE" in err
    assert json.loads(out)["agreement"]["readings"][0]["name"] == "attitudes scalar last"
