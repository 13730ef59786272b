"""`seal(solution)`: every decision about formulas, before anything is printed."""

from collections.abc import Iterator

from rigidsym.codegen.functions import constants, functions, stated
from rigidsym.codegen.ir import Function
from rigidsym.codegen.seal import facts, frame, order, sharing, states
from rigidsym.codegen.seal.claims import Claim
from rigidsym.solution import Solution


def seal(solution: Solution) -> int:
    """Decide every formula that generated code stands for; returns how many decisions there were.

    Raises InputError, naming it, for the first that the lines do not give.
    """
    origin, every = stated(solution), functions(solution)
    order.check(every, {number.name for number in constants()})
    frame.check(every)
    decided = 0
    for claim in _claims(solution, origin, every):
        claim.decide()
        decided += 1
    return decided


def _claims(
    solution: Solution, origin: tuple[Function, ...], every: tuple[Function, ...]
) -> Iterator[Claim]:
    yield from sharing.claims(origin, every)
    yield from facts.claims(solution, every)
    yield from states.claims(solution, every)
