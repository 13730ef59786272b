"""Results of the comparison on random manoeuvres, with their statistics and files.

The results do not depend on how the work is shared among processes.  It is cut into pieces of a
second or two, which processes share well and stop soon.  Each piece draws and plans its manoeuvre
anew, or takes it from a cache.
"""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import asdict, dataclass
from functools import cached_property, lru_cache, partial
from importlib.metadata import version
from itertools import count, islice, product
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from pandas import DataFrame

from rigidsym import _inputs as inputs
from rigidsym._version import __version__
from rigidsym.io._files import write_all
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._comparison import flights, optimiser, page
from rigidsym.manoeuvre._comparison.collocation import MESH, Cost, Model, Task
from rigidsym.manoeuvre._comparison.flights import IMPULSE, METHODS, Case, draw
from rigidsym.manoeuvre._comparison.optimiser import TASKS
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._settings import Controller, Wheels
from rigidsym.validate._executors import Place, local
from rigidsym.view._plots.charts import Spread, spreads
from rigidsym.view._plots.figure import files

SCHEMA = "rigidsym.comparison/1"
PACKAGES = ("casadi", "numpy", "scipy")
_SPREADS = (
    *("torque_integral", "torque_square", "torque_peak", "error_at_duration", "error_after_hold"),
    *("over_natural", "over_least_fuel", "over_least_square"),
)
_DRAWN = Task(Model.THRUSTERS, Cost.FUEL)

# The entry of a manoeuvre in the schema.  flown: measures by actuators and method.  ideal: N m s by
# actuators and way.  optimal: best, miss and attempts by task.
Record = Mapping[str, Any]

MANOEUVRES, SEED = 20, 1
MOST_MANOEUVRES, MOST_SEED = 10_000, 2**32

_WAYS = tuple(product(Model, METHODS))
Found = TypeVar("Found")


@dataclass(frozen=True)
class Comparison:
    """The results of a comparison on random manoeuvres."""

    seed: int
    records: tuple[Record, ...]

    @cached_property
    def flown(self) -> DataFrame:
        """Table of all flights with their measures and cost ratios."""
        return DataFrame(
            {
                "manoeuvre": record["index"],
                "actuators": model,
                "method": method,
                **one,
                "over_natural": one["torque_integral"] / methods["natural"]["torque_integral"],
                "over_least_fuel": one["torque_integral"] / _least(record, model),
                "over_least_square": one["torque_square"] / _least(record, model, Cost.ENERGY),
            }
            for record in self.records
            for model, methods in record["flown"].items()
            for method, one in methods.items()
        )

    @cached_property
    def ideal(self) -> DataFrame:
        """Table of the ideal costs, as ratios to the least fuel without torque limits."""
        return DataFrame(
            {
                "manoeuvre": record["index"],
                "actuators": model,
                "method": way,
                "ratio": cost / _least(record, model, limited=False),
            }
            for record in self.records
            for model, ways in record["ideal"].items()
            for way, cost in ways.items()
        )

    @cached_property
    def attempts(self) -> DataFrame:
        """Table of all attempts of the optimiser, with their iterations and success.

        It has whether each attempt converged, found the least cost, or needed the fewest
        iterations.
        """
        frame = DataFrame(
            {"manoeuvre": record["index"], "task": task, "setting": setting, "guess": guess, **one}
            for record in self.records
            for task, solved in record["optimal"].items()
            for setting, guesses in solved["attempts"].items()
            for guess, one in guesses.items()
        )
        done = frame["iterations"].where(frame["converged"])
        same = [frame[name] for name in ("manoeuvre", "task", "setting")]
        return frame.assign(fewest=done == done.groupby(same).transform("min"))

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Statistics of the flights, of the ideal costs and of optimal control.

        They are spreads and counts, by actuators and method, or by task, setting and guess.
        """
        optimal = _grouped(self.attempts, ["task", "setting", "guess"], _attempts)
        return {
            "flown": _grouped(self.flown, ["actuators", "method"], _measures),
            "ideal": _grouped(
                self.ideal, ["actuators", "method"], lambda ways: spread(ways["ratio"])
            ),
            "optimal": {
                task: {
                    "miss": max(record["optimal"][task]["miss"] for record in self.records),
                    "attempts": attempts,
                }
                for task, attempts in optimal.items()
            },
        }

    @property
    def command(self) -> str:
        """The command line that reproduces this comparison."""
        return f"rigidsym compare --manoeuvres {len(self.records)} --seed {self.seed}"

    def to_json(self) -> str:
        """Return the comparison as JSON in the schema rigidsym.comparison/1.

        The text is the same for each run.
        """
        data = {
            "schema": SCHEMA,
            "command": self.command,
            "settings": {
                "impulse": IMPULSE,
                "hold": flights.HOLD,
                "period": float(flights.PERIOD),
                "wheels": asdict(Wheels()),
                "controller": asdict(Controller()),
                **asdict(MESH),
                "tolerance": optimiser.TOLERANCE,
                "most_iterations": optimiser.MOST_ITERATIONS,
                "same": optimiser.SAME,
                "optimiser": optimiser.SETTINGS,
            },
            "packages": {"rigidsym": __version__, **{name: version(name) for name in PACKAGES}},
            "summary": self.summary,
            "manoeuvres": self.records,
        }
        return json.dumps(data, indent=1) + "\n"

    def tables(self) -> list[page.Table]:
        """Return the tables for terminals, each with a title, columns and rows."""
        return page.tables(self.summary)

    @property
    def conclusion(self) -> str:
        """Sentences that compare the cost of torque-free motions with other methods."""
        return page.conclusion(self.summary, len(self.records))

    def write(self, directory: Path) -> list[Path]:
        """Write comparison.json, comparison.md and the picture to a directory.

        Raises InputError where that fails.
        """
        text = page.page(self.command, len(self.records), self.summary)
        picture = spreads(self._panels(), "one manoeuvre", "the least fuel")
        texts = {"comparison.json": self.to_json(), "comparison.md": text}
        return write_all(directory, {**texts, **files({"comparison": picture})})

    def _panels(self) -> list[Spread]:
        """Return the panels of the picture, with costs by method and iterations by guess."""
        label, title = "torque integral over the least fuel", f"optimal control: {_DRAWN.name}"
        costs = _grouped(
            self.flown, ["actuators", "method"], lambda one: one["over_least_fuel"].tolist()
        )
        tried = self.attempts[self.attempts["task"] == _DRAWN.name]
        iterations = {
            f"{guess},\n{setting}": one["iterations"].astype(float).tolist()
            for (setting, guess), one in tried.groupby(["setting", "guess"], sort=False)
        }
        return [
            *(Spread(f"flown with {one}", label, costs[one], True) for one in reversed(Model)),
            Spread(title, "iterations of IPOPT", iterations, False),
        ]


def _least(record: Record, model: str, cost: Cost = Cost.FUEL, limited: bool = True) -> float:
    """Return the least cost that the optimiser found for a manoeuvre.

    It is in N m s for fuel, and in N^2 m^2 s for energy.
    """
    return record["optimal"][Task(Model(model), cost, limited).name]["best"]


def spread(values: Iterable[float]) -> dict[str, float]:
    """Return the minimum, quartiles and maximum of some values.

    >>> spread([4, 1, 2, 3, 5])["median"]
    3.0
    """
    found = np.quantile(list(values), [0, 0.25, 0.5, 0.75, 1]).tolist()
    return dict(zip(("min", "q1", "median", "q3", "max"), found, strict=True))


def _grouped(frame: DataFrame, columns: list[str], measure: Callable[[DataFrame], Any]) -> Any:
    """Group the rows of a table by columns and measure each group.

    Return nested dictionaries with a level for each column.
    """
    first, *rest = columns
    return {
        str(key): _grouped(group, rest, measure) if rest else measure(group)
        for key, group in frame.groupby(first, sort=False)
    }


def _measures(flown: DataFrame) -> dict[str, Any]:
    """Return statistics of all flights by one method.

    They are spreads, and counts of flights that are cheaper, dearer or saturated.
    """
    return {
        **{name: spread(flown[name]) for name in _SPREADS},
        "cheaper_than_natural": int((flown["over_natural"] < 1).sum()),
        "dearer_than_natural": int((flown["over_natural"] > 1).sum()),
        "saturated": int(flown["saturated"].sum()),
    }


def _attempts(tried: DataFrame) -> dict[str, Any]:
    """Return statistics of the optimiser's attempts from one first guess.

    They are the spread of iterations, and how many attempts converged, were best or quickest.
    """
    done = tried["iterations"][tried["converged"]]
    counts = {name: int(tried[name].sum()) for name in ("converged", "best", "fewest")}
    return {"iterations": spread(done) if len(done) else None, **counts}


def compare(
    manoeuvres: int = MANOEUVRES,
    seed: int = SEED,
    *,
    workers: int | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Comparison:
    """Compare control methods on random manoeuvres from rest to rest.

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
    """Return the results of all manoeuvres.

    Optimal control is solved first, because its motions are flown.
    """
    tasks, ways = list(product(indices, TASKS)), list(product(indices, _WAYS))
    calls = [partial(_call_for_case, seed, k, optimiser.solved, task) for k, task in tasks]
    solved = dict(zip(tasks, work(calls), strict=True))
    calls = [
        partial(_call_for_case, seed, k, flights.flown, *way, solved[k, Task(way[0], Cost.FUEL)][1])
        for k, way in ways
    ]
    flown = dict(zip(ways, work(calls), strict=True))
    ideals = work([partial(_call_for_case, seed, k, flights.ideals) for k in indices])
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


def _call_for_case(seed: int, index: int, work: Callable[..., Found], *given: object) -> Found:
    """Call a function with the random manoeuvre of an index and its cheapest transfer."""
    return work(*_planned(seed, index), *given)


@lru_cache(maxsize=8)
def _planned(seed: int, index: int) -> tuple[Case, Transfer]:
    case = draw(index, seed)
    return case, solve(case.manoeuvre).best


def results(
    place: Place, tell: Callable[[], None], calls: Sequence[Callable[[], Found]]
) -> list[Found]:
    """Run calls in other processes and return their results in order.

    `tell` is called after each.

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
