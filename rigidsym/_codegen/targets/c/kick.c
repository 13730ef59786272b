/* Mean anomaly = E - e sin E for |mean| <= pi, by Newton's method from pi on the side of the mean
   anomaly, from where it comes down without passing (Charles and Tatum, Celestial Mechanics and
   Dynamical Astronomy 69, 357-372, 1998). */
static double elliptic_anomaly(double mean, double e)
{
    double anomaly = copysign(3.141592653589793, mean);
    for (int k = 0; k < 60; k++) {
        const double change = (anomaly - e * sin(anomaly) - mean) / (1.0 - e * cos(anomaly));
        anomaly -= change;
        if (fabs(change) <= 1e-15 * fabs(anomaly))
            break;
    }
    return anomaly;
}

/* Mean anomaly = e sinh F - F, from the far side of the root. */
static double hyperbolic_anomaly(double mean, double e)
{
    double anomaly = asinh(mean / (e - 1.0));
    for (int k = 0; k < 60; k++) {
        const double change = (e * sinh(anomaly) - anomaly - mean) / (e * cosh(anomaly) - 1.0);
        anomaly -= change;
        if (fabs(change) <= 1e-15 * fabs(anomaly))
            break;
    }
    return anomaly;
}

/* The vector from the mass point to the body, times sqrt(3 mu/r^5). */
static void seen_from(const torque_free_orbit *orbit, double t, double u[3])
{
    const double e = orbit->eccentricity, a = orbit->semi_major;
    const double mean = orbit->mean_motion * (t - orbit->epoch);
    double along, across;
    if (e < 1.0) {
        const double turned = remainder(mean, 6.283185307179586);
        const double anomaly = e > 0.0 ? elliptic_anomaly(turned, e) : turned;
        along = a * (cos(anomaly) - e);
        across = a * sqrt(1.0 - e * e) * sin(anomaly);
    } else {
        const double anomaly = hyperbolic_anomaly(mean, e);
        along = a * (e - cosh(anomaly));
        across = a * sqrt(e * e - 1.0) * sinh(anomaly);
    }
    const double r = hypot(along, across);
    const double strong = sqrt(orbit->strength / r) / (r * r);
    for (int k = 0; k < 3; k++)
        u[k] = strong * (along * orbit->along[k] + across * orbit->across[k]);
}

/* Bodies side by side with their states; results do not depend on the lane. */
typedef struct {
    size_t count;
    torque_free_body bodies[LANES];
    double inertia[LANES][3], q[LANES][4], omega[LANES][3];
} pushed;

static void set_vector(lanes *x, size_t i, const double u[3])
{
    x->u1[i] = u[0], x->u2[i] = u[1], x->u3[i] = u[2];
}

static void set_torque(lanes *x, size_t i, const double c[13])
{
    x->b1[i] = c[0], x->b2[i] = c[1], x->b3[i] = c[2], x->k[i] = c[3];
    x->m1[i] = c[4], x->m2[i] = c[5], x->m3[i] = c[6];
    x->Q11[i] = c[7], x->Q22[i] = c[8], x->Q33[i] = c[9];
    x->Q23[i] = c[10], x->Q13[i] = c[11], x->Q12[i] = c[12];
}

static int drifted(lanes *x, pushed *of, double dt, size_t *failed)
{
    scaling as[LANES];
    for (size_t i = 0; i < of->count; i++) {
        put_body(x, i, &of->bodies[i]);
        const int code = set_state(x, i, of->bodies[i].axis, of->q[i], of->omega[i], dt, &as[i]);
        if (code != TORQUE_FREE_STEP_OK) {
            *failed = i;
            return code;
        }
    }
    move(of->count, x);
    for (size_t i = 0; i < of->count; i++) {
        if (!is_held(x, i)) {
            *failed = i;
            return TORQUE_FREE_STEP_ANGLE;
        }
        get_state(x, i, &as[i], of->q[i], of->omega[i]);
    }
    return TORQUE_FREE_STEP_OK;
}

static void add_more(lanes *x, const pushed *of, const torque_free_torque *torque, double t)
{
    for (size_t i = 0; i < of->count; i++) {
        double sum[3] = {x->T1[i], x->T2[i], x->T3[i]};
        torque->more(t, of->q[i], sum, torque->data);
        x->T1[i] = sum[0], x->T2[i] = sum[1], x->T3[i] = sum[2];
    }
}

static void kicked(lanes *x, pushed *of, const torque_free_torque *torque, double t, double dt)
{
    if (torque->orbit) {
        double u[3];
        seen_from(torque->orbit, t, u);
        for (size_t i = 0; i < of->count; i++)
            set_vector(x, i, u);
    }
    for (size_t i = 0; i < of->count; i++)
        x->q0[i] = of->q[i][0], x->q1[i] = of->q[i][1], x->q2[i] = of->q[i][2], x->q3[i] = of->q[i][3];
    step_kick(of->count, x);
    if (torque->more)
        add_more(x, of, torque, t);
    for (size_t i = 0; i < of->count; i++) {
        of->omega[i][0] += dt * (x->T1[i] / of->inertia[i][0]);
        of->omega[i][1] += dt * (x->T2[i] / of->inertia[i][1]);
        of->omega[i][2] += dt * (x->T3[i] / of->inertia[i][2]);
    }
}

/* All steps of some bodies. */
static int advanced(lanes *x, pushed *of, const torque_free_splitting *method,
                    const torque_free_torque *torque, double begin, double step, size_t first,
                    size_t last, size_t *failed)
{
    double pending = 0.0;
    for (size_t k = first; k < last; k++) {
        double into = 0.0;
        for (size_t part = 0; part < method->count; part++) {
            const int code = drifted(x, of, (pending + method->drifts[part]) * step, failed);
            if (code != TORQUE_FREE_STEP_OK)
                return code;
            pending = 0.0;
            into += method->drifts[part];
            kicked(x, of, torque, begin + ((double)k + into) * step, method->kicks[part] * step);
        }
        pending = method->drifts[method->count];
    }
    return first < last ? drifted(x, of, pending * step, failed) : TORQUE_FREE_STEP_OK;
}

int torque_free_integrate(size_t n, const double *inertia, size_t inertia_stride,
                          const torque_free_splitting *method, const torque_free_torque *torque,
                          double begin, double step, size_t first, size_t last, double *q,
                          double *omega, size_t *failed)
{
    lanes x;
    pushed of;
    *failed = 0;
    if (n && !is_rounded_once())
        return TORQUE_FREE_STEP_ARITHMETIC;
    for (size_t start = 0; start < n; start += LANES) {
        const size_t count = n - start < LANES ? n - start : LANES;
        /* One body goes alone; lanes beyond the last of several repeat it. */
        of.count = count > 1 ? LANES : 1;
        for (size_t i = 0; i < of.count; i++) {
            const size_t k = start + (i < count ? i : count - 1);
            const int code = body_init(&of.bodies[i], inertia + k * inertia_stride);
            if (code != TORQUE_FREE_STEP_OK) {
                *failed = k;
                return code;
            }
            memcpy(of.inertia[i], inertia + k * inertia_stride, sizeof of.inertia[i]);
            memcpy(of.q[i], q + 4 * k, sizeof of.q[i]);
            memcpy(of.omega[i], omega + 3 * k, sizeof of.omega[i]);
            set_torque(&x, i, torque->coefficients + k * torque->coefficients_stride);
            if (!torque->orbit)
                set_vector(&x, i, torque->vector + k * torque->vector_stride);
        }
        const int code = advanced(&x, &of, method, torque, begin, step, first, last, failed);
        if (code != TORQUE_FREE_STEP_OK) {
            *failed = start + (*failed < count ? *failed : count - 1);
            return code;
        }
        memcpy(q + 4 * start, of.q, count * sizeof of.q[0]);
        memcpy(omega + 3 * start, of.omega, count * sizeof of.omega[0]);
    }
    return TORQUE_FREE_STEP_OK;
}
