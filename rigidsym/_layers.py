"""Functions of NumPy arrays, applied to the labelled arrays of xarray and the lazy ones of Dask.

A function is called again with what a container holds: a DataArray of Dask arrays is one layer upon
another.  Neither library is imported unless an argument is one of its arrays.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from importlib import import_module
from operator import itemgetter
from typing import Any

import numpy as np

from rigidsym import _containers as containers
from rigidsym.errors import InputError
from rigidsym.sensitivity import Sensitivity

# The last axes of arguments and results: names of dimensions, and sizes.  Times, `t`, have an axis
# of their own, and `dt` has none.
AXES = {
    **dict.fromkeys(("inertia", "omega0", "omega"), ("axis", 3)),
    **dict.fromkeys(("attitude0", "q"), ("component", 4)),
}
LABELS = {"component": ["q0", "q1", "q2", "q3"], "axis": [1, 2, 3]}
ATTRIBUTES = {
    "q": {"long_name": "attitude, body to inertial, scalar first", "units": "1"},
    "omega": {"long_name": "rates in body axes", "units": "rad/s"},
}
_T = "t"
_PLAIN = (np.ndarray, tuple, list, float, int)
# Characters of a message of another library.
_LONGEST = 200


def is_layered(*values: object) -> bool:
    """Return True if any value is an array of xarray or of Dask."""
    return any(type(x) not in _PLAIN and (_is_labelled(x) or _is_lazy(x)) for x in values)


def called(function: Callable[..., Any], given: Mapping[str, Any], **options: Any) -> Any:
    """Call a function of arrays and options, and return its results in the containers of its input.

    Parameters
    ----------
    function : function
        Takes the arrays by name, and returns q, omega and possibly a Sensitivity.
    given : mapping
        Arrays, of which one at least is of xarray or Dask.
    **options
        Options of the function.

    Raises
    ------
    InputError
        For arrays that do not fit, and for options that need plain arrays.
    """
    if options.get("out") is not None:
        raise InputError(
            "out", "as given", "results of xarray and Dask are new arrays; leave it out"
        )
    apply = _labelled if any(map(_is_labelled, given.values())) else _lazily
    try:
        return apply(function, given, options)
    except InputError:
        raise
    except ValueError as error:  # the libraries' own, for shapes and labels that do not fit
        named = {name: x for name, x in given.items() if is_layered(x)}
        reason, next_step = " ".join(str(error).split()), ""
        if any(math.isnan(n) for x in named.values() for n in np.shape(x)):
            reason, next_step = "chunks of unknown size do not fit", "x.compute_chunk_sizes()"
        shown = reason if len(reason) < _LONGEST else f"{reason[:_LONGEST]}..."
        raise InputError(", ".join(named), "as given", shown, next_step=next_step) from None


def _is_labelled(value: object) -> bool:
    return containers.is_a(value, "xarray", "DataArray") or containers.is_a(
        value, "xarray", "Dataset"
    )


def _is_lazy(value: object) -> bool:
    return containers.is_a(value, "dask.array", "Array")


def _labelled(function: Callable[..., Any], given: Mapping[str, Any], options: Any) -> Any:
    """Call a function with arrays of xarray.

    Dimensions are matched by name.
    """
    xarray: Any = import_module("xarray")
    for name, x in given.items():
        if containers.is_a(x, "xarray", "Dataset"):
            raise InputError(name, "a Dataset", "must be one DataArray of it")
    if options.get("sensitivity"):
        raise InputError("sensitivity", True, "takes plain arrays: give the DataArrays' .data")
    last = {name: _last(name, x, options) for name, x in given.items() if name in AXES}
    labelled = {name: x for name, x in given.items() if _is_labelled(x)}
    bodies = {d for n, x in labelled.items() if n != _T for d in x.dims if d != last.get(n)}
    arrays, core = dict(given), {name: [x] for name, x in last.items()}
    if "dt" in given and "dt" not in labelled and np.ndim(given["dt"]):
        _refuse_unlabelled("dt", given["dt"], "a number")
    if _T in given:
        arrays[_T], core[_T] = _times(xarray, given[_T], bodies)
    # Without a dimension of their own, times are of the bodies, one for each.
    one_each = not core.get(_T, [_T]) and np.ndim(arrays[_T]) > 0

    def compute(*values: Any) -> Any:
        named = dict(zip(arrays, values, strict=True))
        if not one_each:
            return function(**named, **options)
        named[_T] = named[_T][..., None]
        return tuple(x[..., 0, :] for x in function(**named, **options))

    # Results have the last dimensions of labelled inputs, if there are any.
    own = {AXES[name][0]: last[name] for name in last if name in labelled}
    ends = {"q": own.get("component", "component"), "omega": own.get("axis", "axis")}
    found = xarray.apply_ufunc(
        compute,
        *arrays.values(),
        input_core_dims=[core.get(name, []) for name in arrays],
        output_core_dims=[[*core.get(_T, []), end] for end in ends.values()],
        join="exact",
        dask="allowed",
    )
    results = []
    for x, (name, end) in zip(found, ends.items(), strict=True):
        if end not in own.values():
            x = x.assign_coords({end: LABELS[AXES[name][0]]})
        results.append(x.rename(name).assign_attrs(ATTRIBUTES[name]))
    return tuple(results)


def _last(name: str, value: Any, options: Mapping[str, Any]) -> str:
    """Return the name of an argument's last dimension, and check its size and its unit.

    It is the dimension named in AXES, or else the only one of that size.
    """
    axis, size = AXES[name]
    if not _is_labelled(value):
        if np.ndim(value) > 1:
            _refuse_unlabelled(name, value, f"one vector of {size} numbers")
        return axis
    named = [axis] if axis in value.dims else value.dims
    found = [dimension for dimension in named if value.sizes[dimension] == size]
    if len(found) != 1:
        rule = f"one dimension must have {size} numbers; if several have, its name must be {axis!r}"
        raise InputError(name, f"a DataArray of sizes {dict(value.sizes)}", rule)
    unit, degrees = value.attrs.get("units"), options.get("degrees", False)
    if axis == "axis" and unit in ("rad/s", "deg/s") and degrees != (unit == "deg/s"):
        rule = f"its units contradict degrees={degrees}"
        raise InputError(name, f"a DataArray in {unit}", rule)
    return found[0]


def _times(xarray: Any, t: Any, bodies: set[Any]) -> tuple[Any, list[Any]]:
    """Return times with labels, and a list of their dimension.

    It is the last dimension that no body has.  The list is empty for a single time, and if each
    body has a time of its own.
    """
    if _is_labelled(t):
        return t, [x for x in t.dims if x not in bodies][-1:]
    if not np.ndim(t):
        return t, []
    if np.ndim(t) > 1 or _T in bodies:
        _refuse_unlabelled(_T, t, "a number or a list of times")
    return xarray.DataArray(t, dims=_T, coords={} if _is_lazy(t) else {_T: t}), [_T]


def _refuse_unlabelled(name: str, value: Any, rule: str) -> None:
    shown = f"an array of shape {np.shape(value)} without labels"
    label = f"xarray.DataArray({name}, dims=[...])"
    raise InputError(name, shown, f"must be {rule} beside DataArrays", next_step=label)


def _lazily(function: Callable[..., Any], given: Mapping[str, Any], options: Any) -> Any:
    """Call a function with each block of Dask's arrays.

    Axes of bodies and of times may be in chunks; last axes are joined.
    """
    da: Any = import_module("dask.array")
    # A call without bodies and times checks the options, and shows the other axes of the results.
    arrays = {name: _chunked(da, name, x) for name, x in given.items()}
    empty = {name: np.empty((0, AXES[name][1]) if name in AXES else 0) for name in given}
    if _T in given:
        empty[_T] = np.empty((0,) * max(1, arrays[_T].ndim))
    sample = function(**empty, **options)
    leading = sample[0].ndim - 1
    labels = {name: tuple(_axes(name, x.ndim)) for name, x in arrays.items()}
    bodies = {name: [y for y in x if y.isdigit()] for name, x in labels.items()}
    out = max(bodies.values(), key=len)
    _check_bodies({name: arrays[name].shape[: len(x)] for name, x in bodies.items()})
    out += [_T] if _T in labels.get(_T, ()) else []
    blocks = da.blockwise(
        *(_block, out),
        *(y for name in arrays for y in (arrays[name], labels[name])),
        **{"function": function, "names": tuple(given), "options": options},
        concatenate=True,
        dtype=object,
        meta=np.empty((0,) * len(out), object),
    )
    found = []
    for k, x in enumerate(_flat(sample)):
        ends = {f"end {n}": size for n, size in enumerate(x.shape[leading:])}
        meta = np.empty((0,) * (len(out) + len(ends)))
        axes = (*out, *ends)
        found.append(
            da.blockwise(itemgetter(k), axes, blocks, out, new_axes=ends, dtype=float, meta=meta)
        )
    if len(sample) == 2:
        return tuple(found)
    names = "attitude", "rates", "attitude_t", "rates_t"
    return *found[:2], replace(sample[2], **dict(zip(names, found[2:], strict=True)))


def _chunked(da: Any, name: str, value: Any) -> Any:
    """Return an input as an array of Dask, with the last axis in its place.

    Raises InputError for another size of this axis, and for dates.
    """
    if not _is_lazy(value):
        value = da.from_array(np.asarray(containers.plain(name, value)))
    if value.dtype.kind == "M":
        rule = "dates of Dask arrays have no first one yet"
        raise InputError(name, f"a Dask array of {value.dtype}", rule, next_step="give t - epoch")
    if name in AXES and value.shape[-1:] != (AXES[name][1],):
        rule = f"the last axis must have {AXES[name][1]} numbers"
        raise InputError(name, f"an array of shape {value.shape}", rule)
    return value


def _check_bodies(shapes: Mapping[str, tuple[int, ...]]) -> None:
    """Raise InputError for the first leading shape that does not broadcast with those before it.

    Unknown sizes are left to Dask.
    """
    before: tuple[int, ...] = ()
    for name, shape in shapes.items():
        known = tuple(1 if math.isnan(n) else n for n in shape)
        try:
            before = np.broadcast_shapes(before, known)
        except ValueError:
            rule = f"must broadcast with {before} of what comes before"
            raise InputError(name, f"leading shape {shape}", rule) from None


def _axes(name: str, count: int) -> Iterator[str]:
    """Yield labels of an input's axes: bodies by number, counted from the last, then its own."""
    own = [name] if name in AXES or (name == _T and count) else []
    yield from map(str, reversed(range(count - len(own))))
    yield from own


def _block(
    *blocks: np.ndarray, function: Callable[..., Any], names: tuple[str, ...], options: Any
) -> tuple[np.ndarray, ...]:
    """Call a function with one block of each input, and return its results as one tuple."""
    try:
        return _flat(function(**dict(zip(names, blocks, strict=True)), **options))
    except InputError as error:
        rule = f"{error.rule} (numbered in its block of a Dask array)"
        raise InputError(error.field, error.value, rule, next_step=error.next_step) from None


def _flat(found: tuple[Any, ...]) -> tuple[np.ndarray, ...]:
    """Return q, omega and the arrays of a Sensitivity as one tuple."""
    q, omega, *more = found
    derivatives: list[Sensitivity] = more
    return (
        q,
        omega,
        *(y for x in derivatives for y in (x.attitude, x.rates, x.attitude_t, x.rates_t)),
    )
