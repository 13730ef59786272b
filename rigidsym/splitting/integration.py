"""Motion under a torque, by splitting methods on the exact free motion."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import engines, inputs
from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.splitting import methods
from rigidsym.splitting.adaptive import chosen
from rigidsym.splitting.running import run
from rigidsym.splitting.state import State
from rigidsym.splitting.stepping import Bodies, Splitting
from rigidsym.splitting.torques import Torque
from rigidsym.splitting.trajectory import Mesh, Trajectory

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
    engine: str = "numpy",
    allow_nonphysical: bool = False,
) -> Trajectory:
    """Bodies that a torque pushes: states at times (N,), from those at times[0].

    inertia (..., 3), q0 (..., 4), omega0 (..., 3): leading shapes broadcast; units, conventions
    and engines are those of `TorqueFreeMotion`.  torque: a function of t (s), q (..., 4) and omega
    (..., 3) that returns N m in body axes, (..., 3); those in `rigidsym.splitting` are ready made.
    One that depends on omega needs `rate_dependent=True`, and four evaluations a kick.  With
    engine="c" runs under the ready-made ones, but for `Potential`, go without Python in between.

    method: "strang", "saba2", "aba84", "bm4" or "bm6" (`rigidsym.splitting.METHODS` has their
    coefficients, orders and sources): free motions, which are exact, and kicks by the torque in
    turn.  So errors are those of the torque alone: a weak one bears steps of a radian.  All are
    symplectic and symmetric; with a torque from a potential the energy does not drift.

    step: s, the same throughout, counted from times[0].  None chooses steps, shorter where the
    torque asks for it, until the error is below `tolerance`, 1e-6 by default: the largest rotation,
    rad, or change of rates as a part of the body's largest, at any of `times`.  The error is
    estimated from runs with steps halved, by the order of convergence that is observed.  The torque
    is probed at a thousand times or more, so that jumps, kinks and pulses of 1/200 of the span or
    more are found; narrower pulses may be missed.  discontinuities: (D,), s, times at which steps
    begin anew; those outside of `times` are ignored.

    Returns a `Trajectory`: `q, omega = integrate(...)` has (..., N, 4) and (..., N, 3), and it can
    be called with other times.  Whatever stops an integration, Ctrl-C or a torque that is not
    finite, has the states until then as the exception's attribute `trajectory`.  Raises InputError,
    and PrecisionError with the reason where no step reaches the tolerance.

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
    with_rates = inputs.is_true("rate_dependent", rate_dependent)
    splitting = Splitting(bodies, torque, methods.checked(method), with_rates)
    at = _times(times)
    if not with_rates:
        _refuse_rate_dependence(splitting, start, float(at[0]))
    stops = _stops(discontinuities, at)
    if step is None:
        goal = TOLERANCE if tolerance is None else _positive("tolerance", tolerance)
        return chosen(splitting, start, at, goal, stops)
    if tolerance is not None:
        raise InputError("tolerance", tolerance, "is for step=None, and a step is given")
    edges = stops[: max(1, stops.size - 1)].tolist()
    return run(splitting, start, at, Mesh(edges, [_step(step, at)] * len(edges)))


def _started(
    inertia: ArrayLike, q0: ArrayLike, omega0: ArrayLike, engine: str, allow_nonphysical: bool
) -> tuple[Bodies, State]:
    """Bodies that can exist and their states, all of one leading shape."""
    sizes = {"inertia": 3, "q0": 4, "omega0": 3}
    arrays = dict(zip(sizes, (inertia, q0, omega0), strict=True))
    given = {name: batches.array(name, value) for name, value in arrays.items()}
    for name, size in sizes.items():
        if given[name].shape[-1:] != (size,):
            rule = f"must be (..., {size})"
            raise InputError(name, f"an array of shape {given[name].shape}", rule)
    moments = batches.possible(
        given["inertia"], inputs.is_true("allow_nonphysical", allow_nonphysical)
    )
    lengths = np.linalg.norm(given["q0"], axis=-1)
    for place in np.argwhere(lengths == 0)[:1]:
        field = f"q0[{', '.join(map(str, place))}]" if place.size else "q0"
        raise InputError(field, given["q0"][tuple(place)], "an attitude must not be zero")
    shape = _common_shape(given)
    q, omega = given["q0"] / lengths[..., None], given["omega0"]
    bodies = Bodies(moments, engines.checked(engine))
    return bodies, State(np.broadcast_to(q, (*shape, 4)), np.broadcast_to(omega, (*shape, 3)))


def _common_shape(given: Mapping[str, np.ndarray]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(array.shape[:-1] for array in given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items())
        raise InputError("omega0", f"shapes {shapes}", "leading shapes must broadcast") from None


def _times(times: ArrayLike) -> np.ndarray:
    array = batches.array("times", times)
    if array.ndim != 1 or not array.size:
        rule = "must be one-dimensional, with one time at least"
        raise InputError("times", f"an array of shape {array.shape}", rule)
    for k in np.flatnonzero(np.diff(array) <= 0)[:1] + 1:
        raise InputError(f"times[{k}]", array[k], f"must be after times[{k - 1}] = {array[k - 1]}")
    return array


def _stops(discontinuities: ArrayLike, times: np.ndarray) -> np.ndarray:
    """The first of `times`, the discontinuities before the last, and the last, s, rising."""
    array = batches.array("discontinuities", discontinuities)
    if array.ndim != 1:
        rule = "must be one-dimensional"
        raise InputError("discontinuities", f"an array of shape {array.shape}", rule)
    inside = (array > times[0]) & (array < times[-1])
    return np.unique([*times[[0, -1]], *array[inside]])


def _positive(field: str, value: float) -> float:
    array = batches.array(field, value)
    if array.ndim:
        raise InputError(field, f"an array of shape {array.shape}", "must be one number")
    if array <= 0:
        raise InputError(field, value, "must be positive")
    return float(array)


def _step(step: float, times: np.ndarray) -> float:
    size, spacing = _positive("step", step), float(np.spacing(np.max(np.abs(times))))
    if size < spacing:
        raise InputError(
            "step", step, f"is lost beside times that are {spacing:g} s apart as doubles"
        )
    return size


def _refuse_rate_dependence(splitting: Splitting, state: State, t: float) -> None:
    """Kicks would be of the first order only, so what is seen of it at the start is an error."""
    other = -0.5 * state.omega + 0.25 * np.max(np.abs(state.omega), initial=1e-3)
    pushed = splitting.acceleration(t, state.q, state.omega)
    if not np.array_equal(pushed, splitting.acceleration(t, state.q, other)):
        raise InputError("torque", f"at {t:g} s", "depends on omega: say rate_dependent=True")
