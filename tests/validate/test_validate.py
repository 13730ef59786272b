"""The validation: reproducible, honest about what it tested, and able to fail."""

import dataclasses
import json
import math
import pickle

import numpy as np
import pytest

from rigidsym import InputError
from rigidsym._engines import EngineError, engine
from rigidsym.validate import _implementations as implementations
from rigidsym.validate import validate
from rigidsym.validate._bounds import BOUNDS, MEASURES
from rigidsym.validate._campaign import DISAGREEMENT, ORACLES
from rigidsym.validate._finding import measure_case
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import distance, enclose
from rigidsym.validate._report import ValidationReport
from rigidsym.validate.strata import STRATA, Sample, count, draw
from rigidsym.view._validation import page

TARGETS = ("numpy", "c")
UNIFORM = draw("uniform", 3, 5)
SPIN = Sample("spin", 0, (1.0, 2.0, 2.5), (0.0, 0.0, 0.5), (1.0, 0.0, 0.0, 0.0), (0.0, 30.0))


@pytest.fixture(scope="module")
def report(once):
    """A report on all strata, measured once for all processes of a run."""

    def measure(folder):
        found = validate(cases=6, seed=5, workers=None)
        (folder / "report").write_bytes(pickle.dumps(found))

    return pickle.loads((once("validation_report", measure) / "report").read_bytes())


def test_a_report_names_its_command_and_its_options(report):
    assert report.options.endswith("--cases 6 --digits 40 --seed 5")
    assert report.command == f"rigidsym validate {report.options}"


@pytest.mark.parametrize("stratum", STRATA)
@pytest.mark.parametrize("target", TARGETS)
def test_every_stratum_is_within_every_documented_bound(report, target, stratum):
    assert report.tally.cases[stratum] == count(stratum, 6)
    for name in MEASURES:
        cell = report.tally.cells[target, name, "share", stratum]
        assert (cell.count, cell.worst <= 1) == (0, True), name


def test_the_papers_body_to_a_few_ulps(report):
    assert report.tally.states["paper"] == 24
    for target in TARGETS:
        assert report.tally.cells[target, "angle", "stratum", "paper"].worst < 10
        assert report.tally.cells[target, "omega", "stratum", "paper"].worst < 6


def test_the_second_oracle_agrees_in_every_stratum(report):
    assert all(0 <= report.agreement(stratum) < 1e-3 for stratum in STRATA)


# Of every sort: a set of its own, drawn, at an edge, at a switch, steady, at long times.
SIX = ("paper", "uniform", "separatrix", "branch switch", "sphere", "near separatrix, long")


def test_reports_are_deterministic_for_any_number_of_workers():
    alone, several = (validate(cases=6, seed=5, workers=n, strata=SIX) for n in (1, 3))
    assert (
        dataclasses.replace(alone, run={}).to_json()
        == dataclasses.replace(several, run={}).to_json()
    )
    other = validate(["numpy"], cases=2, seed=6, strata=["uniform"])
    assert other.to_data()["worst"] != alone.to_data()["worst"]


def test_the_report_says_what_it_is(report):
    data = json.loads(report.to_json())
    assert data["schema"] == "rigidsym.validation/3"
    assert data["passed"] is True
    assert data["command"] == "rigidsym validate numpy c --cases 6 --digits 40 --seed 5"
    assert [stratum["name"] for stratum in data["strata"]] == list(STRATA)
    assert list(data) == sorted(data)
    assert data["run"]["enclosed states"] == sum(s["states"] for s in data["strata"])
    text = report.to_markdown()
    assert text.count("| ok |") == len(TARGETS) * len(STRATA)
    assert "circulation about the axis of largest inertia" in text


ROD = ORACLES, DISAGREEMENT, "stratum", "rod"


@pytest.mark.parametrize(
    ("key", "worst", "complaint"),
    [
        (None, None, "rod: 0 of 6 cases were tested"),
        (("c", "norm", "share", "rod"), None, "c: rod: a bound is broken, or was not tested"),
        (ROD, None, "rod: the oracles disagree by inf"),
        (ROD, 1.5, "rod: the oracles disagree by 1.5e-20"),
    ],
)
def test_what_tested_nothing_and_oracles_that_disagree_fail(report, key, worst, complaint):
    """A cell is left out, or is worse; without a key the cases of a stratum are left out."""
    tally = report.tally.copy()
    assert ValidationReport(report.campaign, tally).passed
    if key is None:
        del tally.cases["rod"]
    elif worst is None:
        del tally.cells[key]
    else:
        tally.cells[key] = dataclasses.replace(tally.cells[key], worst=worst)
    found = ValidationReport(report.campaign, tally)
    assert found.complaints == (complaint,)
    assert not found.passed


class Altered:
    """NumPy's engine with something done to its states."""

    def __init__(self, change):
        self.engine, self.change = engine("numpy"), change

    def prepare(self, *state):
        return self.engine.prepare(*state)

    def states(self, prepared, t):
        return self.change(t, *self.engine.states(prepared, t))


def refused(t, q, omega):
    raise EngineError("t", "not today")


# An interval begins there.
MIDDLE = UNIFORM.times[len(UNIFORM.times) // 2]
SCALAR = np.array([1.0, 0.0, 0.0, 0.0])


@pytest.mark.parametrize(
    ("change", "noticed", "not_noticed"),
    [
        # Longer, faster, turned, with the other sign, drifting, and no numbers.
        (lambda t, q, w: (q * (1 + 2e-15), w), {"angle", "norm"}, {"omega", "energy"}),
        (lambda t, q, w: (q, w * (1 + 4e-15)), {"omega"}, {"angle", "norm", "jump"}),
        (lambda t, q, w: (q[:, [1, 0, 2, 3]] * (1, -1, 1, 1), w),
         {"angle", "residual"}, {"omega", "norm", "jump"}),
        (lambda t, q, w: (np.where(t > MIDDLE, -1, 1)[:, None] * q, w),
         {"jump", "residual"}, {"omega", "norm"}),
        (lambda t, q, w: (q + 1e-14 * np.sin(20 * t)[:, None] * SCALAR, w),
         {"angle", "residual", "norm"}, {"omega"}),
        (lambda t, q, w: (np.vstack([np.full(4, np.nan), q[1:]]), w),
         {"angle", "norm", "jump"}, {"omega"}),
        (refused, set(MEASURES), set()),
    ],
)  # fmt: skip
def test_each_measure_notices_what_it_is_for(change, noticed, not_noticed):
    found = measure(enclose(UNIFORM, 40), Altered(change))
    beyond = {name for name, errors in found.items() if np.any(errors.share > 1)}
    assert noticed <= beyond
    assert not_noticed.isdisjoint(beyond)


def test_drifts_are_judged_by_what_errors_of_the_rates_make_of_them():
    tenth = Altered(lambda t, q, omega: (q, 1.1 * omega))
    found = measure(enclose(UNIFORM, 40), tenth)
    for name in ("energy", "momentum"):
        np.testing.assert_allclose(found[name].units * 2**-53, 0.21, rtol=1e-9)
        assert np.all(found[name].condition >= 2)


def test_the_condition_tells_ill_conditioning_from_sloppiness():
    """The angle of a spin is omega t, and on the separatrix errors of the inputs grow like e^t."""
    spin = enclose(SPIN, 40).condition
    assert spin["angle"][0] == 0
    assert 15 <= spin["angle"][1] < 150
    body = ((1.0, 2.0, 2.25), (0.75, 0.5, 1.0), (1.0, 0.0, 0.0, 0.0), (10.0, 20.0, 30.0))
    steep = enclose(Sample("separatrix", 0, *body), 40)
    growth = np.diff(np.log(steep.condition["angle"])) / 10
    # lambda of the rates, from H and K^2.
    expected = math.sqrt(0.25 * 3.3125 / 4.5)
    np.testing.assert_allclose(growth, expected, rtol=1e-3)
    assert steep.distance == 0
    found = measure_case(steep.sample, 40, ["numpy"])
    assert found.share("numpy") < 1


def test_the_distance_from_the_separatrix():
    assert distance((1, 2, 3), (1, 0, 0)) == 1
    assert distance((1, 2, 3), (0, 0, 0)) == 1
    assert 0 < distance((4, 5, 9), (3, 1, 1 + 1e-9)) < 1e-8


def test_errors_of_states_that_are_refused_are_infinite_and_still_json(monkeypatch):
    monkeypatch.setattr(implementations.engines, "exactly", lambda name: Altered(refused))
    report = validate(["numpy"], cases=1, strata=["uniform"])
    assert not report.passed
    data = json.loads(report.to_json())
    assert data["implementations"][0]["strata"]["uniform"]["angle"]["units"] == "inf"
    (failure,) = report.failures
    assert failure.line.startswith("numpy: uniform:0: angle inf")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"targets": ["rust"]}, "target = rust: must be one of: numpy, c"),
        ({"peers": ["nobody"]}, "peer = nobody: must be one of: heyoka"),
        ({"strata": ["moon"]}, "stratum = moon: must be one of: 'paper'"),
        ({"digits": 5}, "digits = 5: must be at least 20 and at most 1000"),
    ],
)
def test_what_does_not_exist_is_one_line(arguments, message):
    with pytest.raises(InputError, match=message):
        validate(**arguments)


def test_a_simplest_case_at_another_time_than_zero_is_reported(monkeypatch):
    """It has no start to measure."""
    monkeypatch.setitem(BOUNDS, "angle", 1e-16)
    report = validate(["numpy"], cases=2, strata=["uniform"])
    (failure,) = report.failures
    assert failure.simplest.sample.times != (0.0,)
    assert "start" not in failure.simplest.errors["numpy"]
    assert failure.file == f"failures/numpy/uniform-{failure.index}.toml"
    assert f"--case {failure.file}" in report.to_markdown()
    assert failure.line in page(report.to_data())


@pytest.mark.parametrize("digits", [20, 700])
def test_the_condition_is_there_at_any_digits(digits):
    found, expected = (enclose(UNIFORM, d).condition["angle"] for d in (digits, 40))
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_bounds_are_stated_for_every_measure():
    assert set(BOUNDS) == set(MEASURES)
    assert BOUNDS["angle"] == BOUNDS["omega"] == 2e-15
