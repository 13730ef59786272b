"""Random manoeuvres, shared among processes; one result however they are shared."""

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field
from functools import partial
from itertools import islice, product
from typing import TypeVar

from rigidsym import inputs
from rigidsym.manoeuvre.comparison import pieces
from rigidsym.manoeuvre.comparison.cases import draw
from rigidsym.manoeuvre.comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre.comparison.flights import METHODS
from rigidsym.manoeuvre.comparison.optima import TASKS
from rigidsym.manoeuvre.comparison.record import Record
from rigidsym.manoeuvre.comparison.results import Comparison
from rigidsym.validate.executors import Place, local

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
    """Ways to turn, compared on random manoeuvres from rest to rest; raises InputError.

    manoeuvres: how many; the first ones of a larger number are those of a smaller one.  seed: of
    the bodies and attitudes.  workers: processes, one for each core by default.  progress: called
    with the pieces of work done and all of them.
    """
    count = inputs.whole("manoeuvres", manoeuvres, MOST_MANOEUVRES)
    chosen = inputs.whole("seed", seed, MOST_SEED)
    total = count * (len(TASKS) + len(_WAYS) + 1)
    with local(workers) as place:
        work = _Work(place, total, progress)
        return Comparison(chosen, tuple(_records(work, chosen, range(count))))


def _records(work: "_Work", seed: int, indices: Sequence[int]) -> list[Record]:
    """Optimal control first: its motions are flown."""
    tasks, ways = list(product(indices, TASKS)), list(product(indices, _WAYS))
    solved = dict(
        zip(tasks, work.done([partial(pieces.solved, seed, *one) for one in tasks]), strict=True)
    )
    calls = [
        partial(pieces.flown, seed, k, model, method, solved[k, Task(model, Cost.FUEL)][1])
        for k, (model, method) in ways
    ]
    flown = dict(zip(ways, work.done(calls), strict=True))
    ideals = work.done([partial(pieces.ideals, seed, k) for k in indices])
    return [
        Record(
            draw(k, seed),
            {model.value: {way: flown[k, (model, way)] for way in METHODS} for model in Model},
            ideals[k],
            {task.name: solved[k, task][0] for task in TASKS},
        )
        for k in indices
    ]


@dataclass(slots=True)
class _Work:
    """Pieces of work in one place, some of them ahead; how many are done of all."""

    place: Place
    total: int
    progress: Callable[[int, int], None]
    finished: int = field(default=0)

    def done(self, calls: Sequence[Callable[[], Found]]) -> list[Found]:
        """What calls give, in their order."""
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
