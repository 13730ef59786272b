"""Faults of torque_free.py: most of them small, each wrong in some motions or at some times."""

from functools import partial

from rigidsym.validate.faults.fault import Fault

_fault = partial(Fault, "numpy")
_NUMBERS = "pi = _Pair("
_PAIR_MUL = "    def __mul__(self, other):"
_LADDER = "def _ladder("
_CIRCULAR_PLAN = "def _circular_plan("
_CIRCULAR_ANGLES = "def _circular_angles("
_CIRCULAR_STATE = "def _circular_state("
_HYPERBOLIC_PLAN = "def _hyperbolic_plan("
_HYPERBOLIC_ANGLES = "def _hyperbolic_angles("
_HYPERBOLIC_STATE = "def _hyperbolic_state("
_STEADY_PLAN = "def _steady_plan("
_STEADY_ANGLES = "def _steady_angles("
_STEADY_STATE = "def _steady_state("
_PLAN = "def _plan("
_MOVING = "def _add_moving("

_CONSTANTS = (
    _fault(
        "constant",
        "pi off by 1e-12 in plans",
        _NUMBERS,
        "pi = _Pair(3.141592653589793, ",
        "pi = _Pair(3.141592653592935, ",
    ),
    _fault(
        "constant",
        "the last digits of pi lost in plans",
        _NUMBERS,
        "pi = _Pair(3.141592653589793, 1.2246467991473532e-16)",
        "pi = _Pair(3.141592653589793, 1.2246e-16)",
    ),
    _fault(
        "constant",
        "sine_0 off by 1e-12",
        _NUMBERS,
        "sine_0 = -5.16771278004997",
        "sine_0 = -5.167712780055139",
    ),
    _fault(
        "constant",
        "cosine_1 off by 1e-12",
        _NUMBERS,
        "cosine_1 = 4.058712126416648",
        "cosine_1 = 4.058712126420707",
    ),
    _fault(
        "constant",
        "log 2 off by 1e-12",
        _NUMBERS,
        "log_2 = _Pair(0.6931471805599453, ",
        "log_2 = _Pair(0.6931471805606385, ",
    ),
    _fault(
        "constant",
        "1/5 off by 1e-12 in arctangents and logarithms",
        _NUMBERS,
        "over_5 = _Pair(0.2, ",
        "over_5 = _Pair(0.2000000000002, ",
    ),
    _fault(
        "precision",
        "sine_3 in single precision",
        _NUMBERS,
        "sine_3 = 0.08214588673057224",
        "sine_3 = 0.08214588463306427",
    ),
    _fault(
        "precision",
        "cosine_4 in single precision",
        _NUMBERS,
        "cosine_4 = -0.025806888796526702",
        "cosine_4 = -0.025806888937950134",
    ),
    _fault(
        "precision",
        "1/7 in single precision",
        _NUMBERS,
        "over_7 = _Pair(0.14285714285714285, 7.93016446160826e-18)",
        "over_7 = _Pair(0.1428571492433548)",
    ),
    _fault(
        "precision",
        "a row of the attitude in single precision, circular",
        _CIRCULAR_PLAN,
        "row_b_P1_re = over_N * (epsilon * -(p_a * common_11))",
        "row_b_P1_re = np.float64(np.float32((over_N * (epsilon * -(p_a * common_11))).hi))",
    ),
    _fault(
        "precision",
        "the gain of a rate in single precision, hyperbolic",
        _HYPERBOLIC_PLAN,
        "gain_d = chi * tau * A_d * (two / four) * unit",
        "gain_d = np.float64(np.float32((chi * tau * A_d * (two / four)).hi)) * unit",
    ),
)

_SERIES = (
    _fault(
        "series",
        "the last term of theta_1 dropped, circular",
        _CIRCULAR_PLAN,
        "T1_im_3 = rho * (8 * d7)",
        "T1_im_3 = rho * (0 * d7)",
    ),
    _fault(
        "series",
        "the last term of theta_4 dropped, circular",
        _CIRCULAR_PLAN,
        "T4_re_3 = -4 * p6",
        "T4_re_3 = 0 * p6",
    ),
    _fault(
        "series",
        "the last term of theta_3 of the rates dropped, circular",
        _CIRCULAR_PLAN,
        "odd_1 = 8 * Q9",
        "odd_1 = 0 * Q9",
    ),
    _fault(
        "series",
        "the last term of theta_1 of the rates dropped, circular",
        _CIRCULAR_PLAN,
        "sine_even_2 = 16 * Q20",
        "sine_even_2 = 0 * Q20",
    ),
    _fault(
        "series",
        "the last term of zeta but one dropped, circular",
        _CIRCULAR_PLAN,
        " - 8 * d8 + 10 * d10)",
        " + 10 * d10)",
    ),
    _fault(
        "series",
        "the last term but two of Watson's sum dropped, circular",
        _CIRCULAR_PLAN,
        "side_plus = h2_plus * (1 + Q2 * h2_plus * (1 + Q4 * h2_plus * (1 + Q6 * h2_plus * "
        "(1 + common_4 * h2_plus))))",
        "side_plus = h2_plus * (1 + Q2 * h2_plus * (1 + Q4 * h2_plus))",
    ),
    _fault(
        "series",
        "the last term of theta_2 dropped, hyperbolic",
        _HYPERBOLIC_PLAN,
        "re_3 = nome8 * nome * C_3",
        "re_3 = 0 * C_3",
    ),
    _fault(
        "series",
        "the middle term of theta_2 dropped, hyperbolic",
        _HYPERBOLIC_PLAN,
        "im_2 = -(rho * nome4 * S_2)",
        "im_2 = -(0 * nome4 * S_2)",
    ),
    _fault(
        "series",
        "the term nome^20 of zeta dropped, hyperbolic",
        _HYPERBOLIC_PLAN,
        " + 9 * nome20 * S_4",
        "",
    ),
    _fault(
        "series",
        "a term of theta_3 of the rates dropped, hyperbolic",
        _HYPERBOLIC_STATE,
        "middle = 1 + nome4 * common_3 + w2 * w2 * nome8",
        "middle = 1 + w2 * w2 * nome8",
    ),
    _fault(
        "series",
        "a term of the nome dropped",
        "def _root_ratio(",
        "_horner(e4, 1, 2, 15, 150)",
        "_horner(e4, 1, 2)",
    ),
    _fault(
        "series",
        "the series of the logarithm cut",
        "def _logarithm(",
        "over_13, over_15, over_17, tail)",
        "over_13, over_15)",
    ),
    _fault(
        "ladder",
        "the last Landen step dropped from the angle",
        _LADDER,
        "return K0, s5, c5, Y5",
        "return K0, s4, c4, Y5",
    ),
    _fault(
        "ladder",
        "the last Landen step dropped from K",
        _LADDER,
        "K4 = (1 + k5) * K5",
        "K4 = K5",
    ),
    _fault(
        "ladder",
        "the imaginary time one Landen step behind",
        _LADDER,
        "return K0, s5, c5, Y5",
        "return K0, s5, c5, Y4",
    ),
)

_GEOMETRY = (
    _fault(
        "axis",
        "the vector of attitude0 in the order of the inputs",
        _MOVING,
        "x[index, 1 + axes[:, k]]",
        "x[index, 1 + k]",
    ),
    _fault(
        "axis",
        "axes a and d not swapped below the separatrix",
        "def _axes(",
        "excess.hi[:, None] >= 0, order[:, ::-1], order)",
        "excess.hi[:, None] >= 0, order[:, ::-1], order[:, ::-1])",
    ),
    _fault(
        "axis",
        "p_a taken for p_b in one coefficient, circular",
        _CIRCULAR_PLAN,
        "row_d_P1_im = over_N * (epsilon * (p_a * chi))",
        "row_d_P1_im = over_N * (epsilon * (p_b * chi))",
    ),
    _fault(
        "sign",
        "axes always right-handed",
        _MOVING,
        "% 3 == 1, 1.0, -1.0)",
        "% 3 == 1, 1.0, 1.0)",
    ),
    _fault(
        "sign",
        "sigma never negative",
        _MOVING,
        "sigma = np.where(rates[0].hi < 0, -1.0, 1.0)",
        "sigma = np.where(rates[0].hi < 0, 1.0, 1.0)",
    ),
    _fault(
        "sign",
        "rho never negative",
        _MOVING,
        "rho = np.where(_is_below(inertia[0], inertia[2]), -1.0, 1.0)",
        "rho = np.where(_is_below(inertia[0], inertia[2]), 1.0, 1.0)",
    ),
    _fault(
        "sign",
        "chi without rho",
        _MOVING,
        "chi = np.where(-rho * epsilon",
        "chi = np.where(-epsilon",
    ),
    _fault(
        "sign",
        "rho forgotten in Lambda, hyperbolic",
        _HYPERBOLIC_PLAN,
        "Lambda = psi_0 / 2 + rho * mu * zeta",
        "Lambda = psi_0 / 2 + mu * zeta",
    ),
    _fault(
        "attitude",
        "attitude0 not normalised",
        _PLAN,
        "q[:, k] / length",
        "q[:, k] / 1.0",
    ),
    _fault(
        "attitude",
        "the conjugate of attitude0's vector part in one product",
        _HYPERBOLIC_PLAN,
        "p_b = q_b * qbar_0 - q_0 * qbar_b",
        "p_b = q_b * qbar_0 + q_0 * qbar_b",
    ),
    _fault(
        "attitude",
        "the sine of attitude0 and a vector part swapped, hyperbolic",
        _HYPERBOLIC_PLAN,
        "row_a_P4_im = over_N * (p_0 * sigma)",
        "row_a_P4_im = over_N * (p_a * sigma)",
    ),
)

_DECISIONS = (
    _fault(
        "branch",
        "the branches swapped",
        _MOVING,
        'small = known["k_1"].hi ** 2 <= 0.5',
        'small = known["k_1"].hi ** 2 >= 0.5',
    ),
    _fault(
        "branch",
        "the circular branch taken up to k_1^2 = 0.8",
        _MOVING,
        'small = known["k_1"].hi ** 2 <= 0.5',
        'small = known["k_1"].hi ** 2 <= 0.8',
    ),
    _fault(
        "branch",
        "the hyperbolic branch taken from k_1^2 = 0.05",
        _MOVING,
        'small = known["k_1"].hi ** 2 <= 0.5',
        'small = known["k_1"].hi ** 2 <= 0.05',
    ),
    _fault(
        "branch",
        "the side of the separatrix decided by pairs, not by integers",
        "def _exact_excess(",
        "2.0**-10 * (over.hi - under.hi)",
        "-1 * (over.hi - under.hi)",
    ),
    _fault(
        "branch",
        "the separatrix taken for a motion with a period",
        _HYPERBOLIC_PLAN,
        "period_inverse = _choose(nome_d, 0, 0, 1 / period_d)",
        "period_inverse = _choose(nome_d, 0, 1, 1 / period_d)",
    ),
    _fault(
        "branch",
        "moments that nearly agree taken for equal",
        "def _same(",
        "(x.hi == y.hi)",
        "(np.abs(x.hi - y.hi) < 1e-12)",
    ),
    _fault(
        "branch",
        "moments sorted as doubles",
        "def _axes(",
        "np.lexsort((c.lo, c.hi), axis=-1)",
        "np.argsort(c.hi, axis=-1, kind='stable')",
    ),
    _fault(
        "branch",
        "faint rates taken for zero too soon",
        "NEGLIGIBLE = ",
        "NEGLIGIBLE = 2.0**-400",
        "NEGLIGIBLE = 2.0**-60",
    ),
    _fault(
        "winding",
        "no jumps between periods, hyperbolic",
        _HYPERBOLIC_PLAN,
        "jump = -2 * rho * alpha",
        "jump = -0.0 * rho * alpha",
    ),
    _fault(
        "winding",
        "half periods not counted, hyperbolic",
        _HYPERBOLIC_ANGLES,
        "flip = _alternating(periods)",
        "flip = 1.0 + 0.0 * periods",
    ),
    _fault(
        "winding",
        "half turns not counted, circular",
        _CIRCULAR_ANGLES,
        "v_sign = _alternating(v_whole)",
        "v_sign = 1.0 + 0.0 * v_whole",
    ),
    _fault(
        "quadrant",
        "a carry between angles lost, hyperbolic",
        _HYPERBOLIC_ANGLES,
        "whole = L_whole + (j_whole + turned_whole)",
        "whole = L_whole + j_whole",
    ),
    _fault(
        "quadrant",
        "the half before the middle of a period mirrored, hyperbolic",
        _HYPERBOLIC_ANGLES,
        "side = _choose(0, y, 1, -1)",
        "side = _choose(0, y, 1, 1)",
    ),
    _fault(
        "quadrant",
        "the start after the middle of a period only, hyperbolic",
        _HYPERBOLIC_PLAN,
        "y0 = side * y_size",
        "y0 = y_size",
    ),
    _fault(
        "quadrant",
        "the far half of a period taken for the near one",
        _HYPERBOLIC_PLAN,
        "y_size = _choose(far, near, y_b, period / 2 - y_b)",
        "y_size = y_b",
    ),
    _fault(
        "quadrant",
        "the sine of negative angles positive, circular",
        _CIRCULAR_ANGLES,
        "sin_v = v_sign * (v_turns * pi_hi",
        "sin_v = v_sign * (abs(v_turns) * pi_hi",
    ),
    _fault(
        "sheet",
        "the half turns of q not counted, circular",
        _CIRCULAR_ANGLES,
        "L_sign = _alternating(L_whole)",
        "L_sign = 1.0 + 0.0 * L_whole",
    ),
    _fault(
        "sheet",
        "the half turns of q not counted, steady",
        _STEADY_ANGLES,
        "L_sign = _alternating(L_whole)",
        "L_sign = 1.0 + 0.0 * L_whole",
    ),
)

_DIGITS = (
    _fault(
        "pair",
        "the low part of the rate of v lost, circular",
        _CIRCULAR_PLAN,
        "v_rate.hi, v_rate.lo",
        "v_rate.hi, 0 * v_rate.lo",
    ),
    _fault(
        "pair",
        "the low part of the rate of Lambda lost, hyperbolic",
        _HYPERBOLIC_PLAN,
        "Lambda_rate.hi, Lambda_rate.lo",
        "Lambda_rate.hi, 0 * Lambda_rate.lo",
    ),
    _fault(
        "pair",
        "the low part of the period lost, hyperbolic",
        _HYPERBOLIC_PLAN,
        "period.hi, period.lo",
        "period.hi, 0 * period.lo",
    ),
    _fault(
        "pair",
        "the low part of the jump lost, hyperbolic",
        _HYPERBOLIC_PLAN,
        "jump.hi, jump.lo",
        "jump.hi, 0 * jump.lo",
    ),
    _fault(
        "pair",
        "the rounding of the turned angle forgotten, circular",
        _CIRCULAR_ANGLES,
        "L_error = _product_error(Lambda_rate_hi, t, L) + Lambda_rate_lo * t",
        "L_error = Lambda_rate_lo * t",
    ),
    _fault(
        "pair",
        "half of the cross terms lost in products of pairs",
        _PAIR_MUL,
        "(self.hi * other.lo + self.lo * other.hi)",
        "self.hi * other.lo",
    ),
    _fault(
        "pair",
        "quotients of pairs not corrected",
        "    def __truediv__(self, other):",
        "((self.hi - r.hi) + (self.lo - r.lo)) / top",
        "0.0 * top",
    ),
    _fault(
        "pair",
        "K of the ladder a plain double",
        _LADDER,
        "return K0, s5",
        "return _Pair(K0.hi, 0.0 * K0.hi), s5",
    ),
    _fault(
        "scale",
        "the unit of a rate forgotten, circular",
        _CIRCULAR_PLAN,
        "gain_b = chi * A_b * (three / two) * unit",
        "gain_b = chi * A_b * (three / two)",
    ),
    _fault(
        "scale",
        "the scale of K^2 - 2 H c_b forgotten",
        "def _exact_excess(",
        "np.ldexp(excess.hi, 2 * exponent), np.ldexp(excess.lo, 2 * exponent)",
        "excess.hi, excess.lo",
    ),
    _fault(
        "scale",
        "rates scaled once in K^2 - 2 H c_b from integers",
        "def _integer_excess(",
        "exponent = shift + 2 * (scale_c + scale_omega)",
        "exponent = shift + 2 * scale_c + scale_omega",
    ),
    _fault(
        "steady",
        "a vector product turned around",
        _STEADY_STATE,
        "q1 = p0 * r1 + p1 * cos_half_theta + p2 * r3 - p3 * r2",
        "q1 = p0 * r1 + p1 * cos_half_theta + p3 * r2 - p2 * r3",
    ),
    _fault(
        "steady",
        "the angle twice as fast",
        _STEADY_PLAN,
        "Lambda_rate = omega / (2 * pi)",
        "Lambda_rate = omega / pi",
    ),
    _fault(
        "steady",
        "the axis without its sign",
        _STEADY_PLAN,
        "axis2 = Omega2 / omega",
        "axis2 = abs(Omega2) / omega",
    ),
    _fault(
        "steady",
        "rest without an axis",
        "def _steady(",
        "first = _Pair(np.where(rest, 1.0, omega.hi[:, 0]), omega.lo[:, 0])",
        "first = omega[:, 0]",
    ),
    _fault(
        "special",
        "no number on the separatrix",
        _HYPERBOLIC_PLAN,
        "period_far = _choose(nome_d, 0, never, _rounded(period))",
        "period_far = _choose(nome_d, 0, math.nan, _rounded(period))",
    ),
    _fault(
        "special",
        "t = 0 on the other sheet",
        "    zero = np.flatnonzero(flat == 0)",
        'plan["q0"][:, None]',
        '-plan["q0"][:, None]',
    ),
    _fault(
        "routes",
        "t = 0 computed as any other time",
        "    zero = np.flatnonzero(flat == 0)",
        "if zero.size:",
        "if zero.size > flat.size:",
    ),
    _fault(
        "routes",
        "two axes swapped at one time alone",
        "    q, omega = [values[0], 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]",
        "omega[axis] = values[1 + k], values[4 + k]",
        "omega[axis] = values[1 + k], values[6 - k]",
    ),
    _fault(
        "routes",
        "constants of the first body for all of a batch",
        "    timed, kept = (",
        "[[x[some, None]",
        "[[x[:1, None]",
    ),
    _fault(
        "routes",
        "all blocks of many times at those of the first",
        "    timed, kept = (",
        'inner = float(plan["unit"][body]) * t[some]',
        'inner = float(plan["unit"][body]) * t[: len(t[some])]',
    ),
    _fault(
        "ulps",
        "the attitude 4e-15 too long, circular",
        _CIRCULAR_STATE,
        "scale = _sqrt(over)",
        "scale = _sqrt(over) * (1 + 4e-15)",
    ),
    _fault(
        "ulps",
        "a rate off by 4e-15, hyperbolic",
        _HYPERBOLIC_STATE,
        "Omega_a = gain_a * (theta3_y * over)",
        "Omega_a = gain_a * (theta3_y * over) * (1 + 4e-15)",
    ),
    _fault(
        "ulps",
        "the angle 6e-16 half turns ahead, steady",
        _STEADY_ANGLES,
        "L_turns = L_rest + L_error",
        "L_turns = L_rest + (L_error + 6e-16)",
    ),
)

FAULTS = (*_CONSTANTS, *_SERIES, *_GEOMETRY, *_DECISIONS, *_DIGITS)
