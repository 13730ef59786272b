"""Draws the picture of the README: `python notebooks/site/picture.py` (extra `lab`).

The paper's spacecraft: its momentum among all motions of the body, how it tumbles, and how wrong
the numbers are.  Solids are seen from far away, so that parallels stay parallel.
"""

import argparse
import io
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
from matplotlib import rc_context
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

from rigidsym import TorqueFreeMotion
from rigidsym.io._files import write_text
from rigidsym.quaternions import rotated
from rigidsym.solution._polhode import Regime
from rigidsym.validate.peers import peer
from rigidsym.view._geometry import REGIMES, members, moments, momentum, polhode, separatrix
from rigidsym.view._style import AXES, SCALAR
from rigidsym.view.scenes._pictures import edges

FILE = Path(__file__).resolve().parent / "pictures" / "spacecraft.svg"
INERTIA, OMEGA0, ATTITUDE0 = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02), (1.0, 0.0, 0.0, 0.0)
SECONDS, SNAPSHOTS, BOUND = 180.0, 10, 2e-15
# No date and no random names: the same picture is the same file.
STYLE: Any = {
    "svg.hashsalt": "rigidsym",
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.titlepad": 8,
}
LIGHT = ("#9ccbe8", "#f5bd98", "#93d3ba")
GREY = "0.4"


def picture() -> str:
    """The picture as SVG, on white."""
    motion = TorqueFreeMotion(INERTIA, OMEGA0, ATTITUDE0)
    with rc_context(STYLE):
        figure = Figure((9.8, 5.0))
        for draw, place in PLACES.items():
            draw(figure.add_axes(place), motion)
        buffer = io.StringIO()
        figure.savefig(
            buffer, format="svg", metadata={"Date": None, "Creator": None}, facecolor="white"
        )
    return buffer.getvalue()


def view(elevation: float, azimuth: float) -> np.ndarray:
    """The rotation to the picture: right, up, and towards the reader; angles in degrees."""
    e, a = np.radians((elevation, azimuth))
    right = np.array([-np.sin(a), np.cos(a), 0])
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    return np.array([right, np.cross(towards, right), towards])


BODY, SPACE = view(22, 40), view(20, 35)


def _sphere(axes: Any, motion: TorqueFreeMotion) -> None:
    """Polhodes of the motions with this |M|, coloured by regime, and this one's."""
    size = float(np.linalg.norm(momentum(motion)))
    axes.add_patch(Circle((0, 0), 1, facecolor="#f3f5f8", edgecolor="0.8", linewidth=0.8))
    for k in range(3):
        _axis(axes, k)
    for other in members(motion, size, 5):
        _curve(axes, _track(other, size), REGIMES[other.regime], 1.0)
    for circle in separatrix(motion.exact["inertia"], 1.0):
        _curve(axes, circle, REGIMES[Regime.SEPARATRIX], 1.6)
    colour, start = REGIMES[motion.regime], BODY @ momentum(motion) / size
    _curve(axes, _track(motion, size), colour, 3.6)
    axes.plot(*start[:2], "o", color=colour, markersize=8, markeredgecolor="white")
    for regime in (Regime.LARGEST, Regime.SMALLEST, Regime.SEPARATRIX):
        axes.plot([], [], color=REGIMES[regime], label=str(regime))
    axes.plot([], [], "o-", color=colour, linewidth=3.6, label="the paper's spacecraft, from t = 0")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.03), frameon=False)
    axes.set(aspect="equal", xlim=(-1.08, 1.2), ylim=(-1.04, 1.25), anchor="C")
    axes.set_axis_off()
    axes.set_title("All motions of one body, on its momentum sphere")


def _track(motion: TorqueFreeMotion, size: float) -> np.ndarray:
    return moments(motion) * polhode(motion, 121) / size


def _axis(axes: Any, k: int) -> None:
    """From the sphere's surface outwards."""
    tip = BODY @ np.eye(3)[k]
    axes.plot(*np.outer(tip[:2], (1, 1.14)), color=GREY, linewidth=1.4, zorder=4)
    axes.text(*(1.25 * tip[:2]), f"$M_{k + 1}$", color=GREY, ha="center", va="center", zorder=4)


def _curve(axes: Any, points: np.ndarray, colour: str, width: float) -> None:
    """A curve on the sphere, faint where it is behind."""
    x, y, depth = BODY @ points.T
    for front, alpha in ((False, 0.2), (True, 1.0)):
        shown = (depth > 0) == front
        parts = [np.where(shown, coordinate, np.nan) for coordinate in (x, y)]
        axes.plot(*parts, color=colour, linewidth=width, alpha=alpha, zorder=3 if front else 2)


def _tumbling(axes: Any, motion: TorqueFreeMotion) -> None:
    """A box with the moments of the body, at equal steps of time."""
    times = np.linspace(0, SECONDS, SNAPSHOTS)
    size = edges(moments(motion))
    for place, q in enumerate(motion(times)[0]):
        for corners, colour in _sides(rotated(q, np.eye(3)), size):
            flat = corners[:, :2] + (place, 0)
            side = Polygon(flat, facecolor=colour, edgecolor="0.25", linewidth=0.7, clip_on=False)
            axes.add_patch(side)
    axes.set(aspect="equal", xlim=(0, SNAPSHOTS - 1), ylim=(-0.5, 0.5))
    axes.set_axis_off()
    axes.set_title("The paper's spacecraft tumbles, and its attitude is known in closed form")


def _sides(axes: np.ndarray, size: np.ndarray) -> Iterator[tuple[np.ndarray, Any]]:
    """The sides of a box that are seen, as corners (4, 3) in the picture's axes, and colours.

    The rows of `axes` are the body's in space; a box is convex, so no side hides another.
    """
    body = axes @ SPACE.T * size[:, None] / 2
    for k in range(3):
        normal, (a, b) = body[k], np.delete(body, k, axis=0)
        side = np.sign(normal[2]) * normal
        shade = 0.72 + 0.28 * abs(normal[2]) / np.linalg.norm(normal)
        yield side + [a + b, a - b, -a - b, b - a], shade * np.array(to_rgb(LIGHT[k]))


def _attitude(axes: Any, motion: TorqueFreeMotion) -> None:
    t = np.linspace(0, SECONDS, 361)
    for k, (column, colour) in enumerate(zip(motion(t)[0].T, (SCALAR, *AXES), strict=True)):
        axes.plot(t, column, color=colour, linewidth=1.6)
        axes.annotate(
            f"$q_{k}$", (t[-1], column[-1]), (6, 0), textcoords="offset points", color=colour
        )
    axes.set(xlim=(0, SECONDS), ylim=(-1.05, 1.05), ylabel="quaternion", xlabel="t (s)")
    axes.set_xticks(np.arange(0, SECONDS + 1, 20))
    _dress(axes)


def _errors(axes: Any, motion: TorqueFreeMotion) -> None:
    """Of generated code, and of a good integrator, against forty digits."""
    t = np.logspace(0, 12, 361)
    axes.loglog(t, error(motion, t, motion(t)[0]), ".", color=AXES[0], markersize=3)
    axes.axhline(BOUND, color="black", linewidth=1, linestyle="--")
    t = np.logspace(0, 4, 101)
    integrator = peer("dop853")
    found, _ = integrator.states(integrator.prepare(INERTIA, OMEGA0, ATTITUDE0), t)
    axes.loglog(t, error(motion, t, found), color=GREY, linewidth=1.6)
    axes.text(2e4, 2e-11, "a good integrator: SciPy's DOP853 at its best", color=GREY)
    axes.text(8e11, 4e-15, "documented bound, 2e-15 rad", ha="right")
    axes.text(8e11, 5e-18, "generated code", color=AXES[0], ha="right")
    axes.set(xlim=(1, 1e12), ylim=(1e-18, 1e-9), ylabel="error (rad)", xlabel="t (s)")
    axes.set_title("The numbers stay right: errors against certain digits, to 30 000 years")
    _dress(axes)


def error(motion: TorqueFreeMotion, t: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The angle of the rotation from the true attitude to a quaternion, rad (N,)."""
    exact, _ = motion.precise(t, digits=40)
    with mpmath.workdps(40):
        chords = [mpmath.norm(list(y - x)) for x, y in zip(q.tolist(), exact, strict=True)]
        return np.array([float(4 * mpmath.asin(chord / 2)) for chord in chords])


def _dress(axes: Any) -> None:
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


# From the left and from below, width and height, as parts of the figure's.
PLACES = {
    _sphere: (0.0, 0.21, 0.385, 0.715),
    _tumbling: (0.455, 0.815, 0.505, 0.11),
    _attitude: (0.455, 0.545, 0.505, 0.24),
    _errors: (0.455, 0.1, 0.505, 0.285),
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the picture."""
    parser = argparse.ArgumentParser(description="Draw the picture of the README.")
    parser.add_argument("-o", "--output", type=Path, default=FILE, metavar="FILE")
    write_text(parser.parse_args(arguments).output, picture())
    return 0


if __name__ == "__main__":
    sys.exit(main())
