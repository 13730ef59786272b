"""The public function `integrate`, which integrates the motion of bodies under a torque."""

import inspect

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _engines as engines
from rigidsym import _inputs as inputs
from rigidsym._engines import batches
from rigidsym.errors import InputError
from rigidsym.splitting import _methods as methods
from rigidsym.splitting._adaptive import chosen
from rigidsym.splitting._stepping import Bodies, Splitting, State
from rigidsym.splitting._torques import Torque
from rigidsym.splitting._trajectory import Mesh, Trajectory, run

TOLERANCE = 1e-6


def integrate(
    inertia: ArrayLike,
    q0: ArrayLike,
    omega0: ArrayLike,
    torque: Torque,
    times: ArrayLike,
    *,
    step: float | None,
    method: str = "saba2",
    tolerance: float | None = None,
    discontinuities: ArrayLike = (),
    rate_dependent: bool = False,
    engine: str = engines.DEFAULT,
    allow_nonphysical: bool = False,
) -> Trajectory:
    """Integrate the motion of rigid bodies under a torque.

    Parameters
    ----------
    inertia : (..., 3)
        Principal moments; leading shapes of bodies broadcast.  Units, conventions and engines are
        those of `TorqueFreeMotion`.
    q0 : (..., 4)
        Attitudes at times[0].
    omega0 : (..., 3)
        Rates at times[0].
    torque : function
        Torque in body axes, N m, (..., 3), of t (s), q (..., 4) and omega (..., 3); common ones are
        in `rigidsym.splitting`.  In C those, except `Potential`, run without Python in between.
    times : (N,)
        Times, s, increasing.
    step : float or None
        Constant step, s, counted from times[0].  With None, steps are chosen so that the error is
        below `tolerance`; they are shorter where the torque requires it.
    method : {"strang", "saba2", "aba84", "bm4", "bm6"}
        Splitting into free motions, which are exact, and kicks by the torque; the coefficients,
        orders and sources are in `rigidsym.splitting.METHODS`.  Only the torque causes errors, so
        that a weak torque allows steps of a radian.  All methods are symplectic and symmetric; with
        a torque from a potential the energy does not drift.
    tolerance : float
        Largest error at any of `times` for step=None, 1e-6 by default: a rotation, rad, or a change
        of rates as a part of the body's largest.  It is estimated from runs with steps halved, by
        the observed order of convergence.  The torque is probed at a thousand times or more, so
        that jumps, kinks and pulses of 1/200 of the span or more are found; narrower pulses may be
        missed.
    discontinuities : (D,)
        Times at which steps begin anew, s; those outside of `times` are ignored.
    rate_dependent : bool
        Must be True for a torque that depends on omega; a kick then takes four evaluations.
    engine : str
        As for `TorqueFreeMotion`.
    allow_nonphysical : bool
        Accept moments of bodies that cannot exist.

    Returns
    -------
    Trajectory
        `q, omega = integrate(...)` has (..., N, 4) and (..., N, 3); it can be called with other
        times.

    Raises
    ------
    InputError
        For arguments that are refused, and a torque that is not finite.
    PrecisionError
        With the reason, where no step reaches the tolerance.

    An exception that stops an integration, Ctrl-C included, has the states until then as its
    attribute `trajectory`.

    Examples
    --------
    >>> from rigidsym.splitting import GravityGradient, KeplerOrbit
    >>> inertia = (0.0109, 0.04, 0.0506)
    >>> torque = GravityGradient(inertia, KeplerOrbit(mu=3.986004418e14, periapsis=6.778e6))
    >>> times = np.linspace(0, 500, 6)
    >>> q, omega = integrate(inertia, (1, 0, 0, 0), (0.05, 0.03, -0.02), torque, times, step=20)
    >>> q.shape, omega.shape
    ((6, 4), (6, 3))
    """
    bodies, start = _started(inertia, q0, omega0, engine, allow_nonphysical)
    if not callable(torque):
        raise InputError("torque", repr(torque), "must be a function of t, q and omega")
    try:
        found = inspect.signature(torque)
    except ValueError:
        found = None  # functions in C may have none
    try:
        _ = found and found.bind(0.0, q0, omega0)
    except TypeError:
        rule = "must be a function of t, q and omega"
        raise InputError("torque", f"a function of {found}", rule) from None
    with_rates = inputs.is_true("rate_dependent", rate_dependent)
    splitting = Splitting(bodies, torque, methods.checked(method), with_rates)
    at = batches.array("times", times)
    if at.ndim != 1 or not at.size:
        rule = "must be one-dimensional, with one time at least"
        raise InputError("times", f"an array of shape {at.shape}", rule)
    for k in np.flatnonzero(np.diff(at) <= 0)[:1] + 1:
        raise InputError(f"times[{k}]", at[k], f"must be after times[{k - 1}] = {at[k - 1]}")
    if not with_rates:
        _refuse_rate_dependence(splitting, start, float(at[0]))
    breaks = batches.array("discontinuities", discontinuities)
    if breaks.ndim != 1:
        rule = "must be one-dimensional"
        raise InputError("discontinuities", f"an array of shape {breaks.shape}", rule)
    stops = np.unique([*at[[0, -1]], *breaks[(breaks > at[0]) & (breaks < at[-1])]])
    if step is None:
        goal = TOLERANCE if tolerance is None else _positive("tolerance", tolerance)
        return chosen(splitting, start, at, goal, stops)
    if tolerance is not None:
        raise InputError("tolerance", tolerance, "is for step=None, and a step is given")
    size, spacing = _positive("step", step), float(np.spacing(np.max(np.abs(at))))
    if size < spacing:
        rule = f"is lost beside times that are {spacing:g} s apart as doubles"
        raise InputError("step", step, rule)
    edges = stops[: max(1, stops.size - 1)].tolist()
    return run(splitting, start, at, Mesh(edges, [size] * len(edges)))


def _started(
    inertia: ArrayLike, q0: ArrayLike, omega0: ArrayLike, engine: str, allow_nonphysical: bool
) -> tuple[Bodies, State]:
    """Check bodies and their initial states, and broadcast their leading shapes."""
    moments = batches.array("inertia", inertia, last=(3,))
    q, omega = batches.array("q0", q0, last=(4,)), batches.array("omega0", omega0, last=(3,))
    moments = batches.possible(moments, inputs.is_true("allow_nonphysical", allow_nonphysical))
    lengths = np.linalg.norm(q, axis=-1)
    for place in np.argwhere(lengths == 0)[:1]:
        field = f"q0[{', '.join(map(str, place))}]" if place.size else "q0"
        raise InputError(field, q[tuple(place)], "an attitude must not be zero")
    try:
        shape = np.broadcast_shapes(*(x.shape[:-1] for x in (moments, q, omega)))
    except ValueError:
        shapes = f"shapes inertia {moments.shape}, q0 {q.shape}, omega0 {omega.shape}"
        raise InputError("omega0", shapes, "leading shapes must broadcast") from None
    start = np.broadcast_to(q / lengths[..., None], (*shape, 4))
    bodies = Bodies(moments, engines.resolved(engine))
    return bodies, State(start, np.broadcast_to(omega, (*shape, 3)))


def _positive(field: str, value: float) -> float:
    found = batches.number(field, value)
    if found <= 0:
        raise InputError(field, value, "must be positive")
    return found


def _refuse_rate_dependence(splitting: Splitting, state: State, t: float) -> None:
    """Raise InputError if the torque at the initial states depends on the rates.

    Kicks would then be of the first order only.
    """
    other = -0.5 * state.omega + 0.25 * np.max(np.abs(state.omega), initial=1e-3)
    pushed = splitting.acceleration(t, state.q, state.omega)
    if not np.array_equal(pushed, splitting.acceleration(t, state.q, other)):
        raise InputError("torque", f"at {t:g} s", "depends on omega: say rate_dependent=True")
