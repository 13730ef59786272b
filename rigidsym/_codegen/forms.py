"""Forms of the solution for generated modules (theta, Pi, step), and limits of their domains."""

from dataclasses import dataclass, replace

from rigidsym._codegen.formats import BINARY32, BINARY64, Format
from rigidsym.errors import unknown

THETA, PI, STEP = "theta", "pi", "step"
# The forms, with what states are computed from; the first is the default.
FORMS = {
    THETA: "two theta functions of a shifted time",
    PI: "one integral of the third kind, and no theta function",
    STEP: "one step from any state, by its elapsed time alone",
}


def checked(form: str) -> str:
    """Check the name of a form, and return it unchanged.

    Raises InputError for an unknown form.
    """
    if form not in FORMS:
        raise unknown("form", form, FORMS, plain=True)
    return form


def split(key: str) -> tuple[str, str]:
    """Split the key of a generated module into its target and its form.

    >>> split("c"), split("numpy-pi")
    (('c', 'theta'), ('numpy', 'pi'))
    """
    target, _, form = key.partition("-")
    return target, form or THETA


def option(form: str) -> str:
    """Return the command-line option that selects a form.

    It is empty for the default form.
    """
    return "" if form == THETA else f" --form {form}"


def key(target: str, form: str) -> str:
    """Return the key of a generated module, for example `numpy-pi`.

    For the default form it is the target alone.
    """
    return target if form == THETA else f"{target}-{form}"


@dataclass(frozen=True, slots=True)
class Limit:
    """Numeric limit in a generated module, always a power of two.

    `exponent` is that of the power, and `meaning` says what is limited.
    """

    name: str
    exponent: int
    meaning: str


# Where a step ends.
STEP_LIMITS = (
    Limit("min_moment_ratio", -200, "ratio of two principal moments"),
    Limit("max_step", 3, "|omega dt|, rad"),
)
LIMITS = (
    Limit("negligible", -400, "rates below this share of the largest are taken for zero"),
    Limit("decisive", -70, "share of a tilt; rates that cause less may be taken for zero"),
    Limit("min_discriminant", -900, "E_b in inner units; below it, motions are on the separatrix"),
    Limit("tolerated", -60, "error of such motions, as a share of the momentum"),
    Limit("min_moment_ratio", -200, "ratio of two principal moments"),
    Limit("max_circular", -1, "k_1^2 on the circular branch; above it, the hyperbolic one"),
    Limit("max_real", -1, "m for thetas of real elapsed time; above it, of imaginary time"),
    Limit("max_angle", 46, "|omega0 t|, rad"),
    Limit("max_rate", 990, "a rate, rad/s; exact products with it do not overflow"),
)


# Exponents of limits in single precision where they differ.
_SINGLE = {
    **{"negligible": -60, "decisive": -35, "min_discriminant": -75, "tolerated": -30},
    **{"min_moment_ratio": -20, "max_angle": 17, "max_rate": 100},
}


def limits(form: str, binary: Format = BINARY64) -> tuple[Limit, ...]:
    """Return the numeric limits for one form of the solution in a floating-point format.

    Only the default form has sensitivities, and with them the limit `max_real`.
    """
    if binary is BINARY32:
        return tuple(replace(x, exponent=_SINGLE.get(x.name, x.exponent)) for x in limits(form))
    if form == STEP:
        return STEP_LIMITS
    return LIMITS if form == THETA else tuple(x for x in LIMITS if x.name != "max_real")
