"""Where generated code ends, as powers of two: one table for all targets."""

from dataclasses import dataclass

from rigidsym.codegen.forms import STEP, THETA


@dataclass(frozen=True, slots=True)
class Limit:
    """2^exponent, and what it is a limit of."""

    name: str
    exponent: int
    meaning: str


# Where a step ends.
STEP_LIMITS = (
    Limit("min_moment_ratio", -200, "of one principal moment over another"),
    Limit("max_step", 3, "of |omega dt|, rad"),
)
LIMITS = (
    Limit("negligible", -400, "rates below this share of the largest are taken for zero"),
    Limit("decisive", -70, "of others' share in a tilt, below which those may be taken for zero"),
    Limit(
        "min_discriminant", -900, "of E_b in inner units; nearer to the separatrix is taken for it"
    ),
    Limit("tolerated", -60, "of the momentum, by which that, or middle-axis spin, may be wrong"),
    Limit("min_moment_ratio", -200, "of one principal moment over another"),
    Limit("max_circular", -1, "of k_1^2 on the circular branch; above it, the hyperbolic one"),
    Limit(
        "max_real", -1, "of m where the elapsed time has thetas of its own; above, of i times it"
    ),
    Limit("max_angle", 46, "of |omega0 t|, rad"),
    Limit("max_rate", 990, "of a rate, rad/s: exact products with it are still held"),
)


def limits(form: str) -> tuple[Limit, ...]:
    """Those of a form; sensitivities are the default's alone."""
    if form == STEP:
        return STEP_LIMITS
    return LIMITS if form == THETA else tuple(x for x in LIMITS if x.name != "max_real")
