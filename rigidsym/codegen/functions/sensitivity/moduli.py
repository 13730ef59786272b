"""lambda and the modulus of a motion, from differences taken before rounding."""

from rigidsym.codegen.functions.sensitivity.given import EXTENDED, GIVEN, coefficients
from rigidsym.codegen.ir import Function, let
from rigidsym.codegen.passes import select
from rigidsym.solution import Solution

RESULTS = ("p", "r", "apart", "lambda_", "divisor", "modulus", "complement")


def moduli(solution: Solution) -> Function:
    """From inertia and rates to lambda, the modulus and its complement."""
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
