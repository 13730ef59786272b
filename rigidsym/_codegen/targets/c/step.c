/* Return the exponent to scale by, 0 from 2^-40 to 2^40: there the highest powers of rates, the 22nd, do
   not overflow. */
static double scale(double largest)
{
    int exponent;
    if (largest >= 9.094947017729282e-13 && largest <= 1099511627776.0)
        return 0.0;
    frexp(largest, &exponent);
    return (double)exponent;
}

static double largest_of(const double x[3]) { return fmax(fabs(x[0]), fmax(fabs(x[1]), fabs(x[2]))); }

/* The mark of a prepared body: a number that memory hardly has by chance. */
enum { PREPARED = 0x7f4a7c15 };

@bodies.c@

/* Check moments and write them to lane i, the largest first; return a code. */
static int set_body(lanes *x, size_t i, const double *inertia, int axis[3])
{
    const double largest = largest_of(inertia), least = fmin(inertia[0], fmin(inertia[1], inertia[2]));
    if (!(inertia[0] > 0.0 && inertia[1] > 0.0 && inertia[2] > 0.0))
        return isnan(inertia[0] + inertia[1] + inertia[2]) ? TORQUE_FREE_STEP_NOT_FINITE : TORQUE_FREE_STEP_INERTIA;
    if (!(largest <= DBL_MAX))
        return TORQUE_FREE_STEP_NOT_FINITE;
    const int exponent = -(int)scale(largest);
    const double_double c[3] = {dd_of(ldexp(inertia[0], exponent)), dd_of(ldexp(inertia[1], exponent)),
                                dd_of(ldexp(inertia[2], exponent))};
    if (!can_exist(c))
        return TORQUE_FREE_STEP_NONPHYSICAL;
    if (least / largest < min_moment_ratio)
        return TORQUE_FREE_STEP_THIN;
    const int first = inertia[0] >= inertia[1] ? (inertia[0] >= inertia[2] ? 0 : 2) : (inertia[1] >= inertia[2] ? 1 : 2);
    const int one = (first + 1) % 3, other = (first + 2) % 3, turned = inertia[one] < inertia[other];
    axis[0] = first;
    axis[1] = turned ? other : one;
    axis[2] = turned ? one : other;
    const double c_a = c[axis[0]].hi, c_b = c[axis[1]].hi, c_d = c[axis[2]].hi;
    const double_double ab = two_sum(c_a, -c_b), ad = two_sum(c_a, -c_d), bd = two_sum(c_b, -c_d);
    x->c_a_hi[i] = c_a, x->c_a_lo[i] = 0.0, x->c_b_hi[i] = c_b, x->c_b_lo[i] = 0.0;
    x->c_d_hi[i] = c_d, x->c_d_lo[i] = 0.0, x->c_ab_hi[i] = ab.hi, x->c_ab_lo[i] = ab.lo;
    x->c_ad_hi[i] = ad.hi, x->c_ad_lo[i] = ad.lo, x->c_bd_hi[i] = bd.hi, x->c_bd_lo[i] = bd.lo;
    x->epsilon[i] = turned ? -1.0 : 1.0;
    return TORQUE_FREE_STEP_OK;
}

static void get_body(const lanes *x, torque_free_body *body)
{
    const double moments[] = {x->c_a_hi[0], x->c_b_hi[0], x->c_d_hi[0]};
    const double alphas[] = {x->alpha_a_hi[0], x->alpha_a_lo[0], x->alpha_b_hi[0],
                             x->alpha_b_lo[0], x->alpha_d_hi[0], x->alpha_d_lo[0]};
    const double squares[] = {x->l_a_hi[0], x->l_a_lo[0], x->l_b_hi[0], x->l_b_lo[0], x->l_d_hi[0], x->l_d_lo[0]};
    memcpy(body->moments, moments, sizeof moments);
    memcpy(body->alphas, alphas, sizeof alphas);
    memcpy(body->squares, squares, sizeof squares);
    body->epsilon = x->epsilon[0];
}

static void put_body(lanes *x, size_t i, const torque_free_body *body)
{
    const double *alphas = body->alphas, *squares = body->squares;
    x->c_a_hi[i] = body->moments[0], x->c_b_hi[i] = body->moments[1], x->c_d_hi[i] = body->moments[2];
    x->c_a_lo[i] = x->c_b_lo[i] = x->c_d_lo[i] = 0.0;
    x->alpha_a_hi[i] = alphas[0], x->alpha_a_lo[i] = alphas[1], x->alpha_b_hi[i] = alphas[2];
    x->alpha_b_lo[i] = alphas[3], x->alpha_d_hi[i] = alphas[4], x->alpha_d_lo[i] = alphas[5];
    x->l_a_hi[i] = squares[0], x->l_a_lo[i] = squares[1], x->l_b_hi[i] = squares[2];
    x->l_b_lo[i] = squares[3], x->l_d_hi[i] = squares[4], x->l_d_lo[i] = squares[5];
    x->epsilon[i] = body->epsilon;
}

/* The given state of a lane, the exponent that scales its rates, and 1 where nothing turns. */
typedef struct {
    int axis[3], exponent, still;
    double q[4], omega[3];
} scaling;

static int set_state(lanes *x, size_t i, const int axis[3], const double *q, const double *omega, double dt,
                     scaling *of)
{
    const double largest = largest_of(omega), size = fmax(fabs(q[0]), largest_of(q + 1));
    double sum = dt;
    for (int k = 0; k < 3; k++)
        sum += 0.0 * omega[k] + 0.0 * q[1 + k];
    if (!(fabs(sum + 0.0 * q[0]) <= DBL_MAX))
        return TORQUE_FREE_STEP_NOT_FINITE;
    if (!(size > 0.0))
        return TORQUE_FREE_STEP_ATTITUDE;
    of->still = !(largest > 0.0 && fabs(dt) > 0.0);
    of->exponent = largest > 0.0 ? (int)scale(largest) : 0;
    memcpy(of->axis, axis, sizeof of->axis);
    double rates[3], attitude[4];
    for (int k = 0; k < 3; k++)
        rates[k] = of->exponent ? ldexp(omega[axis[k]], -of->exponent) : omega[axis[k]];
    const int less = -(int)scale(size);
    attitude[0] = less ? ldexp(q[0], less) : q[0];
    for (int k = 0; k < 3; k++)
        attitude[1 + k] = less ? ldexp(q[1 + axis[k]], less) : q[1 + axis[k]];
    x->t[i] = of->exponent ? ldexp(dt, of->exponent) : dt;
    if (of->still)
        x->t[i] = 0.0;
    if (!(largest > 0.0))
        rates[0] = 1.0;
    memcpy(of->omega, omega, sizeof of->omega);
    of->q[0] = attitude[0];
    for (int k = 0; k < 3; k++)
        of->q[1 + axis[k]] = attitude[1 + k];
    x->Omega_a0_hi[i] = rates[0], x->Omega_b0_hi[i] = rates[1], x->Omega_d0_hi[i] = rates[2];
    x->Omega_a0_lo[i] = x->Omega_b0_lo[i] = x->Omega_d0_lo[i] = 0.0;
    x->q_0[i] = attitude[0], x->q_a[i] = attitude[1], x->q_b[i] = attitude[2], x->q_d[i] = attitude[3];
    const double squared = rates[0] * rates[0] + rates[1] * rates[1] + rates[2] * rates[2];
    return sqrt(squared) * fabs(x->t[i]) <= max_step ? TORQUE_FREE_STEP_OK : TORQUE_FREE_STEP_ANGLE;
}

#define SWAP_IF(turned, one, other)                                                                       \
    do {                                                                                                  \
        const double first = (one), second = (other);                                                     \
        (one) = (turned) ? second : first;                                                                \
        (other) = (turned) ? first : second;                                                              \
    } while (0)

/* Choose the axis a: that of largest moment, or of smallest where K^2 < 2 H c_b. */
static void circulating(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double over = x->l_a_hi[i] * x->Omega_a0_hi[i] * x->Omega_a0_hi[i];
        const double under = x->l_d_hi[i] * x->Omega_d0_hi[i] * x->Omega_d0_hi[i];
        const int turned = over < under;
        const double sign = turned ? -1.0 : 1.0;
        SWAP_IF(turned, x->Omega_a0_hi[i], x->Omega_d0_hi[i]);
        SWAP_IF(turned, x->c_a_hi[i], x->c_d_hi[i]);
        SWAP_IF(turned, x->alpha_a_hi[i], x->alpha_d_hi[i]);
        SWAP_IF(turned, x->alpha_a_lo[i], x->alpha_d_lo[i]);
        SWAP_IF(turned, x->l_a_hi[i], x->l_d_hi[i]);
        SWAP_IF(turned, x->l_a_lo[i], x->l_d_lo[i]);
        SWAP_IF(turned, x->q_a[i], x->q_d[i]);
        x->epsilon[i] *= sign;
        x->turned[i] = sign;
        x->sigma[i] = x->Omega_a0_hi[i] < 0.0 ? -1.0 : 1.0;
    }
}

/* Replace X, Y and W by their values at twice the time. */
static void advance(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        x->X_hi[i] = x->X_next_hi[i];
        x->X_lo[i] = x->X_next_lo[i];
        x->Y_hi[i] = x->Y_next_hi[i];
        x->Y_lo[i] = x->Y_next_lo[i];
        x->W_re[i] = x->W_next_re[i];
        x->W_im[i] = x->W_next_im[i];
    }
}

/* x over the root of a square, with little more error than one rounding. */
static INLINED double divided(double x, double over, double more)
{
    const double y = x * over;
    return y + (product_error(x, over, y) + x * more);
}

/* Normalise a quaternion. */
static INLINED void divide(double *q_0, double *q_a, double *q_b, double *q_d)
{
    const double_double first = dd_add_xx(two_product(*q_0, *q_0), two_product(*q_a, *q_a));
    const double_double square = dd_add_xx(first, dd_add_xx(two_product(*q_b, *q_b), two_product(*q_d, *q_d)));
    const double over = 1.0 / sqrt(square.hi);
    const double_double rest = dd_sub_dx(1.0, dd_mul_xx(square, two_product(over, over)));
    const double more = over * (rest.hi + rest.lo) / 2.0;
    *q_0 = divided(*q_0, over, more);
    *q_a = divided(*q_a, over, more);
    *q_b = divided(*q_b, over, more);
    *q_d = divided(*q_d, over, more);
}

static void normalised(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++)
        divide(&x->q_0[i], &x->q_a[i], &x->q_b[i], &x->q_d[i]);
}

/* x rounded up or down, to the nearer double more often: chance is between -1/2 and 1/2. */
static INLINED double dithered(double hi, double lo, double chance)
{
    const double size = fabs(hi), next = size + size * 1.1102230246251568e-16;
    return hi + (lo + chance * (next - size));
}

/* Round rates up or down at random, by the attitude's last digits: rounded to nearest, a slow motion's
   rates would err one way for long. */
static void rounded(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const uint64_t one = bits_of(x->q_0[i]), two = bits_of(x->q_a[i]), three = bits_of(x->q_b[i]);
        uint64_t mixed = (one ^ (two << 21 | two >> 43) ^ (three << 42 | three >> 22)) * UINT64_C(0x9e3779b97f4a7c15);
        mixed = (mixed ^ mixed >> 32) * UINT64_C(0xd6e8feb86659fd93);
        mixed ^= mixed >> 32;
        const double a = from_bits(UINT64_C(0x3ff0000000000000) | mixed >> 44 << 32) - 1.5;
        const double b = from_bits(UINT64_C(0x3ff0000000000000) | mixed << 20 >> 44 << 32) - 1.5;
        const double d = from_bits(UINT64_C(0x3ff0000000000000) | mixed << 40 >> 44 << 32) - 1.5;
        x->Omega_a_hi[i] = dithered(x->Omega_a_hi[i], x->Omega_a_lo[i], a);
        x->Omega_b_hi[i] = dithered(x->Omega_b_hi[i], x->Omega_b_lo[i], b);
        x->Omega_d_hi[i] = dithered(x->Omega_d_hi[i], x->Omega_d_lo[i], d);
    }
}

static void move(size_t n, lanes *x)
{
    circulating(n, x);
    step_start(n, x);
    step_first(n, x);
    for (int k = 0; k < @steps@; k++) {
        if (k < @steps@ - @last@) {
            step_projected(n, x);
            step_second_half(n, x);
        } else {
            step_last_projected(n, x);
            step_last_second_half(n, x);
        }
        step_doubled(n, x);
        advance(n, x);
    }
    step_rates(n, x);
    step_shortest_before(n, x);
    step_front(n, x);
    step_shortest(n, x);
    step_attitude(n, x);
    normalised(n, x);
    rounded(n, x);
}

/* Return 1 where the state is finite: nonphysical bodies can turn much faster than at the start. */
static int is_held(const lanes *x, size_t i)
{
    const double sum = x->q_0[i] + x->q_a[i] + x->q_b[i] + x->q_d[i];
    return fabs(sum + x->Omega_a_hi[i] + x->Omega_b_hi[i] + x->Omega_d_hi[i]) <= DBL_MAX;
}

static void get_state(const lanes *x, size_t i, const scaling *of, double *q, double *omega)
{
    if (of->still) {
        memcpy(q, of->q, sizeof of->q);
        divide(q, q + 1, q + 2, q + 3);
        memcpy(omega, of->omega, sizeof of->omega);
        return;
    }
    const int a = x->turned[i] < 0.0 ? 2 : 0, d = 2 - a;
    const double rates[3] = {x->Omega_a_hi[i], x->Omega_b_hi[i], x->Omega_d_hi[i]};
    const double parts[3] = {x->q_a[i], x->q_b[i], x->q_d[i]};
    const int axis[3] = {of->axis[a], of->axis[1], of->axis[d]};
    q[0] = x->q_0[i];
    for (int k = 0; k < 3; k++) {
        q[1 + axis[k]] = parts[k];
        omega[axis[k]] = of->exponent ? ldexp(rates[k], of->exponent) : rates[k];
    }
}

@step_arithmetic.c@

/* Compute the constants of a body, without testing the arithmetic of this build. */
static int body_init(torque_free_body *body, const double inertia[3])
{
    lanes x;
    int axis[3];
    const int code = set_body(&x, 0, inertia, axis);
    if (code != TORQUE_FREE_STEP_OK)
        return code;
    step_body(1, &x);
    get_body(&x, body);
    memcpy(body->axis, axis, sizeof axis);
    body->prepared = PREPARED;
    return TORQUE_FREE_STEP_OK;
}

int torque_free_body_init(torque_free_body *body, const double inertia[3])
{
    torque_free_body made;
    const int code = body_init(&made, inertia);
    if (code != TORQUE_FREE_STEP_OK)
        return code;
    if (!is_rounded_once())
        return TORQUE_FREE_STEP_ARITHMETIC;
    *body = made;
    return TORQUE_FREE_STEP_OK;
}

int torque_free_step(const torque_free_body *body, double q[4], double omega[3], double dt)
{
    lanes x;
    scaling of;
    if (body->prepared != PREPARED)
        return TORQUE_FREE_STEP_UNPREPARED;
    const int code = set_state(&x, 0, body->axis, q, omega, dt, &of);
    if (code != TORQUE_FREE_STEP_OK)
        return code;
    put_body(&x, 0, body);
    move(1, &x);
    if (!is_held(&x, 0))
        return TORQUE_FREE_STEP_ANGLE;
    get_state(&x, 0, &of, q, omega);
    return TORQUE_FREE_STEP_OK;
}

int torque_free_steps(size_t n, const double *inertia, size_t inertia_stride, const double *q,
                      const double *omega, const double *dt, size_t dt_stride, double *q_after,
                      double *omega_after, size_t *failed)
{
    torque_free_body body;
    lanes x;
    scaling of[LANES];
    int axis[LANES][3], code;
    *failed = 0;
    if (n && inertia_stride && !is_rounded_once())
        return TORQUE_FREE_STEP_ARITHMETIC;
    if (n && !inertia_stride && (code = torque_free_body_init(&body, inertia)) != TORQUE_FREE_STEP_OK)
        return code;
    for (size_t begin = 0; begin < n; begin += LANES) {
        const size_t count = n - begin < LANES ? n - begin : LANES;
        for (size_t i = 0; i < LANES; i++) {
            /* Lanes beyond the last body repeat it. */
            const size_t k = begin + (i < count ? i : count - 1);
            code = TORQUE_FREE_STEP_OK;
            if (inertia_stride)
                code = set_body(&x, i, inertia + k * inertia_stride, axis[i]);
            else
                put_body(&x, i, &body);
            const int *order = inertia_stride ? axis[i] : body.axis;
            if (code == TORQUE_FREE_STEP_OK)
                code = set_state(&x, i, order, q + 4 * k, omega + 3 * k, dt[k * dt_stride], &of[i]);
            if (code != TORQUE_FREE_STEP_OK) {
                *failed = k;
                return code;
            }
        }
        if (inertia_stride)
            step_body(LANES, &x);
        move(LANES, &x);
        for (size_t i = 0; i < count; i++) {
            if (!is_held(&x, i)) {
                *failed = begin + i;
                return TORQUE_FREE_STEP_ANGLE;
            }
            get_state(&x, i, &of[i], q_after + 4 * (begin + i), omega_after + 3 * (begin + i));
        }
    }
    return TORQUE_FREE_STEP_OK;
}

size_t torque_free_body_size(void) { return sizeof(torque_free_body); }

const char *torque_free_step_digest(void) { return "@digest@"; }

const char *torque_free_step_message(int code)
{
    switch (code) {
@messages@
    default: return "@unknown@";
    }
}

const char *torque_free_step_field(int code)
{
    switch (code) {
@fields@
    default: return "";
    }
}

const char *torque_free_step_rule(int code)
{
    switch (code) {
@rules@
    default: return "@unknown@";
    }
}
