"""Assembly of the functions of each generated module, before they are printed.

A motion's constants come from extended numbers: `_initial_state` finds the invariants and the
descended functions at t = 0, and, by the modulus, `_circular_constants` or `_hyperbolic_constants`
the rest.  States are doubles, in two functions for each branch: `_<branch>_angles` finds what
changes with time, and `_<branch>_state` the state from that.
"""

from dataclasses import replace
from functools import cache

import mpmath

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.forms import PI, STEP, THETA
from rigidsym._codegen.functions import pi, theta
from rigidsym._codegen.functions.common import circulation, discriminant, start, steady
from rigidsym._codegen.functions.sensitivity import sensitivity
from rigidsym._codegen.functions.step import step
from rigidsym._codegen.ir import Constant, Function, Let
from rigidsym._codegen.names import INITIAL
from rigidsym._codegen.passes import live, narrowed, products, share
from rigidsym._codegen.special_functions import (
    angles,
    carlson,
    exponential,
    landen,
    nome,
    reduction,
)
from rigidsym.solution import Solution


@cache
def functions(
    solution: Solution, form: str = THETA, binary: Format = BINARY64
) -> tuple[Function, ...]:
    """Return all generated functions for one form of the solution, optimised for printing.

    Each calls only functions before it.  Other formats than binary64 have no sensitivities.
    """
    found = tuple(finished(function, binary) for function in stated(solution, form, binary))
    return found if binary.is_wide else tuple(map(narrowed, found))


def stated(
    solution: Solution, form: str = THETA, binary: Format = BINARY64
) -> tuple[Function, ...]:
    """Return all generated functions for one form of the solution, before optimisation.

    Unused lines are still there, and no common part is shared.
    """
    carried = {f.fact: f.source for every in solution.sequences.values() for f in every}

    def cited(let: Let) -> Let:
        """Cite the paper's equations behind an assignment's facts before its other references."""
        equations = [equation for fact in let.facts for equation in carried.get(fact, ())]
        return replace(let, source=tuple(dict.fromkeys((*equations, *let.source))))

    return tuple(
        replace(function, lets=tuple(map(cited, function.lets)))
        for function in _stated(solution, form, binary)
    )


def _stated(solution: Solution, form: str, binary: Format) -> tuple[Function, ...]:
    if form == STEP:
        return step(solution, binary)
    own = _pi(solution) if form == PI else _theta(solution, binary)
    return (
        exponential.function(binary),
        discriminant(solution),
        circulation(solution),
        start(solution, pi.GIVEN if form == PI else INITIAL),
        landen.step(solution),
        landen.ladder(binary),
        *own,
        *steady(solution, binary),
    )


def _theta(solution: Solution, binary: Format) -> tuple[Function, ...]:
    """Return the functions that only the theta form has."""
    return (
        nome.root_ratio(binary),
        angles.half_turns(binary),
        angles.logarithm(binary),
        *theta.circular(solution, binary),
        *theta.hyperbolic(solution, binary),
        *(sensitivity(solution) if binary is BINARY64 else ()),
    )


def _pi(solution: Solution) -> tuple[Function, ...]:
    """Return the functions that only the Pi form has."""
    return (
        angles.half_turns(),
        angles.logarithm(),
        landen.complete(),
        carlson.third_kind(),
        *pi.circular(solution),
        *pi.hyperbolic(solution),
    )


def finished(function: Function, binary: Format = BINARY64) -> Function:
    """Optimise a function: drop unused lines, expand powers, and share common subexpressions."""
    formulas = live(function.lets, function.results)
    done = replace(function, lets=share(products(formulas)), formulas=formulas)
    numbers = {constant.name for constant in constants(binary) if constant.lo is not None}
    return replace(done, extended=function.extended | (numbers & done.used()))


@cache
def constants(binary: Format = BINARY64) -> tuple[Constant, ...]:
    """Return the named numerical constants that generated functions use."""
    with mpmath.workdps(60):
        (pi_hi, pi_lo), (log_2, log_2_lo) = binary.pair(+mpmath.pi), binary.pair(+mpmath.ln2)
    return (
        Constant("pi", pi_hi, pi_lo, "pi"),
        Constant("unity", 1.0, 0.0, "1"),
        Constant("pi_hi", pi_hi, None, "pi"),
        Constant("pi_lo", pi_lo, None, "pi - pi_hi"),
        Constant("log_2", log_2, log_2_lo, "log_2"),
        Constant("never", binary.never, None, "an exponent that stands for infinity"),
        *angles.constants(binary),
        *reduction.constants(binary),
        *exponential.constants(binary),
        *pi.numbers(),
    )
