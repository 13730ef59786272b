"""Sensitivities of states: their changes with attitude, rates, moments and time."""

SENSITIVE: size = BLOCK if BLOCK < 32 else 32
"The number of sensitivities computed side by side: each needs about ninety doubles of stack."
unit_rows: double[9] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
no_row: double[3] = [0.0, 0.0, 0.0]


# Inputs that states change with, to be added up; columns are in this order.


@public
class inputs:
    """Inputs that states change with, to be added up; columns are in this order."""

    BY_ATTITUDE0: int = 1
    "three: a small turn at t = 0, in space"
    BY_OMEGA0: int = 2
    "three: the rates at t = 0"
    BY_INERTIA: int = 4
    "three: the principal moments"
    BY_T: int = 8
    "the time, which has arrays of its own"
    BY_ALL: int = 15
    "all of these"


class sensitive:
    """The constants of sensitivities; axes are those with p >= r, where rates are constant, too."""

    along: along
    columns: columns
    turn: turn
    real: real
    imaginary: imaginary
    axis: int[3]
    is_real: bool
    at_rest: bool


def given_pair(motion: motion, k: size) -> pair:
    """Return one of the numbers that a motion was made from."""
    return pair(motion.given[2 * k], motion.given[2 * k + 1])


def sensitive_init(motion: motion, made: out[sensitive]):
    """Write the constants of sensitivities."""
    c: pair[3]
    apart_from_next: pair[3]
    omega: pair[3]
    axis: int[3]
    E_b: pair = given_pair(motion, 9)
    at_rest: bool = True
    for k in range(3):
        c[k] = given_pair(motion, k)
        apart_from_next[k] = given_pair(motion, 3 + k)
        omega[k] = given_pair(motion, 6 + k)
        axis[k] = motion.axis[k]
        at_rest = at_rest and is_zero(omega[k].hi)
    if difference(apart_from_next, axis[0], axis[2]).hi * E_b.hi < 0.0:
        axis[0] = motion.axis[2]
        axis[2] = motion.axis[0]
    for k in range(3):
        made.axis[k] = axis[k]
    made.at_rest = at_rest
    c_a: pair = c[axis[0]]
    c_b: pair = c[axis[1]]
    c_d: pair = c[axis[2]]
    c_ab: pair = difference(apart_from_next, axis[0], axis[1])
    c_ad: pair = difference(apart_from_next, axis[0], axis[2])
    c_bd: pair = difference(apart_from_next, axis[1], axis[2])
    Omega_a0: pair = omega[axis[0]]
    Omega_b0: pair = omega[axis[1]]
    Omega_d0: pair = omega[axis[2]]
    axis_a: double = double(axis[0])
    axis_b: double = double(axis[1])
    axis_d: double = double(axis[2])
    # The time at which a motion turns over is known on the hyperbolic branch alone; others hardly
    # do.
    turns_over: bool = motion.branch == 2
    reach: double = 1.0 if turns_over else never
    y0: pair = pair(0.0, 0.0)
    if turns_over:
        y0 = pair(motion.of.hyperbolic.y0_hi, motion.of.hyperbolic.y0_lo)
    p, r, apart, lambda_, divisor, modulus, complement = moduli(*named())
    along_constants(*named(), made.along)
    columns_constants(*named(), made.columns)
    made.is_real = modulus.hi * modulus.hi <= max_real
    if made.is_real:
        real_constants(*named(), made.real)
    else:
        imaginary_constants(*named(), made.imaginary)
    if not at_rest:
        turn_constants(
            c[0].hi,
            c[1].hi,
            c[2].hi,
            difference(apart_from_next, 0, 1).hi,
            difference(apart_from_next, 0, 2).hi,
            difference(apart_from_next, 1, 2).hi,
            omega[0].hi,
            omega[1].hi,
            omega[2].hi,
            motion.q0[0],
            motion.q0[1],
            motion.q0[2],
            motion.q0[3],
            made.turn,
        )


def elapsed(made: sensitive, n: size, t: double[...], to: out[double[...]]):
    """Write S_t, C_t, D_t, E_t, D_t F_t, the integral over the phase and its turns, in rows."""
    angles: double[11 * SENSITIVE]
    rest: double[SENSITIVE]
    for i in range(n):
        rest[i] = 0.0
    if made.is_real:
        real_angles(made.real, n, t, rest, *rows(angles, SENSITIVE))
        real_state(made.real, n, *rows(angles, SENSITIVE, 2), t, *rows(to, SENSITIVE, 7))
    else:
        imaginary_angles(made.imaginary, n, t, rest, *rows(angles, SENSITIVE))
        imaginary_state(made.imaginary, n, *rows(angles, SENSITIVE, 11), t, *rows(to, SENSITIVE, 7))


@inline
def asks(asked: bits, input: int) -> bool:
    """Return True where the changes with an input are asked for."""
    return (asked & bits(input)) != 0


@inline
def width_of(asked: bits) -> size:
    """Return the number of doubles of one state in `attitude` and in `rates`."""
    first: size = 9 if asks(asked, BY_ATTITUDE0) else 0
    second: size = 9 if asks(asked, BY_OMEGA0) else 0
    third: size = 9 if asks(asked, BY_INERTIA) else 0
    return first + second + third


@inline
def width_t(asked: bits) -> size:
    """Return the number of doubles of one state in `attitude_t` and in `rates_t`."""
    return 3 if asks(asked, BY_T) else 0


@inline
def put_row(
    asked: bits,
    row: out[double[...]],
    turn: double[3],
    column: double[...],
    by_rate: double,
    by_moment: double,
    again: double,
):
    """Write three columns of each chosen group of a row.

    The groups are by the turn at t = 0, omega0 and the moments.  column: the six of the last two,
    SENSITIVE apart.
    """
    after: size = 3 if asks(asked, BY_ATTITUDE0) else 0
    last: size = after + (3 if asks(asked, BY_OMEGA0) else 0)
    for k in range(3):
        if asks(asked, BY_ATTITUDE0):
            row[k] = turn[k]
        if asks(asked, BY_OMEGA0):
            row[after + k] = by_rate * column[k * SENSITIVE]
        if asks(asked, BY_INERTIA):
            row[last + k] = again * (by_moment * column[(3 + k) * SENSITIVE])


@inline
def put_rows(
    asked: bits,
    motion: motion,
    n: size,
    turned_by: double[...],
    by: double[...],
    attitude: out[double[...]],
    rates: out[double[...]],
    attitude_t: out[double[...]],
    rates_t: out[double[...]],
):
    """Write the rows of n states.

    turned_by: 18 derivatives of the turn by omega0 and the moments, then six of turn and rates by
    the time; by: 18 derivatives of the rates.  Rows of both are SENSITIVE apart.
    """
    unit: double = motion.unit
    over: double = 1.0 / unit
    over_moment: double = 1.0 / motion.moment_unit
    # A unit of rates over one of moments may leave binary64 where no rate by a moment does.
    apart: double = double(exponent(unit) - exponent(motion.moment_unit))
    part: double = ldexp(1.0, int(0.5 * apart))
    rest: double = unit / part * over_moment
    width: size = width_of(asked) // 3
    for i in range(n):
        for k in range(3):
            to: size = 3 * width * i + width * k
            own: size = 6 * k * SENSITIVE + i
            put_row(
                asked, attitude[to:], unit_rows[3 * k :], turned_by[own:], over, over_moment, 1.0
            )
            put_row(asked, rates[to:], no_row, by[own:], 1.0, part, rest)
        if asks(asked, BY_T):
            for k in range(3):
                attitude_t[3 * i + k] = unit * turned_by[(18 + k) * SENSITIVE + i]
                rates_t[3 * i + k] = unit * (unit * turned_by[(21 + k) * SENSITIVE + i])


def block_sensitivities(
    motion: motion,
    made: sensitive,
    asked: bits,
    n: size,
    t: double[...],
    q: double[...],
    omega: double[...],
    attitude: out[double[...]],
    rates: out[double[...]],
    attitude_t: out[double[...]],
    rates_t: out[double[...]],
):
    """Write the derivatives of n <= SENSITIVE states at inner times t."""
    functions: double[7 * SENSITIVE]
    state: double[7 * SENSITIVE]
    along: double[7 * SENSITIVE]
    by: double[21 * SENSITIVE]
    turned_by: double[24 * SENSITIVE]
    place: size[21]
    over: double = 1.0 / motion.unit
    for i in range(n):
        for k in range(4):
            state[k * SENSITIVE + i] = q[4 * i + k]
        for k in range(3):
            state[(4 + k) * SENSITIVE + i] = omega[3 * i + k] * over
    # Rows of derivatives by columns of axes a, b, d go where those of axes 1, 2, 3 are.
    for x in range(3):
        rate: size = size(made.axis[x])
        place[18 + x] = (18 + rate) * SENSITIVE
        for y in range(3):
            column: size = 6 * rate + size(made.axis[y])
            place[6 * x + y] = column * SENSITIVE
            place[6 * x + 3 + y] = (column + 3) * SENSITIVE
    Omega_a: size = (4 + size(made.axis[0])) * SENSITIVE
    Omega_b: size = (4 + size(made.axis[1])) * SENSITIVE
    Omega_d: size = (4 + size(made.axis[2])) * SENSITIVE
    elapsed(made, n, t, functions)
    along_state(
        made.along,
        n,
        *rows(functions, SENSITIVE, 7),
        t,
        state[Omega_a:],
        state[Omega_b:],
        state[Omega_d:],
        *rows(along, SENSITIVE),
    )
    columns_state(
        made.columns,
        n,
        *rows(functions, SENSITIVE, 5),
        *rows(along, SENSITIVE, 7),
        t,
        state[Omega_a:],
        state[Omega_b:],
        state[Omega_d:],
        *rows(by, place[...]),
    )
    turn_state(
        made.turn,
        n,
        *rows(state, SENSITIVE, 7),
        *rows(by, SENSITIVE, 21),
        t,
        *rows(turned_by, SENSITIVE),
    )
    # All columns, the most frequent choice, without a test for each number.
    if asked == bits(BY_ALL):
        put_rows(bits(BY_ALL), motion, n, turned_by, by, attitude, rates, attitude_t, rates_t)
    else:
        put_rows(asked, motion, n, turned_by, by, attitude, rates, attitude_t, rates_t)


def plain_sensitivity(
    motion: motion, t: double, asked: bits, attitude: out[double[...]], rates: out[double[...]]
):
    """Write the derivatives of a body at rest, or of any body at t = 0.

    A body at rest begins to turn when given rates.
    """
    q_0: double = motion.q0[0]
    # gcc fuses the products of sums and differences in turn, whatever options say.
    less_0: double = hidden(-q_0)
    q_1: double = motion.q0[1]
    q_2: double = motion.q0[2]
    q_3: double = motion.q0[3]
    start: double[3, 3]
    start[0, 0] = 1.0 - 2.0 * (q_2 * q_2 + q_3 * q_3)
    start[0, 1] = 2.0 * (q_1 * q_2 + less_0 * q_3)
    start[0, 2] = 2.0 * (q_1 * q_3 + q_0 * q_2)
    start[1, 0] = 2.0 * (q_1 * q_2 + q_0 * q_3)
    start[1, 1] = 1.0 - 2.0 * (q_1 * q_1 + q_3 * q_3)
    start[1, 2] = 2.0 * (q_2 * q_3 + less_0 * q_1)
    start[2, 0] = 2.0 * (q_1 * q_3 + less_0 * q_2)
    start[2, 1] = 2.0 * (q_2 * q_3 + q_0 * q_1)
    start[2, 2] = 1.0 - 2.0 * (q_1 * q_1 + q_2 * q_2)
    place: size = 0
    for k in range(3):
        if asks(asked, BY_ATTITUDE0):
            for j in range(3):
                attitude[place + j] = 1.0 if j == k else 0.0
                rates[place + j] = 0.0
            place += 3
        if asks(asked, BY_OMEGA0):
            for j in range(3):
                attitude[place + j] = t * start[k, j]
                rates[place + j] = 1.0 if j == k else 0.0
            place += 3
        if asks(asked, BY_INERTIA):
            for j in range(3):
                attitude[place + j] = 0.0
                rates[place + j] = 0.0
            place += 3


def any_lost(n: size, x: double[...]) -> bool:
    """Return True where one of n numbers is NaN."""
    lost: size = 0
    for k in range(n):
        lost += 1 if isnan(x[k]) else 0
    return lost > 0


def no_numbers(n: size, x: out[double[...]]):
    """Write n NaN."""
    for k in range(n):
        x[k] = nan


def no_changes(
    n: size,
    asked: bits,
    attitude: out[double[...]],
    rates: out[double[...]],
    attitude_t: out[double[...]],
    rates_t: out[double[...]],
):
    """Write NaN for all changes of n states."""
    no_numbers(width_of(asked) * n, attitude)
    no_numbers(width_of(asked) * n, rates)
    no_numbers(width_t(asked) * n, attitude_t)
    no_numbers(width_t(asked) * n, rates_t)


def sensitivities_at(
    motion: motion,
    n: size,
    t: double[...],
    asked: bits,
    q: out[double[...]],
    omega: out[double[...]],
    attitude: out[double[...]],
    rates: out[double[...]],
    attitude_t: out[double[...]],
    rates_t: out[double[...]],
    lenient: bool,
) -> int:
    """Write n states and their sensitivities; late times have NaN where `lenient`."""
    width: size = width_of(asked)
    by_t: size = width_t(asked)
    made: sensitive
    inner: double[SENSITIVE]
    if motion.prepared != PREPARED:
        return UNPREPARED
    code: int = unrefused_states(motion, n, t, q, omega, lenient)
    if code != OK and not lenient:
        return code
    sensitive_init(motion, made)
    for i in range(0, n, SENSITIVE):
        count: size = min(n - i, size(SENSITIVE))
        near, has_zero = scaled_times(motion, count, t[i:], inner)
        if not near:
            for k in range(count):
                inner[k] = inner[k] if abs(inner[k]) <= motion.max_angle else 0.0
        if not made.at_rest:
            block_sensitivities(
                motion,
                made,
                asked,
                count,
                inner,
                q[4 * i :],
                omega[3 * i :],
                attitude[width * i :],
                rates[width * i :],
                attitude_t[by_t * i :],
                rates_t[by_t * i :],
            )
        else:
            for k in range(by_t * count):
                attitude_t[by_t * i + k] = 0.0
                rates_t[by_t * i + k] = 0.0
        if made.at_rest or has_zero:
            for k in range(i, i + count):
                if made.at_rest or is_zero(t[k]):
                    plain_sensitivity(
                        motion, t[k], asked, attitude[width * k :], rates[width * k :]
                    )
        # Look for lost numbers while the block is in the cache.
        if (
            near
            and not any_lost(width * count, attitude[width * i :])
            and not any_lost(width * count, rates[width * i :])
        ):
            continue
        for k in range(i, i + count):
            late: bool = not (abs(motion.unit * t[k]) <= motion.max_angle)
            if (
                late
                or any_lost(width, attitude[width * k :])
                or any_lost(width, rates[width * k :])
            ):
                no_changes(
                    1,
                    asked,
                    attitude[width * k :],
                    rates[width * k :],
                    attitude_t[by_t * k :],
                    rates_t[by_t * k :],
                )
                code = code if late else GROWTH
    return code


@public
def states_with_sensitivity(
    motion: motion,
    n: size,
    t: double[...],
    q: out[double[...]],
    omega: out[double[...]],
    attitude: out[double[...]],
    rates: out[double[...]],
    attitude_t: out[double[...]],
    rates_t: out[double[...]],
) -> int:
    """The states at n times t[n] (s), as torque_free_states_at has them, and their changes with the
    inputs.  attitude[n][3][9]: a small turn eta in space, rad: the matrix from body to space
    changes by [eta] times itself.  rates[n][3][9]: the body rates.  Their columns: the small turn
    at t = 0, omega0 and the principal moments.  attitude_t[n][3], rates_t[n][3]: both by the time.
    No arrays overlap; numbers beyond binary64 are infinite.  Returns a code as
    torque_free_states_at does, or TORQUE_FREE_GROWTH with states at all times and changes that are
    NaN at some.
    """
    return sensitivities_at(
        motion, n, t, bits(BY_ALL), q, omega, attitude, rates, attitude_t, rates_t, False
    )


@public
def states_with_columns(
    motion: motion,
    n: size,
    t: double[...],
    columns: int,
    q: out[double[...]],
    omega: out[double[...]],
    attitude: maybe[out[double[...]]],
    rates: maybe[out[double[...]]],
    attitude_t: maybe[out[double[...]]],
    rates_t: maybe[out[double[...]]],
) -> int:
    """As torque_free_states_with_sensitivity, with the changes in `columns` alone, a sum of the
    inputs above: attitude[n][3][m] and rates[n][3][m] have three columns for each of the first
    three that is in it, attitude_t and rates_t are written where TORQUE_FREE_BY_T is.
    TORQUE_FREE_GROWTH is about these columns alone.
    """
    return sensitivities_at(
        motion, n, t, bits(columns), q, omega, attitude, rates, attitude_t, rates_t, False
    )


@public
def propagate_with_columns(
    bodies: size,
    inertia: double[...],
    omega0: double[...],
    attitude0: double[...],
    n: size,
    t: double[...],
    stride: size,
    columns: int,
    q: out[double[...]],
    omega: out[double[...]],
    attitude: maybe[out[double[...]]],
    rates: maybe[out[double[...]]],
    attitude_t: maybe[out[double[...]]],
    rates_t: maybe[out[double[...]]],
    codes: maybe[out[int[...]]],
    failed: out[size[...]],
) -> int:
    """As torque_free_propagate_with_sensitivity, with the changes in `columns` alone and the arrays
    of torque_free_states_with_columns.
    """
    asked: bits = bits(columns)
    width: size = width_of(asked)
    by_t: size = width_t(asked)
    made: motion[LANES]
    code: int[LANES]
    lane: lanes
    cleared(lane)
    rounded: bool = is_rounded_once()
    for first in range(0, bodies, LANES):
        count: size = several_init(
            made,
            code,
            lane,
            rounded,
            bodies - first,
            inertia[3 * first :],
            omega0[3 * first :],
            attitude0[4 * first :],
        )
        for i in range(count):
            k: size = first + i
            from_: size = n * k
            if code[i] == OK:
                code[i] = sensitivities_at(
                    made[i],
                    n,
                    t[stride * k :],
                    asked,
                    q[4 * from_ :],
                    omega[3 * from_ :],
                    attitude[width * from_ :],
                    rates[width * from_ :],
                    attitude_t[by_t * from_ :],
                    rates_t[by_t * from_ :],
                    codes is not None,
                )
            elif codes is not None:
                no_states(n, q[4 * from_ :], omega[3 * from_ :])
                no_changes(
                    n,
                    asked,
                    attitude[width * from_ :],
                    rates[width * from_ :],
                    attitude_t[by_t * from_ :],
                    rates_t[by_t * from_ :],
                )
            if codes is not None:
                codes[k] = code[i]
            elif code[i] != OK:
                failed[0] = k
                return code[i]
    return OK


@public
def propagate_with_sensitivity(
    bodies: size,
    inertia: double[...],
    omega0: double[...],
    attitude0: double[...],
    n: size,
    t: double[...],
    stride: size,
    q: out[double[...]],
    omega: out[double[...]],
    attitude: out[double[...]],
    rates: out[double[...]],
    attitude_t: out[double[...]],
    rates_t: out[double[...]],
    codes: maybe[out[int[...]]],
    failed: out[size[...]],
) -> int:
    """States and changes at n times of each of many bodies, as torque_free_propagate has them:
    q[bodies][n][4] to rates_t[bodies][n][3], none of which overlap.  Where codes is not NULL,
    refused times have states of NaN, and changes are NaN at these times and at those where they
    leave binary64; a body with such a time has code TORQUE_FREE_GROWTH, whatever else it has.
    """
    return propagate_with_columns(
        bodies,
        inertia,
        omega0,
        attitude0,
        n,
        t,
        stride,
        BY_ALL,
        q,
        omega,
        attitude,
        rates,
        attitude_t,
        rates_t,
        codes,
        failed,
    )
