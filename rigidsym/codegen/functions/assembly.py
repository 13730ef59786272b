"""From the solution to the functions a target prints.

A motion's constants come from extended numbers: `_initial_state` finds the invariants and the
descended functions at t = 0, and, by the modulus, `_circular_constants` or `_hyperbolic_constants`
the rest.  States are doubles, in two functions for each branch: `_<branch>_angles` finds what
changes with time, and `_<branch>_state` the state from that.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import mpmath

from rigidsym.codegen.forms import PI, STEP, THETA
from rigidsym.codegen.functions.circular import circular
from rigidsym.codegen.functions.hyperbolic import hyperbolic
from rigidsym.codegen.functions.initial_state import circulation, discriminant, start
from rigidsym.codegen.functions.pi import circular as pi_circular
from rigidsym.codegen.functions.pi import common
from rigidsym.codegen.functions.pi import hyperbolic as pi_hyperbolic
from rigidsym.codegen.functions.sensitivity import sensitivity
from rigidsym.codegen.functions.steady import steady
from rigidsym.codegen.functions.step import step
from rigidsym.codegen.ir import Constant, Function, Let
from rigidsym.codegen.names import INITIAL
from rigidsym.codegen.passes import live, products, share
from rigidsym.codegen.special_functions import (
    angles,
    carlson,
    complete,
    exponential,
    landen,
    nome,
    reduction,
)
from rigidsym.solution import Solution


def functions(solution: Solution, form: str = THETA) -> tuple[Function, ...]:
    """All functions of a form, in an order in which each calls those before it."""
    return tuple(map(finished, stated(solution, form)))


def stated(solution: Solution, form: str = THETA) -> tuple[Function, ...]:
    """All functions as they are stated, before anything is left out or shared."""
    carried = {f.fact: f.source for every in solution.sequences.values() for f in every}
    return tuple(_cited(function, carried) for function in _stated(solution, form))


def _cited(function: Function, carried: Mapping[str, tuple[str, ...]]) -> Function:
    """The function whose lines name the equations that their facts carry, before references."""
    return replace(function, lets=tuple(_with_equations(let, carried) for let in function.lets))


def _with_equations(let: Let, carried: Mapping[str, tuple[str, ...]]) -> Let:
    equations = [equation for fact in let.facts for equation in carried.get(fact, ())]
    return replace(let, source=tuple(dict.fromkeys((*equations, *let.source))))


def _stated(solution: Solution, form: str) -> tuple[Function, ...]:
    if form == STEP:
        return step(solution)
    own = _pi(solution) if form == PI else _theta(solution)
    return (
        exponential.function(),
        discriminant(solution),
        circulation(solution),
        start(solution, common.GIVEN if form == PI else INITIAL),
        landen.step(solution),
        landen.ladder(),
        *own,
        *steady(solution),
    )


def _theta(solution: Solution) -> tuple[Function, ...]:
    """What is the theta form's own."""
    return (
        nome.root_ratio(),
        angles.half_turns(),
        angles.logarithm(),
        *circular(solution),
        *hyperbolic(solution),
        *sensitivity(solution),
    )


def _pi(solution: Solution) -> tuple[Function, ...]:
    """What is the Pi form's own."""
    return (
        angles.half_turns(),
        angles.logarithm(),
        complete.complete(),
        carlson.third_kind(),
        *pi_circular.circular(solution),
        *pi_hyperbolic.hyperbolic(solution),
    )


def finished(function: Function) -> Function:
    """The function with what its results need alone, shared and without powers."""
    formulas = live(function.lets, function.results)
    done = replace(function, lets=share(products(formulas)), formulas=formulas)
    numbers = {constant.name for constant in constants() if constant.lo is not None}
    return replace(done, extended=function.extended | (numbers & done.used()))


@cache
def constants() -> tuple[Constant, ...]:
    """The named numbers that functions use."""
    with mpmath.workdps(60):
        pi, log_2 = (
            _in_two(name, value) for name, value in (("pi", mpmath.pi), ("log_2", mpmath.ln2))
        )
    halves = (
        Constant("pi_hi", pi.hi, None, "pi"),
        Constant("pi_lo", pi.lo or 0.0, None, "pi - pi_hi"),
    )
    never = Constant("never", 1e300, None, "the exponent of what has vanished")
    unity = Constant("unity", 1.0, 0.0, "1")
    return (
        pi,
        unity,
        *halves,
        log_2,
        never,
        *angles.constants(),
        *reduction.constants(),
        *exponential.constants(),
        *pi_hyperbolic.numbers(),
    )


def _in_two(name: str, value: mpmath.mpf) -> Constant:
    hi = float(value)
    return Constant(name, hi, float(value - hi), name)
