"""Steps of bodies, one after another, without lanes."""

PREPARED: int = 0x7F4A7C15
"the mark of a prepared body: a number that memory hardly has by chance"


@public
class body:
    """The constants of a body; written by body_init, read by step."""

    axis: int[3]
    "by moments of inertia, the largest first"
    prepared: int
    "a mark that body_init has written the struct"
    epsilon: double
    "1, or -1 where the axes in this order are left-handed"
    moments: double[3]
    "in this order, in inner units"
    alphas: pair[3]
    "the coefficients of Euler's equations"
    squares: pair[3]
    "their products"


@public
def body_init(body: out[body], inertia: double[3]) -> int:
    """Compute the constants of a body; return a code.

    inertia: principal moments about the body axes, kg m^2, positive.  A call that fails writes
    nothing.
    """
    power: int = moment_scale(inertia)
    c: double[3]
    for k in range(3):
        c[k] = times_power(inertia[k], power)
    code: int = body_code(inertia, c)
    if code != OK:
        return code
    first, second, third, epsilon = order_of(inertia)
    c_a: double = c[first]
    c_b: double = c[second]
    c_d: double = c[third]
    c_ab: pair = two_sum(c_a, -c_b)
    c_ad: pair = two_sum(c_a, -c_d)
    c_bd: pair = two_sum(c_b, -c_d)
    made = step_body(*named())
    body.axis[0] = first
    body.axis[1] = second
    body.axis[2] = third
    body.epsilon = epsilon
    body.moments[0] = c_a
    body.moments[1] = c_b
    body.moments[2] = c_d
    body.alphas[0] = alpha_a
    body.alphas[1] = alpha_b
    body.alphas[2] = alpha_d
    body.squares[0] = l_a
    body.squares[1] = l_b
    body.squares[2] = l_d
    body.prepared = PREPARED
    return OK


def moved(
    c_a: double,
    c_b: double,
    c_d: double,
    alpha_a: pair,
    alpha_b: pair,
    alpha_d: pair,
    l_a: pair,
    l_b: pair,
    l_d: pair,
    q_0: double,
    q_a: double,
    q_b: double,
    q_d: double,
    Omega_a0: double,
    Omega_b0: double,
    Omega_d0: double,
    t: double,
    epsilon: double,
    sigma: double,
) -> tuple[double, double, double, double, double, double, double]:
    """Return the attitude and the rates after a time, about the axes a, b, d."""
    begun = step_start(*named())
    W_re, W_im = step_first(*named())
    for k in range(STEPS):
        if k < STEPS - LAST:
            w_re, w_im = step_projected(*named())
            W_re, W_im = step_second_half(*named())
        else:
            v_re, v_im = step_last_projected(*named())
            W_re, W_im = step_last_second_half(*named())
        X, Y = step_doubled(*named())
    Omega_a, Omega_b, Omega_d = step_rates(*named())
    s_0, s_b, s_d = step_shortest_before(*named())
    p_0, p_a, p_b, p_d = step_front(*named())
    s_0, s_b, s_d = step_shortest(*named())
    turn_0, turn_a, turn_b, turn_d = step_attitude(
        *named(Lambda_rate_hi=Lambda_rate.hi, Lambda_rate_lo=Lambda_rate.lo)
    )
    unit_0, unit_a, unit_b, unit_d = unit(turn_0, turn_a, turn_b, turn_d)
    rate_a, rate_b, rate_d = stochastic(unit_0, unit_a, unit_b, Omega_a, Omega_b, Omega_d)
    return unit_0, unit_a, unit_b, unit_d, rate_a, rate_b, rate_d


@public
def step(body: body, q: out[double[4]], omega: out[double[3]], dt: double) -> int:
    """Compute the free motion after dt (s), in place; return a code.

    q, scalar first, body to inertial, of any length but zero, becomes a unit quaternion, continuous
    in the double cover; omega: body rates in rad/s.  A call that fails writes nothing.
    """
    if body.prepared != PREPARED:
        return UNPREPARED
    code: int = state_code(q, omega, dt)
    if code != OK:
        return code
    power, is_still, t = scaled_time(omega, dt)
    first, second, third = scaled_rates(body.axis, omega, power)
    if not is_short(first, second, third, t):
        return ANGLE
    given: double[4]
    given[0], given[1], given[2], given[3] = scaled_attitude(q)
    if is_still:
        q[0], q[1], q[2], q[3] = unit(given[0], given[1], given[2], given[3])
        return OK
    # The axis a is that of largest moment, or of smallest where K^2 < 2 H c_b.
    is_turned: bool = is_under(body.squares[0].hi, body.squares[2].hi, first, third)
    a: size = 2 if is_turned else 0
    d: size = 0 if is_turned else 2
    rate_a: double = third if is_turned else first
    rate_d: double = first if is_turned else third
    parts: double[3]
    rates: double[3]
    q_0, parts[0], parts[1], parts[2], rates[0], rates[1], rates[2] = moved(
        body.moments[a],
        body.moments[1],
        body.moments[d],
        body.alphas[a],
        body.alphas[1],
        body.alphas[d],
        body.squares[a],
        body.squares[1],
        body.squares[d],
        given[0],
        given[1 + body.axis[a]],
        given[1 + body.axis[1]],
        given[1 + body.axis[d]],
        rate_a,
        second,
        rate_d,
        t,
        -body.epsilon if is_turned else body.epsilon,
        -1.0 if rate_a < 0.0 else 1.0,
    )
    if not is_finite_state(q_0, parts[0], parts[1], parts[2], rates[0], rates[1], rates[2]):
        return ANGLE
    place_1, place_2, place_3 = places(body.axis, is_turned)
    q[0] = q_0
    q[1] = parts[place_1]
    q[2] = parts[place_2]
    q[3] = parts[place_3]
    omega[0] = times_power(rates[place_1], power)
    omega[1] = times_power(rates[place_2], power)
    omega[2] = times_power(rates[place_3], power)
    return OK


@public
def steps(
    n: size,
    inertia: double[...],
    inertia_stride: size,
    q: double[...],
    omega: double[...],
    dt: double[...],
    dt_stride: size,
    q_after: out[double[...]],
    omega_after: out[double[...]],
) -> tuple[int, size]:
    """Compute one step of each of n bodies; return a code and a body.

    q[n][4] and omega[n][3] go to q_after[n][4] and omega_after[n][3], which may be q and omega
    themselves, and overlap nothing else.  Body k has the moments at inertia + k inertia_stride and
    the time dt[k dt_stride]: strides are 3 and 1, or 0 where all have the same.  The first body
    that is refused ends the call: its code and its number are returned, and the bodies before it
    are done.
    """
    one: body
    attitude: double[4]
    rates: double[3]
    failed: size = 0
    for k in range(n):
        failed = k
        if k == 0 or inertia_stride != 0:
            refused: int = body_init(one, inertia[k * inertia_stride :])
            if refused != OK:
                return refused, failed
        attitude = q[4 * k :]
        rates = omega[3 * k :]
        code: int = step(one, attitude, rates, dt[k * dt_stride])
        if code != OK:
            return code, failed
        for j in range(4):
            q_after[4 * k + j] = attitude[j]
        for j in range(3):
            omega_after[3 * k + j] = rates[j]
    failed = 0
    return OK, failed
