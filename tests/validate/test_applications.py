"""Campaigns of applications: cases, goals, the truth about torques, and covariances of fits."""

from random import Random

import numpy as np
import pytest
from scipy.stats import binom, chi2

import rigidsym
from rigidsym.errors import InputError
from rigidsym.validate import _fits as fits
from rigidsym.validate import _torques as torques
from rigidsym.validate._applications import Application, Goal, Outcome
from rigidsym.validate._torques import APPLICATION, Case, reference

GOAL = Goal(refused=0.02, most=3.0, part=0.99, worst=10.0)
SEED = 1
LEVEL, CHANCE = 0.95, 0.01
# Of fifty ordinary fits.
MOST_FLAGGED = 10


def outcomes(*shares):
    return [Outcome("some", k, share) for k, share in enumerate(shares)]


@pytest.mark.parametrize(
    ("shares", "sentence"),
    [
        ([0.5] * 98 + [None] * 2 + [2.9], ""),
        ([0.5] * 99 + [3.1], ""),
        ([0.5] * 97 + [None] * 3, "3 of 100 cases are refused, above 2%"),
        ([0.5] * 98 + [3.1] * 2, "2 of 100 errors are above 3 times the promised"),
        ([0.5] * 99 + [11.0], "the worst error is 11 times the promised, above 10"),
        ([0.5] * 199 + [np.nan], "the worst error is nan times the promised, above 10"),
        ([None], "1 of 1 cases are refused, above 2%"),
    ],
)
def test_a_goal_is_kept_or_not(shares, sentence):
    assert "; ".join(GOAL.broken(outcomes(*shares))) == sentence


def test_rows_say_how_strata_do():
    found = Application("some", {}, lambda case: None, GOAL).rows(outcomes(0.5, None, 4.0, 0.1))
    assert list(found) == [("some", "4", "1", "0.5", "4", "some:2", "1 above 3")]


def test_cases_are_those_of_a_seed_and_differ():
    one, same, other = (APPLICATION.draw("pulse", 3, seed) for seed in (1, 1, 2))
    assert one.omega0 == same.omega0 != other.omega0
    pushed = (x.torque(0.1, np.array(one.q0), np.zeros(3)).tolist() for x in (one, same))
    assert next(pushed) == pytest.approx(next(pushed))


def test_a_stratum_that_does_not_exist_is_refused():
    with pytest.raises(InputError, match=r"^stratum = storm: must be one of: smooth"):
        list(APPLICATION.outcomes(1, 1, ["storm"]))


def test_the_truth_about_a_jump_on_a_sphere():
    """About an axis a sphere turns by the integral of its rates."""

    def torque(t, q, omega):
        return np.array([0.0, 0.0, 6.0 if t < 0.7 else -2.0])

    still = (0.0, 0.0, 0.0)
    case = Case((2.0,) * 3, (1, 0, 0, 0), still, torque, (0.0, 2.0), (0.7,), (), "saba2", 1e-6)
    q, omega = reference(case)
    assert omega[-1] == pytest.approx([0, 0, 3 * 0.7 - 1.3], abs=1e-12)
    half = (1.5 * 0.7**2 + 2.1 * 1.3 - 0.5 * 1.3**2) / 2
    assert q[-1] == pytest.approx([np.cos(half), 0, 0, np.sin(half)], abs=1e-12)


def test_strata_are_what_they_say():
    """Torques of several strata jump at the breaks that they say, and are as narrow."""
    for index in range(20):
        case = torques.jump(Random(index))
        q, zero = np.array(case.q0), np.zeros(3)
        for t in case.breaks:
            before, after = (case.torque(s, q, zero) for s in (t * (1 - 1e-12), t * (1 + 1e-12)))
            assert np.linalg.norm(after - before) > 1e-6 * np.linalg.norm(after + before)
    widths = []
    for index in range(60):
        case = torques.pulse(Random(index))
        q, zero = np.array(case.q0), np.zeros(3)
        times = np.linspace(0, case.times[-1], 4001)
        sizes = [np.linalg.norm(case.torque(t, q, zero)) for t in times]
        widths.append(np.mean(np.array(sizes) > max(sizes) / 2))
    assert 0 < min(widths) < 0.01
    assert torques.rest(Random(1)).omega0 == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("--torques --cases 1 --stratum jump", ["rigidsym validate --torques", "jump:0"]),
        ("--fits --stratum uniform --cases 2", ["uniform"]),
    ],
)
def test_applications_are_measured_by_the_command(command, words, run):
    printed = run(f"validate {command}").out
    assert all(word in printed for word in words)


def test_an_estimate_that_is_wrong_is_noticed(monkeypatch, run):
    """Steps are chosen for a tolerance a thousand times as large."""
    true = torques.integrate

    def careless(*arguments, step, tolerance, **options):
        return true(*arguments, step=step, tolerance=1e3 * tolerance, **options)

    monkeypatch.setattr(torques, "integrate", careless)
    command = "validate --torques --cases 3 --stratum kink --stratum smooth"
    assert "broken: " in run(command, status=1).err


@pytest.mark.parametrize(
    ("options", "line"),
    [
        ("numpy --torques", "targets = given: is not for --torques"),
        ("--torques --digits 30", "digits = given: is not for --torques"),
        ("--torques --stratum storm", "stratum = storm: must be one of"),
        ("--sensitivity --json", "json = given: is not for --sensitivity"),
        ("numpy-pi --sensitivity", "target = numpy-pi: its module has no sensitivities"),
    ],
)
def test_options_that_mean_nothing_are_refused(options, line, refused):
    assert line in refused(f"validate {options}")


# Fits where linear errors bend: a truth lies where the covariance says, or the fit is flagged.


def test_a_fit_of_each_stratum_is_covered_or_flagged():
    found = list(fits.APPLICATION.outcomes(1, SEED))
    assert {one.stratum for one in found} == {*fits.APPLICATION.strata}
    assert list(fits.APPLICATION.goal.broken(found)) == []
    assert any(one.share is not None for one in found)


@pytest.mark.slow
def test_more_fits_are_covered_or_flagged():
    found = list(fits.APPLICATION.outcomes(8, SEED))
    assert list(fits.APPLICATION.goal.broken(found)) == []
    ordinary = fits.APPLICATION.outcomes(50, SEED, ["uniform"])
    assert sum(one.share is None for one in ordinary) <= MOST_FLAGGED


def fitted(stratum, index):
    case = fits.APPLICATION.draw(stratum, index, SEED + 1)
    fit = rigidsym.fit(case.times, attitudes=case.seen, sigma=fits.SIGMA, guess=case.truth)
    return case.truth, fit


@pytest.mark.slow
def test_distances_that_are_not_flagged_are_those_of_chi2():
    squares = freedoms = 0
    for index in range(100):
        truth, fit = fitted("uniform", index)
        if not fit.nonlinearity.flagged:
            square, freedom = fits.distance(fit, truth)
            squares, freedoms = squares + square, freedoms + freedom
    assert chi2.sf(squares, freedoms) > CHANCE / 2
    assert chi2.cdf(squares, freedoms) > CHANCE / 2


@pytest.mark.slow
@pytest.mark.parametrize("stratum", ["uniform", "near separatrix", "near prolate", "near oblate"])
def test_intervals_hold_as_many_truths_as_they_say(stratum):
    """Count one rate of each fit, since rates of one fit are correlated."""
    held = []
    for index in range(100):
        truth, fit = fitted(stratum, index)
        place = 3 + index % 3
        if np.isfinite(fit.sigma[place]):
            lower, upper = fit.intervals(LEVEL)[place]
            held.append(lower <= float(truth.exact["omega0"][place - 3]) <= upper)
    count = len(held)
    assert count > 50
    assert binom.ppf(CHANCE / 2, count, LEVEL) <= sum(held) <= binom.isf(CHANCE / 2, count, LEVEL)
