"""Elementary functions for targets that have no mathematical library, from bits and arithmetic.

All are exact or rounded to nearest, but `fused`: their values are those of every other library.
"""

size_bits: bits = 0x7FFFFFFFFFFFFFFF
"all bits below the sign"
least_normal: double = 2.2250738585072014e-308
"2^-1022: numbers below have fewer digits"


@inline
def abs(x: double) -> double:
    """Return |x|."""
    return from_bits(bits_of(x) & size_bits)


@inline
def copysign(x: double, y: double) -> double:
    """Return the size of x with the sign of y."""
    sign: bits = bits_of(y) >> sign_place
    return from_bits((bits_of(x) & size_bits) | (sign << sign_place))


@inline
def fused(a: double, b: double, c: double) -> double:
    """Return a b + c, rounded twice."""
    return a * b + c


def exponent(x: double) -> int:
    """Return the e for which |x| is between 2^(e - 1) and 2^e, and 0 for zero."""
    is_small: bool = abs(x) < least_normal
    y: double = x * 18014398509481984.0 if is_small else x
    every: bits = bits_of(y) & size_bits
    e: int = int(every >> exponent_place) - 1022
    return e - 54 if is_small and abs(x) > 0.0 else 0 if is_small else e


def ldexp(x: double, n: int) -> double:
    """Return x 2^n, rounded once, for |n| <= 4000.

    Only the last factor can leave a subnormal number that is not zero.
    """
    y: double = x
    rest: int = n
    for k in range(3):
        if rest > 1023:
            y *= 8.98846567431158e307
            rest -= 1023
        if rest < -1022:
            y *= 2.004168360008973e-292
            rest += 969
    return y * power_of_two(double(rest))


def sqrt(x: double) -> double:
    """Return the root of x, rounded to nearest.

    x is m 4^k with m between 1 and 4.  Newton's method gives 1/sqrt(m), and m times this is the
    root s to an error below 2^-52.  The exact residual m - s^2 then decides between s and its
    neighbours: sqrt(m) is beyond s + 2^-53 where m - s^2 > 2^-52 s, since both sides are whole
    multiples of 2^-104, and up to s - 2^-53 where m - s^2 <= -2^-52 s.
    """
    if not (x > 0.0 and isfinite(x)):
        return x if not x < 0.0 else nan
    is_small: bool = x < least_normal
    every: bits = bits_of(x * 18014398509481984.0 if is_small else x)
    place: bits = every >> exponent_place
    m: double = from_bits((every & fraction_bits) | (1024 - (place & 1) << exponent_place))
    power: double = from_bits((place + 1023 >> 1) << exponent_place)
    over: double = from_bits(0x5FE6EB50C7B537A9 - (bits_of(m) >> 1))
    for k in range(4):
        over *= 1.5 - 0.5 * m * over * over
    s: double = m * over
    square: double = s * s
    rest: double = (m - square) - product_error(s, s, square)
    s += 0.5 * over * rest
    square = s * s
    rest = (m - square) - product_error(s, s, square)
    last: double = 2.220446049250313e-16
    if rest > last * s:
        s += last
    if rest <= -last * s:
        s -= last
    return s * power * 7.450580596923828e-09 if is_small else s * power
