/* Tests of the arithmetic of this very build, which the compiler's options can spoil: a `volatile` zero is
   in all numbers, so that no compiler can compute the outcome. */

static int is_double_double(double_double x, double hi, double lo)
{
    return fabs(x.hi - hi) <= 0.0 && fabs(x.lo - lo) <= 1e-30;
}

/* Return 1 where the compiler itself fuses no product with a sum, or where the bits were not chosen. */
static int bits_hold(void)
{
    const volatile double zero = 0.0;
    const double more = zero + 1.000000000931322574615478515625, less = zero + 0.999999999068677425384521484375;
    return !BITS_ARE_CHOSEN || fabs(more * less - (zero + 1.0)) <= 0.0;
}

/* Return 1 where sums and products are rounded once, to nearest, and no low part is lost. */
static int sums_hold(void)
{
    const volatile double zero = 0.0;
    const double one = zero + 1.0, many = zero + 49.0, part = zero + 0.02040816326530612;
    const double tiny = zero + 8.673617379884035e-19;
    const double_double third = {one * over_3.hi, one * over_3.lo}, seventh = {one * over_7.hi, one * over_7.lo};
    return bits_hold() && is_double_double(two_sum(one, tiny), 1.0, 8.673617379884035e-19) &&
           is_double_double(two_sum(-tiny, one), 1.0, -8.673617379884035e-19) &&
           is_double_double(two_product(part, many), 0.9999999999999999, 3.122502256758253e-17) &&
           is_double_double(dd_mul_xx(third, third), over_9.hi, over_9.lo) &&
           is_double_double(dd_mul_xx(third, dd_mul_dx(one, over_5)), over_15.hi, over_15.lo) &&
           is_double_double(dd_mul_xd(seventh, many), 7.0, 0.0);
}
