"""Batches: arrays of doubles as users give them, and the bodies in them that cannot exist."""

import math
from typing import NoReturn

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import inputs
from rigidsym.errors import InputError, written

# Bodies at a time, so that memory does not grow with their number.
_BLOCK = 1 << 14


def array(name: str, value: ArrayLike, lenient: bool = False) -> np.ndarray:
    """The doubles of an array; raises InputError for the first number that is masked or, unless
    `lenient`, not finite."""
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
    # The extremes tell, without another array of that size; NaN comes through both.
    if doubles.size and not lenient and not _are_finite(doubles):
        _refuse(name, doubles, tuple(np.argwhere(~np.isfinite(doubles))[0]), "must be finite")
    return doubles


def floats(value: object, length: int) -> tuple[float, ...] | None:
    """Return one vector of finite doubles as Python's floats; None for what needs a closer look."""
    listed = value.tolist() if type(value) is np.ndarray else value
    if not isinstance(listed, (tuple, list)) or len(listed) != length:
        return None
    for x in listed:
        if type(x) is not float:
            if not all(map(_is_double, listed)):
                return None
            listed = [float(x) for x in listed]
            break
    return tuple(listed) if math.isfinite(sum(listed)) else None


def _is_double(x: object) -> bool:
    """Whether it is a float, or a whole number that is a double exactly."""
    return isinstance(x, float) or (type(x) is int and -(2**53) <= x <= 2**53)


def moments(value: object) -> tuple[float, ...] | None:
    """Return the moments of one body that can exist for certain, as `floats` does.

    Where a rounded sum is above a double, so is the exact one; and three moments that are each
    below the sum of the others are positive.
    """
    found = floats(value, 3)
    if found is None:
        return None
    a, b, c = found
    return found if a + b > c and b + c > a and c + a > b else None


def _are_finite(doubles: np.ndarray) -> bool:
    return math.isfinite(doubles.min()) and math.isfinite(doubles.max())


def possible(inertia: np.ndarray, allow_nonphysical: bool, lenient: bool = False) -> np.ndarray:
    """The moments (..., 3) of bodies that can exist; raises InputError for the first that cannot.

    Where `lenient`, a copy in which those have moments that are no numbers.
    """
    if not inertia.ndim or inertia.shape[-1] != 3:
        return inertia
    rows = inertia.reshape(-1, 3)
    refused = np.zeros(len(rows), bool)
    for first in range(0, len(rows), _BLOCK):
        some = slice(first, first + _BLOCK)
        doubtful = first + _doubtful(rows[some])
        if doubtful.size:
            refused[doubtful] = _are_refused(rows[doubtful], allow_nonphysical)
    if lenient and refused.any():
        return np.where(refused.reshape(*inertia.shape[:-1], 1), np.nan, inertia)
    for body in np.flatnonzero(refused)[:1]:
        _refuse_body(inertia, np.unravel_index(body, inertia.shape[:-1]))
    return inertia


@np.errstate(over="ignore", invalid="ignore")
def _doubtful(inertia: np.ndarray) -> np.ndarray:
    """Return the indices of rows of (B, 3) moments that sums of doubles leave in doubt."""
    a, b, c = inertia.T
    return np.flatnonzero(~((a + b > c) & (b + c > a) & (c + a > b)))


def _are_refused(inertia: np.ndarray, allow_nonphysical: bool) -> np.ndarray:
    """Which of (B, 3) moments no body can have."""
    refused = np.any(inertia <= 0, axis=-1)
    return refused if allow_nonphysical else refused | _are_impossible(inertia)


def _refuse_body(inertia: np.ndarray, place: tuple[np.intp, ...]) -> NoReturn:
    for axis in np.flatnonzero(inertia[place] <= 0)[:1]:
        _refuse("inertia", inertia, (*place, axis), "principal moments must be positive")
    _refuse("inertia", inertia, place, inputs.NO_BODY)


def _are_impossible(inertia: np.ndarray) -> np.ndarray:
    """Which of (B, 3) positive moments `inputs.can_exist` refuses, without rounding.

    With largest moments between 1 and 2 every sum is a double and its error, which decide.
    """
    exponent = np.frexp(np.max(inertia, axis=-1, keepdims=True))[1]
    low, middle, high = np.sort(np.ldexp(inertia, 1 - exponent), axis=-1).T
    total, rest = _two_sum(low, middle)
    beyond, more = _two_sum(high - total, -rest)
    allowed = float(inputs.ROUNDING) * low
    return (high > total) & ((beyond > allowed) | ((beyond == allowed) & (more > 0)))


def _two_sum(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """a + b exactly, as a rounded sum and its error (Knuth)."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def _refuse(name: str, values: np.ndarray, place: tuple[np.intp, ...], rule: str) -> NoReturn:
    index = ", ".join(map(str, place))
    raise InputError(f"{name}[{index}]" if index else name, values[tuple(place)], rule)
