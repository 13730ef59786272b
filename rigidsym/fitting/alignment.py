"""The attitude at the start, once all else is given: Davenport's matrix, for many motions at once.

A motion with the identity for its attitude at t = 0 is right up to one rotation A on the left,
which attitudes seen, and directions seen, decide in closed form: A as a quaternion is the
eigenvector of the largest eigenvalue (Davenport, 1968; Markley, J. Astronautical Sciences 55,
2007).
"""

from dataclasses import replace

import numpy as np

from rigidsym.fitting.observations import Attitudes, Directions, Observations
from rigidsym.fitting.parameters import IDENTITY, Point
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.states import states
from rigidsym.quaternions import conjugate, product, rotated


def aligns(sets: tuple[Observations, ...]) -> bool:
    """Whether there is anything that tells an attitude."""
    return any(isinstance(one, Attitudes | Directions) for one in sets)


def aligned(problem: Problem, point: Point) -> Point:
    """The motions (B,) turned as a whole, so that they show what was seen as well as they can."""
    if not aligns(problem.sets):
        return point
    free = replace(point, attitude=np.broadcast_to(IDENTITY, point.attitude.shape))
    q, _ = free.seen(*states(free, problem.since, problem.engine))
    matrix = np.zeros((point.count, 4, 4))
    for one, at in zip(problem.sets, problem.places, strict=True):
        if isinstance(one, Attitudes):
            matrix += _of_attitudes(one, q[:, at])
        elif isinstance(one, Directions):
            matrix += _of_directions(one, q[:, at])
    good = np.isfinite(matrix).all(axis=(1, 2))
    attitude = np.broadcast_to(IDENTITY, point.attitude.shape).copy()
    attitude[good] = np.linalg.eigh(matrix[good])[1][..., -1]
    return replace(point, attitude=attitude)


def _sizes(one: Observations) -> np.ndarray:
    """The mean inverse variance of each observation, (N,)."""
    return np.sum(one.weights**2, axis=(-2, -1)) / one.weights.shape[-1]


def _of_attitudes(one: Attitudes, q: np.ndarray) -> np.ndarray:
    between = product(one.seen, conjugate(q))
    return np.einsum("n,bni,bnj->bij", 2 * _sizes(one), between, between)


def _of_directions(one: Directions, q: np.ndarray) -> np.ndarray:
    """v . A u of A as a quaternion, of v in space and u turned there by the motion."""
    known = np.broadcast_to(np.asarray(one.known), one.seen.shape)
    space, body = (known, one.seen) if one.seen_in == "body" else (one.seen, known)
    turned = rotated(q, body)
    cosine = np.sum(turned * space, axis=-1)
    found = np.empty((*cosine.shape, 4, 4))
    found[..., 0, 0] = cosine
    found[..., 0, 1:] = found[..., 1:, 0] = np.cross(turned, space)
    outer = space[..., :, None] * turned[..., None, :]
    found[..., 1:, 1:] = outer + np.swapaxes(outer, -2, -1) - cosine[..., None, None] * np.eye(3)
    return np.einsum("n,bnij->bij", _sizes(one), found)
