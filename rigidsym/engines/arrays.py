"""Arrays as engines take and give them: times, batches of bodies, and outputs."""

import math
from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines.protocol import EngineError, Outputs, Sensitivities, States
from rigidsym.generated import torque_free

BAD_TIMES = "times must be one finite number or a one-dimensional array of them"
# What states change by: the columns of sensitivities, three for each but the time.
COLUMNS = torque_free.COLUMNS
# Doubles of the pieces of memory that are kept for the next sensitivities: at 100 000 times.
_LEAST, _MOST = 1 << 19, 60 * 100_000
_kept: list[np.ndarray] = []
SIZES = {"inertia": 3, "differences": 3, "omega0": 3, "attitude0": 4}
ERRORS = ("raise", "nan")
_DOUBLE = np.dtype(np.float64)


def times(t: ArrayLike) -> np.ndarray:
    """A float64 array in one piece of memory, of no or one dimension."""
    array = np.asarray(t, float)
    if array.ndim > 1:
        raise EngineError("t", BAD_TIMES)
    return in_one_piece(array)


def is_lenient(errors: str) -> bool:
    """Whether states of NaN stand for what is refused."""
    if errors not in ERRORS:
        raise EngineError("errors", "must be 'raise' or 'nan'")
    return errors == "nan"


def count(value: int) -> int:
    """How many samples a grid has."""
    if value < 0:
        raise EngineError("count", f"must not be negative, {value} is")
    return value


def named(inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> dict[str, np.ndarray]:
    """The arrays that say which bodies, by name."""
    given = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
    return {name: np.asarray(value, float) for name, value in given.items()}


def in_one_piece(array: np.ndarray) -> np.ndarray:
    """The array or a copy, contiguous and aligned as C has them."""
    whole = array.flags.c_contiguous and array.flags.aligned
    return array if whole else array.copy(order="C")


def batch(given: Mapping[str, np.ndarray], t: np.ndarray) -> tuple[int, ...]:
    """The shape that the leading shapes of inertia, omega0, attitude0 and t broadcast to."""
    for name, array in given.items():
        if array.ndim < 1 or array.shape[-1] != SIZES[name]:
            rule = f"shape {array.shape}: the last axis must have {SIZES[name]} numbers"
            raise EngineError(name, rule)
    inertia, omega0, attitude0 = (array.shape[:-1] for array in given.values())
    try:
        bodies = np.broadcast_shapes(inertia, omega0, attitude0)
    except ValueError:
        rule = f"leading shapes {omega0} and {attitude0} must broadcast with {inertia} of inertia"
        raise EngineError("omega0, attitude0", rule) from None
    try:
        return np.broadcast_shapes(bodies, t.shape[:-1])
    except ValueError:
        rule = f"the leading shape must broadcast with {bodies} of the bodies"
        raise EngineError("t", rule) from None


def rows(array: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """The vectors of a batch one below the other, (B, 3) or (B, 4)."""
    size = array.shape[-1]
    return in_one_piece(np.broadcast_to(array, (*shape, size)).reshape(math.prod(shape), size))


def row_or_rows(array: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """One row for all bodies of a batch, (1, N), or one for each, (B, N)."""
    if math.prod(array.shape[:-1]) == 1:
        return in_one_piece(array.reshape(1, array.size))
    return rows(array, shape)


def outputs(
    out: Outputs,
    shape: tuple[int, ...],
    *inputs: object,
    own: tuple[object, object] = (None, None),
) -> States:
    """The caller's arrays, once they have been checked, or new ones: (*shape, 4), (*shape, 3).

    They share no memory with each other or an input that is an array, but may be the two of `own`,
    each in its place.
    """
    if out is None:
        return np.empty((*shape, 4)), np.empty((*shape, 3))
    if not isinstance(out, (tuple, list)) or len(out) != 2:
        raise EngineError("out", "must be a pair of arrays (q, omega)")
    q, omega = out
    _check_output("q", q, (*shape, 4))
    _check_output("omega", omega, (*shape, 3))
    read = []
    for x in inputs:
        if type(x) is np.ndarray and not (x is q is own[0] or x is omega is own[1]):
            read.append(x)
    if not _are_apart(q, omega, read):
        pairs = ((q, omega), *((x, y) for x in (q, omega) for y in read))
        if any(np.may_share_memory(x, y) for x, y in pairs):
            raise EngineError("out", "q and omega must not overlap each other or the inputs")
    return q, omega


def _are_apart(q: np.ndarray, omega: np.ndarray, read: list[np.ndarray]) -> bool:
    """Return True if q, omega and what is read are parts of different arrays.

    False does not mean that they overlap.
    """
    first = second = None
    for x in (q, omega, *read):
        # NumPy finds the array that has the memory through all views.
        whole = x if x.base is None else x.base
        if whole is first or whole is second:
            return False
        if type(whole) is not np.ndarray or not whole.flags.owndata:
            return False
        if x is q:
            first = whole
        elif x is omega:
            second = whole
    return True


def columns(names: Iterable[str] | None) -> tuple[str, ...]:
    """The columns that are asked for, in the order of COLUMNS; all where None."""
    if names is None or names is COLUMNS:
        return COLUMNS
    try:
        given = (names,) if isinstance(names, str) else tuple(names)
    except TypeError:
        given = ()
    # Of what is no string no comparison is made: that of an array is one.
    found = tuple(name for name in COLUMNS if name in [x for x in given if isinstance(x, str)])
    if not given or len(found) != len(given):
        raise EngineError("columns", f"must be some of {', '.join(COLUMNS)}, each once")
    return found


def sensitivity_shapes(asked: tuple[str, ...]) -> tuple[tuple[int, ...], ...]:
    """The last axes of states and what they change by, of these columns."""
    by_t = (3 if "t" in asked else 0,)
    changes = (3, 3 * (len(asked) - ("t" in asked)))
    return (4,), (3,), changes, changes, by_t, by_t


def sensitivities(shape: tuple[int, ...], asked: tuple[str, ...] = COLUMNS) -> Sensitivities:
    """New arrays for states of this shape and what they change by."""
    count, ends = math.prod(shape), sensitivity_shapes(asked)
    piece, begin, changes = _memory(count * sum(map(math.prod, ends[2:]))), 0, []
    for last in ends[2:]:
        size = count * math.prod(last)
        changes.append(piece[begin : begin + size].reshape(*shape, *last))
        begin += size
    attitude, rates, attitude_t, rates_t = changes
    q, omega = (np.empty((*shape, *last)) for last in ends[:2])
    return q, omega, attitude, rates, attitude_t, rates_t


class _Loan:
    """A block of memory that returns to the cache when no array refers to it."""

    def __init__(self, room: np.ndarray) -> None:
        self.room, self.__array_interface__ = room, room.__array_interface__

    def __del__(self, kept: list[np.ndarray] = _kept) -> None:
        kept[:] = [self.room]


def _memory(size: int) -> np.ndarray:
    """Return an uninitialised array of `size` doubles, from the cache if possible.

    The system clears memory before it gives it, which takes as long as to compute what it is for:
    the last piece of up to 48 MB is kept for the next call.  Of pieces below 4 MB allocators keep
    enough.
    """
    if not _LEAST <= size <= _MOST:
        return np.empty(size)
    try:
        room = _kept.pop()  # in one step, so that no two threads are given the same memory
    except IndexError:
        room = np.empty(size)
    if not size <= room.size <= 2 * size:
        room = np.empty(size)
    return np.asarray(_Loan(room))[:size]


def _check_output(name: str, array: object, shape: tuple[int, ...]) -> None:
    if type(array) is not np.ndarray:
        raise EngineError("out", f"{name} is a {type(array).__name__}: must be an array")
    if array.dtype != _DOUBLE or array.shape != shape:
        found = f"{array.dtype} of shape {array.shape}"
        raise EngineError("out", f"{name} is {found}: must be float64 of shape {shape}")
    if not array.flags.carray:
        raise EngineError("out", f"{name} must be C-contiguous, aligned and writeable")
