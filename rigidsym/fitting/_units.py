"""Units of times, angles and rates in tables, with exact factors to s, rad and rad/s.

Numbers are multiplied as decimals of 60 digits and rounded to a double once.
"""

import re
from decimal import Context, Decimal

from rigidsym.errors import InputError

_EXACT = Context(prec=60)
_PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628621")
_TIMES = {
    **{name: Decimal(x) for name, x in (("s", 1), ("ms", "1e-3"), ("us", "1e-6"), ("ns", "1e-9"))},
    **{name: Decimal(x) for name, x in (("min", 60), ("h", 3600), ("d", 86400))},
}
_ANGLES = {
    **{name: Decimal(x) for name, x in (("rad", 1), ("mrad", "1e-3"), ("urad", "1e-6"))},
    **{
        name: _EXACT.divide(_PI, x)
        for name, x in (("deg", 180), ("arcmin", 10800), ("arcsec", 648000), ("hour", 12))
    },
    "mdeg": _EXACT.divide(_PI, 180_000),
    "turn": _EXACT.multiply(_PI, 2),
}
# Other spellings, in lower case.
_WORDS = {
    **dict.fromkeys(("sec", "secs", "second", "seconds"), "s"),
    **dict.fromkeys(("msec", "millis", "milliseconds"), "ms"),
    **dict.fromkeys(("µs", "μs", "usec", "micros", "microseconds"), "us"),
    **dict.fromkeys(("nsec", "nanos", "nanoseconds"), "ns"),
    **dict.fromkeys(("minute", "minutes"), "min"),
    **dict.fromkeys(("hr", "hrs", "hours"), "h"),
    **dict.fromkeys(("day", "days"), "d"),
    **dict.fromkeys(("°", "degs", "degree", "degrees"), "deg"),
    **dict.fromkeys(("rads", "radian", "radians"), "rad"),
    **dict.fromkeys(('"', "as", "arcseconds"), "arcsec"),
    **dict.fromkeys(("'", "arcminutes"), "arcmin"),
    **dict.fromkeys(("rev", "revs", "revolution", "turns"), "turn"),
}
_RATES = {"dps": "deg/s", "mdps": "mdeg/s", "rpm": "turn/min", "degs": "deg/s", "rads": "rad/s"}
DEFAULTS = {"time": "s", "angle": "rad", "rate": "rad/s"}
"Quantities that have units, with the unit where none is given."
_BASES = {"time": _TIMES, "angle": _ANGLES}
# Between the parts of a rate: deg/s, deg s^-1, deg.s-1, deg s⁻¹, deg per s.
_PER = re.compile(r"(.+?)(?:\s*/\s*|\s+per\s+|[\s.·*]+(?=\S+?(?:\^?-1|⁻¹)$))(.+?)(?:\^?-1|⁻¹)?")
_NUMBER = re.compile(r"\s*(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)\s*(.*)", re.ASCII)


def factor(quantity: str, unit: str) -> Decimal | None:
    """Return the factor from a unit to s, rad or rad/s; None if it is no unit of the quantity."""
    name = unit.strip().lower()
    if quantity != "rate":
        return _BASES[quantity].get(_WORDS.get(name, name))
    parts = _PER.fullmatch(_RATES.get(name, name))
    if not parts:
        return None
    angle, time = factor("angle", parts[1]), factor("time", parts[2])
    return None if angle is None or time is None else _EXACT.divide(angle, time)


def needed(field: str, quantity: str, unit: str) -> Decimal:
    """Return the factor of a unit.

    Raises InputError if it is no unit of the quantity.
    """
    found = factor(quantity, unit)
    if found is None:
        rule = f"must be a unit of {quantity}: {names(quantity)}"
        raise InputError(field, repr(unit), rule)
    return found


def names(quantity: str) -> str:
    """Return the names of the units of a quantity, for messages."""
    if quantity == "rate":
        return f"rpm, or an angle / a time: {', '.join(_ANGLES)} / {', '.join(_TIMES)}"
    return ", ".join(_BASES[quantity])


def converted(number: Decimal, unit: Decimal) -> Decimal:
    """Multiply a number by the factor of its unit, to 60 digits."""
    return _EXACT.multiply(number, unit)


def measured(field: str, quantity: str, value: float | str) -> float:
    """Convert a number, or a text such as "0.1deg", to s, rad or rad/s.

    Numbers without a unit are in these.  Raises InputError.
    """
    if not isinstance(value, str):
        return value
    parts = _NUMBER.fullmatch(value)
    if not parts:
        unit = "deg/s" if quantity == "rate" else "deg"
        rule = f"must be a positive number with a unit, such as 0.1{unit}"
        raise InputError(field, repr(value), rule)
    unit = needed(field, quantity, parts[2] or DEFAULTS[quantity])
    return float(converted(Decimal(parts[1]), unit))
