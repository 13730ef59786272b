"""Logarithms and powers of two for targets that have no mathematical library.

They decide time domains alone, so that other values in the last digits change no state.
"""


def log(x: double) -> double:
    """Return the natural logarithm of x > 0."""
    e: int = exponent(x)
    mantissa: pair = pair(ldexp(x, -e), 0.0)
    return rounded(logarithm(mantissa) + double(e) * log_2)


def log2(x: double) -> double:
    """Return the binary logarithm of x > 0."""
    e: int = exponent(x)
    mantissa: pair = pair(ldexp(x, -e), 0.0)
    return double(e) + rounded(logarithm(mantissa) / log_2)


def exp2(x: double) -> double:
    """Return 2^x for x <= 0."""
    return exponential(x * log_2.hi)
