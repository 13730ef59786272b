"""Comparison of methods: errors within radii, motions on the separatrix, and equal bytes."""

import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from fractions import Fraction
from itertools import product

import pytest
from mpmath import mp

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.io.cases import Case, paper_case, parse_case
from rigidsym.precise import METHODS
from rigidsym.precise import _comparison as comparison
from rigidsym.precise._comparison import DISTANCES, NAMES, compare
from rigidsym.solution._polhode import Regime

PAPER = paper_case()
SHORT = Case(PAPER.motion, (Fraction(5),))


@pytest.fixture(autouse=True, scope="module")
def quickly():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(comparison, "REPEATS", 1)
        patch.setattr(comparison, "DISTANCE_DIGITS", 20)
        yield


@pytest.fixture(scope="module")
def found(quickly):
    return compare(SHORT, [20, 10, 20, 150])


@pytest.fixture
def near_and_on(monkeypatch):
    """Compare at two distances from the separatrix alone."""
    monkeypatch.setattr(comparison, "DISTANCES", ("1e-1", "0"))


def without_seconds(found):
    data = json.loads(found.to_json())
    for measurement in data["by_digits"] + data["by_distance"]:
        del measurement["seconds"], measurement["seconds_more"]
    return data


def test_every_method_at_every_setting_once(found):
    by_digits = [(m.digits, m.method) for m in found.by_digits]
    by_distance = [(m.distance, m.method) for m in found.by_distance]
    assert by_digits == [*product((10, 20, 150), NAMES)]
    assert by_distance == [*product(DISTANCES, NAMES)]


def test_errors_are_as_small_as_asked_for_and_within_the_radii(found):
    for m in (*found.by_digits, *found.by_distance):
        if (m.method, m.distance) == ("theorem1", "0"):
            assert m.seconds is None  # on the separatrix Lemma 1 has no sines
            continue
        assert 0 < mp.mpf(m.error) < mp.mpf(10) ** -m.digits
        if m.method not in METHODS:
            assert m.radius is None
        elif mp.mpf(m.radius) > mp.mpf(10) ** -(m.digits + 20):
            assert mp.mpf(m.error) <= mp.mpf(m.radius) * 1.1
        assert m.seconds > 0


@pytest.mark.usefixtures("near_and_on")
def test_a_wrong_method_is_seen(monkeypatch):
    exact = comparison.integrate

    def slightly_off(*arguments):
        q, omega = exact(*arguments)
        return [q[0] + mp.mpf(10) ** -9, *q[1:]], omega

    monkeypatch.setattr(comparison, "integrate", slightly_off)
    errors = {m.method: mp.mpf(m.error) for m in compare(SHORT, [20]).by_digits}
    assert 0.9e-9 < errors["taylor"] < 1.1e-9
    assert max(error for name, error in errors.items() if name != "taylor") < 1e-20


def test_the_family_ends_on_the_separatrix_of_a_neighbour(found):
    motion = TorqueFreeMotion(**found.neighbour)
    assert motion.regime == Regime.SEPARATRIX
    for a, b in zip(motion.inertia, PAPER.motion.inertia, strict=True):
        assert abs(a / b - 1) < Fraction(1, 10**11)
    third = motion.omega0[2]
    for delta in ("1e-30", "-1e-30"):
        off = [*motion.omega0[:2], third]
        off[0] *= 1 + Fraction(delta)
        assert TorqueFreeMotion(motion.inertia, off).regime != Regime.SEPARATRIX


def test_only_times_differ_between_runs(found):
    assert without_seconds(compare(SHORT, [10, 20, 150])) == without_seconds(found)


def test_the_plot_is_one_and_the_same_for_the_same_numbers(found):
    text = found.to_svg()
    assert text == found.to_svg()
    root = ET.fromstring(text)
    lines = [e for e in root.iter() if e.get("id", "").startswith("line ")]
    assert len(lines) == 4 * len(NAMES)


@pytest.mark.usefixtures("near_and_on")
def test_what_takes_too_long_is_not_run(monkeypatch):
    monkeypatch.setattr(comparison, "QUADRATURE_DIGITS", 15)
    monkeypatch.setattr(comparison, "TAYLOR_WORK", 50)
    far = compare(SHORT, [20])
    left_out = {m.method for m in far.by_digits if m.seconds is None}
    assert left_out == {"quadrature", "taylor"}
    assert all("not run" in m.row("20") for m in far.by_digits if m.method in left_out)
    assert ET.fromstring(far.to_svg()).tag.endswith("svg")


@pytest.mark.parametrize("inertia", ["[1, 1, 2]", "[1, 1, 1]"])
@pytest.mark.parametrize("rates", ["[0, 0, 0]", "[1, 0, 2]"])
def test_bodies_without_a_separatrix(inertia, rates):
    case = parse_case(f"inertia = {inertia}\nomega0 = {rates}\ntimes = [0]")
    found = compare(case, [15])
    assert found.by_distance == ()
    assert found.neighbour is None
    assert ET.fromstring(found.to_svg()).tag.endswith("svg")


def test_bad_cases_are_one_line():
    uncertain = TorqueFreeMotion(("0.0109 +/- 1e-9", "0.04", "0.0506"), PAPER.motion.omega0)
    for case, digits, message in (
        (replace(PAPER, times=()), [15], "times = "),
        (PAPER, [0], "digits = 0"),
        (replace(PAPER, motion=uncertain), [15], "only enclose"),
    ):
        with pytest.raises(InputError, match=message):
            compare(case, digits)
