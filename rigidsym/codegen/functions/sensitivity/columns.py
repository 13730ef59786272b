"""What the rates change by with each rate at t = 0 and each moment of inertia."""

from rigidsym.codegen.functions.sensitivity.along import RESULTS as ALONG
from rigidsym.codegen.functions.sensitivity.given import EXTENDED, GIVEN, START, coefficients
from rigidsym.codegen.functions.sensitivity.real import ELAPSED
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import RATES
from rigidsym.codegen.passes import renamed, select
from rigidsym.solution import Solution
from rigidsym.solution.formulas import AXES

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
KEPT = (
    *START,
    *("alpha_a", "alpha_b", "alpha_d", "alpha_divisor"),
    *(
        "g_a",
        "g_d",
        "k",
        "kappa_a",
        "kappa_d",
        "p",
        "apart",
        "p_by_Omega_a",
        "p_by_Omega_b",
        "r_by_Omega_d",
    ),
    *(f"{x}_by_c_{y}" for x in ("kappa", "p", "apart", "leant", *AXES) for y in AXES),
)


# By the rate of another axis, the product's: that of the axis whose coefficient stands below.
_MIDDLE = {"Omega_b_by_Omega_a": ("d", "a"), "Omega_b_by_Omega_d": ("a", "d")}


# What changes with time.
TIMED = (*ELAPSED, *ALONG, "t", *RATES)


def columns(solution: Solution) -> tuple[Function, ...]:
    """Constants of a motion, and the columns at a time."""
    constants = Function(
        "_columns_constants",
        "What sensitivities of the rates are made from, at t = 0.",
        GIVEN,
        tuple(_constants(solution)),
        KEPT,
        frozenset(EXTENDED),
        rounds=True,
    )
    state = Function(
        "_columns_state",
        "What the rates change by, and integrals of their squares, from functions of the time.",
        (*TIMED, *KEPT),
        tuple(_state(solution)),
        RESULTS,
    )
    return constants, state


def _constants(solution: Solution) -> list[Let]:
    names = [name for name in KEPT if name not in (*START, "alpha_divisor", *_ALPHAS)]
    return [
        *coefficients(solution, _ALPHAS),
        *select(solution.sequences["columns"], names, (*_ALPHAS, *EXTENDED)),
        # Where all moments are equal the excess is zero, whatever it is divided by.
        let("alpha_divisor = choose(rounded(size(alpha_b)), 0, 1, alpha_b)"),
    ]


def _state(solution: Solution) -> list[Let]:
    given = (*TIMED, *KEPT)
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
    """The middle rate's columns: products where they are no larger than what they are made from.

    Near spin about b these keep all digits, and the general form is a difference of large numbers.
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
    """The integral of the middle rate's square, without the time itself near a spin about b."""
    spun = select(solution.sequences["spun"], ("excess_spun",), (*given, "over"))
    return [
        let("p_divisor = choose(size(p), 0, 1, p)"),
        let("C_ahead = choose(C_t, 0, 0, C_t)"),
        *renamed(spun, {"p": "p_divisor", "C_t": "C_ahead"}),
        let("spinning = choose(C_t, 0, 0, k)"),
        let("excess_b = choose(spinning, kappa_a + kappa_d, any_excess_b, excess_spun)"),
    ]
