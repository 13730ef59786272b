"""sn, cn, dn and the integrals of the elapsed time, for m <= 1/2: thetas of real time.

With v = pi u/2K, g = pi/2K and Q the nome of m, the integral of sn^2 is (DLMF 22.16.30)

    (Q/m) (8 g^2 u B(0)/theta_4(0) - 4 g sin 2v A(v)/theta_4(v))
    A(v) = 1 - 4 Q^3 x + 3 Q^8 (4 x^2 - 1),    B(0) = 1 - 4 Q^3 + 9 Q^8,    x = cos 2v

where Q/m is regular at m = 0; B is the slope of sin 2v A, so that all of it vanishes twice at
u = 0.  They leave out 16 Q^15.
"""

from rigidsym._codegen.functions.common import flat
from rigidsym._codegen.functions.sensitivity import near
from rigidsym._codegen.functions.sensitivity.moduli import RESULTS
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.passes import select
from rigidsym._codegen.special_functions import reduction, theta_circular
from rigidsym._codegen.special_functions.polynomials import horner
from rigidsym.solution import Solution

_SPLIT = ("v_rate",)
_FORMS = ("even", "odd", "sine_even", "sine_odd")
_ZETA, _SLOPE = "DLMF 22.16.30", "DLMF 20.2.4"
ELAPSED = ("S_t", "C_t", "D_t", "E_t", "f")
# r times the integral of S_t^2/D_t^2 over the phase, and how many half periods of it there were.
PASSED = ("passed", "turned")


def real(solution: Solution) -> tuple[Function, ...]:
    """State constants, angles and functions."""
    kept = [
        *(name for form in _FORMS for name in theta_circular.names(form)),
        *("gain_S", "gain_C", "gain_D", "E_rate", "slope_0", "slope_1", "slope_2", "p", "apart"),
        *near.COEFFICIENTS,
    ]
    constants = Function(
        "_real_constants",
        "Constants of the elapsed time for m <= 1/2, from `_moduli`.",
        RESULTS,
        tuple(_constants()),
        (*_SPLIT, *kept),
        frozenset(RESULTS),
        frozenset(_SPLIT),
        rounds=True,
    )
    timed = ("sin_v", "cos_v")
    angles = Function(
        "_real_angles",
        "Angles of the elapsed time t + t_lo for m <= 1/2.",
        ("t", "t_lo", *flat(_SPLIT)),
        tuple(_angles()),
        timed,
    )
    state = Function(
        "_real_state",
        "S_t, C_t, D_t, E_t and D_t F_t for m <= 1/2.",
        (*timed, "t", *kept),
        tuple(_state(solution)),
        (*ELAPSED, *PASSED),
    )
    return constants, angles, state


def _constants() -> list[Let]:
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
        *near.coefficients(),
    ]


def _angles() -> list[Let]:
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


def _state(solution: Solution) -> list[Let]:
    slopes = ["slope_0", "slope_1", "slope_2"]
    return [
        *theta_circular.argument(),
        *theta_circular.rate_values(),
        let("over = 1/theta4_v"),
        *near.growth(),
        near.sine("gain_S*(theta1_v*over)"),
        let("C_t = gain_C*(theta2_v*over)", "DLMF 22.2.5"),
        let("D_t = gain_D*(theta3_v*over)", "DLMF 22.2.6"),
        let(f"E_far = E_rate*t - 2*(sin_v*cos_v)*({horner('x', slopes)})*over", _ZETA),
        *near.values(),
        let(f"E_t = choose(growth, {near.NEAR}, E_near, E_far)", _ZETA),
        let("F_far = (t - p*E_t - S_t*(C_t/D_t))/apart", facts=("definition elapsed_F.F_t",)),
        let(f"F_t = choose(growth, {near.NEAR}, F_near, F_far)", _ZETA),
        *select(solution.sequences["sensitivity"], ("f",), ("D_t", "F_t")),
        # No phase is known, and what has passed is not asked for.
        *(let(f"{name} = 0") for name in PASSED),
    ]
