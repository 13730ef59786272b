"""Faults of torque_free.py: most of them small, each wrong in some motions or at some times."""

from functools import partial

from rigidsym.validate.faults.fault import Fault

_fault = partial(Fault, "numpy")
_PAIR_MUL = "    def __mul__(self, other):"
_LADDER = "def _ladder("
_CIRCULAR_PLAN = "def _circular_constants("
_CIRCULAR_ANGLES = "def _circular_angles("
_CIRCULAR_STATE = "def _circular_state("
_HYPERBOLIC_PLAN = "def _hyperbolic_constants("
_HYPERBOLIC_ANGLES = "def _hyperbolic_angles("
_HYPERBOLIC_STATE = "def _hyperbolic_state("
_STEADY_PLAN = "def _steady_constants("
_STEADY_ANGLES = "def _steady_angles("
_STEADY_STATE = "def _steady_state("
_PREPARATION = "    apart: what each moment is above"
_MOVING = "def _add_moving("
_START = "def _initial_state("
_CIRCULATION = "def _circulation("

_SERIES = (
    _fault(
        "series",
        "the last term of theta_1 dropped, circular",
        _CIRCULAR_PLAN,
        "T1_im_3 = rho * (8 * d7)",
        "T1_im_3 = rho * (0 * d7)",
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
        "_taken(q[1:], axis), axis",
        'q["-abd".index(x)], axis',
    ),
    _fault(
        "axis",
        "axes a and d not swapped below the separatrix",
        _PREPARATION,
        "axes = _reversed(side < 0, axes)",
        "axes = _reversed(side != side, axes)",
    ),
    _fault(
        "sign",
        "axes always right-handed",
        _START,
        "(axis_b - axis_a) * (axis_d - axis_a) * (axis_d - axis_b) / 2",
        "1.0",
    ),
    _fault(
        "sign",
        "sigma never negative",
        _START,
        "sigma = _choose(0, _rounded(Omega_a), 1, -1)",
        "sigma = _choose(0, _rounded(Omega_a), 1, 1)",
    ),
    _fault(
        "sign",
        "rho never negative",
        _START,
        "rho = _choose(0, _rounded(c_ad), 1, -1)",
        "rho = _choose(0, _rounded(c_ad), 1, 1)",
    ),
    _fault(
        "sign",
        "chi without tau",
        _START,
        "chi = _choose(0, tau * _rounded(Omega_d)",
        "chi = _choose(0, _rounded(Omega_d)",
    ),
    _fault(
        "attitude",
        "attitude0 not normalised",
        _PREPARATION,
        "x / length",
        "x / 1.0",
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
        'small = known["k_1"].hi ** 2 <= MAX_CIRCULAR',
        'small = known["k_1"].hi ** 2 >= MAX_CIRCULAR',
    ),
    _fault(
        "branch",
        "the circular branch taken up to k_1^2 = 0.8",
        _MOVING,
        'small = known["k_1"].hi ** 2 <= MAX_CIRCULAR',
        'small = known["k_1"].hi ** 2 <= 0.8',
    ),
    _fault(
        "branch",
        "the hyperbolic branch taken from k_1^2 = 0.05",
        _MOVING,
        'small = known["k_1"].hi ** 2 <= MAX_CIRCULAR',
        'small = known["k_1"].hi ** 2 <= 0.05',
    ),
    _fault(
        "branch",
        "the side of the separatrix decided by pairs, not by integers",
        "def _exact_discriminant(",
        "2.0**-10 * (over.hi - under.hi)",
        "-1 * (over.hi - under.hi)",
    ),
    _fault(
        "branch",
        "moments that nearly agree taken for equal",
        "def _sides(",
        "_sign(abs(x.hi))",
        "_sign(abs(x.hi) // 1e-12)",
    ),
    _fault(
        "branch",
        "a prolate body circulating about the axis of largest inertia",
        _CIRCULATION,
        "prolate_motion = -1",
        "prolate_motion = 1",
    ),
    _fault(
        "branch",
        "moments sorted as doubles",
        _PREPARATION,
        "axes = _sorted(apart)",
        "a, b, d = (_DoubleDouble(c[0].hi), _DoubleDouble(c[1].hi), _DoubleDouble(c[2].hi))\n"
        "    axes = _sorted([a - b, b - d, d - a])",
    ),
    _fault(
        "branch",
        "differences taken from what moments are rounded to",
        "def _made_from_pairs(*rows):",
        "made = _prepared(c, apart,",
        "made = _prepared(c, [c[0] - c[1], c[1] - c[2], c[2] - c[0]],",
    ),
    _fault(
        "branch",
        "faint rates taken for zero too soon",
        "NEGLIGIBLE = ",
        "NEGLIGIBLE = 2.0**-400",
        "NEGLIGIBLE = 2.0**-60",
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
        "double_cover_sign",
        "the half turns of q not counted, circular",
        _CIRCULAR_ANGLES,
        "L_sign = _alternating(L_whole)",
        "L_sign = 1.0 + 0.0 * L_whole",
    ),
    _fault(
        "double_cover_sign",
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
        "half of the cross terms lost in products of pairs",
        _PAIR_MUL,
        "a * other.lo + self.lo * b",
        "a * other.lo",
    ),
    _fault(
        "pair",
        "quotients of pairs not corrected",
        "    def __truediv__(self, other):",
        "((self.hi - r) + (self.lo - (e - (r - p)))) / b",
        "0.0 * b",
    ),
    _fault(
        "pair",
        "K of the ladder a plain double",
        _LADDER,
        "return K0, s5",
        "return _DoubleDouble(K0.hi, 0.0 * K0.hi), s5",
    ),
    _fault(
        "scale",
        "the scale of K^2 - 2 H c_b forgotten",
        "def _exact_discriminant(",
        "_ldexp(both.hi, 2 * exponent), _ldexp(both.lo, 2 * exponent)",
        "both.hi, both.lo",
    ),
    _fault(
        "scale",
        "rates scaled once in K^2 - 2 H c_b from integers",
        "def _integer_discriminant(",
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
        "def _add_steady(",
        "first = _DoubleDouble(_where(rest, 1.0, omega[0].hi), omega[0].lo)",
        "first = omega[0]",
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
        "t = 0 with the other double-cover sign",
        "def _begin(",
        "prepared[name][:, None]",
        "-prepared[name][:, None]",
    ),
    _fault(
        "entry_points",
        "t = 0 computed as any other time",
        "def _begin(",
        "np.nonzero(t == 0)",
        "np.nonzero(t != t)",
    ),
    _fault(
        "entry_points",
        "two axes swapped at one time alone",
        "    q, omega = [values[0], 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]",
        "omega[axis] = values[1 + k], values[4 + k]",
        "omega[axis] = values[1 + k], values[6 - k]",
    ),
    _fault(
        "entry_points",
        "constants of the first body for all of a batch",
        "    timed, kept = (",
        "[[x[some, None]",
        "[[x[:1, None]",
    ),
    _fault(
        "entry_points",
        "all blocks of many times at those of the first",
        "    timed, kept = (",
        'inner = float(prepared["unit"][body]) * t[body if len(t) > 1 else 0, some]',
        'inner = float(prepared["unit"][body]) * t[0, : len(t[0, some])]',
    ),
    _fault(
        "callers",
        "the caller's rates kept in a prepared motion",
        "    given = [np.asarray(",
        "given], shape, None)",
        'given], shape, None) | {"omega0": given[1].reshape(1, 3)}',
    ),
    _fault(
        "callers",
        "states of bodies that are refused",
        "def _blot_out(",
        "values[refused[index]] = np.nan",
        "values[refused[index]] = values[refused[index]]",
    ),
    _fault(
        "callers",
        "the body after one that is refused without states",
        "def _blot_out(",
        "values[refused[index]] = np.nan",
        "values[np.roll(refused, 1)[index]] = np.nan",
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

FAULTS = (*_SERIES, *_GEOMETRY, *_DECISIONS, *_DIGITS)
