"""Parameters of a fit: attitude, rates, moments of inertia and principal axes.

Moments c_i = s - a_i stand for the second moments of the mass a_i > 0 about the centre, s their
sum.  Their logarithms are free: every choice is a body that can exist, and axes may change their
order.  A motion shows two of the three; their common scale is unobservable.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from rigidsym.motion import TorqueFreeMotion, propagate
from rigidsym.quaternions import (
    conjugate,
    cross_matrices,
    matrices,
    of_rotation_vectors,
    product,
    rotated,
)

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])
# An orthonormal basis across (1, 1, 1), in which the shape moves the three logarithms.
_SHAPES = np.array([[1.0, 1.0], [-1.0, 1.0], [0.0, -2.0]]) / np.sqrt([2.0, 6.0])
# The least second moment, as a part of their sum; flatter bodies count as flat.
_THINNEST = 1e-9
# The least second moment of a start, because steps of logarithms hardly leave flat bodies.
_INNER = 1e-6
# Squares of angles below which series of three terms are right to rounding.
_SMALL = 1e-2


@dataclass(frozen=True, slots=True)
class Point:
    """The state and inertia of a motion or of an array of motions.

    Parameters are counted from it.

    attitude (..., 4) and omega (..., 3) at the epoch, moments (..., 3), along the principal axes;
    mount (..., 4): the rotation from the principal axes to the observed axes of the body, along
    which observations are expressed.
    """

    attitude: np.ndarray
    omega: np.ndarray
    moments: np.ndarray
    mount: np.ndarray

    def __getitem__(self, some: np.ndarray | int | slice) -> "Point":
        return Point(*(x[some] for x in self.parts))

    @property
    def count(self) -> int:
        """Return the number B of motions."""
        return len(self.omega)

    @property
    def parts(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Return the attitude, rates, moments and mount."""
        return self.attitude, self.omega, self.moments, self.mount

    def repeated(self, count: int = 1) -> "Point":
        """Return an array of `count` copies of one motion."""
        return Point(*(np.tile(x, (count, 1)) for x in self.parts))

    def in_observed_axes(self, q: np.ndarray, omega: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Transform states from the principal axes to the observed axes.

        Attitudes have the shape (..., N, 4), rates (..., N, 3).
        """
        if np.all(self.mount == IDENTITY):
            return q, omega
        mount = self.mount[..., None, :]
        return product(q, conjugate(mount)), rotated(mount, omega)


def joined(points: Iterable[Point]) -> Point:
    """Concatenate arrays of motions."""
    return Point(*(np.concatenate(x) for x in zip(*(p.parts for p in points), strict=True)))


@dataclass(frozen=True)
class Parameters:
    """The choice of the parameters that a fit estimates.

    A rotation vector and rates are always parameters; two of the shape, the scale of the moments,
    and a turn of the principal axes in the body where they are wanted.
    """

    shape: bool = True
    scale: bool = False
    axes: bool = False

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Return the name of each parameter."""
        named = [f"{name} {axis}" for name in ("attitude", "omega") for axis in "123"]
        named += ["shape 1", "shape 2"] * self.shape + ["scale"] * self.scale
        return (*named, *(["axes 1", "axes 2", "axes 3"] * self.axes))

    @property
    def count(self) -> int:
        """Return the number of parameters."""
        return len(self.names)

    def _places(self, name: str) -> list[int]:
        return [k for k, x in enumerate(self.names) if x.startswith(name)]

    def natural_sizes(self, point: Point, span: float) -> np.ndarray:
        """Return the natural scales (count,) of the parameters.

        These are 1 rad, the rates as they are or 1 rad in the span of the observations, and the
        moments as they are.  A change by its natural size changes everything.
        """
        found = np.ones(self.count)
        found[3:6] = max(float(np.linalg.norm(point.omega)), 1 / span)
        return found

    def moved(self, point: Point, x: np.ndarray) -> Point:
        """Return the point displaced by parameters x (..., count)."""
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
        """Return points displaced by steps of the linear parameters of `linear_derivatives`.

        The parameters x have the shape (..., count).

        They start from one point or from as many.  Shapes are steps of the moments, at most to
        where bodies cease to exist.
        """
        level = np.array(x)
        level[..., self._places("shape") + self._places("scale")] = 0.0
        moments = (
            point.moments + (self.linear_derivatives(point)[..., 6:9, :] @ x[..., None])[..., 0]
        )
        if np.any(moments != point.moments):
            own, _ = _second_moments(np.abs(moments))
            moments = np.sum(own, axis=-1, keepdims=True) - own
        return replace(self.moved(point, level), moments=moments)

    def inner(self, point: Point) -> Point:
        """Replace a flat body by a slightly thicker one, whose shape can change."""
        if not self.shape:
            return point
        own, total = _second_moments(point.moments)
        share = np.maximum(own / total, _INNER)
        moved = total * (1 - share / np.sum(share, axis=-1, keepdims=True))
        thin = np.any(own / total < _INNER, axis=-1, keepdims=True)
        return replace(point, moments=np.where(thin, moved, point.moments))

    def derivatives(self, point: Point, x: np.ndarray | None = None) -> np.ndarray:
        """Return the derivatives of the quantities of a motion with respect to the parameters.

        The quantities (..., 12, count) are a small turn, rates, moments and axes.

        They are at a point; or, for one motion, where x (count,) has moved to that point.
        """
        found = np.zeros((*point.omega.shape[:-1], 12, self.count))
        found[..., :3, :3] = np.eye(3) if x is None else left_jacobian(x[:3])
        found[..., 3:6, 3:6] = np.eye(3)
        if self.shape:
            own, total = _second_moments(point.moments)
            mixed = own[..., :, None] * own[..., None, :] / total[..., None]
            reshaped = -(own[..., :, None] * np.eye(3) - mixed) @ _SHAPES
            found[..., 6:9, self._places("shape")] = reshaped
        if self.scale:
            found[..., 6:9, self._places("scale")] = point.moments[..., None]
        if self.axes:
            places = self._places("axes")
            found[..., 9:, places] = np.eye(3) if x is None else left_jacobian(x[places])
        return found

    def linear_derivatives(self, point: Point) -> np.ndarray:
        """Return derivatives of a motion's quantities by the linear parameters used for errors.

        Their shape is (..., 12, count).

        Shapes are two directions of the moments across their scale, of the size of the moments:
        unlike logarithms they do not end at flat bodies.
        """
        found = self.derivatives(point)
        if self.shape:
            size = np.linalg.norm(point.moments, axis=-1)[..., None, None]
            across = np.linalg.svd(point.moments[..., None, :])[2][..., 1:, :]
            found[..., 6:9, self._places("shape")] = size * np.swapaxes(across, -2, -1)
        return found


def left_jacobian(vector: np.ndarray) -> np.ndarray:
    """Return the left Jacobian (3, 3) of the exponential map of rotations.

    This is J with exp(vector + d) = exp(J d) exp(vector), to first order in d.

    Source: Chirikjian, Stochastic Models, Information Theory, and Lie Groups 2 (2012), section
    10.3.
    """
    square = float(vector @ vector)
    turn = cross_matrices(vector)
    if square < _SMALL:
        versine = 1 / 2 - square / 24 + square**2 / 720
        defect = 1 / 6 - square / 120 + square**2 / 5040
    else:
        angle = np.sqrt(square)
        versine = (1 - np.cos(angle)) / square
        defect = (angle - np.sin(angle)) / (angle * square)
    return np.eye(3) + versine * turn + defect * turn @ turn


def observed_derivatives(
    point: Point, q: np.ndarray, omega: np.ndarray, sensitivity: np.ndarray, own: np.ndarray
) -> np.ndarray:
    """Return the derivatives of states with respect to the parameters, in the observed axes.

    They are those (..., N, 6, p) of a small turn and of the rates.

    q, omega: states (..., N, 4), (..., N, 3) of the observed axes; sensitivity (..., N, 6, 9): of
    the principal axes; own (..., 12, p): see `Parameters.derivatives`.
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
    """Return the second moments (..., 3) of the mass distribution and their sum (..., 1)."""
    total = np.sum(moments, axis=-1, keepdims=True) / 2
    return np.maximum(total - moments, _THINNEST * total), total


def _reshaped(moments: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return moments (..., 3) of another shape with the same sum.

    The logarithms of the second moments of the mass have moved by x (..., 2).
    """
    own, total = _second_moments(moments)
    log = np.log(own) + x @ _SHAPES.T
    share = np.exp(log - np.max(log, axis=-1, keepdims=True))
    share = np.maximum(share / np.sum(share, axis=-1, keepdims=True), _THINNEST)
    return total * (1 - share / np.sum(share, axis=-1, keepdims=True))


def motion(point: Point) -> TorqueFreeMotion:
    """Convert one point to the torque-free motion of its principal axes."""
    return TorqueFreeMotion(point.moments.tolist(), point.omega.tolist(), point.attitude.tolist())


def states(point: Point, times: np.ndarray, engine: str) -> tuple[np.ndarray, np.ndarray]:
    """Return attitudes (..., N, 4) and rates (..., N, 3) of the principal axes.

    They are NaN where there are none.
    """
    found = propagate(
        point.moments, point.omega, times, point.attitude, engine=engine, errors="nan"
    )
    return found[0], found[1]


def sensitivities(
    point: Point, times: np.ndarray, engine: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the states of the principal axes and their sensitivities.

    These are the derivatives (..., N, 6, 9) of a small turn and of the rates, with respect to the
    state at the epoch and the moments.
    """
    q, omega, found = propagate(
        point.moments,
        point.omega,
        times,
        point.attitude,
        engine=engine,
        errors="nan",
        sensitivity=True,
    )
    return q, omega, np.concatenate([found.attitude, found.rates], axis=-2)
