"""Directions of angular momentum from which a torque-free motion can reach the target.

The motion keeps the momentum in space, so the turn takes it from the target's body axes to the
start's; it keeps the energy, too.  Both momenta m and mR of size 1 then have the same energy:
m A m = 0 with A = R J R^T - J, J the inverse moments (fact manoeuvre.cone).  A has no trace (fact
manoeuvre.trace), so that this is a cone, and its directions are two closed curves on the sphere,
one opposite the other.  They are cut into arcs at the points where transit times jump or have no
bound: the axis of the turn, which is on the cone (fact manoeuvre.axis), and the two planes of the
separatrix (fact separatrix_planes.planes); and where they pass close by the other principal axes.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rigidsym.manoeuvre._problem import Problem

# Relative size of A below which it is rounding: the turn is a symmetry of the body.
_SYMMETRY = 1e-13
# Ratio of openings of cones so flat that their curves come close to two planes, and turn sharply
# where these cross.
_FLAT = 0.05
# Distance of a principal axis from a curve within which the curve follows a whole polhode.
_CLOSE = 0.05
_SAME = 1e-12


@dataclass(frozen=True, slots=True)
class Arcs:
    """Arcs of curves on the unit sphere of momentum directions.

    ends (A, 2): angles of both ends of each arc.  direction: from angles and arcs (N,) to unit
    vectors (N, 3).  Along an arc goes the coordinate x from -inf to inf, in which the ends are
    approached like exp(-|x|).
    """

    ends: np.ndarray
    direction: Callable[[np.ndarray, np.ndarray], np.ndarray]

    def at(self, arc: np.ndarray, x: np.ndarray) -> np.ndarray:
        """Return the directions at given coordinates on given arcs.

        Directions have the shape (N, 3), coordinates and arcs (N,).
        """
        begin, end = self.ends[arc].T
        share = (end - begin) / (1 + np.exp(np.abs(x)))
        return self.direction(np.where(x < 0, begin + share, end - share), arc)


def arcs(problem: Problem) -> Arcs:
    """Return the arcs of momentum directions from which motions can reach the target.

    There are none for spherical bodies.

    For a symmetry of the body, one direction of each polhode stands for all of it.
    """
    low, middle, high = problem.axes
    inverse, form = _inverse(problem), quadratic_form(problem)
    if not inverse.any():
        return Arcs(np.empty((0, 2)), lambda angle, arc: np.empty((0, 3)))
    across, along = np.sqrt(np.abs(inverse[[high, low]]))
    if is_symmetry(problem):
        return _meridian(problem, float(np.arctan2(across, along)))
    planes = [along * sign * np.eye(3)[high] + across * np.eye(3)[low] for sign in (1, -1)]
    form = form / np.abs(form).max()
    ends = np.eye(3)[[low, high]]
    close = np.abs(np.diag(form))[[low, high]] < _CLOSE * np.linalg.norm(ends @ form, axis=1)
    return _cone(form, [problem.axis, *ends[close]], np.eye(3)[middle], planes)


def is_symmetry(problem: Problem) -> bool:
    """Return True if the turn from start to target is a symmetry of the body.

    Its motions then come in one-parameter families.

    Facts manoeuvre.symmetry, ring.euler.
    """
    return bool(
        np.abs(quadratic_form(problem)).max() <= _SYMMETRY * np.abs(_inverse(problem)).max()
    )


def _inverse(problem: Problem) -> np.ndarray:
    """Return each inverse moment of inertia minus that of the middle axis.

    They are 1/c_k - 1/c_middle for each axis k, computed without cancellation.
    """
    c, middle = problem.inertia, problem.axes[1]
    return (c[middle] - c) / (c * c[middle])


def quadratic_form(problem: Problem) -> np.ndarray:
    """Return the matrix A (3, 3) of the cone m A m = 0 of momentum directions.

    A = R J R^T - J.
    """
    inverse = _inverse(problem)
    return (problem.rotation * inverse) @ problem.rotation.T - np.diag(inverse)


def _meridian(problem: Problem, split: float) -> Arcs:
    """Return the arcs of the great circle through the axes of largest and smallest moment.

    They cross every polhode, on both sides of both axes: turns about the axis of a symmetric body
    need not be half turns.
    """
    low, _, high = problem.axes

    def direction(angle: np.ndarray, arc: np.ndarray) -> np.ndarray:
        found = np.zeros((len(angle), 3))
        found[:, high], found[:, low] = np.cos(angle), np.sin(angle)
        return found

    quarter = np.array([0.0, split, np.pi / 2])
    cuts = np.unique([-quarter, quarter, np.pi - quarter])
    return Arcs(np.stack([cuts[:-1], cuts[1:]], axis=-1), direction)


def _cone(
    form: np.ndarray, axes: list[np.ndarray], middle: np.ndarray, planes: list[np.ndarray]
) -> Arcs:
    """Return arcs of the curves in which the cone of a quadratic form meets the unit sphere."""
    values, frame = np.linalg.eigh(form)
    if values[1] < 0:
        values, frame = -values[::-1], frame[:, ::-1]
    # One eigenvalue below zero, the cone's axis, and two that are not.
    opening = np.maximum(values[1:], 0.0) / -values[0]
    frame = np.roll(frame, -1, axis=1)
    points = [*axes, *(m for plane in planes for m in _on_plane(form, middle, plane))]
    local = np.array([sign * point @ frame for point in points for sign in (1, -1)])
    ends, sides = [], []
    for side in (1, -1):
        cuts = _cuts(local[local[:, 2] * side > -_SAME], flat=opening[0] < _FLAT * opening[1])
        ends.append(np.stack([cuts, np.roll(cuts, -1)], axis=-1))
        ends[-1][-1, 1] += 2 * np.pi
        sides += [side] * len(cuts)
    height = np.array(sides)

    def direction(angle: np.ndarray, arc: np.ndarray) -> np.ndarray:
        x, y = np.cos(angle), np.sin(angle)
        z = height[arc] * np.sqrt(opening[0] * x * x + opening[1] * y * y)
        found = np.stack([x, y, z], axis=-1)
        return found / np.linalg.norm(found, axis=-1, keepdims=True) @ frame.T

    return Arcs(np.concatenate(ends), direction)


def _cuts(points: np.ndarray, flat: bool) -> np.ndarray:
    """Return the angles at which a curve of the cone is cut into arcs.

    It is cut at the points (N, 3), and at the sharp corners of a flat cone.
    """
    angles = [0.0, *np.arctan2(points[:, 1], points[:, 0])]
    angles += [0.0, np.pi] if flat else []
    cuts = np.unique(np.mod(angles, 2 * np.pi))
    return cuts[np.diff(cuts, prepend=-1.0) > _SAME]


def _on_plane(form: np.ndarray, e: np.ndarray, f: np.ndarray) -> list[np.ndarray]:
    """Return the directions in which the plane of two vectors cuts a cone.

    There are two, each up to its sign, or none.
    """
    ee, ef, ff = e @ form @ e, e @ form @ f, f @ form @ f
    root = ef * ef - ee * ff
    if root < 0:
        return []
    larger = -(ef + np.copysign(np.sqrt(root), ef))
    found = [larger * e + ee * f, ff * e + larger * f]
    return [x / np.linalg.norm(x) for x in found if x.any()]
