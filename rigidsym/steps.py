"""Steps of free bodies: the public function, on an engine."""

import math

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import engines
from rigidsym.engines import EngineError, arrays, batches
from rigidsym.errors import InputError

_SIZES = {"inertia": 3, "q": 4, "omega": 3}


def step(
    inertia: ArrayLike,
    q: ArrayLike,
    omega: ArrayLike,
    dt: ArrayLike,
    *,
    engine: str = "numpy",
    out: tuple[np.ndarray, np.ndarray] | None = None,
    allow_nonphysical: bool = False,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the free motion of bodies after dt (s), q (..., 4) and omega (..., 3).

    inertia (..., 3) in kg m^2 about principal axes, q (..., 4) scalar first, body to inertial, of
    any length but zero, omega (..., 3) in rad/s in body axes, dt (...) for all or one for each:
    leading shapes broadcast.  A step starts from any state and costs the same in every regime.  For
    one body, tuples, lists and arrays of floats are the quickest, and constants of the last bodies
    are kept for the next call.  |omega dt| may be up to 8 rad, forwards or back.  Up to 2 pi,
    rotation angles are right to 1e-15 rad and rates to 1e-15 of |omega|.  q is returned as a unit
    quaternion, continuous in the double cover.

    engine: `numpy`, or `c`.  out: a pair of float64 arrays of the shapes returned, to fill; (q,
    omega) themselves for a step in place.  Raises InputError, naming the first body
    that is refused.

    >>> q, omega = step((0.0109, 0.04, 0.0506), (1, 0, 0, 0), (0.05, 0.03, -0.02), 0.5)
    >>> q.shape, omega.shape
    ((4,), (3,))
    """
    if (one := _one(inertia, q, omega, dt, engine, out)) is not None:
        return one
    given = {"inertia": inertia, "q": q, "omega": omega, "dt": dt}
    doubles = {name: batches.array(name, value) for name, value in given.items()}
    doubles["inertia"] = batches.possible(doubles["inertia"], allow_nonphysical)
    shape = _shape(doubles)
    after = _outputs(out, shape, doubles)
    count = math.prod(shape)
    if not count:
        return after
    moments = arrays.row_or_rows(doubles["inertia"], shape)
    start = (arrays.rows(doubles[name], shape) for name in ("q", "omega"))
    times = arrays.row_or_rows(doubles["dt"][..., None], shape).reshape(-1)
    flat = after[0].reshape(count, 4), after[1].reshape(count, 3)
    try:
        engines.stepper(engine).step(moments, *start, times, flat)
    except EngineError as error:
        raise _refused(error, doubles, shape) from None
    return after


def _one(
    inertia: ArrayLike,
    q: ArrayLike,
    omega: ArrayLike,
    dt: ArrayLike,
    engine: str,
    out: tuple[np.ndarray, np.ndarray] | None,
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the step of one body of plain finite numbers, by the shortest way to the engine.

    None for what needs a closer look, and for what is refused, in words that are `step`'s.
    """
    moments, start = batches.moments(inertia), batches.floats(q, 4)
    rates = batches.floats(omega, 3)
    times = (dt,) if type(dt) is float else batches.floats((dt,), 1)
    if moments is None or start is None or rates is None or times is None:
        return None
    if out is not None:
        try:
            out = arrays.outputs(out, (), inertia, q, omega, own=(q, omega))
        except EngineError:
            return None
    return engines.stepper(engine).one(moments, start, rates, times[0], out)


def _shape(given: dict[str, np.ndarray]) -> tuple[int, ...]:
    """What leading shapes broadcast to; raises InputError where they do not."""
    for name, size in _SIZES.items():
        if given[name].ndim < 1 or given[name].shape[-1] != size:
            found = f"an array of shape {given[name].shape}"
            raise InputError(name, found, f"the last axis must have {size} numbers")
    leading = {name: x.shape[:-1] if name in _SIZES else x.shape for name, x in given.items()}
    shape: tuple[int, ...] = ()
    for name, own in leading.items():
        try:
            shape = np.broadcast_shapes(shape, own)
        except ValueError:
            rule = f"leading shape {own} must broadcast with {shape} of what comes before"
            raise InputError(name, f"an array of shape {given[name].shape}", rule) from None
    return shape


def _outputs(
    out: tuple[np.ndarray, np.ndarray] | None, shape: tuple[int, ...], given: dict[str, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """New arrays or the caller's, of which each may be the input that it takes the place of."""
    try:
        return arrays.outputs(out, shape, *given.values(), own=(given["q"], given["omega"]))
    except EngineError as error:
        raise InputError(error.field, "as given", error.rule) from None


def _refused(
    error: EngineError, given: dict[str, np.ndarray], shape: tuple[int, ...]
) -> InputError:
    """The error with the value, and the index of the body in a batch."""
    if error.body is None or error.field not in given:
        return InputError(error.field, "as given", error.rule)
    array, tail = given[error.field], 1 if error.field in _SIZES else 0
    own = array.shape[: array.ndim - tail]
    place = np.unravel_index(error.body, shape)
    named = ", ".join(map(str, place))
    if math.prod(own) == 1:
        # One for all bodies: which of them it is refused for.
        rule = error.rule if math.prod(shape) == 1 else f"{error.rule} (body {named})"
        return InputError(error.field, array.reshape(array.shape[len(own) :])[()], rule)
    value = np.broadcast_to(array, (*shape, *array.shape[len(own) :]))[place]
    return InputError(f"{error.field}[{named}]", value, error.rule)
