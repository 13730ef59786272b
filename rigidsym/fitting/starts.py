"""Where searches start: rates at one time, moments and axes, from what each kind of sight tells.

Attitudes are not part of it: `alignment` finds them.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.stats import qmc

from rigidsym.fitting import tops
from rigidsym.fitting.alignment import aligns
from rigidsym.fitting.observations import Attitudes, Observations, Rates
from rigidsym.fitting.parameters import IDENTITY, Parameters, Point, joined
from rigidsym.fitting.problem import Problem
from rigidsym.motion import propagate
from rigidsym.quaternions import conjugate, matrices, product, rotated, rotation_vectors

# From the axes of a body to axes with the first, second and third as z.
_FRAMES = np.array([[0.5, -0.5, -0.5, -0.5], [0.5, 0.5, 0.5, 0.5], [1.0, 0.0, 0.0, 0.0]])
# Rotation from one attitude to the next is told from that by whole turns more below it, rad.
_PLAIN, _LARGEST = 1.0, 2.0
_MARGIN = 1.5
# Of the way of a wave over the arc: two steps of the grid for each radian that matters.
_STEP = np.pi / 2
_FEWEST = 8


@dataclass(frozen=True, slots=True)
class Body:
    """What starts are made of besides rates: moments (S, 3), and axes `mount` (S, 4)."""

    moments: np.ndarray
    mount: np.ndarray


def starts(problem: Problem, known: np.ndarray | None, count: int, fastest: float) -> Point:
    """Some `count` motions from which to look for minima.

    known (3,): moments, where they are known or guessed.  fastest: the largest rate, rad/s.
    """
    found = [*_from_tops(problem, known, count, fastest), *_from_rates(problem, known)]
    if not found:
        found = [_from_anywhere(problem, known, count, fastest)]
    return joined(found)


def fastest_rate(sets: tuple[Observations, ...]) -> float:
    """The largest rate that the observations ask for, rad/s.

    With rates among them their largest; with attitudes so close that the turns between them are
    plain, what these show; else half a turn between observations.
    """
    shown = [np.max(np.linalg.norm(x, axis=-1), initial=0.0) for _, x in _series(sets)]
    if shown and max(shown) > 0:
        return _MARGIN * float(max(shown))
    times = np.unique(np.concatenate([one.t for one in sets]))
    return float(np.pi / np.median(np.diff(times)))


def _series(sets: tuple[Observations, ...]) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Times (N,) and rates (N, 3) along the axes observed, of each set that shows them."""
    for one in sets:
        if isinstance(one, Rates):
            yield one.t, one.seen
        elif isinstance(one, Attitudes) and one.count > 1:
            yield from _differences(one)


def _differences(one: Attitudes) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Between attitudes far enough apart that errors count little, where turns are plain."""
    if np.max(_turns(one, 1)[1]) > _PLAIN:
        return
    stride = 1
    while 2 * stride < one.count and np.max(_turns(one, 2 * stride)[1]) < _LARGEST:
        stride *= 2
    turns, _ = _turns(one, stride)
    gaps = one.t[stride:] - one.t[:-stride]
    yield one.t[:-stride] + gaps / 2, turns / gaps[:, None]


def _turns(one: Attitudes, stride: int) -> tuple[np.ndarray, np.ndarray]:
    """Rotation vectors from each attitude to another, in the axes of the body; their lengths."""
    turns = rotation_vectors(product(conjugate(one.seen[:-stride]), one.seen[stride:]))
    return turns, np.linalg.norm(turns, axis=-1)


def _from_rates(problem: Problem, known: np.ndarray | None) -> Iterator[Point]:
    """At the first, a middle and the last rates of each series, with bodies of many shapes."""
    bodies = _bodies(problem.parameters, known)
    for times, rates in _series(problem.sets):
        for k in sorted({0, len(times) // 2, len(times) - 1}):
            yield _at(problem, times[k], np.broadcast_to(rates[k], bodies.moments.shape), bodies)


def _from_tops(
    problem: Problem, known: np.ndarray | None, count: int, fastest: float
) -> Iterator[Point]:
    """The best tops of a grid, from each set of attitudes."""
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
        found = tops.tops(one.seen, one.t, at, frames, rates)
        best = np.argsort(found.misfit, kind="stable")[:count]
        if not best.size:
            continue
        frame = frames[found.axis[best]]
        across = tops.moments(found.ratio[best])
        if problem.parameters.axes:
            bodies = Body(across, conjugate(frame))
        else:
            own = np.abs(np.einsum("bji,bj->bi", matrices(frame), across))
            own = own if known is None else np.broadcast_to(known, own.shape)
            bodies = Body(own, np.broadcast_to(IDENTITY, (best.size, 4)))
        yield _at(problem, at, found.omega[best], bodies)


def _from_anywhere(problem: Problem, known: np.ndarray | None, count: int, fastest: float) -> Point:
    """Sobol's sequence over rates, shapes, axes and, where nothing tells them, attitudes."""
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
    if aligns(problem.sets):
        attitude = np.broadcast_to(IDENTITY, (size, 4))
    return Point(attitude, omega, moments, mount)


def _at(problem: Problem, time: float, rates: np.ndarray, bodies: Body) -> Point:
    """Motions from the epoch that have these rates (B, 3), along the axes observed, at a time."""
    own = rotated(conjugate(bodies.mount), rates)
    _, omega = propagate(
        bodies.moments,
        own,
        np.array([problem.epoch - time]),
        errors="nan",
        engine=problem.engine,
    )
    attitude = np.broadcast_to(IDENTITY, (len(own), 4))
    return Point(attitude, omega[:, 0], bodies.moments, bodies.mount)


def _bodies(parameters: Parameters, known: np.ndarray | None) -> Body:
    """Shapes all over what bodies can be, in all orders; or the one that is known."""
    shares = (np.array([(i, j, 9 - i - j) for i in range(10) for j in range(10 - i)]) + 1 / 3) / 10
    moments = 1 - shares if known is None else np.asarray(known, float)[None]
    mounts = conjugate(_sphere()) if parameters.axes else IDENTITY[None]
    return Body(np.repeat(moments, len(mounts), axis=0), np.tile(mounts, (len(moments), 1)))


def _sphere(count: int = 24) -> np.ndarray:
    """Rotations spread over all there are."""
    return _quaternions(qmc.Sobol(3, scramble=False).random(32)[1 : count + 1])


def _ball(cube: np.ndarray) -> np.ndarray:
    """Vectors (B, 3) evenly in the unit ball, of a cube's points."""
    height, angle = 2 * cube[:, 0] - 1, 2 * np.pi * cube[:, 1]
    across = np.sqrt(1 - height**2)
    directions = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=-1)
    return np.cbrt(cube[:, 2:]) * directions


def _quaternions(cube: np.ndarray) -> np.ndarray:
    """Rotations (B, 4) evenly spread, of a cube's points (Shoemake, Graphics Gems III, 1992)."""
    a, b = np.sqrt(1 - cube[:, 0]), np.sqrt(cube[:, 0])
    one, other = 2 * np.pi * cube[:, 1], 2 * np.pi * cube[:, 2]
    parts = [a * np.sin(one), a * np.cos(one), b * np.sin(other), b * np.cos(other)]
    return np.stack(parts, axis=-1)
