"""Fits where linear errors bend: a truth lies where the covariance says, or the fit is flagged."""

import numpy as np
import pytest
from scipy.stats import binom, chi2

import rigidsym
from rigidsym._cli import main
from rigidsym.validate._fits import APPLICATION, SIGMA, distance

SEED = 1
LEVEL, CHANCE = 0.95, 0.01
# Of fifty ordinary fits.
MOST_FLAGGED = 10


def test_a_case_of_each_stratum_is_covered_or_flagged():
    found = list(APPLICATION.outcomes(1, SEED))
    assert {one.stratum for one in found} == {*APPLICATION.strata}
    assert list(APPLICATION.goal.broken(found)) == []
    assert any(one.share is not None for one in found)


def test_the_command_measures_a_stratum(capsys):
    assert main(["validate", "--fits", "--stratum", "uniform", "--cases", "2"]) == 0
    assert "uniform" in capsys.readouterr().out


@pytest.mark.slow
def test_more_cases_are_covered_or_flagged():
    found = list(APPLICATION.outcomes(8, SEED))
    assert list(APPLICATION.goal.broken(found)) == []
    ordinary = [one for one in APPLICATION.outcomes(50, SEED, ["uniform"]) if one.share is None]
    assert len(ordinary) <= MOST_FLAGGED


def fitted(stratum, index):
    case = APPLICATION.draw(stratum, index, SEED + 1)
    fit = rigidsym.fit(case.times, attitudes=case.seen, sigma=SIGMA, guess=case.truth)
    return case.truth, fit


@pytest.mark.slow
def test_distances_that_are_not_flagged_are_those_of_chi2():
    squares = freedoms = 0
    for index in range(100):
        truth, fit = fitted("uniform", index)
        if not fit.nonlinearity.flagged:
            square, freedom = distance(fit, truth)
            squares, freedoms = squares + square, freedoms + freedom
    assert chi2.sf(squares, freedoms) > CHANCE / 2
    assert chi2.cdf(squares, freedoms) > CHANCE / 2


@pytest.mark.slow
@pytest.mark.parametrize("stratum", ["uniform", "near separatrix", "near prolate", "near oblate"])
def test_intervals_hold_as_many_truths_as_they_say(stratum):
    """One rate of each fit, since those of a fit go together."""
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
