"""Drawings that several notebooks share, by matplotlib.  They illustrate and prove nothing."""

from typing import Any

import numpy as np

# Body axes (1, 2, 3) as the picture's (z, x, y): right-handed, with axis 1 upwards.
_TURNED = [1, 2, 0]


def curve(axes: Any, points: Any, **style: Any) -> None:
    """A curve through points (N, 3) in body axes."""
    axes.plot(*np.asarray(points).T[_TURNED], **style)


def label(axes: Any, point: Any, text: str, **style: Any) -> None:
    """A text at a point in body axes."""
    axes.text(*np.asarray(point)[_TURNED], text, ha="center", **style)


def momentum_sphere(figure: Any, place: Any, inertia: Any) -> Any:
    """The sphere of momentum directions with body axes, polhodes and, dashed, the separatrices.

    `place` says where, as `add_subplot` takes it; returns the axes, for `curve` and `label`.
    """
    axes = figure.add_subplot(place, projection="3d")
    axes.set_box_aspect((1, 1, 1), zoom=1.45)
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 61), np.linspace(0, np.pi, 31))
    ball = (np.sin(v) * np.cos(u), np.sin(v) * np.sin(u), np.cos(v))
    axes.plot_surface(*ball, color="0.9", alpha=0.35, lw=0, shade=False)
    low, middle, high = sorted(1 / np.asarray(inertia))
    for share in (0.08, 0.3, 0.65):
        for height in (low + share * (middle - low), high - share * (high - middle)):
            for points in polhode(inertia, height):
                curve(axes, points, color="0.65", lw=0.7)
    for points in separatrices(inertia):
        curve(axes, points, color="C3", lw=1, ls="--")
    for k, axis in enumerate(np.eye(3), start=1):
        curve(axes, [0 * axis, 1.35 * axis], color="0.3", lw=1)
        label(axes, 1.45 * axis, f"axis {k}", size=9)
    axes.view_init(18, 35)
    axes.set_axis_off()
    return axes


def polhode(inertia: Any, height: float) -> list[np.ndarray]:
    """The two closed curves 2H/K^2 = height on the unit sphere, (N, 3) each."""
    gaps = 1 / np.asarray(inertia) - height  # sum of gap x^2 = 0 and of x^2 = 1
    (a,) = (k for k in range(3) if all(np.sign(np.delete(gaps, k)) == -np.sign(gaps[k])))
    b, d = (k for k in range(3) if k != a)
    s = np.linspace(0, 2 * np.pi, 721)
    points = np.ones((len(s), 3))
    points[:, b], points[:, d] = np.cos(s), np.sin(s)
    points /= np.sqrt(abs(gaps))
    points /= np.linalg.norm(points, axis=1)[:, None]
    other = np.ones(3)
    other[a] = -1
    return [points, points * other]


def separatrices(inertia: Any) -> list[np.ndarray]:
    """The two great circles through the middle axis that part the circulations, (N, 3) each."""
    d, b, a = np.argsort(inertia)
    gaps = np.sqrt(abs(1 / np.asarray(inertia) - 1 / inertia[b]))
    s = np.linspace(0, 2 * np.pi, 361)[:, None]
    circles = []
    for side in (1, -1):
        across = np.zeros(3)
        across[a], across[d] = gaps[d], side * gaps[a]
        across /= np.linalg.norm(across)
        circles.append(np.cos(s) * np.eye(3)[b] + np.sin(s) * across)
    return circles
