"""What a flight leaves: its states, and what is measured on them."""

from dataclasses import dataclass

import numpy as np

from rigidsym.manoeuvre.flight.burns import Burns
from rigidsym.manoeuvre.flight.control import Reference
from rigidsym.manoeuvre.flight.rotation import angle, matrix, relative, size
from rigidsym.manoeuvre.flight.summary import Arrival, Effort, Holding, Tracking, rows
from rigidsym.view.html.flights import run_html
from rigidsym.view.text import columns


@dataclass(frozen=True, slots=True)
class Run:
    """A flight at its samples, N of them; SI units, vectors in body axes."""

    inertia: np.ndarray
    "Principal moments (3,)."
    arrival: float
    "When the target takes the track's place as what is followed, s."
    t: np.ndarray
    "(N,)."
    q: np.ndarray
    "Attitude flown (N, 4)."
    omega: np.ndarray
    "Body rates flown (N, 3)."
    reference: Reference
    "What was to be followed: the track, then the target."
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
        """Angle between what was flown and what was to be followed (N,), rad."""
        return angle(self.reference.q, self.q)

    def momentum_defect(self) -> float:
        """Largest change of body's and wheels' momentum that nothing from outside explains.

        In inertial axes, N m s: zero but for rounding and integration.
        """
        body = self.inertia * self.omega + self.wheel_momentum
        whole = np.array([matrix(q) @ m for q, m in zip(self.q, body, strict=True)])
        return float(np.max(np.linalg.norm(whole - whole[0] - self.impulse, axis=1)))

    def energy_defect(self) -> float:
        """Largest change of the body's energy of rotation that is no torque's work, J."""
        energy = 0.5 * np.sum(self.inertia * self.omega**2, axis=1)
        return float(np.max(np.abs(energy - energy[0] - self.work)))

    def sizes(self) -> tuple[float, float]:
        """Return the largest momentum of body and wheels, N m s, and the largest energy, J."""
        body = self.inertia * self.omega
        momentum = np.linalg.norm(body, axis=1) + np.linalg.norm(self.wheel_momentum, axis=1)
        return float(np.max(momentum)), float(np.max(np.sum(body * self.omega, axis=1)) / 2)

    def tracking(self) -> Tracking:
        """Greatest, root mean square and last angle of error until arrival, rad."""
        error = self.error[self.t < self.arrival]
        rms = float(np.sqrt(np.mean(error**2)))
        return {"max": float(np.max(error)), "rms": rms, "last": float(error[-1])}

    def holding(self, settled: float) -> Holding:
        """Of the target after arrival: the last angle of error (rad), and since when (s) it stays

        within `settled` rad; None where it is not so at the end, or nothing is flown by then.
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

    def last_burn(self) -> Arrival | None:
        """How far the first sample after all burns of thrusters is from what is wanted there.

        None without thrusters, or where the flight ends before.
        """
        if self.burns is None or self.t[-1] < self.burns.end:
            return None
        k = int(np.searchsorted(self.t, self.burns.end))
        slip = self.omega[k] - self.reference.omega[k] @ matrix(
            relative(self.reference.q[k], self.q[k])
        )
        return {"t": float(self.t[k]), "error": float(self.error[k]), "rate": size(slip)}

    def effort(self) -> Effort:
        """By axis: peak of |torque| (N m), its integral (N m s), peak of the wheels' momentum."""
        taken = np.abs(self.torque)
        return {
            "torque_peak": np.max(taken, axis=0).tolist(),
            "torque_integral": np.trapezoid(taken, self.t, axis=0).tolist(),
            "wheel_momentum_peak": np.max(np.abs(self.wheel_momentum), axis=0).tolist(),
        }

    def disturbance_peak(self) -> dict[str, float]:
        """The greatest size of each disturbing torque, N m."""
        return {
            name: float(np.max(np.linalg.norm(torque, axis=1)))
            for name, torque in self.disturbances.items()
        }

    def __repr__(self) -> str:
        title = f"Flight: {self.t[-1]:g} s, {len(self.t)} samples"
        return columns(title, ("", ""), rows(self))

    def _repr_html_(self) -> str:
        return run_html(self, rows(self))
