"""The functions every motion begins with: E_b, which decides the regime, and the state at t = 0.

Both are given the differences of the moments: what the moments are rounded to is not subtracted.
"""

from rigidsym.codegen.ir import Function
from rigidsym.codegen.names import AMPLITUDES, DIFFERENCES, INERTIA, INITIAL, RATES, SIGNS
from rigidsym.codegen.passes import renamed, select
from rigidsym.solution import Solution


def discriminant(solution: Solution) -> Function:
    """E_b, over any kind of numbers."""
    parameters = ("c_a", "c_d", "c_ab", "c_bd", "Omega_a", "Omega_d")
    lets = select(solution.sequences["constants"], ("E_b",), parameters)
    return Function("_discriminant", "K^2 - 2 H c_b over any numbers.", parameters, lets, ("E_b",))


def start(solution: Solution, results: tuple[str, ...] = INITIAL) -> Function:
    """From inertia and rates to what both plans are made of."""
    numbers = (*INERTIA, *DIFFERENCES, *RATES, "E_b")
    given = (*numbers, *SIGNS)
    names = {"k_c", "sn", "cn", "dn", "K", *AMPLITUDES, "k_1", "mu", "psi_0", *results}
    lets = select(solution.sequences["constants"], names, given)
    lets += select(solution.sequences["theta"], ("B_a", "B_d"), (*given, "A_a", "A_d"))
    first = {"kc": "k_c", "k_next": "k_1", "kc_next": "kc_1", "s": "sn", "c": "cn", "d": "dn"}
    first |= {"s_next": "s", "c_next": "c", "d_next": "d"}
    wanted = ("kc_next", "s_next", "c_next", "d_next")
    step = select(solution.sequences["landen"], wanted, ("k_next", "kc", "s", "c", "d"))
    lets = (*lets, *renamed(step, first))
    summary = "Invariants, amplitudes, descended functions at t = 0; E_b is of `_discriminant`."
    return Function("_initial_state", summary, given, lets, results, frozenset(numbers))
