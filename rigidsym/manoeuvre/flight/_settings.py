"""Settings of a flight with their sources, and how manoeuvre files change them.

"paper" below is the caption of the paper's Figure 3.  The paper prints nothing else: what is not
marked so is a choice made here, with its reason.

Each field states its rule in its type, and `read` has pydantic check the tables of a file by these
types.  Pydantic is chosen because it works on plain dataclasses, which stay unchecked and cheap
where code makes them (`dataclasses.replace`), because a rule may be a function of the value as the
file has it (a float, or a string or fraction taken exactly), and because an error is data (path,
value, rule), from which InputError makes one line.  attrs checks whatever is constructed, msgspec
has rules for its own types alone and no values in its errors, cattrs leaves rules to its users.
"""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, replace
from datetime import UTC, datetime
from fractions import Fraction
from typing import Annotated, Any

from pydantic import AfterValidator, PlainValidator, ValidationError

from rigidsym import _inputs as inputs
from rigidsym.errors import InputError
from rigidsym.io import _attitude_ephemeris as ephemeris
from rigidsym.io._files import TomlTable, subtable

MOST_SAMPLES = 1_000_000
LONGEST = 100_000
"s: some seventeen orbits, over which the circular one stays what it is."
SHORTEST = Fraction(1, 10**9)
"s, of a flight and of a period of control: beyond any wheels."
LOWEST, HIGHEST = 100.0, 100_000.0
"""km: below, the air lets no circular orbit last; above, the models of the Earth's field and of its
atmosphere do not hold."""
LEAST_RATE, MOST_RATE = 1e-12, 1e12
"N m/s: with the first, a day makes 1e-7 N m, as little as what disturbs; the second is no limit."
# Far beyond what flies: more is a slip of units.
MOST_MOMENTUM = 1e6
MOST_DIPOLE = 1e6
MOST_DRAG = 100.0
MOST_METRES = 1e3

Triple = tuple[float, float, float]
# A condition, and the words for it.
Rule = tuple[Callable[[Any], bool], str]


def _read(read: Callable[[Any], Any], *rules: Rule) -> PlainValidator:
    """Return a Pydantic validator that reads a value and checks it by rules.

    Each part of a tuple is checked.
    """

    def found(value: Any) -> Any:
        number = read(value)
        several = isinstance(number, tuple)
        for k, one in enumerate(number if several else (number,)):
            for holds, rule in rules:
                if not holds(one):
                    raise InputError(f"[{k}]" if several else "", one if several else value, rule)
        return number

    return PlainValidator(found)


def _number(*rules: Rule) -> PlainValidator:
    """Return a Pydantic validator that checks a double by rules."""
    return _read(lambda value: inputs.doubles("", [inputs.exact("", value)])[0], *rules)


def _triple(*rules: Rule) -> PlainValidator:
    """Return a Pydantic validator that checks each of three doubles by rules."""

    def read(value: Any) -> tuple[float, ...]:
        return tuple(inputs.doubles("", inputs.certain("", inputs.vector("", value, 3))))

    return _read(read, *rules)


def _instant(value: object) -> datetime:
    if not isinstance(value, datetime):
        raise InputError("", repr(value), "must be a date and time, 2013-07-17T12:00:00Z")
    try:
        return value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)
    except OverflowError:
        raise InputError("", value.isoformat(), "must be in the years 1 to 9999, UTC") from None


def _within(most: float, unit: str) -> Rule:
    return lambda x: abs(x) <= most, f"must be at most {most:g} {unit}"


def _between(low: float, high: float, what: str = "", unit: str = "") -> PlainValidator:
    """Return a Pydantic validator of a double in a range.

    `what` and `unit` are words for the message.
    """
    return _number((lambda x: low <= x <= high, f"must be {what}from {low:g} to {high:g}{unit}"))


_ABOVE: Rule = (lambda x: x > 0, "must be above zero")
_LENGTH = _within(MOST_METRES, "m")
_ALTITUDE = (
    (lambda x: x > 0, "must be above the surface, km"),
    (lambda x: x >= LOWEST, f"must be at least {LOWEST:.0f} km: no circular orbit lasts below"),
    (lambda x: x <= HIGHEST, f"must be at most {HIGHEST:.0f} km"),
)
_STORABLE = (
    lambda x: 0 < x <= MOST_MOMENTUM,
    f"must be above zero, and at most {MOST_MOMENTUM:g} N m s",
)
_SECONDS = (
    (lambda x: 0 < x <= LONGEST, f"must be above zero, and at most {LONGEST} s"),
    (lambda x: x >= SHORTEST, f"must be at least {float(SHORTEST):g} s"),
)
_TOLERANCE = (lambda x: 1e-14 <= x <= 1e-3, "must be from 1e-14 to 1e-3")
Positive = Annotated[float, _number(_ABOVE)]
NotNegative = Annotated[float, _number((lambda x: x >= 0, "must not be negative"))]
Share = Annotated[float, _between(0, 1, "a share, ")]
Turn = Annotated[float, _between(-360, 360, "an angle in degrees, ")]
Seconds = Annotated[Fraction, _read(lambda value: inputs.exact("", value), *_SECONDS)]
Switch = Annotated[bool, PlainValidator(lambda value: inputs.is_true("", value))]


@dataclass(frozen=True, slots=True)
class Orbit:
    """A circular Kepler orbit around a spherical Earth."""

    altitude: Annotated[float, _number(*_ALTITUDE)] = 600.0
    "Above the equatorial radius, km (paper)."
    inclination: Annotated[float, _between(0, 180, unit=" degrees")] = 97.79
    "Degrees (paper)."
    node: Turn = 0.0
    "Right ascension of the ascending node, degrees (chosen)."
    latitude_argument: Turn = 45.0
    "From the ascending node at t = 0, degrees (chosen: in sunlight, so that all disturbances act)."
    epoch: Annotated[datetime, PlainValidator(_instant)] = datetime(2013, 7, 17, 12, tzinfo=UTC)
    "The instant t = 0 (chosen: any would do); the Sun, the Earth's turn and its field follow."


@dataclass(frozen=True, slots=True)
class Wheels:
    """Three equal reaction wheels along the principal axes."""

    max_torque: Positive = 1e-3
    "N m (paper)."
    max_torque_rate: Annotated[float, _between(LEAST_RATE, MOST_RATE, unit=" N m/s")] = 1e-2
    "N m/s (paper)."
    max_momentum: Annotated[float, _number(_STORABLE)] | None = None
    "N m s that a wheel can store; None: no limit (the paper gives none)."
    momentum: Annotated[Triple, _triple(_within(MOST_MOMENTUM, "N m s"))] = (0.0, 0.0, 0.0)
    "Stored at t = 0, N m s (chosen)."
    rotor_inertia: Positive = 2e-6
    "Of a wheel about its own axis, kg m^2, for its speed (chosen: 1e-3 N m s at 4800 rpm)."


@dataclass(frozen=True, slots=True)
class Thrusters:
    """Pairs of on-off thrusters along the principal axes."""

    torque: Positive = 1e-3
    "Of a pair while it burns, N m (chosen: as much as the wheels')."
    min_impulse: NotNegative = 1e-6
    "Minimum impulse bit of a pair, N m s (chosen: 1 ms of it)."
    centred: Switch = True
    "Whether burns are centred on the instants of the bursts; else they begin there."


@dataclass(frozen=True, slots=True)
class Controller:
    """Proportional-derivative feedback of the attitude, with gains proportional to inertia.

    On each axis the error decays as that of an oscillator, whatever the inertia: the gains are
    natural_frequency^2 I and 2 damping_ratio natural_frequency I.  The paper prints none.
    """

    natural_frequency: NotNegative = 0.3
    "rad/s; zero: no control (chosen: bursts of some 10 s, below half of the wheels' torque)."
    damping_ratio: NotNegative = 1.0
    "Critical: the fastest return without oscillation (chosen)."
    feedforward: Switch = False
    "Whether to cancel the wheels' gyroscopic torque as well (the paper has PD alone)."
    track_feedforward: Switch = False
    "Whether to exert the torque of the track, bursts included, ahead of errors (the paper: no)."


@dataclass(frozen=True, slots=True)
class Spacecraft:
    """The box-shaped spacecraft on which the environment acts.

    Its middle is beside the centre of mass.
    """

    size: Annotated[Triple, _triple(_LENGTH, _ABOVE)] = (0.34, 0.1, 0.1)
    "Edges along the body axes, m (chosen: three CubeSat units, the long axis the lightest)."
    offset: Annotated[Triple, _triple(_LENGTH)] = (0.02, 0.02, 0.02)
    "From the centre of mass to the box's middle, m (chosen: as much as CubeSats may have)."
    drag_coefficient: Annotated[float, _between(0, MOST_DRAG)] = 2.2
    "Of flat plates in free molecular flow (Vallado, section 8.6.2)."
    specular: Share = 0.1
    "Share of sunlight that is reflected as by a mirror (chosen: solar cells)."
    diffuse: Share = 0.1
    "Share of sunlight that is scattered (chosen: solar cells)."
    dipole: Annotated[Triple, _triple(_within(MOST_DIPOLE, "A m^2"))] = (0.01, 0.01, 0.01)
    "Residual magnetic dipole, A m^2 (chosen: usual for nano-spacecraft without compensation)."


@dataclass(frozen=True, slots=True)
class Disturbances:
    """Switches of the four disturbance torques.

    The paper has all of them.
    """

    drag: Switch = True
    gravity_gradient: Switch = True
    radiation: Switch = True
    dipole: Switch = True


@dataclass(frozen=True, slots=True)
class Timing:
    """Length, sampling and accuracy of a flight."""

    length: Seconds = Fraction(180)
    "s (the paper's Figure 3)."
    period: Seconds = Fraction(1, 10)
    "Of control, and of what is recorded, s (chosen: usual, and a thirtieth of the loop's time)."
    tolerance: Annotated[float, _number(_TOLERANCE)] = 1e-10
    "Relative, of the integration (chosen: far below the errors of interest)."
    settled: Positive = 0.1
    "Degrees: nearer than that the spacecraft counts as settled (chosen)."


def _storable(wheels: Wheels) -> Wheels:
    most = float("inf") if wheels.max_momentum is None else wheels.max_momentum
    for k, momentum in enumerate(wheels.momentum):
        if abs(momentum) > most:
            raise InputError(f".momentum[{k}]", momentum, "is more than wheels.max_momentum")
    return wheels


def _scattered(craft: Spacecraft) -> Spacecraft:
    if craft.specular + craft.diffuse > 1:
        rule = "with specular, must not be more than all of the light"
        raise InputError(".diffuse", craft.diffuse, rule)
    return craft


def _sampled(run: Timing) -> Timing:
    if run.period > run.length:
        raise InputError(".period", float(run.period), "must not be longer than run.length")
    if run.length / run.period > MOST_SAMPLES:
        raise InputError(".period", float(run.period), f"is for {MOST_SAMPLES} samples at most")
    return run


@dataclass(frozen=True, slots=True)
class Flight:
    """All settings of a flight.

    `Flight()` is the paper's.
    """

    orbit: Orbit = field(default_factory=Orbit)
    wheels: Annotated[Wheels, AfterValidator(_storable)] = field(default_factory=Wheels)
    controller: Controller = field(default_factory=Controller)
    spacecraft: Annotated[Spacecraft, AfterValidator(_scattered)] = field(
        default_factory=Spacecraft
    )
    disturbances: Disturbances = field(default_factory=Disturbances)
    run: Annotated[Timing, AfterValidator(_sampled)] = field(default_factory=Timing)
    thrusters: Thrusters | None = None
    "None: wheels alone, as in the paper.  With them bursts are theirs."
    message: Mapping[str, str] = field(default_factory=dict)
    "What a message of the flight says of itself: see `rigidsym.io._attitude_ephemeris`."


_NAMES = {
    name: tuple(table)
    for name, table in asdict(Flight(thrusters=Thrusters())).items()
    if name != "message"
}


def read(tables: TomlTable) -> Flight:
    """Read the settings of a flight from the tables of a manoeuvre file.

    The tables are [orbit], [wheels] and so on.

    What is missing is the paper's.  With [thrusters] and no [controller] there is no feedback.

    Parameters
    ----------
    tables : mapping
        All tables of the file as TOML gives them; those of other names are left alone.

    Raises
    ------
    InputError
        For the first unknown key or bad value.
    """
    # Its import takes a while, which flights that are not read from files do without.
    from pydantic import TypeAdapter

    settings = {
        name: dict(subtable(name, tables[name], known))
        for name, known in _NAMES.items()
        if name in tables
    }
    for name, table in settings.items():
        for key, value in table.items():
            # TOML has no None, which pydantic would take for a default.
            if value is None:
                raise InputError(f"{name}.{key}", value, "must be a number")
    if "thrusters" in tables:
        settings.setdefault("controller", {"natural_frequency": 0.0})
    try:
        flight = TypeAdapter(Flight).validate_python(settings)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        cause = first["ctx"]["error"]
        path = ".".join(map(str, first["loc"]))
        raise InputError(path + cause.field, cause.value, cause.rule) from None
    message = ephemeris.message_fields(tables.get("message", {}), ephemeris.MISSION_FIELDS)
    return replace(flight, message=message)
