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
from rigidsym.view._plots import figure as drawing
from rigidsym.view._plots import flights as pictures

if TYPE_CHECKING:
    from rigidsym.view._plots.figure import Figure


@dataclass(frozen=True, slots=True)
class Figures:
    """A flight, and the classical angles of the natural motion that it follows."""

    tracked: Tracked
    angles: EulerAngles

    def numbers(self) -> dict[str, Any]:
        """Return the numbers beside the figures; SI units, angles in degrees.

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
        return [*written, write_text(directory / "figures.md", page(self.numbers()))]


def figures(progress: Callable[[int, int], None] = lambda done, total: None) -> Figures:
    """Plan and fly the paper's manoeuvre; `progress` is called as by `track`."""
    tracked = track("paper", progress)
    return Figures(tracked, euler_angles(tracked.transfer.motion, tracked.run.t))


@drawing.defaults()
def _euler(t: np.ndarray, angles: EulerAngles) -> "Figure":
    """Draw angles in degrees; the line joins their jumps, as it does in the paper's picture."""
    figure, axes = drawing.history()
    values = np.stack([angles.precession, angles.nutation, angles.spin], axis=1)
    names = ("precession", "nutation", "spin")
    drawing.lines(axes, t, np.degrees(values), names, linewidth=1.6)
    axes.set_ylabel("Euler's angles (degrees)")
    axes.set_ylim(-190, 190)
    axes.set_yticks(range(-180, 181, 60))
    drawing.legend(axes)
    return figure


def page(n: dict[str, Any]) -> str:
    """Return figures.md, from the numbers of `Figures.numbers`."""
    jumps = ", ".join(f"{count} of the {name}" for name, count in n["jumps"].items())
    error, (first, coast, last) = n["tracking"], n["burst"]
    text = f"""# Figures

Written by `rigidsym figures`.  The manoeuvre and the flight are those of `rigidsym track paper`
(`rigidsym/manoeuvre/paper.toml`): the inertia, the orbit, the disturbances and the limits of the
wheels are the paper's (caption of Figure 3); attitudes, duration, gains and all else are chosen
here, since the paper does not print them.  So the curves differ from the paper's point for point,
and can be compared in what they are drawn to show.

## Figure 1

![Euler's angles](figure1.svg)

The paper: the natural motion by the classical solution in Euler's angles ([2], (B5) and (B10));
"Figure 1 shows discontinuities which make them unfeasible for direct application".

Here: the same motion as in Figure 2, by the classical formulas for the angles about the fixed
momentum (nutation by an arccosine, spin by an arctangent, precession by an integral), principal
values in degrees.  Jumps within {n["length"]:g} s: {jumps}.  As rotations, the angles agree
with the library's quaternions to {n["apart"]:.1e} degrees: the angles jump, the motion does not.

## Figure 2

![Attitude](figure2.svg)

The paper: the same motion by the quaternions of Theorem 1, dashed, and the track flown by a
spacecraft under a PD controller, continuous; the dashed line goes on after the target has been
reached, where the natural motion is no longer the reference.

Here: the same.  The target is reached at {n["arrival"]:g} s.  The natural motion changes by
{n["step"]:.4f} at most in any component in {n["period"]:g} s: no jump.  The spacecraft starts at
rest, so it falls behind and catches up: the error is {error["max"]:.2f} degrees at most and
{error["rms"]:.2f} (rms) until the target, {error["last"]:.2f} when it is reached; then it settles
(from {n["settled_at"]:g} s on) and ends {n["final_error"]:.3f} degrees from the target.

## Figure 3

![Control torques](figure3.svg)

The paper: the torques of the three reaction wheels over 180 s, on axes from -3e-4 to 5e-4 N m;
close to a scheme of two bursts.

Here: from {n["lowest"]:.2e} to {n["highest"]:.2e} N m over {n["length"]:g} s; the limit of the
wheels is {n["limit"]:g} N m.  The first burst peaks at {first:.2e}, the last at {last:.2e}; between
them {coast:.1e} at most, {coast / min(first, last):.1%} of the smaller burst; all disturbances
together peak at {n["disturbance"]:.1e} N m.  The wheels have stored the momentum of the body, so
that the total momentum is zero and the body feels no gyroscopic torque.  To follow the natural
motion the wheels must supply that torque, {n["gyroscopic"]:.1e} N m at most."""
    return "\n\n".join(fill(part, 100) for part in text.split("\n\n")) + "\n"
