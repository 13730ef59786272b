"""Values of pandas, xarray and SciPy, and dates and times, as arrays of numbers.

The type checks import no library: before a library is imported, no value can have its types.
"""

import sys
from datetime import datetime, timedelta
from fractions import Fraction
from typing import Any

import numpy as np

from rigidsym.errors import InputError

_PLAIN = (np.ndarray, list, tuple, float, int, str, type(None))
# Arguments that are times, and their spans.
_TIMES, _SPANS = ("t", "times"), ("t", "times", "dt")
_SECONDS = {
    **{"W": Fraction(604800), "D": Fraction(86400), "h": Fraction(3600), "m": Fraction(60)},
    **{
        unit: Fraction(1, 1000**k)
        for k, unit in enumerate(("s", "ms", "us", "ns", "ps", "fs", "as"))
    },
}
_UNITS = {
    **{"inertia": "kg m^2", "tensor": "kg m^2", "omega0": "rad/s", "omega": "rad/s"},
    **dict.fromkeys(_SPANS, "s"),
}
_SUBTRACT = "subtract the epoch of t = 0 first: t - epoch"


def is_a(value: object, module: str, name: str) -> bool:
    """Return True if a value is an instance of a library's class, without importing the library."""
    return isinstance(value, getattr(sys.modules.get(module), name, ()))


def plain(field: str, value: Any) -> Any:
    """Convert a value of another library to an array or a number.

    Dates and times become seconds, see `ticks`; for other values see `unwrapped`.
    """
    found = ticks(field, value := unwrapped(field, value))
    if found is None:
        return value
    count, unit = found
    if unit.denominator == 1:
        return count * float(unit)
    # In two parts of one sign, because a double has not all digits of nanoseconds.
    rest = np.fmod(count, unit.denominator)
    whole, multiple = (count - rest) // unit.denominator, float(unit.numerator)
    return whole * multiple + rest * multiple / unit.denominator


def unwrapped(field: str, value: Any) -> Any:
    """Convert a value of another library to NumPy's, and return others as they are.

    A SciPy Rotation becomes quaternions (..., 4) with the scalar first; arrays and indices of
    pandas and xarray become arrays.  Raises InputError for values with units.
    """
    if type(value) in _PLAIN:
        if isinstance(value, list | tuple) and value and type(value[0]) not in _PLAIN:
            _refuse_unit(field, value[0], value)
        return value
    if is_a(value, "scipy.spatial.transform", "Rotation"):
        return value.as_quat(scalar_first=True)
    if hasattr(value, "to_numpy"):
        return _to_numpy(value)
    if isinstance(value, timedelta):
        return np.asarray(value, "timedelta64[us]")
    if isinstance(value, datetime):
        return np.asarray(value.replace(tzinfo=None), "datetime64[us]")
    _refuse_unit(field, value, value)
    return value


def _refuse_unit(field: str, one: object, given: object) -> None:
    """Raise InputError if a value has a unit, as those of pint and of astropy have."""
    if hasattr(one, "units") or (hasattr(one, "unit") and hasattr(one, "dtype")):
        unit = f" in {_UNITS[field]}" if field in _UNITS else ""
        raise InputError(field, given, f"has a unit: give its numbers{unit}")


def ticks(field: str, value: Any) -> tuple[np.ndarray, Fraction] | None:
    """Convert dates and times to whole numbers of a unit, and return them with that unit in s.

    Spans (timedelta64) are times themselves.  Dates (datetime64) count from the first one, in days
    of 86400 s.  Returns None for other values.  Raises InputError for NaT, for a single date, and
    for arguments that are not times.
    """
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    argument = field.rpartition(".")[2]
    if kind not in ("m", "M") or argument not in (_TIMES if kind == "M" else _SPANS):
        return None
    given = np.asarray(value)
    for place in np.argwhere(np.isnat(given))[:1].tolist():
        name = f"{field}[{', '.join(map(str, place))}]" if place else field
        raise InputError(name, "NaT", "must be a date or a time")
    if kind == "M" and given.ndim != 1:
        shown = f"an array of dates of shape {given.shape}" if given.ndim else given
        rule = "dates count from the first of a one-dimensional array"
        raise InputError(field, shown, rule, next_step=_SUBTRACT)
    name, multiple = np.datetime_data(given.dtype)
    if kind == "M" and name in ("Y", "M"):
        given, name, multiple = given.astype("datetime64[D]"), "D", 1
    if name not in _SECONDS:
        raise InputError(field, f"times in units of {name!r}", "must be in weeks or shorter units")
    count = given.astype(np.int64)
    if kind == "M" and count.size:
        first, later = count[0], count >= count[0]
        count = count - first
        if np.any((count >= 0) != later):
            raise InputError(field, f"dates in {name}", "the first and another are too far apart")
    return count, multiple * _SECONDS[name]


def refuse_dates(field: str, value: Any) -> None:
    """Raise InputError for dates where t = 0 is known to be another date than the first of them."""
    if getattr(getattr(unwrapped(field, value), "dtype", None), "kind", "") == "M":
        raise InputError(field, "dates", "must be times since t = 0", next_step=_SUBTRACT)


def _to_numpy(value: Any) -> np.ndarray:
    """Convert an array of pandas or xarray to NumPy, and dates with a time zone to UTC."""
    dtype = getattr(value, "dtype", None)
    if getattr(dtype, "tz", None) is not None:
        return value.to_numpy(f"datetime64[{getattr(dtype, 'unit', 'ns')}]")
    return value.to_numpy()
