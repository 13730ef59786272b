"""Steps of torque-free bodies side by side in lanes."""

PREPARED: int = 0x7F4A7C15
"the mark of a prepared body: a number that memory hardly has by chance"


@public
class body:
    """The constants of a body; written by torque_free_body_init, read by torque_free_step."""

    axis: int[3]
    "by moments of inertia, the largest first"
    prepared: int
    "a mark that torque_free_body_init has written the struct"
    epsilon: double
    moments: double[3]
    alphas: double[6]
    squares: double[6]


class scaling:
    """The given state of a lane, the exponent that scales its rates, and whether nothing turns."""

    axis: int[3]
    power: int
    is_still: bool
    q: double[4]
    omega: double[3]


def set_body(x: out[lanes], i: size, inertia: double[3], axis: out[int[3]]) -> int:
    """Check moments and write them to lane i, the largest first; return a code."""
    power: int = moment_scale(inertia)
    c: double[3]
    for k in range(3):
        c[k] = times_power(inertia[k], power)
    code: int = body_code(inertia, c)
    if code != OK:
        return code
    axis[0], axis[1], axis[2], x.epsilon[i] = order_of(inertia)
    c_a: double = c[axis[0]]
    c_b: double = c[axis[1]]
    c_d: double = c[axis[2]]
    ab: pair = two_sum(c_a, -c_b)
    ad: pair = two_sum(c_a, -c_d)
    bd: pair = two_sum(c_b, -c_d)
    x.c_a_hi[i] = c_a
    x.c_a_lo[i] = 0.0
    x.c_b_hi[i] = c_b
    x.c_b_lo[i] = 0.0
    x.c_d_hi[i] = c_d
    x.c_d_lo[i] = 0.0
    x.c_ab_hi[i] = ab.hi
    x.c_ab_lo[i] = ab.lo
    x.c_ad_hi[i] = ad.hi
    x.c_ad_lo[i] = ad.lo
    x.c_bd_hi[i] = bd.hi
    x.c_bd_lo[i] = bd.lo
    return OK


def get_body(x: lanes, body: out[body]):
    """Copy the constants of the body in lane 0."""
    body.epsilon = x.epsilon[0]
    body.moments[0] = x.c_a_hi[0]
    body.moments[1] = x.c_b_hi[0]
    body.moments[2] = x.c_d_hi[0]
    body.alphas[0] = x.alpha_a_hi[0]
    body.alphas[1] = x.alpha_a_lo[0]
    body.alphas[2] = x.alpha_b_hi[0]
    body.alphas[3] = x.alpha_b_lo[0]
    body.alphas[4] = x.alpha_d_hi[0]
    body.alphas[5] = x.alpha_d_lo[0]
    body.squares[0] = x.l_a_hi[0]
    body.squares[1] = x.l_a_lo[0]
    body.squares[2] = x.l_b_hi[0]
    body.squares[3] = x.l_b_lo[0]
    body.squares[4] = x.l_d_hi[0]
    body.squares[5] = x.l_d_lo[0]


def put_body(x: out[lanes], i: size, body: body):
    """Write the constants of a body to lane i."""
    x.epsilon[i] = body.epsilon
    x.c_a_hi[i] = body.moments[0]
    x.c_b_hi[i] = body.moments[1]
    x.c_d_hi[i] = body.moments[2]
    x.c_a_lo[i] = 0.0
    x.c_b_lo[i] = 0.0
    x.c_d_lo[i] = 0.0
    x.alpha_a_hi[i] = body.alphas[0]
    x.alpha_a_lo[i] = body.alphas[1]
    x.alpha_b_hi[i] = body.alphas[2]
    x.alpha_b_lo[i] = body.alphas[3]
    x.alpha_d_hi[i] = body.alphas[4]
    x.alpha_d_lo[i] = body.alphas[5]
    x.l_a_hi[i] = body.squares[0]
    x.l_a_lo[i] = body.squares[1]
    x.l_b_hi[i] = body.squares[2]
    x.l_b_lo[i] = body.squares[3]
    x.l_d_hi[i] = body.squares[4]
    x.l_d_lo[i] = body.squares[5]


def set_state(
    x: out[lanes], i: size, q: double[4], omega: double[3], dt: double, of: out[scaling]
) -> int:
    """Check a state and a time, and write them to lane i, scaled; return a code.

    The axes of `of` are set before.
    """
    code: int = state_code(q, omega, dt)
    if code != OK:
        return code
    of.omega = omega
    of.power, of.is_still, x.t[i] = scaled_time(omega, dt)
    of.q[0], of.q[1], of.q[2], of.q[3] = scaled_attitude(q)
    a, b, d = scaled_rates(of.axis, omega, of.power)
    x.Omega_a0_hi[i] = a
    x.Omega_b0_hi[i] = b
    x.Omega_d0_hi[i] = d
    x.Omega_a0_lo[i] = 0.0
    x.Omega_b0_lo[i] = 0.0
    x.Omega_d0_lo[i] = 0.0
    x.q_0[i] = of.q[0]
    x.q_a[i] = of.q[1 + of.axis[0]]
    x.q_b[i] = of.q[1 + of.axis[1]]
    x.q_d[i] = of.q[1 + of.axis[2]]
    return OK if is_short(a, b, d, x.t[i]) else ANGLE


def circulating(n: size, x: out[lanes]):
    """Choose the axis a: that of largest moment, or of smallest where K^2 < 2 H c_b."""
    for i in range(n):
        turned: bool = is_under(x.l_a_hi[i], x.l_d_hi[i], x.Omega_a0_hi[i], x.Omega_d0_hi[i])
        sign: double = -1.0 if turned else 1.0
        x.Omega_a0_hi[i], x.Omega_d0_hi[i] = swapped(turned, x.Omega_a0_hi[i], x.Omega_d0_hi[i])
        x.c_a_hi[i], x.c_d_hi[i] = swapped(turned, x.c_a_hi[i], x.c_d_hi[i])
        x.alpha_a_hi[i], x.alpha_d_hi[i] = swapped(turned, x.alpha_a_hi[i], x.alpha_d_hi[i])
        x.alpha_a_lo[i], x.alpha_d_lo[i] = swapped(turned, x.alpha_a_lo[i], x.alpha_d_lo[i])
        x.l_a_hi[i], x.l_d_hi[i] = swapped(turned, x.l_a_hi[i], x.l_d_hi[i])
        x.l_a_lo[i], x.l_d_lo[i] = swapped(turned, x.l_a_lo[i], x.l_d_lo[i])
        x.q_a[i], x.q_d[i] = swapped(turned, x.q_a[i], x.q_d[i])
        x.epsilon[i] *= sign
        x.turned[i] = sign
        x.sigma[i] = -1.0 if x.Omega_a0_hi[i] < 0.0 else 1.0


def advance(n: size, x: out[lanes]):
    """Replace X, Y and W by their values at twice the time."""
    for i in range(n):
        x.X_hi[i] = x.X_next_hi[i]
        x.X_lo[i] = x.X_next_lo[i]
        x.Y_hi[i] = x.Y_next_hi[i]
        x.Y_lo[i] = x.Y_next_lo[i]
        x.W_re[i] = x.W_next_re[i]
        x.W_im[i] = x.W_next_im[i]


def normalise(n: size, x: out[lanes]):
    """Normalise the attitudes of all lanes."""
    for i in range(n):
        x.q_0[i], x.q_a[i], x.q_b[i], x.q_d[i] = unit(x.q_0[i], x.q_a[i], x.q_b[i], x.q_d[i])


def round_rates(n: size, x: out[lanes]):
    """Round the rates of all lanes up or down at random."""
    for i in range(n):
        x.Omega_a_hi[i], x.Omega_b_hi[i], x.Omega_d_hi[i] = stochastic(
            x.q_0[i],
            x.q_a[i],
            x.q_b[i],
            pair(x.Omega_a_hi[i], x.Omega_a_lo[i]),
            pair(x.Omega_b_hi[i], x.Omega_b_lo[i]),
            pair(x.Omega_d_hi[i], x.Omega_d_lo[i]),
        )


def move(n: size, x: out[lanes]):
    """Compute the states of n lanes after their times."""
    circulating(n, x)
    step_start(n, x)
    step_first(n, x)
    for k in range(STEPS):
        if k < STEPS - LAST:
            step_projected(n, x)
            step_second_half(n, x)
        else:
            step_last_projected(n, x)
            step_last_second_half(n, x)
        step_doubled(n, x)
        advance(n, x)
    step_rates(n, x)
    step_shortest_before(n, x)
    step_front(n, x)
    step_shortest(n, x)
    step_attitude(n, x)
    normalise(n, x)
    round_rates(n, x)


def is_held(x: lanes, i: size) -> bool:
    """Return True where the state of lane i is finite."""
    return is_finite_state(
        x.q_0[i],
        x.q_a[i],
        x.q_b[i],
        x.q_d[i],
        x.Omega_a_hi[i],
        x.Omega_b_hi[i],
        x.Omega_d_hi[i],
    )


def get_state(x: lanes, i: size, of: scaling, q: out[double[4]], omega: out[double[3]]):
    """Copy the state of lane i, in the given order of axes; a body at rest keeps its state."""
    if of.is_still:
        q[0], q[1], q[2], q[3] = unit(of.q[0], of.q[1], of.q[2], of.q[3])
        omega = of.omega
        return
    parts: double[3] = [x.q_a[i], x.q_b[i], x.q_d[i]]
    rates: double[3] = [x.Omega_a_hi[i], x.Omega_b_hi[i], x.Omega_d_hi[i]]
    first, second, third = places(of.axis, x.turned[i] < 0.0)
    q[0] = x.q_0[i]
    q[1] = parts[first]
    q[2] = parts[second]
    q[3] = parts[third]
    omega[0] = times_power(rates[first], of.power)
    omega[1] = times_power(rates[second], of.power)
    omega[2] = times_power(rates[third], of.power)


def body_constants(body: out[body], inertia: double[3]) -> int:
    """Compute the constants of a body without testing this build's arithmetic; return a code."""
    x: lanes
    code: int = set_body(x, 0, inertia, body.axis)
    if code != OK:
        return code
    step_body(1, x)
    get_body(x, body)
    body.prepared = PREPARED
    return OK


@public
def body_init(body: out[body], inertia: double[3]) -> int:
    """Compute the constants of a body.

    inertia: principal moments about the body axes, kg m^2, positive.  Functions that take moments
    refuse those that no body can have, beyond rounding, as TORQUE_FREE_STEP_NONPHYSICAL, unless the
    source is compiled with -DALLOW_NONPHYSICAL.  Returns a code above.
    """
    made: body
    code: int = body_constants(made, inertia)
    if code != OK:
        return code
    if not is_rounded_once():
        return ARITHMETIC
    body = made
    return OK


@public
def step(body: body, q: out[double[4]], omega: out[double[3]], dt: double) -> int:
    """Compute the free motion after dt (s), in place.

    q[4], scalar first, body to inertial, of any length but zero, becomes a unit quaternion,
    continuous in the double cover; omega[3], body rates in rad/s.  Returns a code above; a call
    that fails writes nothing.
    """
    x: lanes
    of: scaling
    if body.prepared != PREPARED:
        return UNPREPARED
    of.axis = body.axis
    code: int = set_state(x, 0, q, omega, dt, of)
    if code != OK:
        return code
    put_body(x, 0, body)
    move(1, x)
    if not is_held(x, 0):
        return ANGLE
    get_state(x, 0, of, q, omega)
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
    failed: out[size[...]],
) -> int:
    """Compute one step of each of n bodies of moments inertia[n][3], in lanes.

    q[n][4] and omega[n][3] go to q_after[n][4] and omega_after[n][3], which may be q and omega
    themselves, and overlap nothing else.  Body k has the moments at inertia + k inertia_stride and
    the time dt[k dt_stride]: strides are 3 and 1, or 0 where all have the same.  A body has the
    same bits wherever it stands among others.  The first body that is refused ends the call: its
    number is left in *failed, its code is returned, and bodies LANES or more before it are done.
    """
    alike: body
    x: lanes
    of: scaling[LANES]
    code: int = OK
    failed[0] = 0
    if n == 0:
        return OK
    if inertia_stride == 0:
        code = body_init(alike, inertia)
    elif not is_rounded_once():
        code = ARITHMETIC
    if code != OK:
        return code
    for begin in range(0, n, LANES):
        count: size = n - begin if n - begin < LANES else LANES
        for i in range(LANES):
            # Lanes beyond the last body repeat it.
            k: size = begin + (i if i < count else count - 1)
            if inertia_stride != 0:
                code = set_body(x, i, inertia[k * inertia_stride :], of[i].axis)
            else:
                put_body(x, i, alike)
                of[i].axis = alike.axis
            if code == OK:
                code = set_state(x, i, q[4 * k :], omega[3 * k :], dt[k * dt_stride], of[i])
            if code != OK:
                failed[0] = k
                return code
        if inertia_stride != 0:
            step_body(LANES, x)
        move(LANES, x)
        for i in range(count):
            if not is_held(x, i):
                failed[0] = begin + i
                return ANGLE
            get_state(x, i, of[i], q_after[4 * (begin + i) :], omega_after[3 * (begin + i) :])
    return OK


@public
def body_size() -> size:
    """Return sizeof(torque_free_body), for callers of a shared library."""
    return sizeof(body)
