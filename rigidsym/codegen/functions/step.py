"""One step from any state: what the body alone decides, the start, doublings, and the end; kicks.

Times begin at t/2^STEPS, where series are short, and are doubled.  What angles and rates grow from
is extended; what only corrects them is not.
"""

from rigidsym.codegen.functions.attitude import phase
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import ATTITUDE, DIFFERENCES, INERTIA, RATES
from rigidsym.codegen.passes import renamed, select, specialise
from rigidsym.codegen.special_functions import short_time
from rigidsym.solution import Solution

ALPHAS = ("alpha_a", "alpha_b", "alpha_d")
SQUARES = ("l_a", "l_b", "l_d")
STARTS = ("Omega_a0", "Omega_b0", "Omega_d0")
# A torque is found from the attitude, a vector in space, and coefficients.
KICK = (
    *(f"q{k}" for k in range(4)),
    *(f"{x}{k}" for x in "ub" for k in range(1, 4)),
    *("k", "m1", "m2", "m3", "Q11", "Q22", "Q33", "Q23", "Q13", "Q12"),
)
TORQUE = ("T1", "T2", "T3")
_FRONT = ("p_0", "p_a", "p_b", "p_d")
_PROJECTED = ("z_re", "z_im", "zr_re", "zr_im")
_HALF = {"cos_half_psi": "turn_re", "sin_half_psi": "turn_im"}


def step(solution: Solution) -> tuple[Function, ...]:
    """All functions of a step, in the order in which they are used."""
    return (
        _body(solution),
        _start(solution),
        _first(solution),
        _doubled(solution),
        _projected(solution),
        _second_half(solution),
        _rates(solution),
        _front(solution),
        _attitude(solution),
        _kick(solution),
    )


def _function(
    name: str, summary: str, given: str, extended: str, lets, results, split=""
) -> Function:
    parameters = (*extended.split(), *given.split())
    return Function(
        f"_step_{name}",
        summary,
        parameters,
        tuple(lets),
        tuple(results),
        frozenset(extended.split()),
        frozenset(split.split()),
        rounds=True,
    )


def _body(solution: Solution) -> Function:
    """What is of the body alone."""
    given = (*INERTIA, *DIFFERENCES, "epsilon")
    results = (*ALPHAS, *SQUARES)
    lets = select(solution.sequences["step"], results, given)
    extended = " ".join((*INERTIA, *DIFFERENCES))
    summary = "The coefficients of Euler's equations, and their products."
    return _function("body", summary, "epsilon", extended, lets, results, " ".join(results))


def _start(solution: Solution) -> Function:
    """Momentum, frequencies, the rate of psi, X and Y at the shortest time."""
    given = (*INERTIA, *SQUARES, *STARTS, "sigma")
    names = ("h", "e_1", "e_2", "K", "psi_0")
    lets = [
        *select(solution.sequences["step"], names, given),
        let("Lambda_rate = psi_0/(2*pi)"),
        let(f"first_t = t*(1/{2**short_time.STEPS})"),
        *short_time.elapsed(),
    ]
    extended = " ".join((*INERTIA, *SQUARES, *STARTS))
    split = "h e_1 e_2 K Lambda_rate X Y"
    summary = "Momentum, frequencies and rate of psi; X and Y at the shortest of times."
    return _function("start", summary, "t sigma", extended, lets, split.split(), split)


def _first(solution: Solution) -> Function:
    """The projection of the momentum, and psi at the shortest time, but for its own rate."""
    given = ("K", *INERTIA, *DIFFERENCES, *STARTS, "epsilon", "sigma")
    turned = select(
        solution.sequences["thirds"],
        ("R", "N", "cos_half_psi", "sin_half_psi"),
        ("G_re", "G_im", "T_re", "T_im", "E_re", "E_im"),
    )
    lets = [
        *select(solution.sequences["step"], _PROJECTED, given),
        *select(
            solution.sequences["projection"],
            ("nu_re", "nu_im", "rate_re", "rate_im", "G_re", "G_im"),
            ("h", *_PROJECTED, "X"),
        ),
        *short_time.third_kind(),
        *renamed(
            specialise(turned, {"T_re": 1, "T_im": 0}),
            {"cos_half_psi": "W_re", "sin_half_psi": "W_im"},
        ),
    ]
    names = " ".join(("K", "h", "e_1", "e_2", "X", *INERTIA, *DIFFERENCES, *STARTS))
    results = (*_PROJECTED, "W_re", "W_im")
    summary = "The momentum's projection; psi/2 at the shortest time less what grows with it."
    return _function("first", summary, f"{names} epsilon sigma", "", lets, results)


def _doubled(solution: Solution) -> Function:
    lets = select(solution.sequences["doubling"], ("X_next", "Y_next"), ("X", "Y", "e_1", "e_2"))
    results = ("X_next", "Y_next")
    summary = "X and Y at twice the time."
    return _function("doubled", summary, "", "X Y e_1 e_2", lets, results, "X_next Y_next")


def _projected(solution: Solution) -> Function:
    given = ("h", *_PROJECTED, "X", "Y")
    lets = select(solution.sequences["projection"], ("w_re", "w_im"), given)
    summary = "The momentum's projection at the time of X and Y."
    return _function("projected", summary, " ".join(given), "", lets, ("w_re", "w_im"))


def _second_half(solution: Solution) -> Function:
    """Angles of both halves add up."""
    factor = select(solution.sequences["projection"], ("G_re", "G_im"), ("h", "z_re", "z_im", "X"))
    sum_of_angles = select(
        solution.sequences["thirds"], ("P_re", "P_im"), ("T_re", "T_im", "E_re", "E_im")
    )
    both = {"T_re": "W_re", "T_im": "W_im", "E_re": "V_re", "E_im": "V_im"}
    lets = [
        *renamed(factor, {"z_re": "w_re", "z_im": "w_im"}),
        *select(
            solution.sequences["second_half"],
            ("R", "V_re", "V_im"),
            ("G_re", "G_im", "W_re", "W_im"),
        ),
        *renamed(sum_of_angles, both | {"P_re": "W_next_re", "P_im": "W_next_im"}),
    ]
    results = ("W_next_re", "W_next_im")
    summary = "Half of psi at twice the time, but for what grows with it."
    return _function("second_half", summary, "h X w_re w_im W_re W_im", "", lets, results)


def _rates(solution: Solution) -> Function:
    given = ("X", "Y", "h", *ALPHAS, "l_d", *STARTS)
    lets = select(solution.sequences["step_rates"], RATES, given)
    return _function("rates", "The rates after the step.", "", " ".join(given), lets, RATES)


def _front(solution: Solution) -> Function:
    """The unit quaternion in front, from the attitude where psi is 0."""
    given = ("K", "epsilon", "sigma", *_HALF, *INERTIA, *RATES, *ATTITUDE)
    lets = specialise(
        select(solution.sequences["constants"], _FRONT, given),
        dict(zip(_HALF, (1, 0), strict=True)),
    )
    starts = dict(zip(RATES, STARTS, strict=True))
    names = " ".join(("K", *INERTIA, *STARTS, *ATTITUDE))
    summary = "The quaternion in front of the attitude by psi and the shortest rotation."
    return _function("front", summary, f"{names} epsilon sigma", "", renamed(lets, starts), _FRONT)


def _attitude(solution: Solution) -> Function:
    """psi/2 by its start's rate and the rest, and the attitude."""
    given = ("K", "epsilon", "sigma", *_HALF, *INERTIA, *RATES, *_FRONT)
    sum_of_angles = select(
        solution.sequences["thirds"], ("P_re", "P_im"), ("T_re", "T_im", "E_re", "E_im")
    )
    both = {"T_re": "X_re", "T_im": "X_im", "E_re": "W_re", "E_im": "W_im"}
    both |= {"P_re": "turn_re", "P_im": "turn_im"}
    lets: list[Let] = [
        *specialise(phase(), {"t_lo": 0}),
        *renamed(sum_of_angles, both),
        *renamed(select(solution.sequences["state"], ATTITUDE, given), _HALF),
    ]
    names = " ".join(("K", *INERTIA, *RATES, *_FRONT))
    timed = "t Lambda_rate_hi Lambda_rate_lo W_re W_im"
    summary = "The attitude after the step."
    return _function("attitude", summary, f"{timed} {names} epsilon sigma", "", lets, ATTITUDE)


def _kick(solution: Solution) -> Function:
    """On the axes of the body as they are given."""
    lets = select(solution.sequences["kick"], TORQUE, KICK)
    summary = "The torque of what a vector in space exerts, and of what stays in the body."
    return _function("kick", summary, " ".join(KICK), "", lets, TORQUE)
