"""Generated functions that compute sensitivities, the derivatives of a state by each input.

sn, cn, dn and two integrals of the elapsed time come first, then the rates, then the attitude: a
small turn in space about the user's axes 1, 2 and 3.  The functions of the elapsed time depend on
no phase and no regime, but on which nome is small: that of m up to 1/2 (`_real_*`, thetas of real
time), the complementary one above (`_imaginary_*`).
"""

from rigidsym._codegen.functions.sensitivity.changes import along, columns, moduli
from rigidsym._codegen.functions.sensitivity.elapsed import imaginary, real
from rigidsym._codegen.ir import Function
from rigidsym._codegen.passes import select
from rigidsym.solution import Solution

AXES = ("1", "2", "3")
CHANGES = tuple(f"{x}{k}" for x in ("Omega", "c") for k in AXES)
INERTIA, START = tuple(f"c{k}" for k in AXES), tuple(f"Omega{k}_0" for k in AXES)
BEGUN = ("p0", "p1", "p2", "p3")
# What changes with time, in the user's axes.
TIMED = (
    *("q0", "q1", "q2", "q3"),
    *(f"Omega{k}" for k in AXES),
    *(f"Omega{k}_by_{y}" for k in AXES for y in CHANGES),
    *(f"excess{k}" for k in AXES),
)
RESULTS = tuple(f"eta{k}_by_{y}" for k in AXES for y in CHANGES)
BY_TIME = tuple(f"{x}{k}_by_t" for x in ("eta", "Omega") for k in AXES)
_ARMS = tuple(f"B{i}{k}" for i in AXES for k in AXES)
DIFFERENCES = ("c12", "c13", "c23")
_KEPT = (*INERTIA, *DIFFERENCES, *START, "per_K2", *(f"l{k}" for k in AXES), *_ARMS)


def sensitivity(solution: Solution) -> tuple[Function, ...]:
    """Return all functions that compute sensitivities.

    Each calls only functions before it.
    """
    return (
        moduli(solution),
        *along(solution),
        *columns(solution),
        *real(solution),
        *imaginary(),
        *turn(solution),
    )


def turn(solution: Solution) -> tuple[Function, ...]:
    """Build the functions that compute the attitude's derivatives as small turns in space."""
    given = (*INERTIA, *DIFFERENCES, *START, *BEGUN)
    first = select(solution.sequences["turn_constants"], _KEPT, given)
    constants = Function(
        "_turn_constants",
        "Constants of the attitude's sensitivities for a moving body.",
        given,
        tuple(first),
        _KEPT,
        rounds=True,
    )
    results = (*RESULTS, *BY_TIME)
    state = Function(
        "_turn_state",
        "Derivatives of the attitude by the inputs, and of the state by the time.",
        (*TIMED, "t", *_KEPT),
        select(solution.sequences["turn"], results, (*TIMED, "t", *_KEPT)),
        results,
    )
    return constants, state
