"""Generated functions that the theta form and the Pi form share.

These compute the initial state, reduced times, the parts of a branch, and constant rates.

The first functions take the differences of the moments as arguments, since differences of rounded
moments would lose digits.  Axes are given by their numbers, 0, 1 and 2.  v is u_1 in half turns of
2 K_1; near the separatrix y is u_1 in units of 2 K_c/pi, where K_c is the quarter period of the
complementary modulus, and the half period of y grows without bound.
"""

from collections.abc import Iterable
from dataclasses import replace

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import EXACT_SUM, Function, Let, let
from rigidsym._codegen.names import (
    AMPLITUDES,
    ATTITUDE,
    DIFFERENCES,
    INERTIA,
    INITIAL,
    NUMBERS,
    RATES,
    SIGNS,
    STATE,
)
from rigidsym._codegen.passes import live, renamed, select, specialise
from rigidsym._codegen.special_functions import reduction
from rigidsym.language._expression import names, parse, put
from rigidsym.solution import Solution
from rigidsym.solution._partition import GIVEN, HANDEDNESS, ONES, ROOT

_QUATERNION = ("q0", "q1", "q2", "q3")


def discriminant(solution: Solution) -> Function:
    """Build the function that computes the discriminant E_b = K^2 - 2 H c_b.

    It takes numbers of any kind.
    """
    parameters = ("c_a", "c_d", "c_ab", "c_bd", "Omega_a", "Omega_d")
    lets = select(solution.sequences["constants"], ("E_b",), parameters)
    return Function(
        "_discriminant", "K^2 - 2 H c_b, for numbers of any kind.", parameters, lets, ("E_b",)
    )


def circulation(solution: Solution) -> Function:
    """Build the function that determines the axis about which the momentum circulates.

    It returns 1 or -1 where this axis, a, has the largest or smallest moment, and 0 for constant
    rates.
    """
    lets = select(solution.sequences["decisions"], (ROOT,), (*GIVEN, *ONES))
    summary = "1 or -1 where a is the axis of largest or smallest moment, 0 for constant rates."
    return Function("_circulation", summary, GIVEN, specialise(lets, ONES), (ROOT,))


def start(solution: Solution, results: tuple[str, ...] = INITIAL) -> Function:
    """Build the function that computes a motion's signs, invariants and amplitudes at t = 0."""
    numbers = (*INERTIA, *DIFFERENCES, *RATES, "E_b")
    given = (*numbers, *SIGNS, "tau")
    names = {"k_c", "sn", "cn", "dn", "K", *AMPLITUDES, "k_1", "mu", "psi_0", *results}
    lets = select(solution.sequences["constants"], names, given)
    lets += select(solution.sequences["theta"], ("B_a", "B_d"), (*given, "A_a", "A_d"))
    first = {"kc": "k_c", "k_next": "k_1", "kc_next": "kc_1", "s": "sn", "c": "cn", "d": "dn"}
    first |= {"s_next": "s", "c_next": "c", "d_next": "d"}
    wanted = ("kc_next", "s_next", "c_next", "d_next")
    step = select(solution.sequences["landen"], wanted, ("k_next", "kc", "s", "c", "d"))
    lets = (*_signs(solution), *lets, *renamed(step, first))
    summary = "Signs, invariants, amplitudes and functions at t = 0; E_b is from `_discriminant`."
    parameters = (*numbers, *NUMBERS)
    results = (*results, *SIGNS)
    return Function("_initial_state", summary, parameters, lets, results, frozenset(numbers))


def _signs(solution: Solution) -> list[Let]:
    """Return assignments that compute the sign constants of a motion.

    These are the handedness of the axes and the signs of rounded numbers.
    """
    given = ("c_ad", "Omega_a", "Omega_d")
    rounded = {name: parse(f"rounded({name})") for name in given}
    return [
        let(f"epsilon = {HANDEDNESS}", "Levi-Civita"),
        *(
            replace(formula, expression=put(formula.expression, rounded))
            for formula in select(solution.sequences["signs"], (*SIGNS[1:], "tau"), given)
        ),
    ]


def circular_time() -> list[Let]:
    """Return assignments that split the angle v into whole half turns and a remainder."""
    return [
        *reduction.product("p", "v_rate", extra="v_lo"),
        *reduction.total("v", "p", "v_hi"),
        *reduction.whole("v", "v"),
        let("v_turns = v_rest + (p_error + v_error)", reduction.TURNS),
    ]


def hyperbolic_time(half_period: str) -> list[Let]:
    """Return assignments that reduce the scaled time y by whole half periods.

    half_period: the reference for the half period.
    """
    return [
        *reduction.product("p_y", "y_rate", extra="y0_lo"),
        let("periods = nearest((p_y + y0_hi)*period_inverse)", half_period),
        *reduction.product("back", "period", "periods", later=False),
        *reduction.total("ahead", "p_y", "-back"),
        *reduction.total("y_near", "ahead", "y0_hi"),
        let("y = y_near + (y_near_error + (ahead_error + (p_y_error - back_error)))", half_period),
    ]


def elapsed_time(half_period: str) -> list[Let]:
    """Return assignments that subtract whole half periods from the angle y of the elapsed time.

    y is 0 at t = 0.  The remainder is y + y_lo, a sum of two doubles.
    """
    return [
        *reduction.product("p_y", "y_rate"),
        let("periods = nearest(p_y*period_inverse)", half_period),
        *reduction.product("back", "period", "periods", later=False),
        *reduction.total("ahead", "p_y", "-back"),
        let("y_rest = ahead_error + (p_y_error - back_error)", half_period),
        let("y = ahead + y_rest", half_period),
        let("y_lo = (ahead - y) + y_rest", EXACT_SUM),
    ]


def elapsed_phase(half_period: str) -> list[Let]:
    """Return assignments that reduce the phase z by multiples of its half period.

    They follow those of `elapsed_time`.  The remainder is z + z_lo, a sum of two doubles.
    """
    return [
        let("turns = nearest((p_y + z0_hi)*period_inverse)", half_period),
        *reduction.product("behind", "period", "turns", later=False),
        *reduction.total("beyond", "p_y", "-behind"),
        *reduction.total("z_near", "beyond", "z0_hi"),
        let("z_rest = z_near_error + (beyond_error + ((p_y_error + z0_lo) - behind_error))"),
        let("z = z_near + z_rest", half_period),
        let("z_lo = (z_near - z) + z_rest", EXACT_SUM),
    ]


def hyperbolic_turns() -> list[Let]:
    """Return assignments that compute the phase: Lambda t, and a jump for each half period.

    The phase is a number of whole half turns and a remainder.
    """
    return [
        *reduction.product("L", "Lambda_rate"),
        *reduction.whole("L", "L"),
        *reduction.product("j", "jump", "periods", later=False),
        *reduction.whole("j", "j"),
        *reduction.total("turned", "L_rest", "j_rest"),
        *reduction.whole("turned", "turned"),
        let("turns = turned_rest + (turned_error + (L_error + j_error))", reduction.TURNS),
        let("whole = L_whole + (j_whole + turned_whole)", reduction.TURNS),
    ]


def imaginary_phase(ladder: str) -> list[Let]:
    """Return assignments that compute sinh(y) for the imaginary phase y at t = 0.

    ladder: the call of Landen's ladder with the complementary modulus.
    """
    return [
        # Past K/2 the phase is reflected to K - u: sc(K - u) = cs(u)/k' (DLMF 22.4(iii)).
        let("size_s = size(s)", "DLMF 22.4.3"),
        let("near = rounded(c*c)", "DLMF 22.4.3"),
        let("far = rounded(kc_1*(s*s))", "DLMF 22.4.3"),
        let("above = choose(far, near, size_s, c)", "DLMF 22.4.3"),
        let("below = choose(far, near, c, kc_1*size_s)", "DLMF 22.4.3"),
        let("xi = above/below", "DLMF 22.6.7"),
        let(ladder, "DLMF 19.8.12"),
    ]


def period_bounds(vanished: str, half_period: str) -> list[Let]:
    """Return assignments for the half period and its inverse, finite on the separatrix too.

    vanished: the name of a quantity that is 0 on the separatrix.
    """
    return [
        let(f"period_far = choose({vanished}, 0, never, rounded(period))", half_period),
        let(f"period_d = rounded(choose({vanished}, 0, 1, period))", half_period),
        let(f"period_inverse = choose({vanished}, 0, 0, 1/period_d)", half_period),
    ]


def phase_at_start(*parity: str) -> list[Let]:
    """Return assignments that compute the phase y at t = 0 from its hyperbolic sine.

    parity: the references for the sign of y.
    """
    return [
        let("cosh_y = sqrt(1 + Y_b*Y_b)", "DLMF 4.35.11"),
        let("y_b = _logarithm(Y_b + cosh_y)", "DLMF 4.37.16"),
        let("y_size = choose(far, near, y_b, period/2 - y_b)", "DLMF 22.4.3"),
        let("side = choose(0, rounded(s), 1, -1)", *parity),
        let("y0 = side*y_size"),
        let("y_rate = mu*gc"),
    ]


def phase(binary: Format = BINARY64) -> list[Let]:
    """Return assignments that compute the cosine and sine of the phase Lambda t."""
    return [
        *reduction.product("L", "Lambda_rate"),
        *reduction.whole("L", "L"),
        let("L_turns = L_rest + L_error", reduction.TURNS),
        *reduction.sine_and_cosine("L", "L_turns", "L_whole", "X_im", "X_re", binary),
    ]


def flat(split: Iterable[str]) -> tuple[str, ...]:
    """Return the names of the high and low doubles of extended numbers."""
    return tuple(f"{name}_{part}" for name in split for part in ("hi", "lo"))


def branch(
    name: str,
    constants: Iterable[Let],
    angles: Iterable[Let],
    state: Iterable[Let],
    *,
    split: tuple[str, ...],
    in_angles: tuple[str, ...],
    timed: tuple[str, ...],
    in_state: tuple[str, ...],
    given: tuple[str, ...] = (*INITIAL, *ATTITUDE),
) -> tuple[Function, ...]:
    """Build the three functions of a branch: constants, angles at a time, and state.

    split, in_angles: the constants that angles take, as two doubles each and as one.  timed: the
    angles.  in_state: the constants that states take.  given: the extended numbers that constants
    may be computed from.
    """
    results, lets = (*split, *in_angles, *in_state), tuple(constants)
    used = {name for let in live(lets, results) for name in names(let.expression)} | {*results}
    extended = tuple(name for name in given if name in used)
    return (
        Function(
            f"_{name}_constants",
            f"The constants of a motion on the {name} branch, from `_initial_state`.",
            (*extended, *(sign for sign in SIGNS if sign in used), "unit"),
            lets,
            results,
            frozenset(extended),
            frozenset(split),
            rounds=True,
        ),
        Function(
            f"_{name}_angles",
            f"Angles of the {name} branch at t + t_lo.",
            ("t", "t_lo", *flat(split), *in_angles),
            tuple(angles),
            timed,
        ),
        Function(
            f"_{name}_state",
            f"The state on the {name} branch, from `_{name}_angles`.",
            (*timed, *in_state),
            tuple(state),
            STATE,
        ),
    )


def steady(solution: Solution, binary: Format = BINARY64) -> tuple[Function, ...]:
    """Build the functions that compute constants, angles and state for constant rates."""
    sequence = solution.sequences["steady"]
    given = ("Omega1", "Omega2", "Omega3")
    axis, start = ("axis1", "axis2", "axis3"), ("p0", "p1", "p2", "p3")
    first = [*select(sequence, ("omega", *axis), given), let("Lambda_rate = omega/(2*pi)")]
    turned = ("X_im", "X_re")
    # The half angle is omega t/2: its cosine and sine are those of the phase.
    state = [
        let("cos_half_theta = X_re", facts=("reading steady.cos_half_theta",)),
        let("sin_half_theta = X_im", facts=("reading steady.sin_half_theta",)),
        *select(sequence, _QUATERNION, ("sin_half_theta", "cos_half_theta", *axis, *start)),
    ]
    results = ("Lambda_rate", *axis, *start)
    return (
        Function(
            "_steady_constants",
            "The axis and the rate of a motion with constant rates.",
            (*given, *start),
            tuple(first),
            results,
            frozenset((*given, *start)),
            frozenset(("Lambda_rate",)),
            rounds=True,
        ),
        Function(
            "_steady_angles",
            "Angles of the steady branch at t + t_lo.",
            ("t", "t_lo", *flat(("Lambda_rate",))),
            tuple(phase(binary)),
            turned,
        ),
        Function(
            "_steady_state",
            "The attitude from `_steady_angles`.",
            (*turned, *axis, *start),
            tuple(state),
            _QUATERNION,
        ),
    )
