"""Random manoeuvres, and the control methods that fly them with the same actuators.

Every other manoeuvre is with the paper's body; all are from rest to rest, and all flights through
the same disturbances.  Wheels fly as `rigidsym track` does.  The torque of a track and its bursts
are fed forward, except in the ways by feedback alone.  Thrusters are flown with wheels that cancel
the gyroscopic torque of their own momentum (`feedforward`): the body moves as if the wheels stored
none, and the torque without that part is counted, which is what thrusters would exert.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, partial
from math import ceil, e
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import lambertw

from rigidsym._engines import engine
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._comparison.collocation import MESH, Driven, Guess, Model
from rigidsym.manoeuvre._manoeuvre import Manoeuvre, manoeuvre
from rigidsym.manoeuvre._problem import Problem, problem, unit
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._control import Track
from rigidsym.manoeuvre.flight._fly import fly
from rigidsym.manoeuvre.flight._rotation import angle
from rigidsym.manoeuvre.flight._run import Run
from rigidsym.manoeuvre.flight._settings import Controller, Flight, Timing
from rigidsym.quaternions import product

PAPER = ("0.0109", "0.04", "0.0506")
"Principal moments of the paper's Figure 3, kg m^2."
LARGEST_MOMENTS = 0.02, 0.06
"Range of the largest moment of random bodies, kg m^2: nano-spacecraft as well."
IMPULSE = 1e-3
"""N m s: it decides durations.  In a duration the whole angle can be turned about the axis of the
largest moment at constant rate with this momentum.  A burst of it takes a wheel of the paper 1 s
at its limit; the paper's controller takes 60 percent of the limit, 2 zeta omega_n times it."""
ROUNDED, SHORTEST = 10, 60
"s: durations are whole multiples of the first, and at least the second, 18 times the loop's."
_DIGITS = 6
HOLD = 60
"Time for which the target is held after the manoeuvre's duration, s."
PERIOD = Fraction(1, 5)
"Period of control, s: a sixteenth of the loop's time, and half the work of the paper's flight."
FAMILIES = 10
"Number of natural motions from which the least sum over axes is taken."
AHEAD = Controller(feedforward=True, track_feedforward=True)
"Feedback with the torque of the track, bursts included, fed forward."
_SAMPLES = 2001

# From times from 0 to 1 (N,) to shares of a turn and their derivatives.
Profile = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True)
class Case:
    """A random manoeuvre of the comparison.

    `body` is "paper" or "random".
    """

    index: int
    body: str
    manoeuvre: Manoeuvre

    @cached_property
    def problem(self) -> Problem:
        """The dimensionless boundary-value problem of the manoeuvre.

        No motion is computed with its engine.
        """
        asked = self.manoeuvre
        return problem(asked.inertia, asked.start, asked.target, engine("numpy"))

    @cached_property
    def inertia(self) -> np.ndarray:
        """Principal moments (3,), kg m^2."""
        return np.array([float(x) for x in self.manoeuvre.inertia])

    @property
    def duration(self) -> float:
        """Time from the first burst to the last, in s."""
        return float(self.manoeuvre.duration or 0)

    @cached_property
    def start(self) -> np.ndarray:
        """Attitude (4,) at t = 0, of length 1."""
        return unit(self.manoeuvre.start)

    @property
    def rotation_vector(self) -> np.ndarray:
        """Rotation vector (3,) of the shorter turn from start to target, in rad."""
        vector = self.problem.turn[1:]
        return self.problem.angle * vector / np.linalg.norm(vector)

    def to_data(self) -> dict[str, Any]:
        """Return the entries of this case in the schema rigidsym.comparison/1."""
        return {
            "index": self.index,
            "body": self.body,
            "angle": float(np.degrees(self.problem.angle)),
            "manoeuvre": self.manoeuvre.to_data(),
        }


def draw(index: int, seed: int) -> Case:
    """Draw the random manoeuvre with a given index.

    Attitudes are spread evenly over all rotations, and rounded to six decimals.
    """
    rng = np.random.default_rng([seed, index])
    body = "random" if index % 2 else "paper"
    start, target = (_rounded(rng.normal(size=4)) for _ in range(2))
    inertia = PAPER
    if body == "random":
        # Moments of a positive distribution of mass.
        x, y, z = rng.uniform(0.05, 1, size=3)
        moments = np.array([y + z, z + x, x + y])
        inertia = _rounded(moments * rng.uniform(*LARGEST_MOMENTS) / moments.max())
    quickest = Case(index, body, manoeuvre(inertia, start, target, SHORTEST))
    impulse = quickest.inertia.max() * quickest.problem.angle
    duration = max(SHORTEST, ROUNDED * ceil(impulse / IMPULSE / ROUNDED))
    return Case(index, body, manoeuvre(inertia, start, target, duration))


def _rounded(values: np.ndarray) -> tuple[str, ...]:
    return tuple(f"{x:.{_DIGITS}f}" for x in values.tolist())


def constant(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the profile of a turn at constant rate.

    It starts and stops instantaneously, as natural motions do.
    """
    return x, np.ones_like(x)


def smooth(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the profile 3 x^2 - 2 x^3 of a smooth turn from rest to rest.

    Its torque is linear in time, and has the least integral of its square for a single axis.
    """
    return x * x * (3 - 2 * x), 6 * x * (1 - x)


def step(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the profile of a step that reaches the target at once."""
    return np.ones_like(x), np.zeros_like(x)


def turned(vector: np.ndarray, profile: Profile, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the attitudes and rates of a turn about a fixed axis.

    Attitudes (N, 4) are relative to the start; rates have the shape (N, 3).

    vector (3,): axis times angle, rad.  t (N,): times from 0 to 1.
    """
    share, rate = profile(np.asarray(t))
    angle = np.linalg.norm(vector)
    half, axis = share[:, None] * angle / 2, vector / angle
    return np.hstack([np.cos(half), np.sin(half) * axis]), rate[:, None] * vector


def eigenaxis(case: Case, profile: Profile) -> Track:
    """Return the track of the shorter turn about the eigenaxis from start to target."""
    return _track(case, partial(turned, case.rotation_vector, profile))


def _track(case: Case, motion: Guess) -> Track:
    """Convert a dimensionless motion to a track in seconds and inertial axes.

    The motion is a function of times from 0 to 1, with attitudes relative to the start.
    """

    def at(t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        x = np.atleast_1d(np.asarray(t, float)) / case.duration
        q, omega = motion(np.clip(x, 0.0, 1.0))
        found = product(case.start, q), omega / case.duration
        return found if np.ndim(t) else (found[0][0], found[1][0])

    return Track(case.duration, at)


@dataclass(frozen=True, slots=True)
class Ways:
    """Ways to fly a random manoeuvre: the data from which control methods are set up.

    transfer: its cheapest natural motion.  impulses: of the motion of least fuel for the actuators
    that fly, without units, on the mesh of collocation.
    """

    case: Case
    actuators: Model
    transfer: Transfer
    impulses: np.ndarray

    def flight(self, controller: Controller | None = None) -> Flight:
        """Return the settings of a flight with a controller.

        The default controller has feedback alone.
        """
        plain = Controller(feedforward=self.actuators is Model.THRUSTERS)
        timing = Timing(length=Fraction(self.case.duration) + HOLD, period=PERIOD)
        return Flight(run=timing, controller=controller or plain)

    @property
    def slow(self) -> Flight:
        """Settings of feedback with gains so low that a step response takes the whole duration."""
        flight, case = self.flight(), self.case
        settled = np.radians(flight.run.settled)
        frequency = slowest(case.problem.angle, settled) / case.duration
        return self.flight(replace(flight.controller, natural_frequency=frequency))

    @property
    def optimum(self) -> Track:
        """The minimum-fuel motion as a track."""
        inertia = self.case.inertia / self.case.inertia.max()
        return _track(self.case, Driven(self.actuators, inertia, self.impulses, MESH))


METHODS: Mapping[str, Callable[[Ways], tuple[Transfer | Track, Flight]]] = {
    "natural": lambda ways: (ways.transfer, ways.flight(AHEAD)),
    "natural, feedback alone": lambda ways: (ways.transfer, ways.flight()),
    "eigenaxis": lambda ways: (eigenaxis(ways.case, constant), ways.flight(AHEAD)),
    "eigenaxis, smooth": lambda ways: (eigenaxis(ways.case, smooth), ways.flight(AHEAD)),
    "optimum": lambda ways: (ways.optimum, ways.flight(AHEAD)),
    # With the gains of all others a step is much faster than the duration.
    "step": lambda ways: (eigenaxis(ways.case, step), ways.flight()),
    "step, slow": lambda ways: (eigenaxis(ways.case, step), ways.slow),
}
"Track and flight of each way, by its name in the report."


@dataclass(frozen=True, slots=True)
class Flown:
    """Torque integrals, torque peak and attitude errors of one flight.

    torque_integral: of |torque|, summed over the axes, N m s.  torque_square: integral of torque^2,
    summed over the axes, N^2 m^2 s.  torque_peak: of any axis, N m.  error_at_duration,
    error_after_hold: degrees from the target.  saturated: whether a wheel reached its limit.
    """

    torque_integral: float
    torque_square: float
    torque_peak: float
    error_at_duration: float
    error_after_hold: float
    saturated: bool


def flown(
    case: Case, transfer: Transfer, actuators: Model, method: str, impulses: np.ndarray
) -> Flown:
    """Fly a case by one control method and measure the flight.

    Raises InputError where the integration fails.
    """
    track, flight = METHODS[method](Ways(case, actuators, transfer, impulses))
    return measured(fly(case.manoeuvre, flight, track), flight, actuators)


def measured(run: Run, flight: Flight, actuators: Model) -> Flown:
    """Measure the torques and the errors of a flight."""
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
    """Return the torques (N, 3), in N m, that given actuators exert in a flight.

    For thrusters, these are the wheels' torques without the gyroscopic torque of the wheels.
    """
    if actuators is Model.WHEELS:
        return run.torque
    return run.torque - np.cross(run.omega, run.wheel_momentum)


def slowest(turn: float, within: float) -> float:
    """Return the natural frequency at which a critically damped oscillator settles in time 1.

    It is `turn` off at first and `within` at last, rad: (1 + x) exp(-x) = within / turn, solved
    by Lambert's function.
    """
    return float(-1 - lambertw(-within / turn / e, -1).real) if turn > within else 1.0


def ideals(case: Case, transfer: Transfer) -> dict[str, dict[str, float]]:
    """Return the ideal costs, with instantaneous bursts and without disturbances.

    They are the integral of |torque|, summed over the axes, N m s, by actuators and way.  Wheels
    have to exert the gyroscopic torque of a natural motion, thrusters have to cancel that of a turn
    at constant rate.
    """
    several = solve(case.manoeuvre, FAMILIES).transfers
    rates, t = case.rotation_vector / case.duration, np.linspace(0, case.duration, _SAMPLES)

    def gyroscopic(omega: np.ndarray) -> np.ndarray:
        return np.abs(np.cross(omega, case.inertia * omega)).sum(axis=-1)

    def natural(one: Transfer, model: Model) -> float:
        bursts = float(np.abs(one.bursts).sum())
        if model is Model.THRUSTERS:
            return bursts
        return bursts + float(np.trapezoid(gyroscopic(one.motion(t)[1]), t))

    turn = 2 * float(np.abs(case.inertia * rates).sum())
    driven = turn + case.duration * float(gyroscopic(rates))
    return {
        model.value: {
            "natural": natural(transfer, model),
            f"natural, best of {FAMILIES}": min(natural(one, model) for one in several),
            "eigenaxis": driven if model is Model.THRUSTERS else turn,
        }
        for model in Model
    }
