"""Starting motions of a search, from each kind of observations.

Attitudes give symmetric tops.  A symmetric top has R(t) = A Rz(W t) Ry(theta) Rz(psi(t)) P, where P
takes the symmetry axis to z.  At a precession rate W the axis describes a cone: a linear regression
gives A and theta.  The angle psi remains, and a rotation rate w fits if psi - w t is nearly
constant.  By the momentum, moments across and along the axis have the ratio 1 + w / (W cos theta):
above 1 for long-axis modes, from 1/2 to 1 for short-axis modes; no body has less.  Source:
Samarasinha and A'Hearn, Icarus 93 (1991), 194-225.

The attitude is determined last, in closed form, for many motions at once.  A motion with the
identity for its attitude at the epoch is right up to one rotation A on the left; A as a quaternion
is the eigenvector of the largest eigenvalue of Davenport's matrix (Davenport, 1968; Markley, J.
Astronautical Sciences 55, 2007).
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import qmc

from rigidsym.fitting._observations import Attitudes, Observations
from rigidsym.fitting._parameters import IDENTITY, Parameters, Point, joined, states
from rigidsym.fitting._problem import Problem
from rigidsym.motion import propagate
from rigidsym.quaternions import conjugate, matrices, of_rotation_vectors, rotated

# From the axes of a body to axes with the first, second and third as z.
_FRAMES = np.array([[0.5, -0.5, -0.5, -0.5], [0.5, 0.5, 0.5, 0.5], [1.0, 0.0, 0.0, 0.0]])
# The largest rate of a search over the largest rate that the observations contain.
_MARGIN = 1.5
# Phase over the arc between two rates of the grid of tops, rad.
_STEP = np.pi / 2
# The fewest attitudes that tops are fitted to, and the fewest rates of their grid.
_FEWEST = 8
# The least ratio of moments, below 1/2 because of noise; ratios are then kept between the others.
_LEAST, _FLAT, _NEEDLE = 0.4, 0.52, 50.0


def starts(problem: Problem, known: np.ndarray | None, count: int, fastest: float) -> Point:
    """Return about `count` starting motions for the search for minima.

    known (3,): moments, where they are known or guessed. fastest: the largest rate, rad/s.
    """
    found = [*_from_tops(problem, known, count, fastest), *_from_rates(problem, known)]
    if not found:
        found = [_from_anywhere(problem, known, count, fastest)]
    return joined(found)


def fastest_rate(sets: tuple[Observations, ...]) -> float:
    """Return the largest rate to search, in rad/s.

    It follows from observed rates, or from attitudes so close that the turns between them are
    unambiguous; else it is half a turn between observations.
    """
    series = [x for one in sets for _, x in one.rate_series()]
    fastest = max((np.max(np.linalg.norm(x, axis=-1), initial=0.0) for x in series), default=0.0)
    if fastest > 0:
        return _MARGIN * float(fastest)
    times = np.unique(np.concatenate([one.t for one in sets]))
    return float(np.pi / np.median(np.diff(times)))


def _from_rates(problem: Problem, known: np.ndarray | None) -> Iterator[Point]:
    """Yield starting motions from observed rates, for many bodies.

    They have the first, a middle and the last rates of each series.
    """
    # Bodies of all shapes, or the known one, with principal axes in all directions.
    shares = (np.array([(i, j, 9 - i - j) for i in range(10) for j in range(10 - i)]) + 1 / 3) / 10
    moments = 1 - shares if known is None else np.asarray(known, float)[None]
    mounts = conjugate(_sphere()) if problem.parameters.axes else IDENTITY[None]
    mount = np.tile(mounts, (len(moments), 1))
    moments = np.repeat(moments, len(mounts), axis=0)
    for times, rates in (series for one in problem.sets for series in one.rate_series()):
        for k in sorted({0, len(times) // 2, len(times) - 1}):
            every = np.broadcast_to(rates[k], moments.shape)
            yield _at(problem, times[k], every, moments, mount)


def _from_tops(
    problem: Problem, known: np.ndarray | None, count: int, fastest: float
) -> Iterator[Point]:
    """Yield the symmetric tops of a grid that best fit each set of attitudes."""
    frames = _sphere() if problem.parameters.axes else _FRAMES
    for one in problem.sets:
        if not isinstance(one, Attitudes) or one.count < _FEWEST:
            continue
        span = float(np.ptp(one.t))
        # Precession, rotation either way, and a frame for each start of the grid.
        steps = max(_FEWEST, int(np.sqrt(count / (2 * len(frames)))))
        step = max(fastest / steps, 0.5 * _STEP / span)
        rates = np.arange(0.5 * step, fastest + step, step)
        at = float(one.t[one.count // 2])
        found = tops(one.seen, one.t, at, frames, rates)
        best = np.argsort(found.misfit, kind="stable")[:count]
        if not best.size:
            continue
        frame = frames[found.axis[best]]
        ratio = found.ratio[best]
        # Along frames whose z is the symmetry axis.
        across = np.stack([ratio, ratio, np.ones_like(ratio)], axis=-1)
        if problem.parameters.axes:
            moments, mount = across, conjugate(frame)
        else:
            moments = np.abs(np.einsum("bji,bj->bi", matrices(frame), across))
            moments = moments if known is None else np.broadcast_to(known, moments.shape)
            mount = np.broadcast_to(IDENTITY, (best.size, 4))
        yield _at(problem, at, found.omega[best], moments, mount)


@dataclass(frozen=True, slots=True)
class Tops:
    """Symmetric tops that have been fitted to attitudes.

    omega (B, 3): rates along the observed axes. axis (B,): index of the frame that has the symmetry
    axis for its z. ratio (B,): moment across over moment along the axis. misfit (B,).
    """

    omega: np.ndarray
    axis: np.ndarray
    ratio: np.ndarray
    misfit: np.ndarray


def tops(q: np.ndarray, t: np.ndarray, at: float, frames: np.ndarray, rates: np.ndarray) -> Tops:
    """Fit all symmetric tops of a grid to attitudes.

    q (N, 4): attitudes at times t (N,).

    Tops that no body can be are left out. at: the time of the rates. frames (F, 4): quaternions
    from the observed axes to axes with the symmetry axis as z. rates (G,): of precession, and both
    ways of rotation, rad/s, positive.
    """
    seen = matrices(q) @ np.swapaxes(matrices(frames), -2, -1)[:, None]
    turn, tilt, cone = _cones(seen[..., 2], t - at, rates)
    angles = _angles(seen, turn, tilt, t - at, rates)
    both = np.concatenate([-rates[::-1], rates])
    waves = np.exp(1j * angles) @ np.exp(-1j * np.outer(t - at, both)) / t.size
    shape = waves.shape
    misfit = cone[..., None] + 2 * (1 - np.abs(waves))
    with np.errstate(divide="ignore"):
        ratio = 1 + both / (rates[:, None] * np.cos(tilt)[..., None])
    good = (ratio > _LEAST) & np.isfinite(misfit)
    # Along the axes of the frame, W along the momentum plus w along z.
    psi = np.angle(waves)
    across, along = np.sin(tilt)[..., None], np.cos(tilt)[..., None] + np.zeros_like(psi)
    momentum = np.stack([-across * np.cos(psi), across * np.sin(psi), along], axis=-1)
    omega = rates[:, None, None] * momentum
    omega[..., 2] += both
    omega = np.einsum("fji,fgwj->fgwi", matrices(frames), omega)
    axis = np.broadcast_to(np.arange(shape[0])[:, None, None], shape)
    return Tops(omega[good], axis[good], np.clip(ratio[good], _FLAT, _NEEDLE), misfit[good])


def _cones(
    axes: np.ndarray, t: np.ndarray, rates: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fit a precession cone to a symmetry axis in space, for each precession rate.

    axes (F, N, 3): the symmetry axis of each frame at each time.

    Return A (F, G, 3, 3), theta (F, G) and the misfits (F, G).
    """
    phase = rates[:, None] * t
    waves = np.stack([np.ones_like(phase), np.cos(phase), np.sin(phase)], axis=-1)
    inverse = np.linalg.pinv(waves)
    columns = np.einsum("gkn,fni->fgik", inverse, axes)
    left = axes[:, None] - np.einsum("fgik,gnk->fgni", columns, waves)
    centre, one, other = np.moveaxis(columns, -1, 0)
    x, z = _unit(one), _unit(np.cross(one, other))
    tilt = np.arctan2(
        (np.linalg.norm(one, axis=-1) + np.linalg.norm(other, axis=-1)) / 2,
        np.sum(centre * z, axis=-1),
    )
    turn = np.stack([x, np.cross(z, x), z], axis=-1)
    return turn, tilt, np.mean(np.sum(left**2, axis=-1), axis=-1)


def _unit(vectors: np.ndarray) -> np.ndarray:
    with np.errstate(invalid="ignore", divide="ignore"):
        return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _angles(
    seen: np.ndarray, turn: np.ndarray, tilt: np.ndarray, t: np.ndarray, rates: np.ndarray
) -> np.ndarray:
    """Return the remaining rotation angles psi (F, G, N) about the symmetry axis."""
    about_z = matrices(of_rotation_vectors(np.multiply.outer(np.outer(rates, t), np.eye(3)[2])))
    about_y = matrices(of_rotation_vectors(np.multiply.outer(tilt, np.eye(3)[1])))
    before = turn[:, :, None] @ about_z @ about_y[:, :, None]
    left = np.swapaxes(before, -2, -1) @ seen[:, None]
    return np.arctan2(left[..., 1, 0] - left[..., 0, 1], left[..., 0, 0] + left[..., 1, 1])


def _from_anywhere(problem: Problem, known: np.ndarray | None, count: int, fastest: float) -> Point:
    """Return starting motions spread over all rates, shapes, axes and attitudes.

    They are drawn from a Sobol sequence.
    """
    size = 1 << (count - 1).bit_length()
    cube = qmc.Sobol(12, scramble=False).random(size)
    omega = _ball(cube[:, :3]) * fastest
    shape = 6 * (cube[:, 3:5] - 0.5)
    level = Point(
        _quaternions(cube[:, 5:8]), omega, np.ones((size, 3)), _quaternions(cube[:, 8:11])
    )
    moments = Parameters().moved(level, np.hstack([np.zeros((size, 6)), shape])).moments
    moments = moments if known is None else np.broadcast_to(known, moments.shape)
    mount = level.mount if problem.parameters.axes else np.broadcast_to(IDENTITY, (size, 4))
    attitude = level.attitude
    if any(one.tells_attitude for one in problem.sets):
        attitude = np.broadcast_to(IDENTITY, (size, 4))
    return Point(attitude, omega, moments, mount)


def _at(
    problem: Problem, time: float, rates: np.ndarray, moments: np.ndarray, mount: np.ndarray
) -> Point:
    """Return the motions that have given rates (B, 3) at a given time.

    time: s. rates: along the observed axes, rad/s.
    """
    own = rotated(conjugate(mount), rates)
    since = np.array([problem.epoch - time])
    _, omega = propagate(moments, own, since, errors="nan", engine=problem.engine)
    return Point(np.broadcast_to(IDENTITY, (len(own), 4)), omega[:, 0], moments, mount)


def _sphere(count: int = 24) -> np.ndarray:
    """Return quaternions (count, 4) spread evenly over all rotations."""
    return _quaternions(qmc.Sobol(3, scramble=False).random(32)[1 : count + 1])


def _ball(cube: np.ndarray) -> np.ndarray:
    """Map points of the unit cube evenly to vectors (B, 3) in the unit ball."""
    height, angle = 2 * cube[:, 0] - 1, 2 * np.pi * cube[:, 1]
    across = np.sqrt(1 - height**2)
    directions = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=-1)
    return np.cbrt(cube[:, 2:]) * directions


def _quaternions(cube: np.ndarray) -> np.ndarray:
    """Map points of the unit cube evenly to rotation quaternions (B, 4).

    Source: Shoemake, Graphics Gems III (1992).
    """
    a, b = np.sqrt(1 - cube[:, 0]), np.sqrt(cube[:, 0])
    one, other = 2 * np.pi * cube[:, 1], 2 * np.pi * cube[:, 2]
    parts = [a * np.sin(one), a * np.cos(one), b * np.sin(other), b * np.cos(other)]
    return np.stack(parts, axis=-1)


def aligned(problem: Problem, point: Point) -> Point:
    """Rotate each motion in space so that it agrees best with the observations."""
    telling = [
        (one, at)
        for one, at in zip(problem.sets, problem.indices, strict=True)
        if one.tells_attitude
    ]
    if not telling:
        return point
    free = replace(point, attitude=np.broadcast_to(IDENTITY, point.attitude.shape))
    q, omega = free.in_observed_axes(*states(free, problem.since, problem.engine))
    matrix = np.zeros((point.count, 4, 4))
    for one, at in telling:
        matrix += one.davenport(q[:, at], omega[:, at])
    good = np.isfinite(matrix).all(axis=(1, 2))
    attitude = np.broadcast_to(IDENTITY, point.attitude.shape).copy()
    attitude[good] = np.linalg.eigh(matrix[good])[1][..., -1]
    return replace(point, attitude=attitude)
