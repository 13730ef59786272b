"""Motions in C: constants of several motions side by side, and states in blocks of times."""

# The mark of a prepared motion: a number that memory hardly has by chance.
PREPARED: int = 0x7F4A7C15


@public
class motion:
    """The constants of one motion; written by torque_free_motion_init, read by all others."""

    branch: int
    "0 steady, 1 circular, 2 hyperbolic"
    axis: int[3]
    "the body axes a, b, d"
    blurred: int
    "1 where later times are refused as TORQUE_FREE_SEPARATRIX"
    prepared: int
    "a mark that torque_free_motion_init has written the struct"
    unit: double
    "a power of two, 1/s: inner times are unit t; 0 at rest"
    max_angle: double
    "the largest inner time"
    q0: double[4]
    "attitude at t = 0"
    omega0: double[3]
    "body rates at t = 0, rad/s"
    of: union[circular, hyperbolic, steady]
    moment_unit: double
    "a power of two, kg m^2: inner moments are times this"
    given: double[20]
    "moments, their differences, rates and E_b, all inner, in pairs"


def steady_init(motion: out[motion], omega: pair[3], q: pair[4]):
    """Compute the constants of a motion with constant rates."""
    at_rest: bool = is_at_rest(omega)
    one: pair = pair(1.0, 0.0)
    first: pair = one if at_rest else omega[0]
    motion.branch = 0
    steady_constants(first, omega[1], omega[2], q[0], q[1], q[2], q[3], motion.of.steady)
    if at_rest:
        motion.unit = 0.0
        motion.of.steady.Lambda_rate_hi = 0.0
        motion.of.steady.Lambda_rate_lo = 0.0


def put_pair(high: out[double[...]], low: out[double[...]], i: size, x: pair):
    """Write a pair to lane i."""
    high[i] = x.hi
    low[i] = x.lo


def put(
    lane: out[lanes],
    i: size,
    motion: motion,
    c: pair[3],
    apart: pair[3],
    omega: pair[3],
    q: pair[4],
    E_b: pair,
):
    """Write the numbers that the constants of a motion are computed from to lane i."""
    a: int = motion.axis[0]
    b: int = motion.axis[1]
    d: int = motion.axis[2]
    put_pair(lane.c_a_hi, lane.c_a_lo, i, c[a])
    put_pair(lane.c_b_hi, lane.c_b_lo, i, c[b])
    put_pair(lane.c_d_hi, lane.c_d_lo, i, c[d])
    put_pair(lane.c_ab_hi, lane.c_ab_lo, i, difference(apart, a, b))
    put_pair(lane.c_ad_hi, lane.c_ad_lo, i, difference(apart, a, d))
    put_pair(lane.c_bd_hi, lane.c_bd_lo, i, difference(apart, b, d))
    put_pair(lane.Omega_a_hi, lane.Omega_a_lo, i, omega[a])
    put_pair(lane.Omega_b_hi, lane.Omega_b_lo, i, omega[b])
    put_pair(lane.Omega_d_hi, lane.Omega_d_lo, i, omega[d])
    put_pair(lane.E_b_hi, lane.E_b_lo, i, E_b)
    put_pair(lane.q_0_hi, lane.q_0_lo, i, q[0])
    put_pair(lane.q_a_hi, lane.q_a_lo, i, q[1 + a])
    put_pair(lane.q_b_hi, lane.q_b_lo, i, q[1 + b])
    put_pair(lane.q_d_hi, lane.q_d_lo, i, q[1 + d])
    lane.axis_a[i] = double(a)
    lane.axis_b[i] = double(b)
    lane.axis_d[i] = double(d)
    lane.unit[i] = motion.unit


def spread(row: out[double[...]], own: double[LANES], used: size):
    """Copy a used lane of a row to all that are not used."""
    other: double = row[used]
    for i in range(LANES):
        row[i] = row[i] if own[i] > 0.0 else other


def repeat(lane: out[lanes], own: bool[LANES]):
    """Copy a used lane to all that are not used, so that unused lanes raise no exceptions."""
    used: size = 0
    mask: double[LANES]
    for i in range(LANES):
        used = LANES - 1 - i if own[LANES - 1 - i] else used
        mask[i] = 1.0 if own[i] else 0.0
    for x in members(lanes):
        spread(lane.x, mask, used)


def branch_init(lane: lanes, branch: int, n: size, motion: out[motion[...]], code: out[int[...]]):
    """Compute the constants of those of n motions that are on one branch.

    lane: what `initial_state` has written.
    """
    alike: lanes
    alike = lane
    own: bool[LANES]
    is_any: bool = False
    are_others: bool = False
    for i in range(LANES):
        own[i] = i < n and motion[i].branch == branch
        is_any = is_any or own[i]
        are_others = are_others or (i < n and motion[i].branch != 0 and not own[i])
    if not is_any:
        return
    if are_others:
        repeat(alike, own)
    if branch == 1:
        circular: circular_lanes
        circular_constants(alike, circular)
        for i in range(n):
            if own[i]:
                holds: bool = True
                for x in members(circular):
                    motion[i].of.circular.x = circular.x[i]
                    holds = holds and isfinite(circular.x[i])
                motion[i].max_angle = limit(
                    motion[i].max_angle, circular.v_rate_hi[i], circular.Lambda_rate_hi[i]
                )
                code[i] = OK if holds else RATES
    else:
        hyperbolic: hyperbolic_lanes
        hyperbolic_constants(alike, hyperbolic)
        for i in range(n):
            if own[i]:
                holds: bool = True
                for x in members(hyperbolic):
                    motion[i].of.hyperbolic.x = hyperbolic.x[i]
                    holds = holds and isfinite(hyperbolic.x[i])
                motion[i].max_angle = limit(
                    motion[i].max_angle, hyperbolic.y_rate_hi[i], hyperbolic.Lambda_rate_hi[i]
                )
                code[i] = OK if holds else RATES
    for i in range(n):
        if own[i] and not is_held(motion[i].unit, lane.A_a_hi[i], lane.A_b_hi[i], lane.A_d_hi[i]):
            code[i] = RATES


def moving_init(lane: out[lanes], n: size, motion: out[motion[...]], code: out[int[...]]):
    """Compute the constants of n motions that `begin` wrote to lanes, and their codes.

    Steady motions have their constants.
    """
    own: bool[LANES]
    count: size = 0
    for i in range(LANES):
        own[i] = i < n and motion[i].branch != 0
        count += 1 if own[i] else 0
    if count == 0:
        return
    if count < LANES:
        repeat(lane, own)
    initial_state(lane)
    for i in range(n):
        if own[i]:
            motion[i].branch = 1 if lane.k_1_hi[i] * lane.k_1_hi[i] <= max_circular else 2
    branch_init(lane, 1, n, motion, code)
    branch_init(lane, 2, n, motion, code)


def keep(motion: out[motion], c: pair[3], apart: pair[3], omega: pair[3], E_b: pair):
    """Copy the numbers that sensitivities are computed from to the motion."""
    for k in range(3):
        motion.given[2 * k] = c[k].hi
        motion.given[2 * k + 1] = c[k].lo
        motion.given[6 + 2 * k] = apart[k].hi
        motion.given[7 + 2 * k] = apart[k].lo
        motion.given[12 + 2 * k] = omega[k].hi
        motion.given[13 + 2 * k] = omega[k].lo
    motion.given[18] = E_b.hi
    motion.given[19] = E_b.lo


def begin(
    motion: out[motion],
    lane: out[lanes],
    i: size,
    c: pair[3],
    apart: pair[3],
    given: pair[3],
    q: pair[4],
    is_known: bool,
    known: pair,
    unit: double,
):
    """Set all of a motion but the constants of its branch, which are computed from lane i.

    c, apart (differences of each moment and the next in turn), the rates `given` and q are in inner
    units; known: E_b, where `is_known`.
    """
    cleared(motion)
    motion.prepared = PREPARED
    motion.unit = unit
    motion.moment_unit = 1.0
    omega: pair[3]
    for k in range(3):
        omega[k] = not_negligible(given[k])
        motion.omega0[k] = given[k].hi * unit
    turn: pair[4]
    turn[0], turn[1], turn[2], turn[3] = normalised(q)
    for k in range(4):
        motion.q0[k] = rounded(turn[k])
    a, b, d = sorted_axes(apart)
    found: pair = known
    if not is_known:
        found = discriminant_of(c, apart, omega, a, b, d)
    last, omega_0, omega_1, omega_2, E_b = course(c, apart, given, omega, a, b, d, found)
    omega[0] = omega_0
    omega[1] = omega_1
    omega[2] = omega_2
    motion.max_angle = last
    motion.blurred = 1 if last < max_angle else 0
    keep(motion, c, apart, omega, E_b)
    side: double = side_of(apart, omega, a, b, d, E_b.hi)
    motion.axis[0] = d if side < 0.0 else a
    motion.axis[1] = b
    motion.axis[2] = a if side < 0.0 else d
    motion.branch = 1 if side < 0.0 or side > 0.0 else 0
    if motion.branch == 0:
        steady_init(motion, omega, turn)
    else:
        put(lane, i, motion, c, apart, omega, turn, E_b)


def begin_doubles(
    motion: out[motion],
    lane: out[lanes],
    i: size,
    inertia: double[3],
    omega0: double[3],
    attitude0: double[4],
) -> int:
    """Check doubles and begin a motion with them; return a code."""
    motion.branch = 0
    if not (all_finite(3, inertia) and all_finite(3, omega0) and all_finite(4, attitude0)):
        return NOT_FINITE
    c_scale: int = scale_of(inertia[0], inertia[1], inertia[2])
    scale: int = scale_of(omega0[0], omega0[1], omega0[2])
    q_scale: int = scale_of_attitude(attitude0)
    c: pair[3]
    apart: pair[3]
    omega: pair[3]
    q: pair[4]
    for k in range(3):
        c[k] = pair(scaled_by(inertia[k], -c_scale), 0.0)
        omega[k] = pair(scaled_rate(omega0[k], -scale), 0.0)
    code: int = broken_rule(inertia, c, attitude0)
    if code != OK:
        return code
    for k in range(4):
        q[k] = pair(scaled_by(attitude0[k], -q_scale), 0.0)
    # Differences of doubles are pairs exactly.
    for k in range(3):
        apart[k] = two_sum(c[k].hi, -c[(k + 1) % 3].hi)
    begin(motion, lane, i, c, apart, omega, q, False, q[0], scaled_by(1.0, scale))
    for k in range(3):
        motion.omega0[k] = omega0[k]
    motion.moment_unit = scaled_by(1.0, c_scale)
    return OK


def end(motion: out[motion], made: out[motion[...]], lane: out[lanes]) -> int:
    """Finish one motion that was begun, and return its code."""
    code: int[1]
    code[0] = OK
    if not is_rounded_once():
        return ARITHMETIC
    moving_init(lane, 1, made, code)
    if code[0] == OK:
        motion = made[0]
    return code[0]


@public
def motion_init(
    motion: out[motion], inertia: double[3], omega0: double[3], attitude0: double[4]
) -> int:
    """The constants of a motion.  inertia: principal moments about the body axes, kg m^2, positive;
    omega0: body rates at t = 0, rad/s; attitude0: quaternion at t = 0, scalar first, body to
    inertial, of any length but zero.  Functions that take moments refuse those that no body can
    have, beyond rounding, as TORQUE_FREE_NONPHYSICAL, unless the source is compiled with
    -DALLOW_NONPHYSICAL.  Returns a code above."""
    made: motion[1]
    lane: lanes
    cleared(lane)
    code: int = begin_doubles(made[0], lane, 0, inertia, omega0, attitude0)
    if code != OK:
        return code
    return end(motion, made, lane)


@public
def motion_init_double_doubles(
    motion: out[motion],
    inertia: double[3, 2],
    differences: double[3, 2],
    omega0: double[3, 2],
    attitude0: double[4, 2],
    discriminant: double[2],
    unit: double,
) -> int:
    """The constants of a motion from numbers known beyond binary64, each the sum of two doubles
    {hi, lo}.  The largest moment and the largest rate should be between 1/2 and 4.  Numbers that
    pairs would lose by subtraction are arguments, right to all digits of a double_double:
    differences, moments 0 less 1, 1 less 2 and 2 less 0, and discriminant, K^2 - 2 H c_b, b the
    middle axis, whose sign decides the regime.  Rates are times `unit` rad/s, a power of two."""
    c: pair[3]
    apart: pair[3]
    omega: pair[3]
    q: pair[4]
    are_finite: bool = isfinite(discriminant[0]) and isfinite(discriminant[1]) and isfinite(unit)
    for k in range(3):
        c[k] = pair(inertia[k, 0], inertia[k, 1])
        apart[k] = pair(differences[k, 0], differences[k, 1])
        omega[k] = pair(omega0[k, 0], omega0[k, 1])
        if not (isfinite(c[k].hi) and isfinite(c[k].lo)):
            return NOT_FINITE
        if not (isfinite(apart[k].hi) and isfinite(apart[k].lo)):
            return NOT_FINITE
        if not (isfinite(omega[k].hi) and isfinite(omega[k].lo)):
            return NOT_FINITE
        if not c[k].hi > 0.0:
            return INERTIA
        if c[k].hi < min_moment_ratio or c[k].hi > 4.0:
            return THIN
        if abs(omega[k].hi) > 4.0:
            return RATES
    if not can_exist(c):
        return NONPHYSICAL
    is_turned: bool = False
    for k in range(4):
        q[k] = pair(attitude0[k, 0], attitude0[k, 1])
        are_finite = are_finite and isfinite(q[k].hi) and isfinite(q[k].lo)
        is_turned = is_turned or not is_zero(q[k].hi)
    if not are_finite:
        return NOT_FINITE
    if not unit > 0.0:
        return RATES
    if not is_turned:
        return ATTITUDE
    made: motion[1]
    lane: lanes
    cleared(lane)
    known: pair = pair(discriminant[0], discriminant[1])
    begin(made[0], lane, 0, c, apart, omega, q, True, known, unit)
    return end(motion, made, lane)


def scaled_times(
    motion: motion, n: size, t: double[...], inner: out[double[...]]
) -> tuple[bool, bool]:
    """Scale times to inner units.

    Return whether all are within the domain, and whether one is zero.
    """
    unit: double = motion.unit
    last: double = motion.max_angle
    # Counts as wide as a double: vectors of comparisons need not be narrowed then.
    late: size = 0
    zeros: size = 0
    for i in range(n):
        inner[i] = unit * t[i]
        late += 0 if abs(inner[i]) <= last else 1
        zeros += 1 if is_zero(t[i]) else 0
    near: bool = late == 0
    has_zero: bool = zeros > 0
    return near, has_zero


def interleaved(n: size, a: double[...], b: double[...], c: double[...], rows: out[double[...]]):
    """Write three columns as n rows, the first ones by shuffles where a target has these."""
    done: size = shuffled(n, a, b, c, rows)
    for i in range(done, n):
        rows[3 * i] = a[i]
        rows[3 * i + 1] = b[i]
        rows[3 * i + 2] = c[i]


def interleaved4(
    n: size, a: double[...], b: double[...], c: double[...], d: double[...], rows: out[double[...]]
):
    """Write four columns as n rows, the first ones by shuffles where a target has these."""
    done: size = shuffled4(n, a, b, c, d, rows)
    for i in range(done, n):
        rows[4 * i] = a[i]
        rows[4 * i + 1] = b[i]
        rows[4 * i + 2] = c[i]
        rows[4 * i + 3] = d[i]


def block_states(
    motion: motion,
    n: size,
    s: size,
    angles: double[...],
    to: out[double[...]],
    q: out[double[...]],
    omega: out[double[...]],
):
    """Compute n states from the angles, in rows s apart.

    The steady branch has two rows of angles, the others have at most six; `to` has room for seven.
    """
    if motion.branch == 0:
        steady_state(motion.of.steady, n, *rows(angles, s), *rows(to, s))
        for i in range(n):
            for k in range(3):
                omega[3 * i + k] = motion.omega0[k]
        interleaved4(n, to, to[s:], to[2 * s :], to[3 * s :], q)
        return
    if motion.branch == 1:
        circular_state(motion.of.circular, n, *rows(angles, s), *rows(to, s))
    else:
        hyperbolic_state(motion.of.hyperbolic, n, *rows(angles, s), *rows(to, s))
    # Where the row of each body axis begins.
    at: size[3]
    for k in range(3):
        at[motion.axis[k]] = (1 + k) * s
    interleaved4(n, to, to[at[0] :], to[at[1] :], to[at[2] :], q)
    interleaved(n, to[3 * s + at[0] :], to[3 * s + at[1] :], to[3 * s + at[2] :], omega)


def block_angles(
    motion: motion, n: size, s: size, t: double[...], t_lo: double[...], to: out[double[...]]
):
    """Write the angles at the inner times t + t_lo, in rows s apart."""
    if motion.branch == 0:
        steady_angles(motion.of.steady, n, t, t_lo, *rows(to, s))
    elif motion.branch == 1:
        circular_angles(motion.of.circular, n, t, t_lo, *rows(to, s))
    else:
        hyperbolic_angles(motion.of.hyperbolic, n, t, t_lo, *rows(to, s))


def fetch(n: size, q: double[...], omega: double[...]):
    """Prefetch the cache lines that the next block will be written to, where n states are left."""
    if n >= 2 * BLOCK:
        prefetch(q[4 * BLOCK :], 4 * BLOCK)
        prefetch(omega[3 * BLOCK :], 3 * BLOCK)


def at_initial_state(motion: motion, q: out[double[...]], omega: out[double[...]]):
    """Write the exact initial state of a motion."""
    for k in range(4):
        q[k] = motion.q0[k]
    for k in range(3):
        omega[k] = motion.omega0[k]


def refusal(motion: motion, are_finite: bool) -> int:
    """Return the code for times at which a motion has no states."""
    if not are_finite:
        return NOT_FINITE
    return SEPARATRIX if motion.blurred != 0 else TIME


def no_states(n: size, q: out[double[...]], omega: out[double[...]]):
    """Write n states of NaN."""
    for i in range(4 * n):
        q[i] = nan
    for i in range(3 * n):
        omega[i] = nan


@public
def state_at(motion: motion, t: double, q: out[double[4]], omega: out[double[3]]) -> int:
    """The state at time t (s): q[4], unit, body to inertial, continuous in the double cover from
    attitude0 on, and omega[3], body rates in rad/s.  Returns 0,
    TORQUE_FREE_NOT_FINITE, TORQUE_FREE_TIME, TORQUE_FREE_SEPARATRIX or, as all functions below,
    TORQUE_FREE_UNPREPARED."""
    by_time: double[6]
    to: double[7]
    inner: double[1]
    rest: double[1]
    if motion.prepared != PREPARED:
        return UNPREPARED
    inner[0] = motion.unit * t
    rest[0] = 0.0
    if not abs(inner[0]) <= motion.max_angle:
        return refusal(motion, isfinite(t))
    if is_zero(t):
        at_initial_state(motion, q, omega)
        return OK
    block_angles(motion, 1, 1, inner, rest, by_time)
    block_states(motion, 1, 1, by_time, to, q, omega)
    return OK


def unrefused_states(
    motion: motion,
    n: size,
    t: double[...],
    q: out[double[...]],
    omega: out[double[...]],
    lenient: bool,
) -> int:
    """Write the states at n times.

    Late times are refused, or have states of NaN where `lenient`.
    """
    by_time: double[6 * BLOCK]
    to: double[7 * BLOCK]
    inner: double[BLOCK]
    rest: double[BLOCK]
    is_refused: bool = False
    if not lenient:
        for i in range(0, n, BLOCK):
            near, zero = scaled_times(motion, min(n - i, BLOCK), t[i:], inner)
            if not near:
                return refusal(motion, all_finite(n, t))
    for k in range(BLOCK):
        rest[k] = 0.0
    for i in range(0, n, BLOCK):
        count: size = min(n - i, BLOCK)
        near, zero = scaled_times(motion, count, t[i:], inner)
        if not near:
            is_refused = True
            for k in range(count):
                inner[k] = inner[k] if abs(inner[k]) <= motion.max_angle else 0.0
        fetch(n - i, q[4 * i :], omega[3 * i :])
        block_angles(motion, count, BLOCK, inner, rest, by_time)
        block_states(motion, count, BLOCK, by_time, to, q[4 * i :], omega[3 * i :])
        if zero:
            for k in range(count):
                if is_zero(t[i + k]):
                    at_initial_state(motion, q[4 * (i + k) :], omega[3 * (i + k) :])
        if not near:
            for k in range(count):
                if not abs(motion.unit * t[i + k]) <= motion.max_angle:
                    no_states(1, q[4 * (i + k) :], omega[3 * (i + k) :])
    if is_refused:
        return refusal(motion, all_finite(n, t))
    return OK


@public
def states_at(
    motion: motion, n: size, t: double[...], q: out[double[...]], omega: out[double[...]]
) -> int:
    """The states at n times t[n] (s), in any order: q[n][4] and omega[n][3], row by row, which must
    not overlap each other or t.  Returns a code as torque_free_state_at does."""
    if motion.prepared != PREPARED:
        return UNPREPARED
    return unrefused_states(motion, n, t, q, omega, False)


def turned(
    n: size,
    sin_a: double,
    cos_a: double,
    sin_b: double[...],
    cos_b: double[...],
    sine: out[double[...]],
    cosine: out[double[...]],
):
    """Write the sines and cosines of a + b."""
    for i in range(n):
        sine[i] = fused(sin_a, cos_b[i], cos_a * sin_b[i])
        cosine[i] = fused(cos_a, cos_b[i], -(sin_a * sin_b[i]))


def grid_table(motion: motion, step: double, table: out[double[...]]):
    """Write the sines and cosines of both angles in a block of a grid from t = 0, as from zero."""
    t: double[BLOCK]
    t_lo: double[BLOCK]
    from_zero: motion
    from_zero = motion
    if motion.branch == 1:
        from_zero.of.circular.v_hi = 0.0
        from_zero.of.circular.v_lo = 0.0
    for k in range(BLOCK):
        time: pair = two_product(double(k), step)
        t[k] = time.hi
        t_lo[k] = time.lo
    block_angles(from_zero, BLOCK, BLOCK, t, t_lo, table)


def grid_angles(
    motion: motion,
    start: double,
    step: double,
    first: size,
    every: size,
    n: size,
    by_time: out[double[...]],
):
    """Write the angles at n times, each `every`-th of the grid from number `first` on."""
    t: double[BLOCK]
    t_lo: double[BLOCK]
    for i in range(n):
        time: pair = two_product(double(first + i * every), step) + start
        t[i] = time.hi
        t_lo[i] = time.lo
    block_angles(motion, n, BLOCK, t, t_lo, by_time)


def grid_states(
    motion: motion,
    start: double,
    step: double,
    first: size,
    n: size,
    table: double[...],
    q: out[double[...]],
    omega: out[double[...]],
):
    """Write n <= BLOCK^2 states from number `first` on.

    Angles are evaluated once in a block, and turned.
    """
    base: double[6 * BLOCK]
    by_time: double[4 * BLOCK]
    to: double[7 * BLOCK]
    angles: size = 2 * BLOCK if motion.branch == 0 else 4 * BLOCK
    grid_angles(motion, start, step, first, BLOCK, (n + BLOCK - 1) // BLOCK, base)
    for i in range(0, n, BLOCK):
        count: size = min(n - i, BLOCK)
        k: size = i // BLOCK
        fetch(n - i, q[4 * i :], omega[3 * i :])
        for s in range(0, angles, 2 * BLOCK):
            turned(
                count,
                base[s + k],
                base[s + BLOCK + k],
                table[s:],
                table[s + BLOCK :],
                by_time[s:],
                by_time[s + BLOCK :],
            )
        block_states(motion, count, BLOCK, by_time, to, q[4 * i :], omega[3 * i :])


def grid_states_one_by_one(
    motion: motion,
    start: double,
    step: double,
    first: size,
    n: size,
    q: out[double[...]],
    omega: out[double[...]],
):
    """Write the states of a grid where angles are more than sines and cosines."""
    by_time: double[6 * BLOCK]
    to: double[7 * BLOCK]
    for i in range(0, n, BLOCK):
        count: size = min(n - i, BLOCK)
        fetch(n - i, q[4 * i :], omega[3 * i :])
        grid_angles(motion, start, step, first + i, 1, count, by_time)
        block_states(motion, count, BLOCK, by_time, to, q[4 * i :], omega[3 * i :])


def grid_zero(start: double, step: double, first: size, n: size) -> size:
    """Return the index of the first of n samples that is at t = 0, or n."""
    k: double = double(first) if is_zero(step) else nearest(-start / step)
    t: pair = two_product(k, step) + start
    place: double = k - double(first)
    if place >= 0.0 and place < double(n) and abs(t.hi) <= 0.0:
        return size(place)
    return n


@public
def states_on_grid(
    motion: motion,
    start: double,
    step: double,
    first: size,
    n: size,
    q: out[double[...]],
    omega: out[double[...]],
) -> int:
    """The n states at start + k step, k = first, first + 1, ..., exactly these times; first + n is
    at most 2^53.  Sines are evaluated once in 64 samples, but near the separatrix.  A grid in
    parts, each begun at a multiple of 64, has the same bits as the whole."""
    table: double[6 * BLOCK]
    if motion.prepared != PREPARED:
        return UNPREPARED
    # Sample number 0 does not depend on the step, however large.
    used: double = step if first + n > 1 else 0.0
    inner: double = motion.unit * start
    inner_step: double = motion.unit * used
    begin: double = inner + inner_step * double(first)
    end: double = inner + inner_step * double(first + n - 1 if n > 0 else first)
    last: double = motion.max_angle
    if not (abs(inner) <= last and abs(begin) <= last and abs(end) <= last):
        return refusal(motion, isfinite(start) and isfinite(used))
    if motion.branch >= ONE_BY_ONE:
        grid_states_one_by_one(motion, inner, inner_step, first, n, q, omega)
    else:
        grid_table(motion, inner_step, table)
        for i in range(0, n, BLOCK * BLOCK):
            count: size = min(n - i, BLOCK * BLOCK)
            grid_states(
                motion, inner, inner_step, first + i, count, table, q[4 * i :], omega[3 * i :]
            )
    every: size = 1 if is_zero(step) else n
    for i in range(grid_zero(start, step, first, n), n, every):
        at_initial_state(motion, q[4 * i :], omega[3 * i :])
    return OK


def several_init(
    motion: out[motion[...]],
    code: out[int[...]],
    lane: out[lanes],
    rounds_once: bool,
    bodies: size,
    inertia: double[...],
    omega0: double[...],
    attitude0: double[...],
) -> size:
    """Prepare the motions of as many bodies as there are lanes, with codes; return how many."""
    count: size = min(bodies, LANES)
    for i in range(count):
        code[i] = begin_doubles(
            motion[i], lane, i, inertia[3 * i :], omega0[3 * i :], attitude0[4 * i :]
        )
        if code[i] == OK and not rounds_once:
            code[i] = ARITHMETIC
    moving_init(lane, count, motion, code)
    return count


def states_of(
    motion: motion,
    n: size,
    t: double[...],
    q: out[double[...]],
    omega: out[double[...]],
    lenient: bool,
) -> int:
    """Write the states of one of many bodies; late times have states of NaN where `lenient`."""
    if n != 1:
        return unrefused_states(motion, n, t, q, omega, lenient)
    code: int = state_at(motion, t[0], q, omega)
    if code != OK and lenient:
        no_states(1, q, omega)
    return code


@public
def propagate(
    bodies: size,
    inertia: double[...],
    omega0: double[...],
    attitude0: double[...],
    n: size,
    t: double[...],
    stride: size,
    q: out[double[...]],
    omega: out[double[...]],
    codes: maybe[out[int[...]]],
    failed: out[size[...]],
) -> int:
    """A motion and n states for each of many bodies: inertia[bodies][3], omega0[bodies][3],
    attitude0[bodies][4] and t[n] to q[bodies][n][4] and omega[bodies][n][3], none of which overlap.
    Times of body k are t[k stride], t[k stride + 1], ...: stride is 0 where all have the same, n
    where t is t[bodies][n].
    codes[bodies]: the code of each body; refused bodies and times have states of NaN, and 0 is
    returned.  Where codes is NULL, the first body that is refused ends the call: its number is left
    in *failed, its code is returned, and the states of the bodies before it are written."""
    motions: motion[LANES]
    code: int[LANES]
    lane: lanes
    cleared(lane)
    lenient: bool = codes is not None
    rounds_once: bool = is_rounded_once()
    for first in range(0, bodies, LANES):
        count: size = several_init(
            motions,
            code,
            lane,
            rounds_once,
            bodies - first,
            inertia[3 * first :],
            omega0[3 * first :],
            attitude0[4 * first :],
        )
        for i in range(count):
            k: size = first + i
            if code[i] == OK:
                code[i] = states_of(
                    motions[i], n, t[stride * k :], q[4 * n * k :], omega[3 * n * k :], lenient
                )
            elif lenient:
                no_states(n, q[4 * n * k :], omega[3 * n * k :])
            if codes is not None:
                codes[k] = code[i]
            elif code[i] != OK:
                failed[0] = k
                return code[i]
    return OK


@public
def last_time(motion: motion) -> double:
    """The largest |t| (s) that a motion has states for; NaN where it was not prepared."""
    longest: double = 1.7976931348623157e308
    if motion.prepared != PREPARED:
        return nan
    if not motion.unit > 0.0:
        return longest
    last: double = motion.max_angle / motion.unit
    return min(last, longest)


@public
def motion_size() -> size:
    """sizeof(torque_free_motion), for callers of a shared library."""
    return sizeof(motion)
