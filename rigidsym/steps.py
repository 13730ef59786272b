"""The public function `step`, which advances torque-free bodies by one time step."""

import math

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _engines as engines
from rigidsym import _layers as layers
from rigidsym._engines import EngineError, arrays, batches, blocks
from rigidsym.errors import InputError

_SIZES = {"inertia": 3, "q": 4, "omega": 3}


def step(
    inertia: ArrayLike,
    q: ArrayLike,
    omega: ArrayLike,
    dt: ArrayLike,
    *,
    engine: str = engines.DEFAULT,
    out: tuple[np.ndarray, np.ndarray] | None = None,
    allow_nonphysical: bool = False,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the states of bodies after dt seconds of torque-free motion.

    A step starts from any state and costs the same in every regime.  Leading shapes broadcast.
    Arrays of xarray and Dask are taken as `propagate` does.  For one body, tuples, lists and arrays
    of floats are fastest; the constants of the last bodies are cached for the next call.

    Parameters
    ----------
    inertia : array_like (..., 3)
        Principal moments, kg m^2.
    q : array_like (..., 4) or Rotation
        Attitude quaternions, scalar first, body to inertial, of any length but zero.
    omega : array_like (..., 3)
        Body rates, rad/s.
    dt : number or array_like (...)
        Time, s, forwards or back; |omega dt| may be up to 8 rad.
    engine : {"auto", "c", "c-portable", "numpy"}
        As for `TorqueFreeMotion`.
    out : pair of arrays
        Float64 arrays of the shapes returned, to fill; (q, omega) themselves for a step in place.
        Memory maps and Zarr arrays are written block by block.
    allow_nonphysical : bool
        Accept moments that no body has.

    Returns
    -------
    q : array (..., 4)
        Unit quaternions, continuous in the double cover.  Up to |omega dt| = 2 pi rotation angles
        have errors below 1e-15 rad.
    omega : array (..., 3)
        Body rates, rad/s, with errors below 1e-15 of |omega|.

    Raises
    ------
    InputError
        Names the first body that is refused.

    Examples
    --------
    >>> q, omega = step((0.0109, 0.04, 0.0506), (1, 0, 0, 0), (0.05, 0.03, -0.02), 0.5)
    >>> q.shape, omega.shape
    ((4,), (3,))
    """
    if (one := _one(inertia, q, omega, dt, engine, out)) is not None:
        return one
    given = {"inertia": inertia, "q": q, "omega": omega, "dt": dt}
    if layers.is_layered(*given.values()):
        return layers.called(
            step, given, engine=engine, out=out, allow_nonphysical=allow_nonphysical
        )
    doubles = {name: batches.array(name, value) for name, value in given.items()}
    doubles["inertia"] = batches.possible(doubles["inertia"], allow_nonphysical)
    shape, stepper = _shape(doubles), engines.stepper(engine)
    try:
        if out is not None and blocks.are_streams(out):

            def compute(part: blocks.Part, after: engines.States) -> None:
                leading = {n: arrays.along(part, _bodies(n, x)) for n, x in doubles.items()}
                _advance(stepper, {n: x[leading[n]] for n, x in doubles.items()}, after)

            read = [x for x in given.values() if x is not out[0] and x is not out[1]]
            return blocks.fill(out, shape, read, compute, len(shape))
        own = doubles["q"], doubles["omega"]
        after = arrays.outputs(out, shape, *doubles.values(), own=own)
        _advance(stepper, doubles, after)
    except EngineError as error:
        raise batches.input_error(error, doubles) from None
    return after


def _advance(stepper: engines.Stepper, given: dict[str, np.ndarray], after: engines.States) -> None:
    """Compute the states of bodies after a step, and write them to arrays."""
    shape = after[0].shape[:-1]
    count = math.prod(shape)
    if not count:
        return
    moments = arrays.row_or_rows(given["inertia"], shape)
    q, omega = (arrays.rows(given[name], shape) for name in ("q", "omega"))
    times = arrays.row_or_rows(given["dt"][..., None], shape).reshape(-1)
    flat = after[0].reshape(count, 4), after[1].reshape(count, 3)
    stepper.step(moments, q, omega, times, flat)


def _one(
    inertia: ArrayLike,
    q: ArrayLike,
    omega: ArrayLike,
    dt: ArrayLike,
    engine: str,
    out: tuple[np.ndarray, np.ndarray] | None,
) -> tuple[np.ndarray, np.ndarray] | None:
    """Advance one body by a time step, if its inputs are plain finite numbers.

    Returns None for all other input, which `step` then checks in full.
    """
    moments, start = batches.moments(inertia), batches.floats(q, 4)
    rates = batches.floats(omega, 3)
    times = (dt,) if type(dt) is float else batches.floats((dt,), 1)
    if moments is None or start is None or rates is None or times is None:
        return None
    if out is not None:
        try:
            out = arrays.outputs(out, (), inertia, q, omega, own=(q, omega))
        except InputError:
            return None
    return engines.stepper(engine).one(moments, start, rates, times[0], out)


def _shape(given: dict[str, np.ndarray]) -> tuple[int, ...]:
    """Return the shape to which the leading shapes of arrays broadcast.

    Raises InputError where they do not fit.
    """
    shape: tuple[int, ...] = ()
    for name, array in given.items():
        size, found = _SIZES.get(name), f"an array of shape {array.shape}"
        if size and array.shape[-1:] != (size,):
            raise InputError(name, found, f"the last axis must have {size} numbers")
        own = _bodies(name, array)
        try:
            shape = np.broadcast_shapes(shape, own)
        except ValueError:
            rule = f"leading shape {own} must broadcast with {shape} of what comes before"
            raise InputError(name, found, rule) from None
    return shape


def _bodies(name: str, array: np.ndarray) -> tuple[int, ...]:
    """Return the shape of an input over its bodies."""
    return array.shape[:-1] if name in _SIZES else array.shape
