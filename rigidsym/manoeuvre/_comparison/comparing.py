"""The comparison on random manoeuvres, computed by several processes.

The results do not depend on how the work is shared.  It is cut into pieces of a second or two,
which processes share well and stop soon.  Each piece draws and plans its manoeuvre anew, or takes
it from a cache.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import asdict
from functools import lru_cache, partial
from itertools import count, islice, product
from typing import Any, TypeVar

from rigidsym import _inputs as inputs
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._comparison import flights, optimiser
from rigidsym.manoeuvre._comparison.cases import Case, draw
from rigidsym.manoeuvre._comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre._comparison.flights import METHODS
from rigidsym.manoeuvre._comparison.optimiser import TASKS
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
    indices = range(inputs.whole("manoeuvres", manoeuvres, MOST_MANOEUVRES))
    chosen = inputs.whole("seed", seed, MOST_SEED)
    total, done = len(indices) * (len(TASKS) + len(_WAYS) + 1), count(1)
    with local(workers) as place:
        work = partial(results, place, lambda: progress(next(done), total))
        return Comparison(chosen, tuple(_records(work, chosen, indices)))


def _records(
    work: Callable[[Sequence[Callable[[], Any]]], list[Any]], seed: int, indices: Sequence[int]
) -> list[Record]:
    """Return the results of all manoeuvres; optimal control is first, as its motions are flown."""
    tasks, ways = list(product(indices, TASKS)), list(product(indices, _WAYS))
    calls = [partial(_piece, seed, k, optimiser.solved, task) for k, task in tasks]
    solved = dict(zip(tasks, work(calls), strict=True))
    calls = [
        partial(_piece, seed, k, flights.flown, *way, solved[k, Task(way[0], Cost.FUEL)][1])
        for k, way in ways
    ]
    flown = dict(zip(ways, work(calls), strict=True))
    ideals = work([partial(_piece, seed, k, flights.ideals) for k in indices])
    return [
        {
            **draw(k, seed).to_data(),
            "flown": {
                model.value: {way: asdict(flown[k, (model, way)]) for way in METHODS}
                for model in Model
            },
            "ideal": ideals[k],
            "optimal": {task.name: solved[k, task][0] for task in TASKS},
        }
        for k in indices
    ]


def _piece(seed: int, index: int, work: Callable[..., Found], *given: object) -> Found:
    """Return a piece of work on the manoeuvre of an index and its cheapest transfer."""
    return work(*_planned(seed, index), *given)


@lru_cache(maxsize=8)
def _planned(seed: int, index: int) -> tuple[Case, Transfer]:
    case = draw(index, seed)
    return case, solve(case.manoeuvre).best


def results(
    place: Place, tell: Callable[[], None], calls: Sequence[Callable[[], Found]]
) -> list[Found]:
    """Return the results of calls, in their order; `tell` is called after each.

    The place gets some calls ahead, and no more once one has failed.
    """
    left = iter(enumerate(calls))
    pending: dict[Future[Found], int] = {}
    found: dict[int, Found] = {}
    while len(found) < len(calls):
        for k, call in islice(left, place.ahead - len(pending)):
            pending[place.submit(call)] = k
        ended, _ = wait(pending, return_when=FIRST_COMPLETED)
        for future in ended:
            found[pending.pop(future)] = future.result()
            tell()
    return [found[k] for k in range(len(calls))]
