"""One step from any state: constants of the body, the start, doublings, and the end; kicks.

Start at t/2^STEPS, where short series suffice, then double.  Numbers that angles and rates grow
from are extended.  Corrections of them are doubles, except in the last doublings: for thin bodies
the share taken from psi there is ten times as wrong as the numbers it is made from.  The shortest
rotations are extended until they are complete.
"""

from rigidsym._codegen.functions.common import phase
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.names import ATTITUDE, DIFFERENCES, INERTIA, RATES
from rigidsym._codegen.passes import renamed, select, specialise
from rigidsym._codegen.special_functions import short_time
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
_SHORTEST = ("s_0", "s_b", "s_d")
# The projection in the last doublings, which is extended.
_LAST = {"w_re": "v_re", "w_im": "v_im"}
_HALF = {"cos_half_psi": "turn_re", "sin_half_psi": "turn_im"}


def step(solution: Solution) -> tuple[Function, ...]:
    """Return all functions of a step, in the order in which they are used."""
    return (
        _body(solution),
        _start(solution),
        _first(solution),
        _doubled(solution),
        _projected(solution),
        _second_half(solution),
        _last_projected(solution),
        _last_second_half(solution),
        _rates(solution),
        _shortest_before(solution),
        _front(solution),
        _shortest(solution),
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
    """State the quantities that depend on the body alone."""
    given = (*INERTIA, *DIFFERENCES, "epsilon")
    results = (*ALPHAS, *SQUARES)
    lets = select(solution.sequences["step"], results, given)
    extended = " ".join((*INERTIA, *DIFFERENCES))
    summary = "The coefficients of Euler's equations, and their products."
    return _function("body", summary, "epsilon", extended, lets, results, " ".join(results))


def _start(solution: Solution) -> Function:
    """State momentum, projection, frequencies and psi's rate; X and Y at the shortest time."""
    given = (*INERTIA, *SQUARES, *STARTS, "epsilon", "sigma")
    names = ("h", "e_1", "e_2", "K", "psi_0", *_PROJECTED)
    lets = [
        *select(solution.sequences["step"], names, given),
        let("Lambda_rate = psi_0/(2*pi)"),
        let(f"first_t = t*(1/{2**short_time.STEPS})"),
        *short_time.elapsed(),
    ]
    extended = " ".join((*INERTIA, *SQUARES, *STARTS))
    split = " ".join(("h e_1 e_2 K Lambda_rate X Y", *_PROJECTED))
    summary = "Momentum, its projection, frequencies, rate of psi; X and Y at the shortest time."
    return _function("start", summary, "t epsilon sigma", extended, lets, split.split(), split)


def _first(solution: Solution) -> Function:
    """State psi at the shortest time, without its own rate."""
    turned = select(
        solution.sequences["thirds"],
        ("R", "N", "cos_half_psi", "sin_half_psi"),
        ("G_re", "G_im", "T_re", "T_im", "E_re", "E_im"),
    )
    lets = [
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
    names = " ".join(("h", "e_1", "e_2", "X", *_PROJECTED))
    summary = "psi/2 at the shortest time, without its linear part."
    return _function("first", summary, names, "", lets, ("W_re", "W_im"))


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


def _last_projected(solution: Solution) -> Function:
    given = ("h", *_PROJECTED, "X", "Y")
    lets = select(solution.sequences["projection"], tuple(_LAST), given)
    summary = "The momentum's projection in extended precision, for the last doublings."
    results = tuple(_LAST.values())
    names = " ".join(given), renamed(lets, _LAST)
    return _function("last_projected", summary, "", *names, results, " ".join(results))


def _second_half(solution: Solution) -> Function:
    lets, results = _both_halves(solution, ("w_re", "w_im"))
    summary = "psi/2 at twice the time, without its linear part."
    return _function("second_half", summary, "h X w_re w_im W_re W_im", "", lets, results)


def _last_second_half(solution: Solution) -> Function:
    lets, results = _both_halves(solution, tuple(_LAST.values()))
    summary = "psi/2 at twice the time from extended numbers, for the last doublings."
    return _function("last_second_half", summary, "W_re W_im", "h X v_re v_im", lets, results)


def _both_halves(
    solution: Solution, projected: tuple[str, ...]
) -> tuple[list[Let], tuple[str, ...]]:
    """Add the angles of both halves; return the lets, and the names of the sum."""
    factor = select(solution.sequences["projection"], ("G_re", "G_im"), ("h", "z_re", "z_im", "X"))
    sum_of_angles = select(
        solution.sequences["thirds"], ("P_re", "P_im"), ("T_re", "T_im", "E_re", "E_im")
    )
    both = {"T_re": "W_re", "T_im": "W_im", "E_re": "V_re", "E_im": "V_im"}
    lets = [
        *renamed(factor, dict(zip(("z_re", "z_im"), projected, strict=True))),
        *select(
            solution.sequences["second_half"],
            ("R", "V_re", "V_im"),
            ("G_re", "G_im", "W_re", "W_im"),
        ),
        *renamed(sum_of_angles, both | {"P_re": "W_next_re", "P_im": "W_next_im"}),
    ]
    return lets, ("W_next_re", "W_next_im")


def _rates(solution: Solution) -> Function:
    given = ("X", "Y", "h", *ALPHAS, "l_d", *STARTS)
    lets = select(solution.sequences["step_rates"], RATES, given)
    after, split = "The rates after the step.", " ".join(RATES)
    return _function("rates", after, "", " ".join(given), lets, RATES, split)


def _shortest_before(solution: Solution) -> Function:
    summary = "The shortest rotation that takes the momentum at the start to its axis."
    lets = renamed(_shortest_lets(solution), dict(zip(RATES, STARTS, strict=True)))
    return _shortest_of("shortest_before", summary, STARTS, lets)


def _shortest(solution: Solution) -> Function:
    summary = "The shortest rotation that takes the momentum after the step to its axis."
    return _shortest_of("shortest", summary, RATES, _shortest_lets(solution))


def _shortest_lets(solution: Solution) -> tuple[Let, ...]:
    given = ("K", "epsilon", "sigma", *INERTIA, *RATES)
    return select(solution.sequences["state"], _SHORTEST, given)


def _shortest_of(name: str, summary: str, rates: tuple[str, ...], lets) -> Function:
    given = " ".join((*INERTIA, "epsilon", "sigma"))
    return _function(name, summary, given, " ".join(("K", *rates)), lets, _SHORTEST)


def _front(solution: Solution) -> Function:
    """State the unit quaternion in front, by the attitude where psi is 0."""
    given = ("epsilon", "sigma", *_HALF, *_SHORTEST, *ATTITUDE)
    lets = specialise(
        select(solution.sequences["constants"], _FRONT, given),
        dict(zip(_HALF, (1, 0), strict=True)),
    )
    names = " ".join((*_SHORTEST, *ATTITUDE, "epsilon"))
    summary = "The constant left factor of the attitude."
    return _function("front", summary, names, "", lets, _FRONT)


def _attitude(solution: Solution) -> Function:
    """State psi/2, by its rate at the start and the rest, and the attitude."""
    given = ("epsilon", "sigma", *_HALF, *_SHORTEST, *_FRONT)
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
    names = " ".join((*_SHORTEST, *_FRONT))
    timed = "t Lambda_rate_hi Lambda_rate_lo W_re W_im"
    summary = "The attitude after the step."
    return _function("attitude", summary, f"{timed} {names} epsilon sigma", "", lets, ATTITUDE)


def _kick(solution: Solution) -> Function:
    """State the torque on the axes of the body as they are given."""
    lets = select(solution.sequences["kick"], TORQUE, KICK)
    summary = "The torque that a vector in space exerts, and a torque fixed in the body."
    return _function("kick", summary, " ".join(KICK), "", lets, TORQUE)
