"""Reports on modules and on a user's integrator: reproducible, complete, and able to fail."""

import json
import math
import pickle
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym._engines import engine
from rigidsym.validate import STRATA, draw, examine, measure_case, validate
from rigidsym.validate import _finding as finding
from rigidsym.validate._bounds import BOUNDS, MEASURES
from rigidsym.validate._campaign import DISAGREEMENT, ORACLES
from rigidsym.validate._report import ValidationReport
from rigidsym.validate.strata import count, in_doubles
from rigidsym.view._validation import page

TARGETS = ("numpy", "c")


@pytest.fixture(scope="module")
def report(once):
    """Return a report on all strata, measured once for all processes of a run."""

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
    texts = {replace(one, run={}).to_json() for one in (alone, several)}
    assert len(texts) == 1
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
    """Leave out a cell or make it worse; without a key, leave out the cases of a stratum."""
    tally = report.tally.copy()
    assert ValidationReport(report.campaign, tally).passed
    if key is None:
        del tally.cases["rod"]
    elif worst is None:
        del tally.cells[key]
    else:
        tally.cells[key] = replace(tally.cells[key], worst=worst)
    found = ValidationReport(report.campaign, tally)
    assert found.complaints == (complaint,)
    assert not found.passed


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"targets": ["fortran"]}, "target = fortran: must be one of: numpy, c"),
        ({"peers": ["nobody"]}, "peer = nobody: must be one of: heyoka"),
        ({"strata": ["moon"]}, "stratum = moon: must be one of: 'paper'"),
        ({"digits": 5}, "digits = 5: must be at least 20 and at most 1000"),
    ],
)
def test_what_does_not_exist_is_one_line(arguments, message):
    with pytest.raises(InputError, match=message):
        validate(**arguments)


def test_a_simplest_case_at_another_time_than_zero_is_reported(monkeypatch):
    """Report a case without t = 0, which has no start to measure."""
    monkeypatch.setitem(BOUNDS, "angle", 1e-16)
    report = validate(["numpy"], cases=2, strata=["uniform"])
    (failure,) = report.failures
    assert failure.simplest.sample.times != (0.0,)
    assert "start" not in failure.simplest.errors["numpy"]
    assert failure.file == f"failures/numpy/uniform-{failure.index}.toml"
    assert f"--case {failure.file}" in report.to_markdown()
    assert failure.line in page(report.to_data())


# A user's integrator: the truth passes, and whatever is wrong is a finding in the report.

FEW = ("uniform", "spin")


def exact(inertia, omega0, attitude0, times):
    return TorqueFreeMotion(inertia, omega0, attitude0)(times)


def few(integrator, **options):
    return examine(integrator, **{"cases": 1, "strata": FEW, **options})


def test_the_truth_passes_everywhere(monkeypatch):
    monkeypatch.setattr(finding, "enclose", cache(finding.enclose))
    for reach in (None, math.inf):
        report = examine(exact, cases=2, seed=7, reach=reach)
        assert report.complaints == ()
        assert report.passed
        assert report.campaign.strata == in_doubles()
        assert set(report.by_stratum()) == set(in_doubles())


def test_what_doubles_cannot_say_is_left_out():
    exact_only = {"decimals", "needle", "nearest separatrix", "nearest sphere", "published"}
    assert set(STRATA) - set(in_doubles()) == exact_only | {"nearest symmetric"}
    assert not examine(exact, cases=1, strata=["decimals"]).passed


def test_the_report_is_that_of_everybody():
    report = few(exact, name="the truth", cases=2)
    data = json.loads(report.to_json())
    assert data["passed"] is True
    assert data["command"] == (
        "examine(the_truth, cases=2, digits=40, seed=1, strata=['uniform', 'spin'])"
    )
    assert [one["name"] for one in data["implementations"]] == ["peer the truth"]
    assert data["worst"][0]["replay"].startswith("measure_case(draw('spin', ")
    assert "| uniform | 2 | 44 |" in report.to_markdown()
    assert "the truth" in page(data)
    assert "the truth" in report._repr_html_()
    assert repr(report) == f"<ValidationReport, passed: {data['command']}>"
    said = str(report).splitlines()
    assert said[0].startswith(data["command"])
    assert [line.split()[0] for line in said[1:4]] == ["stratum", "uniform", "spin"]
    assert said[-1] == report.conclusion


def test_what_a_function_gets():
    asked = []

    def heard(inertia, omega0, attitude0, times):
        asked.append(times.copy())
        assert [x.shape for x in (inertia, omega0, attitude0)] == [(3,), (3,), (4,)]
        assert abs(np.linalg.norm(attitude0) - 1) < 1e-15
        found = exact(inertia, omega0, attitude0, times)
        for given in (inertia, omega0, attitude0, times):
            given[:] = np.nan
        return found

    assert few(heard, reach=5.0).passed
    assert {float(np.sign(times[0])) for times in asked} == {-1.0, 1.0}
    for times in asked:
        assert np.all(np.diff(np.abs(times)) > 0)
        assert len({*np.sign(times)}) == 1


def raising(error):
    def raises(inertia, omega0, attitude0, times):
        raise error

    return raises


def altered(change):
    def alters(inertia, omega0, attitude0, times):
        return change(*exact(inertia, omega0, attitude0, times))

    return alters


WRONG = {
    "a key": (raising(KeyError("x")), "KeyError: 'x'"),
    "two lines": (raising(RuntimeError("a\nb")), "RuntimeError: a b"),
    "no words": (raising(ZeroDivisionError()), "ZeroDivisionError"),
    "recursion": (raising(RecursionError("deep")), "RecursionError: deep"),
    "transposed": (altered(lambda q, w: (q.T, w.T)), "q: shape (4, "),
    "rates of four": (altered(lambda q, w: (q, q)), "omega: shape ("),
    "one state": (altered(lambda q, w: (q[0], w[0])), "q: shape (4,)"),
    "attitude alone": (altered(lambda q, w: q[:3]), "must be (q, omega)"),
    "nothing": (lambda *given: None, "gives NoneType: must be (q, omega)"),
    "words": (altered(lambda q, w: ([["a"] * 4] * len(q), w)), "q: must be real numbers"),
    "complex": (altered(lambda q, w: (q + 1j, w)), "q: must be real numbers"),
    "ragged": (altered(lambda q, w: ([[1.0], [1.0, 2.0]], w)), "q: must be real numbers"),
    "too few arguments": (lambda inertia: None, "TypeError: "),
    "NaN": (altered(lambda q, w: (np.full_like(q, np.nan), w)), "angle inf"),
    "infinite": (altered(lambda q, w: (q, w * np.inf)), "inf of its bound"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_goes_wrong_is_said_for_each_stratum(name):
    integrator, words = WRONG[name]
    report = few(integrator)
    assert not report.passed
    assert len(report.complaints) == len(report.failures) == len(FEW)
    for line in report.complaints:
        assert words in line
        assert "\n" not in line
    assert {worst.error for worst in report.by_stratum().values()} == {math.inf}
    assert json.loads(report.to_json())["complaints"] == [*report.complaints]
    page(report.to_data())
    report.to_markdown()


def test_interrupts_are_not_caught():
    with pytest.raises(KeyboardInterrupt):
        few(raising(KeyboardInterrupt()))


def test_what_fails_on_one_side_is_right_on_the_other():
    def forward(inertia, omega0, attitude0, times):
        if times[0] < 0:
            raise ValueError("not backwards")
        return exact(inertia, omega0, attitude0, times)

    report = few(forward, strata=["uniform"])
    assert "not backwards" in report.complaints[0]
    worst = report.by_stratum()["uniform"]
    assert (worst.error, worst.time < 0) == (math.inf, True)
    found = measure_case(draw("uniform", 0, 1), 40, {"x": forward}).errors["x"]["angle"]
    assert np.isinf(found.units[found.times < 0]).all()
    assert np.all(found.share[found.times >= 0] <= 1)
    assert np.all(found.values[found.times >= 0] < 2e-15)


def test_errors_are_in_their_own_units_with_case_and_time():
    report = few(altered(lambda q, w: (q, w * (1 + 1e-6))), strata=["uniform"])
    worst = report.by_stratum("omega")["uniform"]
    assert worst.error == pytest.approx(1e-6, rel=1e-6)
    assert worst.time in draw(*worst.case, seed=1).times
    assert report.by_stratum(name="alters")["uniform"].error < 2e-15
    assert report.by_stratum(name="peer alters") == report.by_stratum()


class Rotations:
    """Object with a peer's methods, without a double-cover sign."""

    name, version, reach, double_cover_sign = "rotations", "7", 20.0, False

    def __init__(self):
        self.engine = engine("numpy")

    def prepare(self, *motion):
        return self.engine.prepare(*motion)

    def states(self, prepared, t):
        assert max(map(abs, t)) < 1e6
        q, omega = self.engine.states(prepared, np.asarray(t))
        return np.copysign(1.0, q[:, 0])[:, None] * q, omega


def test_an_object_says_itself_what_it_is():
    report = few(Rotations(), strata=["uniform"])
    assert report.by_stratum("angle")["uniform"].error < 2e-15
    assert report.campaign.peers == ("rotations",)
    assert report.campaign.peer_versions == ("7",)
    assert (
        few(Rotations(), strata=["uniform"], double_cover_sign=True).by_stratum()["uniform"].error
        > 1
    )
    assert few(Rotations(), name="other").campaign.peers == ("other",)


def test_validate_takes_no_part_in_it():
    report = validate(["numpy"], cases=1, strata=["uniform"])
    assert report.campaign.judged == ("numpy",)
    assert set(report.by_stratum()) == {"uniform"}


def test_progress_counts_cases():
    told = []
    few(exact, cases=2, progress=lambda done, total: told.append((done, total)))
    assert told == [(k, 4) for k in range(1, 5)]


@pytest.mark.parametrize(
    ("integrator", "options", "line"),
    [
        (3, {}, "integrator = 3: must be a function of"),
        (exact, {"name": ""}, "name = '': must be words"),
        (exact, {"name": "../x"}, "name = '../x': must be words"),
        (exact, {"name": 3}, "name = 3: must be words"),
        (exact, {"name": "dop853"}, "name = dop853: is measured by that name already"),
        (exact, {"name": "numpy"}, "name = numpy: is measured by that name already"),
        (exact, {"reach": 0}, "reach = 0: must be a number above zero"),
        (exact, {"reach": math.nan}, "reach = nan: must be a number above zero"),
        (exact, {"reach": "far"}, "reach = 'far': must be a number above zero"),
        (exact, {"cases": 0}, "cases = 0: must be a whole number, at least 1"),
        (exact, {"cases": 1.5}, "cases = 1.5: must be a whole number, at least 1"),
        (exact, {"digits": 3}, "digits = 3: must be at least 20"),
        (exact, {"strata": ["foo"]}, "stratum = foo: must be one of"),
    ],
)
def test_options_that_mean_nothing(integrator, options, line):
    with pytest.raises(InputError) as caught:
        few(integrator, **options)
    assert str(caught.value).startswith(line)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("arguments", "line"),
    [(("foo",), "measure = foo: must be one of: angle,"),
     (("angle", "you"), "name = you: must be one of: exact")],
)  # fmt: skip
def test_what_was_not_measured_has_no_errors(arguments, line):
    with pytest.raises(InputError) as caught:
        few(exact, strata=["rest"]).by_stratum(*arguments)
    assert str(caught.value).startswith(line)


def test_lambdas_and_objects_have_names():
    assert few(lambda *given: exact(*given)).campaign.peers == ("lambda",)

    class Mine:
        def __call__(self, *given):
            return exact(*given)

    assert few(Mine()).campaign.peers == ("Mine",)
    assert set(FEW) < set(STRATA)
