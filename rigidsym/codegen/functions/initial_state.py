"""The functions every motion begins with: E_b, which way it circulates, and the state at t = 0.

They are given the differences of the moments: what the moments are rounded to is not subtracted.
Axes are told by their numbers, 0, 1 and 2.
"""

from dataclasses import replace

from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import AMPLITUDES, DIFFERENCES, INERTIA, INITIAL, NUMBERS, RATES, SIGNS
from rigidsym.codegen.passes import renamed, select, specialise
from rigidsym.language.expression import parse, put
from rigidsym.solution import Solution
from rigidsym.solution.partition import GIVEN, ONES, ROOT
from rigidsym.solution.signs import HANDEDNESS


def discriminant(solution: Solution) -> Function:
    """E_b, over any kind of numbers."""
    parameters = ("c_a", "c_d", "c_ab", "c_bd", "Omega_a", "Omega_d")
    lets = select(solution.sequences["constants"], ("E_b",), parameters)
    return Function("_discriminant", "K^2 - 2 H c_b over any numbers.", parameters, lets, ("E_b",))


def circulation(solution: Solution) -> Function:
    """Whether the rates are constant, or which axis is a."""
    lets = select(solution.sequences["decisions"], (ROOT,), (*GIVEN, *ONES))
    summary = "1: a is the axis of largest moment, -1: of smallest, 0: constant rates; by 0 and 1."
    return Function("_circulation", summary, GIVEN, specialise(lets, ONES), (ROOT,))


def start(solution: Solution, results: tuple[str, ...] = INITIAL) -> Function:
    """From inertia and rates to what both plans are made of."""
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
    summary = "Signs, invariants, amplitudes, functions at t = 0; E_b is of `_discriminant`."
    parameters = (*numbers, *NUMBERS)
    results = (*results, *SIGNS)
    return Function("_initial_state", summary, parameters, lets, results, frozenset(numbers))


def _signs(solution: Solution) -> list[Let]:
    """The handedness of the axes, and the signs of what rounding leaves the sign of."""
    given = ("c_ad", "Omega_a", "Omega_d")
    rounded = {name: parse(f"rounded({name})") for name in given}
    return [
        let(f"epsilon = {HANDEDNESS}", "Levi-Civita"),
        *(
            replace(formula, expression=put(formula.expression, rounded))
            for formula in select(solution.sequences["signs"], (*SIGNS[1:], "tau"), given)
        ),
    ]
