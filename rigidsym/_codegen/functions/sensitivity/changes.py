"""Generated functions that compute the derivatives of the body rates.

They include the moduli of the Jacobi functions of elapsed time.
"""

from collections.abc import Iterable

from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.names import DIFFERENCES, INERTIA, NUMBERS, RATES
from rigidsym._codegen.passes import renamed, select
from rigidsym.solution import Solution
from rigidsym.solution._formulas import AXES
from rigidsym.solution._partition import HANDEDNESS

START = tuple(f"Omega_{x}0" for x in AXES)
EXTENDED = (*INERTIA, *DIFFERENCES, *START, "E_b")
GIVEN = (*EXTENDED, *NUMBERS)
MODULI = ("p", "r", "apart", "lambda_", "divisor", "modulus", "complement")
# Functions of the elapsed time.
ELAPSED = ("S_t", "C_t", "D_t", "E_t", "f")
# r times the integral of S_t^2/D_t^2 over the phase, and how many half periods of it there were.
PASSED = ("passed", "turned")

ALONG = ("over", *(f"{rate}_{way}" for way in "kr" for rate in RATES))
_ALONG_ALPHAS = tuple(f"alpha_{x}" for x in AXES)
_ALONG_KEPT = (
    *(*START, *_ALONG_ALPHAS, "k", "kappa_a", "kappa_d", "p", "r"),
    *("share", "half_over_p", "reach"),
)
_ALONG_TIMED = (*ELAPSED, *PASSED, "t", *RATES)
CHANGES = (*RATES, *(f"c_{x}" for x in AXES))
RESULTS = (
    *(f"{rate}_by_{change}" for rate in RATES for change in CHANGES),
    *(f"excess_{x}" for x in AXES),
)
_ALPHAS = (
    *("alpha_a", "alpha_b", "alpha_d", "tilt"),
    *(f"tilt_by_c_{x}" for x in AXES),
    *(f"alpha_{x}_by_c_{y}" for x in AXES for y in AXES),
)
_KEPT = (
    *START,
    *("alpha_a", "alpha_b", "alpha_d", "alpha_divisor"),
    *("g_a", "g_d", "k", "kappa_a", "kappa_d", "p", "apart"),
    *("p_by_Omega_a", "p_by_Omega_b", "r_by_Omega_d"),
    *(f"{x}_by_c_{y}" for x in ("kappa", "p", "apart", "leant", *AXES) for y in AXES),
)
# By the rate of another axis, the product's: that of the axis whose coefficient stands below.
_MIDDLE = {"Omega_b_by_Omega_a": ("d", "a"), "Omega_b_by_Omega_d": ("a", "d")}
# What changes with time.
_TIMED = (*ELAPSED, *ALONG, "t", *RATES)


def coefficients(solution: Solution, names: Iterable[str]) -> list[Let]:
    """Return assignments for the coefficients of Euler's equations.

    names: the coefficients, and derivatives of them by the moments, that are needed.
    """
    given = (*EXTENDED, "epsilon")
    return [
        let(f"epsilon = {HANDEDNESS}", "Levi-Civita"),
        *select(solution.sequences["moments"], tuple(names), given),
    ]


def moduli(solution: Solution) -> Function:
    """Build the function that computes the moduli of the Jacobi functions of elapsed time."""
    alphas = ("alpha_a", "alpha_b", "alpha_d", "tilt")
    lets = [
        *coefficients(solution, alphas),
        *select(solution.sequences["columns"], ("p", "r", "apart"), (*alphas, *EXTENDED)),
        let("lambda_ = sqrt(p)"),
        let("divisor = choose(rounded(p), 0, 1, p)"),
        let("modulus = sqrt(r/divisor)", "DLMF 22.2.2"),
        let("complement = sqrt(choose(rounded(p), 0, 1, apart/divisor))", "DLMF 19.2.8"),
    ]
    summary = "p, r, p - r, sqrt(p), p or 1 to divide by, and the modulus with its complement."
    return Function("_moduli", summary, GIVEN, tuple(lets), MODULI, frozenset(EXTENDED))


def along(solution: Solution) -> tuple[Function, ...]:
    """Build the functions that differentiate the rates along two directions in parameter space.

    Along the first p and r grow equally; along the second r alone grows.
    """
    constants = Function(
        "_along_constants",
        "Constants of `_along_state`; phases are known where p t^2 exceeds reach.",
        (*(name for name in GIVEN if name != "E_b"), "reach"),
        tuple(_constants_along(solution)),
        _ALONG_KEPT,
        frozenset(EXTENDED),
        rounds=True,
    )
    state = Function(
        "_along_state",
        "Derivatives of the rates where p and r grow equally, and where r alone grows.",
        (*_ALONG_TIMED, *_ALONG_KEPT),
        tuple(_state_along(solution)),
        ALONG,
    )
    return constants, state


def _constants_along(solution: Solution) -> list[Let]:
    names = ("k", "kappa_a", "kappa_d", "p", "r")
    divisors = ("alpha_b", "alpha_d", "Omega_a0", "p")
    passing = select(
        solution.sequences["passing"], ("share", "half_over_p"), (*divisors, *names, *START)
    )
    return [
        *coefficients(solution, _ALONG_ALPHAS),
        *select(solution.sequences["columns"], names, (*_ALONG_ALPHAS, *EXTENDED)),
        *map(_there, divisors),
        *renamed(passing, {name: f"{name}_there" for name in divisors}),
    ]


def _there(name: str) -> Let:
    """Return an assignment that copies a divisor, with 1 in place of zero.

    The quotient is not used where the divisor is zero.
    """
    return let(f"{name}_there = choose(rounded(size({name})), 0, 1, {name})")


def _state_along(solution: Solution) -> list[Let]:
    given = (*_ALONG_TIMED, *_ALONG_KEPT)
    every = select(solution.sequences["sensitivity"], ALONG, given)
    passing = [f"{rate}_p" for rate in RATES]
    known = (*given, "over")
    made = select(solution.sequences["passing"], passing, known)
    return [
        *renamed(every, {f"{rate}_r": f"any_{rate}_r" for rate in RATES}),
        let("Omega_a_there = choose(size(Omega_a), 0, 1, Omega_a)"),
        *renamed(made, {"Omega_a": "Omega_a_there"}),
        let("lobe = choose(2, turned, 0, Omega_b*Omega_b0)"),
        let("crossed = choose(reach, p*(t*t), lobe, 1)"),
        *(
            let(f"{rate}_r = choose(crossed, 0, {rate}_k - {rate}_p, any_{rate}_r)")
            for rate in RATES
        ),
    ]


def columns(solution: Solution) -> tuple[Function, ...]:
    """Build the functions for the Jacobian columns: rates by initial rates and by moments."""
    constants = Function(
        "_columns_constants",
        "Constants of the rates' sensitivities.",
        GIVEN,
        tuple(_constants_of_columns(solution)),
        _KEPT,
        frozenset(EXTENDED),
        rounds=True,
    )
    state = Function(
        "_columns_state",
        "Derivatives of the rates, and integrals of the squares of rates.",
        (*_TIMED, *_KEPT),
        tuple(_state_of_columns(solution)),
        RESULTS,
    )
    return constants, state


def _constants_of_columns(solution: Solution) -> list[Let]:
    names = [name for name in _KEPT if name not in (*START, "alpha_divisor", *_ALPHAS)]
    return [
        *coefficients(solution, _ALPHAS),
        *select(solution.sequences["columns"], names, (*_ALPHAS, *EXTENDED)),
        # Where all moments are equal the excess is zero, whatever it is divided by.
        let("alpha_divisor = choose(rounded(size(alpha_b)), 0, 1, alpha_b)"),
    ]


def _state_of_columns(solution: Solution) -> list[Let]:
    given = (*_TIMED, *_KEPT)
    excesses = select(
        solution.sequences["excesses"], ("excess_a", "excess_d"), (*given, "excess_b")
    )
    columns = select(solution.sequences["sensitivity"], RESULTS, given)
    return [
        *renamed(columns, {name: f"any_{name}" for name in (*_MIDDLE, "excess_b")}),
        *_middle(solution, given),
        *_excess(solution, given),
        *renamed(excesses, {"alpha_b": "alpha_divisor"}),
    ]


def _middle(solution: Solution, given: tuple[str, ...]) -> list[Let]:
    """Return assignments for the derivatives of the middle axis' rate.

    Near spin about b they are products, which keep all digits; the general form is a difference of
    large numbers there.
    """
    lets = [let("b_divisor = choose(size(Omega_b), 0, 1, Omega_b)")]
    known = (*given, "Omega_d_by_Omega_a", "Omega_a_by_Omega_d")
    for name, (x, y) in _MIDDLE.items():
        product = f"middle_by_Omega_{y}"
        made = select(solution.sequences["middle"], (product,), known)
        divisors = {"Omega_b": "b_divisor", f"alpha_{x}": f"{x}_divisor"}
        lets += [
            let(f"{x}_divisor = choose(size(alpha_{x}), 0, 1, alpha_{x})"),
            *renamed(made, divisors),
            let(f"{x}_size = size(alpha_b*Omega_{x})"),
            let(f"{name} = choose({x}_size, size(alpha_{x}*Omega_b), {product}, any_{name})"),
        ]
    return lets


def _excess(solution: Solution, given: tuple[str, ...]) -> list[Let]:
    """Return assignments for the integral of the squared rate about the middle axis.

    Near spin about b they use a form without t.
    """
    spun = select(solution.sequences["spun"], ("excess_spun",), (*given, "over"))
    return [
        let("p_divisor = choose(size(p), 0, 1, p)"),
        let("C_ahead = choose(C_t, 0, 0, C_t)"),
        *renamed(spun, {"p": "p_divisor", "C_t": "C_ahead"}),
        let("spinning = choose(C_t, 0, 0, k)"),
        let("excess_b = choose(spinning, kappa_a + kappa_d, any_excess_b, excess_spun)"),
    ]
