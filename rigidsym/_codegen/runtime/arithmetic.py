"""Extended numbers: unevaluated sums hi + lo of two doubles, |lo| <= ulp(hi)/2.

The relative errors, with u = 2^-53, are those of Joldes, Muller and Popescu (ACM TOMS 44(2), 2017):
3 u^2 for sums, 5 u^2 for products, 15 u^2 for quotients; 25/8 u^2 for roots (Lefevre, Louvet,
Muller, Picot and Rideau, ACM TOMS 49(1), 2023).

A target brings `fused`, `product_error`, `sqrt`, `bits_of`, `from_bits` and `hidden` itself;
without fused multiply-add, `product_error` is `split_product_error`.  The constants below are those
of binary64; `Format.arithmetic` has those of every format.
"""

splitter: double = 134217729.0
"2^27 + 1"
rounder: double = 6755399441055744.0
"3 2^51; in n + 3 2^51 the last bits are those of the whole number n, |n| < 2^51"
least_whole: double = 4503599627370496.0
"2^52: from here on doubles are whole numbers"
exponent_bias: double = 1023.0
"what the exponent among the bits of 1 is"
sign_place: int = 63
"the place of the sign among the bits"
exponent_place: int = 52
"the place of the exponent among the bits"
one_bits: bits = 0x3FF0000000000000
"the bits of 1"
half_bits: bits = 0x3FE0000000000000
"the bits of 1/2"
least_whole_bits: bits = 0x4330000000000000
"the bits of 2^52"
fraction_bits: bits = 0x000FFFFFFFFFFFFF
"all bits below the exponent"


@inline
def upper_half(a: double) -> double:
    """Return the upper half of the digits of a (Veltkamp); a must stay below 2^995."""
    c: double = splitter * a
    d: double = c - a
    return c - d


@inline
def split_product_error(a: double, b: double, p: double) -> double:
    """Return a b - p exactly, where p is the rounded product (Dekker)."""
    a1: double = upper_half(a)
    b1: double = upper_half(b)
    a2: double = a - a1
    b2: double = b - b1
    error: double = a1 * b1
    error -= p
    error += a1 * b2
    error += a2 * b1
    error += a2 * b2
    return error


@inline
def nearest(x: double) -> double:
    """Return the nearest whole number, for |x| < 2^51."""
    shifted: double = x + rounder
    return shifted - rounder


@inline
def alternating(n: double) -> double:
    """Return (-1)^n for a whole number n: its last bit becomes the sign of 1."""
    return from_bits(one_bits | (bits_of(n + rounder) << sign_place))


@inline
def power_of_two(n: double) -> double:
    """Return 2^n for a whole number n between -1022 and 1023, from its bits."""
    return from_bits(bits_of(n + (rounder + exponent_bias)) << exponent_place)


@inline
def choose(x: double, y: double, one: double, other: double) -> double:
    """Return one where x <= y, else other."""
    return one if x <= y else other


@inline
def dd_of(a: double) -> pair:
    """Return a double as an extended number."""
    return pair(a, 0.0)


@inline
def two_sum(a: double, b: double) -> pair:
    """Return a + b exactly (Knuth)."""
    s: double = a + b
    c: double = s - a
    d: double = s - c
    return pair(s, (a - d) + (b - c))


@inline
def quick_sum(a: double, b: double) -> pair:
    """Return a + b exactly, for |a| >= |b| (Dekker)."""
    s: double = a + b
    c: double = s - a
    return pair(s, b - c)


@inline
def two_product(a: double, b: double) -> pair:
    """Return a b exactly."""
    p: double = a * b
    return pair(p, product_error(a, b, p))


@inline
def dd_neg(x: pair) -> pair:
    """Return -x."""
    return pair(-x.hi, -x.lo)


@inline
def dd_add_xx(x: pair, y: pair) -> pair:
    """Return x + y."""
    s: pair = two_sum(x.hi, y.hi)
    t: pair = two_sum(x.lo, y.lo)
    v: pair = quick_sum(s.hi, s.lo + t.hi)
    return quick_sum(v.hi, v.lo + t.lo)


@inline
def dd_add_xd(x: pair, y: double) -> pair:
    """Return x + y."""
    s: pair = two_sum(x.hi, y)
    return quick_sum(s.hi, s.lo + x.lo)


@inline
def dd_add_dx(x: double, y: pair) -> pair:
    """Return x + y."""
    return dd_add_xd(y, x)


@inline
def dd_sub_xx(x: pair, y: pair) -> pair:
    """Return x - y."""
    return dd_add_xx(x, dd_neg(y))


@inline
def dd_sub_xd(x: pair, y: double) -> pair:
    """Return x - y."""
    return dd_add_xd(x, -y)


@inline
def dd_sub_dx(x: double, y: pair) -> pair:
    """Return x - y."""
    return dd_add_xd(dd_neg(y), x)


@inline
def dd_mul_xx(x: pair, y: pair) -> pair:
    """Return x y."""
    p: pair = two_product(x.hi, y.hi)
    return quick_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi))


@inline
def dd_mul_xd(x: pair, y: double) -> pair:
    """Return x y."""
    p: pair = two_product(x.hi, y)
    return quick_sum(p.hi, p.lo + x.lo * y)


@inline
def dd_mul_dx(x: double, y: pair) -> pair:
    """Return x y."""
    return dd_mul_xd(y, x)


@inline
def dd_div_xx(x: pair, y: pair) -> pair:
    """Return x/y."""
    q: double = x.hi / y.hi
    r: pair = dd_mul_xd(y, q)
    return quick_sum(q, ((x.hi - r.hi) + (x.lo - r.lo)) / y.hi)


@inline
def dd_div_xd(x: pair, y: double) -> pair:
    """Return x/y."""
    q: double = x.hi / y
    r: pair = two_product(y, q)
    return quick_sum(q, ((x.hi - r.hi) + (x.lo - r.lo)) / y)


@inline
def dd_div_dx(x: double, y: pair) -> pair:
    """Return x/y."""
    return dd_div_xx(dd_of(x), y)


@inline
def dd_sqrt(x: pair) -> pair:
    """Return the root of x, zero for zero."""
    s: double = sqrt(x.hi)
    r: pair = two_product(s, s)
    rest: double = (x.hi - r.hi) + (x.lo - r.lo)
    divisor: double = 2.0 * s if s > 0.0 else 1.0
    return quick_sum(s, rest / divisor)


@inline
def dd_size(x: pair) -> pair:
    """Return |x|."""
    return dd_neg(x) if x.hi < 0.0 else x


@inline
def dd_rounded(x: pair) -> double:
    """Return x rounded to a double."""
    return x.hi if HIGH_IS_ROUNDED else x.hi + x.lo


@inline
def dd_choose(x: double, y: double, one: pair, other: pair) -> pair:
    """Return one where x <= y, else other."""
    return one if x <= y else other


@inline
def dd_exponent(x: pair) -> double:
    """Return the exponent e of x = m 2^e with m between sqrt(1/2) and sqrt(2), nearly.

    x is between 2^-1021 and 2^1022.  Its bits give a mantissa between 1/2 and 1 first.
    """
    every: bits = bits_of(x.hi)
    fraction: double = from_bits((every & fraction_bits) | half_bits)
    e: double = from_bits((every >> exponent_place) | least_whole_bits) - (
        least_whole + exponent_bias - 1.0
    )
    return e - 1.0 if fraction < 0.7071067811865475244 else e


@inline
def dd_mantissa(x: pair) -> pair:
    """Return the mantissa that belongs to `dd_exponent`."""
    power: double = power_of_two(-dd_exponent(x))
    return pair(x.hi * power, x.lo * power)
