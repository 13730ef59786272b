"""The fit of a motion to observations."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import chi2 as chi2_law

from rigidsym import _engines as engines
from rigidsym import _inputs as inputs
from rigidsym.errors import InputError, unknown
from rigidsym.fitting._fit import Fit
from rigidsym.fitting._minimise import LOSSES, Minimum, minimise
from rigidsym.fitting._parameters import IDENTITY, Point, motion, states
from rigidsym.fitting._problem import Problem, SetsLike, Sigma, observation_sets, posed
from rigidsym.fitting._result import Alternative
from rigidsym.fitting._search import search
from rigidsym.fitting._starts import aligned
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import product

STARTS, MOST_STARTS = 2000, 1_000_000
DELTA_CHI2 = 9.0
# Probability that errors alone make a spin look like more than a spin.
_CHANCE = 1e-3
# Digits of the state at t = 0 where doubles are not enough, next to a separatrix: the first that
# are enough, or the last.
_DIGITS = (30, 60)
# Change of a residual on the way to t = 0 and back that is accepted, in units of its error.
_SLIGHT = 1e-3


def fit(
    times: ArrayLike | None = None,
    *,
    attitudes: SetsLike = None,
    rates: SetsLike = None,
    vectors: SetsLike = None,
    models: SetsLike = None,
    sigma: Sigma = None,
    inertia: str = "ratios",
    moments: ArrayLike | None = None,
    scale: float | None = None,
    loss: str = "linear",
    guess: TorqueFreeMotion | None = None,
    starts: int = STARTS,
    fastest: float | None = None,
    delta_chi2: float = DELTA_CHI2,
    engine: str = engines.DEFAULT,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Fit:
    """Fit a torque-free motion to observations, with its errors and the alternatives.

    Parameters
    ----------
    times : (N,)
        Times of attitudes and rates that are given as arrays, s, increasing.
    attitudes : (N, 4), Attitudes, or a list of them
        Quaternions, scalar first, body to inertial, of either sign.
    rates : (N, 3), Rates, or a list of them
        Rates along the axes of the body, rad/s.
    vectors : Directions, or a list of them
        Directions known in space and seen in the body, or the reverse.
    models : Modelled, or a list of them
        Values that a function of yours computes from states.
    sigma : number, array, or a mapping by kind
        Errors of observations that are given as arrays: one standard deviation, (N,) of them, a
        covariance (k, k), or (N, k, k); attitudes in rad, as rotation vectors along the axes of
        the body.  `sigma["moments"]`: errors of the moments (3,), a prior that fixes their scale.
    inertia : {"ratios", "known", "tensor"}
        What is estimated of the inertia: two ratios of the principal moments along the observed
        axes; nothing; or ratios and the directions of the principal axes.
    moments : (3,)
        Principal moments, kg m^2: known, the mean of the prior, or a guess.
    scale : float
        The largest moment, kg m^2, where it is known; else it is the unit of the moments.
    loss : {"linear", "soft_l1", "huber", "cauchy", "arctan"}
        Loss of SciPy's least squares; all but the first reduce the influence of outliers.
    guess : TorqueFreeMotion
        Start of the fit; there is then no search, and there are no alternatives.
    starts : int
        Number of motions from which a search starts.
    fastest : float
        The largest rate to search, rad/s; by default derived from the observations.
    delta_chi2 : float
        Minima are kept up to so much above the best chi2.
    engine : str
        As for `TorqueFreeMotion`.
    progress : function
        Called with the steps done and their total.

    Returns
    -------
    Fit
        The best motion, its errors and alternatives.  It is returned without convergence, too: see
        `converged` and `reason`.

    Raises
    ------
    InputError
        For fewer numbers than parameters, observations at one time only, times that do not
        increase, wrong shapes, zero vectors, and errors that are not positive.
    """
    by_kind = {"attitudes": attitudes, "rates": rates, "vectors": vectors, "models": models}
    sets = observation_sets(times, by_kind, sigma)
    problem, known = posed(sets, inertia, moments, sigma, engine)
    count = inputs.whole("starts", starts, MOST_STARTS)
    limit = None if fastest is None else _positive("fastest", fastest)
    range_ = _positive("delta_chi2", delta_chi2)
    if loss not in LOSSES:
        raise unknown("loss", loss, LOSSES)
    size = None if scale is None else _positive("scale", scale)
    again = partial(search, known=known, count=count, fastest=limit, within=range_, loss=loss)
    if guess is None:
        minima = again(problem, progress=progress)
    else:
        problem, start = started(problem, guess, known)
        minima = [minimise(problem, start, loss)]
    best, *others = minima
    spin = _spin(problem, best, loss) if problem.parameters.shape else None
    chosen = spin or best
    found = solved(problem, chosen.point, size)
    return Fit(
        found.motion,
        found.point,
        found.chi2,
        problem=problem,
        loss=loss,
        delta_chi2=range_,
        scaled=size is not None or problem.prior is not None or not problem.parameters.shape,
        converged=chosen.converged,
        reason=chosen.reason,
        spinning=spin is not None,
        alternatives=tuple(solved(problem, x.point, size) for x in others),
        search=again,
    )


def _positive(name: str, value: float) -> float:
    found = float(inputs.exact(name, value))
    if found <= 0:
        raise InputError(name, value, "must be above zero")
    return found


def started(
    problem: Problem, guess: TorqueFreeMotion, known: np.ndarray | None
) -> tuple[Problem, Point]:
    """Convert a guessed motion to its state and inertia at the epoch of a fit problem.

    Return the problem and the point.

    The epoch becomes t = 0 if the guess has no state at the epoch.
    """
    moments, omega, attitude = (np.array(x, float) for x in guess.exact.values())
    moments = moments if known is None else known
    start = Point(attitude / np.linalg.norm(attitude), omega, moments, IDENTITY)
    q, omega = states(start, np.array([problem.epoch]), problem.engine)
    if not (np.isfinite(q).all() and np.isfinite(omega).all()):
        return replace(problem, epoch=0.0), start
    return problem, replace(start, attitude=q[0], omega=omega[0])


def _spin(problem: Problem, best: Minimum, loss: str) -> Minimum | None:
    """Return the best-fitting spin about a principal axis if it explains the observations.

    Return None otherwise.

    In this case the observations contain no information on the ratios of inertia: small motions
    that a fit finds beside a spin are those of the errors, and their periods mean nothing.  A spin
    lacks the parameters of the shape and the rates across the axis.  What errors gain by these is
    chi2 of so many degrees of freedom, at the best of as many periods as are resolved in the span
    of the observations.
    """
    if not np.isfinite(best.cost):
        return None
    names = problem.parameters.names
    axis = int(np.argmax(np.abs(best.point.omega)))
    across = [3 + k for k in range(3) if k != axis]
    kept = [k for k, x in enumerate(names) if not x.startswith("shape") and k not in across]
    start = _pure_spin(axis, best.point, problem.parameters.axes)
    start = aligned(problem, start.repeated())[0]
    found = minimise(problem, start, loss, np.eye(len(names))[:, kept])
    free = len(names) - len(kept) - (2 if problem.parameters.axes else 0)
    trials = max(1.0, float(np.linalg.norm(start.omega)) * problem.span / np.pi)
    gain = float(chi2_law.isf(_CHANCE / trials, max(free, 1)))
    return found if found.converged and found.cost <= best.cost + gain else None


def _pure_spin(axis: int, point: Point, anywhere: bool) -> Point:
    """Return the principal-axis spin that is nearest to a motion.

    anywhere: turn the axis to the rates.
    """
    omega = np.where(np.arange(3) == axis, point.omega, 0.0)
    if not anywhere:
        return replace(point, omega=omega)
    size = np.linalg.norm(point.omega)
    omega *= size / max(np.linalg.norm(omega), 1e-300)
    # The shortest rotation from one to the other, whose cosine is at least 1/sqrt(3).
    across = np.concatenate([[size**2 + omega @ point.omega], np.cross(omega, point.omega)])
    turn = across / max(np.linalg.norm(across), 1e-300)
    mount = product(point.mount, turn if size else IDENTITY)
    return replace(point, omega=omega, mount=mount)


def solved(problem: Problem, point: Point, size: float | None) -> Alternative:
    """Return the motion and the chi2 of a point in parameter space.

    size: the largest moment, where neither the observations nor a prior determine it.
    """
    if problem.parameters.shape and problem.prior is None:
        point = replace(point, moments=point.moments / point.moments.max() * (size or 1.0))
    residuals = problem.residuals(point)
    chi2 = float(np.sum(residuals**2)) if np.isfinite(residuals).all() else np.inf
    return Alternative(_from_zero(problem, point, residuals), point, chi2)


def _from_zero(problem: Problem, point: Point, residuals: np.ndarray) -> TorqueFreeMotion:
    """Convert a point in parameter space to a motion described by its state at t = 0.

    The state has as many digits as the observations resolve.

    Next to a separatrix a state at t = 0 in doubles is another motion at the observations.
    """
    amid = motion(point)
    if problem.epoch == 0 or not np.isfinite(residuals).all():
        return amid
    found = None
    try:
        q, omega = amid(-problem.epoch)
        found = amid.replace(omega0=omega.tolist(), attitude0=q.tolist())
    except InputError:
        pass  # doubles do not reach t = 0
    for digits in _DIGITS:
        try:
            missed = problem.state_residuals(point, *found(problem.times)) if found else np.inf
            if np.max(np.abs(missed - residuals)) < _SLIGHT:
                break
        except InputError:
            pass
        q, omega = amid.precise(-problem.epoch, digits)
        found = amid.replace(omega0=tuple(omega), attitude0=tuple(q))
    return found or amid
