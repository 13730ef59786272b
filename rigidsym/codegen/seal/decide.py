"""`seal(solution)`: every decision about formulas, before anything is printed."""

from collections.abc import Iterator

from rigidsym.codegen.forms import THETA
from rigidsym.codegen.functions import constants, functions, stated
from rigidsym.codegen.ir import Function
from rigidsym.codegen.seal import facts, frame, order, sharing, states
from rigidsym.codegen.seal.claims import Claim
from rigidsym.solution import Solution


def seal(solution: Solution, form: str = THETA) -> int:
    """Decide every formula that generated code stands for; returns how many decisions there were.

    Raises InputError, naming it, for the first that the lines do not give.
    """
    origin, every = stated(solution, form), functions(solution, form)
    order.check(every, {number.name for number in constants()})
    frame.check(every, form)
    decided = 0
    for claim in _claims(solution, origin, every, form):
        claim.decide()
        decided += 1
    return decided


def _claims(
    solution: Solution, origin: tuple[Function, ...], every: tuple[Function, ...], form: str
) -> Iterator[Claim]:
    yield from sharing.claims(origin, every)
    yield from facts.claims(solution, every, form)
    yield from states.claims(solution, every, form)
