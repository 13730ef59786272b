"""Double-double arithmetic over NumPy arrays, and other functions that generated lines call.

Functions take arrays or floats; for floats they use Python's own arithmetic, which is faster.
"""

import math
from typing import Any

import numpy as np

from rigidsym._codegen.targets.numpy.stubs import (
    _dd_add_xd,
    _dd_add_xx,
    _dd_div_xd,
    _dd_div_xx,
    _dd_mul_xd,
    _dd_mul_xx,
    _dd_sqrt,
)

# --- double-doubles ---
_SHIFT = 6755399441055744.0
# Whole numbers by which products are exact.
_EXACT = frozenset((-16, -8, -4, -2, -1, 1, 2, 4, 8, 16))


class _DoubleDouble:
    """The unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2.

    The relative errors, with u = 2^-53, are those of Joldes, Muller and Popescu (ACM TOMS 44(2),
    2017): 3 u^2 for sums, 5 u^2 for products, 15 u^2 for quotients; 25/8 u^2 for roots (Lefevre,
    Louvet, Muller, Picot and Rideau, ACM TOMS 49(1), 2023).
    """

    __slots__ = ("hi", "lo")
    __array_ufunc__ = None

    def __init__(self, hi: Any, lo: Any = 0.0):
        self.hi, self.lo = hi, lo

    def __getitem__(self, key):
        return _DoubleDouble(self.hi[key], self.lo[key])

    def __neg__(self):
        return _DoubleDouble(-self.hi, -self.lo)

    def __add__(self, other):
        if isinstance(other, _DoubleDouble):
            return _dd_add_xx(self, other)
        return _dd_add_xd(self, other)

    __radd__ = __add__

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if isinstance(other, _DoubleDouble):
            return _dd_mul_xx(self, other)
        if type(other) is int and other in _EXACT:
            return _DoubleDouble(self.hi * other, self.lo * other)
        return _dd_mul_xd(self, other)

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, _DoubleDouble):
            return _dd_div_xx(self, other)
        return _dd_div_xd(self, other)

    def __rtruediv__(self, other):
        return _DoubleDouble(other) / self

    def __abs__(self):
        sign = _choose(0.0, self.hi, 1.0, -1.0)
        return _DoubleDouble(sign * self.hi, sign * self.lo)


def _sqrt(x):
    if isinstance(x, _DoubleDouble):
        return _dd_sqrt(x)
    return math.sqrt(x) if type(x) is float else np.sqrt(x)


def _exp(x):
    return math.exp(x) if type(x) is float else np.exp(x)


def _horner(x, *coefficients):
    """Return c_0 + x (c_1 + x (c_2 + ...)); arrays are added and multiplied in place."""
    total = x * coefficients[-1]
    for c in coefficients[-2:0:-1]:
        total += c
        total *= x
    total += coefficients[0]
    return total


def _nearest(x):
    """Return the nearest whole number, for |x| < 2^51."""
    return (x + _SHIFT) - _SHIFT if type(x) is float else np.rint(x)


def _alternating(n):
    """Return (-1)^n for a whole number n."""
    half = 0.5 * n
    rest = half - _nearest(half)
    return 1.0 - 8.0 * (rest * rest)


def _choose(x, y, one, other):
    """Return `one` where x <= y, else `other`."""
    return _where(x <= y, one, other)


def _where(first, one, other):
    if type(first) is bool and type(one) is type(other):
        return one if first else other
    if isinstance(one, _DoubleDouble) or isinstance(other, _DoubleDouble):
        one, other = (x if isinstance(x, _DoubleDouble) else _DoubleDouble(x) for x in (one, other))
        hi, lo = _where(first, one.hi, other.hi), _where(first, one.lo, other.lo)
        return _DoubleDouble(1.0 * hi, lo)
    if isinstance(first, np.ndarray):
        return np.where(first, one, other)
    return one if first else other


def _rounded(x):
    return x.hi + x.lo if isinstance(x, _DoubleDouble) else x


def _exponent(x):
    """Return the exponent e with x 2^-e between sqrt(1/2) and sqrt(2), for x > 0."""
    if type(x.hi) is float:
        mantissa, e = math.frexp(x.hi)
        return float(e - (mantissa < 0.70710678118654752))
    mantissa, e = np.frexp(x.hi)
    return e - (mantissa < 0.70710678118654752) * 1.0


def _mantissa(x):
    e = -_exponent(x)
    n = int(e) if type(e) is float else e.astype(int)
    return _DoubleDouble(_ldexp(x.hi, n), _ldexp(x.lo, n))


def _power(x):
    """Return the exponent e with |x| 2^-e between 1/2 and 1."""
    return math.frexp(x)[1] if type(x) is float else np.frexp(x)[1]


def _ldexp(x, n):
    is_plain = type(x) is float and type(n) is int
    return math.ldexp(x, n) if is_plain else np.ldexp(x, n)


def _taken(columns, axis):
    """Select the column of an axis, or for each body the column of its own axis."""
    if type(axis) is int:
        return columns[axis]
    if isinstance(columns[0], _DoubleDouble):
        hi, lo = (_taken([getattr(x, end) for x in columns], axis) for end in ("hi", "lo"))
        return _DoubleDouble(hi, lo)
    # Several times as fast as `choose`.
    count = len(columns[0])
    return np.concatenate(columns).take(axis * count + np.arange(count))


def _reversed(first, columns):
    """Reverse the order of the columns where `first` is True."""
    if type(first) is bool:
        return columns[::-1] if first else columns
    return [_where(first, *both) for both in zip(columns[::-1], columns, strict=True)]


def _at(values, places):
    """Select bodies from columns; what is one number for all of them stays so."""
    if isinstance(values, list | tuple):
        return [_at(x, places) for x in values]
    return values[places] if isinstance(values, np.ndarray | _DoubleDouble) else values


def _only(chosen, compute, values, given):
    """Compute values for the chosen bodies alone, and put them among those of the others."""
    if not isinstance(chosen, np.ndarray):
        return compute(*given) if chosen else values
    at = np.flatnonzero(chosen)
    return _put(values, at, compute(*_at(given, at)), chosen) if at.size else values


def _put(values, at, found, like):
    if isinstance(values, tuple):
        return [_put(x, at, y, like) for x, y in zip(values, found, strict=True)]
    if isinstance(values, _DoubleDouble):
        hi, lo = _put((values.hi, values.lo), at, (found.hi, found.lo), like)
        return _DoubleDouble(hi, lo)
    whole = np.array(np.broadcast_to(values, like.shape))
    whole[at] = found
    return whole
