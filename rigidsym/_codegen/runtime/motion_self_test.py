"""Tests of compiled arithmetic in functions of motions, before motions are computed."""

TIMES: size = 8
"times that `angles_hold` computes"
difference_cases: double[5] = [
    0.7260104308260092,
    0.48196654854338067,
    0.3559016780679596,
    0.15335179025447007,
    0.03588181116623288,
]
"three moments and two rates"
known_cosines: double[6] = [1.0, 0.5, -0.5, -1.0, -0.5, 0.5]
"those of multiples of sixty degrees"


def differences_hold() -> bool:
    """Return True where a difference of products has all its digits.

    clang's -ffp-contract=fast fuses sums with products across functions, so that low parts are
    counted twice.
    """
    zero: double = hidden(0.0)
    x: pair[5]
    for k in range(5):
        x[k] = dd_of(zero + difference_cases[k])
    above: pair = dd_sub_xx(x[0], x[1])
    below: pair = dd_sub_xx(x[1], x[2])
    found: pair = discriminant_dd(x[0], x[2], above, below, x[3], x[4])
    return is_double_double(found, 0.004108897986419382, -6.277847770376781e-21)


def angles_hold() -> bool:
    """Return True where the loop over times loses no turns.

    At t = 2^45 - 3 + i both angles, (t + 1)/3 and t/3 half turns, are multiples of sixty degrees,
    and their whole turns and all low parts count.
    """
    start: double = hidden(35184372088829.0)
    t: double[TIMES]
    t_lo: double[TIMES]
    to: double[6 * TIMES]
    motion: circular
    cleared(motion)
    motion.v_rate_hi = over_3.hi
    motion.v_rate_lo = over_3.lo
    motion.Lambda_rate_hi = over_3.hi
    motion.Lambda_rate_lo = over_3.lo
    motion.v_hi = over_3.hi
    motion.v_lo = over_3.lo
    for i in range(TIMES):
        t[i] = start + double(i)
        t_lo[i] = 0.0
    circular_angles(motion, TIMES, t, t_lo, *rows(to, TIMES))
    holds: bool = True
    for i in range(TIMES):
        cosine: double = to[TIMES + i]
        turned_cosine: double = to[3 * TIMES + i]
        holds = holds and abs(cosine - known_cosines[i % 6]) <= 1e-15
        holds = holds and abs(turned_cosine - known_cosines[(i + 5) % 6]) <= 1e-15
    return holds


def is_rounded_once() -> bool:
    """Return True where this build's arithmetic passes all tests."""
    return sums_hold() and differences_hold() and quotients_hold() and angles_hold()
