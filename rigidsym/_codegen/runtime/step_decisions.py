"""Decisions on a step of one body: checks, scales, order of axes, normalisation, rounding.

Axes a, b, d are in the order of their moments; a is the first, or the last where the momentum
circulates about that.
"""


def largest_of(x: double, y: double, z: double) -> double:
    """Return the largest size of three numbers."""
    larger: double = max(abs(y), abs(z))
    return max(abs(x), larger)


def size_of(q: double[4]) -> double:
    """Return the largest size of a quaternion's components."""
    larger: double = largest_of(q[1], q[2], q[3])
    return max(abs(q[0]), larger)


def scale(largest: double) -> int:
    """Return the exponent to scale by, 0 for moderate numbers and for what is not finite.

    The highest powers of moderate rates, for binary64 the 22nd, do not overflow.
    """
    is_moderate: bool = largest >= 1.0 / MODERATE and largest <= MODERATE
    return 0 if is_moderate or not isfinite(largest) else exponent(largest)


@inline
def times_power(x: double, power: int) -> double:
    """Return x 2^power, and x itself where the power is 0."""
    return ldexp(x, power) if power != 0 else x


# --- bodies


def moment_scale(inertia: double[3]) -> int:
    """Return the exponent that takes moments to their inner units."""
    return -scale(largest_of(inertia[0], inertia[1], inertia[2]))


def is_possible(c: double[3]) -> bool:
    """Return True for moments that a body can have, up to rounding."""
    moments: pair[3]
    for k in range(3):
        moments[k] = pair(c[k], 0.0)
    return can_exist(moments)


def body_code(inertia: double[3], c: double[3]) -> int:
    """Check the moments of a body, and these in inner units; return a code."""
    largest: double = largest_of(inertia[0], inertia[1], inertia[2])
    less: double = min(inertia[1], inertia[2])
    smallest: double = min(inertia[0], less)
    is_number: bool = not isnan(inertia[0] + inertia[1] + inertia[2])
    is_positive: bool = inertia[0] > 0.0 and inertia[1] > 0.0 and inertia[2] > 0.0
    divisor: double = largest if is_positive else 1.0
    return (
        (INERTIA if is_number else NOT_FINITE)
        if not is_positive
        else NOT_FINITE
        if not isfinite(largest)
        else NONPHYSICAL
        if not (ALLOW_NONPHYSICAL or is_possible(c))
        else THIN
        if smallest / divisor < min_moment_ratio
        else OK
    )


def order_of(inertia: double[3]) -> tuple[int, int, int, double]:
    """Return the axes by their moments, the largest first, and 1, or -1 where they are left-handed.

    Of equal moments, that of the axis next in turn is first.
    """
    above: int = 0 if inertia[0] >= inertia[2] else 2
    below: int = 1 if inertia[1] >= inertia[2] else 2
    first: int = above if inertia[0] >= inertia[1] else below
    one: int = (first + 1) % 3
    other: int = (first + 2) % 3
    is_turned: bool = inertia[one] < inertia[other]
    second: int = other if is_turned else one
    third: int = one if is_turned else other
    epsilon: double = -1.0 if is_turned else 1.0
    return first, second, third, epsilon


# --- states


def state_code(q: double[4], omega: double[3], dt: double) -> int:
    """Check an attitude, rates and a time; return a code."""
    sum: double = dt
    for k in range(3):
        sum += 0.0 * omega[k] + 0.0 * q[1 + k]
    is_number: bool = isfinite(sum + 0.0 * q[0])
    return NOT_FINITE if not is_number else OK if size_of(q) > 0.0 else ATTITUDE


def scaled_time(omega: double[3], dt: double) -> tuple[int, bool, double]:
    """Return the exponent that scales rates, whether nothing turns, and the scaled time."""
    largest: double = largest_of(omega[0], omega[1], omega[2])
    power: int = scale(largest)
    is_still: bool = not (largest > 0.0 and abs(dt) > 0.0)
    t: double = 0.0 if is_still else times_power(dt, power)
    return power, is_still, t


def scaled_rates(axis: int[3], omega: double[3], power: int) -> tuple[double, double, double]:
    """Return the scaled rates in the order of axes, for a body at rest those of a spin.

    At rest the momentum has no direction to divide by.
    """
    is_turning: bool = largest_of(omega[0], omega[1], omega[2]) > 0.0
    a: double = times_power(omega[axis[0]], -power) if is_turning else 1.0
    b: double = times_power(omega[axis[1]], -power)
    d: double = times_power(omega[axis[2]], -power)
    return a, b, d


def scaled_attitude(q: double[4]) -> tuple[double, double, double, double]:
    """Return a quaternion times a power of two, so that squares neither overflow nor vanish."""
    power: int = -scale(size_of(q))
    return (
        times_power(q[0], power),
        times_power(q[1], power),
        times_power(q[2], power),
        times_power(q[3], power),
    )


def is_short(a: double, b: double, d: double, t: double) -> bool:
    """Return True where a step turns by no more than the largest angle."""
    return sqrt(a * a + b * b + d * d) * abs(t) <= max_step


@inline
def is_under(l_a: double, l_d: double, a: double, d: double) -> bool:
    """Return True where the momentum circulates about the axis of smallest moment.

    That is where K^2 < 2 H c_b.
    """
    return l_a * a * a < l_d * d * d


@inline
def swapped(is_turned: bool, one: double, other: double) -> tuple[double, double]:
    """Return two numbers, in the other order where `is_turned`."""
    return other if is_turned else one, one if is_turned else other


@inline
def divided(x: double, over: double, more: double) -> double:
    """Return x over the root of a square, with little more error than one rounding."""
    y: double = x * over
    return y + (product_error(x, over, y) + x * more)


@inline
def unit(
    q_0: double, q_a: double, q_b: double, q_d: double
) -> tuple[double, double, double, double]:
    """Normalise a quaternion."""
    first: pair = two_product(q_0, q_0) + two_product(q_a, q_a)
    square: pair = first + (two_product(q_b, q_b) + two_product(q_d, q_d))
    over: double = 1.0 / sqrt(square.hi)
    rest: pair = 1.0 - square * two_product(over, over)
    more: double = over * (rest.hi + rest.lo) / 2.0
    return (
        divided(q_0, over, more),
        divided(q_a, over, more),
        divided(q_b, over, more),
        divided(q_d, over, more),
    )


@inline
def dithered(x: pair, chance: double) -> double:
    """Round a pair up or down, to the nearer double more often; chance is between -1/2 and 1/2."""
    size: double = abs(x.hi)
    next: double = size + size * HALF_ULP
    return x.hi + (x.lo + chance * (next - size))


@inline
def stochastic(
    q_0: double, q_a: double, q_b: double, a: pair, b: pair, d: pair
) -> tuple[double, double, double]:
    """Round rates up or down at random, by the attitude's last digits.

    Rounded to nearest, a slow motion's rates would err one way for long.
    """
    one: bits = bits_of(q_0)
    two: bits = bits_of(q_a)
    three: bits = bits_of(q_b)
    turned: bits = (two << TURN | two >> TURN_BACK) ^ (three << SECOND_TURN | three >> SECOND_BACK)
    mixed: bits = (one ^ turned) * FACTOR
    mixed = (mixed ^ mixed >> HALF_WORD) * SECOND_FACTOR
    mixed ^= mixed >> HALF_WORD
    for_a: double = from_bits(ONE_BITS | mixed >> TOP << PLACE) - 1.5
    for_b: double = from_bits(ONE_BITS | mixed << CHANCE >> TOP << PLACE) - 1.5
    for_d: double = from_bits(ONE_BITS | mixed << SECOND_CHANCE >> TOP << PLACE) - 1.5
    return dithered(a, for_a), dithered(b, for_b), dithered(d, for_d)


@inline
def is_finite_state(
    q_0: double, q_a: double, q_b: double, q_d: double, a: double, b: double, d: double
) -> bool:
    """Return True where a state is finite.

    Nonphysical bodies can turn much faster than at the start.
    """
    return isfinite(q_0 + q_a + q_b + q_d + a + b + d)


@inline
def places(axis: int[3], is_turned: bool) -> tuple[int, int, int]:
    """Return the place of each axis in the order of axes, whose ends are swapped if `is_turned`."""
    first: int = axis[2] if is_turned else axis[0]
    return (
        0 if first == 0 else 1 if axis[1] == 0 else 2,
        0 if first == 1 else 1 if axis[1] == 1 else 2,
        0 if first == 2 else 1 if axis[1] == 2 else 2,
    )
