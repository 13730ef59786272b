"""Double-double arithmetic over NumPy arrays, and other functions that generated lines call.

Functions take arrays or floats; for floats they use Python's own arithmetic, which is faster.
"""

import math
from typing import Any

import numpy as np

# --- double-doubles ---
_SPLITTER = 134217729.0
_SHIFT = 6755399441055744.0
# Whole numbers by which products are exact.
_EXACT = frozenset((-16, -8, -4, -2, -1, 1, 2, 4, 8, 16))


def _product_error(a, b, p):
    """Return the rounding error a b - p of p for |a|, |b| < 2^995 (Dekker, Veltkamp)."""
    c, d = _SPLITTER * a, _SPLITTER * b
    a1, b1 = c - (c - a), d - (d - b)
    a2, b2 = a - a1, b - b1
    error = a1 * b1
    error -= p
    error += a1 * b2
    error += a2 * b1
    error += a2 * b2
    return error


def _two_sum(a, b):
    """Return a + b exactly, as a rounded sum and its error (Knuth)."""
    s = a + b
    c = s - a
    return s, (a - (s - c)) + (b - c)


def _quick_sum(a, b):
    """Return a + b exactly, for |a| >= |b| (Dekker)."""
    s = a + b
    return _DoubleDouble(s, b - (s - a))


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
        if not isinstance(other, _DoubleDouble):
            s, e = _two_sum(self.hi, other)
            return _quick_sum(s, e + self.lo)
        s, e = _two_sum(self.hi, other.hi)
        t, f = _two_sum(self.lo, other.lo)
        e += t
        v = s + e
        return _quick_sum(v, (e - (v - s)) + f)

    __radd__ = __add__

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        a = self.hi
        if isinstance(other, _DoubleDouble):
            b = other.hi
            p = a * b
            e = _product_error(a, b, p)
            e += a * other.lo + self.lo * b
        elif type(other) is int and other in _EXACT:
            return _DoubleDouble(a * other, self.lo * other)
        else:
            p = a * other
            e = _product_error(a, other, p)
            e += self.lo * other
        return _quick_sum(p, e)

    __rmul__ = __mul__

    def __truediv__(self, other):
        b, b_lo = (other.hi, other.lo) if isinstance(other, _DoubleDouble) else (other, 0.0)
        q = self.hi / b
        p = b * q
        e = _product_error(b, q, p) + b_lo * q
        r = p + e
        return _quick_sum(q, ((self.hi - r) + (self.lo - (e - (r - p)))) / b)

    def __rtruediv__(self, other):
        return _DoubleDouble(other) / self

    def __abs__(self):
        sign = _choose(0.0, self.hi, 1.0, -1.0)
        return _DoubleDouble(sign * self.hi, sign * self.lo)

    def sqrt(self):
        s = math.sqrt(self.hi) if type(self.hi) is float else np.sqrt(self.hi)
        p = s * s
        rest = (self.hi - p) + (self.lo - _product_error(s, s, p))
        return _quick_sum(s, rest / (2 * s + (s == 0)))


def _sqrt(x):
    if isinstance(x, _DoubleDouble):
        return x.sqrt()
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
    if type(x.hi) is float:
        return _DoubleDouble(math.ldexp(x.hi, int(e)), math.ldexp(x.lo, int(e)))
    return _DoubleDouble(np.ldexp(x.hi, e.astype(int)), np.ldexp(x.lo, e.astype(int)))


def _power(x):
    """Return the exponent e with |x| 2^-e between 1/2 and 1."""
    return math.frexp(x)[1] if type(x) is float else np.frexp(x)[1]


def _ldexp(x, exponent):
    return math.ldexp(x, exponent) if type(x) is float else np.ldexp(x, exponent)


def _largest(columns):
    sizes = [abs(x) for x in columns]
    return max(sizes) if type(sizes[0]) is float else np.maximum.reduce(sizes)


def _taken(columns, axis):
    """Select the column of an axis, or for each body the column of its own axis."""
    if type(axis) is int:
        return columns[axis]
    if isinstance(columns[0], _DoubleDouble):
        halves = ([x.hi for x in columns], [x.lo for x in columns])
        return _DoubleDouble(*(np.choose(axis, x) for x in halves))
    return np.choose(axis, columns)


def _reversed(first, columns):
    """Reverse the order of the columns where `first` is True."""
    if type(first) is bool:
        return columns[::-1] if first else columns
    return [_where(first, *both) for both in zip(columns[::-1], columns, strict=True)]
