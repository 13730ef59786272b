"""The branch for k_1^2 > 1/2 with the separatrix: thetas of imaginary time, complementary nome."""

from rigidsym.codegen.functions.attitude import (
    at_time,
    constants_function,
    flat,
    from_angles,
    front,
    gains,
    parts,
    secular,
    state_lets,
)
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import GAINS, ROWS
from rigidsym.codegen.passes import select
from rigidsym.codegen.special_functions import reduction, theta_hyperbolic
from rigidsym.solution import Solution
from rigidsym.solution.formulas import INPUTS

_SPLIT = ("y_rate", "y0", "period", "Lambda_rate", "jump")
_BEYOND = ("period_far", "period_inverse")
# What a period along the imaginary axis does to theta_2.
_PERIOD = "DLMF 20.2.7"


def hyperbolic(solution: Solution) -> tuple[Function, ...]:
    """Plan, angles and state."""
    kept = [f"{part}_{n}" for part in ("re", "im") for n in range(theta_hyperbolic.STATE)]
    kept += ["nome", "nome2", "nome4", "nome8", "nome12"]
    timed = ("w", "p", "side", "flip", "X_im", "X_re")
    results = (*_SPLIT, *_BEYOND, *kept, *ROWS, *GAINS)
    return (
        constants_function("hyperbolic", _constants(solution), results, _SPLIT),
        at_time("hyperbolic", _angles(), (*flat(_SPLIT), *_BEYOND), timed),
        from_angles("hyperbolic", _state(solution), timed, (*kept, *ROWS, *GAINS)),
    )


def _constants(solution: Solution) -> list[Let]:
    return [
        *select(solution.sequences["shift"], ("s_beta", "c_beta", "d_beta"), INPUTS["shift"]),
        let("r = _root_ratio(kc_1, k_1)", "DLMF 20.9.1"),
        let("root_nome = kc_1/r", "DLMF 20.9.1"),
        let("nome = root_nome*root_nome", "DLMF 20.9.1"),
        *_descended(),
        let("gc = pi/(2*K_c)", facts=("reading hyperbolic_form.gc",)),
        *theta_hyperbolic.powers(),
        *theta_hyperbolic.multiples(),
        *theta_hyperbolic.zeta(),
        *theta_hyperbolic.coefficients(),
        *theta_hyperbolic.constants(),
        *secular(solution),
        *_phase_at_initial_state(),
        *theta_hyperbolic.values(),
        *front(solution, "hyperbolic_form", "2*theta2_y*watson", "1/sqrt(2*watson)"),
        *gains(solution, {"sn": "three/four", "cn": "two/four", "dn": "two/three"}),
    ]


def _descended() -> list[Let]:
    """beta and the imaginary phase at the bottom of the ladder of the complementary modulus."""
    return [
        # Past K/2 the phase is reflected to K - u: sc(K - u) = cs(u)/k' (DLMF 22.4(iii)).
        let("size_s = size(s)", "DLMF 22.4.3"),
        let("near = rounded(c*c)", "DLMF 22.4.3"),
        let("far = rounded(kc_1*(s*s))", "DLMF 22.4.3"),
        let("above = choose(far, near, size_s, c)", "DLMF 22.4.3"),
        let("below = choose(far, near, c, kc_1*size_s)", "DLMF 22.4.3"),
        let("xi = above/below", "DLMF 22.6.7"),
        let(
            "K_c, sin_a, cos_a, Y_b = _ladder(kc_1, k_1, s_beta, c_beta, d_beta, kc_1, xi)",
            "DLMF 19.8.12",
        ),
    ]


def _phase_at_initial_state() -> list[Let]:
    """y at t = 0, the period of y, and the exponentials there."""
    return [
        # On the separatrix the nome is zero and nothing ever returns.
        let("nome_d = rounded(nome)", "DLMF 20.2.2"),
        let("period = -_logarithm(choose(nome_d, 0, 1, nome))", "DLMF 20.2.2"),
        let("period_far = choose(nome_d, 0, never, rounded(period))", _PERIOD),
        let("period_d = rounded(choose(nome_d, 0, 1, period))", _PERIOD),
        let("period_inverse = choose(nome_d, 0, 0, 1/period_d)", _PERIOD),
        let("cosh_y = sqrt(1 + Y_b*Y_b)", "DLMF 4.35.11"),
        let("y_b = _logarithm(Y_b + cosh_y)", "DLMF 4.37.16"),
        let("y_size = choose(far, near, y_b, period/2 - y_b)", "DLMF 22.4.3"),
        let("side = choose(0, rounded(s), 1, -1)", "DLMF 20.2.1", "DLMF 20.2.2"),
        let("y0 = side*y_size"),
        let("y_rate = mu*gc"),
        let("e_near = 1/((Y_b + cosh_y)*(Y_b + cosh_y))", "DLMF 4.37.16"),
        let("e_far = nome/e_near", "DLMF 20.2.2"),
        let("w = choose(far, near, e_near, e_far)", "DLMF 20.2.2"),
        let("p = choose(far, near, e_far, e_near)", "DLMF 20.2.2"),
        let("alpha = _half_turns(sin_a, cos_a)", "DLMF 4.24.3"),
        let("jump = -2*rho*alpha", _PERIOD),
    ]


def _angles() -> list[Let]:
    return [
        *reduction.product("p_y", "y_rate", extra="y0_lo"),
        let("periods = nearest((p_y + y0_hi)*period_inverse)", _PERIOD),
        *reduction.product("back", "period", "periods", later=False),
        *reduction.total("ahead", "p_y", "-back"),
        *reduction.total("y_near", "ahead", "y0_hi"),
        let("y = y_near + (y_near_error + (ahead_error + (p_y_error - back_error)))", _PERIOD),
        let("side = choose(0, y, 1, -1)", "DLMF 20.2.1", "DLMF 20.2.2"),
        let("flip = alternating(periods)", "DLMF 20.2.6"),
        let("depth = size(2*y)", "DLMF 20.2.2"),
        let("w = exp(-depth)", "DLMF 20.2.2"),
        let("p = exp(depth - period_far)", "DLMF 20.2.2"),
        *reduction.product("L", "Lambda_rate"),
        *reduction.whole("L", "L"),
        *reduction.product("j", "jump", "periods", later=False),
        *reduction.whole("j", "j"),
        *reduction.total("turned", "L_rest", "j_rest"),
        *reduction.whole("turned", "turned"),
        let("turns = turned_rest + (turned_error + (L_error + j_error))", reduction.TURNS),
        let("whole = L_whole + (j_whole + turned_whole)", reduction.TURNS),
        *reduction.sine_and_cosine("L", "turns", "whole", "X_im", "X_re"),
    ]


def _state(solution: Solution) -> list[Let]:
    return [
        *theta_hyperbolic.values(),
        *parts(solution),
        let("over = 1/theta2_y"),
        let("scale = sqrt(over)"),
        *state_lets(("theta3_y", "flip*theta1_y", "flip*theta4_y"), "flip"),
    ]
