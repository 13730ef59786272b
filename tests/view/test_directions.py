"""The directions of a plan: what is drawn lies on the cone, and transfers begin and end there."""

import sys

import numpy as np
import pytest

from rigidsym import plan
from rigidsym.manoeuvre import directions_of
from rigidsym.manoeuvre._problem import problem
from rigidsym.view.scenes._still import still

INERTIA = (0.0109, 0.04, 0.0506)
START, TARGET = (1, 0, 0, 0), (0.5, -0.1, -0.5, 0.7)


def planned(inertia=INERTIA, target=TARGET, families=3):
    return plan(inertia, START, target, 120, families=families, engine="numpy")


def points(figure, name):
    (found,) = (trace for trace in figure.data if trace.name == name)
    whole = np.stack([found.x, found.y, found.z], 1).astype(float)
    return whole[~np.isnan(whole).any(axis=1)]


def test_the_cone_has_the_same_energy_at_both_ends():
    found = planned()
    asked = found.manoeuvre
    posed = problem(asked.inertia, asked.start, asked.target, None)
    begin = points(directions_of(found), "cone of directions")
    end = begin @ posed.rotation
    assert np.abs(np.linalg.norm(begin, axis=1) - 1).max() < 1e-9
    assert np.abs(((begin**2 - end**2) / INERTIA).sum(axis=1)).max() < 1e-8
    assert len({*np.sign(begin @ begin[0])}) == 2


def test_transfers_go_from_the_cone_to_where_the_turn_puts_them():
    found = planned()
    asked = found.manoeuvre
    posed = problem(asked.inertia, asked.start, asked.target, None)
    figure = directions_of(found)
    cone = points(figure, "cone of directions")
    for k, transfer in enumerate(found.transfers, 1):
        way = points(figure, f"transfer {k}")
        begin = np.array(INERTIA) * transfer.omega0 / transfer.momentum
        assert np.allclose(way[0], begin, atol=1e-9)
        assert np.allclose(way[-1], begin @ posed.rotation, atol=1e-9)
        assert np.linalg.norm(cone - begin, axis=1).min() < 0.05
        assert np.allclose(points(figure, f"transfer {k}, ends")[0], way[-1], atol=1e-9)


@pytest.mark.parametrize(
    ("inertia", "target", "named"),
    [
        (INERTIA, (0, 0, 0, 1), "one of each polhode"),
        ((1, 1, 1), TARGET, None),
        ((1, 1, 1.5), TARGET, "cone of directions"),
        (INERTIA, START, "one of each polhode"),
    ],
)
def test_edges_are_drawn(inertia, target, named):
    figure = directions_of(planned(inertia, target, 2))
    names = {trace.name for trace in figure.data}
    assert {"cone of directions", "one of each polhode"} & names == ({named} - {None})
    assert len(still(figure)) < 60_000


def test_without_plotly_the_error_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "plotly.graph_objects", None)
    with pytest.raises(ImportError, match=r"directions_of needs plotly"):
        directions_of(planned(families=1))
