"""Tests of compiled arithmetic in functions of steps, before steps are computed."""

lane_cases: double[4] = [
    0.7260104308260092,
    0.48196654854338067,
    0.3559016780679596,
    0.15335179025447007,
]
"three moments, which also serve as elapsed functions, and a constant"


def lanes_hold() -> bool:
    """Return True where the constants of a body, and a doubling, have all their digits.

    clang's -ffp-contract=fast fuses sums with products across functions, so that low parts are
    counted twice.
    """
    zero: double = hidden(0.0)
    inertia: double[3]
    axis: int[3]
    x: lanes
    for k in range(3):
        inertia[k] = zero + lane_cases[k]
    if set_body(x, 0, inertia, axis) != OK:
        return False
    x.X_hi[0] = inertia[0]
    x.Y_hi[0] = inertia[1]
    x.e_1_hi[0] = inertia[2]
    x.e_2_hi[0] = zero + lane_cases[3]
    x.X_lo[0] = zero
    x.Y_lo[0] = zero
    x.e_1_lo[0] = zero
    x.e_2_lo[0] = zero
    step_body(1, x)
    step_doubled(1, x)
    l_a: pair = pair(x.l_a_hi[0], x.l_a_lo[0])
    l_b: pair = pair(x.l_b_hi[0], x.l_b_lo[0])
    X: pair = pair(x.X_next_hi[0], x.X_next_lo[0])
    Y: pair = pair(x.Y_next_hi[0], x.Y_next_lo[0])
    return (
        is_double_double(l_a, 0.5265630116004512, 2.0259269896901686e-17)
        and is_double_double(l_b, 0.11906636935098612, 4.186140756463748e-18)
        and is_double_double(X, 0.7309683706206017, -5.138891903440856e-18)
        and is_double_double(Y, 0.9450906240536523, 1.3279045143746525e-17)
    )


def is_rounded_once() -> bool:
    """Return True where this build's arithmetic passes all tests."""
    return sums_hold() and quotients_hold() and lanes_hold()
