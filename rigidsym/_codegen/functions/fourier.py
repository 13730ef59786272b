"""The state from sn, cn, dn and psi/2 that Fourier series give.

No module flies by it: `rigidsym compare-forms` runs it beside those that do.
"""

from rigidsym._codegen.functions.assembly import finished
from rigidsym._codegen.ir import Function
from rigidsym._codegen.names import AMPLITUDES, ATTITUDE, INERTIA, RATES, SIGNS, STATE
from rigidsym._codegen.passes import select
from rigidsym.solution import Solution

SUMMED = ("sn", "cn", "dn", "cos_half_psi", "sin_half_psi")
CONSTANTS = (*INERTIA, *AMPLITUDES, "K", "p_0", "p_a", "p_b", "p_d", "tau")


def state(solution: Solution) -> Function:
    """Make the function of rates and attitude, given sn, cn, dn and psi."""
    signs = tuple(sign for sign in SIGNS if sign != "rho")
    given = (*SUMMED, *CONSTANTS, *signs)
    lets = select(solution.sequences["state"], (*ATTITUDE, *RATES), given)
    summary = "The state from sn, cn, dn and the cosine and sine of psi/2."
    return finished(Function("_fourier_state", summary, given, lets, STATE))
