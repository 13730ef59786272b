"""Decisions on one motion from its numbers: checks, scales, order of axes, separatrix, time domain.

Moments c, differences `apart` (of each moment and the next in turn), rates and times are in inner
units; a, b, d are the numbers of axes, b that of the middle moment.
"""


@inline
def is_zero(x: double) -> bool:
    """Return True for zero of either sign."""
    return not (x < 0.0 or x > 0.0)


@inline
def scaled_by(x: double, n: int) -> double:
    """Return x 2^n, by `ldexp` where 2^n is no normal double."""
    return (
        x * power_of_two(double(n)) if n >= LEAST_EXPONENT and n <= MOST_EXPONENT else ldexp(x, n)
    )


@inline
def scaled(x: pair, n: int) -> pair:
    """Return x 2^n."""
    return pair(scaled_by(x.hi, n), scaled_by(x.lo, n))


def scale_of(x: double, y: double, z: double) -> int:
    """Return the exponent e of the largest size, so that x 2^-e is below 2; -1 for zeros."""
    first: double = max(abs(x), abs(y))
    largest: double = max(first, abs(z))
    return exponent(largest) - 1


def scale_of_attitude(q: double[4]) -> int:
    """Return the exponent of a quaternion's largest component; -1 for zeros."""
    first: double = max(abs(q[0]), abs(q[1]))
    return scale_of(first, q[2], q[3])


def scaled_rate(x: double, n: int) -> double:
    """Return x 2^n, or the least double of its sign where that is zero but x is not."""
    y: double = scaled_by(x, n)
    smallest: double = -LEAST if x < 0.0 else LEAST
    return smallest if is_zero(y) and not is_zero(x) else y


def broken_rule(inertia: double[3], c: pair[3], attitude0: double[4]) -> int:
    """Return the code of the first rule that finite numbers of a body break, or OK.

    c: the moments in inner units.
    """
    smaller: double = min(inertia[0], inertia[1])
    smallest: double = min(smaller, inertia[2])
    thinner: double = min(c[0].hi, c[1].hi)
    thinnest: double = min(thinner, c[2].hi)
    no_attitude: bool = (
        is_zero(attitude0[0])
        and is_zero(attitude0[1])
        and is_zero(attitude0[2])
        and is_zero(attitude0[3])
    )
    attitude: int = ATTITUDE if no_attitude else OK
    thin: int = THIN if thinnest < min_moment_ratio else attitude
    nonphysical: int = thin if ALLOW_NONPHYSICAL or can_exist(c) else NONPHYSICAL
    return nonphysical if smallest > 0.0 else INERTIA


def normalised(q: pair[4]) -> tuple[pair, pair, pair, pair]:
    """Return a quaternion divided by its length."""
    square: pair = ((q[0] * q[0] + q[1] * q[1]) + q[2] * q[2]) + q[3] * q[3]
    length: pair = sqrt(square)
    q_0: pair = q[0] / length
    q_1: pair = q[1] / length
    q_2: pair = q[2] / length
    q_3: pair = q[3] / length
    return q_0, q_1, q_2, q_3


@inline
def not_negligible(rate: pair) -> pair:
    """Return a rate, or zero where it is negligible beside the largest."""
    zero: pair = pair(0.0, 0.0)
    return zero if abs(rate.hi) < negligible else rate


def is_at_rest(omega: pair[3]) -> bool:
    """Return True if all rates are zero."""
    return is_zero(omega[0].hi) and is_zero(omega[1].hi) and is_zero(omega[2].hi)


@inline
def difference(apart: pair[3], j: int, k: int) -> pair:
    """Return c_j - c_k of two different axes."""
    return apart[j] if k == (j + 1) % 3 else -apart[k]


@inline
def ordered(apart: pair[3], j: int, k: int) -> tuple[int, int]:
    """Return two axes, that of the larger moment first; equal ones keep their order."""
    swaps: bool = difference(apart, j, k).hi < 0.0
    first: int = k if swaps else j
    second: int = j if swaps else k
    return first, second


def sorted_axes(apart: pair[3]) -> tuple[int, int, int]:
    """Return the axes by their moments, largest first; equal ones keep their order."""
    one, other = ordered(apart, 0, 1)
    rest, d = ordered(apart, other, 2)
    a, b = ordered(apart, one, rest)
    return a, b, d


def mark(x: pair) -> double:
    """Return 0 for zero, else 1."""
    return 0.0 if is_zero(x.hi) else 1.0


def side_of(apart: pair[3], omega: pair[3], a: int, b: int, d: int, E_b: double) -> double:
    """Return 1 or -1 where a is the axis of largest or smallest moment, 0 where rates are constant.

    The axes are sorted by their moments.
    """
    return circulation(
        mark(difference(apart, a, b)),
        mark(difference(apart, a, d)),
        mark(difference(apart, b, d)),
        mark(omega[a]),
        mark(omega[b]),
        mark(omega[d]),
        E_b,
    )


def discriminant_of(c: pair[3], apart: pair[3], omega: pair[3], a: int, b: int, d: int) -> pair:
    """Return E_b to all digits of a pair, from exact arithmetic where its terms cancel."""
    c_ab: pair = difference(apart, a, b)
    c_bd: pair = difference(apart, b, d)
    zero: pair = pair(0.0, 0.0)
    scale: int = scale_of(omega[a].hi, omega[d].hi, 0.0)
    rate_a: pair = scaled(omega[a], -scale)
    rate_d: pair = scaled(omega[d], -scale)
    over: pair = discriminant_dd(c[a], c[d], c_ab, c_bd, rate_a, zero)
    under: pair = discriminant_dd(c[a], c[d], c_ab, c_bd, zero, rate_d)
    E_b: pair = over + under
    if not abs(E_b.hi) > (over.hi - under.hi) / 1024.0 and not is_zero(over.hi):
        E_b = exact_discriminant(c[a].hi, c[b].hi, c[d].hi, rate_a.hi, rate_d.hi)
    return scaled(E_b, 2 * scale)


def log2_of(x: double) -> double:
    """Return log2(x), x >= 0, without an exception for zero."""
    return log2(x) if x > 0.0 else -inf


def log2_sum(x: double, y: double) -> double:
    """Return log2(2^x + 2^y); both may be minus infinity."""
    most: double = max(x, y)
    other: double = min(x, y)
    return most + log2(1.0 + exp2(other - most)) if isfinite(most) else most


def follow(
    c: pair[3],
    apart: pair[3],
    given: pair[3],
    omega: pair[3],
    a: int,
    b: int,
    d: int,
    E_b: double,
    is_faint: bool,
) -> tuple[bool, bool, double]:
    """Return whether a motion is replaced by another, whether by spin, and its last time.

    A separatrix motion replaces a motion whose E_b is too faint.  Spin about the middle axis
    replaces a motion for which rates taken for zero could decide when that spin turns over.  The
    last time is that up to which the replacement is close enough.

    With X = sqrt(c_a |c_a - c_b|) Omega_a, Z = sqrt(c_d |c_b - c_d|) Omega_d Euler's equations are
    X' = k Omega_b Z, Z' = k Omega_b X, up to signs.  So X + Z and X - Z, whose product is E_b, grow
    no faster than exp(lambda t), where lambda is k times the largest |Omega_b|.  One of them is
    zero on the separatrix, and both are zero in spin.  Those that are not zero may grow to the
    share `tolerated` of the momentum.  Logarithms have base 2: the numbers themselves leave the
    range of binary64.
    """
    c_a: double = c[a].hi
    c_b: double = c[b].hi
    c_d: double = c[d].hi
    rate_b: double = given[b].hi
    rate_d: double = given[d].hi
    over: double = abs(difference(apart, a, b).hi)
    under: double = abs(difference(apart, b, d).hi)
    largest: double = max(c_a, c_d)
    smallest: double = min(c_a, c_d)
    weight_a: double = 0.5 * log2_of(c_a * over)
    weight_d: double = 0.5 * log2_of(c_d * under)
    part_a: double = weight_a + log2_of(abs(given[a].hi))
    part_d: double = weight_d + log2_of(abs(rate_d))
    loses_a: bool = is_zero(omega[a].hi)
    loses_d: bool = is_zero(omega[d].hi)
    gone: double = log2_sum(part_a if loses_a else -inf, part_d if loses_d else -inf)
    left: double = log2_sum(-inf if loses_a else part_a, -inf if loses_d else part_d)
    momentum_0: double = c[0].hi * abs(given[0].hi)
    momentum_1: double = c[1].hi * abs(given[1].hi)
    momentum_2: double = c[2].hi * abs(given[2].hi)
    larger: double = max(momentum_0, momentum_1)
    momentum: double = max(larger, momentum_2)
    whole: double = log2_sum(part_a, part_d)
    distance: double = log2_of(abs(E_b))
    spins: bool = gone > left + log2(decisive) or (
        is_faint and distance > 2.0 * whole + log2(decisive)
    )
    growth: double = sqrt(
        over / c_a * (under / c_d) * (rate_b * rate_b)
        + under / c_b * ((over + under) / c_a) * (rate_d * rate_d)
    )
    speed: double = log2_of(growth) + log2(smallest / largest)
    slow: double = min(0.0, speed)
    room: double = (
        min(weight_a, weight_d)
        + log2(momentum / largest)
        + slow
        - (whole if spins else distance - whole)
    )
    doublings: double = log2(tolerated) + room
    until: double = log(2.0) * doublings / growth if doublings > 0.0 else 0.0
    close: double = min(until, max_angle)
    follows: bool = spins or is_faint
    last: double = close if follows else max_angle
    return follows, spins, last


def course(
    c: pair[3], apart: pair[3], given: pair[3], omega: pair[3], a: int, b: int, d: int, E_b: pair
) -> tuple[double, pair, pair, pair, pair]:
    """Return a motion's last time, and the rates and E_b that it is computed from until then.

    given: the rates; omega: the same but for negligible ones, which are zero.
    """
    is_asymmetric: bool = not (is_zero(apart[0].hi) or is_zero(apart[1].hi) or is_zero(apart[2].hi))
    is_faint: bool = not is_zero(E_b.hi) and abs(E_b.hi) < min_discriminant
    loses_a: bool = is_zero(omega[a].hi) and not is_zero(given[a].hi)
    loses_d: bool = is_zero(omega[d].hi) and not is_zero(given[d].hi)
    zero: pair = pair(0.0, 0.0)
    follows: bool = False
    spins: bool = False
    last: double = max_angle
    if is_asymmetric and (is_faint or loses_a or loses_d):
        follows, spins, last = follow(c, apart, given, omega, a, b, d, E_b.hi, is_faint)
    omega_0: pair = zero if spins and b != 0 else omega[0]
    omega_1: pair = zero if spins and b != 1 else omega[1]
    omega_2: pair = zero if spins and b != 2 else omega[2]
    found: pair = zero if follows else E_b
    return last, omega_0, omega_1, omega_2, found


def limit(last: double, rate: double, other: double) -> double:
    """Return the last time, earlier for nonphysical bodies that speed up a lot after t = 0."""
    larger: double = max(abs(rate), abs(other))
    largest: double = max(larger, 16.0)
    earlier: double = 16.0 * max_angle / largest
    return min(last, earlier)


def is_held(unit: double, A_a: double, A_b: double, A_d: double) -> bool:
    """Return True if no rate, up to its amplitude, overflows."""
    return A_a * unit <= max_rate and A_b * unit <= max_rate and A_d * unit <= max_rate


def all_finite(n: size, x: double[...]) -> bool:
    """Return True if n doubles are finite."""
    for k in range(n):
        if not isfinite(x[k]):
            return False
    return True
