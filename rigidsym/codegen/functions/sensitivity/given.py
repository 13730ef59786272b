"""What a motion hands to its sensitivities, and what both of the first functions make of it."""

from collections.abc import Iterable

from rigidsym.codegen.ir import Let, let
from rigidsym.codegen.names import DIFFERENCES, INERTIA, NUMBERS
from rigidsym.codegen.passes import select
from rigidsym.solution import Solution
from rigidsym.solution.formulas import AXES
from rigidsym.solution.signs import HANDEDNESS

START = tuple(f"Omega_{x}0" for x in AXES)
EXTENDED = (*INERTIA, *DIFFERENCES, *START, "E_b")
GIVEN = (*EXTENDED, *NUMBERS)


def coefficients(solution: Solution, names: Iterable[str]) -> list[Let]:
    """Those of Euler's equations, and what the moments change them by."""
    given = (*EXTENDED, "epsilon")
    return [
        let(f"epsilon = {HANDEDNESS}", "Levi-Civita"),
        *select(solution.sequences["moments"], tuple(names), given),
    ]
