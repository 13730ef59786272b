"""Ways to the target, each flown by the same actuators, through the same disturbances.

Wheels fly as `rigidsym track` does; what is known of a track ahead, its torque and its bursts, is
fed forward, but where feedback alone is looked at.  Thrusters are flown with wheels that cancel
what is felt of their own momentum (`feedforward`): the body moves as if they stored none, and what
is counted is the torque without that part, which is what thrusters would exert.
"""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from math import e

import numpy as np
from scipy.special import lambertw

from rigidsym.manoeuvre.comparison import tracks
from rigidsym.manoeuvre.comparison.cases import Case
from rigidsym.manoeuvre.comparison.collocation import Model
from rigidsym.manoeuvre.comparison.collocation.driven import Driven
from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh
from rigidsym.manoeuvre.flight.control import Track
from rigidsym.manoeuvre.flight.fly import fly
from rigidsym.manoeuvre.flight.rotation import angle
from rigidsym.manoeuvre.flight.run import Run
from rigidsym.manoeuvre.flight.settings import Controller, Flight, Timing
from rigidsym.manoeuvre.transfer import Transfer

HOLD = 60
"s that the target is held after the manoeuvre's duration."
PERIOD = Fraction(1, 5)
"Of control, s: a sixteenth of the loop's time, and half the work of the paper's flight."


@dataclass(frozen=True, slots=True)
class Ways:
    """What the ways of a case are made of: its cheapest natural motion, and what drives that of
    least fuel for the actuators that fly, impulses without units on the mesh of collocation."""

    case: Case
    actuators: Model
    transfer: Transfer
    impulses: np.ndarray

    @property
    def flight(self) -> Flight:
        """That of the paper, as long as it takes."""
        length = Fraction(self.case.duration) + HOLD
        controller = Controller(feedforward=self.actuators is Model.THRUSTERS)
        return Flight(run=Timing(length=length, period=PERIOD), controller=controller)

    @property
    def foreseen(self) -> Flight:
        """The same with the torque of the track, bursts included, fed forward."""
        controller = Controller(feedforward=True, track_feedforward=True)
        return replace(self.flight, controller=controller)


@dataclass(frozen=True, slots=True)
class Flown:
    """torque_integral: of |torque|, summed over the axes, N m s.  torque_square: the integral of
    torque^2, summed as well, N^2 m^2 s.  torque_peak: of any axis, N m.
    errors: degrees from the target when the duration is over, and at the end of the hold.
    saturated: whether a wheel reached its limit."""

    torque_integral: float
    torque_square: float
    torque_peak: float
    error_at_duration: float
    error_after_hold: float
    saturated: bool

    def to_data(self) -> dict[str, float]:
        """For files."""
        return asdict(self)


def natural(ways: Ways) -> tuple[Track, Flight]:
    """The cheapest natural motion."""
    return ways.transfer, ways.foreseen


def pursued(ways: Ways) -> tuple[Track, Flight]:
    """The same by feedback alone, which falls behind each burst and catches up."""
    return ways.transfer, ways.flight


def optimum(ways: Ways) -> tuple[Track, Flight]:
    """The motion of least fuel, by collocation."""
    case = ways.case
    driven = Driven(ways.actuators, case.inertia / case.inertia.max(), ways.impulses, Mesh())
    return tracks.Followed(case.duration, tracks.placed(case, driven)), ways.foreseen


def eigenaxis(ways: Ways) -> tuple[Track, Flight]:
    """The eigenaxis at constant rate."""
    return tracks.eigenaxis(ways.case, tracks.constant), ways.foreseen


def smooth(ways: Ways) -> tuple[Track, Flight]:
    """The eigenaxis by a cubic, from rest to rest."""
    return tracks.eigenaxis(ways.case, tracks.smooth), ways.foreseen


def step(ways: Ways) -> tuple[Track, Flight]:
    """Quaternion feedback straight to the target, the gains as for all others: it is much faster
    than asked."""
    return tracks.eigenaxis(ways.case, tracks.step), ways.flight


def slow_step(ways: Ways) -> tuple[Track, Flight]:
    """The same with gains so low that it takes the duration, and that stay so for the hold."""
    track, flight = step(ways)
    within = np.radians(flight.run.settled)
    frequency = slowest(ways.case.angle, within) / ways.case.duration
    return track, replace(
        flight, controller=replace(flight.controller, natural_frequency=frequency)
    )


METHODS: Mapping[str, Callable[[Ways], tuple[Track, Flight]]] = {
    "natural": natural,
    "natural, feedback alone": pursued,
    "eigenaxis": eigenaxis,
    "eigenaxis, smooth": smooth,
    "optimum": optimum,
    "step": step,
    "step, slow": slow_step,
}
"By the names of the report."


def flown(method: str, ways: Ways) -> Flown:
    """Fly a way and measure it; raises InputError where torques are too wild to follow."""
    track, flight = METHODS[method](ways)
    return measured(fly(ways.case.manoeuvre, flight, track), flight, ways.actuators)


def measured(run: Run, flight: Flight, actuators: Model) -> Flown:
    """The figures of a flight."""
    size = np.abs(exerted(run, actuators))
    errors = np.degrees(angle(run.reference.q[-1], run.q))
    return Flown(
        torque_integral=float(np.trapezoid(size, run.t, axis=0).sum()),
        torque_square=float(np.trapezoid(size**2, run.t, axis=0).sum()),
        torque_peak=float(size.max()),
        error_at_duration=float(errors[np.searchsorted(run.t, run.arrival)]),
        error_after_hold=float(errors[-1]),
        saturated=bool(np.abs(run.torque).max() >= flight.wheels.max_torque),
    )


def exerted(run: Run, actuators: Model) -> np.ndarray:
    """The torques (N, 3) of a flight that count, N m."""
    if actuators is Model.WHEELS:
        return run.torque
    return run.torque - np.cross(run.omega, run.wheel_momentum)


def slowest(turn: float, within: float) -> float:
    """The natural frequency times the time in which a critically damped oscillator that is `turn`
    off comes `within` (rad): (1 + x) exp(-x) = within / turn, by Lambert's function."""
    return float(-1 - lambertw(-within / turn / e, -1).real) if turn > within else 1.0
