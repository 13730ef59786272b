"""The validation: reproducible, honest about what it tested, and able to fail."""

import dataclasses
import json

import numpy as np
import pytest

from rigidsym import InputError
from rigidsym.generated import torque_free
from rigidsym.validate import validate
from rigidsym.validate.measure import bound, measure
from rigidsym.validate.report import StratumReport
from rigidsym.validate.strata import STRATA, draw, samples

REPORT = validate(cases=6, seed=5)


@pytest.mark.parametrize("stratum", REPORT.strata, ids=lambda stratum: stratum.name)
def test_every_stratum_is_within_the_documented_bound(stratum):
    assert stratum.states > 0
    assert stratum.passed, stratum


def test_the_papers_body_to_a_few_ulps():
    (paper,) = (stratum for stratum in REPORT.strata if stratum.name == "paper")
    assert paper.states == 19
    assert paper.worst["angle"] < 32
    assert paper.worst["omega"] < 16


def test_a_sample_is_the_same_whenever_it_is_drawn():
    listed = [sample for sample in samples(2, seed=9) if sample.stratum != "paper"]
    assert len(listed) == 2 * len(STRATA)
    assert all(sample == draw(sample.stratum, sample.index, 9) for sample in listed)
    assert draw("uniform", 0, 9) != draw("uniform", 0, 10)


def test_reports_are_deterministic_json_and_markdown():
    again = validate(cases=6, seed=5)
    assert again.to_json() == REPORT.to_json()
    data = json.loads(REPORT.to_json())
    assert data["schema"] == "rigidsym.validation/1"
    assert data["passed"] is True
    assert {s["name"] for s in data["strata"]} == {"paper", *STRATA}
    assert REPORT.to_markdown().count("| ok |") == len(REPORT.strata)


def test_a_stratum_that_tested_nothing_fails():
    empty = StratumReport("nothing", 0, 0, dict.fromkeys(REPORT.strata[0].worst, 0.0), None, 0.0)
    assert not empty.passed


def rounded(values):
    return tuple(np.float32(x).astype(float) for x in values)


RATE = torque_free.RESULTS.index("mu")
FAULTS = {
    "a constant off by 1e-12": (
        "_plan",
        lambda values: (*values[:RATE], values[RATE] * (1 + 1e-12), *values[RATE + 1 :]),
    ),
    "a rate of the wrong sign": ("_state", lambda values: (*values[:5], -values[5], values[6])),
    "two axes swapped": ("_state", lambda values: (*values[:5], values[6], values[5])),
    "the other sheet": ("_state", lambda values: (*(-x for x in values[:4]), *values[4:])),
    "single precision": ("_state", rounded),
    "not a number": ("_state", lambda values: (values[0] * np.nan, *values[1:])),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_in_the_module_are_noticed(fault, monkeypatch):
    function, spoil = FAULTS[fault]
    original = getattr(torque_free, function)
    monkeypatch.setattr(torque_free, function, lambda *values: spoil(original(*values)))
    shares = [measure(draw("uniform", k, 5), 25).share for k in range(4)]
    assert max(shares) > 1


def test_a_missing_winding_is_noticed(monkeypatch):
    monkeypatch.setattr(torque_free, "_complete_j", lambda n, mc: 0.0)
    shares = [measure(draw("uniform", k, 5), 25).share for k in range(4)]
    assert max(shares) > 1


def test_the_bound_grows_with_the_angle_turned():
    sample = draw("uniform", 0, 5)
    far = dataclasses.replace(sample, times=(0.0, 1e3))
    assert bound(far, 1e3) > bound(far, 1.0) > 256
    assert measure(far, 25).share < 1


def test_a_target_that_does_not_exist():
    with pytest.raises(InputError, match="target = rust: must be one of: numpy"):
        validate("rust")
