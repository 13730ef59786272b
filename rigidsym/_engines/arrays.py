"""Checks and allocation of the engines' input and output arrays."""

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.errors import EngineError, InputError
from rigidsym.generated import torque_free

States = tuple[np.ndarray, np.ndarray]
Outputs = States | None
# q (..., 4) and omega (..., 3); then the derivatives of the attitude, as a small rotation in space,
# and of the rates (..., 3, 9) by the small rotation at t = 0, the rates there and the moments; then
# both derivatives by the time (..., 3).
Sensitivities = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]

BAD_TIMES = "times must be one finite number or a one-dimensional array of them"
# The inputs by which sensitivities have columns: three for each but the time.
COLUMNS = torque_free.COLUMNS
# Doubles in the block of memory that is kept for the next sensitivities: up to 100 000 times.
_LEAST, _MOST = 1 << 19, 60 * 100_000
_kept: list[np.ndarray] = []
SIZES = {"inertia": 3, "differences": 3, "omega0": 3, "attitude0": 4}
ERRORS = ("raise", "nan")
_DOUBLE = np.dtype(np.float64)


class Batch(NamedTuple):
    """Bodies and times whose states are computed together, as arrays that broadcast.

    bodies: inertia (..., 3), omega0 (..., 3) and attitude0 (..., 4) by name.  t: (), (N,) or
    (..., N).  leading: the shape that their leading axes broadcast to.
    """

    bodies: dict[str, np.ndarray]
    t: np.ndarray
    leading: tuple[int, ...]

    @property
    def number(self) -> int:
        """The number of bodies."""
        return math.prod(self.leading)

    @property
    def shape(self) -> tuple[int, ...]:
        """The leading shape of the states.

        It consists of the bodies' leading shape and the number of times.
        """
        return *self.leading, *self.t.shape[-1:]

    @property
    def times(self) -> np.ndarray:
        """The times as a matrix with one row for all bodies or one row per body.

        Its shape is (1, N) or (B, N).
        """
        return row_or_rows(self.t, self.leading)

    def part(self, index: tuple[slice, ...]) -> "Batch":
        """Return some bodies and times, given a slice for each axis of `shape`."""
        leading, times = index[: len(self.leading)], index[len(self.leading) :]
        bodies = {name: x[along(leading, x.shape[:-1])] for name, x in self.bodies.items()}
        t = self.t[(*along(leading, self.t.shape[:-1]), *times)]
        return Batch(bodies, t, tuple(x.stop - x.start for x in leading))


def batch(inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike, t: ArrayLike) -> Batch:
    """Combine arrays of bodies and times to a batch.

    Raises InputError if their shapes do not broadcast.
    """
    given = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
    bodies = {name: np.asarray(value, float) for name, value in given.items()}
    for name, array in bodies.items():
        if array.ndim < 1 or array.shape[-1] != SIZES[name]:
            rule = f"the last axis must have {SIZES[name]} numbers"
            raise InputError(name, f"an array of shape {array.shape}", rule)
    shapes = {name: array.shape[:-1] for name, array in bodies.items()}
    try:
        leading = np.broadcast_shapes(*shapes.values())
    except ValueError:
        value = f"leading shapes {shapes['omega0']} and {shapes['attitude0']}"
        rule = f"must broadcast with {shapes['inertia']} of inertia"
        raise InputError("omega0, attitude0", value, rule) from None
    times = np.asarray(t, float)
    try:
        return Batch(bodies, times, np.broadcast_shapes(leading, times.shape[:-1]))
    except ValueError:
        rule = f"the leading shape must broadcast with {leading} of the bodies"
        raise InputError("t", f"an array of shape {times.shape}", rule) from None


def along(index: tuple[slice, ...], shape: tuple[int, ...]) -> tuple[slice, ...]:
    """Return the part of an index that applies to an array which broadcasts to the whole.

    Axes of one are taken whole.
    """
    own = index[len(index) - len(shape) :]
    return tuple(slice(None) if n == 1 else x for x, n in zip(own, shape, strict=True))


def times(t: ArrayLike) -> np.ndarray:
    """Convert times to a contiguous float64 array.

    Its shape is () or (N,).
    """
    array = np.asarray(t, float)
    if array.ndim > 1:
        raise EngineError("t", BAD_TIMES)
    return in_one_piece(array)


def is_lenient(errors: str) -> bool:
    """Return True if the option `errors` asks for NaN instead of exceptions.

    Its values are "nan" and "raise". Raises InputError for others.
    """
    if errors not in ERRORS:
        raise InputError("errors", errors, "must be 'raise' or 'nan'")
    return errors == "nan"


def in_one_piece(array: np.ndarray) -> np.ndarray:
    """Return an array itself, or a copy if it is not contiguous and aligned."""
    whole = array.flags.c_contiguous and array.flags.aligned
    return array if whole else array.copy(order="C")


def rows(array: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Broadcast vectors to a leading shape, and return them as the rows of a matrix.

    Its shape is (B, 3) or (B, 4).
    """
    size = array.shape[-1]
    return in_one_piece(np.broadcast_to(array, (*shape, size)).reshape(math.prod(shape), size))


def row_or_rows(array: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Convert vectors to a matrix with one row for all bodies or one row per body.

    Its shape is (1, N) if all bodies share the vector, else (B, N).
    """
    if math.prod(array.shape[:-1]) == 1:
        return in_one_piece(array.reshape(1, array.size))
    return rows(array, shape)


def outputs(
    out: Outputs,
    shape: tuple[int, ...],
    *inputs: object,
    own: tuple[object, object] = (None, None),
) -> States:
    """Check the caller's output arrays for states, or allocate new ones.

    Their shapes are (*shape, 4) and (*shape, 3).  They must share no memory with each other or an
    input that is an array, but may be the two of `own`, each in its place.
    """
    if out is None:
        return np.empty((*shape, 4)), np.empty((*shape, 3))
    if not isinstance(out, (tuple, list)) or len(out) != 2:
        raise InputError("out", "as given", "must be a pair of arrays (q, omega)")
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
            rule = "q and omega must not overlap each other or the inputs"
            raise InputError("out", "as given", rule)
    return q, omega


def _are_apart(q: np.ndarray, omega: np.ndarray, read: list[np.ndarray]) -> bool:
    """Return True if it is certain that outputs and inputs share no memory.

    False does not mean that they overlap.
    """
    first = second = None
    for x in (q, omega, *read):
        # The base of a view is the array that owns the memory, through all views.
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
    """Check the names of columns of derivatives, and sort them as in COLUMNS.

    None stands for all columns.  Raises InputError for other names.
    """
    if names is None or names is COLUMNS:
        return COLUMNS
    try:
        given = (names,) if isinstance(names, str) else tuple(names)
    except TypeError:
        given = ()
    # Strings alone are compared: a comparison with an array would be an array.
    found = tuple(name for name in COLUMNS if name in [x for x in given if isinstance(x, str)])
    if not given or len(found) != len(given):
        rule = f"must be some of {', '.join(COLUMNS)}, each once"
        raise InputError("columns", repr(names), rule)
    return found


def shapes(columns: tuple[str, ...] | None) -> tuple[tuple[int, ...], ...]:
    """Return the trailing shapes of the arrays for states and their derivatives.

    Those of derivatives are left out if `columns` is None.
    """
    if columns is None:
        return (4,), (3,)
    by_t = (3 if "t" in columns else 0,)
    by_inputs = (3, 3 * (len(columns) - ("t" in columns)))
    return (4,), (3,), by_inputs, by_inputs, by_t, by_t


def sensitivities(shape: tuple[int, ...], columns: tuple[str, ...] = COLUMNS) -> Sensitivities:
    """Allocate arrays for states and their derivatives."""
    count, ends = math.prod(shape), shapes(columns)
    block, begin, derivatives = _memory(count * sum(map(math.prod, ends[2:]))), 0, []
    for last in ends[2:]:
        size = count * math.prod(last)
        derivatives.append(block[begin : begin + size].reshape(*shape, *last))
        begin += size
    attitude, rates, attitude_t, rates_t = derivatives
    q, omega = (np.empty((*shape, *last)) for last in ends[:2])
    return q, omega, attitude, rates, attitude_t, rates_t


class _Loan:
    """Block of memory that returns to the cache when no array uses it any more."""

    def __init__(self, room: np.ndarray) -> None:
        self.room, self.__array_interface__ = room, room.__array_interface__

    def __del__(self, kept: list[np.ndarray] = _kept) -> None:
        kept[:] = [self.room]


def _memory(size: int) -> np.ndarray:
    """Allocate `size` uninitialised doubles, from the cache if possible.

    The system clears new memory, which takes as long as the computation: the last block of up to
    48 MB is kept for the next call.  Allocators keep blocks below 4 MB themselves.
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
    rule = None
    if type(array) is not np.ndarray and type(array) is not np.memmap:
        rule = f"{name} is a {type(array).__name__}: must be an array"
    elif array.dtype != _DOUBLE or array.shape != shape:
        found = f"{array.dtype} of shape {array.shape}"
        rule = f"{name} is {found}: must be float64 of shape {shape}"
    elif not array.flags.carray:
        rule = f"{name} must be C-contiguous, aligned and writeable"
    if rule:
        raise InputError("out", "as given", rule)
