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
from rigidsym.codegen.functions.reduced_time import (
    hyperbolic_time,
    hyperbolic_turns,
    imaginary_phase,
    period_bounds,
    phase_at_start,
)
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import GAINS, ROWS
from rigidsym.codegen.passes import select
from rigidsym.codegen.special_functions import reduction, theta_hyperbolic
from rigidsym.solution import Solution

_SPLIT = ("y_rate", "y0", "period", "Lambda_rate", "jump")
_BEYOND = ("period_far", "period_inverse")
# What a period along the imaginary axis does to theta_2.
_PERIOD = "DLMF 20.2.7"
_LADDER = "K_c, sin_a, cos_a, Y_b = _ladder(kc_1, k_1, s_beta, c_beta, d_beta, kc_1, xi)"


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
        *select(solution.sequences["shift"], ("s_beta", "c_beta", "d_beta"), ()),
        let("r = _root_ratio(kc_1, k_1)", "DLMF 20.9.1"),
        let("root_nome = kc_1/r", "DLMF 20.9.1"),
        let("nome = root_nome*root_nome", "DLMF 20.9.1"),
        *imaginary_phase(_LADDER),
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


def _phase_at_initial_state() -> list[Let]:
    """y at t = 0, the period of y, and the exponentials there."""
    return [
        # On the separatrix the nome is zero and nothing ever returns.
        let("nome_d = rounded(nome)", "DLMF 20.2.2"),
        let("period = -_logarithm(choose(nome_d, 0, 1, nome))", "DLMF 20.2.2"),
        *period_bounds("nome_d", _PERIOD),
        *phase_at_start("DLMF 20.2.1", "DLMF 20.2.2"),
        let("e_near = 1/((Y_b + cosh_y)*(Y_b + cosh_y))", "DLMF 4.37.16"),
        let("e_far = nome/e_near", "DLMF 20.2.2"),
        let("w = choose(far, near, e_near, e_far)", "DLMF 20.2.2"),
        let("p = choose(far, near, e_far, e_near)", "DLMF 20.2.2"),
        let("alpha = _half_turns(sin_a, cos_a)", "DLMF 4.24.3"),
        let("jump = -2*rho*alpha", _PERIOD),
    ]


def _angles() -> list[Let]:
    return [
        *hyperbolic_time(_PERIOD),
        let("side = choose(0, y, 1, -1)", "DLMF 20.2.1", "DLMF 20.2.2"),
        let("flip = alternating(periods)", "DLMF 20.2.6"),
        let("depth = size(2*y)", "DLMF 20.2.2"),
        let("w = exp(-depth)", "DLMF 20.2.2"),
        let("p = exp(depth - period_far)", "DLMF 20.2.2"),
        *hyperbolic_turns(),
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
