"""What is asked of a manoeuvre: from one attitude to another in a given time, within limits."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import TypedDict

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import ExactNumber, Quaternion, Vector3
from rigidsym.io import toml as toml_file
from rigidsym.io.files import read_text

REST = (0, 0, 0)
_NEEDED = ("inertia", "start", "target")
_OWN = {*_NEEDED, "duration", "spin", "limits", "degrees"}
# What doubles can hold, and the products of three of them too.
_LARGEST = 10**60


@dataclass(frozen=True, slots=True)
class Limits:
    """What the spacecraft can do; None where there is no limit."""

    max_rate: Fraction | None = None
    "Of the body rates at any time of the motion, |omega|, rad/s."
    max_burst: Fraction | None = None
    "Of either burst, the change of the momentum that it makes, N m s."


class ManoeuvreTables(TypedDict):
    """The tables of a manoeuvre file, numbers as strings."""

    inertia: list[str]
    start: list[str]
    target: list[str]
    duration: str | None
    spin: dict[str, list[str]]
    limits: dict[str, str]


@dataclass(frozen=True, slots=True)
class Manoeuvre:
    """From `start` to `target` (quaternions, scalar first, body to inertial), in `duration` s.

    inertia: principal moments, kg m^2.  duration None: the shortest that the limits allow.
    start_spin, target_spin: body rates before the first burst and after the last, rad/s.
    All numbers are exact; `manoeuvre` and `parse` make one from what users give.
    """

    inertia: tuple[Fraction, ...]
    start: tuple[Fraction, ...]
    target: tuple[Fraction, ...]
    duration: Fraction | None
    start_spin: tuple[Fraction, ...] = (Fraction(0),) * 3
    target_spin: tuple[Fraction, ...] = (Fraction(0),) * 3
    limits: Limits = Limits()

    def __repr__(self) -> str:
        from rigidsym.view.text import manoeuvre_text

        return manoeuvre_text(self)

    @property
    def trivial(self) -> bool:
        """Whether start equals target, of either sign and any length, at rest: nothing to do."""
        pairs = combinations(zip(self.start, self.target, strict=True), 2)
        turned = any(p * s != q * r for (p, q), (r, s) in pairs)
        return not (turned or any(self.start_spin) or any(self.target_spin))

    def to_data(self) -> ManoeuvreTables:
        """The tables of a manoeuvre file, numbers as strings that mean them exactly."""
        given = {"max_rate": self.limits.max_rate, "max_burst": self.limits.max_burst}
        return {
            "inertia": _texts(self.inertia),
            "start": _texts(self.start),
            "target": _texts(self.target),
            "duration": None if self.duration is None else inputs.exact_text(self.duration),
            "spin": {"start": _texts(self.start_spin), "target": _texts(self.target_spin)},
            "limits": {k: inputs.exact_text(x) for k, x in given.items() if x is not None},
        }


def _texts(values: tuple[Fraction, ...]) -> list[str]:
    return [inputs.exact_text(value) for value in values]


def manoeuvre(
    inertia: Vector3,
    start: Quaternion,
    target: Quaternion,
    duration: ExactNumber | None = None,
    *,
    start_spin: Vector3 = REST,
    target_spin: Vector3 = REST,
    max_rate: ExactNumber | None = None,
    max_burst: ExactNumber | None = None,
    degrees: bool = False,
) -> Manoeuvre:
    """A manoeuvre from numbers as users give them; raises InputError for the first bad one.

    degrees: spins and `max_rate` are in deg/s, and are rounded to doubles in rad/s.
    """
    turned = inputs.is_true("degrees", degrees)
    given = {"max_rate": max_rate, "max_burst": max_burst, "duration": duration}
    exact = {name: None if x is None else above_zero(name, x) for name, x in given.items()}
    if turned and exact["max_rate"] is not None:
        (exact["max_rate"],) = _in_radians([exact["max_rate"]])
    length, limits = exact["duration"], Limits(exact["max_rate"], exact["max_burst"])
    if length is None and limits == Limits():
        raise InputError("duration", "missing", "give one, or a limit that decides it")
    spins = _spin("spin.start", start_spin), _spin("spin.target", target_spin)
    return Manoeuvre(
        _moderate("inertia", inputs.certain("inertia", inputs.inertia(inertia, way_out=""))),
        inputs.certain("start", inputs.attitude(start, "start")),
        inputs.certain("target", inputs.attitude(target, "target")),
        length,
        *(_in_radians(spin) if turned else spin for spin in spins),
        limits,
    )


def above_zero(field: str, value: ExactNumber) -> Fraction:
    """An exact number above zero, and neither too large nor too small for what follows."""
    number = inputs.exact(field, value)
    if number <= 0:
        raise InputError(field, value, "must be above zero")
    return _moderate(field, (number,))[0]


def _spin(field: str, values: Vector3) -> tuple[Fraction, ...]:
    spin = inputs.certain(field, inputs.vector(field, values, 3))
    if any(abs(x) > _LARGEST for x in spin):
        raise InputError(field, inputs.shown(spin), "must not be beyond 1e60")
    return spin


def _in_radians(values: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Doubles, which files can hold in a few digits."""
    exact = inputs.certain("degrees", inputs.in_radians(values))
    return tuple(Fraction(float(x)) for x in exact)


def _moderate(field: str, values: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    """The same numbers above zero; raises InputError for one that is too large or too small."""
    if any(not 1 <= x * _LARGEST <= _LARGEST**2 for x in values):
        raise InputError(field, inputs.shown(values), "must be from 1e-60 to 1e60")
    return values


def load(
    path: str | Path, others: frozenset[str] = frozenset()
) -> tuple[Manoeuvre, toml_file.TomlTable]:
    """A manoeuvre file and its tables as they are; raises InputError about the first bad thing.

    `others` are tables that a file may hold for those who fly the manoeuvre.
    """
    tables = toml_file.parse("manoeuvre", read_text("manoeuvre", path))
    return parse(tables, others), tables


def parse(tables: toml_file.TomlTable, others: frozenset[str] = frozenset()) -> Manoeuvre:
    """A manoeuvre from the tables of a file; numbers may be floats or strings of decimals."""
    toml_file.check_keys("manoeuvre", tables, _OWN | others, _NEEDED)
    spin = _table(tables, "spin", {"start", "target"})
    limits = _table(tables, "limits", {"max_rate", "max_burst"})
    return manoeuvre(
        *(tables[key] for key in _NEEDED),
        tables.get("duration"),
        start_spin=spin.get("start", REST),
        target_spin=spin.get("target", REST),
        **limits,
        degrees=tables.get("degrees", False),
    )


def _table(tables: toml_file.TomlTable, name: str, known: set[str]) -> toml_file.TomlTable:
    table = tables.get(name, {})
    if not isinstance(table, Mapping):
        raise InputError(name, repr(table), f"must be a table of {', '.join(sorted(known))}")
    toml_file.check_keys(name, table, known)
    return table
