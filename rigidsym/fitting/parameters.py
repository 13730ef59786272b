"""What is estimated: a small turn, rates, the shape of the body, and where its axes lie.

Moments c_i = s - a_i stand for the second moments of the mass a_i > 0 about the centre, s their
sum.  Their logarithms are free: every choice is a body that can exist, axes may change their order,
and two of them are seen in a motion, while their common scale is not.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from rigidsym.fitting.rotations import left_jacobian
from rigidsym.quaternions import (
    conjugate,
    cross_matrices,
    matrices,
    of_rotation_vectors,
    product,
    rotated,
)

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])
# What two of three logarithms move: an orthonormal basis across (1, 1, 1).
_SHAPES = np.array([[1.0, 1.0], [-1.0, 1.0], [0.0, -2.0]]) / np.sqrt([2.0, 6.0])
# Of the sum of the second moments: flatter bodies are not told from flat ones.
_THINNEST = 1e-9
# What a start has to have of them: logarithms hardly leave flat bodies.
_INNER = 1e-6


@dataclass(frozen=True, slots=True)
class Point:
    """One motion, or many with leading shapes: where its parameters are zero.

    attitude (..., 4) and omega (..., 3) at t = 0, moments (..., 3), along the principal axes;
    mount (..., 4): the rotation from the principal axes to those that observations speak of.
    """

    attitude: np.ndarray
    omega: np.ndarray
    moments: np.ndarray
    mount: np.ndarray

    def __getitem__(self, some: np.ndarray | int | slice) -> "Point":
        return Point(self.attitude[some], self.omega[some], self.moments[some], self.mount[some])

    @property
    def count(self) -> int:
        """How many motions, of those that have a leading shape (B,)."""
        return len(self.omega)

    def repeated(self, count: int = 1) -> "Point":
        """One motion as many equal ones, (B,)."""
        parts = (self.attitude, self.omega, self.moments, self.mount)
        return Point(*(np.tile(x, (count, 1)) for x in parts))

    def seen(self, q: np.ndarray, omega: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """States (..., N, 4), (..., N, 3) of the principal axes as those of the axes observed."""
        if np.all(self.mount == IDENTITY):
            return q, omega
        mount = self.mount[..., None, :]
        return product(q, conjugate(mount)), rotated(mount, omega)


def joined(points: Iterable[Point]) -> Point:
    """Points (B,) one after the other."""
    parts = [(p.attitude, p.omega, p.moments, p.mount) for p in points]
    return Point(*(np.concatenate(x) for x in zip(*parts, strict=True)))


@dataclass(frozen=True)
class Parameters:
    """Which of them there are: rotation vector and rates always; two of shape, the scale of the
    moments, and a turn of the principal axes in the body where they are asked for."""

    shape: bool = True
    scale: bool = False
    axes: bool = False

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Of each, for reading."""
        named = [f"{name} {axis}" for name in ("attitude", "omega") for axis in "123"]
        named += ["shape 1", "shape 2"] * self.shape + ["scale"] * self.scale
        return (*named, *(["axes 1", "axes 2", "axes 3"] * self.axes))

    @property
    def count(self) -> int:
        """How many."""
        return len(self.names)

    def _places(self, name: str) -> list[int]:
        return [k for k, x in enumerate(self.names) if x.startswith(name)]

    def natural(self, point: Point, span: float) -> np.ndarray:
        """What changes everything, (count,): 1 rad, the rates as they are or 1 rad in the span of
        the observations, the moments as they are."""
        found = np.ones(self.count)
        found[3:6] = max(float(np.linalg.norm(point.omega)), 1 / span)
        return found

    def moved(self, point: Point, x: np.ndarray) -> Point:
        """The point that x (..., count) stands for."""
        found = replace(
            point,
            attitude=product(of_rotation_vectors(x[..., :3]), point.attitude),
            omega=point.omega + x[..., 3:6],
        )
        if self.shape:
            found = replace(found, moments=_reshaped(found.moments, x[..., self._places("shape")]))
        if self.scale:
            found = replace(found, moments=found.moments * np.exp(x[..., self._places("scale")]))
        if self.axes:
            turn = of_rotation_vectors(x[..., self._places("axes")])
            found = replace(found, mount=product(turn, found.mount))
        return found

    def stepped(self, point: Point, x: np.ndarray) -> Point:
        """The points that x (..., count) stands for as `linear` counts it, from one point or from
        as many: shapes are steps of the moments, to where bodies end at most."""
        level = np.array(x)
        level[..., self._places("shape") + self._places("scale")] = 0.0
        moments = point.moments + (self.linear(point)[..., 6:9, :] @ x[..., None])[..., 0]
        if np.any(moments != point.moments):
            own, _ = _second_moments(np.abs(moments))
            moments = np.sum(own, axis=-1, keepdims=True) - own
        return replace(self.moved(point, level), moments=moments)

    def inner(self, point: Point) -> Point:
        """The point, or one beside it from which its shape can move."""
        if not self.shape:
            return point
        own, total = _second_moments(point.moments)
        share = np.maximum(own / total, _INNER)
        moved = total * (1 - share / np.sum(share, axis=-1, keepdims=True))
        thin = np.any(own / total < _INNER, axis=-1, keepdims=True)
        return replace(point, moments=np.where(thin, moved, point.moments))

    def own(self, point: Point, x: np.ndarray | None = None) -> np.ndarray:
        """How (eta0, omega0, moments) and the turn of the axes, 12 rows, go with the parameters.

        (..., 12, count), at a point; or, for one motion, where x (count,) has moved to that point.
        """
        found = np.zeros((*point.omega.shape[:-1], 12, self.count))
        found[..., :3, :3] = np.eye(3) if x is None else left_jacobian(x[:3])
        found[..., 3:6, 3:6] = np.eye(3)
        if self.shape:
            found[..., 6:9, self._places("shape")] = _shaping(point.moments)
        if self.scale:
            found[..., 6:9, self._places("scale")] = point.moments[..., None]
        if self.axes:
            places = self._places("axes")
            found[..., 9:, places] = np.eye(3) if x is None else left_jacobian(x[places])
        return found

    def linear(self, point: Point) -> np.ndarray:
        """The same rows (..., 12, count) by parameters that errors are told of.

        Shapes are two directions of the moments across their scale, of the size of the moments:
        unlike logarithms they do not end at flat bodies.
        """
        found = self.own(point)
        if self.shape:
            size = np.linalg.norm(point.moments, axis=-1)[..., None, None]
            across = np.linalg.svd(point.moments[..., None, :])[2][..., 1:, :]
            found[..., 6:9, self._places("shape")] = size * np.swapaxes(across, -2, -1)
        return found


def observed(
    point: Point, q: np.ndarray, omega: np.ndarray, sensitivity: np.ndarray, own: np.ndarray
) -> np.ndarray:
    """How turn and rates of the axes observed go with the parameters: (..., N, 6, p).

    Of states (..., N, 4), (..., N, 3) of those axes, sensitivities (..., N, 6, 9) of the principal
    ones, and the rows (..., 12, p) of `Parameters.own`.
    """
    own = own[..., None, :, :]
    moved = sensitivity @ own[..., :9, :]
    if not own[..., 9:, :].any():
        return moved
    turned = matrices(point.mount)[..., None, :, :] @ moved[..., 3:, :]
    moved[..., :3, :] -= matrices(q) @ own[..., 9:, :]
    moved[..., 3:, :] = turned - cross_matrices(omega) @ own[..., 9:, :]
    return moved


def _second_moments(moments: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """a (..., 3) and their sum (..., 1)."""
    total = np.sum(moments, axis=-1, keepdims=True) / 2
    return np.maximum(total - moments, _THINNEST * total), total


def _reshaped(moments: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Moments (..., 3) with the same sum whose logarithms have moved by x (..., 2)."""
    own, total = _second_moments(moments)
    log = np.log(own) + x @ _SHAPES.T
    share = np.exp(log - np.max(log, axis=-1, keepdims=True))
    share = np.maximum(share / np.sum(share, axis=-1, keepdims=True), _THINNEST)
    return total * (1 - share / np.sum(share, axis=-1, keepdims=True))


def _shaping(moments: np.ndarray) -> np.ndarray:
    """Its derivative (..., 3, 2)."""
    own, total = _second_moments(moments)
    mixed = own[..., :, None] * own[..., None, :] / total[..., None]
    return -(own[..., :, None] * np.eye(3) - mixed) @ _SHAPES
