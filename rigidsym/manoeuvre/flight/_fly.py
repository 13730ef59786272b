"""Simulation of a rigid body in closed loop with sampled control, wheels and thrusters."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np
from scipy.integrate import solve_ivp

from rigidsym.errors import InputError
from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight import _control as control
from rigidsym.manoeuvre.flight._actuators import Burns, next_torque, planned
from rigidsym.manoeuvre.flight._environment import Environment
from rigidsym.manoeuvre.flight._rotation import cross, matrix
from rigidsym.manoeuvre.flight._run import Run
from rigidsym.manoeuvre.flight._settings import Flight
from rigidsym.motion import TorqueFreeMotion

# The integrated state: attitude (4), rates (3), impulse from outside (3), work of all (1).
_Q, _OMEGA, _IMPULSE, _WORK = slice(0, 4), slice(4, 7), slice(7, 10), 10
# Typical sizes of these numbers, for the absolute tolerance.
_SIZES = np.array([1.0] * 4 + [1e-2] * 3 + [1e-5] * 3 + [1e-6])
_NONE = np.zeros(3)


@dataclass(frozen=True, slots=True)
class _Sample:
    """The integrated state (11,) and the wheels' torque and momentum (3,) at one sample."""

    state: np.ndarray
    torque: np.ndarray
    momentum: np.ndarray


@dataclass(frozen=True, slots=True)
class _Ramp:
    """The wheels' torque between two samples, as a linear function of time.

    `then` is the torque at the end.
    """

    begin: float
    end: float
    now: _Sample
    then: np.ndarray

    def at(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the wheels' torque (3,) on the body and their momentum (3,) at a time."""
        share = (t - self.begin) / (self.end - self.begin)
        torque = self.now.torque + share * (self.then - self.now.torque)
        return torque, self.now.momentum - (t - self.begin) / 2 * (self.now.torque + torque)


@dataclass(frozen=True, slots=True)
class _Loop:
    """The closed loop, which computes one sample from the one before."""

    flight: Flight
    inertia: np.ndarray
    environment: Environment
    burns: Burns | None

    @property
    def thrusting(self) -> Burns | None:
        """The burns of thrusters, or None if wheels make the bursts."""
        return self.burns if self.flight.thrusters else None

    def steered(self, now: _Sample, wanted: control.Wanted, span: tuple[float, float]) -> _Ramp:
        """Return the wheels' torque until the next sample, under all control commands.

        The commands are feedback, feedforward and burns.
        """
        begin, end = span
        q, omega, controller = now.state[_Q], now.state[_OMEGA], self.flight.controller
        command = control.feedforward(controller, q, omega, now.momentum, wanted)
        half = (end - begin) / 2
        burst = self.burns.between(end - half, end + half) if self.burns else _NONE
        if not burst.any():
            command = command + control.feedback(controller, self.inertia, q, omega, wanted)
        elif self.flight.thrusters is None:
            command = command + burst
        then = next_torque(self.flight.wheels, now.torque, now.momentum, command, end - begin)
        return _Ramp(begin, end, now, then)

    def flown(self, ramp: _Ramp) -> np.ndarray | None:
        """Integrate the state to the next sample.

        Return None where integration fails.

        q has unit length.

        Steps end where the torque of thrusters changes.
        """
        state, tolerance, burns = ramp.now.state, self.flight.run.tolerance, self.thrusting
        for piece in burns.pieces(ramp.begin, ramp.end) if burns else [(ramp.begin, ramp.end)]:
            burning = burns.between(*piece) if burns else _NONE
            try:
                with np.errstate(over="raise", invalid="raise"):
                    found = solve_ivp(
                        _equations(self.inertia, ramp, self.environment, burning),
                        piece,
                        state,
                        method="DOP853",
                        rtol=tolerance,
                        atol=tolerance * _SIZES,
                        first_step=piece[1] - piece[0],
                    )
            except ArithmeticError:
                return None
            if not found.success:
                return None
            state = found.y[:, -1]
            state[_Q] /= np.linalg.norm(state[_Q])
        return state

    @np.errstate(all="ignore")
    def causes(self, ramp: _Ramp, turning: np.ndarray) -> dict[str, float]:
        """Return the magnitudes of all torques at the start of an interval, by their cause.

        They are in N m.

        Control counts with the torque at the end of the wheels' ramp, the wheels' first momentum
        with its gyroscopic torque at the wanted rates (3,), since the rates flown come of all
        torques.
        """
        size = np.linalg.norm
        each = self.environment.each(np.array([ramp.begin]), ramp.now.state[None, _Q])
        found = {
            "control (lower gains or limits)": max(map(size, (ramp.now.torque, ramp.then))),
            "wheels.momentum": size(self.flight.wheels.momentum) * size(turning),
            **{name.replace("_", " "): size(torque) for name, torque in each.items()},
        }
        return {name: float(np.nan_to_num(size, nan=np.inf)) for name, size in found.items()}


def fly(
    manoeuvre: Manoeuvre,
    flight: Flight,
    track: Transfer | control.Track,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Run:
    """Follow a track, such as a transfer, from t = 0, then hold the target.

    At each period of `flight.run` the controller reads the true state and says which torque it
    wants; until the next one the wheels go there along a straight line, as far as they can.  So
    the torques are continuous, their limits hold exactly, and between the samples the equations
    are smooth: I omega' = -omega x (I omega + h) + torque + disturbances and h' = -torque, with h
    the momentum of the wheels, and I the spacecraft with its wheels locked.  They are integrated
    anew from each sample by SciPy's DOP853, together with the impulse from outside (inertial axes)
    and the work of all torques, which the checks of a `Run` need.

    Bursts of thrusters or with `track_feedforward` are burns centred on their instants: the flight
    begins when the first does, before t = 0, and feedback waits while one lasts.  Wheels exert the
    mean of a burn about each sample, so that their straight lines have its impulse; thrusters are
    on or off, and steps end where they change.

    Parameters
    ----------
    manoeuvre : Manoeuvre
        Body, attitudes and spins before and after.
    flight : Flight
        Settings of the spacecraft, its orbit and its controller.
    track : Transfer or Track
        Motion to follow from the start to the target.
    progress : callable
        Called with the samples done and all of them.

    Returns
    -------
    Run
        States and torques at the samples.

    Raises
    ------
    InputError
        For torques too wild to follow, naming the greatest, and for burns that last too long.
    """
    inertia = np.array([float(x) for x in manoeuvre.inertia])
    burns = planned(flight, manoeuvre, track)
    # Whole periods from t = 0; the first before all burns, or at zero.
    period = flight.run.period
    early = ceil(-burns.begin / float(period)) if burns else 0
    count = flight.run.length // period + 1
    t = np.array([float(k * period) for k in range(-early, count)])
    reference = control.reference(manoeuvre, track, t)
    needed = control.torques(inertia, track, t)
    environment = Environment(flight, inertia, float(t[0]))
    loop = _Loop(flight, inertia, environment, burns)
    # The body has turned freely until the first sample.
    still = TorqueFreeMotion(manoeuvre.inertia, manoeuvre.start_spin, manoeuvre.start)
    state = np.concatenate([*still(float(t[0])), np.zeros(4)])
    samples = [_Sample(state, np.zeros(3), np.array(flight.wheels.momentum))]
    for k, span in enumerate(pairwise(t.tolist())):
        wanted = control.Wanted(reference.q[k], reference.omega[k], needed[k + 1])
        ramp = loop.steered(samples[-1], wanted, span)
        state = loop.flown(ramp)
        if state is None:
            causes = loop.causes(ramp, wanted.omega)
            name = max(causes, key=causes.__getitem__)
            rule = (
                "torques turn the spacecraft too fast to be followed; the greatest, "
                f"{causes[name]:.1e} N m, is that of {name}"
            )
            raise InputError("run", f"beyond {span[0]} s", rule)
        samples.append(_Sample(state, ramp.then, ramp.at(span[1])[1]))
        progress(k + 1, len(t) - 1)
    states = np.array([sample.state for sample in samples])
    return Run(
        inertia=inertia,
        arrival=float(track.duration),
        t=t,
        q=states[:, _Q],
        omega=states[:, _OMEGA],
        reference=reference,
        track=control.Reference(*track.motion(t)),
        torque=np.array([sample.torque for sample in samples]),
        wheel_momentum=np.array([sample.momentum for sample in samples]),
        disturbances=environment.each(t, states[:, _Q]),
        impulse=states[:, _IMPULSE],
        work=states[:, _WORK],
        burns=loop.thrusting,
    )


def _equations(
    inertia: np.ndarray, ramp: _Ramp, environment: Environment, burning: np.ndarray
) -> Callable[[float, np.ndarray], np.ndarray]:
    """Return the right-hand side of the equations of motion between two samples.

    The torque (3,) of thrusters is constant.
    """

    def derivative(t: float, state: np.ndarray) -> np.ndarray:
        q, omega = state[_Q], state[_OMEGA]
        torque, stored = ramp.at(t)
        outer = environment.total(t, q) + burning
        both = torque + outer
        turning = (both - cross(omega, inertia * omega + stored)) / inertia
        return np.concatenate([_turn(q, omega), turning, matrix(q) @ outer, [omega @ both]])

    return derivative


def _turn(q: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """Return the time derivative q' = q (0, omega) / 2 of the attitude."""
    (a, b, c, d), (x, y, z) = q.tolist(), (omega / 2).tolist()
    return np.array(
        [
            -b * x - c * y - d * z,
            a * x + c * z - d * y,
            a * y + d * x - b * z,
            a * z + b * y - c * x,
        ]
    )
