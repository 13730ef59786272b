"""Manoeuvres from one attitude to another within limits, and their files."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from importlib import resources
from itertools import combinations
from pathlib import Path
from typing import Any

from rigidsym import _inputs as inputs
from rigidsym._inputs import ExactNumber, Quaternion, Vector3
from rigidsym.errors import InputError
from rigidsym.io import _files as files

PAPER = "paper.toml"
"The file of the package."
REST = (0, 0, 0)
FLIGHT = frozenset(
    ("orbit", "wheels", "thrusters", "controller", "spacecraft", "disturbances", "run", "message")
)
"Tables of a file for the flight, fields of `flight.settings.Flight`; planners leave them alone."
_NEEDED = ("inertia", "start", "target")
OWN = {*_NEEDED, "duration", "spin", "limits", "degrees"}
# Doubles can hold such numbers, and products of three of them.
_LARGEST = 10**60


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of the body rate and of the bursts of a manoeuvre.

    None stands for no limit.
    """

    max_rate: Fraction | None = None
    "Greatest body rate at any time of the motion, |omega|, rad/s."
    max_burst: Fraction | None = None
    "Greatest size of either burst, the change of momentum that it makes, N m s."


@dataclass(frozen=True, slots=True)
class Manoeuvre:
    """An attitude manoeuvre of a rigid body from `start` to `target`.

    start, target: quaternions, scalar first, body to inertial.

    inertia: principal moments, kg m^2.  duration: s; None for the shortest that the limits allow.
    start_spin, target_spin: body rates before the first burst and after the last, rad/s.
    All numbers are exact; `manoeuvre` and `parse` make one from numbers of users.
    """

    inertia: tuple[Fraction, ...]
    start: tuple[Fraction, ...]
    target: tuple[Fraction, ...]
    duration: Fraction | None
    start_spin: tuple[Fraction, ...] = (Fraction(0),) * 3
    target_spin: tuple[Fraction, ...] = (Fraction(0),) * 3
    limits: Limits = Limits()

    def __repr__(self) -> str:
        from rigidsym.view._motions import manoeuvre_text

        return manoeuvre_text(self)

    @property
    def trivial(self) -> bool:
        """True if the body rests at the target attitude from the beginning.

        Quaternions are compared up to their sign and length.
        """
        pairs = combinations(zip(self.start, self.target, strict=True), 2)
        turned = any(p * s != q * r for (p, q), (r, s) in pairs)
        return not (turned or any(self.start_spin) or any(self.target_spin))

    def to_data(self) -> dict[str, Any]:
        """Return the tables of a manoeuvre file, with exact numbers as strings."""

        def text(value: Fraction | tuple[Fraction, ...] | None) -> Any:
            if isinstance(value, tuple):
                return [inputs.exact_text(one) for one in value]
            return None if value is None else inputs.exact_text(value)

        limits = {"max_rate": self.limits.max_rate, "max_burst": self.limits.max_burst}
        return {
            "inertia": text(self.inertia),
            "start": text(self.start),
            "target": text(self.target),
            "duration": text(self.duration),
            "spin": {"start": text(self.start_spin), "target": text(self.target_spin)},
            "limits": {name: text(x) for name, x in limits.items() if x is not None},
        }


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
    """Create a manoeuvre from a user's numbers.

    Raises InputError for the first invalid number.

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
    spins = []
    for field, values in (("spin.start", start_spin), ("spin.target", target_spin)):
        spin = inputs.certain(field, inputs.vector(field, values, 3))
        if any(abs(x) > _LARGEST for x in spin):
            raise InputError(field, inputs.shown(spin), "must not be beyond 1e60")
        spins.append(_in_radians(spin) if turned else spin)
    return Manoeuvre(
        _moderate("inertia", inputs.certain("inertia", inputs.inertia(inertia, next_step=""))),
        inputs.certain("start", inputs.attitude(start, "start")),
        inputs.certain("target", inputs.attitude(target, "target")),
        length,
        *spins,
        limits,
    )


def above_zero(field: str, value: ExactNumber) -> Fraction:
    """Read a positive exact number.

    Raises InputError for one that is too large or too small for doubles.
    """
    number = inputs.exact(field, value)
    if number <= 0:
        raise InputError(field, value, "must be above zero")
    return _moderate(field, (number,))[0]


def _in_radians(values: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Convert rates from deg/s to rad/s and round them to doubles.

    Files can hold doubles in a few digits.
    """
    exact = inputs.certain("degrees", inputs.in_radians(values))
    return tuple(Fraction(float(x)) for x in exact)


def _moderate(field: str, values: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    """Check that numbers are from 1e-60 to 1e60 and return them unchanged.

    Raises InputError for any other number.
    """
    if any(not 1 <= x * _LARGEST <= _LARGEST**2 for x in values):
        raise InputError(field, inputs.shown(values), "must be from 1e-60 to 1e60")
    return values


def open_manoeuvre(name: str) -> tuple[Manoeuvre, files.TomlTable]:
    """Read a manoeuvre file.

    Return the manoeuvre, and all tables of the file as TOML gives them.

    The name `paper` means the file of the package.  Raises InputError about the first error in the
    manoeuvre itself.
    """
    if name == "paper":
        text = resources.files("rigidsym.manoeuvre").joinpath(PAPER).read_text("utf-8")
    else:
        text = files.read_text("manoeuvre", Path(name))
    tables = files.parse_toml("manoeuvre", text)
    return parse(tables, FLIGHT), tables


def parse(tables: files.TomlTable, others: frozenset[str] = frozenset()) -> Manoeuvre:
    """Create a manoeuvre from the TOML tables of a file.

    Numbers may be floats or decimal strings.

    others: names of further tables that the file may have.
    """
    files.check_keys("manoeuvre", tables, OWN | others, _NEEDED)
    spin = files.subtable("spin", tables.get("spin", {}), ("start", "target"))
    limits = files.subtable("limits", tables.get("limits", {}), Limits.__slots__)
    return manoeuvre(
        *(tables[key] for key in _NEEDED),
        tables.get("duration"),
        start_spin=spin.get("start", REST),
        target_spin=spin.get("target", REST),
        **limits,
        degrees=tables.get("degrees", False),
    )
