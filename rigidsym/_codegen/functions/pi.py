"""Pi form of the solution: the angle psi from one elliptic integral of the third kind.

It has no theta function.

For k_1^2 <= 1/2 the mean slope of that integral is part of the rate of psi.  For larger moduli, up
to the separatrix, psi is measured from the saddle.  There u_1 is measured from the nearest crossing
of the middle axis' plane, up to half a quarter period; beyond that, where the motion rests near the
saddle, it is measured from the saddle.
"""

from collections.abc import Iterable, Mapping

from rigidsym._codegen.functions.common import (
    branch,
    circular_time,
    hyperbolic_time,
    hyperbolic_turns,
    imaginary_phase,
    period_bounds,
    phase_at_start,
)
from rigidsym._codegen.ir import Constant, Function, Let, let
from rigidsym._codegen.names import AMPLITUDES, ATTITUDE, INERTIA, RATES
from rigidsym._codegen.passes import renamed, select, specialise
from rigidsym._codegen.special_functions import landen, reduction
from rigidsym.solution import Solution

# Landen's levels, from a state's down to where functions are elementary.
LEVELS = landen.STATE_STEPS + 1
FRONT = ("p_0", "p_a", "p_b", "p_d")
# As in the theta form, sines and cosines come in rows before the rest.
TIMED = ("s", "c", "X_im", "X_re", "d")
# The names of rates in the unit of time that motions are computed in.
INNER = {rate: f"inner_{rate[-1]}" for rate in RATES}
# Those of the cosine and sine of psi/2.
HALF = {"cos_half_psi": "X_re", "sin_half_psi": "X_im"}
# What a state is made of beside what changes with time.
KEPT = (*INERTIA, *AMPLITUDES, "K", "k_1", "k_c", "epsilon", "sigma", "chi", "tau", *FRONT, "unit")
# What the plans take from `_initial_state`.
GIVEN = ("K", *AMPLITUDES, "B_a", "B_d", "k_c", "k_1", "kc_1", "m_c", "mu", "psi_0")
GIVEN += ("n", "kappa", "H", "s", "c", "d")
_CIRCULAR_SPLIT = ("v_rate", "v", "Lambda_rate")
_CIRCULAR_MODULI = tuple(f"k_{n}" for n in range(2, LEVELS + 1))
_CIRCULAR_KEPT = (*_CIRCULAR_MODULI, "characteristic", "spread", "kappa", "j", "two_K", "rest_0")
# 2 K_1 later J has grown by 2 J_c (DLMF 19.2.7), and J - j u_1 is what it was.
_WINDING = "DLMF 19.2.7"
_HYPERBOLIC_SPLIT = ("y_rate", "y0", "period", "Lambda_rate", "jump")
_HYPERBOLIC_MODULI = tuple(f"l_{n}" for n in range(2, LEVELS + 1))
_HYPERBOLIC_COEFFICIENTS = ("g_1", "g_2", "h_2", "alpha", "delta", "spread", "slope")
_HYPERBOLIC_COEFFICIENTS += ("z", "characteristic")
_HYPERBOLIC_KEPT = ("period_far", "period_inverse", *_HYPERBOLIC_MODULI, "gc", "kc_1", "m_c", "rho")
_HYPERBOLIC_KEPT += (*_HYPERBOLIC_COEFFICIENTS, "start_rest")
_LADDER = "K_c, sin_b, cos_b, Y_b = _ladder(kc_1, k_1, 0, 1, 1, kc_1, xi)"
_THIRD = "DLMF 19.25.14"
# sn, cn and dn of K - u by those of u, and back.
_REFLECTED = "DLMF 22.4(iii)"
_HALF_PERIOD = "DLMF 22.4(i)"
# s, c and d at the nearer end, and n.
NEAR = {"s": "near_s", "c": "near_c", "d": "near_d", "n": "characteristic"}
# The two parts of psi/2 that a state turns by.
PARTS = {"X_re": "turn_re", "X_im": "turn_im", "T_re": "arc_re", "T_im": "arc_im"}


def level(name: str, n: int) -> str:
    """Return the name of a quantity at level n of Landen's transformation."""
    return name if n == 1 else f"{name}_{n}"


def moduli(solution: Solution, modulus: str, complement: str) -> tuple[Let, ...]:
    """Return assignments that compute the moduli of all lower Landen levels from the first."""
    lets: tuple[Let, ...] = ()
    for n in range(1, LEVELS):
        step = select(solution.sequences["landen"], ("k_next", "kc_next"), ("k", "kc"))
        names = {"k": f"{modulus}_{n}", "k_next": f"{modulus}_{n + 1}", "root_kc": f"root_{n}"}
        names |= {"kc": f"{complement}_{n}", "kc_next": f"{complement}_{n + 1}"}
        lets += renamed(step, names)
    return lets


def ascent(solution: Solution, modulus: str, functions: tuple[str, ...]) -> tuple[Let, ...]:
    """Return assignments that compute Jacobi functions by Landen's ascending transformation.

    They lead from the last level, where dn is 1, to the first.
    """
    lets: tuple[Let, ...] = ()
    for n in reversed(range(1, LEVELS)):
        names = {name: level(name, n) for name in (*functions, "inside")}
        names |= {f"{name}_next": level(name, n + 1) for name in functions}
        step = select(solution.sequences["ascent"], functions, ())
        lets += renamed(step, names | {"k_next": f"{modulus}_{n + 1}"})
    return specialise(lets, {level("d", LEVELS): 1})


def state(solution: Solution) -> tuple[Let, ...]:
    """Return assignments that compute rates and attitude.

    They use s, c, d and the cosine and sine of psi/2.
    """
    given = ("s", "c", "d", *HALF, *KEPT)
    lets = select(solution.sequences["state"], (*ATTITUDE, *RATES), given)
    units = (let(f"{rate} = unit*{INNER[rate]}") for rate in RATES)
    return (*renamed(lets, INNER | HALF), *units)


def front(solution: Solution) -> tuple[Let, ...]:
    """Return assignments for the sign tau and the constant left factor p of the attitude."""
    given = ("K", "epsilon", "sigma", "rho", *HALF, *INERTIA, *RATES, *ATTITUDE)
    return select(solution.sequences["constants"], ("tau", *FRONT), given)


def _branch(
    name: str,
    solution: Solution,
    constants: Iterable[Let],
    angles: Iterable[Let],
    kept: tuple[str, ...],
    split: tuple[str, ...],
) -> tuple[Function, ...]:
    """Build the functions for the constants, angles and state of a branch.

    The state has the same formulas on both branches.
    """
    given = (*GIVEN, *INERTIA, *RATES, *ATTITUDE)
    return branch(
        name,
        constants,
        angles,
        state(solution),
        split=split,
        in_angles=kept,
        timed=TIMED,
        in_state=KEPT,
        given=given,
    )


def circular(solution: Solution) -> tuple[Function, ...]:
    """Build the functions for the constants, angles and state of the circular branch."""
    constants, angles = _circular_constants(solution), _circular_angles(solution)
    return _branch("circular", solution, constants, angles, _CIRCULAR_KEPT, _CIRCULAR_SPLIT)


def _circular_constants(solution: Solution) -> list[Let]:
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


def _circular_angles(solution: Solution) -> list[Let]:
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


def numbers() -> list[Constant]:
    """Return the largest argument of tanh and the least value of sech, as named constants.

    They are `deepest` and `least_c`.
    """
    return [
        Constant("deepest", 100.0, None, "beyond it tanh is 1 and sech is 0"),
        Constant("least_c", 1e-45, None, "stands for sech where that is 0"),
    ]


def hyperbolic(solution: Solution) -> tuple[Function, ...]:
    """Build the functions for the constants, angles and state of the hyperbolic branch."""
    constants, angles = _hyperbolic_constants(solution), _hyperbolic_angles(solution)
    return _branch("hyperbolic", solution, constants, angles, _HYPERBOLIC_KEPT, _HYPERBOLIC_SPLIT)


def _hyperbolic_constants(solution: Solution) -> list[Let]:
    given = ("H", "K", "rho", "k_1", "m_c", "n", "x", "y", "z", "K_1", "j")
    kept = ("Lambda", "delta", "n_2", "g_1", "g_2", "h_2", "slope", "alpha")
    return [
        let("l_1 = kc_1", "DLMF 22.7.1"),
        let("lc_1 = k_1", "DLMF 22.7.1"),
        *moduli(solution, "l", "lc"),
        *select(solution.sequences["shift"], ("x", "y", "z"), ()),
        *imaginary_phase(_LADDER),
        let("gc = pi/(2*K_c)"),
        let("K_1, total = _complete(kc_1, 1 - n)", "DLMF 19.8.6"),
        let("characteristic = n"),
        let("j = total/(2*(1 - n))", "DLMF 19.8.6"),
        *select(solution.sequences["pi_hyperbolic"], kept, given),
        let("Lambda_rate = Lambda/pi"),
        let("spread = n_2*((delta*k_1*x)*(delta*k_1*x))", "DLMF 19.36.1"),
        # On the separatrix the complement is zero and nothing ever returns.
        let("kc_d = rounded(kc_1)", _HALF_PERIOD),
        let("period = choose(kc_d, 0, 0, 2*K_1*gc)", _HALF_PERIOD),
        *period_bounds("kc_d", _HALF_PERIOD),
        *phase_at_start(_HALF_PERIOD),
        let("jump = -2*rho*alpha/pi", "DLMF 19.2.7"),
        *_rest_at_start(),
        *_turn(solution, {}),
        let("start_re = choose(far, near, T_re, 1)"),
        let("start_im = choose(far, near, T_im, 0)"),
        *renamed(front(solution), dict(zip(HALF, ("start_re", "start_im"), strict=True))),
    ]


def _rest_at_start() -> list[Let]:
    """Return assignments for psi/2 at t = 0 without its arctangent part.

    It is measured from the nearer end of the quarter period.
    """
    return [
        let("near_s = rounded(choose(far, near, size_s, c/d))", _REFLECTED),
        let("near_c = rounded(choose(far, near, c, kc_1*size_s/d))", _REFLECTED),
        let("near_d = rounded(choose(far, near, d, kc_1/d))", _REFLECTED),
        let("cosine = choose(near_c, least_c, least_c, near_c)", _REFLECTED),
        let("path = cosine*cosine + rounded(delta)*(near_s*near_s)", _THIRD),
        let("third = _third_kind(near_s, cosine, near_d, path, rounded(spread))", _THIRD),
        let("w = y_b/gc"),
        *_rest("far", "near"),
        let("start_rest = side*rest"),
    ]


def _rest(one: str, other: str) -> list[Let]:
    """Return assignments for psi/2 without its arctangent part.

    It is measured from the crossing if `one` <= `other`, else from the saddle.
    """
    return [
        let("from_crossing = g_1*w + g_2*third"),
        let("from_saddle = alpha - (g_1*w + h_2*third)"),
        let(f"rest = choose({one}, {other}, from_crossing, from_saddle)"),
    ]


def _turn(solution: Solution, names: Mapping[str, str]) -> tuple[Let, ...]:
    """Return assignments for the cosine and sine of the arctangent part of psi/2.

    names: other names for the quantities in its formulas.
    """
    given = ("z", "slope", "delta", "n", "rho", "s", "c", "d")
    lets = select(solution.sequences["pi_hyperbolic"], ("T_re", "T_im"), given)
    return renamed(lets, names)


def _hyperbolic_angles(solution: Solution) -> list[Let]:
    return [
        *hyperbolic_time(_HALF_PERIOD),
        let("side = choose(0, y, 1, -1)", _HALF_PERIOD),
        let("flip = alternating(periods)", _HALF_PERIOD),
        let("depth = size(y)", _HALF_PERIOD),
        let("quarter = period_far/4", _HALF_PERIOD),
        let("nearer = choose(depth, quarter, depth, 2*quarter - depth)", _REFLECTED),
        let("bounded = choose(nearer, deepest, nearer, deepest)", "DLMF 4.28"),
        let("falling = exp(-bounded)", "DLMF 4.28.1"),
        let(f"x_{LEVELS} = (1 - falling*falling)/(2*falling)", "DLMF 4.28.1"),
        *ascent(solution, "l", ("x",)),
        let("size_x = sqrt(1 + x*x)", "DLMF 22.6.1"),
        let("near_c = 1/size_x", "DLMF 22.6.1"),
        let("near_size = x*near_c", "DLMF 22.6.1"),
        let("near_d = near_c*sqrt(1 + m_c*(x*x))", "DLMF 22.6.1"),
        let("path = near_c*near_c + delta*(near_size*near_size)", _THIRD),
        let("third = _third_kind(near_size, near_c, near_d, path, spread)", _THIRD),
        let("w = bounded/gc"),
        *_rest("depth", "quarter"),
        let("near_s = side*near_size"),
        *_turn(solution, NEAR),
        *hyperbolic_turns(),
        let("psi_turns = turns - rho*(side*rest - start_rest)/pi_hi"),
        *reduction.whole("psi", "psi_turns"),
        let("psi_all = whole + psi_whole", reduction.TURNS),
        *reduction.sine_and_cosine("psi", "psi_rest", "psi_all", "turn_im", "turn_re"),
        let("arc_re = choose(depth, quarter, T_re, 1)"),
        let("arc_im = choose(depth, quarter, T_im, 0)"),
        *_half_psi(solution),
        *_functions(),
    ]


def _half_psi(solution: Solution) -> tuple[Let, ...]:
    """Return assignments for the cosine and sine of psi/2 as a sum of two angles."""
    parts = ("X_re", "X_im", "T_re", "T_im")
    lets = select(solution.sequences["pi_hyperbolic"], tuple(HALF), parts)
    return renamed(lets, PARTS | HALF)


def _functions() -> list[Let]:
    """Return assignments that compute the Jacobi functions s, c and d of u_1.

    They use the values at the nearer end of the quarter period.
    """
    return [
        let("over_d = 1/near_d", _REFLECTED),
        let("size_s = choose(depth, quarter, near_size, near_c*over_d)", _REFLECTED),
        let("size_c = choose(depth, quarter, near_c, kc_1*near_size*over_d)", _REFLECTED),
        let("d = choose(depth, quarter, near_d, kc_1*over_d)", _REFLECTED),
        let("s = flip*(side*size_s)", _HALF_PERIOD),
        let("c = flip*size_c", _HALF_PERIOD),
    ]
