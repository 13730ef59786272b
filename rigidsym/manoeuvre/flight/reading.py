"""The settings of a flight from the tables of a manoeuvre file."""

from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from fractions import Fraction
from typing import Any, TypeVar

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import ExactNumber, Vector3
from rigidsym.io import messages
from rigidsym.io import toml as toml_file
from rigidsym.manoeuvre.flight.settings import (
    Controller,
    Disturbances,
    Flight,
    Orbit,
    Spacecraft,
    Thrusters,
    Timing,
    Wheels,
)

MOST_SAMPLES = 1_000_000
LONGEST = 100_000
"s: some seventeen orbits, over which the circular one stays what it is."
SHORTEST = Fraction(1, 10**9)
"s, of a flight and of a period of control: beyond any wheels."
LOWEST, HIGHEST = 100.0, 100_000.0
"""km: below, the air lets no circular orbit last; above, the field of the Earth and its atmosphere
are not what the models say."""
LEAST_RATE, MOST_RATE = 1e-12, 1e12
"N m/s: with the first, a day makes 1e-7 N m, as little as what disturbs; the second is no limit."
# Far beyond what flies: more is a slip of units.
MOST_MOMENTUM = 1e6
MOST_DIPOLE = 1e6
MOST_DRAG = 100.0
MOST_METRES = 1e3

Setting = TypeVar("Setting", covariant=True)
# Of a field and its value, of whatever type TOML has it.
Reader = Callable[[str, Any], Setting]


def read(tables: toml_file.TomlTable) -> Flight:
    """A flight from the tables [orbit], [wheels], ... as TOML gives them; missing: the paper's.

    With [thrusters] and no [controller] nothing but their burns steers.

    Raises InputError about the first key that is not known or value that cannot be.
    """
    made = {name: _table(name, tables[name]) for name in _READERS if name in tables}
    if "thrusters" in made:
        made.setdefault("controller", Controller(natural_frequency=0.0))
    flight = Flight(**made, message=messages.read(tables.get("message", {}), messages.MISSION))
    _check_sunlight(flight.spacecraft)
    _check_wheels(flight.wheels)
    _check_samples(flight.run)
    return flight


def _table(name: str, table: object) -> Any:
    kind, readers = _READERS[name]
    if not isinstance(table, Mapping):
        raise InputError(name, repr(table), f"must be a table of {', '.join(sorted(readers))}")
    toml_file.check_keys(name, table, readers)
    return kind(**{key: readers[key](f"{name}.{key}", value) for key, value in table.items()})


def _number(field: str, value: ExactNumber) -> float:
    return inputs.doubles(field, [inputs.exact(field, value)])[0]


def _between(low: float, high: float, rule: str, open_below: bool = False) -> Reader[float]:
    """A reader of numbers from low to high, or above low; `rule` says so."""

    def reader(field: str, value: ExactNumber) -> float:
        number = _number(field, value)
        if not low <= number <= high or (open_below and number == low):
            raise InputError(field, value, rule)
        return number

    return reader


def _altitude(field: str, value: ExactNumber) -> float:
    altitude = _number(field, value)
    if altitude <= 0:
        raise InputError(field, value, "must be above the surface, km")
    if altitude < LOWEST:
        rule = f"must be at least {LOWEST:.0f} km: no circular orbit lasts below"
        raise InputError(field, value, rule)
    if altitude > HIGHEST:
        raise InputError(field, value, f"must be at most {HIGHEST:.0f} km")
    return altitude


def _triple(most: float, unit: str) -> Reader[tuple[float, ...]]:
    """A reader of three numbers, none of them larger than `most` either way."""

    def reader(field: str, value: Vector3) -> tuple[float, ...]:
        exact = inputs.certain(field, inputs.vector(field, value, 3))
        numbers = tuple(inputs.doubles(field, exact))
        for k, number in enumerate(numbers):
            if abs(number) > most:
                raise InputError(f"{field}[{k}]", number, f"must be at most {most:g} {unit}")
        return numbers

    return reader


def _size(field: str, value: Vector3) -> tuple[float, ...]:
    edges = _LENGTHS(field, value)
    for k, edge in enumerate(edges):
        if edge <= 0:
            raise InputError(f"{field}[{k}]", edge, "must be above zero")
    return edges


def _switch(field: str, value: object) -> bool:
    if not isinstance(value, bool):
        raise InputError(field, repr(value), "must be true or false")
    return value


def _instant(field: str, value: object) -> datetime:
    if not isinstance(value, datetime):
        raise InputError(field, repr(value), "must be a date and time, 2013-07-17T12:00:00Z")
    try:
        return value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)
    except OverflowError:
        raise InputError(field, value.isoformat(), "must be in the years 1 to 9999, UTC") from None


def _seconds(field: str, value: ExactNumber) -> Fraction:
    number = inputs.exact(field, value)
    if not 0 < number <= LONGEST:
        raise InputError(field, value, f"must be above zero, and at most {LONGEST} s")
    if number < SHORTEST:
        raise InputError(field, value, f"must be at least {float(SHORTEST):g} s")
    return number


def _check_sunlight(craft: Spacecraft) -> None:
    if craft.specular + craft.diffuse > 1:
        rule = "with specular, must not be more than all of the light"
        raise InputError("spacecraft.diffuse", craft.diffuse, rule)


def _check_wheels(wheels: Wheels) -> None:
    for k, momentum in enumerate(wheels.momentum):
        if wheels.max_momentum is not None and abs(momentum) > wheels.max_momentum:
            rule = "is more than wheels.max_momentum"
            raise InputError(f"wheels.momentum[{k}]", momentum, rule)


def _check_samples(run: Timing) -> None:
    if run.period > run.length:
        raise InputError("run.period", float(run.period), "must not be longer than run.length")
    if run.length / run.period > MOST_SAMPLES:
        raise InputError("run.period", float(run.period), f"is for {MOST_SAMPLES} samples at most")


_ANY = float("inf")
_ABOVE = _between(0, _ANY, "must be above zero", open_below=True)
_NOT_NEGATIVE = _between(0, _ANY, "must not be negative")
_LENGTHS = _triple(MOST_METRES, "m")
_SHARE = _between(0, 1, "must be a share, from 0 to 1")
_TURN = _between(-360, 360, "must be an angle in degrees, from -360 to 360")

_READERS: dict[str, tuple[type, Mapping[str, Reader[object]]]] = {
    "orbit": (
        Orbit,
        {
            "altitude": _altitude,
            "inclination": _between(0, 180, "must be from 0 to 180 degrees"),
            "node": _TURN,
            "latitude_argument": _TURN,
            "epoch": _instant,
        },
    ),
    "wheels": (
        Wheels,
        {
            "max_torque": _ABOVE,
            "max_torque_rate": _between(
                LEAST_RATE, MOST_RATE, f"must be from {LEAST_RATE:g} to {MOST_RATE:g} N m/s"
            ),
            "max_momentum": _between(
                0,
                MOST_MOMENTUM,
                f"must be above zero, and at most {MOST_MOMENTUM:g} N m s",
                open_below=True,
            ),
            "momentum": _triple(MOST_MOMENTUM, "N m s"),
            "rotor_inertia": _ABOVE,
        },
    ),
    "thrusters": (
        Thrusters,
        {"torque": _ABOVE, "min_impulse": _NOT_NEGATIVE, "centred": _switch},
    ),
    "controller": (
        Controller,
        {
            "natural_frequency": _NOT_NEGATIVE,
            "damping_ratio": _NOT_NEGATIVE,
            "feedforward": _switch,
            "track_feedforward": _switch,
        },
    ),
    "spacecraft": (
        Spacecraft,
        {
            "size": _size,
            "offset": _LENGTHS,
            "drag_coefficient": _between(0, MOST_DRAG, f"must be from 0 to {MOST_DRAG:g}"),
            "specular": _SHARE,
            "diffuse": _SHARE,
            "dipole": _triple(MOST_DIPOLE, "A m^2"),
        },
    ),
    "disturbances": (Disturbances, dict.fromkeys(Disturbances.__slots__, _switch)),
    "run": (
        Timing,
        {
            "length": _seconds,
            "period": _seconds,
            "tolerance": _between(1e-14, 1e-3, "must be from 1e-14 to 1e-3"),
            "settled": _ABOVE,
        },
    ),
}
