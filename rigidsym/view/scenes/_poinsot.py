"""Poinsot's picture: the ellipsoid of inertia rolls, without slipping, on the invariable plane."""

from dataclasses import dataclass
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from rigidsym._inputs import Times
from rigidsym.errors import InputError
from rigidsym.quaternions import product, rotated
from rigidsym.view._geometry import (
    REGIMES,
    chosen,
    great_circles,
    moments,
    momentum,
    polhode,
    upright,
)
from rigidsym.view._style import CONE, ELLIPSOID, GREY, MARK, SPACE_RATES_AXES
from rigidsym.view.scenes._scene import (
    ball,
    curves,
    dot,
    figure,
    line,
    plotly,
    sketch,
    skin,
    with_slider,
)

if TYPE_CHECKING:
    from plotly.basedatatypes import BaseTraceType as Trace
    from plotly.graph_objects import Figure

    from rigidsym.motion import TorqueFreeMotion

FRAMES, AROUND, PATH = 61, 97, 721
"Frames of the slider, and points of the polhode and of the herpolhode."
_MESH = (13, 25)


@dataclass(frozen=True, slots=True)
class Rolling:
    """Rates in space with the momentum along the third axis, rad/s, and the body's attitude there.

    `height` is the distance 2H/K of the invariable plane from the centre; `axes` are the half axes
    sqrt(2H/c_i) of the ellipsoid.
    """

    times: np.ndarray
    q: np.ndarray
    contact: np.ndarray
    axes: np.ndarray
    height: float


def rolling(motion: "TorqueFreeMotion", times: np.ndarray) -> Rolling:
    """Return the motion at some times, in axes whose third is along the momentum."""
    start = motion(0.0)
    inertia, body = moments(motion), momentum(motion)
    front = upright(rotated(start[0], body))
    q, omega = motion(times)
    turned = product(front, q)
    double_energy = float(body @ start[1])
    axes = np.sqrt(double_energy / inertia)
    return Rolling(
        times, turned, rotated(turned, omega), axes, double_energy / float(np.linalg.norm(body))
    )


def rolling_ellipsoid(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw the rolling ellipsoid with polhode and herpolhode, and a slider for the time.

    The picture shows the space of rates, rad/s, with the momentum upwards: the contact is omega.

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
    go = plotly("rolling_ellipsoid")
    if not any(motion.exact["omega0"]):
        raise InputError("omega0", "zero", "the ellipsoid of a body at rest is a point")
    shown = chosen(motion, times, FRAMES)
    path = rolling(motion, np.linspace(min(shown[0], 0.0), shown[-1], PATH))
    steps = rolling(motion, shown)
    frames = [_moving(go, motion, steps, k) for k in range(len(shown))]
    fixed = _fixed(go, path, REGIMES[motion.regime])
    half = 1.08 * max(*steps.axes, float(np.abs(path.contact).max()))
    title = f"Poinsot's ellipsoid: {motion.regime}"
    whole = figure([*frames[0], *fixed], title, SPACE_RATES_AXES, half)
    return with_slider(go, whole, shown, range(len(frames[0])), frames)


def _moving(go: ModuleType, motion: "TorqueFreeMotion", steps: Rolling, k: int) -> list["Trace"]:
    """Return the ellipsoid, its main sections and the polhode, turned, and the contact."""
    q, colour = steps.q[k], REGIMES[motion.regime]
    sections = curves([steps.axes * circle[::2] for circle in great_circles(1.0)])
    track = polhode(motion, AROUND)
    return [
        skin(go, rotated(q, steps.axes * ball(*_MESH)), ELLIPSOID, 0.45),
        sketch(go, rotated(q, sections), "sections", GREY, 2, showlegend=False),
        line(go, rotated(q, track), "polhode", colour, 6),
        line(go, np.stack([0 * steps.contact[k], steps.contact[k]]), "ω", GREY, 4),
        dot(go, steps.contact[k], "contact", MARK),
    ]


def _fixed(go: ModuleType, path: Rolling, colour: str) -> list["Trace"]:
    """Return the invariable plane and the herpolhode on it."""
    reach = 1.25 * float(np.hypot(*path.contact.T[:2]).max()) or 0.5 * path.height
    sides = np.array([-reach, reach])
    x, y = np.meshgrid(sides, sides)
    plane = np.stack([x, y, np.full_like(x, path.height)], axis=2)
    return [
        skin(go, plane, CONE, 0.28),
        line(go, path.contact, "herpolhode", MARK, 4),
    ]
