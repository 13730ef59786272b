/* Return 1 for moments that a body can have, up to rounding: the largest is at most the sum of the
   others, or that sum as a double, or beyond it by 2^-50 of the smallest. */
static int can_exist(const double_double c[3])
{
#ifdef ALLOW_NONPHYSICAL
    (void)c;
    return 1;
#else
    int high = 0;
    for (int k = 1; k < 3; k++)
        if (c[k].hi > c[high].hi || (c[k].hi >= c[high].hi && c[k].lo > c[high].lo))
            high = k;
    const double_double one = c[(high + 1) % 3], other = c[(high + 2) % 3], total = dd_add_xx(one, other);
    const double_double beyond = two_sum(c[high].hi - total.hi, c[high].lo - total.lo);
    const double allowed = 8.881784197001252e-16 * (one.hi < other.hi ? one.hi : other.hi);
    return c[high].hi < total.hi || (c[high].hi <= total.hi && c[high].lo <= 0.0) || beyond.hi < allowed ||
           (beyond.hi <= allowed && beyond.lo <= 0.0);
#endif
}
