"""Random manoeuvres, shared among processes; the result does not depend on how they are shared.

The work is cut into pieces of a second or two, which processes share well and stop soon.  Each
piece draws and plans its manoeuvre anew, or takes it from a cache.
"""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field
from functools import lru_cache, partial
from itertools import islice, product
from typing import TypeVar

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._comparison import flights, optima
from rigidsym.manoeuvre._comparison.cases import Case, draw
from rigidsym.manoeuvre._comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre._comparison.flights import METHODS, Flown, Ways
from rigidsym.manoeuvre._comparison.optima import TASKS, Solved
from rigidsym.manoeuvre._comparison.results import Comparison, Record
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.validate._executors import Place, local

MANOEUVRES, SEED = 20, 1
MOST_MANOEUVRES, MOST_SEED = 10_000, 2**32

_WAYS = tuple(product(Model, METHODS))
Found = TypeVar("Found")


def compare(
    manoeuvres: int = MANOEUVRES,
    seed: int = SEED,
    *,
    workers: int | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Comparison:
    """Compare ways to turn on random manoeuvres from rest to rest.

    Parameters
    ----------
    manoeuvres : int
        Number of manoeuvres; a smaller number has the first ones of a larger.
    seed : int
        Seed of bodies and attitudes.
    workers : int, optional
        Number of processes; by default one for each core.
    progress : callable
        Called with the pieces of work done and all of them.

    Returns
    -------
    Comparison
        Costs of all ways, with statistics, tables and files.

    Raises
    ------
    InputError
        For a number out of range, or where a flight or an optimum fails.
    """
    count = inputs.whole("manoeuvres", manoeuvres, MOST_MANOEUVRES)
    chosen = inputs.whole("seed", seed, MOST_SEED)
    total = count * (len(TASKS) + len(_WAYS) + 1)
    with local(workers) as place:
        work = _Work(place, total, progress)
        return Comparison(chosen, tuple(_records(work, chosen, range(count))))


def _records(work: "_Work", seed: int, indices: Sequence[int]) -> list[Record]:
    """Solve optimal control first, since its motions are flown."""
    tasks, ways = list(product(indices, TASKS)), list(product(indices, _WAYS))
    solved = dict(
        zip(tasks, work.done([partial(_solved, seed, *one) for one in tasks]), strict=True)
    )
    calls = [
        partial(_flown, seed, k, model, method, solved[k, Task(model, Cost.FUEL)][1])
        for k, (model, method) in ways
    ]
    flown = dict(zip(ways, work.done(calls), strict=True))
    ideals = work.done([partial(_ideals, seed, k) for k in indices])
    return [
        Record(
            draw(k, seed),
            {model.value: {way: flown[k, (model, way)] for way in METHODS} for model in Model},
            ideals[k],
            {task.name: solved[k, task][0] for task in TASKS},
        )
        for k in indices
    ]


def _solved(seed: int, index: int, task: Task) -> tuple[Solved, np.ndarray]:
    case, transfer = _planned(seed, index)
    return optima.solved(case, task, optima.guesses(case, transfer))


def _flown(seed: int, index: int, model: Model, method: str, impulses: np.ndarray) -> Flown:
    case, transfer = _planned(seed, index)
    return flights.flown(method, Ways(case, model, transfer, impulses))


def _ideals(seed: int, index: int) -> Mapping[str, Mapping[str, float]]:
    case, transfer = _planned(seed, index)
    return {model.value: flights.ideal(case, model, transfer) for model in Model}


@lru_cache(maxsize=8)
def _planned(seed: int, index: int) -> tuple[Case, Transfer]:
    case = draw(index, seed)
    return case, solve(case.manoeuvre).best


@dataclass(slots=True)
class _Work:
    """Pieces of work in one place, some of them ahead; how many of all are done."""

    place: Place
    total: int
    progress: Callable[[int, int], None]
    finished: int = field(default=0)

    def done(self, calls: Sequence[Callable[[], Found]]) -> list[Found]:
        """Return the results of calls, in their order."""
        left = iter(enumerate(calls))
        pending: dict[Future[Found], int] = {}
        found: dict[int, Found] = {}
        while len(found) < len(calls):
            for k, call in islice(left, self.place.ahead - len(pending)):
                pending[self.place.submit(call)] = k
            ended, _ = wait(pending, return_when=FIRST_COMPLETED)
            for future in ended:
                found[pending.pop(future)] = future.result()
                self.finished += 1
                self.progress(self.finished, self.total)
        return [found[k] for k in range(len(calls))]
