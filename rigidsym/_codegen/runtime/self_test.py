"""Tests of compiled arithmetic, which the compiler's options can spoil.

A zero that the compiler cannot see is added to all numbers, so that no compiler can compute the
outcome.
"""

quotient_cases: double[6, 4] = [
    [7.0, 3.0, 2.3333333333333335, -1.4802973661668753e-16],
    [3.0, 5.0, 0.6, 2.2204460492503132e-17],
    [7.0, 25.0, 0.28, -2.6645352591003756e-17],
    [15.0, 13.0, 1.1538461538461537, 1.0248212535001446e-16],
    [15.0, 22.0, 0.6818181818181818, 5.0464682937507114e-17],
    [13.0, 23.0, 0.5652173913043478, 4.344350965924526e-17],
]
"x, y, and x/y in two doubles"


def is_double_double(x: pair, hi: double, lo: double) -> bool:
    """Return True where x is hi + lo to all its digits."""
    return abs(x.hi - hi) <= 0.0 and abs(x.lo - lo) <= 1e-30


def bits_hold() -> bool:
    """Return True where the compiler itself fuses no product with a sum.

    Return True, too, where the bits were not chosen.
    """
    zero: double = hidden(0.0)
    more: double = zero + 1.000000000931322574615478515625
    less: double = zero + 0.999999999068677425384521484375
    return not BITS_ARE_CHOSEN or abs(more * less - (zero + 1.0)) <= 0.0


def sums_hold() -> bool:
    """Return True where sums and products are rounded once, to nearest, and no low part is lost."""
    zero: double = hidden(0.0)
    one: double = zero + 1.0
    many: double = zero + 49.0
    part: double = zero + 0.02040816326530612
    tiny: double = zero + 8.673617379884035e-19
    third: pair = pair(one * 0.3333333333333333, one * 1.850371707708594e-17)
    fifth: pair = pair(0.2, -1.1102230246251566e-17)
    seventh: pair = pair(one * 0.14285714285714285, one * 7.93016446160826e-18)
    return (
        bits_hold()
        and is_double_double(two_sum(one, tiny), 1.0, 8.673617379884035e-19)
        and is_double_double(two_sum(-tiny, one), 1.0, -8.673617379884035e-19)
        and is_double_double(two_product(part, many), 0.9999999999999999, 3.122502256758253e-17)
        and is_double_double(dd_mul_xx(third, third), 0.1111111111111111, 6.1679056923619804e-18)
        and is_double_double(
            dd_mul_xx(third, dd_mul_dx(one, fifth)), 0.06666666666666667, 9.251858538542971e-19
        )
        and is_double_double(dd_mul_xd(seventh, many), 7.0, 0.0)
    )


def quotients_hold() -> bool:
    """Return True where quotients and roots have all their digits.

    y (x/y) is not x, nor a root's square its radicand.  Compilers that assume so are wrong in one
    quotient of five, some of which are here.
    """
    zero: double = hidden(0.0)
    root: pair = dd_sqrt(dd_of(zero + 2.0))
    holds: bool = is_double_double(root, 1.4142135623730951, -9.667293313452913e-17)
    for k in range(6):
        x: double = zero + quotient_cases[k, 0]
        y: double = zero + quotient_cases[k, 1]
        hi: double = quotient_cases[k, 2]
        lo: double = quotient_cases[k, 3]
        holds = holds and is_double_double(dd_div_xd(dd_of(x), y), hi, lo)
        holds = holds and is_double_double(dd_div_dx(x, dd_of(y)), hi, lo)
    return holds
