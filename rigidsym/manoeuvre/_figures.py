"""The paper's Figures 1 to 3, for the manoeuvre of `paper.toml`.

Figure 1 shows Euler's angles about the fixed momentum, by the classical solution.  Conventions: the
third axis of the fixed frame lies along the angular momentum, of size K; the rotation from body to
fixed axes is Rz(precession) Rx(nutation) Rz(spin).  Then the momentum's body components are
K sin(nutation) (sin(spin), cos(spin)) and K cos(nutation), so that

    nutation   = arccos(I3 w3 / K)
    spin       = arctan(I1 w1 / (I2 w2))
    precession = constant + integral of K (I1 w1^2 + I2 w2^2) / ((I1 w1)^2 + (I2 w2)^2)

(Landau and Lifshitz, Mechanics, sections 35 and 37; Whittaker, Analytical Dynamics, section 69).
Angles are principal values, as inverse functions give them: nutation from 0 to pi, the others
above -pi and up to pi, with the arctangent of two arguments; that of one would jump still more.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.io._files import write_all
from rigidsym.manoeuvre.flight._results import Tracked, track
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import product, rotated
from rigidsym.view._geometry import moments, momentum, upright
from rigidsym.view._pages import render
from rigidsym.view._plots import figure as drawing
from rigidsym.view._plots import motions as pictures

if TYPE_CHECKING:
    from rigidsym.view._plots.figure import Figure

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


@dataclass(frozen=True, slots=True)
class EulerAngles:
    """Euler angles of an attitude history, in rad.

    Each is an array (N,).
    """

    precession: np.ndarray
    nutation: np.ndarray
    spin: np.ndarray

    def quaternion(self) -> np.ndarray:
        """Return the attitudes as quaternions (N, 4) from body to fixed axes.

        They may have either sign.
        """
        total, difference = self.precession + self.spin, self.precession - self.spin
        cosine, sine = np.cos(self.nutation / 2), np.sin(self.nutation / 2)
        parts = (
            cosine * np.cos(total / 2),
            sine * np.cos(difference / 2),
            sine * np.sin(difference / 2),
            cosine * np.sin(total / 2),
        )
        return np.stack(parts, axis=-1)

    def jumps(self) -> dict[str, int]:
        """Count the jumps of each angle by more than half a turn between samples."""
        angles = {"precession": self.precession, "nutation": self.nutation, "spin": self.spin}
        return {name: int(np.sum(np.abs(np.diff(x)) > np.pi)) for name, x in angles.items()}


def euler_angles(motion: TorqueFreeMotion, t: np.ndarray) -> EulerAngles:
    """Return the Euler angles of a torque-free motion at increasing times (N,).

    The precession is integrated by Gauss's rule.

    The momentum must never lie along the third axis of the body.
    """
    fixed = upright(_fixed_momentum(motion))
    body = moments(motion) * motion(t)[1]
    size = np.linalg.norm(body, axis=1)
    # The rotation is Rz(precession) Rx(nutation) Rz(spin).
    a, b, c, d = product(fixed, motion(t[:1])[0])[0]
    first = float(np.arctan2(b * d + a * c, a * b - c * d))
    nutation = np.arccos(np.clip(body[:, 2] / size, -1, 1))
    spin = np.arctan2(body[:, 0], body[:, 1])
    half = np.diff(t) / 2
    nodes = (t[:-1] + half)[:, None] + half[:, None] * NODES
    rate = _rate(motion, nodes.ravel()).reshape(nodes.shape)
    turned = first + np.concatenate([[0.0], np.cumsum(half * (rate @ WEIGHTS))])
    # Above -pi and up to pi.
    precession = np.pi - np.mod(np.pi - turned, 2 * np.pi)
    return EulerAngles(precession, nutation, spin)


def difference(motion: TorqueFreeMotion, t: np.ndarray, angles: EulerAngles) -> float:
    """Return the largest angle, in rad, between attitudes by Euler angles and by quaternions."""
    found = product(upright(_fixed_momentum(motion)), motion(t)[0])
    # The sines of half the angles: small ones are not lost beside one.
    sides = [np.linalg.norm(found - side * angles.quaternion(), axis=1) for side in (1, -1)]
    apart = np.minimum(*sides)
    return float(np.max(2 * apart))


def _fixed_momentum(motion: TorqueFreeMotion) -> np.ndarray:
    """Return the angular momentum of a motion in inertial axes."""
    return rotated(motion(0.0)[0], momentum(motion))


def _rate(motion: TorqueFreeMotion, t: np.ndarray) -> np.ndarray:
    """Return the precession rate (N,) at times (N,), in rad/s."""
    body, rates = moments(motion)[:2], motion(t)[1][:, :2]
    size = float(np.linalg.norm(momentum(motion)))
    across = body * rates
    return size * np.sum(across * rates, axis=1) / np.sum(across**2, axis=1)


@dataclass(frozen=True, slots=True)
class Figures:
    """The data of the paper's figures.

    They are a flight, and the Euler angles of the natural motion that it follows.
    """

    tracked: Tracked
    angles: EulerAngles

    def numbers(self) -> dict[str, Any]:
        """Return the numbers that describe the figures, in SI units, with angles in degrees.

        burst: the largest torques of the first burst, of the coast and of the last burst.
        """
        run, motion = self.tracked.run, self.tracked.transfer.motion
        error, target = run.tracking(), self.tracked.summary()["target"]
        if target["settled_at"] is None:
            raise ValueError("the figures are of a flight that settles at the target")
        # The first burst is over after ten times of the loop.
        begin = 10 / self.tracked.flight.controller.natural_frequency
        late, coast = run.t >= run.arrival, (run.t >= begin) & (run.t < run.arrival)
        omega = run.track.omega[coast]
        return {
            "jumps": self.angles.jumps(),
            "apart": degrees(difference(motion, run.t, self.angles)),
            "step": float(np.max(np.abs(np.diff(run.track.q, axis=0)))),
            "period": float(run.t[1] - run.t[0]),
            "length": float(run.t[-1]),
            "arrival": run.arrival,
            "tracking": {name: degrees(angle) for name, angle in error.items()},
            "settled_at": target["settled_at"],
            "final_error": degrees(target["final_error"]),
            "lowest": float(np.min(run.torque)),
            "highest": float(np.max(run.torque)),
            "limit": self.tracked.flight.wheels.max_torque,
            "burst": [
                float(np.max(np.abs(run.torque[part]))) for part in (~coast & ~late, coast, late)
            ],
            "disturbance": sum(run.disturbance_peak().values()),
            "gyroscopic": float(np.max(np.abs(np.cross(omega, run.inertia * omega)))),
        }

    def rows(self) -> list[tuple[str, str]]:
        """Return a table with one line for each figure."""
        n = self.numbers()
        jumps = ", ".join(f"{name} {count}" for name, count in n["jumps"].items())
        return [
            ("1", f"jumps of Euler's angles in {n['length']:g} s: {jumps}"),
            (
                "2",
                f"tracking error at most {n['tracking']['max']:.2f} deg; target at "
                f"{n['arrival']:g} s, settled from {n['settled_at']:g} s on",
            ),
            ("3", f"torques from {n['lowest']:.2e} to {n['highest']:.2e} N m"),
        ]

    def drawn(self) -> dict[str, "Figure"]:
        """Draw the figures and return them by name."""
        run = self.tracked.run
        return {
            "figure1": _euler(run.t, self.angles),
            "figure2": pictures.attitude(run),
            "figure3": pictures.torques(run),
        }

    def write(self, directory: Path) -> list[Path]:
        """Write the figures as SVG and PNG, and figures.md, to a directory.

        Raises InputError where that fails.
        """
        page = render("figures.md", **self.numbers()).rstrip("\n")
        text = "\n\n".join(fill(part, 100) for part in page.split("\n\n")) + "\n"
        return write_all(directory, {**drawing.files(self.drawn()), "figures.md": text})


def figures(progress: Callable[[int, int], None] = lambda done, total: None) -> Figures:
    """Plan and fly the paper's manoeuvre for its figures.

    `progress` is called as by `track`.
    """
    tracked = track("paper", progress)
    return Figures(tracked, euler_angles(tracked.transfer.motion, tracked.run.t))


@drawing.defaults()
def _euler(t: np.ndarray, angles: EulerAngles) -> "Figure":
    """Draw the Euler angles in degrees.

    Lines go across the jumps, as in the paper.
    """
    figure, axes = drawing.history("Euler's angles (degrees)")
    values = np.stack([angles.precession, angles.nutation, angles.spin], axis=1)
    names = ("precession", "nutation", "spin")
    drawing.lines(axes, t, np.degrees(values), names, linewidth=1.6)
    axes.set_ylim(-190, 190)
    axes.set_yticks(range(-180, 181, 60))
    drawing.legend(axes)
    return figure
