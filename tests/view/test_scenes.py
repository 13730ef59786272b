"""Interactive pictures show the numbers of the motion, and have a still image."""

import base64
import sys

import numpy as np
import pytest
from picture_motions import MOTIONS, MOVING, picture

from rigidsym import InputError, Regime, TorqueFreeMotion, plan
from rigidsym.manoeuvre import directions_of
from rigidsym.manoeuvre._problem import problem
from rigidsym.quaternions import product, rotated
from rigidsym.view._geometry import once, upright
from rigidsym.view.scenes import (
    momentum_sphere,
    rolling_ellipsoid,
    sphere_and_body,
    tumbling_body,
)
from rigidsym.view.scenes._pictures import edges, rolling
from rigidsym.view.scenes._still import still

pytest.importorskip("IPython", reason="IPython is not installed: extra `lab`")
plotly_io = pytest.importorskip("plotly.io", reason="plotly is not installed: extra `lab`")
image = pytest.importorskip("matplotlib.image", reason="matplotlib is not installed: extra `lab`")

PICTURES = (momentum_sphere, rolling_ellipsoid, tumbling_body)
TRACED = [name for name in MOVING if not MOTIONS[name].regime.steady]
INERTIA = (0.0109, 0.04, 0.0506)
START, TARGET = (1, 0, 0, 0), (0.5, -0.1, -0.5, 0.7)
KIND = "application/vnd.plotly.v1+json"


def points(figure, name):
    """Return the points of the one trace of a name, with its gaps."""
    (found,) = (trace for trace in figure.data if trace.name == name)
    return np.stack([found.x, found.y, found.z], 1).astype(float)


def without_gaps(points):
    return points[~np.isnan(points).any(axis=1)]


def body(motion):
    """Return the moments of inertia, the initial rates, and |M|."""
    inertia, omega = (np.array([*map(float, motion.exact[x])]) for x in ("inertia", "omega0"))
    return inertia, omega, float(np.linalg.norm(inertia * omega))


@pytest.mark.parametrize("name", MOVING)
def test_polhode_and_separatrix_lie_on_the_sphere_and_have_their_energy(name):
    """The separatrix has the energy of a spin about the middle axis."""
    motion, figure = MOTIONS[name], picture(momentum_sphere, name)
    inertia, omega, size = body(motion)
    assert ("separatrix" in {t.name for t in figure.data}) == (motion.regime != Regime.SPHERICAL)
    curves = []
    if motion.regime != Regime.SPHERICAL:
        circles = without_gaps(points(figure, "separatrix")) / size
        curves.append((circles, 1 / np.median(inertia)))
    if not motion.regime.steady:
        polhode = points(figure, "this motion") / size
        curves.append((polhode, (inertia * omega**2).sum() / size**2))
        assert np.linalg.norm(np.diff(polhode, axis=0), axis=1).max() < 0.25
        closed = np.linalg.norm(polhode[0] - polhode[-1])
        assert closed < 1e-9 or motion.regime == Regime.SEPARATRIX
    for curve, energy in curves:
        assert np.abs(np.linalg.norm(curve, axis=1) - 1).max() < 1e-9
        assert np.abs((curve**2 / inertia).sum(axis=1) / energy - 1).max() < 1e-9


def test_families_are_coloured_by_regime():
    figure = momentum_sphere(MOTIONS["paper"], family=3)
    named = {str(Regime.LARGEST), str(Regime.SMALLEST)}
    colours = {t.name: t.line.color for t in figure.data if t.name in named}
    assert {*colours} == named
    assert len({*colours.values()}) == 2
    size = body(MOTIONS["paper"])[2]
    for name in colours:
        polhodes = points(figure, name)
        assert np.isnan(polhodes).any(axis=1).sum() == 2 * 3 - 1
        assert np.abs(np.linalg.norm(without_gaps(polhodes), axis=1) / size - 1).max() < 1e-9
    assert figure.layout.scene.xaxis.title.text == "M₁ (kg m²/s)"


@pytest.mark.parametrize("name", MOVING)
def test_the_ellipsoid_touches_the_plane_at_omega_and_does_not_slip(name):
    inertia, omega, size = body(MOTIONS[name])
    rate = float(np.linalg.norm(omega))
    figure = picture(rolling_ellipsoid, name)
    height = (inertia * omega**2).sum() / size
    assert np.abs(points(figure, "herpolhode")[:, 2] - height).max() < 1e-9 * rate
    for frame in figure.frames[::12]:
        assert abs(points(frame, "contact")[0, 2] - height) < 1e-9 * rate
        # The body's point of contact: on its ellipsoid, whose highest point it is.
        assert points(frame, "polhode")[:, 2].max() < height + 1e-9 * rate
        surface = np.asarray(frame.data[0].z, dtype=float)
        assert surface.max() < height + 1e-5 * rate
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
    motion, times = MOTIONS[name], np.linspace(0, 3, 5)
    figure = tumbling_body(motion, times)
    sides = np.diag(edges(body(motion)[0]))
    q, _ = motion(times)
    assert len(figure.frames) == 5
    for frame, attitude in zip(figure.frames, q, strict=True):
        corners = np.stack([frame.data[0].x, frame.data[0].y, frame.data[0].z], 1)
        for corner, side in zip((3, 5, 6), sides, strict=True):
            assert np.allclose(corners[7] - corners[corner], rotated(attitude, side), atol=1e-5)


def test_the_sphere_and_the_body_move_together():
    """One slider moves both: the dot is I omega, the box has the attitude."""
    motion, times = MOTIONS["paper"], [0.0, 20.0, 50.0]
    figure, alone = sphere_and_body(motion, times), tumbling_body(motion, times)
    assert figure.layout.title.text == str(motion.regime)
    assert {trace.scene for trace in figure.data} == {None, "scene2"}
    inertia, *_ = body(motion)
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


@pytest.mark.parametrize("name", TRACED)
def test_after_a_period_the_rates_are_back(name):
    motion = MOTIONS[name]
    found = motion.period
    if motion.regime == Regime.SEPARATRIX:
        assert found == np.inf
        ends = motion(once(motion))[1]
        assert np.allclose(np.abs(ends[:, 1]), np.linalg.norm(ends, axis=1), rtol=1e-5)
        return
    _, omega = motion([0.0, found, found / 2])
    rate = np.linalg.norm(omega[0])
    assert np.abs(omega[1] - omega[0]).max() < 1e-9 * rate
    assert np.abs(omega[2] - omega[0]).max() > 1e-5 * rate


@pytest.mark.parametrize("vector", [[1.0, 2.0, -3.0], [0.0, 0.0, -2.0], [0.0, 0.0, 1.0]])
def test_the_shortest_rotation_to_the_third_axis(vector):
    q = upright(np.array(vector))
    assert np.allclose(rotated(q, np.array(vector)), [0, 0, np.linalg.norm(vector)])
    assert np.allclose(product(q, q * [1, -1, -1, -1]), [1, 0, 0, 0])


def planned(inertia=INERTIA, target=TARGET, families=3):
    return plan(inertia, START, target, 120, families=families, engine="numpy")


@pytest.fixture(scope="module")
def directions():
    """A plan, the rotation it asks for, and the picture of its directions."""
    found = planned()
    asked = found.manoeuvre
    rotation = problem(asked.inertia, asked.start, asked.target, None).rotation
    return found, rotation, directions_of(found)


def test_the_cone_has_the_same_energy_at_both_ends(directions):
    _, rotation, figure = directions
    begin = without_gaps(points(figure, "cone of directions"))
    assert np.abs(np.linalg.norm(begin, axis=1) - 1).max() < 1e-9
    end = begin @ rotation
    assert np.abs(((begin**2 - end**2) / INERTIA).sum(axis=1)).max() < 1e-8
    assert len({*np.sign(begin @ begin[0])}) == 2


def test_transfers_go_from_the_cone_to_where_the_turn_puts_them(directions):
    found, rotation, figure = directions
    cone = without_gaps(points(figure, "cone of directions"))
    for k, transfer in enumerate(found.transfers, 1):
        way = points(figure, f"transfer {k}")
        begin = np.array(INERTIA) * transfer.omega0 / transfer.momentum
        assert np.allclose(way[0], begin, atol=1e-9)
        assert np.allclose(way[-1], begin @ rotation, atol=1e-9)
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
def test_directions_of_symmetric_bodies_and_turns_are_drawn(inertia, target, named):
    figure = directions_of(planned(inertia, target, 2))
    names = {trace.name for trace in figure.data}
    assert {"cone of directions", "one of each polhode"} & names == ({named} - {None})
    assert len(still(figure)) < 60_000


@pytest.mark.parametrize("draw", [*PICTURES, directions_of])
def test_one_line_where_plotly_is_missing(monkeypatch, draw):
    value = planned(families=1) if draw is directions_of else MOTIONS["paper"]
    monkeypatch.setitem(sys.modules, "plotly.graph_objects", None)
    with pytest.raises(ImportError, match=rf"^{draw.__name__} needs plotly \(extra lab\): pip"):
        draw(value)


@pytest.mark.parametrize(
    ("draw", "name", "times", "message"),
    [
        *((draw, "rest", [], "at rest") for draw in PICTURES[:2]),
        *((draw, "paper", [[1.0]], "two or more") for draw in PICTURES[1:]),
    ],
)
def test_what_cannot_be_drawn_is_refused(draw, name, times, message):
    with pytest.raises(InputError, match=message):
        draw(MOTIONS[name], *times)


@pytest.fixture
def shown(monkeypatch):
    """The outputs that a notebook gets."""
    found = []
    monkeypatch.setattr(plotly_io.renderers, "default", "plotly_mimetype")
    monkeypatch.setattr("IPython.display.display", lambda data, raw: found.append(data))
    return found


@pytest.mark.parametrize("draw", PICTURES)
@pytest.mark.parametrize("name", MOVING)
def test_pictures_are_small_and_stills_smaller_with_colours(draw, name, tmp_path):
    figure = picture(draw, name)
    assert len(figure.to_json()) < 1_200_000
    data = still(figure)
    assert len(data) < 60_000
    (tmp_path / "still.jpeg").write_bytes(data)
    pixels = image.imread(tmp_path / "still.jpeg")
    assert pixels.shape[0] > 300
    assert len(np.unique(pixels.astype(int) @ [256**2, 256, 1])) > 20


def test_a_still_has_what_was_added_to_the_picture():
    figure = momentum_sphere(MOTIONS["paper"])
    before = still(figure)
    figure.add_scatter3d(x=[0, 1e-3], y=[0, 0], z=[0, 1e-3], line={"color": "#ff0000"})
    assert still(figure) != before


def test_both_are_one_output(shown):
    figure = picture(tumbling_body, "paper")
    figure.show()
    figure._ipython_display_()
    assert shown[0] == shown[1]
    assert set(shown[0]) == {KIND, "image/jpeg"}
    assert base64.b64decode(shown[0]["image/jpeg"]).startswith(b"\xff\xd8\xff")
    assert len(shown[0][KIND]["data"]) == len(figure.data)


def test_a_picture_without_a_still_is_shown_alone(shown, monkeypatch):
    figure = momentum_sphere(MOTIONS["paper"])
    figure.add_cone(x=[0], y=[0], z=[0], u=[1], v=[0], w=[0])
    figure.show()
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    picture(momentum_sphere, "paper").show()
    assert [*map(set, shown)] == [{KIND}, {KIND}]


def test_other_renderers_are_plotlys(shown, monkeypatch):
    asked, figure = [], picture(momentum_sphere, "paper")
    monkeypatch.setattr(plotly_io, "show", lambda picture, **how: asked.append(how))
    figure.show(renderer="browser")
    monkeypatch.setattr(plotly_io.renderers, "default", "browser")
    figure.show()
    assert asked == [{"renderer": "browser"}, {}]
    assert shown == []


@pytest.mark.parametrize("draw", [*PICTURES, sphere_and_body])
def test_what_is_no_motion_is_refused(draw):
    tensor = TorqueFreeMotion.from_tensor(np.diag(INERTIA), (0.1, 0.2, 0.3))
    line = r"^motion = .*: must be a TorqueFreeMotion .*principal"
    for given in (np.zeros((3, 4)), INERTIA, tensor):
        with pytest.raises(InputError, match=line):
            draw(given)
