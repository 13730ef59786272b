"""The branch for k_1^2 <= 1/2: thetas of real time in the nome of m."""

from rigidsym.codegen.functions.attitude import (
    at_time,
    constants_function,
    flat,
    from_angles,
    front,
    gains,
    parts,
    phase,
    secular,
    state_lets,
)
from rigidsym.codegen.functions.reduced_time import circular_time
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import GAINS, ROWS
from rigidsym.codegen.passes import select
from rigidsym.codegen.special_functions import reduction, theta_circular
from rigidsym.solution import Solution

_SPLIT = ("v_rate", "v", "Lambda_rate")


def circular(solution: Solution) -> tuple[Function, ...]:
    """Plan, angles and state."""
    kept = [
        name
        for form in ("T4_re", "T4_im", "T1_re", "T1_im", "even", "odd", "sine_even", "sine_odd")
        for name in theta_circular.names(form)
    ]
    timed = ("sin_v", "cos_v", "X_im", "X_re")
    return (
        constants_function(
            "circular", _constants(solution), (*_SPLIT, *kept, *ROWS, *GAINS), _SPLIT
        ),
        at_time("circular", _angles(), flat(_SPLIT), timed),
        from_angles("circular", _state(solution), timed, (*kept, *ROWS, *GAINS)),
    )


def _constants(solution: Solution) -> list[Let]:
    return [
        let("r = _root_ratio(k_1, kc_1)", "DLMF 20.9.1"),
        *select(
            solution.sequences["scaling"], ("root_r", "Q", "Y"), ("r", "k_1", "B_d", "K", "B_a")
        ),
        let("K_1, sin_v, cos_v, Y_b = _ladder(k_1, kc_1, s, c, d, r, Y)", "DLMF 19.8.12"),
        *select(solution.sequences["scaling"], ("h_plus", "h_minus"), ("Q", "Y_b")),
        let("g = pi/(2*K_1)", facts=("reading theta_form.g",)),
        *theta_circular.powers(),
        *theta_circular.zeta(),
        *theta_circular.coefficients(),
        *theta_circular.constants(),
        *secular(solution),
        let("v = _half_turns(sin_v, cos_v)", "DLMF 4.24.3"),
        let("v_rate = mu*g/pi"),
        *theta_circular.values(),
        *front(solution, "theta_form", "theta4_v*watson", "1/sqrt(watson)"),
        *gains(solution, {"sn": "three/two", "cn": "four/two", "dn": "four/three"}),
    ]


def _angles() -> list[Let]:
    return [
        *circular_time(),
        *reduction.sine_and_cosine("v", "v_turns", "v_whole", "sin_v", "cos_v"),
        *phase(),
    ]


def _state(solution: Solution) -> list[Let]:
    return [
        *theta_circular.values(),
        *parts(solution),
        let("over = 1/theta4_v"),
        let("scale = sqrt(over)"),
        *state_lets(("theta3_v", "theta1_v", "theta2_v")),
    ]
