"""Starts of a search: rates, moments and axes from each kind of observations, and then attitudes.

The attitude is determined last, in closed form, for many motions at once.  A motion with the
identity for its attitude at the epoch is right up to one rotation A on the left; A as a quaternion
is the eigenvector of the largest eigenvalue of Davenport's matrix (Davenport, 1968; Markley, J.
Astronautical Sciences 55, 2007).
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from scipy.stats import qmc

from rigidsym.fitting._observations import Attitudes, Observations
from rigidsym.fitting._parameters import IDENTITY, Parameters, Point, joined, states
from rigidsym.fitting._problem import Problem
from rigidsym.fitting._symmetric_tops import tops
from rigidsym.motion import propagate
from rigidsym.quaternions import conjugate, matrices, rotated

# From the axes of a body to axes with the first, second and third as z.
_FRAMES = np.array([[0.5, -0.5, -0.5, -0.5], [0.5, 0.5, 0.5, 0.5], [1.0, 0.0, 0.0, 0.0]])
# The largest rate of a search over the largest rate that the observations contain.
_MARGIN = 1.5
# Phase over the arc between two rates of the grid of tops, rad.
_STEP = np.pi / 2
# The fewest attitudes that tops are fitted to, and the fewest rates of their grid.
_FEWEST = 8


def starts(problem: Problem, known: np.ndarray | None, count: int, fastest: float) -> Point:
    """Return about `count` motions from which to look for minima.

    known (3,): moments, where they are known or guessed. fastest: the largest rate, rad/s.
    """
    found = [*_from_tops(problem, known, count, fastest), *_from_rates(problem, known)]
    if not found:
        found = [_from_anywhere(problem, known, count, fastest)]
    return joined(found)


def fastest_rate(sets: tuple[Observations, ...]) -> float:
    """Return the largest rate to search, rad/s.

    It follows from the rates among the observations, or from attitudes so close that the turns
    between them are unambiguous; else it is half a turn between observations.
    """
    series = [x for one in sets for _, x in one.rate_series()]
    fastest = max((np.max(np.linalg.norm(x, axis=-1), initial=0.0) for x in series), default=0.0)
    if fastest > 0:
        return _MARGIN * float(fastest)
    times = np.unique(np.concatenate([one.t for one in sets]))
    return float(np.pi / np.median(np.diff(times)))


def _from_rates(problem: Problem, known: np.ndarray | None) -> Iterator[Point]:
    """Yield motions with the first, a middle and the last rates of each series, for many bodies."""
    moments, mount = _bodies(problem.parameters, known)
    for times, rates in (series for one in problem.sets for series in one.rate_series()):
        for k in sorted({0, len(times) // 2, len(times) - 1}):
            every = np.broadcast_to(rates[k], moments.shape)
            yield _at(problem, times[k], every, moments, mount)


def _from_tops(
    problem: Problem, known: np.ndarray | None, count: int, fastest: float
) -> Iterator[Point]:
    """Yield the best symmetric tops of a grid, from each set of attitudes."""
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


def _from_anywhere(problem: Problem, known: np.ndarray | None, count: int, fastest: float) -> Point:
    """Return motions of Sobol's sequence over rates, shapes, axes and, if unknown, attitudes."""
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
    """Return motions that have rates (B, 3), along the observed axes, at a time, s."""
    own = rotated(conjugate(mount), rates)
    since = np.array([problem.epoch - time])
    _, omega = propagate(moments, own, since, errors="nan", engine=problem.engine)
    return Point(np.broadcast_to(IDENTITY, (len(own), 4)), omega[:, 0], moments, mount)


def _bodies(parameters: Parameters, known: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """Return moments (S, 3) and mounts (S, 4) of bodies of all shapes, or of the known one."""
    shares = (np.array([(i, j, 9 - i - j) for i in range(10) for j in range(10 - i)]) + 1 / 3) / 10
    moments = 1 - shares if known is None else np.asarray(known, float)[None]
    mounts = conjugate(_sphere()) if parameters.axes else IDENTITY[None]
    return np.repeat(moments, len(mounts), axis=0), np.tile(mounts, (len(moments), 1))


def _sphere(count: int = 24) -> np.ndarray:
    """Return quaternions (count, 4) spread evenly over all rotations."""
    return _quaternions(qmc.Sobol(3, scramble=False).random(32)[1 : count + 1])


def _ball(cube: np.ndarray) -> np.ndarray:
    """Return vectors (B, 3) spread evenly in the unit ball, from a cube's points."""
    height, angle = 2 * cube[:, 0] - 1, 2 * np.pi * cube[:, 1]
    across = np.sqrt(1 - height**2)
    directions = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=-1)
    return np.cbrt(cube[:, 2:]) * directions


def _quaternions(cube: np.ndarray) -> np.ndarray:
    """Return rotations (B, 4) spread evenly, from a cube's points (Shoemake, Graphics Gems III,
    1992).
    """
    a, b = np.sqrt(1 - cube[:, 0]), np.sqrt(cube[:, 0])
    one, other = 2 * np.pi * cube[:, 1], 2 * np.pi * cube[:, 2]
    parts = [a * np.sin(one), a * np.cos(one), b * np.sin(other), b * np.cos(other)]
    return np.stack(parts, axis=-1)


def aligned(problem: Problem, point: Point) -> Point:
    """Return the motions (B,) turned as a whole so that they agree best with the observations."""
    telling = [
        (one, at)
        for one, at in zip(problem.sets, problem.indices, strict=True)
        if one.tells_attitude
    ]
    if not telling:
        return point
    free = replace(point, attitude=np.broadcast_to(IDENTITY, point.attitude.shape))
    q, _ = free.in_observed_axes(*states(free, problem.since, problem.engine))
    matrix = np.zeros((point.count, 4, 4))
    for one, at in telling:
        matrix += one.davenport(q[:, at])
    good = np.isfinite(matrix).all(axis=(1, 2))
    attitude = np.broadcast_to(IDENTITY, point.attitude.shape).copy()
    attitude[good] = np.linalg.eigh(matrix[good])[1][..., -1]
    return replace(point, attitude=attitude)
