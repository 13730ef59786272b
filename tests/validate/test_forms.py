"""Comparison of forms: the series are the motion, and operations are counted as printed."""

import json
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import TorqueFreeMotion
from rigidsym.precise._motion import PreciseMotion
from rigidsym.validate._forms import compare, fourier

T = np.linspace(-20.0, 20.0, 9)


def motion(inertia, omega0, attitude0=(0.5, 0.5, -0.5, 0.5)):
    exact = [tuple(map(Fraction, values)) for values in (inertia, omega0, attitude0)]
    return PreciseMotion(*exact), TorqueFreeMotion(inertia, omega0, attitude0)


@pytest.mark.parametrize(
    ("inertia", "omega0"),
    [
        ((1.0, 2.0, 2.25), (0.75, 0.5, 2.0)),
        ((1.0, 2.0, 2.25), (0.75, -0.5, 0.9)),
        ((2.25, 1.0, 2.0), (-0.7, 0.3, 0.4)),
        ((2.0, 2.25, 1.0), (0.1, -0.4, -1.5)),
        ((1.0, 2.0, 2.25), (0.75, 0.5, 1.0001)),
    ],
)
def test_fourier_series_are_the_motion(inertia, omega0):
    exact, true = motion(inertia, omega0)
    q, omega = fourier.plan(exact).states(T)
    expected = true(T)
    np.testing.assert_allclose(q, expected[0], rtol=0, atol=3e-15)
    np.testing.assert_allclose(omega, expected[1], rtol=0, atol=3e-15)


def test_terms_grow_with_the_modulus_and_end_before_the_separatrix():
    series = [
        fourier.plan(motion((1.0, 2.0, 2.25), (0.75, 0.5, 1 + x))[0]) for x in (16, 0.1, 1e-8)
    ]
    terms = [each.terms for each in series]
    assert terms == sorted(terms)
    assert terms[-1] > 5 * terms[0]
    on_it = motion((1.0, 2.0, 2.25), (0.75, 0.5, 1.0))[0]
    assert fourier.plan(on_it) is None


def test_operations_of_a_form_are_those_of_its_lines():
    assert compare.operations("theta", "circular") < compare.operations("pi", "circular")
    some = compare.operations("pi", "circular", ["angles"])
    assert some + compare.operations("pi", "circular", ["state"]) == compare.operations(
        "pi", "circular"
    )
    assert compare.constant_bytes("theta", "steady") == 8 * 9


def test_one_table_and_one_figure(monkeypatch):
    monkeypatch.setattr(compare, "AWAY", (1.0, 0.0))
    monkeypatch.setattr(compare, "_REPEATS", 1)
    listed = ("uniform", "symmetric", "separatrix")
    monkeypatch.setattr(compare, "STRATA", {name: compare.STRATA[name] for name in listed})
    found = compare.compare_forms(cases=2)
    assert {one.form for one in found.costs} == {"theta", "pi", "Fourier"}
    generated = [one for one in found.costs if one.form != "Fourier"]
    assert all(max(one.angle, one.omega) < 2e-15 for one in generated)
    (ended,) = (one for one in found.costs if one.form == "Fourier" and one.away == 0)
    assert ended.terms is None
    data = json.loads(found.to_json())
    assert data["schema"] == "rigidsym.forms/1"
    assert set(data["code_bytes"]) == {"theta", "pi"}
    assert found.to_markdown().count("| Fourier |") == 2 + len(listed)
    assert [(one.stratum, one.form) for one in found.strata[:3]] == [
        ("uniform", "theta"),
        ("uniform", "pi"),
        ("uniform", "Fourier"),
    ]
    worst = {(one.stratum, one.form): one for one in found.strata}
    for stratum in listed[:2]:
        assert max(worst[stratum, form].angle for form in data["code_bytes"]) < 3e-15
        assert worst[stratum, "Fourier"].served == 2
        assert worst[stratum, "Fourier"].omega < 1e-14
    assert worst["separatrix", "Fourier"].served == 0
    assert worst["separatrix", "Fourier"].angle is None
    assert all(one.plan_us > 0 for one in found.costs if one.form == "Fourier" and one.terms)
    assert "Fly the theta form" in found.conclusion
