@rounding.c@

/* Return 1 where a difference of products has all its digits: clang's -ffp-contract=fast fuses sums
   with products across functions, so that low parts are counted twice. */
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

@quotients.c@

/* Return 1 where the loop over times loses no turns: at t = 2^45 - 3 + i both angles, (t + 1)/3 and t/3 half
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
