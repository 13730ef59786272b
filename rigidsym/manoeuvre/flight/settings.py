"""What is flown and where: every number that a flight needs, with its source.

"paper" below is the caption of the paper's Figure 3.  The paper prints nothing else: what is not
marked so is a choice made here, with its reason.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from fractions import Fraction

Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Orbit:
    """A circular orbit of Kepler around a spherical Earth."""

    altitude: float = 600.0
    "Above the equatorial radius, km (paper)."
    inclination: float = 97.79
    "Degrees (paper)."
    node: float = 0.0
    "Right ascension of the ascending node, degrees (chosen)."
    latitude_argument: float = 45.0
    "From the ascending node at t = 0, degrees (chosen: in sunlight, so that all disturbances act)."
    epoch: datetime = datetime(2013, 7, 17, 12, tzinfo=UTC)
    "The instant t = 0 (chosen: any would do); the Sun, the Earth's turn and its field follow."


@dataclass(frozen=True, slots=True)
class Wheels:
    """Three reaction wheels along the principal axes; what holds for each."""

    max_torque: float = 1e-3
    "N m (paper)."
    max_torque_rate: float = 1e-2
    "N m/s (paper); files may have from 1e-12 to 1e12."
    max_momentum: float | None = None
    "N m s that a wheel can store; None: no limit (the paper gives none)."
    momentum: Triple = (0.0, 0.0, 0.0)
    "Stored at t = 0, N m s (chosen)."
    rotor_inertia: float = 2e-6
    "Of a wheel about its own axis, kg m^2, for its speed (chosen: 1e-3 N m s at 4800 rpm)."


@dataclass(frozen=True, slots=True)
class Thrusters:
    """Pairs along the principal axes that push against the outside, on or off."""

    torque: float = 1e-3
    "Of a pair while it burns, N m (chosen: as much as the wheels')."
    min_impulse: float = 1e-6
    "Minimum impulse bit of a pair, N m s (chosen: 1 ms of it)."
    centred: bool = True
    "Whether burns are centred on the instants of the bursts; else they begin there."


@dataclass(frozen=True, slots=True)
class Controller:
    """Proportional and derivative feedback of the attitude, gains in proportion to the inertia.

    On each axis the error decays as that of an oscillator, whatever the inertia: the gains are
    natural_frequency^2 I and 2 damping_ratio natural_frequency I.  The paper prints none.
    """

    natural_frequency: float = 0.3
    "rad/s; zero: no control (chosen: bursts of some 10 s, below half of the wheels' torque)."
    damping_ratio: float = 1.0
    "Critical: the fastest return without oscillation (chosen)."
    feedforward: bool = False
    "Whether to cancel the wheels' gyroscopic torque as well (the paper has PD alone)."
    track_feedforward: bool = False
    "Whether to exert the torque of the track, bursts included, ahead of errors (the paper: no)."


@dataclass(frozen=True, slots=True)
class Spacecraft:
    """What the environment acts upon: a box whose middle is beside the centre of mass."""

    size: Triple = (0.34, 0.1, 0.1)
    "Edges along the body axes, m (chosen: three CubeSat units, the long axis the lightest)."
    offset: Triple = (0.02, 0.02, 0.02)
    "From the centre of mass to the box's middle, m (chosen: as much as CubeSats may have)."
    drag_coefficient: float = 2.2
    "Of flat plates in free molecular flow (Vallado, section 8.6.2)."
    specular: float = 0.1
    "Share of sunlight that is reflected as by a mirror (chosen: solar cells)."
    diffuse: float = 0.1
    "Share of sunlight that is scattered (chosen: solar cells)."
    dipole: Triple = (0.01, 0.01, 0.01)
    "Residual magnetic dipole, A m^2 (chosen: usual for nano-spacecraft without compensation)."


@dataclass(frozen=True, slots=True)
class Disturbances:
    """Which of the disturbances act; the paper has all four."""

    drag: bool = True
    gravity_gradient: bool = True
    radiation: bool = True
    dipole: bool = True


@dataclass(frozen=True, slots=True)
class Timing:
    """How long, how often, how exactly."""

    length: Fraction = Fraction(180)
    "s (the paper's Figure 3)."
    period: Fraction = Fraction(1, 10)
    "Of control, and of what is recorded, s (chosen: usual, and a thirtieth of the loop's time)."
    tolerance: float = 1e-10
    "Relative, of the integration (chosen: far below what is looked at)."
    settled: float = 0.1
    "Degrees: nearer than that the spacecraft counts as settled (chosen)."


@dataclass(frozen=True, slots=True)
class Flight:
    """All of it; `Flight()` is the paper's."""

    orbit: Orbit = field(default_factory=Orbit)
    wheels: Wheels = field(default_factory=Wheels)
    controller: Controller = field(default_factory=Controller)
    spacecraft: Spacecraft = field(default_factory=Spacecraft)
    disturbances: Disturbances = field(default_factory=Disturbances)
    run: Timing = field(default_factory=Timing)
    thrusters: Thrusters | None = None
    "None: wheels alone, as in the paper.  With them bursts are theirs."
    message: Mapping[str, str] = field(default_factory=dict)
    "What a message of the flight says of itself: see `rigidsym.io.messages`."
