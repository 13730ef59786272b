"""Samples in single precision: inputs of strata as floats, within the domain of modules for floats.

Floats have fewer exponents than doubles: numbers are brought into their range, and what is far
below the largest of its kind comes nearer to it.
"""

from dataclasses import replace
from fractions import Fraction
from math import copysign, nextafter

from rigidsym._codegen.formats import BINARY32
from rigidsym._codegen.forms import THETA, limits
from rigidsym.validate.strata._sample import Floats, Motion, Numbers, Sample

_LIMITS = {limit.name: limit.exponent for limit in limits(THETA, BINARY32)}
_MAX_ANGLE = 0.99 * 2.0 ** _LIMITS["max_angle"]
_DIGITS = BINARY32.digits
# Exponents that stay as they are, and by what the others are divided.
_NEAR, _FAR = 40, 17
_SHARE = 64


def in_singles(sample: Sample, time_digits: int = 2 * _DIGITS) -> Sample:
    """Return a sample with inputs in floats, and times of so many bits.

    Bodies can still exist, times are in proportion to those given, and halved until modules in
    single precision have states there.
    """
    inertia, omega0 = _moments(sample.inertia), _floats(sample.omega0)
    turning, given = Motion(inertia, omega0).turning, Motion(sample.inertia, sample.omega0).turning
    times = []
    for time in sample.times:
        angle = abs(time * given)
        while angle > _MAX_ANGLE:
            angle /= 2
        times.append(_rounded(copysign(angle / turning, time), time_digits))
    attitude0 = _floats(sample.attitude0)
    return replace(sample, inertia=inertia, omega0=omega0, attitude0=attitude0, times=tuple(times))


def _rounded(time: float, digits: int) -> float:
    """Round a time to a float, or to the sum of two."""
    high = BINARY32.rounded(time)
    return high if digits == _DIGITS else high + BINARY32.rounded(time - high)


def _moments(given: Numbers) -> Floats:
    """Return principal moments as floats that a body can have, none too thin."""
    found = _floats(given)
    least = BINARY32.rounded(max(found) * 2.0 ** _LIMITS["min_moment_ratio"] * 1.01)
    found = [max(x, least) for x in found]
    k = found.index(max(found))
    others = found[(k + 1) % 3] + found[(k + 2) % 3]
    if found[k] > others:
        found[k] = BINARY32.rounded(others)
        if found[k] > others:
            found[k] = BINARY32.rounded(nextafter(found[k] * (1 - 2.0**-_DIGITS), 0.0))
    return tuple(found)


def _floats(given: Numbers) -> Floats:
    """Return numbers as floats, with exponents that floats have."""
    exact = [Fraction(x) for x in given]
    top = max((_exponent(x) for x in exact if x), default=0)
    kept = top if abs(top) <= _NEAR else int(copysign(_NEAR + (abs(top) - _NEAR) // _FAR, top))
    found = []
    for x, plain in zip(exact, given, strict=True):
        below = top - _exponent(x) if x else 0
        near = below if below <= _DIGITS else _DIGITS + (below - _DIGITS) // _SHARE
        shift = Fraction(2) ** (kept - near - _exponent(x)) if x else 1
        found.append(BINARY32.rounded(x * shift) if x else float(plain))
    return tuple(found)


def _exponent(x: Fraction) -> int:
    """Return the exponent of a number other than zero, at most one too large."""
    return x.numerator.bit_length() - x.denominator.bit_length()
