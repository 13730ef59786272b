"""The documented bounds: what is measured of states, in which unit, and how wrong they may be."""

ULP = 2.0**-53
# The documented bound on angle (rad) and rates (relative), of bodies that can exist, at all times.
BOUND = 2e-15
BOUNDS = {
    "angle": BOUND,
    "omega": BOUND,
    "norm": 1e-15,
    # Times the condition of H and K^2: what an error of BOUND in the rates makes of them.
    "energy": BOUND,
    "momentum": BOUND,
    # Two states are in these, each with an error of half the angle.
    "residual": 2 * BOUND,
    "jump": BOUND,
    # The given state itself, but for the rounding of the quaternion's length.
    "start": 3e-16,
    "entry_points": 2 * BOUND,
}
MEASURES = tuple(BOUNDS)
# What the bounds of other modules are times these: psi of the Pi form is a sum of more terms, and
# a step goes one turn at most.
_TIMES = {"numpy-pi": 1.5, "c-pi": 1.5, "numpy-step": 0.5, "c-step": 0.5}
# What is of one quaternion's length alone is as wrong after a step as ever.
_OF_LENGTH = ("norm", "start")
# Those whose bound is times a condition.
CONDITIONED = ("energy", "momentum")
MEANINGS = {
    "angle": "rotation angle from the true attitude, with the right double-cover sign (rad)",
    "omega": "|difference from the true rates| / |omega|",
    "norm": "| |q| - 1 |",
    "energy": "relative drift of H",
    "momentum": "relative drift of K^2",
    "residual": "|q(t2) - q(t1) - integral of q (0, omega)/2| over half a radian",
    "jump": "|q(t+) - q(t)| for the next double t+, beyond what |omega| explains",
    "start": "angle, or relative rates, from the given state at t = 0",
    "entry_points": "one time, a grid, a batch, many times, reused arrays: "
    "from states at the same times",
}


def bounds_of(implementation: str) -> dict[str, float]:
    """The documented bounds of one implementation, by measure.

    >>> bounds_of("numpy-step")["angle"], bounds_of("numpy")["angle"]
    (1e-15, 2e-15)
    """
    times = _TIMES.get(implementation, 1.0)
    of_length = max(times, 1.0)
    return {
        name: bound * (of_length if name in _OF_LENGTH else times) for name, bound in BOUNDS.items()
    }
