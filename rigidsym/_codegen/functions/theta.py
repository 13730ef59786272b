"""Theta form of the solution: the state from theta functions of real or imaginary time.

Imaginary time serves motions near the separatrix.  Factors that do not change with time are
multiplied out beforehand: every component of the attitude is linear in the parts P4 and P1 over N,
and every rate is a constant times a quotient of thetas.
"""

from collections.abc import Iterable

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.functions.common import (
    branch,
    circular_time,
    hyperbolic_time,
    hyperbolic_turns,
    imaginary_phase,
    period_bounds,
    phase,
    phase_at_start,
)
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.names import (
    AMPLITUDES,
    ATTITUDE,
    GAINS,
    PARTS,
    RATES,
    ROWS,
    SIGNS,
)
from rigidsym._codegen.passes import coefficient, inlined, select, specialise
from rigidsym._codegen.special_functions import reduction, theta_circular, theta_hyperbolic
from rigidsym.language._expression import Name, Operation, parse
from rigidsym.solution import Solution
from rigidsym.solution._formulas import AXES

_FRONT = ("p_0", "p_a", "p_b", "p_d")
# What a period along the imaginary axis does to theta_2.
_PERIOD = "DLMF 20.2.7"
_LADDER = "K_c, sin_a, cos_a, Y_b = _ladder(kc_1, k_1, s_beta, c_beta, d_beta, kc_1, xi)"


def secular(solution: Solution) -> list[Let]:
    """Return assignments for the rate Lambda of the phase, in half turns."""
    given = ("psi_0", "rho", "mu", "zeta")
    return [
        *select(solution.sequences["theta"], ("Lambda",), given),
        let("Lambda_rate = Lambda/pi"),
    ]


def parts(solution: Solution) -> tuple[Let, ...]:
    """Return assignments for the theta products: e^(i Lambda t) times theta_4 and theta_1."""
    given = ("X_re", "X_im", "T4_re", "T4_im", "T1_re", "T1_im")
    return select(solution.sequences["circular_state"], PARTS, given)


def front(solution: Solution, form: str, norm: str, share_of_rows: str) -> list[Let]:
    """Return assignments for the constant factors of the attitude.

    They are the left factor, and the rows of q_x = (sum of row times part) * scale.
    """
    sequence = solution.sequences["circular_state"]
    pull_back = solution.sequences["pull_back"]
    bars = tuple(name.replace("q_", "qbar_") for name in ATTITUDE)
    return [
        *specialise(parts(solution), {"X_re": 1, "X_im": 0}),
        let(f"W = {norm}", facts=(f"reading {form}.W",)),
        *select(sequence, ("N",), ("W",)),
        *select(sequence, bars, (*PARTS, "N", *SIGNS)),
        *select(pull_back, _FRONT, (*bars, *ATTITUDE, *SIGNS)),
        let(f"over_N = {share_of_rows}", "DLMF 20.7.14"),
        *_rows(_linear(solution)),
    ]


def _linear(solution: Solution) -> tuple[Let, ...]:
    """Return assignments for the attitude as a linear function of the theta products.

    The products, the parts P4 and P1, are divided by N.
    """
    given = (*_FRONT, *PARTS, "N", *SIGNS)
    return inlined(select(solution.sequences["circular_state"], ATTITUDE, given), ATTITUDE)


def _rows(attitude: Iterable[Let]) -> list[Let]:
    """Return assignments for the matrix of coefficients of theta products, by attitude component.

    The factors are multiplied by over_N.
    """
    rows = []
    for formula in attitude:
        for part in PARTS:
            factor = coefficient(formula.expression, part, PARTS, "N")
            name = f"row_{formula.targets[0][2:]}_{part}"
            expression = Operation("*", Name("over_N"), factor)
            rows.append(Let((name,), expression, formula.source, formula.facts))
    return rows


def _rates(solution: Solution) -> dict[str, Let]:
    """Map each Jacobi function to the rate that is proportional to it."""
    given = ("sn", "cn", "dn", "sigma", "chi", "tau", *AMPLITUDES)
    rates = select(solution.sequences["rates"], RATES, given)
    return dict(zip(("dn", "sn", "cn"), rates, strict=True))


def gains(solution: Solution, scale: dict[str, str]) -> list[Let]:
    """Return assignments for the constant factor of each rate.

    The other factor of a rate is a quotient of thetas (DLMF 22.2.4 to 22.2.6).  `unit` is the power
    of two, in 1/s, by which inner rates are multiplied.
    """
    lets = list(select(solution.sequences["constants"], ("tau",), SIGNS))
    for name, rate in _rates(solution).items():
        (gain,) = specialise([rate], {name: 1})
        quotient = Operation("*", gain.expression, parse(scale[name]))
        product = Operation("*", quotient, Name("unit"))
        target = f"gain_{rate.targets[0][-1]}"
        lets.append(Let((target,), product, (*rate.source, "DLMF 22.2.4"), rate.facts))
    return lets


def state_lets(thetas: tuple[str, str, str], flip: str = "") -> list[Let]:
    """Return assignments that compute attitude and rates from theta functions.

    They use the parts, rows and gains.
    """
    lets = []
    for x in ("0", *AXES):
        first, second, third, fourth = (f"row_{x}_{part}*{part}" for part in PARTS)
        turned = f"{flip}*({third} + {fourth})" if flip else f"({third} + {fourth})"
        lets.append(
            let(
                f"q_{x} = scale*({first} + ({second} + {turned}))",
                facts=(f"definition attitude.q_{x}",),
            )
        )
    for x, theta in zip(AXES, thetas, strict=True):
        lets.append(
            let(
                f"Omega_{x} = gain_{x}*(({theta})*over)",
                facts=(f"definition regular.Omega_{x}",),
            )
        )
    return lets


def circular(solution: Solution, binary: Format = BINARY64) -> tuple[Function, ...]:
    """Build the functions for the constants, angles and state of the circular branch."""
    kept = [
        name
        for form in ("T4_re", "T4_im", "T1_re", "T1_im", "even", "odd", "sine_even", "sine_odd")
        for name in theta_circular.names(form, binary)
    ]
    return branch(
        "circular",
        _circular_constants(solution, binary),
        [
            *circular_time(),
            *reduction.sine_and_cosine("v", "v_turns", "v_whole", "sin_v", "cos_v", binary),
            *phase(binary),
        ],
        [
            *theta_circular.values(binary),
            *parts(solution),
            let("over = 1/theta4_v"),
            let("scale = sqrt(over)"),
            *state_lets(("theta3_v", "theta1_v", "theta2_v")),
        ],
        split=("v_rate", "v", "Lambda_rate"),
        in_angles=(),
        timed=("sin_v", "cos_v", "X_im", "X_re"),
        in_state=(*kept, *ROWS, *GAINS),
    )


def _circular_constants(solution: Solution, binary: Format) -> list[Let]:
    return [
        let("r = _root_ratio(k_1, kc_1)", "DLMF 20.9.1"),
        *select(
            solution.sequences["scaling"], ("root_r", "Q", "Y"), ("r", "k_1", "B_d", "K", "B_a")
        ),
        let("K_1, sin_v, cos_v, Y_b = _ladder(k_1, kc_1, s, c, d, r, Y)", "DLMF 19.8.12"),
        *select(solution.sequences["scaling"], ("h_plus", "h_minus"), ("Q", "Y_b")),
        let("g = pi/(2*K_1)", facts=("reading theta_form.g",)),
        *theta_circular.powers(binary),
        *theta_circular.zeta(binary),
        *theta_circular.coefficients(binary),
        *theta_circular.constants(binary),
        *secular(solution),
        let("v = _half_turns(sin_v, cos_v)", "DLMF 4.24.3"),
        let("v_rate = mu*g/pi"),
        *theta_circular.values(binary),
        *front(solution, "theta_form", "theta4_v*watson", "1/sqrt(watson)"),
        *gains(solution, {"sn": "three/two", "cn": "four/two", "dn": "four/three"}),
    ]


def hyperbolic(solution: Solution, binary: Format = BINARY64) -> tuple[Function, ...]:
    """Build the functions for the constants, angles and state of the hyperbolic branch."""
    kept = [f"{part}_{n}" for part in ("re", "im") for n in range(binary.hyperbolic[0])]
    kept += theta_hyperbolic.kept(binary)
    return branch(
        "hyperbolic",
        _hyperbolic_constants(solution, binary),
        _hyperbolic_angles(binary),
        [
            *theta_hyperbolic.values(binary),
            *parts(solution),
            let("over = 1/theta2_y"),
            let("scale = sqrt(over)"),
            *state_lets(("theta3_y", "flip*theta1_y", "flip*theta4_y"), "flip"),
        ],
        split=("y_rate", "y0", "period", "Lambda_rate", "jump"),
        in_angles=("period_far", "period_inverse"),
        timed=("w", "p", "side", "flip", "X_im", "X_re"),
        in_state=(*kept, *ROWS, *GAINS),
    )


def _hyperbolic_constants(solution: Solution, binary: Format) -> list[Let]:
    return [
        *select(solution.sequences["shift"], ("s_beta", "c_beta", "d_beta"), ()),
        let("r = _root_ratio(kc_1, k_1)", "DLMF 20.9.1"),
        let("root_nome = kc_1/r", "DLMF 20.9.1"),
        let("nome = root_nome*root_nome", "DLMF 20.9.1"),
        *imaginary_phase(_LADDER),
        let("gc = pi/(2*K_c)", facts=("reading hyperbolic_form.gc",)),
        *theta_hyperbolic.powers(),
        *theta_hyperbolic.multiples(binary),
        *theta_hyperbolic.zeta(binary),
        *theta_hyperbolic.coefficients(binary),
        *theta_hyperbolic.constants(binary),
        *secular(solution),
        *_phase_at_initial_state(),
        *theta_hyperbolic.values(binary),
        *front(solution, "hyperbolic_form", "2*theta2_y*watson", "1/sqrt(2*watson)"),
        *gains(solution, {"sn": "three/four", "cn": "two/four", "dn": "two/three"}),
    ]


def _phase_at_initial_state() -> list[Let]:
    """Return assignments for the phase y and its exponentials at t = 0, and for its period."""
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


def _hyperbolic_angles(binary: Format) -> list[Let]:
    return [
        *hyperbolic_time(_PERIOD),
        let("side = choose(0, y, 1, -1)", "DLMF 20.2.1", "DLMF 20.2.2"),
        let("flip = alternating(periods)", "DLMF 20.2.6"),
        let("depth = size(2*y)", "DLMF 20.2.2"),
        let("w = exp(-depth)", "DLMF 20.2.2"),
        let("p = exp(depth - period_far)", "DLMF 20.2.2"),
        *hyperbolic_turns(),
        *reduction.sine_and_cosine("L", "turns", "whole", "X_im", "X_re", binary),
    ]
