"""State of a motion from Fourier series of sn, cn, dn and psi/2.

No generated module uses it: `rigidsym compare-forms` compares it with the forms that are used.
"""

from rigidsym._codegen.functions.assembly import finished
from rigidsym._codegen.ir import Function
from rigidsym._codegen.names import AMPLITUDES, ATTITUDE, INERTIA, RATES, SIGNS, STATE
from rigidsym._codegen.passes import select
from rigidsym.solution import Solution

SUMMED = ("sn", "cn", "dn", "cos_half_psi", "sin_half_psi")
CONSTANTS = (*INERTIA, *AMPLITUDES, "K", "p_0", "p_a", "p_b", "p_d", "tau")


def state(solution: Solution) -> Function:
    """Build the function that computes rates and attitude from sn, cn, dn and psi/2."""
    signs = tuple(sign for sign in SIGNS if sign != "rho")
    given = (*SUMMED, *CONSTANTS, *signs)
    lets = select(solution.sequences["state"], (*ATTITUDE, *RATES), given)
    summary = "The state from sn, cn, dn and the cosine and sine of psi/2."
    return finished(Function("_fourier_state", summary, given, lets, STATE))
