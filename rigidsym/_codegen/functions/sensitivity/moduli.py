"""The inputs of a motion's sensitivities, and its moduli, from differences before rounding."""

from collections.abc import Iterable

from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.names import DIFFERENCES, INERTIA, NUMBERS
from rigidsym._codegen.passes import select
from rigidsym.solution import Solution
from rigidsym.solution._formulas import AXES
from rigidsym.solution._partition import HANDEDNESS

START = tuple(f"Omega_{x}0" for x in AXES)
EXTENDED = (*INERTIA, *DIFFERENCES, *START, "E_b")
GIVEN = (*EXTENDED, *NUMBERS)
RESULTS = ("p", "r", "apart", "lambda_", "divisor", "modulus", "complement")


def coefficients(solution: Solution, names: Iterable[str]) -> list[Let]:
    """State the coefficients of Euler's equations, and their changes with the moments."""
    given = (*EXTENDED, "epsilon")
    return [
        let(f"epsilon = {HANDEDNESS}", "Levi-Civita"),
        *select(solution.sequences["moments"], tuple(names), given),
    ]


def moduli(solution: Solution) -> Function:
    """State lambda, the modulus and its complement, from inertia and rates."""
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
    return Function("_moduli", summary, GIVEN, tuple(lets), RESULTS, frozenset(EXTENDED))
