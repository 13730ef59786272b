"""Each observation against all others, and those that do not belong to them."""

import numpy as np
from scipy.stats import chi2

from rigidsym.fitting.observability import Observability
from rigidsym.fitting.problem import Problem

# That any of good observations is named, all together.
_CHANCE = 0.01
# Where nothing but the observation itself tells what it would be.
_ALONE = 1e-9

Named = tuple[int, int]


def against_others(problem: Problem, found: Observability) -> list[np.ndarray]:
    """Of each set (N,): the chi2 with which each observation misses what the others predict of it,
    of as many degrees of freedom as it has numbers; NaN where they predict nothing."""
    return _deleted(problem.rows, found.residuals, found.moved)


def _deleted(sets: list[np.ndarray], residuals: np.ndarray, part: np.ndarray) -> list[np.ndarray]:
    """By the leverages part part^T of the rows: r^T (1 - H)^-1 r for each observation."""
    listed = []
    for rows in sets:
        own = part[rows]
        left = np.eye(rows.shape[1]) - own @ np.swapaxes(own, -2, -1)
        alone = np.linalg.eigvalsh(left)[:, 0] < _ALONE
        left[alone] = np.eye(rows.shape[1])
        r = residuals[rows]
        found = np.sum(r * np.linalg.solve(left, r[..., None])[..., 0], axis=-1)
        listed.append(np.where(alone, np.nan, found))
    return listed


def outliers(problem: Problem, found: Observability) -> tuple[Named, ...]:
    """Set and index of observations that the others do not allow, at 1 % for all of them together.

    The worst goes first, and the others are asked again without it.
    """
    total = sum(one.count for one in problem.sets)
    limits = [float(chi2.isf(_CHANCE / total, one.width)) for one in problem.sets]
    moved, residuals = found.moved.copy(), found.residuals
    named: list[Named] = []
    part = moved
    while len(named) < total // 2:
        misses = _deleted(problem.rows, residuals, part)
        over = [np.nan_to_num(x) / limit for x, limit in zip(misses, limits, strict=True)]
        worst = max(range(len(over)), key=lambda k: float(np.max(over[k])))
        place = int(np.argmax(over[worst]))
        if over[worst][place] <= 1:
            break
        named.append((worst, place))
        gone = problem.rows[worst][place]
        moved[gone] = 0.0
        kept = np.where(np.isin(np.arange(len(residuals)), gone), 0.0, residuals)
        step = np.linalg.lstsq(moved, -kept, rcond=None)[0]
        residuals = kept + moved @ step
        # Errors of the rest, without what has gone.
        left, sizes, _ = np.linalg.svd(moved, full_matrices=False)
        part = left * (sizes > 0)
    return tuple(sorted(named))
