/* Return 1 where quotients and roots have all their digits: y (x/y) is not x, nor a root's square its
   radicand.  Compilers that assume so are wrong in one quotient of five, some of which are here. */
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
