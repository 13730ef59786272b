static const double_double over_3 = {0.3333333333333333, 1.850371707708594e-17};
static const double_double over_5 = {0.2, -1.1102230246251566e-17};
static const double_double over_7 = {0.14285714285714285, 7.93016446160826e-18};
static const double_double over_9 = {0.1111111111111111, 6.1679056923619804e-18};
static const double_double over_15 = {0.06666666666666667, 9.251858538542971e-19};

@rounding.c@

@quotients.c@

/* Return 1 where the constants of a body, and a doubling, have all their digits: clang's
   -ffp-contract=fast fuses sums with products across functions, so that low parts are counted twice. */
static int lanes_hold(void)
{
    static const double given[] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596,
                                   0.15335179025447007};
    const volatile double zero = 0.0;
    double inertia[3];
    int axis[3];
    lanes x;
    for (int k = 0; k < 3; k++)
        inertia[k] = zero + given[k];
    if (set_body(&x, 0, inertia, axis) != TORQUE_FREE_STEP_OK)
        return 0;
    x.X_hi[0] = inertia[0], x.Y_hi[0] = inertia[1], x.e_1_hi[0] = inertia[2], x.e_2_hi[0] = zero + given[3];
    x.X_lo[0] = x.Y_lo[0] = x.e_1_lo[0] = x.e_2_lo[0] = zero;
    step_body(1, &x);
    step_doubled(1, &x);
    const double_double l_a = {x.l_a_hi[0], x.l_a_lo[0]}, l_b = {x.l_b_hi[0], x.l_b_lo[0]};
    const double_double X = {x.X_next_hi[0], x.X_next_lo[0]}, Y = {x.Y_next_hi[0], x.Y_next_lo[0]};
    return is_double_double(l_a, 0.5265630116004512, 2.0259269896901686e-17) && is_double_double(l_b, 0.11906636935098612, 4.186140756463748e-18) && is_double_double(X, 0.7309683706206017, -5.138891903440856e-18) &&
           is_double_double(Y, 0.9450906240536523, 1.3279045143746525e-17);
}

static int is_rounded_once(void) { return sums_hold() && quotients_hold() && lanes_hold(); }
