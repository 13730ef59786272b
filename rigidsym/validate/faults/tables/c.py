"""Faults of torque_free.c; those of the kernels, frame and exact arithmetic that only C has too."""

from functools import partial

from rigidsym.validate.faults.fault import Fault

_fault = partial(Fault, "c")
_NUMBERS = "static const double_double pi = {"
_LADDER = "static void ladder("
_CIRCULAR_PLAN = "static FLAT void circular_constants("
_CIRCULAR_STATE = "static void circular_state("
_HYPERBOLIC_PLAN = "static FLAT void hyperbolic_constants("
_HYPERBOLIC_ANGLES = "static void hyperbolic_angles("
_HYPERBOLIC_STATE = "static void hyperbolic_state("
_STEADY_PLAN = "static void steady_constants("
_STEADY_STATE = "static void steady_state("
_DISCRIMINANT = "static double_double discriminant_of("
_MOVING = "static void moving_init("
_START = "static FLAT void initial_state("
_CIRCULATION = "static INLINED double circulation("
_INIT = "static void begin("
_END = "static int end("
# Options that reorder sums; some compilers have a macro for it, which is not asked, either.
REORDERED = (
    *("-O1", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"),
    "-U__ASSOCIATIVE_MATH__",
)

_CONSTANTS = (
    _fault(
        "precision",
        "the gain of a rate in single precision, circular",
        _CIRCULAR_PLAN,
        "motion->gain_b[i] = dd_rounded(gain_b);",
        "motion->gain_b[i] = (float)dd_rounded(gain_b);",
    ),
)

_SERIES = (
    _fault(
        "series",
        "the last term of theta_1 dropped, circular",
        _CIRCULAR_PLAN,
        "T1_re_3 = dd_mul_dx(-8.0, p7);",
        "T1_re_3 = dd_mul_dx(0.0, p7);",
    ),
    _fault(
        "ladder",
        "a Landen step with the modulus before it",
        _LADDER,
        "landen(k3, kc3, s3,",
        "landen(k3, kc2, s3,",
    ),
    _fault(
        "ladder",
        "the last Landen step dropped from the angle",
        _LADDER,
        "*s5_out = s5;",
        "*s5_out = s4;",
    ),
    _fault(
        "ladder",
        "the last Landen step dropped from K",
        _LADDER,
        "dd_mul_xx(dd_add_dx(1.0, k5), K5);",
        "K5;",
    ),
)

_GEOMETRY = (
    _fault(
        "axis",
        "q in the order of the principal axes, rates not",
        "static void block_states(",
        "row[1 + axis[k]] = out + (1 + k) * s;",
        "row[1 + k] = out + (1 + k) * s;",
    ),
    _fault(
        "axis",
        "the rates of b and d swapped, hyperbolic",
        _HYPERBOLIC_STATE,
        "Omega_d_out[i] = Omega_d;",
        "Omega_d_out[i] = Omega_b;",
    ),
    _fault(
        "axis",
        "axes in cyclic order taken for the others",
        _START,
        "(axis_d - axis_b) / 2.0",
        "(axis_b - axis_d) / 2.0",
    ),
    _fault(
        "sign",
        "sigma never negative",
        _START,
        "sigma = choose(0.0, dd_rounded(Omega_a), 1.0, -1.0)",
        "sigma = choose(0.0, dd_rounded(Omega_a), 1.0, 1.0)",
    ),
    _fault(
        "sign",
        "rho turned",
        _START,
        "rho = choose(0.0, dd_rounded(c_ad), 1.0, -1.0)",
        "rho = choose(0.0, dd_rounded(c_ad), -1.0, 1.0)",
    ),
    _fault(
        "sign",
        "chi never negative",
        _START,
        "tau * dd_rounded(Omega_d), 1.0, -1.0)",
        "tau * dd_rounded(Omega_d), 1.0, 1.0)",
    ),
    _fault(
        "attitude",
        "the last number of attitude0 left out of its length",
        _INIT,
        "length = dd_add_xx(length, dd_mul_xx(q[k + 1], q[k + 1]));",
        "length = dd_add_xx(length, dd_mul_xx(q[k], q[k + 1]));",
    ),
    _fault(
        "attitude",
        "a vector product turned around, circular",
        _CIRCULAR_PLAN,
        "dd_sub_xx(dd_mul_xx(q_b, qbar_a), dd_mul_xx(q_a, qbar_b))",
        "dd_sub_xx(dd_mul_xx(q_a, qbar_b), dd_mul_xx(q_b, qbar_a))",
    ),
    _fault(
        "attitude",
        "scalar and vector part swapped in one coefficient, hyperbolic",
        _HYPERBOLIC_PLAN,
        "row_0_P4_re = dd_mul_xx(over_N, p_0);",
        "row_0_P4_re = dd_mul_xx(over_N, p_d);",
    ),
)

_DECISIONS = (
    _fault(
        "branch",
        "the circular branch taken up to k_1^2 = 0.9",
        _MOVING,
        "lane->k_1_hi[i] * lane->k_1_hi[i] <= max_circular",
        "lane->k_1_hi[i] * lane->k_1_hi[i] <= 0.9",
    ),
    _fault(
        "branch",
        "the hyperbolic branch taken from k_1^2 = 0.1",
        _MOVING,
        "lane->k_1_hi[i] * lane->k_1_hi[i] <= max_circular",
        "lane->k_1_hi[i] * lane->k_1_hi[i] <= 0.1",
    ),
    _fault(
        "branch",
        "the wrong side of the separatrix",
        _INIT,
        "if (side < 0.0) {",
        "if (side > 0.0) {",
    ),
    _fault(
        "branch",
        "the side of the separatrix decided in doubles",
        _DISCRIMINANT,
        "if (fabs(sum.hi) > (over.hi - under.hi) / 1024.0)",
        "if (fabs(sum.hi) >= 0.0)",
    ),
    _fault(
        "branch",
        "the largest moments taken for equal",
        "static double side_of(",
        "!is_zero(difference(apart, j, k))",
        "0.0",
    ),
    _fault(
        "branch",
        "a prolate body circulating about the axis of largest inertia",
        _CIRCULATION,
        "prolate_motion = -1.0",
        "prolate_motion = 1.0",
    ),
    _fault(
        "branch",
        "differences taken from what moments are rounded to",
        "int torque_free_motion_init_double_doubles(",
        "const double_double above = {differences[k][0], differences[k][1]};",
        "const double *next = inertia[(k + 1) % 3];"
        " const double_double less = {-next[0], -next[1]}, above = dd_add_xx(moment, less);",
    ),
    _fault(
        "quadrant",
        "the start before the middle of a period taken for one after it, hyperbolic",
        _HYPERBOLIC_PLAN,
        "side = choose(0.0, dd_rounded(s), 1.0, -1.0);",
        "side = choose(0.0, dd_rounded(s), 1.0, 1.0);",
    ),
    _fault(
        "quadrant",
        "the rate of d positive in the second half, hyperbolic",
        _HYPERBOLIC_STATE,
        "Omega_d = gain_d * (flip * theta4_y * over);",
        "Omega_d = gain_d * (theta4_y * over);",
    ),
    _fault(
        "quadrant",
        "the near side taken for the far one at the start, hyperbolic",
        _HYPERBOLIC_PLAN,
        "const double_double w = dd_choose(far, near, e_near, e_far);",
        "const double_double w = dd_choose(far, near, e_far, e_near);",
    ),
    _fault(
        "double_cover_sign",
        "attitude0 always with a positive scalar part",
        _INIT,
        "unit_q[k] = dd_div_xx(q[k], length);",
        "unit_q[k] = dd_div_xx(q[0].hi < 0.0 ? dd_neg(q[k]) : q[k], length);",
    ),
)

_DIGITS = (
    _fault(
        "pair",
        "the low part of the rate of Lambda lost, circular",
        _CIRCULAR_PLAN,
        "motion->Lambda_rate_lo[i] = Lambda_rate.lo;",
        "motion->Lambda_rate_lo[i] = 0.0;",
    ),
    _fault(
        "pair",
        "the low part of the rate of y lost, hyperbolic",
        _HYPERBOLIC_PLAN,
        "motion->y_rate_lo[i] = y_rate.lo;",
        "motion->y_rate_lo[i] = 0.0;",
    ),
    _fault(
        "pair",
        "the low part of the rate lost, steady",
        _STEADY_PLAN,
        "motion->Lambda_rate_lo = Lambda_rate.lo;",
        "motion->Lambda_rate_lo = 0.0;",
    ),
    _fault(
        "pair",
        "roots of pairs not corrected",
        "static INLINED double_double dd_sqrt(",
        "rest / (2.0 * s)",
        "0.0 * s",
    ),
    _fault(
        "pair",
        "a low part lost in sums of pairs",
        "static INLINED double_double dd_add_xx(",
        "quick_sum(s.hi, s.lo + t.hi);",
        "quick_sum(s.hi, s.lo + x.lo);",
    ),
    _fault(
        "pair",
        "an exact sum that rounds",
        "static INLINED double_double two_sum(",
        "(a - d) + (b - c)",
        "b - c",
    ),
    _fault(
        "scale",
        "the scale of K^2 - 2 H c_b forgotten",
        _DISCRIMINANT,
        "return scaled(sum, 2 * scale);",
        "return scaled(sum, scale);",
    ),
    _fault(
        "scale",
        "moments not scaled",
        "static int begin_doubles(",
        "scaled_by(inertia[k], -c_scale)",
        "inertia[k]",
    ),
    _fault(
        "scale",
        "attitude0 not scaled",
        "static int begin_doubles(",
        "scaled_by(attitude0[k], -q_scale)",
        "attitude0[k]",
    ),
    _fault(
        "steady",
        "a sphere's rate from one axis",
        _STEADY_PLAN,
        "dd_mul_xx(Omega3, Omega3)",
        "dd_mul_xx(Omega3, dd_of(0.0))",
    ),
    _fault(
        "steady",
        "the scalar part without one product",
        _STEADY_STATE,
        "q0 = fused(-p3, r3, fused(-p2,",
        "q0 = fused(p3, r3, fused(-p2,",
    ),
    _fault(
        "special",
        "exponentials of a motion without a period overflow",
        _NUMBERS,
        "never = 1e+300;",
        "never = 1.0;",
    ),
    _fault(
        "special",
        "t = 0 with the rates of the principal order",
        "static void at_initial_state(",
        "omega[k] = motion->omega0[k];",
        "omega[motion->axis[k]] = motion->omega0[k];",
    ),
    _fault(
        "entry_points",
        "t = 0 computed as any other time",
        "static int states_at(",
        "t[i + k] > 0.0))",
        "t[i + k] >= 0.0))",
    ),
    _fault(
        "entry_points",
        "a grid without its start",
        "static void grid_angles(",
        "step), start);",
        "step), 0.0);",
    ),
    _fault(
        "entry_points",
        "a wrong cosine of a sum in grids",
        "static void turned(",
        "-(sin_a * sin_b[i]));",
        "sin_a * sin_b[i]);",
    ),
    _fault(
        "entry_points",
        "the first attitude of a batch, of all its bodies",
        "static size_t several_init(",
        "attitude0 + 4 * i);",
        "attitude0);",
    ),
    _fault(
        "entry_points",
        "the times of the first body of a batch, for all its bodies",
        "int torque_free_propagate(",
        "t + stride * k",
        "t",
    ),
    _fault(
        "callers",
        "memory of the caller left as it was for a body that is refused",
        "int torque_free_propagate(",
        "else if (codes)",
        "else if (codes && k == 0)",
    ),
    _fault(
        "callers",
        "one refused body ends a batch that goes on",
        "int torque_free_propagate(",
        "codes[k] = code[i];",
        "if ((codes[k] = code[i]) != 0) return 0;",
    ),
    _fault(
        "ulps",
        "the middle axis' rate off by 4e-15, circular",
        _CIRCULAR_STATE,
        "Omega_b = gain_b * (theta1_v * over);",
        "Omega_b = gain_b * (theta1_v * over) * (1.0 + 4e-15);",
    ),
    _fault(
        "ulps",
        "the angle 6e-16 half turns ahead, hyperbolic",
        _HYPERBOLIC_ANGLES,
        "turns = turned_rest + (turned_error",
        "turns = turned_rest + (6e-16 + turned_error",
    ),
    _fault(
        "build",
        "sums reordered by the compiler, and not asked for",
        _END,
        "if (!is_rounded_once())",
        "if (0)",
        REORDERED,
    ),
)

FAULTS = (*_CONSTANTS, *_SERIES, *_GEOMETRY, *_DECISIONS, *_DIGITS)
