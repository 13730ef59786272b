"""Motion of bodies under torques by splitting: a Kepler orbit, kicks, and steps between them."""


@public
class orbit:
    """The direction of a body from a mass point on a Kepler orbit.

    mean_motion (rad/s); epoch, a time at periapsis (s); eccentricity, which is not 1; semi_major,
    the size of the semi-major axis (m); strength, 3 mu (m^3/s^2); and unit vectors, inertial axes:
    along towards periapsis, and across a right angle on from there.
    """

    mean_motion: double
    epoch: double
    eccentricity: double
    semi_major: double
    strength: double
    along: double[3]
    across: double[3]


@public
class torque:
    """A torque of each body, b + k v + v x (Q v - m) in body axes, N m.

    v is what a vector u in space is there.  vector: u, inertial axes, of body k at vector + k
    vector_stride; on an orbit, where that is not null, u is that from the mass point times
    sqrt(3 mu/r^5).  coefficients: three b, k, three m, and Q11, Q22, Q33, Q23, Q13, Q12 of body k
    at coefficients + k coefficients_stride.  Strides are 3 and 13, or 0 where all have the same.
    more, where it is not null, adds another torque on a body of attitude q at a time, in body axes,
    and is called with data.
    """

    coefficients: double[...]
    coefficients_stride: size
    vector: double[...]
    vector_stride: size
    orbit: maybe[orbit]
    more: "void (*more)(double t, const double q[4], double torque[3], void *data)"
    data: "void *data"


@public
class splitting:
    """A splitting method: drift, kick, drift ... kick, drift, as shares of a step.

    There is one drift more than kicks, and the last is as long as the first.
    """

    count: size
    drifts: double[...]
    kicks: double[...]


def elliptic_anomaly(mean: double, e: double) -> double:
    """Solve mean anomaly = E - e sin E for |mean| <= pi.

    Newton's method comes from pi on the side of the mean anomaly, from where it comes down without
    passing (Charles and Tatum, Celestial Mechanics and Dynamical Astronomy 69, 357-372, 1998).
    """
    anomaly: double = copysign(3.141592653589793, mean)
    for _ in range(60):
        change: double = (anomaly - e * sin(anomaly) - mean) / (1.0 - e * cos(anomaly))
        anomaly -= change
        if abs(change) <= 1e-15 * abs(anomaly):
            break
    return anomaly


def hyperbolic_anomaly(mean: double, e: double) -> double:
    """Solve mean anomaly = e sinh F - F, from the far side of the root."""
    anomaly: double = asinh(mean / (e - 1.0))
    for _ in range(60):
        change: double = (e * sinh(anomaly) - anomaly - mean) / (e * cosh(anomaly) - 1.0)
        anomaly -= change
        if abs(change) <= 1e-15 * abs(anomaly):
            break
    return anomaly


def seen_from(orbit: orbit, t: double, u: out[double[3]]):
    """Write the vector from the mass point to the body, times sqrt(3 mu/r^5)."""
    e: double = orbit.eccentricity
    a: double = orbit.semi_major
    mean: double = orbit.mean_motion * (t - orbit.epoch)
    along: double
    across: double
    if e < 1.0:
        turned: double = remainder(mean, 6.283185307179586)
        anomaly: double = elliptic_anomaly(turned, e) if e > 0.0 else turned
        along = a * (cos(anomaly) - e)
        across = a * sqrt(1.0 - e * e) * sin(anomaly)
    else:
        anomaly: double = hyperbolic_anomaly(mean, e)
        along = a * (e - cosh(anomaly))
        across = a * sqrt(e * e - 1.0) * sinh(anomaly)
    r: double = hypot(along, across)
    strong: double = sqrt(orbit.strength / r) / (r * r)
    for k in range(3):
        u[k] = strong * (along * orbit.along[k] + across * orbit.across[k])


class pushed:
    """Bodies side by side with their states; results do not depend on the lane."""

    count: size
    bodies: body[LANES]
    inertia: double[LANES, 3]
    q: double[LANES, 4]
    omega: double[LANES, 3]


def set_vector(x: out[lanes], i: size, u: double[...]):
    """Write the vector that a torque depends on to lane i."""
    x.u1[i] = u[0]
    x.u2[i] = u[1]
    x.u3[i] = u[2]


def set_torque(x: out[lanes], i: size, c: double[...]):
    """Write the coefficients of a torque to lane i."""
    x.b1[i] = c[0]
    x.b2[i] = c[1]
    x.b3[i] = c[2]
    x.k[i] = c[3]
    x.m1[i] = c[4]
    x.m2[i] = c[5]
    x.m3[i] = c[6]
    x.Q11[i] = c[7]
    x.Q22[i] = c[8]
    x.Q33[i] = c[9]
    x.Q23[i] = c[10]
    x.Q13[i] = c[11]
    x.Q12[i] = c[12]


def drifted(x: out[lanes], of: out[pushed], dt: double) -> tuple[int, size]:
    """Compute the free motion of some bodies; return a code, and the body that is refused."""
    scales: scaling[LANES]
    for i in range(of.count):
        put_body(x, i, of.bodies[i])
        scales[i].axis = of.bodies[i].axis
        code: int = set_state(x, i, of.q[i], of.omega[i], dt, scales[i])
        if code != OK:
            return code, i
    move(of.count, x)
    for i in range(of.count):
        if not is_held(x, i):
            return ANGLE, i
        get_state(x, i, scales[i], of.q[i], of.omega[i])
    return OK, 0


def add_more(x: out[lanes], of: pushed, torque: torque, t: double):
    """Add the torque that a caller's function computes."""
    for i in range(of.count):
        sum: double[3] = [x.T1[i], x.T2[i], x.T3[i]]
        torque.more(t, of.q[i], sum, torque.data)
        x.T1[i] = sum[0]
        x.T2[i] = sum[1]
        x.T3[i] = sum[2]


def kicked(x: out[lanes], of: out[pushed], torque: torque, t: double, dt: double):
    """Change rates by what a torque at time t does to them in dt."""
    if torque.orbit is not None:
        u: double[3]
        seen_from(torque.orbit, t, u)
        for i in range(of.count):
            set_vector(x, i, u)
    for i in range(of.count):
        x.q0[i] = of.q[i, 0]
        x.q1[i] = of.q[i, 1]
        x.q2[i] = of.q[i, 2]
        x.q3[i] = of.q[i, 3]
    step_kick(of.count, x)
    if torque.more is not None:
        add_more(x, of, torque, t)
    for i in range(of.count):
        of.omega[i, 0] += dt * (x.T1[i] / of.inertia[i, 0])
        of.omega[i, 1] += dt * (x.T2[i] / of.inertia[i, 1])
        of.omega[i, 2] += dt * (x.T3[i] / of.inertia[i, 2])


def advanced(
    x: out[lanes],
    of: out[pushed],
    method: splitting,
    torque: torque,
    begin: double,
    step: double,
    first: size,
    last: size,
) -> tuple[int, size]:
    """Compute all steps of some bodies; return a code, and the body that is refused."""
    code: int = OK
    failed: size = 0
    pending: double = 0.0
    for k in range(first, last):
        into: double = 0.0
        for part in range(method.count):
            code, failed = drifted(x, of, (pending + method.drifts[part]) * step)
            if code != OK:
                return code, failed
            pending = 0.0
            into += method.drifts[part]
            kicked(x, of, torque, begin + (double(k) + into) * step, method.kicks[part] * step)
        pending = method.drifts[method.count]
    if first < last:
        code, failed = drifted(x, of, pending * step)
    return code, failed


@public
def integrate(
    n: size,
    inertia: double[...],
    inertia_stride: size,
    method: splitting,
    torque: torque,
    begin: double,
    step: double,
    first: size,
    last: size,
    q: out[double[...]],
    omega: out[double[...]],
    failed: out[size[...]],
) -> int:
    """Compute the motion of n bodies under a torque, in place.

    It goes from the time begin + first step to begin + last step (s), in q[n][4] and omega[n][3].
    Free motions between kicks are steps, each of |omega dt| up to 2^3 rad; those that meet are one.
    Bodies with moments inertia as in torque_free_steps.  The first body that is refused ends the
    call: its number is left in *failed, its code is returned, and that body and all after it are
    unchanged, except for bodies less than LANES away.
    """
    x: lanes
    of: pushed
    failed[0] = 0
    if n != 0 and not is_rounded_once():
        return ARITHMETIC
    for start in range(0, n, LANES):
        count: size = n - start if n - start < LANES else LANES
        # One body goes alone; lanes beyond the last of several repeat it.
        of.count = LANES if count > 1 else 1
        for i in range(of.count):
            k: size = start + (i if i < count else count - 1)
            code: int = body_constants(of.bodies[i], inertia[k * inertia_stride :])
            if code != OK:
                failed[0] = k
                return code
            of.inertia[i] = inertia[k * inertia_stride :]
            of.q[i] = q[4 * k :]
            of.omega[i] = omega[3 * k :]
            set_torque(x, i, torque.coefficients[k * torque.coefficients_stride :])
            if torque.orbit is None:
                set_vector(x, i, torque.vector[k * torque.vector_stride :])
        ended, lane = advanced(x, of, method, torque, begin, step, first, last)
        if ended != OK:
            failed[0] = start + (lane if lane < count else count - 1)
            return ended
        for i in range(count):
            for j in range(4):
                q[4 * (start + i) + j] = of.q[i, j]
            for j in range(3):
                omega[3 * (start + i) + j] = of.omega[i, j]
    return OK
