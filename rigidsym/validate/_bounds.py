"""Error measures, with their meanings and documented bounds."""

from dataclasses import dataclass

from rigidsym._codegen.forms import PI, STEP, split

ULP = 2.0**-53
# The documented bound on angle (rad) and rates (relative), of bodies that can exist, at all times.
BOUND = 2e-15


@dataclass(frozen=True, slots=True)
class Measure:
    """Error measure, with its documented bound, its meaning and its column title.

    conditioned: the bound is times the condition number of the measured quantity.
    of_length: it is about the length of one quaternion, which is as wrong after a step as ever.
    """

    bound: float
    meaning: str
    head: str
    conditioned: bool = False
    of_length: bool = False


_TABLE = {
    "angle": Measure(
        BOUND,
        "rotation angle from the true attitude, with the right double-cover sign (rad)",
        "angle",
    ),
    "omega": Measure(BOUND, "|difference from the true rates| / |omega|", "omega"),
    "norm": Measure(1e-15, "| |q| - 1 |", "norm", of_length=True),
    # The condition is that of H and K^2: how far an error of the rates changes them.
    "energy": Measure(BOUND, "relative drift of H", "H", conditioned=True),
    "momentum": Measure(BOUND, "relative drift of K^2", "K^2", conditioned=True),
    # Two states are in these, each with an error of half the angle.
    "residual": Measure(
        2 * BOUND, "|q(t2) - q(t1) - integral of q (0, omega)/2| over half a radian", "residual"
    ),
    "jump": Measure(
        BOUND, "|q(t+) - q(t)| for the next double t+, beyond what |omega| explains", "jump"
    ),
    # The given state itself, but for the rounding of the quaternion's length.
    "start": Measure(
        3e-16, "angle, or relative rates, from the given state at t = 0", "start", of_length=True
    ),
    "entry_points": Measure(
        2 * BOUND,
        "one time, a grid, a batch, many times, reused arrays: from states at the same times",
        "entry points",
    ),
}
MEASURES = tuple(_TABLE)
BOUNDS = {name: one.bound for name, one in _TABLE.items()}
MEANINGS = {name: one.meaning for name, one in _TABLE.items()}
HEADS = tuple(one.head for one in _TABLE.values())
CONDITIONED = tuple(name for name, one in _TABLE.items() if one.conditioned)
# Bounds of other modules over these: psi of the Pi form is a sum of more terms, and a step goes one
# turn at most.
_TIMES = {PI: 1.5, STEP: 0.5}
# In single precision the bound on the angle is 1e-6 rad.
_SINGLE = dict.fromkeys(("c_single", "c_single-step"), 5e8)


def bounds_of(implementation: str) -> dict[str, float]:
    """Return an implementation's documented error bounds, keyed by measure name.

    >>> bounds_of("numpy-step")["angle"], bounds_of("numpy")["angle"]
    (1e-15, 2e-15)
    """
    times = _SINGLE.get(implementation, _TIMES.get(split(implementation)[1], 1.0))
    return {
        name: bound * (max(times, 1.0) if _TABLE[name].of_length else times)
        for name, bound in BOUNDS.items()
    }
