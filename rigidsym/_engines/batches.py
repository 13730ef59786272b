"""Conversion of user input to checked arrays of doubles.

Errors name the wrong number.
"""

import math
import sys
from collections.abc import Mapping
from typing import Any, NoReturn

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _containers as containers
from rigidsym import _inputs as inputs
from rigidsym._engines import arrays
from rigidsym.errors import EngineError, InputError, written

# Bodies at a time, so that memory does not grow with their number.
_BLOCK = 1 << 14


def array(
    name: str, value: ArrayLike, lenient: bool = False, last: tuple[int, ...] = ()
) -> np.ndarray:
    """Convert user input to an array of doubles with given trailing axes.

    This is the way in for arrays, those of other libraries among them.  last: the sizes of the
    axes.  Raises InputError for the first number that is masked or, unless `lenient`, not finite.
    """
    value = containers.plain(name, value)
    if isinstance(value, np.ma.MaskedArray):
        for place in np.argwhere(np.ma.getmaskarray(value))[:1]:
            _refuse(name, value, tuple(place), "is masked")
    try:
        given = np.asarray(value)
        if given.dtype.kind in "bmMc" or value is None:
            raise TypeError(given.dtype)
        doubles = given.astype(float, copy=False)
    except (TypeError, ValueError, OverflowError):
        raise InputError(name, written(value, repr), "must be an array of numbers") from None
    # The extremes suffice, and take no second array of that size; NaN comes through both.
    checked = doubles.size and not lenient
    if checked and not (math.isfinite(doubles.min()) and math.isfinite(doubles.max())):
        _refuse(name, doubles, tuple(np.argwhere(~np.isfinite(doubles))[0]), "must be finite")
    if last and doubles.shape[-len(last) :] != last:
        rule = f"must be (..., {', '.join(map(str, last))})"
        raise InputError(name, f"an array of shape {doubles.shape}", rule)
    return doubles


def batch(
    inertia: ArrayLike,
    omega0: ArrayLike,
    attitude0: ArrayLike,
    t: ArrayLike,
    lenient: bool,
    degrees: bool,
    allow_nonphysical: bool,
) -> arrays.Batch:
    """Convert a user's bodies and times to a batch for engines.

    Raises InputError for the first number that is refused, unless `lenient`, and for shapes.
    """
    moments, rates = array("inertia", inertia, lenient), array("omega0", omega0, lenient)
    attitudes = array("attitude0", attitude0, lenient)
    if inputs.is_true("degrees", degrees):
        rates = np.deg2rad(rates)
    moments = possible(moments, allow_nonphysical, lenient)
    return arrays.batch(moments, rates, attitudes, array("t", t, lenient))


def times(t: ArrayLike, errors: str = "raise") -> float | np.ndarray:
    """Convert a user's times to a float or a one-dimensional array.

    Raises InputError as `array` does.
    """
    is_number = isinstance(t, float) or (isinstance(t, int) and not isinstance(t, bool))
    if is_number and abs(t) <= sys.float_info.max:
        return float(t)
    found = array("t", t, arrays.is_lenient(errors))
    if found.ndim > 1:
        raise InputError("t", f"an array of shape {found.shape}", "must be one-dimensional")
    return found


def number(name: str, value: ArrayLike) -> float:
    """Convert one finite number of user input to a float.

    Raises InputError for anything else.
    """
    found = array(name, value)
    if found.ndim:
        raise InputError(name, f"an array of shape {found.shape}", "must be one number")
    return float(found)


def floats(value: object, length: int) -> tuple[float, ...] | None:
    """Convert a vector of plain numbers to floats without full checks.

    Returns None for a vector that needs them.
    """
    if type(value) is np.ndarray and value.shape != (length,):
        return None  # before its numbers are listed, which takes long for many bodies
    listed = value.tolist() if type(value) is np.ndarray else value
    if not isinstance(listed, (tuple, list)) or len(listed) != length:
        return None
    for x in listed:
        if type(x) is not float:
            # Whole numbers up to 2^53 are doubles.
            for y in listed:
                if not (isinstance(y, float) or (type(y) is int and -(2**53) <= y <= 2**53)):
                    return None
            listed = [float(x) for x in listed]
            break
    return tuple(listed) if math.isfinite(sum(listed)) else None


def moments(value: object) -> tuple[float, ...] | None:
    """Convert plain moments of inertia to floats without full checks.

    Where a rounded sum is above a double, so is the exact sum; and three moments that are each
    below the sum of the others are positive.  Returns None for moments that need them, or that no
    body can have.
    """
    found = floats(value, 3)
    if found is None:
        return None
    a, b, c = found
    return found if a + b > c and b + c > a and c + a > b else None


def possible(inertia: np.ndarray, allow_nonphysical: bool, lenient: bool = False) -> np.ndarray:
    """Check that rigid bodies can have the given principal moments.

    Where `lenient`, return a copy in which such bodies have moments of NaN. Raises InputError for
    the first body (..., 3) that cannot exist.
    """
    if not inertia.ndim or inertia.shape[-1] != 3:
        return inertia
    rows = inertia.reshape(-1, 3)
    refused = np.zeros(len(rows), bool)
    for first in range(0, len(rows), _BLOCK):
        doubtful = first + _doubtful(rows[first : first + _BLOCK])
        if doubtful.size:
            some = rows[doubtful]
            bad = np.any(some <= 0, axis=-1)
            refused[doubtful] = bad if allow_nonphysical else bad | _are_impossible(some)
    if lenient and refused.any():
        return np.where(refused.reshape(*inertia.shape[:-1], 1), np.nan, inertia)
    for body in np.flatnonzero(refused)[:1]:
        place = np.unravel_index(body, inertia.shape[:-1])
        tensor = inertia.shape == (3, 3) and np.array_equal(inertia, inertia.T)
        step = inputs.PRINCIPAL if tensor else ""
        for axis in np.flatnonzero(inertia[place] <= 0)[:1]:
            _refuse("inertia", inertia, (*place, axis), "principal moments must be positive", step)
        _refuse("inertia", inertia, place, inputs.NO_BODY, step or inputs.ALLOW)
    return inertia


@np.errstate(over="ignore", invalid="ignore")
def _doubtful(inertia: np.ndarray) -> np.ndarray:
    """Return the indices of bodies for which rounded sums do not prove the triangle inequality."""
    a, b, c = inertia.T
    return np.flatnonzero(~((a + b > c) & (b + c > a) & (c + a > b)))


def _are_impossible(inertia: np.ndarray) -> np.ndarray:
    """Return a mask of the bodies that violate the triangle inequality, decided exactly.

    The decision is that of `inputs.can_exist`.  With largest moments between 1 and 2 every sum is a
    double and its error, which decide.
    """
    exponent = np.frexp(np.max(inertia, axis=-1, keepdims=True))[1]
    low, middle, high = np.sort(np.ldexp(inertia, 1 - exponent), axis=-1).T
    total, rest = _two_sum(low, middle)
    beyond, more = _two_sum(high - total, -rest)
    allowed = float(inputs.ROUNDING) * low
    return (high > total) & ((beyond > allowed) | ((beyond == allowed) & (more > 0)))


def _two_sum(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the rounded sum of two doubles and its rounding error (Knuth's two-sum)."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def _refuse(
    name: str, values: np.ndarray, place: tuple[np.intp, ...], rule: str, next_step: str = ""
) -> NoReturn:
    index = ", ".join(map(str, place))
    field = f"{name}[{index}]" if index else name
    raise InputError(field, values[tuple(place)], rule, next_step=next_step)


def input_error(error: EngineError, given: Mapping[str, Any]) -> InputError:
    """Convert an engine's error to an InputError with the refused value and its index.

    given: what the engine was given, by name: arrays of shape (..., k), dt (...), and others.
    """
    field, rule, body, time = error.field, error.rule, error.body, error.time
    value = given.get(field, "as given")
    is_array = isinstance(value, np.ndarray)
    own = _leading(field, value) if is_array else ()
    if body is None and (own or time is None):
        shown = f"an array of shape {value.shape}" if own else value
        return InputError(field, shown, rule, body, time)
    leading = np.broadcast_shapes(
        *(_leading(name, x) for name, x in given.items() if isinstance(x, np.ndarray))
    )
    place = tuple(map(int, np.unravel_index(body, leading))) if body is not None else ()
    index: tuple[int, ...] = ()
    if own and (own == leading or math.prod(own) > 1):
        value, index = np.broadcast_to(value, (*leading, *value.shape[len(own) :]))[place], place
    elif is_array:
        # One value for all bodies: the message says which of them it is refused for.
        value = value.reshape(value.shape[len(own) :])[()]
        if place:
            rule = f"{rule} (body {', '.join(map(str, place))})"
    if time is not None and np.ndim(value):
        value, index = value[time], (*index, time)
    named = f"{field}[{', '.join(map(str, index))}]" if index else field
    return InputError(named, value, rule, body, time)


def _leading(field: str, array: np.ndarray) -> tuple[int, ...]:
    """Return the shape of an input array over its bodies, without the axis of components.

    It has all axes but the last, or all axes of dt.
    """
    return array.shape if field == "dt" else array.shape[:-1]
