"""Agreement of model and data, including outliers and mistaken conventions of the data."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import product as every

import numpy as np
from scipy.stats import chi2 as chi2_law

from rigidsym.fitting._minimise import Minimum, minimise
from rigidsym.fitting._observability import Observability, observability
from rigidsym.fitting._observations import KINDS, Observations, Rates
from rigidsym.fitting._parameters import Point, states
from rigidsym.fitting._problem import Problem
from rigidsym.quaternions import conjugate, rotated

Search = Callable[[Problem], list[Minimum]]
Sets = tuple[Observations, ...]
Names = tuple[str, ...]
Place = tuple[int, int]
"The set and the index of an observation."

# Probability that errors of the stated size make chi2 as large, or as small.
_CHANCE = 1e-6
# Root mean square of residuals over that of a motion unrelated to the observations: from the first
# on other conventions are tried, from the second on residuals cannot be errors.
_SUSPECT, _GROSS = 0.05, 0.25
# The largest part of the observations that may be outliers.
_FEW = 0.25
# Limit of the correlation of residuals with the next ones, in standard deviations.
_SERIAL = 5.0
# Factor by which another convention must reduce chi2, and factor within which two are equal.
_BETTER, _TIE = 10.0, 2.0
# Probability that any of good observations is named an outlier.
_OUTLIER_CHANCE = 0.01
# Least eigenvalue of 1 - H for an observation that others predict.
_ALONE = 1e-9
# Units of rates or times that others use, with the factor to the expected units.
_RATES = {
    "rates in degrees": np.pi / 180,
    "rates in degrees a day": np.pi / 180 / 86400,
    "rates in revolutions": 2 * np.pi,
    "rates in revolutions a minute": 2 * np.pi / 60,
    "rates in rad/min": 1 / 60,
    "rates in rad/h": 1 / 3600,
    "times in ms, or rates in mrad/s": 1e-3,
    "times in min": 60.0,
    "times in h": 3600.0,
    "times in days": 86400.0,
}


class Verdict(StrEnum):
    """Verdict on how well model and data agree."""

    AGREE = "agree"
    LARGER = "residuals are larger than the errors given"
    SMALLER = "residuals are smaller than the errors given"
    OUTLIERS = "outliers"
    DISAGREE = "model and data disagree"


@dataclass(frozen=True, slots=True)
class Reading:
    """A reading of the data in another convention, with the chi2 of its best fit."""

    name: str
    chi2: float


@dataclass(frozen=True, slots=True)
class Agreement:
    """The verdict on the residuals of a fit, with advice.

    scale: the root of chi2 over its degrees of freedom. message: one line on what to do, empty
    where residuals agree with the errors. readings: conventions by which the data fit instead.
    """

    verdict: Verdict
    scale: float
    message: str = ""
    readings: tuple[Reading, ...] = ()

    @property
    def hopeless(self) -> bool:
        """Return True if model and data disagree.

        The errors of the motion then mean nothing.
        """
        return self.verdict is Verdict.DISAGREE


def agreement(problem: Problem, point: Point, freedom: int, search: Search) -> Agreement:
    """Judge whether the residuals of a motion agree with the stated errors.

    freedom: degrees of freedom of chi2. search: returns the minima of a problem; other conventions
    of the data are tried only where chi2 is too large and residuals are far from small.
    """
    residuals = problem.residuals(point)
    chi2 = float(np.sum(residuals**2))
    if not np.isfinite(chi2):
        return Agreement(Verdict.DISAGREE, np.inf, "the motion has no states at some times")
    scale = float(np.sqrt(chi2 / max(freedom, 1)))
    tails = chi2_law.sf(chi2, freedom), chi2_law.cdf(chi2, freedom)
    if freedom < 1 or min(tails) > _CHANCE:
        return Agreement(Verdict.AGREE, scale)
    if chi2 < freedom:
        said = f"residuals are {scale:.2g} of the errors given: standard deviations are too large"
        return Agreement(Verdict.SMALLER, scale, said)
    named = _outlier_count(problem, point)
    if named:
        said = f'{named} outliers make chi2: remove them, or use loss="cauchy"'
        return Agreement(Verdict.OUTLIERS, scale, said)
    sizes = _sizes(problem, point)
    found = _readings(problem, chi2, search) if max(sizes) > _SUSPECT else []
    if found:
        least = min(x.chi2 for x in found)
        found = [x for x in found if x.chi2 <= _TIE * (least + freedom)]
        names = "; or ".join(f"{x.name} (chi2 {x.chi2:.6g})" for x in found)
        said = f"the data fit when read as {names}"
        return Agreement(Verdict.DISAGREE, scale, said, tuple(found))
    # Unlike errors, residuals that a model lacks are correlated with the next ones.
    series = [residuals[rows] for rows in problem.rows]
    tiny = np.finfo(float).tiny
    serial = [np.sum(x[1:] * x[:-1]) / max(np.sum(x**2), tiny) * np.sqrt(x.size) for x in series]
    if max(sizes) > _GROSS or max(serial) > _SERIAL:
        said = "no usual reading of the data fits: check units, axes, times, moments, and torques"
        return Agreement(Verdict.DISAGREE, scale, said)
    said = (
        f"residuals are {scale:.2g} times the errors given: standard deviations are as much larger"
    )
    return Agreement(Verdict.LARGER, scale, said)


def _outlier_count(problem: Problem, point: Point) -> int:
    """Return the number of outliers if chi2 is too large only because of them.

    Return 0 otherwise.
    """
    robust = minimise(problem, point, "cauchy")
    named = outliers(problem, observability(problem, robust.point))
    if not 0 < len(named) <= _FEW * sum(one.count for one in problem.sets):
        return 0
    sets = []
    for k, one in enumerate(problem.sets):
        kept = np.setdiff1d(np.arange(one.count), [index for place, index in named if place == k])
        sets += [one.some(kept)] if kept.size else []
    left = replace(problem, sets=tuple(sets))
    freedom = left.count - left.parameters.count
    if freedom < 1:
        return 0
    best = minimise(left, robust.point)
    return len(named) if chi2_law.sf(best.cost, freedom) > _CHANCE else 0


def _sizes(problem: Problem, point: Point) -> list[float]:
    """Return the relative residual size of each set of observations that fits badly.

    A set fits badly if its residuals are too large.  A zero precedes the sizes.

    Sizes are relative to the residuals of a motion unrelated to the set.
    """
    seen = point.in_observed_axes(*states(point, problem.since, problem.engine))
    found = [0.0]
    for one, at in zip(problem.sets, problem.indices, strict=True):
        missed = one.residuals(*(x[at] for x in seen))
        chi2 = np.sum(one.whitened(missed[..., None]) ** 2)
        if chi2_law.sf(chi2, missed.size) < _CHANCE:
            square = np.mean(np.sum(missed**2, axis=-1))
            found.append(float(np.sqrt(square / one.unrelated)))
    return found


def _readings(problem: Problem, chi2: float, search: Search) -> list[Reading]:
    """Return the conventions under which the data fit, or at least fit far better."""
    found: dict[str, float] = {}
    for names, posed, point in _minima(problem, search):
        freedom = posed.count - posed.parameters.count
        least = float(np.sum(posed.residuals(point) ** 2))
        fits = freedom > 0 and chi2_law.sf(least, freedom) > _CHANCE
        if names and (fits or least * _BETTER < chi2):
            found.setdefault(", ".join(names), least)
    return [Reading(name, least) for name, least in found.items()]


def _minima(problem: Problem, search: Search) -> Iterator[tuple[Names, Problem, Point]]:
    """Yield each combination of conventions with the refitted problem and its best motion.

    Rates alone are read in each unit; rates beside others by what suits the motion of the others.
    """
    rates = tuple(one for one in problem.sets if isinstance(one, Rates))
    others = tuple(one for one in problem.sets if not isinstance(one, Rates))
    for name, factor in {} if others else _RATES.items():
        posed = replace(problem, sets=tuple(one.scaled(factor) for one in rates))
        yield (name,), posed, search(posed)[0].point
    for names, sets in _by_conventions(others):
        posed = replace(problem, sets=sets)
        if not (names or rates) or not others or posed.count < posed.parameters.count:
            continue
        point = search(posed)[0].point
        for said, read in _rates_by(point, posed, rates):
            whole = replace(problem, sets=(*sets, *read))
            yield (*names, *said), whole, minimise(whole, point).point if rates else point


def _by_conventions(sets: Sets) -> Iterator[tuple[Names, Sets]]:
    """Yield all combinations of conventions, as names and converted observations."""
    kinds = [kind for kind in KINDS if any(one.kind == kind for one in sets)]
    for names in every(*(KINDS[kind].conventions for kind in kinds)):
        chosen = dict(zip(kinds, names, strict=True))
        read = tuple(one.by_convention(chosen[one.kind]) for one in sets)
        yield tuple(f"{kind} {name}" for kind, name in chosen.items() if name), read


def _rates_by(point: Point, problem: Problem, rates: Sets) -> Iterator[tuple[Names, Sets]]:
    """Yield names of conventions in which observed rates suit a motion, with converted rates.

    These are the best axes and unit, first with errors in the same unit, then with errors as they
    are.
    """
    if not rates or not np.isfinite(problem.residuals(point)).all():
        yield (), rates
        return
    candidates = []
    for axes, (name, factor) in every(("body", "inertial"), (("", 1.0), *_RATES.items())):
        read, missed, size = [], 0.0, 0.0
        for one in rates:
            q, omega = point.in_observed_axes(*states(point, one.t - problem.epoch, problem.engine))
            seen = factor * (one.seen if axes == "body" else rotated(conjugate(q), one.seen))
            missed += float(np.sum((seen - omega) ** 2))
            size += float(np.sum(omega**2))
            read.append(one.changed(seen=seen))
        said = [name] * bool(name) + ["rates along inertial axes"] * (axes != "body")
        if missed < _GROSS**2 * size:
            candidates.append((missed, tuple(said), factor, tuple(read)))
    if not candidates:
        return
    _, said, factor, read = min(candidates, key=lambda x: x[0])
    yield said, tuple(one.changed(weights=one.weights / factor) for one in read)
    yield said, read


def against_others(
    sets: list[np.ndarray], residuals: np.ndarray, part: np.ndarray
) -> list[np.ndarray]:
    """Return the chi2 of each observation against its prediction from all others.

    There is an array (N,) for each set of observations.

    sets: indices (N, width) of residuals; part: an orthonormal basis of the changes that
    parameters make to residuals.  With leverages H = part part^T it is r^T (1 - H)^-1 r, with as
    many degrees of freedom as the observation has numbers; NaN where the others predict nothing.
    """
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


def outliers(problem: Problem, found: Observability) -> tuple[Place, ...]:
    """Return the outliers at 1 % significance, as pairs of set and observation indices.

    The significance is that of all observations together.

    The worst is removed first, and the others are judged again without it.
    """
    total = sum(one.count for one in problem.sets)
    limits = [float(chi2_law.isf(_OUTLIER_CHANCE / total, one.width)) for one in problem.sets]
    moved, residuals = found.basis.copy(), found.residuals
    named: list[Place] = []
    part = moved
    while len(named) < total // 2:
        misses = against_others(problem.rows, residuals, part)
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
        # A basis of the errors of the rest.
        left, sizes, _ = np.linalg.svd(moved, full_matrices=False)
        part = left * (sizes > 0)
    return tuple(sorted(named))
