"""Condition numbers are the norms of what differences of states tend to."""

import json
from fractions import Fraction

import numpy as np
import pytest

from rigidsym._engines import engine
from rigidsym.precise import PreciseMotion
from rigidsym.precise._balls import ball, bits_of, working
from rigidsym.validate._finding import Finding
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import enclose
from rigidsym.validate._tally import Tally
from rigidsym.validate.strata import draw

STEP, DIGITS = Fraction(1, 10**100), 250
MOTIONS = (
    "uniform",
    "near spin, middle",
    "separatrix",
    "needle",
    "large scales",
    "spin",
    "sphere",
    "rest",
)
# Differences of later states need more digits.
EARLY = 3


def differences(sample, time):
    """(7, 7): what relative changes of rates, moments and time do to q and omega."""
    inertia, omega, attitude = sample.exact
    given, found = [*omega, *inertia, Fraction(time)], []
    for k, value in enumerate(given):
        ends = []
        for step in (STEP, -STEP):
            given[k] = value * (1 + step)
            motion = PreciseMotion(tuple(given[3:6]), tuple(given[:3]), attitude)
            ((q, rates),) = motion.enclosures([given[6]], DIGITS)
            ends.append([*q, *rates])
        given[k] = value
        with working(bits_of(DIGITS)):
            changes = [(x - y) / ball(2 * STEP) for x, y in zip(*ends, strict=True)]
        found.append(list(map(float, changes)))
    return np.array(found)


@pytest.mark.parametrize("stratum", MOTIONS)
def test_they_are_norms_of_derivatives(stratum):
    reference = enclose(draw(stratum, 1, seed=3), 40)
    for k, time in enumerate(reference.sample.times[:EARLY]):
        by_inputs = differences(reference.sample, time)
        angle = 2 * np.linalg.norm(by_inputs[:, :4])
        np.testing.assert_allclose(reference.condition["angle"][k], angle, rtol=1e-13, atol=1e-30)
        size = np.linalg.norm(reference.omega[0][k]) or 1.0
        rates = np.linalg.norm(by_inputs[:, 4:]) / size
        np.testing.assert_allclose(reference.condition["omega"][k], rates, rtol=1e-13, atol=1e-30)


def test_what_is_beyond_binary64_is_infinite_and_still_json():
    reference = enclose(draw("separatrix", 0, seed=1), 40)
    found = {"c": measure(reference, engine("c"))}
    assert np.isinf(reference.condition["angle"]).any()
    assert not np.isnan(reference.condition["omega"]).any()
    data = json.loads(json.dumps(Finding(reference, found).to_data(), allow_nan=False))
    assert "inf" in data["condition"]["angle"]
    tally = Tally()
    tally.add("c", reference, found["c"])
    assert "inf" in tally.view("c", "angle", "condition")


def test_states_without_it_are_the_same():
    sample = draw("uniform", 0, seed=1)
    found, alone = enclose(sample, 40), enclose(sample, 40, with_condition=False)
    assert np.array_equal(found.q[0], alone.q[0])
    assert np.isnan(alone.condition["angle"]).all()
    share = [measure(x, engine("numpy"))["angle"].share.max() for x in (found, alone)]
    assert share[0] == pytest.approx(share[1])
