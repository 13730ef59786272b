"""Interactive pictures of a motion's momentum sphere, rolling ellipsoid and tumbling body.

Another one has the momentum directions of a plan.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from rigidsym._inputs import Times
from rigidsym.errors import InputError, package, written
from rigidsym.quaternions import product, rotated
from rigidsym.solution._polhode import Regime
from rigidsym.view import _geometry as geometry
from rigidsym.view import _style as style
from rigidsym.view._geometry import REGIMES, moments, momentum
from rigidsym.view.scenes import _scene as scene
from rigidsym.view.scenes._scene import Trace

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.motion import TorqueFreeMotion

PLOTLY = "plotly.graph_objects"
POLHODE, ON_THE_WAY = 121, 361
"Points of a polhode on a sphere, and of the part of it that a transfer runs through."
ROLLING_FRAMES, SECTION, HERPOLHODE = 61, 97, 721
"Frames of the rolling ellipsoid, and points of its polhode and of the herpolhode."
BODY_FRAMES, AXIS_PATH = 145, 1201
"Frames of the tumbling body, and points of the path of an axis."
PAIR_FRAMES, PAIR_FAMILY, PAIR_WIDTH, PAIR_HEIGHT = 73, 3, 980, 640
THINNEST = 0.04
"The least edge of a box, its longest being 1."
_MESH = (13, 25)
_LEFT, _RIGHT = [0.0, 0.49], [0.51, 1.0]
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2
# Two triangles a side, sides in the order of the axes they lie across.
_TRIANGLES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1)]
_TRIANGLES += [(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def _check(motion: object, picture: str) -> None:
    """Raise InputError for what is no motion about principal axes, and need plotly."""
    package(PLOTLY, picture)
    if not hasattr(motion, "exact"):
        step = "of a motion from a tensor, draw its .principal"
        raise InputError(
            "motion", written(motion, repr), "must be a TorqueFreeMotion", next_step=step
        )


def momentum_sphere(motion: "TorqueFreeMotion", family: int = 5) -> "Figure":
    """Draw the momentum sphere in body axes, with polhodes coloured by regime.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion whose polhode is drawn thick.
    family : int
        Number of further polhodes about each end of each axis.

    Returns
    -------
    plotly.graph_objects.Figure
        Momenta in kg m^2/s; on the separatrix K^2 = 2H c_b.

    Raises
    ------
    InputError
        For a body at rest.
    ImportError
        If plotly is not installed.
    """
    _check(motion, "momentum_sphere")
    size = float(np.linalg.norm(momentum(motion)))
    if not size:
        raise InputError("omega0", "zero", "a body at rest has no momentum sphere")
    polhodes: dict[Regime, list[np.ndarray]] = {}
    for other in geometry.members(motion, size, family):
        points = moments(motion) * geometry.polhode(other, POLHODE)
        polhodes.setdefault(other.regime, []).append(points)
    traces = [
        *_globe(size),
        *(scene.line(_joined(x), str(name), REGIMES[name], 2.5) for name, x in polhodes.items()),
        *_separatrix(motion.exact["inertia"], size, 5),
    ]
    colour = REGIMES[motion.regime]
    if not motion.regime.steady:
        points = moments(motion) * geometry.polhode(motion, 2 * POLHODE - 1)
        traces.append(scene.line(points, "this motion", colour, 8))
    traces += [scene.dot(momentum(motion), "t = 0", colour), *_body_axes(1.15 * size)]
    title = f"Momentum sphere, |M| = {size:.4g} kg m²/s"
    return scene.figure(traces, title, style.MOMENTUM_AXES, 1.15 * size)


def directions(
    inertia: Sequence[Fraction],
    cone: tuple[str, Sequence[np.ndarray]],
    transfers: Mapping[str, "Transfer"],
    title: str,
) -> "Figure":
    """Draw the momentum directions of transfers on the unit sphere.

    A cone and the separatrix are drawn as well.  cone: its name and curves.  transfers: by name.
    """
    package(PLOTLY, "directions_of")
    traces = [*_globe(1.0), *_separatrix(inertia, 1.0, 2)]
    name, parts = cone
    if parts:
        traces.append(scene.line(_joined(parts), name, style.CONE, 7))
    for k, (called, transfer) in enumerate(transfers.items()):
        traces += _transfer(transfer, called, style.TRANSFERS[k % len(style.TRANSFERS)])
    return scene.figure([*traces, *_body_axes(1.15)], title, style.DIRECTION_AXES, 1.15)


def _transfer(transfer: "Transfer", name: str, colour: str) -> Iterator[Trace]:
    """Yield the plotly traces of a transfer's path, its end points and its whole polhode."""
    motion = transfer.motion
    size = float(np.linalg.norm(momentum(motion)))
    rates = motion(np.linspace(0, transfer.duration, ON_THE_WAY))[1]
    way = moments(motion) * rates / size
    begin = scene.dot(way[0], f"{name}, begins", colour, showlegend=motion.regime.steady)
    if motion.regime.steady:
        yield begin
        return
    whole = moments(motion) * geometry.polhode(motion, POLHODE) / size
    yield scene.line(whole, f"{name}, polhode", colour, 2, showlegend=False)
    yield scene.line(way, name, colour, 8)
    yield from (begin, scene.dot(way[-1], f"{name}, ends", style.GREY, showlegend=False))


def _joined(parts: Sequence[np.ndarray]) -> np.ndarray:
    """Join several curves into one curve with gaps between them."""
    gap = np.full((1, 3), np.nan)
    return np.concatenate([piece for part in parts for piece in (part, gap)][:-1])


def _globe(radius: float) -> list[Trace]:
    """Return the plotly traces of a sphere and its great circles.

    The circles have the radius `radius`; the sphere is slightly smaller.
    """
    circles = _joined(geometry.great_circles(radius))
    return [
        scene.skin(0.985 * radius * scene.ball(19, 37), style.GREY, 0.18),
        scene.sketch(circles, "sphere", style.GRID, 1, showlegend=False),
    ]


def _separatrix(inertia: Sequence[Fraction], size: float, width: float) -> list[Trace]:
    """Return the plotly traces of the separatrix on a sphere of radius `size`.

    There are none for a spherical body.
    """
    circles = geometry.separatrix(inertia, size)
    if not circles:
        return []
    return [scene.line(_joined(circles), "separatrix", geometry.SEPARATRIX, width)]


def _body_axes(length: float) -> list[Trace]:
    """Return the plotly traces of the positive halves of the three axes."""
    tips = length * np.eye(3)
    return [
        scene.line(np.stack([0 * tip, tip]), f"axis {k}", colour, 5, showlegend=False)
        for k, (tip, colour) in enumerate(zip(tips, style.AXES, strict=True), 1)
    ]


@dataclass(frozen=True, slots=True)
class Rolling:
    """States of a motion in inertial axes whose third axis is along the angular momentum.

    `height` is the distance 2H/K of the invariable plane from the centre; `axes` are the half axes
    sqrt(2H/c_i) of the ellipsoid.
    """

    q: np.ndarray
    contact: np.ndarray
    axes: np.ndarray
    height: float


def rolling(motion: "TorqueFreeMotion", times: np.ndarray) -> Rolling:
    """Compute states in inertial axes whose third axis is along the angular momentum."""
    start = motion(0.0)
    inertia, body = moments(motion), momentum(motion)
    front = geometry.upright(rotated(start[0], body))
    q, omega = motion(times)
    turned = product(front, q)
    double_energy = float(body @ start[1])
    height = double_energy / float(np.linalg.norm(body))
    return Rolling(turned, rotated(turned, omega), np.sqrt(double_energy / inertia), height)


def rolling_ellipsoid(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw the rolling ellipsoid with polhode and herpolhode.

    A slider selects the time.  The picture shows the space of rates, rad/s, with the momentum
    upwards: the contact is omega.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion to draw.
    times : array_like, shape (N,), optional
        Times of the slider, s; by default they cover two periods or a few turns.

    Returns
    -------
    plotly.graph_objects.Figure

    Raises
    ------
    InputError
        For a body at rest, and for fewer than two times.
    ImportError
        If plotly is not installed.
    """
    _check(motion, "rolling_ellipsoid")
    if not any(motion.exact["omega0"]):
        raise InputError("omega0", "zero", "the ellipsoid of a body at rest is a point")
    shown = geometry.chosen(motion, times, ROLLING_FRAMES)
    path = rolling(motion, np.linspace(min(shown[0], 0.0), shown[-1], HERPOLHODE))
    steps = rolling(motion, shown)
    ellipsoid = steps.axes * scene.ball(*_MESH)
    sections = _joined([steps.axes * circle[::2] for circle in geometry.great_circles(1.0)])
    polhode, colour = geometry.polhode(motion, SECTION), REGIMES[motion.regime]
    frames = [
        [
            scene.skin(rotated(q, ellipsoid), style.ELLIPSOID, 0.45),
            scene.sketch(rotated(q, sections), "sections", style.GREY, 2, showlegend=False),
            scene.line(rotated(q, polhode), "polhode", colour, 6),
            scene.line(np.stack([0 * contact, contact]), "ω", style.GREY, 4),
            scene.dot(contact, "contact", style.MARK),
        ]
        for q, contact in zip(steps.q, steps.contact, strict=True)
    ]
    reach = 1.25 * float(np.hypot(*path.contact.T[:2]).max()) or 0.5 * path.height
    x, y = np.meshgrid((-reach, reach), (-reach, reach))
    fixed = [
        scene.skin(np.stack([x, y, np.full_like(x, path.height)], axis=2), style.CONE, 0.28),
        scene.line(path.contact, "herpolhode", style.MARK, 4),
    ]
    half = 1.08 * max(*steps.axes, float(np.abs(path.contact).max()))
    title = f"Poinsot's ellipsoid: {motion.regime}"
    whole = scene.figure([*frames[0], *fixed], title, style.SPACE_RATES_AXES, half)
    return scene.with_slider(whole, shown, range(len(frames[0])), frames)


def edges(inertia: np.ndarray) -> np.ndarray:
    """Return the relative edge lengths of a uniform box with given moments of inertia.

    Squares are as a_1^2 ~ c_2 + c_3 - c_1; the longest edge is 1, none is below `THINNEST`.
    """
    squares = np.maximum(np.sum(inertia) - 2 * inertia, 0.0)
    return np.maximum(np.sqrt(squares / np.max(squares)), THINNEST)


def tumbling_body(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw the tumbling body in inertial space, with the path of one axis.

    A slider selects the time.  The body is a box of uniform density with the moments of inertia of
    the motion.  The axis is the body axis nearest to the momentum at t = 0, which flips where a
    motion nears the separatrix.  Lengths are relative.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion to draw.
    times : array_like, shape (N,), optional
        Times of the slider, s; by default they cover two periods or a few turns.

    Returns
    -------
    plotly.graph_objects.Figure

    Raises
    ------
    InputError
        For fewer than two times.
    ImportError
        If plotly is not installed.
    """
    _check(motion, "tumbling_body")
    shown = geometry.chosen(motion, times, BODY_FRAMES)
    q, _ = motion(shown)
    path, _ = motion(np.linspace(shown[0], shown[-1], AXIS_PATH))
    body = momentum(motion)
    size, axis = edges(moments(motion)), int(np.argmax(np.abs(body)))
    tip = np.eye(3)[axis] * (0.5 * size[axis] + 0.3)
    frames = [_box_and_axis(attitude, size, tip, axis) for attitude in q]
    path_name = f"path of axis {axis + 1}"
    fixed = [scene.line(rotated(path, tip), path_name, style.AXES[axis], 3)]
    if length := float(np.linalg.norm(body)):
        ends = np.outer((-1.0, 1.0), rotated(motion(0.0)[0], body) / length)
        fixed.append(scene.line(ends, "momentum", style.GREY, 3))
    half = 1.1 * max(float(np.linalg.norm(size)) / 2, float(np.max(tip)), 0.75)
    labels = [f"{k} (inertial)" for k in "xyz"]
    whole = scene.figure([*frames[0], *fixed], f"Tumbling: {motion.regime}", labels, half)
    return scene.with_slider(whole, shown, range(len(frames[0])), frames)


def _box_and_axis(q: np.ndarray, size: np.ndarray, tip: np.ndarray, axis: int) -> list[Trace]:
    """Return the plotly traces of the box, the followed axis and its end at one attitude."""
    box = scene.coordinates(np.round(rotated(q, size * _CORNERS), 6) + 0.0) | {
        "type": "mesh3d",
        **dict(zip("ijk", np.array(_TRIANGLES).T, strict=True)),
        "facecolor": [colour for colour in style.SIDES for _ in range(2)],
        "flatshading": True,
        "hoverinfo": "skip",
        "lighting": {"ambient": 0.8, "diffuse": 0.35, "specular": 0.1},
    }
    end, name, colour = rotated(q, tip), f"axis {axis + 1}", style.AXES[axis]
    return [
        box,
        scene.line(np.stack([0 * end, end]), name, colour, 6),
        scene.dot(end, name, colour, showlegend=False),
    ]


def sphere_and_body(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw the momentum sphere in body axes beside the body in inertial space.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion to draw; the title is its regime.
    times : array_like, shape (N,), optional
        Times of the slider that moves both, s; by default they cover two periods or a few turns.

    Returns
    -------
    plotly.graph_objects.Figure

    Raises
    ------
    InputError
        For a body at rest, and for fewer than two times.
    ImportError
        If plotly is not installed.
    """
    _check(motion, "sphere_and_body")
    shown = geometry.chosen(motion, times, PAIR_FRAMES)
    whole, body = momentum_sphere(motion, PAIR_FAMILY), tumbling_body(motion, shown)
    here = moments(motion) * motion(shown)[1]
    dots = [scene.dot(point, "momentum now", style.MARK) for point in here]
    count = len(whole.data)
    whole.add_traces([dots[0], *(trace.update(scene="scene2") for trace in body.data)])
    moving = [count, *(count + 1 + k for k in body.frames[0].traces)]
    frames = [
        [now, *(trace.update(scene="scene2") for trace in frame.data)]
        for now, frame in zip(dots, body.frames, strict=True)
    ]
    whole.update_layout(
        title={"text": str(motion.regime)},
        width=PAIR_WIDTH,
        height=PAIR_HEIGHT,
        scene={"domain": {"x": _LEFT, "y": [0.0, 1.0]}},
        scene2=body.layout.scene.to_plotly_json() | {"domain": {"x": _RIGHT, "y": [0.0, 1.0]}},
    )
    return scene.with_slider(whole, shown, moving, frames)
