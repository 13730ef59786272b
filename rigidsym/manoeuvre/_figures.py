"""The paper's Figures 1 to 3, drawn from the library, of one manoeuvre: that of `paper.toml`."""

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.io._files import write_bytes, write_text
from rigidsym.manoeuvre._classical import EulerAngles, difference, euler_angles
from rigidsym.manoeuvre.flight._results import Tracked, track
from rigidsym.view._pages import render
from rigidsym.view._plots import figure as drawing
from rigidsym.view._plots import motions as pictures

if TYPE_CHECKING:
    from rigidsym.view._plots.figure import Figure


@dataclass(frozen=True, slots=True)
class Figures:
    """A flight, and the classical angles of the natural motion that it follows."""

    tracked: Tracked
    angles: EulerAngles

    def numbers(self) -> dict[str, Any]:
        """Return the numbers that describe the figures, in SI units, angles in degrees.

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
        """Return one line for each figure."""
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
        """Draw the figures, by name."""
        run = self.tracked.run
        return {
            "figure1": _euler(run.t, self.angles),
            "figure2": pictures.attitude(run),
            "figure3": pictures.torques(run),
        }

    def write(self, directory: Path) -> list[Path]:
        """Write each figure as SVG and PNG, and figures.md; raises InputError where that fails."""
        written = []
        for name, figure in self.drawn().items():
            for suffix, data in drawing.rendered(figure).items():
                written.append(write_bytes(directory / f"{name}.{suffix}", data))
        page = render("figures.md", **self.numbers()).rstrip("\n")
        text = "\n\n".join(fill(part, 100) for part in page.split("\n\n")) + "\n"
        return [*written, write_text(directory / "figures.md", text)]


def figures(progress: Callable[[int, int], None] = lambda done, total: None) -> Figures:
    """Plan and fly the paper's manoeuvre for its figures; `progress` is called as by `track`."""
    tracked = track("paper", progress)
    return Figures(tracked, euler_angles(tracked.transfer.motion, tracked.run.t))


@drawing.defaults()
def _euler(t: np.ndarray, angles: EulerAngles) -> "Figure":
    """Draw Euler's angles in degrees, with lines across their jumps as in the paper."""
    figure, axes = drawing.history("Euler's angles (degrees)")
    values = np.stack([angles.precession, angles.nutation, angles.spin], axis=1)
    names = ("precession", "nutation", "spin")
    drawing.lines(axes, t, np.degrees(values), names, linewidth=1.6)
    axes.set_ylim(-190, 190)
    axes.set_yticks(range(-180, 181, 60))
    drawing.legend(axes)
    return figure
