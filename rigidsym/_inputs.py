"""Conversion of user input to exact rational numbers.

Errors have one-line messages.  Floats mean the exact binary64 value; strings ("0.0109", "1/3",
"0x1.8p+1"), Fraction, Decimal and mpf mean exactly what they say.  "0.0109 +/- 1e-6" and the balls
of python-flint are uncertain.
"""

import math
import operator
import re
from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, InvalidOperation
from fractions import Fraction
from functools import cache
from numbers import Rational, Real
from typing import TYPE_CHECKING, Any, TypedDict, Union

from rigidsym import _containers as containers
from rigidsym.errors import InputError, written

if TYPE_CHECKING:
    import flint

    # mpmath makes its mpf as it runs, of this class.
    from mpmath.ctx_mp_python import _mpf
    from numpy.typing import ArrayLike

# Numbers that are taken exactly, or within a radius, and vectors of them.
ExactNumber = Union[float, int, str, Fraction, Decimal, "_mpf", "flint.arb", "Uncertain"]
Vector3 = Union[Sequence[ExactNumber], "ArrayLike"]
Quaternion = Union[Sequence[ExactNumber], "ArrayLike"]
Times = Union[ExactNumber, Sequence[ExactNumber], "ArrayLike"]

_HEX = re.compile(r"[+-]?0[xX]")
# The tolerance for the rounding of moments, relative to the smallest.
ROUNDING = Fraction(1, 2**50)
_LARGEST_EXPONENT = 10_000
_LONGEST = 10**9
_SHORT = 30
_PI_BITS = 1000
# The digits of whole numbers up to which Python reads and writes them.
_INT_DIGITS = 4300
MOST_DIGITS = 100_000
MOST_TIMES = 10_000_000


@dataclass(frozen=True, slots=True)
class Uncertain:
    """An uncertain number, known to lie within a radius of its middle."""

    middle: Fraction
    radius: Fraction

    def __str__(self) -> str:
        return f"{decimal(self.middle, 12)} +/- {decimal(self.radius, 3)}"


class MotionInputs(TypedDict, total=False):
    """The keyword arguments that define a torque-free motion."""

    inertia: Vector3
    omega0: Vector3
    attitude0: Quaternion
    engine: str
    allow_nonphysical: bool
    degrees: bool


# A number after it was read.
Number = Fraction | Uncertain


def middle(value: Number) -> Fraction:
    """Return the value of an exact number, or the middle of an uncertain one."""
    return value.middle if isinstance(value, Uncertain) else value


def radius(value: Number) -> Fraction:
    """Return the radius of a number, which is 0 for an exact one."""
    return value.radius if isinstance(value, Uncertain) else Fraction(0)


def is_uncertain(*values: Number) -> bool:
    """Return True if any number is uncertain."""
    return any(isinstance(value, Uncertain) for value in values)


def number(field: str, value: ExactNumber) -> Number:
    """Convert user input to an exact or an uncertain number.

    Raises InputError unless it is finite and real.
    """
    if isinstance(value, Uncertain):
        return value
    given: Any = value
    parts = [given]
    if isinstance(given, str):
        parts = given.strip().removeprefix("[").removesuffix("]").split("+/-")
    elif _is_ball(given):
        parts = [given.mid(), given.rad()]
    if len(parts) == 1:
        return exact(field, value)
    if len(parts) != 2:
        raise InputError(
            field, written(value, repr), "must be one number and, after +/-, its radius"
        )
    middle, radius = (exact(field, part) for part in (parts[0] or "0", parts[1]))
    if radius < 0:
        raise InputError(field, written(value, repr), "must not have a negative radius")
    return Uncertain(middle, radius) if radius else middle


def certain(
    field: str, values: Sequence[Number], rule: str = "is uncertain; only enclose takes that"
) -> tuple[Fraction, ...]:
    """Check that no number is uncertain, and return the numbers.

    Raises InputError for the first uncertain one.
    """
    exact_ones = tuple(value for value in values if isinstance(value, Fraction))
    for k, value in enumerate(values):
        if isinstance(value, Uncertain):
            raise InputError(f"{field}[{k}]", value, rule)
    return exact_ones


def in_radians(values: Sequence[Number], degrees: bool = True) -> tuple[Number, ...]:
    """Convert angles or rates to radians if they are in degrees.

    They are returned unchanged unless `degrees`.  All are multiplied by one rational, pi/180 to 300
    digits, so that their ratios stay exact, and the regime with them.
    """
    if not degrees:
        return tuple(values)
    unit = _degree()
    return tuple(
        Uncertain(x.middle * unit, x.radius * unit) if isinstance(x, Uncertain) else x * unit
        for x in values
    )


@cache
def _degree() -> Fraction:
    """Return one degree in radians."""
    from mpmath import mp

    return _exact_mpf("pi", mp.pi(prec=_PI_BITS)) / 180


def is_true(field: str, value: bool) -> bool:
    """Check that an option is True or False, and return it.

    Raises InputError for other values.
    """
    if not isinstance(value, bool):
        raise InputError(field, written(value, repr), "must be true or false")
    return value


def exact(field: str, value: ExactNumber) -> Fraction:
    """Convert a number to an exact rational.

    Raises InputError unless it is finite and real.
    """
    given: Any = value
    if isinstance(given, str):
        return _exact_text(field, given)
    if isinstance(given, bool) or type(given).__name__ == "timedelta64":  # an integer to NumPy
        raise InputError(field, given, "must be a number")
    if isinstance(given, Uncertain) or (_is_ball(given) and given.rad() != 0):
        raise InputError(field, given, "is uncertain; it must be exact")
    if hasattr(given, "_mpf_"):  # mpmath's numbers, and balls of radius 0, which look like them
        return _exact_mpf(field, given)
    if isinstance(given, Rational):
        # A fraction would keep NumPy's integers, which overflow.
        return Fraction(int(given.numerator), int(given.denominator))
    if isinstance(given, Real | Decimal):  # NumPy's floats, too
        if not (given.is_finite() if isinstance(given, Decimal) else math.isfinite(given)):
            raise InputError(field, given, "must be finite")
        return Fraction(*given.as_integer_ratio())
    raise InputError(field, written(given, repr), "must be a number")


def _is_ball(value: object) -> bool:
    """Return True if a value is a ball of python-flint, which has a middle and a radius."""
    return hasattr(value, "rad") and hasattr(value, "mid")


def _exact_mpf(field: str, value: "_mpf | flint.arb") -> Fraction:
    sign, mantissa, exponent, _ = value._mpf_
    if not mantissa and exponent:  # mpmath's way to write nan and the infinities
        raise InputError(field, value, "must be finite")
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _exact_text(field: str, text: str) -> Fraction:
    exponent = re.search(r"[eE]([+-]?\d+)\s*$", text)
    if exponent and not _HEX.match(text) and abs(Decimal(exponent[1])) > _LARGEST_EXPONENT:
        raise InputError(field, written(text, repr), f"exponents go up to {_LARGEST_EXPONENT}")
    try:
        if _HEX.match(text.strip()):
            return Fraction(float.fromhex(text))
        if len(text) <= _INT_DIGITS:
            return Fraction(text)
        # Decimals, because int() reads no more than 4300 digits.
        top, slash, bottom = text.partition("/")
        return Fraction(Decimal(top)) / (Fraction(Decimal(bottom)) if slash else 1)
    except (InvalidOperation, ValueError, OverflowError, ZeroDivisionError):
        raise InputError(field, written(text, repr), "must be a finite decimal number") from None


def vector(
    field: str, values: Vector3 | Quaternion, length: int, next_step: str = ""
) -> tuple[Number, ...]:
    """Convert user input to a vector of exact or uncertain numbers.

    next_step: how the message says to give another kind of value.  Raises InputError for a wrong
    length.
    """
    items = sequence(field, values, next_step=next_step or f"{length} of them")
    if len(items) != length:
        rule = f"must have {length} numbers, not {len(items)}"
        raise InputError(field, values, rule, next_step=next_step)
    return tuple(number(f"{field}[{k}]", item) for k, item in enumerate(items))


def sequence(field: str, values: Any, ndim: int = 1, next_step: str = "") -> list[Any]:
    """Return the items of an ordered sequence or array that has `ndim` axes.

    Raises InputError for other values.
    """
    values = containers.plain(field, values)
    unordered = isinstance(values, str | bytes | Set | Mapping)
    if unordered or not isinstance(values, Iterable) or getattr(values, "ndim", ndim) != ndim:
        rule = "must be a list of numbers"
        raise InputError(field, written(values, repr), rule, next_step=next_step)
    return list(values)


NO_BODY = "no body has a principal moment larger than the sum of the other two"
# What to do with a tensor where moments are expected.
PRINCIPAL = "of an inertia tensor, rigidsym.principal_axes(tensor) has them"
ROTATIONS = (
    "scalar first; SciPy's Rotation.from_matrix and from_euler make attitudes of other kinds"
)
# How to have such a body accepted.
ALLOW = "allow_nonphysical=True or --allow-nonphysical lets it pass"


def inertia(
    values: Vector3, allow_nonphysical: bool = False, next_step: str = ALLOW
) -> tuple[Number, ...]:
    """Convert user input to the principal moments of inertia of a body.

    next_step: how the message says to have other moments accepted.  Raises InputError unless a body
    can have them.
    """
    rows = isinstance(values, list | tuple) and all(isinstance(x, list | tuple) for x in values)
    if getattr(values, "shape", None) == (3, 3) or (rows and values):
        raise InputError("inertia", values, "must be a list of numbers", next_step=PRINCIPAL)
    given = sequence("inertia", values, next_step="3 of them, about principal axes")
    moments = vector("inertia", given, 3)
    least, most = ([_end(moment, side) for moment in moments] for side in (-1, 1))
    for k, moment in enumerate(least):
        if moment <= 0:
            raise InputError(f"inertia[{k}]", given[k], "principal moments must be positive")
    high = max(range(3), key=least.__getitem__)
    others = [most[k] for k in range(3) if k != high]
    if not allow_nonphysical and not can_exist(least[high], *others):
        raise InputError("inertia", shown(moments), NO_BODY, next_step=next_step)
    return moments


def can_exist(largest: Fraction, *others: Fraction) -> bool:
    """Return True if positive moments satisfy the triangle inequality, within rounding.

    The largest is at most the sum of the others, or that sum as a double, or beyond it by 2^-50 of
    the smallest.  Rounding makes flat bodies exceed the sum: the second condition is for moments
    added in doubles, however different, the third for three that were each rounded.

    >>> can_exist(Fraction(0.1 + 0.2), Fraction(0.1), Fraction(0.2))
    True
    >>> can_exist(Fraction(1 + 2**-52), Fraction(1), Fraction(1e-30))
    False
    """
    total = sum(others, Fraction(0))
    # The nearest number of 53 bits, whatever its exponent.
    unit = Fraction(2) ** (total.numerator.bit_length() - total.denominator.bit_length())
    rounded = Fraction(float(total / unit)) * unit
    return largest <= max(rounded, total + ROUNDING * min(others))


def _end(value: Number, side: int) -> Fraction:
    """Return the smallest or the largest value that an uncertain number can have.

    side: -1 for the smallest, 1 for the largest.
    """
    return middle(value) + side * radius(value)


def attitude(values: Quaternion, field: str = "attitude0") -> tuple[Number, ...]:
    """Convert user input to an attitude quaternion, scalar first.

    It may have any length but zero.
    """
    quaternion = vector(field, values, 4, ROTATIONS)
    if all(_end(x, -1) <= 0 <= _end(x, 1) for x in quaternion):
        raise InputError(field, shown(quaternion), "must not be zero")
    return quaternion


def times(values: Times) -> tuple[tuple[Fraction, ...], bool]:
    """Convert user input to a sequence of exact times.

    Also returns True if they are a single number.
    """
    given: Any = values
    if (found := containers.ticks("t", containers.unwrapped("t", given))) is not None:
        count, unit = found
        return tuple(int(k) * unit for k in count.ravel()), not count.ndim
    if isinstance(given, str | Real | Decimal) or hasattr(given, "_mpf_"):
        return (exact("t", given),), True
    if getattr(given, "ndim", 1) == 0:
        return (exact("t", given.item()),), True
    return tuple(exact(f"t[{k}]", x) for k, x in enumerate(sequence("t", values))), False


def digits(value: int) -> int:
    """Check a number of significant digits and return it."""
    return whole("digits", value, MOST_DIGITS)


def whole(field: str, value: int, most: int) -> int:
    """Check that a number is whole and from 1 to `most`, and return it."""
    try:
        count = 0 if isinstance(value, bool) else operator.index(value)
    except TypeError:
        count = 0
    if not 1 <= count <= most:
        raise InputError(
            field, written(value, repr), f"must be a whole number, at least 1 and at most {most}"
        )
    return count


def seconds(value: ExactNumber | None) -> float | None:
    """Check a time limit in seconds, and return it as a float.

    It must be above zero.  None stands for no limit and is returned as it is.
    """
    if value is None:
        return None
    limit = exact("max_seconds", value)
    if limit <= 0:
        raise InputError("max_seconds", value, "must be above zero")
    return float(min(limit, _LONGEST))


def doubles(field: str, values: Sequence[Fraction]) -> list[float]:
    """Round exact numbers to the nearest doubles.

    Raises InputError if one overflows.
    """
    try:
        return [float(value) for value in values]
    except OverflowError:
        raise InputError(field, shown(values), "is beyond the range of binary64") from None


def shown(values: Sequence[Number]) -> str:
    """Format numbers as a list for messages, with 12 digits each."""
    texts = (str(x) if isinstance(x, Uncertain) else decimal(x, 12) for x in values)
    return f"[{', '.join(texts)}]"


def decimal(value: Fraction, digits: int) -> str:
    """Format a rational as a decimal with `digits` digits, without trailing zeros."""
    context = Context(prec=digits, Emax=MAX_EMAX, Emin=MIN_EMIN)
    return str(context.divide(Decimal(value.numerator), Decimal(value.denominator)))


def exact_text(value: Fraction) -> str:
    """Format a number so that `exact` reads it back exactly.

    A short decimal where there is one, else a double in hexadecimal, else a fraction.
    """
    short = decimal(value, _SHORT)
    if Fraction(short) == value:
        return short
    nearest = float(value) if abs(value) < 2**1023 else 0.0
    if Fraction(nearest) == value:
        return nearest.hex()
    # Decimals, because Python writes no whole number of more than 4300 digits.
    return f"{Decimal(value.numerator)}/{Decimal(value.denominator)}"
