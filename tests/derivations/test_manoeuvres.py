"""Facts that the planner cites: they are proved, and hold for its own numbers."""

import re
from pathlib import Path

import numpy as np
import pytest
from ledgers import CONTEXTS, FACTS
from random_manoeuvres import manoeuvre, posed
from values import value_of

from rigidsym import _engines as engines
from rigidsym.language._expression import parse
from rigidsym.manoeuvre import _directions as directions
from rigidsym.manoeuvre import _problem as problem
from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._families import families, least

PLANNER = [*Path(problem.__file__).parent.glob("*.py")]
ENGINE = engines.engine("numpy")
ENDS = [posed(manoeuvre(index), ENGINE) for index in range(10)]


def named(path):
    """Yield the facts that a file of the planner cites."""
    text = " ".join(path.read_text("utf-8").split())
    for cited in re.findall(r"[Ff]acts? ((?:\w+\.\w+(?:, )?)+)", text):
        yield from re.findall(r"\w+\.\w+", cited)


def at_start(posed, momentum):
    """Return the names of the context `manoeuvre` in float64, for one momentum of a problem."""
    found = {f"c{k}": float(c) for k, c in enumerate(posed.inertia, 1)}
    found |= {f"p{k}": float(p) for k, p in enumerate(posed.turn)}
    found |= {f"M{k}": float(m) for k, m in enumerate(momentum, 1)}
    found["K"] = float(np.linalg.norm(momentum))
    for name, text in CONTEXTS["manoeuvre"]["definitions"].items():
        found[name] = value_of(parse(text), found, {})
    return found


def vector(found, name):
    return np.array([found[f"{name}{k}"] for k in (1, 2, 3)])


def matrix(found, name):
    return np.array([[found[f"{name}{j}{k}"] for k in (1, 2, 3)] for j in (1, 2, 3)])


def test_the_planner_cites_facts_that_are_proved():
    cited = {fact for path in PLANNER for fact in named(path)}
    assert len(cited) > 10
    assert {FACTS[fact]["grade"] for fact in cited} == {"PROVED"}


@pytest.mark.parametrize("posed", ENDS)
def test_turn_and_cone_are_those_of_the_planner(posed):
    momentum = np.array([0.3, -0.5, 0.8])
    found = at_start(posed, momentum)
    assert np.allclose(matrix(found, "R"), posed.rotation, rtol=0, atol=1e-14)
    assert np.allclose(vector(found, "N"), momentum @ posed.rotation, rtol=0, atol=1e-14)
    scale = 1 / posed.inertia.min()
    form = directions.quadratic_form(posed)
    assert np.allclose(matrix(found, "A"), form, rtol=0, atol=1e-14 * scale)


@pytest.mark.parametrize("posed", ENDS)
def test_motions_that_arrive_begin_on_the_cone(posed):
    found = families(posed, 1.5 * least(posed))
    assert len(found)
    for rates in found:
        momentum = posed.inertia * rates
        form = matrix(at_start(posed, momentum), "A")
        assert abs(momentum @ form @ momentum) < 1e-9 * (momentum @ rates)


def test_a_motion_that_arrives_by_a_symmetry_does_so_from_any_time_on():
    turn = np.array([np.cos(0.7), 0.0, 0.0, np.sin(0.7)])
    ends = problem.Problem(np.array([1.0, 1.0, 0.4]), turn, ENGINE)
    assert is_symmetry(ends)
    tilted = [rates for rates in families(ends, 9.0) if np.linalg.norm(rates[:2]) > 0.1]
    assert tilted
    times = np.linspace(0, 7, 15)
    for rates in tilted:
        _, later = ENGINE.propagate(ends.inertia, rates, problem.IDENTITY, times)
        assert np.ptp(later[:, 0]) > 0.1
        assert np.linalg.norm(ends.misses(later), axis=1).max() < 1e-9
