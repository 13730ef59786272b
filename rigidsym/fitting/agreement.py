"""Agreement of model and data: goodness of fit, outliers, and other conventions of the data."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import product as every

import numpy as np
from scipy.stats import chi2 as chi2_law

from rigidsym.fitting.local import Local, local
from rigidsym.fitting.observability import observability
from rigidsym.fitting.observations import Attitudes, Directions, Observations, Rates
from rigidsym.fitting.outliers import outliers
from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.states import states
from rigidsym.quaternions import conjugate, rotated

Search = Callable[[Problem], list[Local]]
Sets = tuple[Observations, ...]
Names = tuple[str, ...]

# That errors of the size given make chi2 as large, or as small.
_CHANCE = 1e-6
# Of the residuals of a motion that has nothing to do with the observations, as root mean squares:
# from where on another reading of the data is tried, and from where on no errors are as large.
_SUSPECT, _GROSS = 0.05, 0.25
# Of the observations: how many may be outliers.
_FEW = 0.25
# Standard deviations of the correlation of residuals with the next ones.
_SERIAL = 5.0
# How many times smaller another reading makes chi2, and what is as small.
_BETTER, _TIE = 10.0, 2.0
_ATTITUDES: tuple[str, ...] = (
    "",
    "scalar last",
    "inertial to body",
    "scalar last and inertial to body",
)
_DIRECTIONS: tuple[str, ...] = ("", "known and seen exchanged")
# By what factor rates are those that belong to the times.
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
    """What residuals say of model and data."""

    AGREE = "agree"
    LARGER = "residuals are larger than the errors given"
    SMALLER = "residuals are smaller than the errors given"
    OUTLIERS = "outliers"
    DISAGREE = "model and data disagree"


@dataclass(frozen=True, slots=True)
class Reading:
    """Another convention that the data may follow, and chi2 of the best motion then."""

    name: str
    chi2: float


@dataclass(frozen=True, slots=True)
class Agreement:
    """A verdict on residuals: the root of chi2 over its degrees of freedom, one line on what to do
    (empty where they agree), and the readings of the data that fit instead."""

    verdict: Verdict
    scale: float
    message: str = ""
    readings: tuple[Reading, ...] = ()

    @property
    def hopeless(self) -> bool:
        """Whether the motion is not that of the data, so that its errors mean nothing."""
        return self.verdict is Verdict.DISAGREE


def agreement(problem: Problem, point: Point, freedom: int, search: Search) -> Agreement:
    """Judge the residuals of a motion by what they are beside errors.

    freedom: of chi2.  search: minima of a problem; other readings of the data are tried only where
    chi2 is too large and residuals are far from small.
    """
    residuals = problem.residuals(point)
    chi2 = float(np.sum(residuals**2))
    if not np.isfinite(chi2):
        return Agreement(Verdict.DISAGREE, np.inf, "the motion has no states at some times")
    scale = float(np.sqrt(chi2 / max(freedom, 1)))
    if freedom < 1 or _allows(chi2, freedom):
        return Agreement(Verdict.AGREE, scale)
    if chi2 < freedom:
        said = f"residuals are {scale:.2g} of the errors given: standard deviations are too large"
        return Agreement(Verdict.SMALLER, scale, said)
    named = _named(problem, point)
    if named:
        said = f'{named} outliers make chi2: remove them, or use loss="cauchy"'
        return Agreement(Verdict.OUTLIERS, scale, said)
    sizes = _sizes(problem, point)
    found = list(_readings(problem, chi2, search)) if max(sizes) > _SUSPECT else []
    if found:
        least = min(x.chi2 for x in found)
        found = [x for x in found if x.chi2 <= _TIE * (least + freedom)]
        names = "; or ".join(f"{x.name} (chi2 {x.chi2:.6g})" for x in found)
        return Agreement(
            Verdict.DISAGREE, scale, f"the data fit when read as {names}", tuple(found)
        )
    if max(sizes) > _GROSS or _is_serial(problem, residuals):
        said = "no usual reading of the data fits: check units, axes, times, moments, and torques"
        return Agreement(Verdict.DISAGREE, scale, said)
    said = (
        f"residuals are {scale:.2g} times the errors given: standard deviations are as much larger"
    )
    return Agreement(Verdict.LARGER, scale, said)


def _allows(chi2: float, freedom: int) -> bool:
    return min(chi2_law.sf(chi2, freedom), chi2_law.cdf(chi2, freedom)) > _CHANCE


def _named(problem: Problem, point: Point) -> int:
    """Return how many outliers there are, where few are all that is wrong; else 0."""
    robust = local(problem, point, "cauchy")
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
    best = local(left, robust.point)
    return len(named) if chi2_law.sf(best.cost, freedom) > _CHANCE else 0


def _sizes(problem: Problem, point: Point) -> list[float]:
    """Return the residuals of each set that misses by more than its errors, over those of a motion
    that has nothing to do with it."""
    seen = point.seen(*states(point, problem.since, problem.engine))
    found = [0.0]
    for one, at in zip(problem.sets, problem.places, strict=True):
        missed = one.residuals(*(x[at] for x in seen))
        chi2 = np.sum(one.whitened(missed[..., None]) ** 2)
        if chi2_law.sf(chi2, missed.size) < _CHANCE:
            square = np.mean(np.sum(missed**2, axis=-1))
            found.append(float(np.sqrt(square / one.unrelated)))
    return found


def _is_serial(problem: Problem, residuals: np.ndarray) -> bool:
    """Whether the residuals of a set go with the next ones, as errors do not."""
    for rows in problem.rows:
        own = residuals[rows]
        serial = np.sum(own[1:] * own[:-1]) / max(np.sum(own**2), np.finfo(float).tiny)
        if serial * np.sqrt(own.size) > _SERIAL:
            return True
    return False


def _readings(problem: Problem, chi2: float, search: Search) -> Iterator[Reading]:
    """Yield the readings by which the data fit, or chi2 is a small part of what it was."""
    found: dict[str, float] = {}
    for names, posed, point in _minima(problem, search):
        freedom = posed.count - posed.parameters.count
        least = float(np.sum(posed.residuals(point) ** 2))
        fits = freedom > 0 and chi2_law.sf(least, freedom) > _CHANCE
        if names and (fits or least * _BETTER < chi2):
            found.setdefault(", ".join(names), least)
    yield from (Reading(name, least) for name, least in found.items())


def _minima(problem: Problem, search: Search) -> Iterator[tuple[Names, Problem, Point]]:
    """Yield the names of readings of all sets, the problem by each, and its best motion.

    Rates by themselves are read in each unit; with others, as suits the motion of the others.
    """
    rates = tuple(one for one in problem.sets if isinstance(one, Rates))
    others = tuple(one for one in problem.sets if not isinstance(one, Rates))
    for name, factor in {} if others else _RATES.items():
        posed = replace(problem, sets=tuple(_scaled(one, factor) for one in rates))
        yield (name,), posed, search(posed)[0].point
    for names, sets in _read(others):
        posed = replace(problem, sets=sets)
        if not (names or rates) or not others or posed.count < posed.parameters.count:
            continue
        point = search(posed)[0].point
        for said, read in _rates_by(point, posed, rates):
            whole = replace(problem, sets=(*sets, *read))
            yield (*names, *said), whole, local(whole, point).point if rates else point


def _scaled(one: Observations, factor: float) -> Observations:
    """Rates with their errors in another unit."""
    return one.changed(seen=factor * one.seen, weights=one.weights / factor)


def _read(sets: Sets) -> Iterator[tuple[Names, Sets]]:
    """Yield the names of all readings of attitudes and directions, and the sets read by them."""
    has = [any(isinstance(one, kind) for one in sets) for kind in (Attitudes, Directions)]
    asked = (_ATTITUDES if has[0] else _ATTITUDES[:1], _DIRECTIONS if has[1] else _DIRECTIONS[:1])
    for attitude, direction in every(*asked):
        found = []
        for one in sets:
            seen = one.seen
            if isinstance(one, Directions) and direction:
                one = one.changed(seen_in="space" if one.seen_in == "body" else "body")
            if isinstance(one, Attitudes) and "last" in attitude:
                seen = np.roll(seen, 1, axis=-1)
            if isinstance(one, Attitudes) and "inertial" in attitude:
                seen = conjugate(seen)
            found.append(one.changed(seen=seen))
        names = {"attitudes": attitude, "vectors": direction}
        yield tuple(f"{kind} {name}" for kind, name in names.items() if name), tuple(found)


def _rates_by(point: Point, problem: Problem, rates: Sets) -> Iterator[tuple[Names, Sets]]:
    """Yield the name of a reading of rates, and the sets read by it: by the axes and the unit that
    suit a motion best, first with errors in the same unit, then with errors as they are."""
    if not rates or not np.isfinite(problem.residuals(point)).all():
        yield (), rates
        return
    candidates = []
    for axes, (name, factor) in every(("body", "inertial"), (("", 1.0), *_RATES.items())):
        read, missed, size = [], 0.0, 0.0
        for one in rates:
            q, omega = point.seen(*states(point, one.t - problem.epoch, problem.engine))
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
