@limits@
#define BLOCK ((size_t)TORQUE_FREE_BLOCK)

/* The mark of a prepared motion: a number that memory hardly has by chance. */
enum { PREPARED = 0x7f4a7c15 };

@bodies.c@

/* Exponent of the largest, so that x 2^-exponent is below 2; 0 for zeros. */
static int exponent_of(size_t n, const double *x)
{
    double largest = 0.0;
    int e;
    for (size_t k = 0; k < n; k++)
        largest = fabs(x[k]) > largest ? fabs(x[k]) : largest;
    (void)frexp(largest, &e);
    return e - 1;
}

/* x 2^n, by `ldexp` where 2^n is no normal double. */
static double scaled_by(double x, int n)
{
    return n >= -1022 && n <= 1023 ? x * power_of_two((double)n) : ldexp(x, n);
}

static double_double scaled(double_double x, int n)
{
    const double_double y = {scaled_by(x.hi, n), scaled_by(x.lo, n)};
    return y;
}

static int all_finite(size_t n, const double *x)
{
    for (size_t k = 0; k < n; k++)
        if (!isfinite(x[k]))
            return 0;
    return 1;
}

static int is_zero(double_double x) { return !(x.hi < 0.0 || x.hi > 0.0); }

/* c_j - c_k of two different axes; apart holds the differences of each moment and the next in turn. */
static double_double difference(const double_double apart[3], int j, int k)
{
    return k == (j + 1) % 3 ? apart[j] : dd_neg(apart[k]);
}

/* Sort the axes by their moments, largest first; equal ones keep their order. */
static void sorted(const double_double apart[3], int axis[3])
{
    for (int k = 0; k < 3; k++)
        axis[k] = k;
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < 2; k++)
            if (difference(apart, axis[k], axis[k + 1]).hi < 0.0) {
                const int first = axis[k];
                axis[k] = axis[k + 1];
                axis[k + 1] = first;
            }
}

/* 1 or -1 where a is the axis of largest or smallest moment, 0 where rates are constant; the axes are
   sorted by their moments. */
static double side_of(const double_double apart[3], const double_double omega[3], const int axis[3], double E_2)
{
    const int j = axis[0], k = axis[1], l = axis[2];
    return circulation(!is_zero(difference(apart, j, k)), !is_zero(difference(apart, j, l)),
                       !is_zero(difference(apart, k, l)), !is_zero(omega[j]), !is_zero(omega[k]),
                       !is_zero(omega[l]), E_2);
}

/* E_b to all digits of a double_double, in exact arithmetic where its terms cancel. */
static double_double discriminant_of(const double_double c[3], const double_double apart[3], const double_double omega[3], const int axis[3])
{
    const double_double c_a = c[axis[0]], c_b = c[axis[1]], c_d = c[axis[2]];
    const double_double c_ab = difference(apart, axis[0], axis[1]), c_bd = difference(apart, axis[1], axis[2]);
    const double_double zero = {0.0, 0.0};
    const double rates[2] = {omega[axis[0]].hi, omega[axis[2]].hi};
    const int scale = exponent_of(2, rates);
    const double_double a = scaled(omega[axis[0]], -scale), d = scaled(omega[axis[2]], -scale);
    const double_double over = discriminant_dd(c_a, c_d, c_ab, c_bd, a, zero);
    const double_double under = discriminant_dd(c_a, c_d, c_ab, c_bd, zero, d);
    const double_double sum = dd_add_xx(over, under);
    if (fabs(sum.hi) > (over.hi - under.hi) / 1024.0)
        return scaled(sum, 2 * scale);
    const exact moment_b = exact_of(c_b.hi);
    const exact above = exact_sub_xx(exact_of(c_a.hi), moment_b);
    const exact below = exact_sub_xx(moment_b, exact_of(c_d.hi));
    return scaled(exact_to_dd(discriminant_exact(exact_of(c_a.hi), exact_of(c_d.hi), above, below,
                                             exact_of(a.hi), exact_of(d.hi))),
                  2 * scale);
}

static void steady_init(torque_free_motion *motion, const double_double omega[3], const double_double q[4])
{
    double_double rates[3] = {omega[0], omega[1], omega[2]};
    const int at_rest = is_zero(omega[0]) && is_zero(omega[1]) && is_zero(omega[2]);
    if (at_rest)
        rates[0] = dd_of(1.0);
    motion->branch = 0;
    steady_constants(rates[0], rates[1], rates[2], q[0], q[1], q[2], q[3], &motion->of.steady);
    if (at_rest)
        motion->unit = motion->of.steady.Lambda_rate_hi = motion->of.steady.Lambda_rate_lo = 0.0;
}

/* Shorten the time domain of nonphysical bodies, which can speed up a lot after t = 0. */
static void limit(torque_free_motion *motion, double rate, double other)
{
    const double largest = fabs(rate) > fabs(other) ? fabs(rate) : fabs(other);
    if (largest > 16.0)
        motion->max_angle = fmin(motion->max_angle, 16.0 * max_angle / largest);
}

/* Return 1 where no constant of a motion and no rate, up to its amplitude, overflows. */
static int is_held(double unit, const double *amplitude, size_t n, const double *constants)
{
    for (int k = 0; k < 3; k++)
        if (!(amplitude[k] * unit <= max_rate))
            return 0;
    return all_finite(n, constants);
}

/* Copy lane i of the constants of a branch to a motion; return a code. */
static int take(torque_free_motion *motion, const lanes *lane, size_t i, const double *rows, size_t held)
{
    const double amplitude[3] = {lane->A_a_hi[i], lane->A_b_hi[i], lane->A_d_hi[i]};
    double *constants = (double *)&motion->of;
    for (size_t k = 0; k < held; k++)
        constants[k] = rows[k * LANES + i];
    if (motion->branch == 1)
        limit(motion, motion->of.circular.v_rate_hi, motion->of.circular.Lambda_rate_hi);
    else
        limit(motion, motion->of.hyperbolic.y_rate_hi, motion->of.hyperbolic.Lambda_rate_hi);
    return is_held(motion->unit, amplitude, held, constants) ? TORQUE_FREE_OK : TORQUE_FREE_RATES;
}

/* Write the numbers that the constants of a motion are computed from to lane i. */
#define PUT(name, value) (lane->name##_hi[i] = (value).hi, lane->name##_lo[i] = (value).lo)

static void put(lanes *lane, size_t i, const torque_free_motion *motion, const double_double c[3],
                const double_double apart[3], const double_double omega[3], const double_double q[4], double_double E_b)
{
    const int a = motion->axis[0], b = motion->axis[1], d = motion->axis[2];
    PUT(c_a, c[a]), PUT(c_b, c[b]), PUT(c_d, c[d]);
    PUT(c_ab, difference(apart, a, b)), PUT(c_ad, difference(apart, a, d)), PUT(c_bd, difference(apart, b, d));
    PUT(Omega_a, omega[a]), PUT(Omega_b, omega[b]), PUT(Omega_d, omega[d]), PUT(E_b, E_b);
    PUT(q_0, q[0]), PUT(q_a, q[1 + a]), PUT(q_b, q[1 + b]), PUT(q_d, q[1 + d]);
    lane->axis_a[i] = a, lane->axis_b[i] = b, lane->axis_d[i] = d;
    lane->unit[i] = motion->unit;
}

/* Copy a used lane to all that are not used, so that unused lanes raise no exceptions. */
static void repeat(lanes *lane, const int own[LANES])
{
    double *row = (double *)lane;
    size_t from = 0;
    while (!own[from])
        from++;
    for (size_t k = 0; k < sizeof *lane / sizeof *row; k += LANES)
        for (size_t i = 0; i < LANES; i++)
            row[k + i] = own[i] ? row[k + i] : row[k + from];
}

/* Compute the constants of those of n motions that are on one branch, from the lanes of `initial_state`. */
static void branch_init(const lanes *lane, int branch, size_t n, torque_free_motion *motion, int *code)
{
    lanes alike = *lane;
    union {
        circular_lanes circular;
        hyperbolic_lanes hyperbolic;
    } of;
    int own[LANES], count = 0, others = 0;
    for (size_t i = 0; i < LANES; i++) {
        own[i] = i < n && motion[i].branch == branch;
        count += own[i];
        others += i < n && motion[i].branch && !own[i];
    }
    if (!count)
        return;
    if (others)
        repeat(&alike, own);
    if (branch == 1)
        circular_constants(&alike, &of.circular);
    else
        hyperbolic_constants(&alike, &of.hyperbolic);
    const size_t held = branch == 1 ? sizeof(torque_free_circular) : sizeof(torque_free_hyperbolic);
    for (size_t i = 0; i < n; i++)
        if (own[i])
            code[i] = take(&motion[i], lane, i, (const double *)&of, held / sizeof(double));
}

/* Compute the constants of n motions that `begin` wrote to lanes, and their codes; steady ones have theirs. */
static void moving_init(lanes *lane, size_t n, torque_free_motion *motion, int *code)
{
    int own[LANES], count = 0;
    for (size_t i = 0; i < LANES; i++) {
        own[i] = i < n && motion[i].branch;
        count += own[i];
    }
    if (!count)
        return;
    if (count < LANES)
        repeat(lane, own);
    initial_state(lane);
    for (size_t i = 0; i < n; i++)
        if (own[i])
            motion[i].branch = lane->k_1_hi[i] * lane->k_1_hi[i] <= max_circular ? 1 : 2;
    branch_init(lane, 1, n, motion, code);
    branch_init(lane, 2, n, motion, code);
}

/* log2(x), x >= 0, without an exception for zero. */
static double log2_of(double x) { return x > 0.0 ? log2(x) : -HUGE_VAL; }

/* log2(2^x + 2^y); both may be minus infinity. */
static double log2_sum(double x, double y)
{
    const double most = x > y ? x : y, other = x > y ? y : x;
    return isfinite(most) ? most + log2(1.0 + exp2(other - most)) : most;
}

/* Follow the separatrix, or spin about the middle axis, up to a time, where E_b is too faint, or where
   rates taken for zero could decide when that spin turns over.

   With X = sqrt(c_a |c_a - c_b|) Omega_a, Z = sqrt(c_d |c_b - c_d|) Omega_d Euler's equations are
   X' = k Omega_b Z, Z' = k Omega_b X, but for signs.  So X + Z and X - Z, whose product is E_b, grow
   no faster than exp(lambda t), lambda being k times the largest |Omega_b|; of the separatrix one is
   zero, of the spin both are.  What of them is not zero may grow to 2^@tolerated@ of the momentum. */
static void follow(torque_free_motion *motion, const double_double c[3], const double_double apart[3], double_double omega[3],
                   const double_double given[3], double_double *E_b, int is_faint)
{
    const int *axis = motion->axis;
    const double c_a = c[axis[0]].hi, c_b = c[axis[1]].hi, c_d = c[axis[2]].hi;
    const double over = fabs(difference(apart, axis[0], axis[1]).hi);
    const double under = fabs(difference(apart, axis[1], axis[2]).hi);
    const double largest = c_a > c_d ? c_a : c_d, smallest = c_a > c_d ? c_d : c_a;
    const double weight[2] = {0.5 * log2_of(c_a * over), 0.5 * log2_of(c_d * under)};
    double part[2], gone = -HUGE_VAL, left = -HUGE_VAL, momentum = 0.0;
    for (int k = 0; k < 2; k++) {
        part[k] = weight[k] + log2_of(fabs(given[axis[2 * k]].hi));
        if (is_zero(omega[axis[2 * k]]))
            gone = log2_sum(gone, part[k]);
        else
            left = log2_sum(left, part[k]);
    }
    for (int k = 0; k < 3; k++)
        momentum = fmax(momentum, c[k].hi * fabs(given[k].hi));
    const double size = log2_sum(part[0], part[1]), distance = log2_of(fabs(E_b->hi));
    const int is_spin = gone > left + log2(decisive) || (is_faint && distance > 2.0 * size + log2(decisive));
    if (!is_spin && !is_faint)
        return;
    const double rate_b = given[axis[1]].hi, rate_d = given[axis[2]].hi;
    const double growth = sqrt(over / c_a * (under / c_d) * (rate_b * rate_b) +
                               under / c_b * ((over + under) / c_a) * (rate_d * rate_d));
    const double slow = fmin(0.0, log2_of(growth) + log2(smallest / largest));
    const double room = fmin(weight[0], weight[1]) + log2(momentum / largest) + slow -
                        (is_spin ? size : distance - size);
    const double bits = log2(tolerated) + room;
    motion->max_angle = bits > 0.0 ? fmin(log(2.0) * bits / growth, max_angle) : 0.0;
    motion->blurred = motion->max_angle < max_angle;
    *E_b = dd_of(0.0);
    for (int k = 0; k < 3 && is_spin; k += 2)
        omega[axis[k]] = dd_of(0.0);
}

/* Copy the numbers that sensitivities are computed from to the motion. */
static void keep(torque_free_motion *motion, const double_double c[3], const double_double apart[3],
                 const double_double omega[3], double_double E_b)
{
    for (int k = 0; k < 10; k++) {
        const double_double x = k < 3 ? c[k] : k < 6 ? apart[k - 3] : k < 9 ? omega[k - 6] : E_b;
        motion->given[2 * k] = x.hi;
        motion->given[2 * k + 1] = x.lo;
    }
}

/* Set all of a motion but the constants of its branch, and write what these are computed from to lane i.
   c, apart (differences of each moment and the next in turn), the rates `given` and q are in inner
   units. */
static void begin(torque_free_motion *motion, lanes *lane, size_t i, const double_double c[3],
                  const double_double apart[3], const double_double given[3], const double_double q[4],
                  const double_double *known, double unit)
{
    double_double omega[3], length = dd_mul_xx(q[0], q[0]), unit_q[4];
    memset(motion, 0, sizeof *motion);
    motion->prepared = PREPARED;
    for (int k = 0; k < 3; k++) {
        omega[k] = fabs(given[k].hi) < negligible ? dd_of(0.0) : given[k];
        length = dd_add_xx(length, dd_mul_xx(q[k + 1], q[k + 1]));
    }
    length = dd_sqrt(length);
    motion->unit = unit;
    motion->max_angle = max_angle;
    for (int k = 0; k < 4; k++) {
        unit_q[k] = dd_div_xx(q[k], length);
        motion->q0[k] = dd_rounded(unit_q[k]);
    }
    for (int k = 0; k < 3; k++)
        motion->omega0[k] = given[k].hi * unit;
    sorted(apart, motion->axis);
    double_double discriminant = known ? *known : discriminant_of(c, apart, omega, motion->axis);
    const int distinct = !is_zero(apart[0]) && !is_zero(apart[1]) && !is_zero(apart[2]);
    const int faint = !is_zero(discriminant) && fabs(discriminant.hi) < min_discriminant;
    int lost = 0;
    for (int k = 0; k < 3; k += 2)
        lost |= is_zero(omega[motion->axis[k]]) && !is_zero(given[motion->axis[k]]);
    if (distinct && (lost || faint))
        follow(motion, c, apart, omega, given, &discriminant, faint);
    motion->moment_unit = 1.0;
    keep(motion, c, apart, omega, discriminant);
    const double side = side_of(apart, omega, motion->axis, discriminant.hi);
    if (side < 0.0) {
        const int first = motion->axis[0];
        motion->axis[0] = motion->axis[2];
        motion->axis[2] = first;
    }
    motion->branch = side < 0.0 || side > 0.0;
    if (motion->branch)
        put(lane, i, motion, c, apart, omega, unit_q, discriminant);
    else
        steady_init(motion, omega, unit_q);
}

/* Check doubles and begin a motion with them; return a code. */
static int begin_doubles(torque_free_motion *motion, lanes *lane, size_t i, const double inertia[3],
                         const double omega0[3], const double attitude0[4])
{
    double_double c[3], apart[3], omega[3], q[4];
    double smallest = inertia[0];
    motion->branch = 0;
    if (!all_finite(3, inertia) || !all_finite(3, omega0) || !all_finite(4, attitude0))
        return TORQUE_FREE_NOT_FINITE;
    for (int k = 1; k < 3; k++)
        smallest = inertia[k] < smallest ? inertia[k] : smallest;
    if (!(smallest > 0.0))
        return TORQUE_FREE_INERTIA;
    const int c_scale = exponent_of(3, inertia), scale = exponent_of(3, omega0);
    const int q_scale = exponent_of(4, attitude0);
    int is_zero_attitude = 1;
    for (int k = 0; k < 3; k++) {
        c[k] = dd_of(scaled_by(inertia[k], -c_scale));
        omega[k] = dd_of(scaled_by(omega0[k], -scale));
        /* Numbers other than zero stay so. */
        if (is_zero(omega[k]) && !is_zero(dd_of(omega0[k])))
            omega[k] = dd_of(copysign(4.9406564584124654e-324, omega0[k]));
    }
    if (!can_exist(c))
        return TORQUE_FREE_NONPHYSICAL;
    if (scaled_by(smallest, -c_scale) < min_moment_ratio)
        return TORQUE_FREE_THIN;
    for (int k = 0; k < 4; k++) {
        q[k] = dd_of(scaled_by(attitude0[k], -q_scale));
        is_zero_attitude = is_zero_attitude && is_zero(q[k]);
    }
    if (is_zero_attitude)
        return TORQUE_FREE_ATTITUDE;
    /* Differences of doubles are pairs exactly. */
    for (int k = 0; k < 3; k++)
        apart[k] = two_sum(c[k].hi, -c[(k + 1) % 3].hi);
    begin(motion, lane, i, c, apart, omega, q, NULL, scaled_by(1.0, scale));
    for (int k = 0; k < 3; k++)
        motion->omega0[k] = omega0[k];
    motion->moment_unit = scaled_by(1.0, c_scale);
    return TORQUE_FREE_OK;
}

/* Finish one motion that was begun, and return its code. */
static int end(torque_free_motion *motion, torque_free_motion *made, lanes *lane)
{
    int code = TORQUE_FREE_OK;
    if (!is_rounded_once())
        return TORQUE_FREE_ARITHMETIC;
    moving_init(lane, 1, made, &code);
    if (code == TORQUE_FREE_OK)
        *motion = *made;
    return code;
}

int torque_free_motion_init(torque_free_motion *motion, const double inertia[3], const double omega0[3],
                          const double attitude0[4])
{
    torque_free_motion made;
    lanes lane;
    memset(&lane, 0, sizeof lane);
    const int code = begin_doubles(&made, &lane, 0, inertia, omega0, attitude0);
    return code == TORQUE_FREE_OK ? end(motion, &made, &lane) : code;
}

int torque_free_motion_init_double_doubles(torque_free_motion *motion, const double inertia[3][2],
                                const double differences[3][2], const double omega0[3][2],
                                const double attitude0[4][2], const double discriminant[2], double unit)
{
    double_double c[3], apart[3], omega[3], q[4];
    for (int k = 0; k < 4; k++) {
        const double_double one = {attitude0[k][0], attitude0[k][1]};
        q[k] = one;
    }
    for (int k = 0; k < 3; k++) {
        const double_double moment = {inertia[k][0], inertia[k][1]}, rate = {omega0[k][0], omega0[k][1]};
        const double_double above = {differences[k][0], differences[k][1]};
        c[k] = moment;
        apart[k] = above;
        omega[k] = rate;
        if (!all_finite(2, inertia[k]) || !all_finite(2, differences[k]) || !all_finite(2, omega0[k]))
            return TORQUE_FREE_NOT_FINITE;
        if (!(moment.hi > 0.0))
            return TORQUE_FREE_INERTIA;
        if (moment.hi < min_moment_ratio || moment.hi > 4.0)
            return TORQUE_FREE_THIN;
        if (fabs(rate.hi) > 4.0)
            return TORQUE_FREE_RATES;
    }
    if (!can_exist(c))
        return TORQUE_FREE_NONPHYSICAL;
    if (!all_finite(8, &attitude0[0][0]) || !all_finite(2, discriminant) || !isfinite(unit))
        return TORQUE_FREE_NOT_FINITE;
    if (!(unit > 0.0))
        return TORQUE_FREE_RATES;
    if (is_zero(q[0]) && is_zero(q[1]) && is_zero(q[2]) && is_zero(q[3]))
        return TORQUE_FREE_ATTITUDE;
    const double_double known = {discriminant[0], discriminant[1]};
    torque_free_motion made;
    lanes lane;
    memset(&lane, 0, sizeof lane);
    begin(&made, &lane, 0, c, apart, omega, q, &known, unit);
    return end(motion, &made, &lane);
}

/* Scale times to inner units; return 1 if all are within the domain, and set *zero if one is zero. */
static int scaled_times(const torque_free_motion *motion, size_t n, const double *restrict t,
                        double *restrict inner, int *zero)
{
    const double unit = motion->unit, last = motion->max_angle;
    int bad = 0, zeros = 0;
    for (size_t i = 0; i < n; i++) {
        inner[i] = unit * t[i];
        bad |= !(fabs(inner[i]) <= last);
        zeros |= !(t[i] < 0.0 || t[i] > 0.0);
    }
    *zero = zeros;
    return !bad;
}

static void interleaved(size_t n, const double *restrict a, const double *restrict b,
                        const double *restrict c, double *restrict rows)
{
    for (size_t i = 0; i < n; i++) {
        rows[3 * i] = a[i];
        rows[3 * i + 1] = b[i];
        rows[3 * i + 2] = c[i];
    }
}

static void interleaved4(size_t n, const double *restrict a, const double *restrict b,
                         const double *restrict c, const double *restrict d, double *restrict rows)
{
    for (size_t i = 0; i < n; i++) {
        rows[4 * i] = a[i];
        rows[4 * i + 1] = b[i];
        rows[4 * i + 2] = c[i];
        rows[4 * i + 3] = d[i];
    }
}

/* Compute n states from the angles, in rows s apart: two on the steady branch, at most six on the
   others; `out` has room for seven. */
static void block_states(const torque_free_motion *motion, size_t n, size_t s, const double *restrict in,
                         double *restrict out, double *restrict q, double *restrict omega)
{
    const int *axis = motion->axis;
    double *row[7];
    if (motion->branch == 0) {
        steady_state(&motion->of.steady, n, in, in + s, out, out + s, out + 2 * s, out + 3 * s);
        for (size_t i = 0; i < n; i++)
            for (int k = 0; k < 3; k++)
                omega[3 * i + (size_t)k] = motion->omega0[k];
        interleaved4(n, out, out + s, out + 2 * s, out + 3 * s, q);
        return;
    }
    row[0] = out;
    for (size_t k = 0; k < 3; k++) {
        row[1 + axis[k]] = out + (1 + k) * s;
        row[4 + axis[k]] = out + (4 + k) * s;
    }
    if (motion->branch == 1)
        circular_state(&motion->of.circular, n, @circular rows of in@,
                       out, out + s, out + 2 * s, out + 3 * s, out + 4 * s, out + 5 * s, out + 6 * s);
    else
        hyperbolic_state(&motion->of.hyperbolic, n, @hyperbolic rows of in@,
                         out, out + s, out + 2 * s, out + 3 * s, out + 4 * s, out + 5 * s, out + 6 * s);
    interleaved4(n, row[0], row[1], row[2], row[3], q);
    interleaved(n, row[4], row[5], row[6], omega);
}

/* Write the angles at the inner times t + t_lo, in rows s apart. */
static void block_angles(const torque_free_motion *motion, size_t n, size_t s, const double *restrict t,
                         const double *restrict t_lo, double *restrict to)
{
    if (motion->branch == 0)
        steady_angles(&motion->of.steady, n, t, t_lo, to, to + s);
    else if (motion->branch == 1)
        circular_angles(&motion->of.circular, n, t, t_lo, @circular rows of to@);
    else
        hyperbolic_angles(&motion->of.hyperbolic, n, t, t_lo, @hyperbolic rows of to@);
}

/* Prefetch the cache lines that the next block of rows will be written to. */
static void fetch(const double *q, const double *omega)
{
#ifdef __GNUC__
    for (size_t i = 0; i < 4 * BLOCK; i += 8)
        __builtin_prefetch(q + i, 1);
    for (size_t i = 0; i < 3 * BLOCK; i += 8)
        __builtin_prefetch(omega + i, 1);
#else
    (void)q, (void)omega;
#endif
}

/* Write the exact initial state of a motion. */
static void at_initial_state(const torque_free_motion *motion, double *q, double *omega)
{
    for (int k = 0; k < 4; k++)
        q[k] = motion->q0[k];
    for (int k = 0; k < 3; k++)
        omega[k] = motion->omega0[k];
}

/* Return the code for times at which a motion has no states. */
static int refusal(const torque_free_motion *motion, size_t n, const double *t)
{
    if (!all_finite(n, t))
        return TORQUE_FREE_NOT_FINITE;
    return motion->blurred ? TORQUE_FREE_SEPARATRIX : TORQUE_FREE_TIME;
}

static void no_states(size_t n, double *q, double *omega)
{
    for (size_t i = 0; i < 4 * n; i++)
        q[i] = (double)NAN;
    for (size_t i = 0; i < 3 * n; i++)
        omega[i] = (double)NAN;
}

/* Write the states at n times; late times are refused, or have states of NaN where `lenient`. */
static int states_at(const torque_free_motion *motion, size_t n, const double *t, double *q, double *omega,
                     int lenient)
{
    double by_time[6 * BLOCK], out[7 * BLOCK], inner[BLOCK], rest[BLOCK];
    int zero;
    for (size_t i = 0; i < n && !lenient; i += BLOCK)
        if (!scaled_times(motion, n - i < BLOCK ? n - i : BLOCK, t + i, inner, &zero))
            return refusal(motion, n, t);
    for (size_t k = 0; k < BLOCK; k++)
        rest[k] = 0.0;
    int refused = 0;
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i < BLOCK ? n - i : BLOCK;
        const int near = scaled_times(motion, count, t + i, inner, &zero);
        for (size_t k = 0; !near && k < count; k++)
            inner[k] = fabs(inner[k]) <= motion->max_angle ? inner[k] : 0.0;
        if (n - i >= 2 * BLOCK)
            fetch(q + 4 * (i + BLOCK), omega + 3 * (i + BLOCK));
        block_angles(motion, count, BLOCK, inner, rest, by_time);
        block_states(motion, count, BLOCK, by_time, out, q + 4 * i, omega + 3 * i);
        for (size_t k = 0; zero && k < count; k++)
            if (!(t[i + k] < 0.0 || t[i + k] > 0.0))
                at_initial_state(motion, q + 4 * (i + k), omega + 3 * (i + k));
        for (size_t k = 0; !near && k < count; k++)
            if (!(fabs(motion->unit * t[i + k]) <= motion->max_angle))
                no_states(1, q + 4 * (i + k), omega + 3 * (i + k));
        refused |= !near;
    }
    return refused ? refusal(motion, n, t) : TORQUE_FREE_OK;
}

int torque_free_states_at(const torque_free_motion *motion, size_t n, const double *t, double *q,
                          double *omega)
{
    return motion->prepared == PREPARED ? states_at(motion, n, t, q, omega, 0) : TORQUE_FREE_UNPREPARED;
}

/* Write one state, which needs no block. */
int torque_free_state_at(const torque_free_motion *motion, double t, double q[4], double omega[3])
{
    const double rest = 0.0;
    double by_time[6], out[7], inner;
    int zero;
    if (motion->prepared != PREPARED)
        return TORQUE_FREE_UNPREPARED;
    if (!scaled_times(motion, 1, &t, &inner, &zero))
        return refusal(motion, 1, &t);
    if (zero) {
        at_initial_state(motion, q, omega);
        return TORQUE_FREE_OK;
    }
    block_angles(motion, 1, 1, &inner, &rest, by_time);
    block_states(motion, 1, 1, by_time, out, q, omega);
    return TORQUE_FREE_OK;
}

/* Sines and cosines of a + b. */
static void turned(size_t n, double sin_a, double cos_a, const double *restrict sin_b,
                   const double *restrict cos_b, double *restrict sine, double *restrict cosine)
{
    for (size_t i = 0; i < n; i++) {
        sine[i] = fused(sin_a, cos_b[i], cos_a * sin_b[i]);
        cosine[i] = fused(cos_a, cos_b[i], -(sin_a * sin_b[i]));
    }
}

/* Sines and cosines of both angles at the times k step, k = 0 ... BLOCK - 1, as from zero. */
static void grid_table(const torque_free_motion *motion, double step, double *restrict table)
{
    double t[BLOCK], t_lo[BLOCK];
    torque_free_motion from_zero = *motion;
    if (motion->branch == 1)
        from_zero.of.circular.v_hi = from_zero.of.circular.v_lo = 0.0;
    for (size_t k = 0; k < BLOCK; k++) {
        const double_double time = two_product((double)k, step);
        t[k] = time.hi;
        t_lo[k] = time.lo;
    }
    block_angles(&from_zero, BLOCK, BLOCK, t, t_lo, table);
}

/* Write the angles at n times, each `every`-th of the grid from number `first` on. */
static void grid_angles(const torque_free_motion *motion, double start, double step, size_t first,
                        size_t every, size_t n, double *restrict by_time)
{
    double t[BLOCK], t_lo[BLOCK];
    for (size_t i = 0; i < n; i++) {
        const double_double time = dd_add_xd(two_product((double)(first + i * every), step), start);
        t[i] = time.hi;
        t_lo[i] = time.lo;
    }
    block_angles(motion, n, BLOCK, t, t_lo, by_time);
}

/* Write n <= BLOCK^2 states from number `first` on: angles are evaluated once in a block, and turned. */
static void grid_states(const torque_free_motion *motion, double start, double step, size_t first, size_t n,
                        const double *restrict table, double *restrict q, double *restrict omega)
{
    double base[6 * BLOCK], by_time[4 * BLOCK], out[7 * BLOCK];
    const size_t rows = motion->branch == 0 ? 2 : 4;
    grid_angles(motion, start, step, first, BLOCK, (n + BLOCK - 1) / BLOCK, base);
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i < BLOCK ? n - i : BLOCK, k = i / BLOCK;
        if (n - i >= 2 * BLOCK)
            fetch(q + 4 * (i + BLOCK), omega + 3 * (i + BLOCK));
        for (size_t s = 0; s < rows * BLOCK; s += 2 * BLOCK)
            turned(count, base[s + k], base[s + BLOCK + k], table + s, table + s + BLOCK, by_time + s,
                   by_time + s + BLOCK);
        block_states(motion, count, BLOCK, by_time, out, q + 4 * i, omega + 3 * i);
    }
}

/* Write the states of a grid where angles are more than sines and cosines. */
static void grid_states_one_by_one(const torque_free_motion *motion, double start, double step, size_t first,
                                   size_t n, double *restrict q, double *restrict omega)
{
    double by_time[6 * BLOCK], out[7 * BLOCK];
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i < BLOCK ? n - i : BLOCK;
        if (n - i >= 2 * BLOCK)
            fetch(q + 4 * (i + BLOCK), omega + 3 * (i + BLOCK));
        grid_angles(motion, start, step, first + i, 1, count, by_time);
        block_states(motion, count, BLOCK, by_time, out, q + 4 * i, omega + 3 * i);
    }
}

/* Return the index of the first of n samples, from number `first` on, that is at t = 0; n if there is none. */
static size_t grid_zero(double start, double step, size_t first, size_t n)
{
    const int stands = is_zero(dd_of(step));
    const double k = stands ? (double)first : nearest(-start / step);
    const double_double t = dd_add_xd(two_product(k, step), start);
    const double place = k - (double)first;
    return place >= 0.0 && place < (double)n && fabs(t.hi) <= 0.0 ? (size_t)place : n;
}

int torque_free_states_on_grid(const torque_free_motion *motion, double start, double step, size_t first,
                               size_t n, double *q, double *omega)
{
    double table[6 * BLOCK];
    /* Sample number 0 does not depend on the step, however large. */
    const double inner = motion->unit * start, inner_step = first + n > 1 ? motion->unit * step : 0.0;
    const double begin = inner + inner_step * (double)first;
    const double last = inner + inner_step * (double)(n > 0 ? first + n - 1 : first);
    const double given[2] = {start, first + n > 1 ? step : 0.0};
    const size_t most = BLOCK * BLOCK;
    if (motion->prepared != PREPARED)
        return TORQUE_FREE_UNPREPARED;
    if (!(fabs(inner) <= motion->max_angle && fabs(begin) <= motion->max_angle && fabs(last) <= motion->max_angle))
        return refusal(motion, 2, given);
    if (motion->branch >= @one by one@) {
        grid_states_one_by_one(motion, inner, inner_step, first, n, q, omega);
    } else {
        grid_table(motion, inner_step, table);
        for (size_t i = 0; i < n; i += most)
            grid_states(motion, inner, inner_step, first + i, n - i < most ? n - i : most, table, q + 4 * i,
                        omega + 3 * i);
    }
    for (size_t i = grid_zero(start, step, first, n); i < n; i += is_zero(dd_of(step)) ? 1 : n)
        at_initial_state(motion, q + 4 * i, omega + 3 * i);
    return TORQUE_FREE_OK;
}

/* Prepare the motions of at most as many bodies as there are lanes, with codes; return how many. */
static size_t several_init(torque_free_motion motion[LANES], int code[LANES], lanes *lane, int rounded, size_t bodies,
                           const double *inertia, const double *omega0, const double *attitude0)
{
    const size_t count = bodies < LANES ? bodies : LANES;
    for (size_t i = 0; i < count; i++) {
        code[i] = begin_doubles(&motion[i], lane, i, inertia + 3 * i, omega0 + 3 * i, attitude0 + 4 * i);
        if (code[i] == TORQUE_FREE_OK && !rounded)
            code[i] = TORQUE_FREE_ARITHMETIC;
    }
    moving_init(lane, count, motion, code);
    return count;
}

/* Write the states of one of many bodies; late times have states of NaN where `lenient`. */
static int states_of(const torque_free_motion *motion, size_t n, const double *t, double *q, double *omega,
                     int lenient)
{
    if (n != 1)
        return states_at(motion, n, t, q, omega, lenient);
    const int code = torque_free_state_at(motion, *t, q, omega);
    if (code != TORQUE_FREE_OK && lenient)
        no_states(1, q, omega);
    return code;
}

int torque_free_propagate(size_t bodies, const double *inertia, const double *omega0,
                          const double *attitude0, size_t n, const double *t, size_t stride,
                          double *q, double *omega, int *codes, size_t *failed)
{
    torque_free_motion motion[LANES];
    int code[LANES];
    lanes lane;
    memset(&lane, 0, sizeof lane);
    const int rounded = is_rounded_once();
    for (size_t first = 0; first < bodies; first += LANES) {
        const size_t count = several_init(motion, code, &lane, rounded, bodies - first, inertia + 3 * first,
                                          omega0 + 3 * first, attitude0 + 4 * first);
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            double *q_k = q + 4 * n * k, *omega_k = omega + 3 * n * k;
            if (code[i] == TORQUE_FREE_OK)
                code[i] = states_of(&motion[i], n, t + stride * k, q_k, omega_k, codes != NULL);
            else if (codes)
                no_states(n, q_k, omega_k);
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

double torque_free_last_time(const torque_free_motion *motion)
{
    if (motion->prepared != PREPARED)
        return (double)NAN;
    return motion->unit > 0.0 ? fmin(motion->max_angle / motion->unit, DBL_MAX) : DBL_MAX;
}

size_t torque_free_motion_size(void) { return sizeof(torque_free_motion); }

const char *torque_free_digest(void) { return "@digest@"; }

const char *torque_free_message(int code)
{
    switch (code) {
@messages@
    default: return "@unknown@";
    }
}

const char *torque_free_field(int code)
{
    switch (code) {
@fields@
    default: return "";
    }
}

const char *torque_free_rule(int code)
{
    switch (code) {
@rules@
    default: return "@unknown@";
    }
}
