"""The motion that observations show."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.fitting.given import Given, Sigma, observations, problem
from rigidsym.fitting.local import checked_loss, local
from rigidsym.fitting.origin import solved
from rigidsym.fitting.parameters import IDENTITY, Point
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.search import search
from rigidsym.fitting.shown import Fit
from rigidsym.fitting.spin import spin
from rigidsym.fitting.states import states
from rigidsym.motion import TorqueFreeMotion

STARTS, MOST_STARTS = 2000, 1_000_000
DELTA_CHI2 = 9.0


def fit(
    times: ArrayLike | None = None,
    *,
    attitudes: Given = None,
    rates: Given = None,
    vectors: Given = None,
    models: Given = None,
    sigma: Sigma = None,
    inertia: str = "ratios",
    moments: ArrayLike | None = None,
    scale: float | None = None,
    loss: str = "linear",
    guess: TorqueFreeMotion | None = None,
    starts: int = STARTS,
    fastest: float | None = None,
    delta_chi2: float = DELTA_CHI2,
    engine: str = "c",
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Fit:
    """The free motion that observations show, its errors, and the other motions that they allow.

    Parameters
    ----------
    times : (N,)
        Of attitudes and rates that are given as arrays, s, growing.
    attitudes : (N, 4), Attitudes, or a list of them
        Quaternions, scalar first, body to inertial, of either sign.
    rates : (N, 3), Rates, or a list of them
        Along the axes of the body, rad/s.
    vectors : Directions, or a list of them
        Known in space and seen in the body, or the reverse.
    models : Modelled, or a list of them
        What a function of yours says of states.
    sigma : number, array, or a mapping by kind
        Errors of what is given as arrays: one standard deviation, (N,) of them, a covariance
        (k, k), or (N, k, k); attitudes in rad, as rotation vectors along the axes of the body.
        `sigma["moments"]`: of the moments (3,), a prior that makes their scale known.
    inertia : {"ratios", "known", "tensor"}
        What is estimated of it: two ratios of the principal moments along the axes observed;
        nothing; or ratios and where the principal axes lie.
    moments : (3,)
        Principal moments, kg m^2: known, the mean of the prior, or where to begin.
    scale : float
        The largest moment, kg m^2, where it is known; else it is the unit of the moments.
    loss : {"linear", "soft_l1", "huber", "cauchy", "arctan"}
        As of SciPy's least squares; all but the first let outliers count less.
    guess : TorqueFreeMotion
        Where to begin; there is then no search, and there are no alternatives.
    starts, fastest, delta_chi2
        How many motions a search starts from, up to which rate, rad/s, and which minima it
        keeps, by chi2 above the best.  Of many observations it looks at some first.
    engine : str
        As for `TorqueFreeMotion`.
    progress : function
        Is called with steps done and their total.

    Returns
    -------
    Fit
        Also where there is no convergence: `converged` and `reason` tell.

    Raises
    ------
    InputError
        For fewer numbers than parameters, observations at one time only, times that do not grow,
        wrong shapes, zero vectors, and errors that are none.
    """
    given = {"attitudes": attitudes, "rates": rates, "vectors": vectors, "models": models}
    sets = observations(times, given, sigma)
    posed, known = problem(sets, inertia, moments, sigma, engine)
    count = inputs.whole("starts", starts, MOST_STARTS)
    limit = None if fastest is None else _positive("fastest", fastest)
    range_ = _positive("delta_chi2", delta_chi2)
    checked_loss(loss)
    size = None if scale is None else _positive("scale", scale)
    again = partial(search, known=known, count=count, fastest=limit, within=range_, loss=loss)
    if guess is None:
        minima = again(posed, progress=progress)
    else:
        posed, start = started(posed, guess, known)
        minima = [local(posed, start, loss)]
    best, *others = minima
    only = spin(posed, best, loss) if posed.parameters.shape else None
    chosen = only or best
    found = solved(posed, chosen.point, size)
    return Fit(
        found.motion,
        found.point,
        found.chi2,
        posed,
        loss,
        range_,
        size is not None or posed.prior is not None or not posed.parameters.shape,
        chosen.converged,
        chosen.reason,
        only is not None,
        tuple(solved(posed, x.point, size) for x in others),
        again,
    )


def _positive(name: str, value: float) -> float:
    found = float(inputs.exact(name, value))
    if found <= 0:
        raise InputError(name, value, "must be above zero")
    return found


def started(
    posed: Problem, guess: TorqueFreeMotion, known: np.ndarray | None
) -> tuple[Problem, Point]:
    """The problem, and the guess at its epoch: t = 0 where the guess has no state in the midst."""
    moments, omega, attitude = (np.array(x, float) for x in guess.exact.values())
    moments = moments if known is None else known
    start = Point(attitude / np.linalg.norm(attitude), omega, moments, IDENTITY)
    q, omega = states(start, np.array([posed.epoch]), posed.engine)
    if not (np.isfinite(q).all() and np.isfinite(omega).all()):
        return replace(posed, epoch=0.0), start
    return posed, replace(start, attitude=q[0], omega=omega[0])
