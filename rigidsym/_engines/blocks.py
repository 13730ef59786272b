"""States written block by block to memory maps, Zarr arrays and others that take slices.

Such an array has `shape`, `dtype` and assignment of slices.  Only one block of states is in memory
at a time.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from itertools import product
from typing import Any

import numpy as np

from rigidsym._engines.arrays import States
from rigidsym.errors import EngineError, InputError

# States in a block: 15 MB of them.
_STATES = 1 << 18
Part = tuple[slice, ...]


def are_streams(out: object) -> bool:
    """Return True if a pair of outputs has one that is not an array in memory."""
    return isinstance(out, tuple | list) and len(out) == 2 and any(map(_is_stream, out))


def fill(
    out: Any,
    shape: tuple[int, ...],
    inputs: Iterable[object],
    compute: Callable[[Part, States], None],
    axes: int,
) -> Any:
    """Compute states block by block, write them to a pair of outputs, and return the pair.

    Parameters
    ----------
    out : pair
        Outputs of the shapes (*shape, 4) and (*shape, 3).
    shape : tuple
        The leading shape of the states.
    inputs
        Arrays that must share no memory with the outputs.
    compute : function
        Called with the slices of a block, one for each axis of `shape`, and a pair of arrays.
    axes : int
        Number of leading axes of `shape` that count bodies; an axis of times may follow.

    Raises
    ------
    InputError
        For an output of another shape or type, or that can only be read.
    EngineError
        As `compute` does, with numbers of bodies and times in the whole.
    """
    for name, array, size in zip(("q", "omega"), out, (4, 3), strict=True):
        _check(name, array, (*shape, size))
    memory = [x for x in out if isinstance(x, np.ndarray)]
    pairs = [(x, y) for x in memory for y in inputs if isinstance(y, np.ndarray)]
    if any(np.may_share_memory(x, y) for x, y in [*pairs, *([memory] if len(memory) > 1 else [])]):
        raise InputError("out", "as given", "q and omega must not overlap each other or the inputs")
    for part in _parts(shape, out[0]):
        sizes = tuple(x.stop - x.start for x in part)
        states = np.empty((*sizes, 4)), np.empty((*sizes, 3))
        try:
            compute(part, states)
        except EngineError as error:
            raise _in_the_whole(error, part, shape, axes) from None
        for array, values in zip(out, states, strict=True):
            array[(*part, slice(None))] = values
    return tuple(out)


def _is_stream(array: object) -> bool:
    return type(array) is not np.ndarray and _takes_slices(array)


def _takes_slices(array: object) -> bool:
    return all(hasattr(array, name) for name in ("__setitem__", "dtype", "shape"))


def _check(name: str, array: Any, shape: tuple[int, ...]) -> None:
    rule = None
    # Neither Dask's nor xarray's arrays, which may be anywhere.
    if not _takes_slices(array) or hasattr(array, "__dask_graph__"):
        rule = f"{name} is a {type(array).__name__}: must be an array that takes slices"
    elif array.dtype != np.float64 or tuple(array.shape) != shape:
        found = f"{array.dtype} of shape {tuple(array.shape)}"
        rule = f"{name} is {found}: must be float64 of shape {shape}"
    elif getattr(array, "read_only", isinstance(array, np.ndarray) and not array.flags.writeable):
        rule = f"{name} can only be read: open it for writing"
    if rule:
        raise InputError("out", "as given", rule)


def _parts(shape: tuple[int, ...], output: Any) -> Iterator[Part]:
    """Divide a shape into blocks of up to _STATES states, and yield their slices in order.

    Blocks are of whole chunks of the output along all its axes, if it has chunks.
    """
    chunks = getattr(output, "chunks", None) or ()
    units = [c if isinstance(c, int) else 1 for c in chunks[: len(shape)]] or [1] * len(shape)
    block = [max(1, min(size, unit)) for size, unit in zip(shape, units, strict=True)]
    for k in reversed(range(len(shape))):
        left = _STATES // math.prod(block)
        block[k] = min(shape[k], block[k] * max(1, left))
    ranges = [
        [slice(first, min(first + step, size)) for first in range(0, size, max(1, step))]
        for size, step in zip(shape, block, strict=True)
    ]
    yield from product(*ranges)


def _in_the_whole(error: EngineError, part: Part, shape: tuple[int, ...], axes: int) -> EngineError:
    """Return an error of a block with the number of its body and its time in the whole."""
    body, time = error.body, error.time
    if body is not None and axes:
        sizes = [x.stop - x.start for x in part[:axes]]
        place = [x.start + k for x, k in zip(part, np.unravel_index(body, sizes), strict=False)]
        body = int(np.ravel_multi_index(place, shape[:axes]))
    if time is not None and len(part) > axes:
        time += part[-1].start
    return EngineError(error.field, error.rule, body, time)
