"""The branch for k_1^2 <= 1/2: the mean slope of the third kind goes into the rate of psi."""

from rigidsym.codegen.functions.pi.common import HALF, LEVELS, ascent, branch, front, moduli
from rigidsym.codegen.functions.reduced_time import circular_time
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.passes import renamed, select, specialise
from rigidsym.codegen.special_functions import reduction
from rigidsym.solution import Solution

_SPLIT = ("v_rate", "v", "Lambda_rate")
_MODULI = tuple(f"k_{n}" for n in range(2, LEVELS + 1))
_KEPT = (*_MODULI, "characteristic", "spread", "kappa", "j", "two_K", "rest_0")
_THIRD = "DLMF 19.25.14"
# 2 K_1 later J has grown by 2 J_c (DLMF 19.2.7), and J - j u_1 is what it was.
_WINDING = "DLMF 19.2.7"


def circular(solution: Solution) -> tuple[Function, ...]:
    """Plan, angles and state."""
    return branch("circular", solution, _constants(solution), _angles(solution), _KEPT, _SPLIT)


def _constants(solution: Solution) -> list[Let]:
    psi = solution.sequences["pi_circular"]
    return [
        *moduli(solution, "k", "kc"),
        # The ladder's shift is the theta form's: here it is none.
        let("K_1, sin_v, cos_v, shift = _ladder(k_1, kc_1, s, c, d, k_1, 0)", "DLMF 19.8.12"),
        let("v = _half_turns(sin_v, cos_v)", "DLMF 4.24.3"),
        let("two_K = 2*K_1", "DLMF 22.4(i)"),
        let("v_rate = mu/two_K"),
        let("u_start = two_K*v"),
        let("quarter, total = _complete(kc_1, 1 - n)", "DLMF 19.8.6"),
        let("characteristic = n"),
        let("j = total/(2*(1 - n))", "DLMF 19.8.6"),
        *select(psi, ("Lambda",), ("psi_0", "kappa", "mu", "j")),
        let("Lambda_rate = Lambda/pi"),
        let("spread = -n*(1 - n)*(k_1*k_1 - n)", "DLMF 19.36.1"),
        let("path = rounded(1 - n*(s*s))", _THIRD),
        let("J_0 = _third_kind(rounded(s), rounded(c), rounded(d), path, rounded(spread))", _THIRD),
        *renamed(select(psi, ("rest_0",), ("kappa", "J_0", "j", "phase")), {"phase": "u_start"}),
        *specialise(front(solution), dict(zip(HALF, (1, 0), strict=True))),
    ]


def _angles(solution: Solution) -> list[Let]:
    bottom = f"s_{LEVELS}", f"c_{LEVELS}"
    return [
        *circular_time(),
        # What rounding has left may be past a quarter period, where J is another.
        *reduction.whole("w", "v_turns"),
        let("half_periods = v_whole + w_whole", reduction.TURNS),
        *reduction.sine_and_cosine("w", "w_rest", "half_periods", *bottom),
        *ascent(solution, "k", ("s", "c", "d")),
        let("path = 1 - characteristic*(s*s)", _THIRD),
        let("J = w_sign*_third_kind(s, size(c), d, path, spread)", _THIRD),
        let("u_1 = two_K*w_rest", _WINDING),
        *select(solution.sequences["pi_circular"], ("rest",), ("kappa", "J", "j", "u_1")),
        *reduction.product("L", "Lambda_rate"),
        *reduction.whole("L", "L"),
        let("psi_turns = L_rest + (L_error + (rest - rest_0)/pi_hi)"),
        *reduction.whole("psi", "psi_turns"),
        let("whole = L_whole + psi_whole", reduction.TURNS),
        *reduction.sine_and_cosine("psi", "psi_rest", "whole", "X_im", "X_re"),
    ]
