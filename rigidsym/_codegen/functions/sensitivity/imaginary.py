"""The elapsed time for m > 1/2."""

from rigidsym._codegen.functions.common import elapsed_phase, elapsed_time, flat, period_bounds
from rigidsym._codegen.functions.sensitivity import near
from rigidsym._codegen.functions.sensitivity.moduli import RESULTS
from rigidsym._codegen.functions.sensitivity.real import ELAPSED, PASSED
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.special_functions.polynomials import horner

_GIVEN = (*(name for name in RESULTS if name != "divisor"), "y0")
_SPLIT = ("y_rate", "period", "z0")
_BEYOND = ("period_far", "period_inverse")
_PHASE = ("z_w2", "z_p2", "z", "z_side", "turns")
_NOMES = ("nome2", "nome4", "nome6", "nome8", "nome12", "nome16", "nome18")
_PERIOD, _SQUARE, _ZETA = "DLMF 20.2.7", "DLMF 20.2.2", "DLMF 22.16.30"
_SERIES = ("DLMF 20.2.1", "DLMF 20.2.2")


def imaginary() -> tuple[Function, ...]:
    """State constants, angles and functions."""
    kept = [
        *_NOMES,
        *("gain_S", "gain_C", "gain_D", "f_gain", "f_rate", "f_period", "p", "apart"),
        *("passed_gain", "passed_rate", "passed_period", "passed_0"),
        *near.COEFFICIENTS,
    ]
    constants = Function(
        "_imaginary_constants",
        "Constants of the elapsed time for m > 1/2, from `_moduli`.",
        _GIVEN,
        tuple(_constants()),
        (*_SPLIT, *_BEYOND, *kept),
        frozenset(_GIVEN),
        frozenset(_SPLIT),
        rounds=True,
    )
    timed = ("w", "p2", "y", "side", "flip", "periods", *_PHASE)
    angles = Function(
        "_imaginary_angles",
        "Angles of the elapsed time t + t_lo for m > 1/2.",
        ("t", "t_lo", *flat(_SPLIT), *_BEYOND),
        tuple(_angles()),
        timed,
    )
    state = Function(
        "_imaginary_state",
        "S_t, C_t, D_t, E_t, D_t F_t and the integral over the phase for m > 1/2.",
        (*timed, "t", *kept),
        tuple(_state()),
        (*ELAPSED, *PASSED),
    )
    return constants, angles, state


def _constants() -> list[Let]:
    return [
        let("ratio = _root_ratio(complement, modulus)", "DLMF 20.9.1"),
        let("root_nome = complement/ratio", "DLMF 20.9.1"),
        let("nome2 = root_nome*root_nome", "DLMF 20.9.1"),
        *_powers(),
        *_at_zero(),
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
        *near.coefficients(),
    ]


def _exponentials(z: str, period_lo: str) -> list[Let]:
    """State the sign, e^(-2 |z|) and its mirror in the period, to all digits of z + z_lo."""
    return [
        let(f"{z}_side = choose(0, {z}, 1, -1)", "DLMF 20.2.1", _SQUARE),
        let(f"{z}_depth = 2*size({z})", _SQUARE),
        let(f"{z}_more = 2*({z}_side*{z}_lo)", _SQUARE),
        let(f"{z}_w2 = exp(-{z}_depth)*(1 - {z}_more)", _SQUARE),
        let(f"{z}_p2 = exp({z}_depth - period_far)*(1 + ({z}_more - {period_lo}))", _SQUARE),
    ]


def _over_phase(z: str, integral: str, whole: str = "") -> list[Let]:
    """State r times the integral of sd^2/lambda^2 from 0 to z, by `_exponentials`."""
    w2, p2 = f"{z}_w2", f"{z}_p2"
    linear = f"{whole}*passed_period - passed_rate*{z}" if whole else f"-passed_rate*{z}"
    return [
        let(f"{z}_rise = {_rise(w2, p2)}", _ZETA),
        let(f"{z}_theta = {_third_theta(w2, p2)}", "DLMF 20.2.3"),
        let(f"{integral} = passed_gain*{z}_side*({z}_rise/({w2}*{z}_theta)) + ({linear})", _ZETA),
    ]


def _rise(w2: str, p2: str) -> str:
    return (
        f"(1 - {w2}*{w2})/2 + (nome4*{p2} - nome6*({w2}*{w2}*{w2}))"
        f" + 3*(nome12*({p2}*{p2}) - nome16*(({w2}*{w2})*({w2}*{w2})))/2"
    )


def _angles() -> list[Let]:
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


def _state() -> list[Let]:
    return [
        let("qw2 = nome2*(w*w)", _SQUARE),
        *_theta_values(),
        let("over = 1/theta2_y"),
        *near.growth(),
        near.root(),
        let(
            f"S_t = choose(growth, {near.NEAR}, S_near, gain_S*(flip*theta1_y*over))",
            "DLMF 22.2.4",
        ),
        let("C_t = gain_C*(flip*theta4_y*over)", "DLMF 22.2.5"),
        let("D_t = gain_D*(theta3_y*over)", "DLMF 22.2.6"),
        let(f"rise = {_rise('w2', 'p2')}", _ZETA),
        let("f_far = f_gain*side*(rise/w)*over + D_t*(periods*f_period - f_rate*y)", _ZETA),
        *near.values(),
        let(f"f = choose(growth, {near.NEAR}, D_t*F_near, f_far)", _ZETA),
        let("E_far = (t - S_t*(C_t/D_t) - apart*f/D_t)/p", facts=("definition elapsed_E.E_t",)),
        let(f"E_t = choose(growth, {near.NEAR}, E_near, E_far)", _ZETA),
        *_over_phase("z", "passed_z", "turns"),
        let("passed = passed_z - passed_0", _ZETA),
        let("turned = size(turns)", _PERIOD),
    ]


def _powers() -> list[Let]:
    """Return lets for the powers of the nome that are used."""
    made = {4: (2, 2), 6: (4, 2), 8: (4, 4), 12: (8, 4), 16: (8, 8), 18: (12, 6), 32: (16, 16)}
    return [let(f"nome{n} = nome{i}*nome{j}", "DLMF 20.2.2") for n, (i, j) in made.items()]


def _at_zero() -> list[Let]:
    """State theta_2, theta_3, theta_4 of zero, the first over 2 q^(1/4)."""
    return [
        let("two = 1 + nome4 + nome12 + nome12*nome12", "DLMF 20.2.2"),
        let("three = 1 + 2*nome2 + 2*nome8 + 2*nome18 + 2*nome32", "DLMF 20.2.3"),
        let("four = 1 - 2*nome2 + 2*nome8 - 2*nome18 + 2*nome32", "DLMF 20.2.4"),
    ]


def _theta_values() -> list[Let]:
    """State theta_1 to theta_4 of i y, over q^(1/4) e^|y|, by w, p2, qw2 and sgn(y)."""
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


def _third_theta(w2: str, p2: str) -> str:
    """Return theta_3 of i z over 2 q^(1/4), by e^(-2 |z|) and its mirror in the period."""
    return f"({_middle(w2, p2)}) + ({_ends(w2, p2)})"


def _ends(w2: str, p2: str) -> str:
    return f"{p2}*(1 + nome12*({p2}*{p2})) + {w2}*(nome2 + nome18*({w2}*{w2}))"


def _middle(w2: str, p2: str) -> str:
    return f"1 + nome4*({p2}*{p2}) + {w2}*{w2}*nome8"
