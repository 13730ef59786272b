/* The number of sensitivities computed side by side: each needs about ninety doubles of stack. */
enum { SENSITIVE = TORQUE_FREE_BLOCK < 32 ? TORQUE_FREE_BLOCK : 32 };

/* The constants of sensitivities; the axes are those with p >= r, where rates are constant, too. */
typedef struct {
    torque_free_along along;
    torque_free_columns columns;
    torque_free_turn turn;
    torque_free_real real;
    torque_free_imaginary imaginary;
    int axis[3], is_real, at_rest;
} sensitive;

static double_double given_pair(const torque_free_motion *motion, int k)
{
    const double_double x = {motion->given[2 * k], motion->given[2 * k + 1]};
    return x;
}

static void sensitive_init(const torque_free_motion *motion, sensitive *made)
{
    double_double c[3], apart_from_next[3], omega[3];
    const double_double E_b = given_pair(motion, 9);
    int *axis = made->axis;
    made->at_rest = 1;
    for (int k = 0; k < 3; k++) {
        c[k] = given_pair(motion, k);
        apart_from_next[k] = given_pair(motion, 3 + k);
        omega[k] = given_pair(motion, 6 + k);
        axis[k] = motion->axis[k];
        made->at_rest = made->at_rest && is_zero(omega[k]);
    }
    if (difference(apart_from_next, axis[0], axis[2]).hi * E_b.hi < 0.0) {
        axis[0] = motion->axis[2];
        axis[2] = motion->axis[0];
    }
    const double_double c_a = c[axis[0]], c_b = c[axis[1]], c_d = c[axis[2]];
    const double_double c_ab = difference(apart_from_next, axis[0], axis[1]);
    const double_double c_ad = difference(apart_from_next, axis[0], axis[2]);
    const double_double c_bd = difference(apart_from_next, axis[1], axis[2]);
    const double_double Omega_a0 = omega[axis[0]], Omega_b0 = omega[axis[1]], Omega_d0 = omega[axis[2]];
    const double axis_a = axis[0], axis_b = axis[1], axis_d = axis[2];
    /* The time at which a motion turns over is known on the hyperbolic branch alone; others hardly do. */
    const int turns_over = motion->branch == 2;
    const double reach = turns_over ? 1.0 : never;
    const double_double y0 = {turns_over ? motion->of.hyperbolic.y0_hi : 0.0,
                              turns_over ? motion->of.hyperbolic.y0_lo : 0.0};
    double_double @moduli@;
    moduli(@moduli given@, @moduli out@);
    along_constants(@along given@, &made->along);
    columns_constants(@columns given@, &made->columns);
    made->is_real = modulus.hi * modulus.hi <= max_real;
    if (made->is_real)
        real_constants(@real given@, &made->real);
    else
        imaginary_constants(@imaginary given@, &made->imaginary);
    if (!made->at_rest)
        turn_constants(c[0].hi, c[1].hi, c[2].hi, difference(apart_from_next, 0, 1).hi,
                       difference(apart_from_next, 0, 2).hi, difference(apart_from_next, 1, 2).hi, omega[0].hi,
                       omega[1].hi, omega[2].hi, motion->q0[0], motion->q0[1], motion->q0[2], motion->q0[3],
                       &made->turn);
}

/* Write S_t, C_t, D_t, E_t, D_t F_t, the integral over the phase and its turns, in rows s apart. */
static void elapsed(const sensitive *made, size_t n, size_t s, const double *restrict t, double *restrict to)
{
    double in[11 * SENSITIVE], rest[SENSITIVE];
    for (size_t i = 0; i < n; i++)
        rest[i] = 0.0;
    if (made->is_real) {
        real_angles(&made->real, n, t, rest, @real rows of in@);
        real_state(&made->real, n, @real rows of in@, t, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s,
                   to + 5 * s, to + 6 * s);
    } else {
        imaginary_angles(&made->imaginary, n, t, rest, @imaginary rows of in@);
        imaginary_state(&made->imaginary, n, @imaginary rows of in@, t, to, to + s, to + 2 * s, to + 3 * s,
                        to + 4 * s, to + 5 * s, to + 6 * s);
    }
}

/* The numbers of doubles of one state in `attitude` and in `rates`, then in attitude_t and in rates_t. */
static size_t width_of(int asked)
{
    const size_t first = asked & TORQUE_FREE_BY_ATTITUDE0 ? 9 : 0, second = asked & TORQUE_FREE_BY_OMEGA0 ? 9 : 0;
    return first + second + (asked & TORQUE_FREE_BY_INERTIA ? 9 : 0);
}

static size_t width_t(int asked) { return asked & TORQUE_FREE_BY_T ? 3 : 0; }

/* Write three columns of each chosen group of a row: by the turn at t = 0, omega0 and the moments. */
static INLINED void put_row(int asked, double *restrict row, const double turn[3], const double *const column[6],
                            size_t i, double by_rate, double by_moment, double again)
{
    const int after = asked & TORQUE_FREE_BY_ATTITUDE0 ? 3 : 0;
    const int last = after + (asked & TORQUE_FREE_BY_OMEGA0 ? 3 : 0);
    for (int k = 0; k < 3; k++) {
        if (asked & TORQUE_FREE_BY_ATTITUDE0)
            row[k] = turn[k];
        if (asked & TORQUE_FREE_BY_OMEGA0)
            row[after + k] = by_rate * column[k][i];
        if (asked & TORQUE_FREE_BY_INERTIA)
            row[last + k] = again * (by_moment * column[3 + k][i]);
    }
}

/* Write the rows of n states.  turned_by: 18 derivatives of the turn by omega0 and the moments, then six
   of turn and rates by the time; by: 18 derivatives of the rates. */
static INLINED void put_rows(int asked, const torque_free_motion *motion, size_t n, const double *restrict turned_by,
                             const double *const by[18], double *restrict attitude, double *restrict rates,
                             double *restrict attitude_t, double *restrict rates_t)
{
    enum { s = SENSITIVE };
    static const double unit_rows[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    static const double zeros[3] = {0.0, 0.0, 0.0};
    const double unit = motion->unit, over = 1.0 / unit, over_moment = 1.0 / motion->moment_unit;
    /* A unit of rates over one of moments may leave binary64 where no rate by a moment does. */
    const double part = ldexp(1.0, (ilogb(unit) - ilogb(motion->moment_unit)) / 2);
    const double rest = unit / part * over_moment;
    const size_t width = width_of(asked) / 3;
    const double *eta[18];
    for (int k = 0; k < 18; k++)
        eta[k] = turned_by + k * s;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < 3; k++) {
            put_row(asked, attitude + 3 * width * i + width * k, unit_rows[k], eta + 6 * k, i, over, over_moment, 1.0);
            put_row(asked, rates + 3 * width * i + width * k, zeros, by + 6 * k, i, 1.0, part, rest);
        }
        for (size_t k = 0; k < 3 && asked & TORQUE_FREE_BY_T; k++) {
            attitude_t[3 * i + k] = unit * turned_by[(18 + k) * s + i];
            rates_t[3 * i + k] = unit * (unit * turned_by[(21 + k) * s + i]);
        }
    }
}

/* Write the derivatives of n <= SENSITIVE states at inner times t. */
static void block_sensitivities(const torque_free_motion *motion, const sensitive *made, int asked, size_t n,
                                const double *restrict t, const double *restrict q, const double *restrict omega,
                                double *restrict attitude, double *restrict rates, double *restrict attitude_t,
                                double *restrict rates_t)
{
    enum { s = SENSITIVE };
    double functions[7 * s], state[7 * s], along[7 * s], columns[21 * s], turned_by[24 * s];
    const double over = 1.0 / motion->unit;
    const double *by[18], *excess[3];
    const int *axis = made->axis;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < 4; k++)
            state[k * s + i] = q[4 * i + k];
        for (size_t k = 0; k < 3; k++)
            state[(4 + k) * s + i] = omega[3 * i + k] * over;
    }
    elapsed(made, n, s, t, functions);
    along_state(&made->along, n, functions, functions + s, functions + 2 * s, functions + 3 * s,
                functions + 4 * s, functions + 5 * s, functions + 6 * s, t, state + (4 + axis[0]) * s, state + (4 + axis[1]) * s,
                state + (4 + axis[2]) * s, @along rows of along@);
    columns_state(&made->columns, n, functions, functions + s, functions + 2 * s, functions + 3 * s,
                  functions + 4 * s, @along rows of along@, t, state + (4 + axis[0]) * s, state + (4 + axis[1]) * s,
                  state + (4 + axis[2]) * s, @columns rows of columns@);
    for (int x = 0; x < 3; x++) {
        excess[axis[x]] = columns + (18 + x) * s;
        for (int y = 0; y < 3; y++) {
            by[6 * axis[x] + axis[y]] = columns + (6 * x + y) * s;
            by[6 * axis[x] + 3 + axis[y]] = columns + (6 * x + 3 + y) * s;
        }
    }
    turn_state(&made->turn, n, state, state + s, state + 2 * s, state + 3 * s, state + 4 * s, state + 5 * s,
               state + 6 * s, @turn columns@, excess[0], excess[1], excess[2], t, @turn rows of turned_by@);
    /* All columns, the most frequent choice, without a test for each number. */
    if (asked == TORQUE_FREE_BY_ALL)
        put_rows(TORQUE_FREE_BY_ALL, motion, n, turned_by, by, attitude, rates, attitude_t, rates_t);
    else
        put_rows(asked, motion, n, turned_by, by, attitude, rates, attitude_t, rates_t);
}

/* Write the derivatives of a body at rest, which begins to turn when given rates, or of any body at t = 0. */
static void plain_sensitivity(const torque_free_motion *motion, double t, int asked, double *restrict attitude,
                              double *restrict rates)
{
    const double *q = motion->q0;
    const double start[3][3] = {
        {1.0 - 2.0 * (q[2] * q[2] + q[3] * q[3]), 2.0 * (q[1] * q[2] - q[0] * q[3]), 2.0 * (q[1] * q[3] + q[0] * q[2])},
        {2.0 * (q[1] * q[2] + q[0] * q[3]), 1.0 - 2.0 * (q[1] * q[1] + q[3] * q[3]), 2.0 * (q[2] * q[3] - q[0] * q[1])},
        {2.0 * (q[1] * q[3] - q[0] * q[2]), 2.0 * (q[2] * q[3] + q[0] * q[1]), 1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2])}};
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 9; j++)
            if (asked >> j / 3 & 1) {
                *attitude++ = j == k ? 1.0 : j >= 3 && j < 6 ? t * start[k][j - 3] : 0.0;
                *rates++ = j == 3 + k ? 1.0 : 0.0;
            }
}

static int any_lost(size_t n, const double *x)
{
    size_t lost = 0;
    for (size_t k = 0; k < n; k++)
        lost += isnan(x[k]) ? 1 : 0;
    return lost > 0;
}

static void no_numbers(size_t n, double *x)
{
    for (size_t k = 0; k < n; k++)
        x[k] = (double)NAN;
}

static void no_changes(size_t n, int asked, double *attitude, double *rates, double *attitude_t, double *rates_t)
{
    no_numbers(width_of(asked) * n, attitude);
    no_numbers(width_of(asked) * n, rates);
    no_numbers(width_t(asked) * n, attitude_t);
    no_numbers(width_t(asked) * n, rates_t);
}

/* Write n states and their sensitivities; late times have NaN where `lenient`. */
static int sensitivities_at(const torque_free_motion *motion, size_t n, const double *t, int asked, double *q,
                            double *omega, double *attitude, double *rates, double *attitude_t, double *rates_t,
                            int lenient)
{
    const size_t most = SENSITIVE, width = width_of(asked), by_t = width_t(asked);
    sensitive made;
    if (motion->prepared != PREPARED)
        return TORQUE_FREE_UNPREPARED;
    int code = states_at(motion, n, t, q, omega, lenient);
    if (code != TORQUE_FREE_OK && !lenient)
        return code;
    sensitive_init(motion, &made);
    for (size_t i = 0; i < n; i += most) {
        const size_t count = n - i < most ? n - i : most;
        double *const turns = attitude + width * i, *const changes = rates + width * i;
        double *const turns_t = attitude_t + by_t * i, *const changes_t = rates_t + by_t * i;
        double inner[SENSITIVE];
        int zero;
        const int near = scaled_times(motion, count, t + i, inner, &zero);
        for (size_t k = 0; !near && k < count; k++)
            inner[k] = fabs(inner[k]) <= motion->max_angle ? inner[k] : 0.0;
        if (!made.at_rest)
            block_sensitivities(motion, &made, asked, count, inner, q + 4 * i, omega + 3 * i, turns, changes, turns_t,
                                changes_t);
        for (size_t k = 0; made.at_rest && k < by_t * count; k++)
            turns_t[k] = changes_t[k] = 0.0;
        for (size_t k = 0; (made.at_rest || zero) && k < count; k++)
            if (made.at_rest || !(t[i + k] < 0.0 || t[i + k] > 0.0))
                plain_sensitivity(motion, t[i + k], asked, turns + width * k, changes + width * k);
        /* Look for lost numbers while the block is in the cache. */
        if (near && !any_lost(width * count, turns) && !any_lost(width * count, changes))
            continue;
        for (size_t k = 0; k < count; k++) {
            double *const own[2] = {turns + width * k, changes + width * k};
            const int late = !(fabs(motion->unit * t[i + k]) <= motion->max_angle);
            if (late || any_lost(width, own[0]) || any_lost(width, own[1])) {
                no_changes(1, asked, own[0], own[1], turns_t + by_t * k, changes_t + by_t * k);
                code = late ? code : TORQUE_FREE_GROWTH;
            }
        }
    }
    return code;
}

int torque_free_states_with_columns(const torque_free_motion *motion, size_t n, const double *t, int asked,
                                    double *q, double *omega, double *attitude, double *rates, double *attitude_t,
                                    double *rates_t)
{
    return sensitivities_at(motion, n, t, asked, q, omega, attitude, rates, attitude_t, rates_t, 0);
}

int torque_free_states_with_sensitivity(const torque_free_motion *motion, size_t n, const double *t, double *q,
                                        double *omega, double *attitude, double *rates, double *attitude_t,
                                        double *rates_t)
{
    return sensitivities_at(motion, n, t, TORQUE_FREE_BY_ALL, q, omega, attitude, rates, attitude_t, rates_t, 0);
}

int torque_free_propagate_with_columns(size_t bodies, const double *inertia, const double *omega0,
                                       const double *attitude0, size_t n, const double *t, size_t stride,
                                       int asked, double *q, double *omega, double *attitude, double *rates,
                                       double *attitude_t, double *rates_t, int *codes, size_t *failed)
{
    torque_free_motion motion[LANES];
    int code[LANES];
    lanes lane;
    memset(&lane, 0, sizeof lane);
    const int rounded = is_rounded_once();
    const size_t width = width_of(asked), by_t = width_t(asked);
    for (size_t first = 0; first < bodies; first += LANES) {
        const size_t count = several_init(motion, code, &lane, rounded, bodies - first, inertia + 3 * first,
                                          omega0 + 3 * first, attitude0 + 4 * first);
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            double *const q_k = q + 4 * n * k, *const omega_k = omega + 3 * n * k;
            double *const attitude_k = attitude + width * n * k, *const rates_k = rates + width * n * k;
            double *const attitude_t_k = attitude_t + by_t * n * k, *const rates_t_k = rates_t + by_t * n * k;
            if (code[i] == TORQUE_FREE_OK) {
                code[i] = sensitivities_at(&motion[i], n, t + stride * k, asked, q_k, omega_k, attitude_k, rates_k,
                                           attitude_t_k, rates_t_k, codes != NULL);
            } else if (codes) {
                no_states(n, q_k, omega_k);
                no_changes(n, asked, attitude_k, rates_k, attitude_t_k, rates_t_k);
            }
            if (codes) {
                codes[k] = code[i];
            } else if (code[i] != TORQUE_FREE_OK) {
                *failed = k;
                return code[i];
            }
        }
    }
    return TORQUE_FREE_OK;
}

int torque_free_propagate_with_sensitivity(size_t bodies, const double *inertia, const double *omega0,
                                           const double *attitude0, size_t n, const double *t, size_t stride,
                                           double *q, double *omega, double *attitude, double *rates,
                                           double *attitude_t, double *rates_t, int *codes, size_t *failed)
{
    return torque_free_propagate_with_columns(bodies, inertia, omega0, attitude0, n, t, stride, TORQUE_FREE_BY_ALL, q,
                                              omega, attitude, rates, attitude_t, rates_t, codes, failed);
}
