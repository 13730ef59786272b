"""Options that describe a table of observations, checked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from rigidsym import _inputs as inputs
from rigidsym.errors import InputError, unknown
from rigidsym.fitting._names import ATTITUDES, FORMS, QUANTITIES, pairs
from rigidsym.fitting._units import DEFAULTS, measured, needed
from rigidsym.io import _epochs as epochs

DIRECTIONS = ("body-to-inertial", "inertial-to-body")
ALLOWED = ("missing", "unsorted", "repeated")
"What `allow` permits: lines with missing numbers, out of order, or at the time of another."
_MOST_LINES = 10**9
# Options by the convention that `Agreement.readings` name.
_CONVENTIONS = {
    "attitudes scalar last": "--attitude quaternion-scalar-last",
    "attitudes inertial to body": "--direction inertial-to-body",
    "attitudes scalar last and inertial to body": "--attitude quaternion-scalar-last "
    "--direction inertial-to-body",
    "rates in degrees": "--units rate=deg/s",
    "rates in degrees a day": "--units rate=deg/d",
    "rates in revolutions": "--units rate=turn/s",
    "rates in revolutions a minute": "--units rate=rpm",
    "rates in rad/min": "--units rate=rad/min",
    "rates in rad/h": "--units rate=rad/h",
    "times in ms, or rates in mrad/s": "--units time=ms",
    "times in min": "--units time=min",
    "times in h": "--units time=h",
    "times in days": "--units time=d",
}
FIRST = "first"
"The epoch that is the first time of a table."
_SINGULAR = {"attitude": "attitudes", "rate": "rates", "vector": "vectors", "direction": "vectors"}


@dataclass(frozen=True)
class Layout:
    """How a table of observations is read: the options of `rigidsym.fitting.load`."""

    columns: str | Mapping[str, str] | None = None
    units: str | Mapping[str, str] | None = None
    sigma: str | Mapping[str, Any] | None = None
    time_format: str | None = None
    epoch: str | None = None
    attitude: str = "quaternion"
    direction: str = DIRECTIONS[0]
    axis: Any = None
    allow: str | Sequence[str] = ()
    delimiter: str = ","
    decimal: str = "."
    header_line: int | None = None
    data_line: int = 1
    encoding: str = "utf-8"
    names: dict[str, str] = field(init=False, repr=False)
    factors: dict[str, str] = field(init=False, repr=False)
    errors: dict[str, Any] = field(init=False, repr=False)
    allowed: tuple[str, ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        for name, known in (
            ("time_format", (None, *epochs.FORMATS)),
            ("attitude", ATTITUDES),
            ("direction", DIRECTIONS),
            ("decimal", (".", ",")),
        ):
            if getattr(self, name) not in known:
                raise unknown(name, getattr(self, name), [x for x in known if x])
        if self.decimal == self.delimiter:
            rule = "is the delimiter, too: add --delimiter ';' or another"
            raise InputError("decimal", repr(self.decimal), rule)
        for name in ("delimiter", "encoding"):
            if not isinstance(getattr(self, name), str):
                raise InputError(name, repr(getattr(self, name)), "must be a text")
        for name in ("header_line", "data_line"):
            if getattr(self, name) is not None:
                inputs.whole(name, getattr(self, name), _MOST_LINES)
        allowed = self.allow.split(",") if isinstance(self.allow, str) else self.allow
        if not isinstance(allowed, list | tuple):
            raise InputError("allow", repr(allowed), f"must be some of: {', '.join(ALLOWED)}")
        allowed = tuple(x.strip() if isinstance(x, str) else x for x in allowed if x)
        for x in allowed:
            if x not in ALLOWED:
                raise unknown("allow", x, ALLOWED)
        units = pairs("units", self.units)
        for name, unit in units.items():
            quantity = QUANTITIES.get(name, name)
            if not QUANTITIES.get(name, name in DEFAULTS):
                if name == unit:
                    rule = "must be QUANTITY=UNIT,QUANTITY=UNIT, as time=ms,rate=deg/s"
                    raise InputError("units", repr(name), rule)
                raise unknown("units", name, (*DEFAULTS, *(x for x, y in QUANTITIES.items() if y)))
            needed(f"units.{name}", quantity, str(unit))
        errors = {}
        for name, value in pairs("sigma", self.sigma).items():
            kind = _SINGULAR.get(name, name)
            scales = {form.kind: form.scale for form in FORMS}
            if kind not in scales:
                rule = f"must be KIND=ERROR, as attitudes=0.1deg; kinds are {', '.join(scales)}"
                raise InputError("sigma", name, rule)
            errors[kind] = measured(f"sigma.{kind}", scales[kind], value)
        vars(self).update(
            names=pairs("columns", self.columns), factors=units, errors=errors, allowed=allowed
        )


def options_for(reading: str) -> str:
    """Return the options that read a table in the conventions of an `Agreement`'s reading.

    The text is empty where there is no option for one of them.
    """
    found = []
    for name in sorted(_CONVENTIONS, key=len, reverse=True):
        if name in reading:
            reading = reading.replace(name, "", 1)
            found.append(_CONVENTIONS[name])
    return "" if reading.strip(", ") else " ".join(sorted(found))
