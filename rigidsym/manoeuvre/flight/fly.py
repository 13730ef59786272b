"""The closed loop: sampled control, wheels that ramp between samples, a rigid body between."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import control
from rigidsym.manoeuvre.flight.environment import Environment
from rigidsym.manoeuvre.flight.rotation import cross, matrix
from rigidsym.manoeuvre.flight.run import Run
from rigidsym.manoeuvre.flight.settings import Flight
from rigidsym.manoeuvre.flight.wheels import next_torque
from rigidsym.manoeuvre.manoeuvre import Manoeuvre

# What is integrated: attitude (4), rates (3), impulse of the disturbances (3), work of all (1).
_Q, _OMEGA, _IMPULSE, _WORK = slice(0, 4), slice(4, 7), slice(7, 10), 10
# Sizes of these numbers, for the absolute tolerance.
_SIZES = np.array([1.0] * 4 + [1e-2] * 3 + [1e-5] * 3 + [1e-6])


@dataclass(frozen=True, slots=True)
class _Sample:
    """At one time: what is integrated (11,), and the wheels' torque and momentum (3,) each."""

    state: np.ndarray
    torque: np.ndarray
    momentum: np.ndarray


@dataclass(frozen=True, slots=True)
class _Ramp:
    """The wheels between two samples: their torque goes to `then` along a straight line."""

    begin: float
    end: float
    now: _Sample
    then: np.ndarray

    def at(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Torque on the body and momentum stored, (3,) each."""
        share = (t - self.begin) / (self.end - self.begin)
        torque = self.now.torque + share * (self.then - self.now.torque)
        return torque, self.now.momentum - (t - self.begin) / 2 * (self.now.torque + torque)


def fly(
    manoeuvre: Manoeuvre,
    flight: Flight,
    track: control.Track,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Run:
    """Follow a track, such as a transfer, from t = 0 and hold the target once it is reached.

    At each period of `flight.run` the controller reads the true state and says which torque it
    wants; until the next one the wheels go there along a straight line, as far as they can.  So
    the torques are continuous, their limits hold exactly, and between the samples the equations
    are smooth: I omega' = -omega x (I omega + h) + torque + disturbances and h' = -torque, with h
    what the wheels store, and I the spacecraft with its wheels locked.  They are integrated anew
    from each sample by SciPy's DOP853, together with the impulse of the disturbances (inertial
    axes) and the work of all torques, which the checks of a `Run` need.  `progress` is called with
    the samples done and all of them.  Raises InputError for torques too wild to follow, and names
    the greatest.
    """
    inertia = np.array([float(x) for x in manoeuvre.inertia])
    t = _times(flight)
    wanted = control.reference(manoeuvre, track, t)
    environment = Environment(flight, inertia)
    samples = [_first(manoeuvre, flight)]
    for k, span in enumerate(pairwise(t.tolist())):
        ramp = _steered(flight, inertia, samples[-1], (wanted.q[k], wanted.omega[k]), span)
        equations = _equations(inertia, ramp, environment)
        state = _advance(equations, samples[-1].state, span, flight.run.tolerance)
        if state is None:
            raise _too_fast(_causes(flight, environment, ramp, wanted.omega[k]), span[0])
        samples.append(_Sample(state, ramp.then, ramp.at(span[1])[1]))
        progress(k + 1, len(t) - 1)
    states = np.array([sample.state for sample in samples])
    return Run(
        inertia=inertia,
        arrival=float(track.duration),
        t=t,
        q=states[:, _Q],
        omega=states[:, _OMEGA],
        reference=wanted,
        track=control.along(track, t),
        torque=np.array([sample.torque for sample in samples]),
        wheel_momentum=np.array([sample.momentum for sample in samples]),
        disturbances=environment.each(t, states[:, _Q]),
        impulse=states[:, _IMPULSE],
        work=states[:, _WORK],
    )


def _steered(
    flight: Flight,
    inertia: np.ndarray,
    now: _Sample,
    wanted: tuple[np.ndarray, np.ndarray],
    span: tuple[float, float],
) -> _Ramp:
    """What the wheels do until the next sample, so that q and omega become what is wanted."""
    begin, end = span
    state = now.state[_Q], now.state[_OMEGA], now.momentum
    told = control.command(flight.controller, inertia, state, wanted)
    then = next_torque(flight.wheels, now.torque, now.momentum, told, end - begin)
    return _Ramp(begin, end, now, then)


def _times(flight: Flight) -> np.ndarray:
    """All samples, the first at zero."""
    count = flight.run.length // flight.run.period
    return np.array([float(k * flight.run.period) for k in range(count + 1)])


def _first(manoeuvre: Manoeuvre, flight: Flight) -> _Sample:
    q = np.array([float(x) for x in manoeuvre.start])
    omega = [float(x) for x in manoeuvre.start_spin]
    state = np.concatenate([q / np.linalg.norm(q), omega, np.zeros(4)])
    return _Sample(state, np.zeros(3), np.array(flight.wheels.momentum))


def _equations(
    inertia: np.ndarray, ramp: _Ramp, environment: Environment
) -> Callable[[float, np.ndarray], np.ndarray]:
    """The right-hand side between two samples."""

    def derivative(t: float, state: np.ndarray) -> np.ndarray:
        q, omega = state[_Q], state[_OMEGA]
        torque, stored = ramp.at(t)
        outer = environment.total(t, q)
        both = torque + outer
        turning = (both - cross(omega, inertia * omega + stored)) / inertia
        return np.concatenate([_turn(q, omega), turning, matrix(q) @ outer, [omega @ both]])

    return derivative


def _turn(q: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """q' = q (0, omega) / 2."""
    (a, b, c, d), (x, y, z) = q.tolist(), (omega / 2).tolist()
    return np.array(
        [
            -b * x - c * y - d * z,
            a * x + c * z - d * y,
            a * y + d * x - b * z,
            a * z + b * y - c * x,
        ]
    )


def _advance(
    equations: Callable[[float, np.ndarray], np.ndarray],
    state: np.ndarray,
    span: tuple[float, float],
    tolerance: float,
) -> np.ndarray | None:
    """The state at the end of a span, its quaternion of unit length; None where it is lost."""
    try:
        with np.errstate(over="raise", invalid="raise"):
            found = solve_ivp(
                equations,
                span,
                state,
                method="DOP853",
                rtol=tolerance,
                atol=tolerance * _SIZES,
                first_step=span[1] - span[0],
            )
    except ArithmeticError:
        return None
    if not found.success:
        return None
    after = found.y[:, -1]
    after[_Q] /= np.linalg.norm(after[_Q])
    return after


@np.errstate(all="ignore")
def _causes(
    flight: Flight, environment: Environment, ramp: _Ramp, turning: np.ndarray
) -> dict[str, float]:
    """Sizes of the torques of a span at its beginning, N m, by what they come from.

    Control counts with what the wheels ramp to; the wheels' first momentum with the gyroscopic
    torque that it makes at the rates (3,) that are wanted, since those flown come of all torques.
    """
    q = ramp.now.state[_Q]
    each = environment.each(np.array([ramp.begin]), q[None])
    stored = float(np.linalg.norm(flight.wheels.momentum))
    found = {
        "control (lower gains or limits)": max(map(_size, (ramp.now.torque, ramp.then))),
        "wheels.momentum": stored * _size(turning),
        **{name.replace("_", " "): _size(torque) for name, torque in each.items()},
    }
    return {name: float(np.nan_to_num(size, nan=np.inf)) for name, size in found.items()}


def _size(torque: np.ndarray) -> float:
    return float(np.linalg.norm(torque))


def _too_fast(causes: dict[str, float], begin: float) -> InputError:
    name = max(causes, key=causes.__getitem__)
    told = f"the greatest, {causes[name]:.1e} N m, is that of {name}"
    rule = f"torques turn the spacecraft too fast to be followed; {told}"
    return InputError("run", f"beyond {begin} s", rule)
