"""Interactive pictures: their traces, and that the numbers in them are those of the motion."""

import sys

import numpy as np
import pytest
from picture_motions import MOTIONS

from rigidsym import InputError, Regime
from rigidsym.quaternions import product, rotated
from rigidsym.view._geometry import once, period, upright
from rigidsym.view.scenes import (
    momentum_sphere,
    rolling_ellipsoid,
    sphere_and_body,
    tumbling_body,
)
from rigidsym.view.scenes._pictures import edges, rolling

PICTURES = (momentum_sphere, rolling_ellipsoid, tumbling_body)
MOVING = [name for name in MOTIONS if name != "rest"]
TRACED = [name for name in MOVING if not MOTIONS[name].regime.steady]


def trace(figure, name):
    found = [t for t in figure.data if t.name == name]
    return np.stack([found[0].x, found[0].y, found[0].z], 1).astype(float)


def without_gaps(points):
    return points[~np.isnan(points).any(axis=1)]


def body(motion):
    inertia = np.array([float(x) for x in motion.exact["inertia"]])
    omega = np.array([float(x) for x in motion.exact["omega0"]])
    return inertia, omega, float(np.linalg.norm(inertia * omega))


@pytest.mark.parametrize("name", TRACED)
def test_the_polhode_lies_on_sphere_and_ellipsoid(name):
    motion = MOTIONS[name]
    inertia, omega, size = body(motion)
    points = trace(momentum_sphere(motion), "this motion") / size
    energy = (inertia * omega**2).sum() / size**2
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1e-9
    assert np.abs((points**2 / inertia).sum(axis=1) / energy - 1).max() < 1e-9
    apart = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert apart.max() < 0.25
    closed = np.linalg.norm(points[0] - points[-1])
    assert closed < 1e-9 or motion.regime == Regime.SEPARATRIX


@pytest.mark.parametrize("name", MOVING)
def test_the_separatrix_has_the_energy_of_spin_about_the_middle_axis(name):
    motion = MOTIONS[name]
    inertia, _, size = body(motion)
    figure = momentum_sphere(motion)
    if motion.regime == Regime.SPHERICAL:
        assert "separatrix" not in {t.name for t in figure.data}
        return
    points = without_gaps(trace(figure, "separatrix")) / size
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1e-9
    assert np.abs((points**2 / inertia).sum(axis=1) * np.median(inertia) - 1).max() < 1e-9


def test_families_are_coloured_by_regime():
    figure = momentum_sphere(MOTIONS["paper"], family=3)
    named = {str(Regime.LARGEST), str(Regime.SMALLEST)}
    colours = {t.name: t.line.color for t in figure.data if t.name in named}
    assert {*colours} == named
    assert len({*colours.values()}) == 2
    for name in colours:
        points = trace(figure, name)
        assert np.isnan(points).any(axis=1).sum() == 2 * 3 - 1
        size = body(MOTIONS["paper"])[2]
        assert np.abs(np.linalg.norm(without_gaps(points), axis=1) / size - 1).max() < 1e-9
    assert figure.layout.scene.xaxis.title.text == "M₁ (kg m²/s)"


@pytest.mark.parametrize("name", MOVING)
def test_the_ellipsoid_touches_the_plane_at_omega_and_does_not_slip(name):
    motion = MOTIONS[name]
    inertia, omega, size = body(motion)
    rate = float(np.linalg.norm(omega))
    figure = rolling_ellipsoid(motion)
    height = (inertia * omega**2).sum() / size
    path = trace(figure, "herpolhode")
    assert np.abs(path[:, 2] - height).max() < 1e-9 * rate
    for frame in figure.frames[::12]:
        contact = trace(frame, "contact")[0]
        assert abs(contact[2] - height) < 1e-9 * rate
        # The body's point of contact: on its ellipsoid, whose highest point it is.
        polhode = trace(frame, "polhode")
        assert polhode[:, 2].max() < height + 1e-9 * rate
        surface = np.stack([frame.data[0][x] for x in "xyz"], 2).astype(float)
        assert surface[..., 2].max() < height + 1e-5 * rate
    assert len({step.label for step in figure.layout.sliders[0].steps}) > 1


def test_rolling_is_the_motion_with_its_momentum_upright():
    motion = MOTIONS["largest"]
    inertia, *_ = body(motion)
    times = np.linspace(0, 5, 11)
    found = rolling(motion, times)
    _, omega = motion(times)
    momentum = rotated(found.q, inertia * omega)
    assert np.abs(momentum[:, :2]).max() < 1e-12
    assert np.all(momentum[:, 2] > 0)
    assert np.allclose(found.contact, rotated(found.q, omega), rtol=0, atol=1e-12)
    on = (rotated(found.q * [1, -1, -1, -1], found.contact) / found.axes) ** 2
    assert np.allclose(on.sum(axis=1), 1, rtol=1e-12)


@pytest.mark.parametrize("name", MOTIONS)
def test_the_box_turns_as_the_attitude_does(name):
    motion = MOTIONS[name]
    figure = tumbling_body(motion, np.linspace(0, 3, 5))
    size = edges(body(motion)[0])
    q, _ = motion(np.linspace(0, 3, 5))
    assert len(figure.frames) == 5
    for frame, attitude in zip(figure.frames, q, strict=True):
        corners = np.stack([frame.data[0].x, frame.data[0].y, frame.data[0].z], 1)
        assert np.allclose(corners[7] - corners[3], rotated(attitude, [size[0], 0, 0]), atol=1e-5)
        assert np.allclose(corners[7] - corners[5], rotated(attitude, [0, size[1], 0]), atol=1e-5)
        assert np.allclose(corners[7] - corners[6], rotated(attitude, [0, 0, size[2]]), atol=1e-5)


def test_the_sphere_and_the_body_move_together():
    """One slider: the dot on the left is I omega, the box on the right has its attitude."""
    motion, times = MOTIONS["paper"], [0.0, 20.0, 50.0]
    figure = sphere_and_body(motion, times)
    assert figure.layout.title.text == str(motion.regime)
    assert {trace.scene for trace in figure.data} == {None, "scene2"}
    alone = tumbling_body(motion, times)
    inertia = np.array([float(x) for x in motion.exact["inertia"]])
    for frame, other, omega in zip(figure.frames, alone.frames, motion(times)[1], strict=True):
        dot, *moved = frame.data
        assert np.allclose(np.ravel([dot.x, dot.y, dot.z]), inertia * omega, rtol=1e-10)
        assert figure.data[frame.traces[0]].name == dot.name == "momentum now"
        assert [figure.data[k].name for k in frame.traces[1:]] == [part.name for part in moved]
        for one, two in zip(moved, other.data, strict=True):
            assert one.scene == "scene2"
            assert np.array_equal(one.x, two.x)


def test_a_box_has_the_proportions_of_its_moments():
    a, b, c = 1.0, 0.6, 0.3
    moments = np.array([b * b + c * c, c * c + a * a, a * a + b * b]) / 12
    assert np.allclose(edges(moments), (a, b, c))
    assert edges(np.array([1.0, 2.0, 3.0])).min() > 0


@pytest.mark.parametrize("draw", PICTURES)
def test_one_line_where_plotly_is_missing(monkeypatch, draw):
    monkeypatch.setitem(sys.modules, "plotly.graph_objects", None)
    with pytest.raises(ImportError, match=rf"^{draw.__name__} needs plotly \(extra lab\): pip"):
        draw(MOTIONS["paper"])


@pytest.mark.parametrize("draw", PICTURES[:2])
def test_rest_has_no_sphere_and_no_ellipsoid(draw):
    with pytest.raises(InputError, match="at rest"):
        draw(MOTIONS["rest"])


@pytest.mark.parametrize("draw", PICTURES[1:])
def test_a_picture_that_moves_needs_times(draw):
    with pytest.raises(InputError, match="two or more"):
        draw(MOTIONS["paper"], [1.0])


@pytest.mark.parametrize("name", TRACED)
def test_after_a_period_the_rates_are_back(name):
    motion = MOTIONS[name]
    found = period(motion)
    if motion.regime == Regime.SEPARATRIX:
        assert found == np.inf
        first, last = once(motion)
        ends = motion([first, last])[1]
        assert np.allclose(np.abs(ends[:, 1]), np.linalg.norm(ends, axis=1), rtol=1e-5)
        return
    _, omega = motion([0.0, found, found / 2])
    rate = np.linalg.norm(omega[0])
    assert np.abs(omega[1] - omega[0]).max() < 1e-9 * rate
    assert np.abs(omega[2] - omega[0]).max() > 1e-5 * rate


def test_the_shortest_rotation_to_the_third_axis():
    for vector in ([1.0, 2.0, -3.0], [0.0, 0.0, -2.0], [0.0, 0.0, 1.0]):
        q = upright(np.array(vector))
        assert np.allclose(rotated(q, np.array(vector)), [0, 0, np.linalg.norm(vector)])
        assert np.allclose(product(q, q * [1, -1, -1, -1]), [1, 0, 0, 0])
