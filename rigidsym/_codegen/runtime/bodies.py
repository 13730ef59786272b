"""Moments of inertia that a body can have."""


@inline
def is_above(x: pair, y: pair) -> bool:
    """Return True if x > y."""
    return x.hi > y.hi or (x.hi >= y.hi and x.lo > y.lo)


def can_exist(c: pair[3]) -> bool:
    """Return True for moments that a body can have, up to rounding.

    The largest is at most the sum of the others, or that sum as a double, or beyond it by 2^-50 of
    the smallest.
    """
    second: int = 1 if is_above(c[1], c[0]) else 0
    high: int = 2 if is_above(c[2], c[second]) else second
    one: pair = c[(high + 1) % 3]
    other: pair = c[(high + 2) % 3]
    most: pair = c[high]
    total: pair = one + other
    beyond: pair = two_sum(most.hi - total.hi, most.lo - total.lo)
    allowed: double = ROUNDING * min(one.hi, other.hi)
    return (
        ALLOW_NONPHYSICAL
        or most.hi < total.hi
        or (most.hi <= total.hi and most.lo <= 0.0)
        or beyond.hi < allowed
        or (beyond.hi <= allowed and beyond.lo <= 0.0)
    )
