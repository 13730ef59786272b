"""All three figures from one manoeuvre: the paper's, as `paper.toml` has it."""

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.io.files import write_bytes, write_text
from rigidsym.manoeuvre.figures.classical import EulerAngles, difference, euler_angles
from rigidsym.manoeuvre.figures.text import Numbers, page
from rigidsym.manoeuvre.flight.results import Tracked
from rigidsym.manoeuvre.flight.track import track
from rigidsym.view.plots import flights as pictures
from rigidsym.view.plots import histories as drawing

if TYPE_CHECKING:
    from rigidsym.view.plots.figure import Figure


@dataclass(frozen=True, slots=True)
class Figures:
    """A flight, and the classical angles of the natural motion that it follows."""

    tracked: Tracked
    angles: EulerAngles

    def numbers(self) -> Numbers:
        """What is seen in the pictures, measured; SI units, angles in degrees."""
        run, motion = self.tracked.run, self.tracked.transfer.motion
        steps = np.max(np.abs(np.diff(run.track.q, axis=0)))
        peaks = np.min(run.torque, axis=0), np.max(run.torque, axis=0)
        found = self.tracked.summary()
        error, target = found["tracking_error"], found["target"]
        return {
            "jumps": self.angles.jumps(),
            "apart": degrees(difference(motion, run.t, self.angles)),
            "step": float(steps),
            "period": float(run.t[1] - run.t[0]),
            "length": float(run.t[-1]),
            "arrival": run.arrival,
            "tracking": {
                "max": degrees(error["max"]),
                "rms": degrees(error["rms"]),
                "last": degrees(error["last"]),
            },
            "settled_at": _flown(target["settled_at"]),
            "final_error": degrees(_flown(target["final_error"])),
            "lowest": float(np.min(peaks[0])),
            "highest": float(np.max(peaks[1])),
            "burst": [float(np.max(np.abs(part))) for part in self._parts()],
            "gyroscopic": float(np.max(np.abs(self._gyroscopic()))),
        }

    def _coast(self) -> np.ndarray:
        """Which samples lie between the bursts; the first is over after ten times of the loop."""
        run, controller = self.tracked.run, self.tracked.flight.controller
        return (run.t >= 10 / controller.natural_frequency) & (run.t < run.arrival)

    def _parts(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The torques of the first burst, of the coast and of the last burst."""
        run, coast = self.tracked.run, self._coast()
        late = run.t >= run.arrival
        return run.torque[~coast & ~late], run.torque[coast], run.torque[late]

    def _gyroscopic(self) -> np.ndarray:
        """omega x I omega (N, 3) of the natural motion during the coast, N m."""
        run = self.tracked.run
        omega = run.track.omega[self._coast()]
        return np.cross(omega, run.inertia * omega)

    def rows(self) -> list[tuple[str, str]]:
        """One line for each figure."""
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
        """The figures by name."""
        run = self.tracked.run
        return {
            "figure1": _euler(run.t, self.angles),
            "figure2": pictures.attitude(run),
            "figure3": pictures.torques(run),
        }

    def write(self, directory: Path) -> list[Path]:
        """Each figure as SVG and PNG, and figures.md; raises InputError where that fails."""
        written = []
        for name, figure in self.drawn().items():
            for suffix, data in drawing.rendered(figure).items():
                written.append(write_bytes(directory / f"{name}.{suffix}", data))
        return [*written, write_text(directory / "figures.md", page(self.numbers()))]


def figures(progress: Callable[[int, int], None] = lambda done, total: None) -> Figures:
    """Plan and fly the paper's manoeuvre; `progress` is called as by `track`."""
    tracked = track("paper", progress)
    return Figures(tracked, euler_angles(tracked.transfer.motion, tracked.run.t))


def _flown(value: float | None) -> float:
    """What a flight has that goes on until it has settled at the target."""
    if value is None:
        raise ValueError("the figures are of a flight that settles at the target")
    return value


@drawing.defaults()
def _euler(t: np.ndarray, angles: EulerAngles) -> "Figure":
    """Angles in degrees; jumps are joined by the line, as they are in the paper's picture."""
    figure, axes = drawing.blank()
    values = np.stack([angles.precession, angles.nutation, angles.spin], axis=1)
    names = ("precession", "nutation", "spin")
    drawing.lines(axes, t, np.degrees(values), names, linewidth=1.6)
    axes.set_ylabel("Euler's angles (degrees)")
    axes.set_ylim(-190, 190)
    axes.set_yticks(range(-180, 181, 60))
    drawing.legend(axes)
    return figure
