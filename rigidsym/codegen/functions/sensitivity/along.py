"""What the rates change by along two directions: where p and r grow alike, `_k`, and where r does.

Near spin about the middle axis what grows with the elapsed time alone has grown too far once the
motion has turned over: the second direction is a difference of such numbers.  Where the middle rate
has another sign than at t = 0, or had it, it is the first less what p alone makes, by an integral
over the phase, which is a sum then.
"""

from rigidsym.codegen.functions.sensitivity.given import EXTENDED, GIVEN, START, coefficients
from rigidsym.codegen.functions.sensitivity.real import ELAPSED, PASSED
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import RATES
from rigidsym.codegen.passes import renamed, select
from rigidsym.solution import Solution
from rigidsym.solution.formulas import AXES

RESULTS = ("over", *(f"{rate}_{way}" for way in "kr" for rate in RATES))
_ALPHAS = tuple(f"alpha_{x}" for x in AXES)
_KEPT = (
    *(*START, *_ALPHAS, "k", "kappa_a", "kappa_d", "p", "r"),
    *("share", "half_over_p", "reach"),
)
_TIMED = (*ELAPSED, *PASSED, "t", *RATES)


def along(solution: Solution) -> tuple[Function, ...]:
    """Constants of a motion, and both directions at a time."""
    constants = Function(
        "_along_constants",
        "What both directions are made from; reach: beyond which p t^2 phases are known.",
        (*(name for name in GIVEN if name != "E_b"), "reach"),
        tuple(_constants(solution)),
        _KEPT,
        frozenset(EXTENDED),
        rounds=True,
    )
    state = Function(
        "_along_state",
        "What the rates change by where p and r grow alike, and where r does.",
        (*_TIMED, *_KEPT),
        tuple(_state(solution)),
        RESULTS,
    )
    return constants, state


def _constants(solution: Solution) -> list[Let]:
    names = ("k", "kappa_a", "kappa_d", "p", "r")
    divisors = ("alpha_b", "alpha_d", "Omega_a0", "p")
    passing = select(
        solution.sequences["passing"], ("share", "half_over_p"), (*divisors, *names, *START)
    )
    return [
        *coefficients(solution, _ALPHAS),
        *select(solution.sequences["columns"], names, (*_ALPHAS, *EXTENDED)),
        *map(_there, divisors),
        *renamed(passing, {name: f"{name}_there" for name in divisors}),
    ]


def _there(name: str) -> Let:
    """What is divided by: itself, or 1 where it is zero and what comes of it is not taken."""
    return let(f"{name}_there = choose(rounded(size({name})), 0, 1, {name})")


def _state(solution: Solution) -> list[Let]:
    given = (*_TIMED, *_KEPT)
    every = select(solution.sequences["sensitivity"], RESULTS, given)
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
