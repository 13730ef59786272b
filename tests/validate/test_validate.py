"""The validation: reproducible, honest about what it tested, and able to fail."""

import dataclasses
import json

import numpy as np
import pytest

from rigidsym import InputError
from rigidsym.engines import engine
from rigidsym.generated import torque_free
from rigidsym.validate import validate
from rigidsym.validate.measure import measure
from rigidsym.validate.report import StratumReport
from rigidsym.validate.strata import STRATA, draw, samples

REPORT = validate(cases=20, seed=5)


@pytest.mark.parametrize("stratum", REPORT.strata, ids=lambda stratum: stratum.name)
def test_every_stratum_is_within_the_documented_bound(stratum):
    assert stratum.states > 0
    assert stratum.passed, stratum


def test_the_papers_body_to_a_few_ulps():
    (paper,) = (stratum for stratum in REPORT.strata if stratum.name == "paper")
    assert paper.states == 19
    assert paper.worst["angle"] < 10
    assert paper.worst["omega"] < 6


def test_a_sample_is_the_same_whenever_it_is_drawn():
    listed = [sample for sample in samples(2, seed=9) if sample.stratum != "paper"]
    assert len(listed) == 2 * len(STRATA)
    assert all(sample == draw(sample.stratum, sample.index, 9) for sample in listed)
    assert draw("uniform", 0, 9) != draw("uniform", 0, 10)


def test_reports_are_deterministic_json_and_markdown():
    again = validate(cases=20, seed=5)
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


def spoilt(branch, part, number, change):
    """One result of one generated function, changed."""
    entry = torque_free.BRANCHES[branch]
    original = entry[part]

    def function(*values):
        found = list(original(*values))
        found[number] = change(found[number])
        return tuple(found)

    return entry, part, function


def index(name):
    return torque_free.BRANCHES["circular"]["names"].index(name)


FAULTS = {
    "a rate off by 1e-16 of itself": ("plan", "v_rate_lo", lambda x: x + 1e-17),
    "a constant off by 1e-12": ("plan", "T4_re_1", lambda x: x * (1 + 1e-12) + 1e-14),
    "a dropped theta term": ("plan", "T1_re_2", lambda x: 0 * x),
    "single precision": ("plan", "row_a_P4_re", lambda x: np.float32(x).astype(float)),
    "a rate of the wrong sign": ("state", 5, lambda x: -x),
    "the other sheet": ("state", 0, lambda x: -x),
    "not a number": ("state", 1, lambda x: x * np.nan),
    "a missing winding": ("angles", 0, abs),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_in_the_module_are_noticed(fault, monkeypatch):
    part, number, change = FAULTS[fault]
    number = number if isinstance(number, int) else index(number)
    monkeypatch.setitem(*spoilt("circular", part, number, change))
    numpy = engine("numpy")
    far = [dataclasses.replace(draw("uniform", k, 5), times=(1e5, 2e5)) for k in range(6)]
    assert max(measure(sample, 25, numpy).share for sample in far) > 1


def test_a_target_that_does_not_exist():
    with pytest.raises(InputError, match="target = rust: must be one of: numpy, c"):
        validate("rust")
