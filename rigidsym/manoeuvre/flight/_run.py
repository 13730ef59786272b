"""The sampled states of a flight, with performance measures and table rows."""

from dataclasses import dataclass
from math import degrees, radians
from typing import Any

import numpy as np

from rigidsym.manoeuvre.flight._actuators import Burns
from rigidsym.manoeuvre.flight._control import Reference
from rigidsym.manoeuvre.flight._rotation import angle, matrix, relative
from rigidsym.manoeuvre.flight._settings import Timing, Wheels
from rigidsym.view._motions import run_html
from rigidsym.view._tables import columns

Rows = list[tuple[str, str]]

_SETTLED = Timing().settled
# Part of a flight's largest momentum or energy: rounding and integration errors are far below it.
_ROUNDING = 1e-12
# Share of a limit within which a value counts as at that limit.
_NEAR = 1e-6


@dataclass(frozen=True, slots=True)
class Run:
    """The sampled states, torques and reference of a flight.

    There are N samples.  Units are SI, vectors are in body axes.
    """

    inertia: np.ndarray
    "Principal moments (3,)."
    arrival: float
    "Time when the target replaces the track as the reference, s."
    t: np.ndarray
    "(N,)."
    q: np.ndarray
    "Attitude flown (N, 4)."
    omega: np.ndarray
    "Body rates flown (N, 3)."
    reference: Reference
    "The motion to follow: the track, then the target."
    track: Reference
    "The track all along, on beyond its arrival: that of a transfer is its natural motion."
    torque: np.ndarray
    "Of the wheels on the body (N, 3); straight lines between the samples."
    wheel_momentum: np.ndarray
    "(N, 3)."
    disturbances: dict[str, np.ndarray]
    "Torques by name, (N, 3) each; what is switched off is missing."
    impulse: np.ndarray
    "Of disturbances and thrusters from the first sample on, inertial axes, as integrated (N, 3)."
    work: np.ndarray
    "Of all torques on the body from the first sample on (N,)."
    burns: Burns | None = None
    "Of the thrusters; None where there are none."

    @property
    def error(self) -> np.ndarray:
        """Angle (N,) between the flown attitude and the reference, in rad."""
        return angle(self.reference.q, self.q)

    def momentum_defect(self) -> float:
        """Return the largest change of total momentum, in N m s, not explained by external torque.

        In inertial axes: zero but for rounding and integration.
        """
        body = self.inertia * self.omega + self.wheel_momentum
        whole = np.array([matrix(q) @ m for q, m in zip(self.q, body, strict=True)])
        return float(np.max(np.linalg.norm(whole - whole[0] - self.impulse, axis=1)))

    def energy_defect(self) -> float:
        """Return the largest change of kinetic energy, in J, not explained by torques."""
        energy = 0.5 * np.sum(self.inertia * self.omega**2, axis=1)
        return float(np.max(np.abs(energy - energy[0] - self.work)))

    def sizes(self) -> tuple[float, float]:
        """Return the largest momentum of body and wheels and the largest kinetic energy.

        Units are N m s and J.
        """
        body = self.inertia * self.omega
        momentum = np.linalg.norm(body, axis=1) + np.linalg.norm(self.wheel_momentum, axis=1)
        return float(np.max(momentum)), float(np.max(np.sum(body * self.omega, axis=1)) / 2)

    def tracking(self) -> dict[str, float]:
        """Return statistics of the attitude error until arrival, in rad.

        They are its maximum, root mean square and last value.
        """
        error = self.error[self.t < self.arrival]
        found = {"max": np.max(error), "rms": np.sqrt(np.mean(error**2)), "last": error[-1]}
        return {name: float(angle) for name, angle in found.items()}

    def holding(self, settled: float) -> dict[str, float | None]:
        """Return how accurately the target is held after arrival.

        Values are None where the flight ends before.

        These are `final_error` and `greatest_error`, rad, and `settled_at`, the time (s) from which
        the error stays within `settled` rad; None where it does not at the end.
        """
        late = self.t >= self.arrival
        if not late.any():
            return {"final_error": None, "greatest_error": None, "settled_at": None}
        error, t = self.error[late], self.t[late]
        outside = np.flatnonzero(error > settled)
        since = outside[-1] + 1 if outside.size else 0
        return {
            "final_error": float(error[-1]),
            "greatest_error": float(np.max(error)),
            "settled_at": float(t[since]) if since < len(t) else None,
        }

    def last_burn(self) -> dict[str, float] | None:
        """Return the attitude and rate errors at the end of all thruster burns.

        `t` is in s, `error` in rad, `rate` in rad/s.

        They are those of the first sample after all burns, relative to the reference; None without
        thrusters, or where the flight ends before.
        """
        if self.burns is None or self.t[-1] < self.burns.end:
            return None
        k = int(np.searchsorted(self.t, self.burns.end))
        slip = self.omega[k] - self.reference.omega[k] @ matrix(
            relative(self.reference.q[k], self.q[k])
        )
        return {
            "t": float(self.t[k]),
            "error": float(self.error[k]),
            "rate": float(np.linalg.norm(slip)),
        }

    def effort(self) -> dict[str, list[float]]:
        """Return peaks and integrals of |torque| and peaks of the wheels' momentum, by axis."""
        taken = np.abs(self.torque)
        return {
            "torque_peak": np.max(taken, axis=0).tolist(),
            "torque_integral": np.trapezoid(taken, self.t, axis=0).tolist(),
            "wheel_momentum_peak": np.max(np.abs(self.wheel_momentum), axis=0).tolist(),
        }

    def disturbance_peak(self) -> dict[str, float]:
        """Return the largest magnitude of each disturbance torque, in N m."""
        return {
            name: float(np.max(np.linalg.norm(torque, axis=1)))
            for name, torque in self.disturbances.items()
        }

    def saturation(self, wheels: Wheels) -> dict[str, list[float]]:
        """Return how long each wheel is at its limits, and the momentum that it would need.

        Times at the limits of torque and momentum are in s.

        `momentum_needed` is the largest momentum (N m s) of wheels that follow the reference
        exactly, without disturbances: in space the total momentum stays.
        """
        period = float(self.t[1] - self.t[0])

        def at(values: np.ndarray, limit: float) -> list[float]:
            near = np.abs(values) >= limit * (1 - _NEAR)
            return (period * np.count_nonzero(near, axis=0)).tolist()

        body = self.inertia * self.reference.omega
        whole = matrix(self.q[0]) @ (self.inertia * self.omega[0] + self.wheel_momentum[0])
        needed = np.array([whole @ matrix(q) for q in self.reference.q]) - body
        return {
            "torque": at(self.torque, wheels.max_torque),
            "momentum": at(self.wheel_momentum, wheels.max_momentum or np.inf),
            "momentum_needed": np.abs(needed).max(axis=0).tolist(),
        }

    def rows(self, settled: float = _SETTLED) -> Rows:
        """Return the table of measures as pairs of name and text.

        `settled` is the tolerance of settling at the target, in degrees.
        """
        error, target, effort = self.tracking(), self.holding(radians(settled)), self.effort()
        burnt = []
        if last := self.last_burn():
            off = f"{_deg(last['error'])} off, {degrees(last['rate']):.4f} deg/s left"
            burnt = [("when thrusters end", f"{last['t']:g} s: {off}")]
        held = f"not within {settled:g} deg at the end"
        if target["final_error"] is None:
            held = "not flown"
        elif target["settled_at"] is not None:
            held = f"from {target['settled_at']:.1f} s on, within {settled:g} deg"
        return [
            ("natural motion", f"{self.arrival:g} s"),
            ("tracking error, greatest and rms", f"{_deg(error['max'])}, {_deg(error['rms'])}"),
            ("error at arrival", _deg(error["last"])),
            *burnt,
            ("settled at the target", held),
            ("error at the end", _deg(target["final_error"])),
            ("torque peaks", _three(effort["torque_peak"], "N m")),
            ("torque integrals", _three(effort["torque_integral"], "N m s")),
            ("wheels' momentum peaks", _three(effort["wheel_momentum_peak"], "N m s")),
            *(
                (f"{name.replace('_', ' ')}, peak", f"{peak:.2e} N m")
                for name, peak in self.disturbance_peak().items()
            ),
        ]

    def saturation_rows(self, wheels: Wheels, missed: bool) -> Rows:
        """Return table rows of the limits that wheels reach.

        If the target is missed, the last row says why.
        """
        found = self.saturation(wheels)
        limits = (("torque", wheels.max_torque, "N m"), ("momentum", wheels.max_momentum, "N m s"))
        met = []
        for name, limit, unit in limits:
            times = ", ".join(
                f"{k} for {time:.1f} s" for k, time in enumerate(found[name], 1) if time
            )
            if times:
                met.append((f"wheels at their limit of {name}", f"{times} ({limit:g} {unit})"))
        if missed and any(found["momentum"]):
            k = int(np.argmax(found["momentum_needed"]))
            needed = f"wheel {k + 1} would have to store {found['momentum_needed'][k]:.2e} N m s"
            met.append(("why it misses", f"{needed}; thrusters, [thrusters], need no store"))
        elif missed and met:
            met.append(("why it misses", "wheels give less torque than the controller commands"))
        return met

    def check_rows(self) -> Rows:
        """Return the table rows of unexplained changes of momentum and energy.

        They are bounds where they are rounding, whose digits differ between processors.
        """

        def unexplained(defect: float, size: float) -> str:
            bound = _ROUNDING * size
            return f"below {bound:.0e}" if bound and defect <= bound else f"{defect:.1e}"

        momentum, energy = self.sizes()
        return [
            ("momentum unexplained", f"{unexplained(self.momentum_defect(), momentum)} N m s"),
            ("energy unexplained", f"{unexplained(self.energy_defect(), energy)} J"),
        ]

    def __repr__(self) -> str:
        title = f"Flight: {self.t[-1]:g} s, {len(self.t)} samples"
        return columns(title, ("", ""), self.rows())

    def _repr_html_(self) -> str:
        return run_html(self, self.rows())

    def arrays(self) -> dict[str, Any]:
        """Return the arrays of run.npz by name.

        They have a row for each sample.
        """
        return {
            "t": self.t,
            "q": self.q,
            "omega": self.omega,
            "reference_q": self.reference.q,
            "reference_omega": self.reference.omega,
            "natural_q": self.track.q,
            "natural_omega": self.track.omega,
            "error": self.error,
            "torque": self.torque,
            "wheel_momentum": self.wheel_momentum,
            "impulse": self.impulse,
            "work": self.work,
            **{f"disturbance_{name}": torque for name, torque in self.disturbances.items()},
        }


def predicted(size: float, direction: float) -> tuple[str, str]:
    """Return the table row with the miss that is predicted for an uncorrected motion.

    size: by 1 % of the first burst, rad.  direction: by where it points, rad per rad.
    """
    missed = f"{_deg(size)} by 1 % of the burst, {direction:.3f} deg by 1 deg of its direction"
    return "the same predicted, uncorrected", missed


def _deg(angle: float | None) -> str:
    return "not flown" if angle is None else f"{degrees(angle):.3f} deg"


def _three(values: list[float], unit: str) -> str:
    return f"{', '.join(f'{value:.2e}' for value in values)} {unit}"
