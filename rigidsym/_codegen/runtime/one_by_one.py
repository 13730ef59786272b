"""Motions one after another, and their states one time after another, without lanes and blocks."""

PREPARED: int = 0x7F4A7C15
"the mark of a prepared motion: a number that memory hardly has by chance"


@public
class motion:
    """The constants of one motion; written by motion_init, read by all others."""

    branch: int
    "0 steady, 1 circular, 2 hyperbolic"
    axis: int[3]
    "the body axes a, b, d"
    is_blurred: bool
    "later times are refused as SEPARATRIX"
    prepared: int
    "a mark that motion_init has written the struct"
    unit: double
    "a power of two, 1/s: inner times are unit t; 0 at rest"
    max_angle: double
    "the largest inner time"
    q0: double[4]
    "attitude at t = 0"
    omega0: double[3]
    "body rates at t = 0, rad/s"
    of: union[circular, hyperbolic, steady]


def steady_init(motion: out[motion], omega: pair[3], q: pair[4]):
    """Compute the constants of a motion with constant rates."""
    at_rest: bool = is_at_rest(omega)
    one: pair = pair(1.0, 0.0)
    first: pair = one if at_rest else omega[0]
    steady_constants(first, omega[1], omega[2], q[0], q[1], q[2], q[3], motion.of.steady)
    if at_rest:
        motion.unit = 0.0
        motion.of.steady.Lambda_rate_hi = 0.0
        motion.of.steady.Lambda_rate_lo = 0.0


def branch_init(
    motion: out[motion],
    c_a: pair,
    c_b: pair,
    c_d: pair,
    c_ab: pair,
    c_ad: pair,
    c_bd: pair,
    Omega_a: pair,
    Omega_b: pair,
    Omega_d: pair,
    E_b: pair,
    q_0: pair,
    q_a: pair,
    q_b: pair,
    q_d: pair,
    axis_a: double,
    axis_b: double,
    axis_d: double,
    unit: double,
) -> bool:
    """Compute the constants of a motion whose rates change; return True if binary64 holds them."""
    begun = initial_state(*named())
    # Constants are far from the largest numbers: their sum is finite where all are.
    sum: double = 0.0
    if k_1.hi * k_1.hi <= max_circular:
        motion.branch = 1
        circular_constants(*named(), motion.of.circular)
        for x in members(circular):
            sum += motion.of.circular.x
        motion.max_angle = limit(
            motion.max_angle, motion.of.circular.v_rate_hi, motion.of.circular.Lambda_rate_hi
        )
    else:
        motion.branch = 2
        hyperbolic_constants(*named(), motion.of.hyperbolic)
        for x in members(hyperbolic):
            sum += motion.of.hyperbolic.x
        motion.max_angle = limit(
            motion.max_angle, motion.of.hyperbolic.y_rate_hi, motion.of.hyperbolic.Lambda_rate_hi
        )
    return is_held(unit, A_a.hi, A_b.hi, A_d.hi) and isfinite(sum)


def begun_motion(
    motion: out[motion],
    c: pair[3],
    apart: pair[3],
    given: pair[3],
    q: pair[4],
    is_known: bool,
    known: pair,
    unit: double,
) -> int:
    """Compute the constants of a motion from numbers that were checked; return a code.

    c, apart (differences of each moment and the next in turn), the rates `given` and q are in inner
    units; known: E_b, where `is_known`.
    """
    motion.unit = unit
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
    motion.is_blurred = last < max_angle
    side: double = side_of(apart, omega, a, b, d, E_b.hi)
    first: int = d if side < 0.0 else a
    third: int = a if side < 0.0 else d
    motion.axis[0] = first
    motion.axis[1] = b
    motion.axis[2] = third
    motion.prepared = PREPARED
    if is_zero(side):
        motion.branch = 0
        steady_init(motion, omega, turn)
        return OK
    fits: bool = branch_init(
        motion,
        c[first],
        c[b],
        c[third],
        difference(apart, first, b),
        difference(apart, first, third),
        difference(apart, b, third),
        omega[first],
        omega[b],
        omega[third],
        E_b,
        turn[0],
        turn[1 + first],
        turn[1 + b],
        turn[1 + third],
        double(first),
        double(b),
        double(third),
        unit,
    )
    return OK if fits else RATES


@public
def motion_init(
    motion: out[motion], inertia: double[3], omega0: double[3], attitude0: double[4]
) -> int:
    """Compute the constants of a motion; return a code.

    inertia: principal moments about the body axes, kg m^2, positive; omega0: body rates at t = 0,
    rad/s; attitude0: quaternion at t = 0, scalar first, body to inertial, of any length but zero.
    A call that fails writes nothing.
    """
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
    for k in range(4):
        q[k] = pair(scaled_by(attitude0[k], -q_scale), 0.0)
    # Differences of doubles are pairs exactly.
    for k in range(3):
        apart[k] = two_sum(c[k].hi, -c[(k + 1) % 3].hi)
    code: int = broken_rule(inertia, c, attitude0)
    if code != OK:
        return code
    made: motion
    cleared(made)
    code = begun_motion(made, c, apart, omega, q, False, q[0], scaled_by(1.0, scale))
    if code != OK:
        return code
    made.omega0 = omega0
    motion = made
    return OK


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
    """Compute the constants of a motion from numbers known beyond binary64; return a code.

    Each number is the sum of two doubles {hi, lo}.  The largest moment and the largest rate should
    be between 1/2 and 4.  Numbers that pairs would lose by subtraction are arguments, right to all
    digits of a pair: differences, moments 0 less 1, 1 less 2 and 2 less 0, and discriminant, K^2 -
    2 H c_b, b the middle axis, whose sign decides the regime.  Rates are times `unit` rad/s, a
    power of two.  A call that fails writes nothing.
    """
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
    made: motion
    cleared(made)
    known: pair = pair(discriminant[0], discriminant[1])
    code: int = begun_motion(made, c, apart, omega, q, True, known, unit)
    if code == OK:
        motion = made
    return code


def state_after(motion: motion, t: double, t_lo: double, q: out[double[4]], omega: out[double[3]]):
    """Write the state at the inner time t + t_lo."""
    if motion.branch == 0:
        steady_turn = steady_angles(motion.of.steady, t, t_lo)
        q[0], q[1], q[2], q[3] = steady_state(motion.of.steady, *steady_turn)
        omega = motion.omega0
        return
    first: int = motion.axis[0]
    second: int = motion.axis[1]
    third: int = motion.axis[2]
    if motion.branch == 1:
        circular_turn = circular_angles(motion.of.circular, t, t_lo)
        (
            q[0],
            q[1 + first],
            q[1 + second],
            q[1 + third],
            omega[first],
            omega[second],
            omega[third],
        ) = circular_state(motion.of.circular, *circular_turn)
    else:
        hyperbolic_turn = hyperbolic_angles(motion.of.hyperbolic, t, t_lo)
        (
            q[0],
            q[1 + first],
            q[1 + second],
            q[1 + third],
            omega[first],
            omega[second],
            omega[third],
        ) = hyperbolic_state(motion.of.hyperbolic, *hyperbolic_turn)
    if NORMALISES:
        rest: double = 0.5 * (1.0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]))
        for k in range(4):
            q[k] += q[k] * rest


def is_late(motion: motion, t: double) -> bool:
    """Return True for a time at which a motion has no state."""
    return not abs(motion.unit * t) <= motion.max_angle


def refusal(motion: motion, are_finite: bool) -> int:
    """Return the code for times at which a motion has no states."""
    if not are_finite:
        return NOT_FINITE
    return SEPARATRIX if motion.is_blurred else TIME


def no_state(q: out[double[4]], omega: out[double[3]]):
    """Write a state of NaN."""
    for k in range(4):
        q[k] = nan
    for k in range(3):
        omega[k] = nan


@public
def state_at(motion: motion, t: double, q: out[double[4]], omega: out[double[3]]) -> int:
    """Compute the state at time t (s); return a code.

    q: a unit quaternion, body to inertial, continuous in the double cover from attitude0 on; omega:
    body rates in rad/s.  The code is OK, NOT_FINITE, TIME, SEPARATRIX or, as in all functions
    below, UNPREPARED.
    """
    return state_at_sum(motion, t, 0.0, q, omega)


@public
def state_at_sum(
    motion: motion, t: double, t_lo: double, q: out[double[4]], omega: out[double[3]]
) -> int:
    """Compute the state at the time t + t_lo (s); return a code as state_at does.

    The time is the exact sum of two numbers, and t_lo is at most half a unit in the last place of
    t: so times far from 0 are as near to each other as times about 0.
    """
    if motion.prepared != PREPARED:
        return UNPREPARED
    if is_late(motion, t):
        return refusal(motion, isfinite(t) and isfinite(t_lo))
    if not isfinite(t_lo):
        return NOT_FINITE
    if is_zero(t) and is_zero(t_lo):
        q = motion.q0
        omega = motion.omega0
    else:
        state_after(motion, motion.unit * t, motion.unit * t_lo, q, omega)
    return OK


def unrefused_states(
    motion: motion,
    n: size,
    t: double[...],
    q: out[double[...]],
    omega: out[double[...]],
    lenient: bool,
) -> int:
    """Write the states at n times; late ones are refused, or states of NaN where `lenient`."""
    if motion.prepared != PREPARED:
        return UNPREPARED
    is_refused: bool = False
    for i in range(n):
        is_refused = is_refused or is_late(motion, t[i])
    code: int = refusal(motion, all_finite(n, t)) if is_refused else OK
    if is_refused and not lenient:
        return code
    for i in range(n):
        if state_at(motion, t[i], q[4 * i :], omega[3 * i :]) != OK:
            no_state(q[4 * i :], omega[3 * i :])
    return code


@public
def states_at(
    motion: motion, n: size, t: double[...], q: out[double[...]], omega: out[double[...]]
) -> int:
    """Compute the states at n times t[n] (s), in any order; return a code as state_at does.

    q[n][4] and omega[n][3] are written row by row, and overlap neither each other nor t.
    """
    return unrefused_states(motion, n, t, q, omega, False)


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
) -> tuple[int, size]:
    """Compute a motion and n states for each of many bodies; return a code and a body.

    inertia[bodies][3], omega0[bodies][3], attitude0[bodies][4] and t[n] go to q[bodies][n][4] and
    omega[bodies][n][3], none of which overlap.  Times of body k are t[k stride], t[k stride + 1],
    ...: stride is 0 where all have the same, n where t is t[bodies][n].  codes[bodies]: the code of
    each body; refused bodies and times have states of NaN, and OK is returned.  Without codes, the
    first body that is refused ends the call: its code and its number are returned, and the states
    of the bodies before it are written.
    """
    one: motion
    failed: size = 0
    for k in range(bodies):
        code: int = motion_init(one, inertia[3 * k :], omega0[3 * k :], attitude0[4 * k :])
        if code == OK:
            code = unrefused_states(
                one,
                n,
                t[stride * k :],
                q[4 * n * k :],
                omega[3 * n * k :],
                codes is not None,
            )
        elif codes is not None:
            for i in range(n * k, n * k + n):
                no_state(q[4 * i :], omega[3 * i :])
        if codes is not None:
            codes[k] = code
        elif code != OK:
            failed = k
            return code, failed
    return OK, failed


@public
def last_time(motion: motion) -> double:
    """Return the largest |t| (s) that a motion has states for; NaN where it was not prepared."""
    if motion.prepared != PREPARED:
        return nan
    if not motion.unit > 0.0:
        return LARGEST
    last: double = motion.max_angle / motion.unit
    return min(last, LARGEST)
