"""What a state changes by with each input: sn, cn, dn and two integrals of the elapsed time first,
then the rates, then the attitude.

The functions of the elapsed time ask for no phase and no regime, but for which nome is small: that
of m up to 1/2 (`_real_*`, thetas of real time), the complementary one above (`_imaginary_*`).
"""

from rigidsym.codegen.functions.sensitivity.along import along
from rigidsym.codegen.functions.sensitivity.columns import columns
from rigidsym.codegen.functions.sensitivity.imaginary import imaginary
from rigidsym.codegen.functions.sensitivity.moduli import moduli
from rigidsym.codegen.functions.sensitivity.real import real
from rigidsym.codegen.functions.sensitivity.turn import turn
from rigidsym.codegen.ir import Function
from rigidsym.solution import Solution


def sensitivity(solution: Solution) -> tuple[Function, ...]:
    """All of them, in an order in which each calls those before it."""
    return (
        moduli(solution),
        *along(solution),
        *columns(solution),
        *real(solution),
        *imaginary(),
        *turn(solution),
    )
