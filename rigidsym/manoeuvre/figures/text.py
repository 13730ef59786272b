"""The page beside the figures: what the paper shows, and what these show."""

from textwrap import fill
from typing import TypedDict

from rigidsym.manoeuvre.flight.summary import Tracking


class Numbers(TypedDict):
    """What is seen in the pictures, measured; SI units, angles in degrees.

    burst: the largest torques of the first burst, of the coast and of the last burst.
    """

    jumps: dict[str, int]
    apart: float
    step: float
    period: float
    length: float
    arrival: float
    tracking: Tracking
    settled_at: float
    final_error: float
    lowest: float
    highest: float
    burst: list[float]
    gyroscopic: float


def page(n: Numbers) -> str:
    """Markdown, from the numbers of `Figures.numbers`."""
    parts = "\n\n".join([_HEAD, _first(n), _second(n), _third(n)]).split("\n\n")
    return "\n\n".join(fill(part, 100) for part in parts) + "\n"


_HEAD = """# Figures

Written by `rigidsym figures`.  The manoeuvre and the flight are those of `rigidsym track paper`
(`rigidsym/manoeuvre/paper.toml`): the inertia, the orbit, the disturbances and the limits of the
wheels are the paper's (caption of Figure 3); attitudes, duration, gains and all else are chosen
here, since the paper does not print them.  So the curves are not those of the paper point for
point: what can be compared is what they are drawn to show."""


def _first(n: Numbers) -> str:
    jumps = ", ".join(f"{count} of the {name}" for name, count in n["jumps"].items())
    return f"""## Figure 1

![Euler's angles](figure1.svg)

The paper: the natural motion by the classical solution in Euler's angles ([2], (B5) and (B10));
"Figure 1 shows discontinuities which make them unfeasible for direct application".

Here: the same motion as in Figure 2, by the classical formulas for the angles about the fixed
momentum (nutation by an arccosine, spin by an arctangent, precession by an integral), principal
values in degrees.  Jumps within {n["length"]:g} s: {jumps}.  As rotations, the angles agree
with the library's quaternions to {n["apart"]:.1e} degrees: it is the description that jumps, not
the motion."""


def _second(n: Numbers) -> str:
    error = n["tracking"]
    return f"""## Figure 2

![Attitude](figure2.svg)

The paper: the same motion by the quaternions of Theorem 1, dashed, and the track flown by a
spacecraft under a PD controller, continuous; the dashed line goes on after the target has been
reached, where the natural motion is no longer the reference.

Here: the same.  The target is reached at {n["arrival"]:g} s.  The natural motion changes by
{n["step"]:.4f} at most in any component in {n["period"]:g} s: no jump.  The spacecraft starts at
rest, so it falls behind and catches up: the error is {error["max"]:.2f} degrees at most and
{error["rms"]:.2f} (rms) until the target, {error["last"]:.2f} when it is reached; then it settles
(from {n["settled_at"]:g} s on) and ends {n["final_error"]:.3f} degrees from the target."""


def _third(n: Numbers) -> str:
    first, coast, last = n["burst"]
    return f"""## Figure 3

![Control torques](figure3.svg)

The paper: the torques of the three reaction wheels over 180 s, on axes from -3e-4 to 5e-4 N m;
close to a scheme of two bursts.

Here: from {n["lowest"]:.2e} to {n["highest"]:.2e} N m over {n["length"]:g} s, within 5e-4 N m; the
wheels could do 1e-3.  The first burst peaks at {first:.2e}, the last at {last:.2e}; between them
{coast:.1e} at most.  That is little beside the bursts, and more than the disturbances ask for: the
wheels have taken up what the body turns with, so that both together have no momentum and the
body feels no gyroscopic torque.  To follow the natural motion the wheels must supply that,
{n["gyroscopic"]:.1e} N m at most."""
