/* What options of the compiler take away, asked of this very build: a `volatile` zero is in all numbers,
   so that no compiler knows the outcome. */

static int is_double_double(double_double x, double hi, double lo)
{
    return fabs(x.hi - hi) <= 0.0 && fabs(x.lo - lo) <= 1e-30;
}

/* Whether sums and products are rounded once, to nearest, and nothing of them is lost. */
static int sums_hold(void)
{
    const volatile double zero = 0.0;
    const double one = zero + 1.0, many = zero + 49.0, part = zero + 0.02040816326530612;
    const double tiny = zero + 8.673617379884035e-19;
    const double_double third = {one * over_3.hi, one * over_3.lo}, seventh = {one * over_7.hi, one * over_7.lo};
    return is_double_double(two_sum(one, tiny), 1.0, 8.673617379884035e-19) &&
           is_double_double(two_sum(-tiny, one), 1.0, -8.673617379884035e-19) &&
           is_double_double(two_product(part, many), 0.9999999999999999, 3.122502256758253e-17) &&
           is_double_double(dd_mul_xx(third, third), over_9.hi, over_9.lo) &&
           is_double_double(dd_mul_xx(third, dd_mul_dx(one, over_5)), over_15.hi, over_15.lo) &&
           is_double_double(dd_mul_xd(seventh, many), 7.0, 0.0);
}

/* Whether a difference of products has all its digits: clang's -ffp-contract=fast fuses sums with
   products across functions, and what was split off is counted twice. */
static int differences_hold(void)
{
    static const double given[] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596,
                                   0.15335179025447007, 0.03588181116623288};
    const volatile double zero = 0.0;
    double_double x[5];
    for (int k = 0; k < 5; k++)
        x[k] = dd_of(zero + given[k]);
    const double_double above = dd_add_xx(x[0], dd_neg(x[1])), below = dd_add_xx(x[1], dd_neg(x[2]));
    return is_double_double(discriminant_dd(x[0], x[2], above, below, x[3], x[4]), 0.004108897986419382,
                   -6.277847770376781e-21);
}

/* Whether quotients and roots have all their digits: y (x/y) is not x, nor a root's square its
   radicand.  Compilers that think so are wrong about one quotient in five, some of which are here. */
static int quotients_hold(void)
{
    static const double quotients[][4] = {
        {7.0, 3.0, 2.3333333333333335, -1.4802973661668753e-16},
        {3.0, 5.0, 0.6, 2.2204460492503132e-17},
        {7.0, 25.0, 0.28, -2.6645352591003756e-17},
        {15.0, 13.0, 1.1538461538461537, 1.0248212535001446e-16},
        {15.0, 22.0, 0.6818181818181818, 5.0464682937507114e-17},
        {13.0, 23.0, 0.5652173913043478, 4.344350965924526e-17}};
    const volatile double zero = 0.0;
    const double_double root = dd_sqrt(dd_of(zero + 2.0));
    int holds = is_double_double(root, 1.4142135623730951, -9.667293313452913e-17);
    for (size_t k = 0; k < sizeof quotients / sizeof *quotients; k++) {
        const double *known = quotients[k], x = zero + known[0], y = zero + known[1];
        holds &= is_double_double(dd_div_xd(dd_of(x), y), known[2], known[3]);
        holds &= is_double_double(dd_div_dx(x, dd_of(y)), known[2], known[3]);
    }
    return holds;
}

/* Whether the loop over times loses no turns: at t = 2^45 - 3 + i both angles, (t + 1)/3 and t/3 half
   turns, are multiples of sixty degrees, and their whole turns and all low parts count. */
static int angles_hold(void)
{
    static const double cosines[] = {1.0, 0.5, -0.5, -1.0, -0.5, 0.5};
    enum { TIMES = 8 };
    const volatile double from = 35184372088829.0;
    enum { COSINE = TIMES, TURNED = 3 * TIMES };
    const size_t s = TIMES;
    double t[TIMES], t_lo[TIMES], to[6 * TIMES];
    torque_free_circular motion;
    int holds = 1;
    memset(&motion, 0, sizeof motion);
    motion.v_rate_hi = motion.Lambda_rate_hi = motion.v_hi = over_3.hi;
    motion.v_rate_lo = motion.Lambda_rate_lo = motion.v_lo = over_3.lo;
    for (int i = 0; i < TIMES; i++) {
        t[i] = from + (double)i;
        t_lo[i] = 0.0;
    }
    circular_angles(&motion, TIMES, t, t_lo, @circular rows of to@);
    for (int i = 0; i < TIMES; i++) {
        holds &= fabs(to[COSINE + i] - cosines[i % 6]) <= 1e-15;
        holds &= fabs(to[TURNED + i] - cosines[(i + 5) % 6]) <= 1e-15;
    }
    return holds;
}

static int is_rounded_once(void)
{
    return sums_hold() && differences_hold() && quotients_hold() && angles_hold();
}
