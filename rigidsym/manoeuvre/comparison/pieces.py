"""The work on a manoeuvre, in pieces of a second or two: processes share it well, and stop soon.

Each piece draws and plans its manoeuvre anew, or remembers it.
"""

from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre.comparison import flights, optima
from rigidsym.manoeuvre.comparison.cases import Case, draw
from rigidsym.manoeuvre.comparison.collocation import Model, Task
from rigidsym.manoeuvre.comparison.flights import Flown, Ways
from rigidsym.manoeuvre.comparison.ideal import ideal
from rigidsym.manoeuvre.comparison.optima import Solved
from rigidsym.manoeuvre.transfer import Transfer


def solved(seed: int, index: int, task: Task) -> tuple[Solved, np.ndarray]:
    """Optimal control, and the impulses of the best."""
    case, transfer = _planned(seed, index)
    return optima.solved(case, task, optima.guesses(case, transfer))


def flown(seed: int, index: int, model: Model, method: str, impulses: np.ndarray) -> Flown:
    """One flight."""
    case, transfer = _planned(seed, index)
    return flights.flown(method, Ways(case, model, transfer, impulses))


def ideals(seed: int, index: int) -> Mapping[str, Mapping[str, float]]:
    """Ideal bursts, by actuators and way."""
    case, transfer = _planned(seed, index)
    return {model.value: ideal(case, model, transfer) for model in Model}


@lru_cache(maxsize=8)
def _planned(seed: int, index: int) -> tuple[Case, Transfer]:
    case = draw(index, seed)
    return case, solve(case.manoeuvre).best
