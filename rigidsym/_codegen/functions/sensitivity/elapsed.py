"""Generated functions of the elapsed time: sn, cn, dn, and integrals of their squares.

For m <= 1/2 they are thetas of real time.  With v = pi u/2K, g = pi/2K and Q the nome of m, the
integral of sn^2 is (DLMF 22.16.30)

    (Q/m) (8 g^2 u B(0)/theta_4(0) - 4 g sin 2v A(v)/theta_4(v))
    A(v) = 1 - 4 Q^3 x + 3 Q^8 (4 x^2 - 1),    B(0) = 1 - 4 Q^3 + 9 Q^8,    x = cos 2v

where Q/m is regular at m = 0; B is the slope of sin 2v A, so that all of it vanishes twice at
u = 0.  They leave out 16 Q^15.

For m > 1/2 they are thetas of imaginary time in the complementary nome.

For short times the integrals of S_t^2 and of S_t^2/D_t^2 are Taylor's series in t^2.  Both squares
y satisfy y'' = 2 + 4 A y + 6 B y^2, with A = -(p + r), B = p r for S_t^2, and A = 2 r - p,
B = -r (p - r) for S_t^2/D_t^2.  Their poles are at lambda t = pi/2 or farther, which p t^2 <= 1/16
stays a sixth of: each term is below a thirty-ninth of the one before, and _TERMS leave out less
than 2^-52 of what is there.
"""

from collections.abc import Iterable

from rigidsym._codegen.functions.common import elapsed_phase, elapsed_time, flat, period_bounds
from rigidsym._codegen.functions.sensitivity.changes import ELAPSED, MODULI, PASSED
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.passes import select
from rigidsym._codegen.special_functions import reduction, theta_circular
from rigidsym._codegen.special_functions.polynomials import horner
from rigidsym.solution import Solution

_FORMS = ("even", "odd", "sine_even", "sine_odd")
_ZETA, _SLOPE = "DLMF 22.16.30", "DLMF 20.2.4"
_PERIOD, _SQUARE = "DLMF 20.2.7", "DLMF 20.2.2"
_SERIES = ("DLMF 20.2.1", "DLMF 20.2.2")
# Powers of the nome as products of two others.
_NOMES = {4: (2, 2), 6: (4, 2), 8: (4, 4), 12: (8, 4), 16: (8, 8), 18: (12, 6), 32: (16, 16)}
_TERMS = 10
# Up to here p t^2 is small; and so small that S_t is t.
_NEAR, _TINY = "1/16", "1/18014398509481984"
_TAYLOR = "DLMF 22.10"
_NEAR_COEFFICIENTS = tuple(f"{x}_{n}" for x in "EF" for n in range(_TERMS))


def real(solution: Solution) -> tuple[Function, ...]:
    """Build the functions of elapsed time for parameters m <= 1/2, by thetas of real time."""
    return _functions(
        *("real", "m <= 1/2", "S_t, C_t, D_t, E_t and D_t F_t"),
        *(_real_constants(), _real_angles(), _real_state(solution)),
        given=MODULI,
        split=("v_rate",),
        in_angles=(),
        timed=("sin_v", "cos_v"),
        in_state=(
            *(name for form in _FORMS for name in theta_circular.names(form)),
            *("gain_S", "gain_C", "gain_D", "E_rate", "slope_0", "slope_1", "slope_2"),
            *("p", "apart", *_NEAR_COEFFICIENTS),
        ),
    )


def imaginary() -> tuple[Function, ...]:
    """Build the functions of elapsed time for parameters m > 1/2, by thetas of imaginary time."""
    return _functions(
        *("imaginary", "m > 1/2", "S_t, C_t, D_t, E_t, D_t F_t and the integral over the phase"),
        *(_imaginary_constants(), _imaginary_angles(), _imaginary_state()),
        given=(*(name for name in MODULI if name != "divisor"), "y0"),
        split=("y_rate", "period", "z0"),
        in_angles=("period_far", "period_inverse"),
        timed=(
            *("w", "p2", "y", "side", "flip", "periods"),
            *("z_w2", "z_p2", "z", "z_side", "turns"),
        ),
        in_state=(
            *("nome2", "nome4", "nome6", "nome8", "nome12", "nome16", "nome18"),
            *("gain_S", "gain_C", "gain_D", "f_gain", "f_rate", "f_period", "p", "apart"),
            *("passed_gain", "passed_rate", "passed_period", "passed_0", *_NEAR_COEFFICIENTS),
        ),
    )


def _functions(
    name: str,
    where: str,
    computed: str,
    constants: Iterable[Let],
    angles: Iterable[Let],
    state: Iterable[Let],
    *,
    given: tuple[str, ...],
    split: tuple[str, ...],
    in_angles: tuple[str, ...],
    timed: tuple[str, ...],
    in_state: tuple[str, ...],
) -> tuple[Function, ...]:
    """Build the three functions of the elapsed time: constants, angles and values.

    For the arguments see `common.branch`.
    """
    return (
        Function(
            f"_{name}_constants",
            f"Constants of the elapsed time for {where}, from `_moduli`.",
            given,
            tuple(constants),
            (*split, *in_angles, *in_state),
            frozenset(given),
            frozenset(split),
            rounds=True,
        ),
        Function(
            f"_{name}_angles",
            f"Angles of the elapsed time t + t_lo for {where}.",
            ("t", "t_lo", *flat(split), *in_angles),
            tuple(angles),
            timed,
        ),
        Function(
            f"_{name}_state",
            f"{computed} for {where}.",
            (*timed, "t", *in_state),
            tuple(state),
            (*ELAPSED, *PASSED),
        ),
    )


# --- m <= 1/2


def _real_constants() -> list[Let]:
    return [
        let("ratio = _root_ratio(modulus, complement)", "DLMF 20.9.1"),
        let("root_nome = modulus/ratio", "DLMF 20.9.1"),
        let("Q = root_nome*root_nome", "DLMF 20.9.1"),
        *theta_circular.rates(),
        *theta_circular.at_zero(),
        let("g = 1/(three*three)", "DLMF 20.9.2"),
        let("v_rate = lambda_*g/pi"),
        let("over_lambda = 1/sqrt(divisor)", "DLMF 22.2.4"),
        let("gain_S = three/two*over_lambda", "DLMF 22.2.4"),
        let("gain_C = four/two", "DLMF 22.2.5"),
        let("gain_D = four/three", "DLMF 22.2.6"),
        let("Q_over_m = 1/(ratio*ratio)", _ZETA),
        let("Q8 = Q4*Q4", _SLOPE),
        let("per_square = Q_over_m*g*(over_lambda*over_lambda)", _ZETA),
        let("E_rate = 8*g*per_square*(1 - 4*(Q*Q2) + 9*Q8)/four", _ZETA),
        let("per_cube = 4*per_square*over_lambda", _ZETA),
        let("slope_0 = per_cube*(1 - 3*Q8)", _SLOPE),
        let("slope_1 = -(4*per_cube*(Q*Q2))", _SLOPE),
        let("slope_2 = 12*per_cube*Q8", _SLOPE),
        *_near_coefficients(),
    ]


def _real_angles() -> list[Let]:
    return [
        *reduction.product("v", "v_rate"),
        *reduction.whole("v", "v"),
        let("v_turns = v_rest + v_error", reduction.TURNS),
        let("v_side = choose(0, v_rest, 1, -1)", reduction.TURNS),
        # The cosine as the sine of what is left: to all digits next to its zero, too, where columns
        # of bodies that are nearly symmetric are small.
        let("v_left = (1/2 - size(v_rest)) - v_side*v_error", "DLMF 4.21.10"),
        let("v_sign = alternating(v_whole)", reduction.TURNS),
        *reduction.sine("v_turns", "v_sign", "sin_v"),
        *reduction.sine("v_left", "v_sign", "cos_v"),
    ]


def _real_state(solution: Solution) -> list[Let]:
    slopes = ["slope_0", "slope_1", "slope_2"]
    return [
        *theta_circular.argument(),
        *theta_circular.rate_values(),
        let("over = 1/theta4_v"),
        *_growth(),
        _sine("gain_S*(theta1_v*over)"),
        let("C_t = gain_C*(theta2_v*over)", "DLMF 22.2.5"),
        let("D_t = gain_D*(theta3_v*over)", "DLMF 22.2.6"),
        let(f"E_far = E_rate*t - 2*(sin_v*cos_v)*({horner('x', slopes)})*over", _ZETA),
        *_near_values(),
        let(f"E_t = choose(growth, {_NEAR}, E_near, E_far)", _ZETA),
        let("F_far = (t - p*E_t - S_t*(C_t/D_t))/apart", facts=("definition elapsed_F.F_t",)),
        let(f"F_t = choose(growth, {_NEAR}, F_near, F_far)", _ZETA),
        *select(solution.sequences["sensitivity"], ("f",), ("D_t", "F_t")),
        # No phase is known, and what has passed is not asked for.
        *(let(f"{name} = 0") for name in PASSED),
    ]


# --- m > 1/2


def _imaginary_constants() -> list[Let]:
    return [
        let("ratio = _root_ratio(complement, modulus)", "DLMF 20.9.1"),
        let("root_nome = complement/ratio", "DLMF 20.9.1"),
        let("nome2 = root_nome*root_nome", "DLMF 20.9.1"),
        *(let(f"nome{n} = nome{i}*nome{j}", _SQUARE) for n, (i, j) in _NOMES.items()),
        # theta_2, theta_3, theta_4 of zero, the first over 2 q^(1/4).
        let("two = 1 + nome4 + nome12 + nome12*nome12", _SQUARE),
        let("three = 1 + 2*nome2 + 2*nome8 + 2*nome18 + 2*nome32", "DLMF 20.2.3"),
        let("four = 1 - 2*nome2 + 2*nome8 - 2*nome18 + 2*nome32", "DLMF 20.2.4"),
        let("g = 1/(three*three)", "DLMF 20.9.2"),
        let("y_rate = lambda_*g"),
        # On the separatrix the nome is zero and nothing ever returns.
        let("nome_d = rounded(nome2)", _SQUARE),
        let("period = -_logarithm(choose(nome_d, 0, 1, nome2))", _SQUARE),
        *period_bounds("nome_d", _PERIOD),
        let("over_lambda = 1/lambda_", "DLMF 22.2.4"),
        let("gain_S = three/four*over_lambda", "DLMF 22.2.4"),
        let("gain_C = two/four", "DLMF 22.2.5"),
        let("gain_D = two/three", "DLMF 22.2.6"),
        let("scale = 8*g/(ratio*ratio)*over_lambda/r", _ZETA),
        let("f_gain = scale*gain_D", _ZETA),
        let("f_rate = scale*(1 + 4*nome6 + 9*nome16)/three", _ZETA),
        let("m_1 = complement*complement", "DLMF 19.2.8"),
        let("m_safe = choose(nome_d, 0, 1, m_1)", _ZETA),
        let("whole = choose(nome_d, 0, 0, 2*g/m_safe*over_lambda/r)", _ZETA),
        let("f_period = whole - f_rate*period", _ZETA),
        let("passed_gain = r*scale/2", _ZETA),
        let("passed_rate = r*f_rate", _ZETA),
        let("passed_period = r*f_period", _ZETA),
        # A state's nome is the square of this one, and its y a half of z.
        let("z0 = 2*y0", "DLMF 20.7.12"),
        let("start = rounded(z0)"),
        let("start_lo = rounded(z0 - start)"),
        let("period_rest = rounded(choose(nome_d, 0, 0, period - period_far))"),
        *_exponentials("start", "period_rest"),
        *_over_phase("start", "passed_0"),
        *_near_coefficients(),
    ]


def _exponentials(z: str, period_lo: str) -> list[Let]:
    """Return assignments for the sign of z, e^(-2 |z|) and e^(2 |z| - period).

    They are accurate to all digits of z + z_lo.
    """
    return [
        let(f"{z}_side = choose(0, {z}, 1, -1)", "DLMF 20.2.1", _SQUARE),
        let(f"{z}_depth = 2*size({z})", _SQUARE),
        let(f"{z}_more = 2*({z}_side*{z}_lo)", _SQUARE),
        let(f"{z}_w2 = exp(-{z}_depth)*(1 - {z}_more)", _SQUARE),
        let(f"{z}_p2 = exp({z}_depth - period_far)*(1 + ({z}_more - {period_lo}))", _SQUARE),
    ]


def _over_phase(z: str, integral: str, whole: str = "") -> list[Let]:
    """Return assignments for r times the integral of sd^2/lambda^2 over the phase from 0 to z.

    They follow those of `_exponentials`.
    """
    w2, p2 = f"{z}_w2", f"{z}_p2"
    linear = f"{whole}*passed_period - passed_rate*{z}" if whole else f"-passed_rate*{z}"
    return [
        let(f"{z}_rise = {_rise(w2, p2)}", _ZETA),
        let(f"{z}_theta = ({_middle(w2, p2)}) + ({_ends(w2, p2)})", "DLMF 20.2.3"),
        let(f"{integral} = passed_gain*{z}_side*({z}_rise/({w2}*{z}_theta)) + ({linear})", _ZETA),
    ]


def _rise(w2: str, p2: str) -> str:
    return (
        f"(1 - {w2}*{w2})/2 + (nome4*{p2} - nome6*({w2}*{w2}*{w2}))"
        f" + 3*(nome12*({p2}*{p2}) - nome16*(({w2}*{w2})*({w2}*{w2})))/2"
    )


def _imaginary_angles() -> list[Let]:
    return [
        *elapsed_time(_PERIOD),
        let("side = choose(0, y, 1, -1)", "DLMF 20.2.1", _SQUARE),
        let("flip = alternating(periods)", "DLMF 20.2.6"),
        let("depth = size(y)", _SQUARE),
        let("more = side*y_lo", _SQUARE),
        let("w = exp(-depth)*(1 - more)", _SQUARE),
        let("p2 = exp(2*depth - period_far)*(1 + (2*more - period_lo))", _SQUARE),
        *elapsed_phase(_PERIOD),
        *_exponentials("z", "period_lo"),
    ]


def _imaginary_state() -> list[Let]:
    return [
        let("qw2 = nome2*(w*w)", _SQUARE),
        *_theta_values(),
        let("over = 1/theta2_y"),
        *_growth(),
        _root(),
        let(
            f"S_t = choose(growth, {_NEAR}, S_near, gain_S*(flip*theta1_y*over))",
            "DLMF 22.2.4",
        ),
        let("C_t = gain_C*(flip*theta4_y*over)", "DLMF 22.2.5"),
        let("D_t = gain_D*(theta3_y*over)", "DLMF 22.2.6"),
        let(f"rise = {_rise('w2', 'p2')}", _ZETA),
        let("f_far = f_gain*side*(rise/w)*over + D_t*(periods*f_period - f_rate*y)", _ZETA),
        *_near_values(),
        let(f"f = choose(growth, {_NEAR}, D_t*F_near, f_far)", _ZETA),
        let("E_far = (t - S_t*(C_t/D_t) - apart*f/D_t)/p", facts=("definition elapsed_E.E_t",)),
        let(f"E_t = choose(growth, {_NEAR}, E_near, E_far)", _ZETA),
        *_over_phase("z", "passed_z", "turns"),
        let("passed = passed_z - passed_0", _ZETA),
        let("turned = size(turns)", _PERIOD),
    ]


def _theta_values() -> list[Let]:
    """Return assignments for theta_1 to theta_4 at i y.

    They use w, p2, qw2 and sgn(y); the functions are divided by q^(1/4) e^|y|.
    """
    falling, turning = ["1", "nome2", "nome8", "nome18"], ["1", "-nome2", "nome8", "-nome18"]
    return [
        let("w2 = w*w", *_SERIES),
        let(f"tall = {horner('p2', falling)}", "DLMF 20.2.2"),
        let(f"deep = w2*({horner('qw2', falling)})", "DLMF 20.2.2"),
        let("theta2_y = tall + deep", "DLMF 20.2.2"),
        let(f"tall_1 = {horner('p2', turning)}", "DLMF 20.2.1"),
        let(f"deep_1 = w2*({horner('qw2', turning)})", "DLMF 20.2.1"),
        let("theta1_y = side*(tall_1 - deep_1)", "DLMF 20.2.1"),
        let(f"ends = {_ends('w2', 'p2')}", "DLMF 20.2.3"),
        let(f"middle = {_middle('w2', 'p2')}", "DLMF 20.2.3"),
        let("theta3_y = 2*(w*(middle + ends))", "DLMF 20.2.3"),
        let("theta4_y = 2*(w*(middle - ends))", "DLMF 20.2.4"),
    ]


def _ends(w2: str, p2: str) -> str:
    return f"{p2}*(1 + nome12*({p2}*{p2})) + {w2}*(nome2 + nome18*({w2}*{w2}))"


def _middle(w2: str, p2: str) -> str:
    return f"1 + nome4*({p2}*{p2}) + {w2}*{w2}*nome8"


# --- short times


def _near_coefficients() -> list[Let]:
    """Return assignments for the short-time Taylor coefficients of the integrals E_t and F_t.

    The n-th coefficient is that of t^3 t^(2 n), made from p, r and p - r.  The series serve short
    times.
    """
    lets = [
        let("p_d = rounded(p)"),
        let("r_d = rounded(r)"),
        let("apart_d = rounded(apart)"),
        let("E_one = -4*(p_d + r_d)", _TAYLOR),
        let("E_two = 6*(p_d*r_d)", _TAYLOR),
        let("F_one = 4*(r_d - apart_d)", _TAYLOR),
        let("F_two = -6*(r_d*apart_d)", _TAYLOR),
    ]
    return [*lets, *_near_of("E"), *_near_of("F")]


def _near_of(name: str) -> list[Let]:
    """Return assignments for Taylor coefficients of a squared Jacobi function and its integral.

    The coefficient square_n is that of t^(2 n + 2).
    """
    square = f"{name}_square"
    lets = [let(f"{square}_0 = 1", _TAYLOR), let(f"{name}_0 = 1/3", _TAYLOR)]
    for n in range(1, _TERMS):
        products = " + ".join(f"{square}_{i}*{square}_{n - 2 - i}" for i in range(n - 1))
        more = f" + {name}_two*({products})" if products else ""
        lets += [
            let(
                f"{square}_{n} = ({name}_one*{square}_{n - 1}{more})/{(2 * n + 2) * (2 * n + 1)}",
                _TAYLOR,
            ),
            let(f"{name}_{n} = {square}_{n}/{2 * n + 3}", _TAYLOR),
        ]
    return lets


def _growth() -> list[Let]:
    """Return assignments for p t^2, which decides whether a time is short."""
    return [let("t2 = t*t", _TAYLOR), let("growth = p*t2", _TAYLOR)]


def _sine(far: str) -> Let:
    """Return the assignment for the scaled Jacobi sine S_t, equal to t where p t^2 is tiny.

    Products with p may underflow there.
    """
    return let(f"S_t = choose(growth, {_TINY}, t, {far})", "DLMF 22.2.4")


def _root() -> Let:
    """Return the assignment for the scaled Jacobi sine S_t at short times, as a square root."""
    square = horner("t2", [f"{2 * n + 3}*E_{n}" for n in range(_TERMS)])
    return let(f"S_near = t*sqrt(size({square}))", _TAYLOR)


def _near_values() -> list[Let]:
    """Return assignments for the integrals E_t and F_t at short times."""
    rows = {x: [f"{x}_{n}" for n in range(_TERMS)] for x in "EF"}
    return [
        let(f"E_near = t*t2*({horner('t2', rows['E'])})", _TAYLOR),
        let(f"F_near = t*t2*({horner('t2', rows['F'])})", _TAYLOR),
    ]
