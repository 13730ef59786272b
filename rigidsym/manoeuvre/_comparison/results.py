"""A comparison: the records of all manoeuvres, their statistics by pandas, and the files."""

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from pandas import DataFrame

from rigidsym._version import __version__
from rigidsym.io._files import write_bytes, write_text
from rigidsym.manoeuvre._comparison import flights, optima, page
from rigidsym.manoeuvre._comparison.cases import IMPULSE, Case
from rigidsym.manoeuvre._comparison.collocation import INTERVALS, POINTS, Cost, Model, Task
from rigidsym.manoeuvre._comparison.flights import Flown
from rigidsym.manoeuvre._comparison.optima import Solved
from rigidsym.manoeuvre._comparison.optimiser import MOST_ITERATIONS, SETTINGS, TOLERANCE
from rigidsym.manoeuvre.flight._settings import Controller, Wheels
from rigidsym.view._plots.figure import rendered
from rigidsym.view._plots.spreads import Panel, spreads

SCHEMA = "rigidsym.comparison/1"
PACKAGES = ("casadi", "numpy", "scipy")
_SPREADS = (
    *("torque_integral", "torque_square", "torque_peak", "error_at_duration", "error_after_hold"),
    *("over_natural", "over_least_fuel", "over_least_square"),
)
_DRAWN = Task(Model.THRUSTERS, Cost.FUEL)


@dataclass(frozen=True, slots=True)
class Record:
    """The results of one manoeuvre.

    flown: by actuators and method.  ideal: by actuators and way, N m s.  solved: by task.
    """

    case: Case
    flown: Mapping[str, Mapping[str, Flown]]
    ideal: Mapping[str, Mapping[str, float]]
    solved: Mapping[str, Solved]

    def least(self, model: str, cost: Cost = Cost.FUEL, limited: bool = True) -> float:
        """Return the least cost that was found, N m s of fuel, N^2 m^2 s of energy."""
        return self.solved[Task(Model(model), cost, limited).name].best

    def to_data(self) -> dict[str, Any]:
        """Return the entries of the schema rigidsym.comparison/1."""
        return {
            **self.case.to_data(),
            "flown": {
                model: {name: asdict(one) for name, one in methods.items()}
                for model, methods in self.flown.items()
            },
            "ideal": {name: dict(ways) for name, ways in self.ideal.items()},
            "optimal": {name: one.to_data() for name, one in self.solved.items()},
        }


@dataclass(frozen=True)
class Comparison:
    """Records of the manoeuvres from 0 on of a seed."""

    seed: int
    records: tuple[Record, ...]

    @cached_property
    def flown(self) -> DataFrame:
        """A row for each flight: manoeuvre, actuators, method, measures and their ratios."""
        return DataFrame(
            {
                "manoeuvre": record.case.index,
                "actuators": model,
                "method": method,
                **asdict(one),
                "over_natural": one.torque_integral / methods["natural"].torque_integral,
                "over_least_fuel": one.torque_integral / record.least(model),
                "over_least_square": one.torque_square / record.least(model, Cost.ENERGY),
            }
            for record in self.records
            for model, methods in record.flown.items()
            for method, one in methods.items()
        )

    @cached_property
    def ideal(self) -> DataFrame:
        """A row for each way with ideal bursts: its ratio to the least fuel without limits."""
        return DataFrame(
            {
                "manoeuvre": record.case.index,
                "actuators": model,
                "method": way,
                "ratio": cost / record.least(model, limited=False),
            }
            for record in self.records
            for model, ways in record.ideal.items()
            for way, cost in ways.items()
        )

    @cached_property
    def attempts(self) -> DataFrame:
        """A row for each search: iterations, and whether it converged, was best, was quickest."""
        frame = DataFrame(
            {
                "manoeuvre": record.case.index,
                "task": task,
                "setting": setting,
                "guess": guess,
                "iterations": one.iterations,
                "converged": one.converged,
                "best": solved.is_best(one),
            }
            for record in self.records
            for task, solved in record.solved.items()
            for setting, guesses in solved.attempts.items()
            for guess, one in guesses.items()
        )
        done = frame["iterations"].where(frame["converged"])
        same = [frame[name] for name in ("manoeuvre", "task", "setting")]
        return frame.assign(fewest=done == done.groupby(same).transform("min"))

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Spreads and counts: flights by actuators and method, ideal bursts, optima by task."""
        optimal = _grouped(self.attempts, ["task", "setting", "guess"], _attempts)
        return {
            "flown": _grouped(self.flown, ["actuators", "method"], _measures),
            "ideal": _grouped(
                self.ideal, ["actuators", "method"], lambda ways: spread(ways["ratio"])
            ),
            "optimal": {
                task: {
                    "miss": max(record.solved[task].miss for record in self.records),
                    "attempts": attempts,
                }
                for task, attempts in optimal.items()
            },
        }

    @property
    def command(self) -> str:
        """The command that makes this comparison."""
        return f"rigidsym compare --manoeuvres {len(self.records)} --seed {self.seed}"

    def to_data(self) -> dict[str, Any]:
        """Return the schema rigidsym.comparison/1: no times, so that it is the same on each run."""
        return {
            "schema": SCHEMA,
            "command": self.command,
            "settings": {
                "impulse": IMPULSE,
                "hold": flights.HOLD,
                "period": float(flights.PERIOD),
                "wheels": asdict(Wheels()),
                "controller": asdict(Controller()),
                "intervals": INTERVALS,
                "points": POINTS,
                "tolerance": TOLERANCE,
                "most_iterations": MOST_ITERATIONS,
                "same": optima.SAME,
                "optimiser": {name: dict(options) for name, options in SETTINGS.items()},
            },
            "packages": {"rigidsym": __version__, **{name: version(name) for name in PACKAGES}},
            "summary": self.summary,
            "manoeuvres": [record.to_data() for record in self.records],
        }

    def to_json(self) -> str:
        """Return the same as text."""
        return json.dumps(self.to_data(), indent=1) + "\n"

    def tables(self) -> list[page.Table]:
        """Return titles, columns and rows for terminals."""
        return page.tables(self.summary)

    @property
    def conclusion(self) -> str:
        """The costs of the natural motion beside the least fuel and beside all other ways."""
        return page.conclusion(self.summary, len(self.records))

    def write(self, directory: Path) -> list[Path]:
        """Write comparison.json, comparison.md and the picture; raises InputError."""
        text = page.page(self.command, len(self.records), self.summary)
        written = [
            write_text(directory / "comparison.json", self.to_json()),
            write_text(directory / "comparison.md", text),
        ]
        picture = spreads(self._panels(), "one manoeuvre", "the least fuel")
        for suffix, data in rendered(picture).items():
            written.append(write_bytes(directory / f"comparison.{suffix}", data))
        return written

    def _panels(self) -> list[Panel]:
        """Return a dot for each manoeuvre: costs by method, iterations by guess."""
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
            *(Panel(f"flown with {one}", label, costs[one], True) for one in reversed(Model)),
            Panel(title, "iterations of IPOPT", iterations, False),
        ]


def spread(values: Iterable[float]) -> dict[str, float]:
    """Return least, quartiles and most.

    >>> spread([4, 1, 2, 3, 5])["median"]
    3.0
    """
    found = np.quantile(list(values), [0, 0.25, 0.5, 0.75, 1]).tolist()
    return dict(zip(("min", "q1", "median", "q3", "max"), found, strict=True))


def _grouped(frame: DataFrame, columns: list[str], measure: Callable[[DataFrame], Any]) -> Any:
    """Return measures of groups as nested dicts by the values of columns, in order of rows."""
    first, *rest = columns
    return {
        str(key): _grouped(group, rest, measure) if rest else measure(group)
        for key, group in frame.groupby(first, sort=False)
    }


def _measures(flown: DataFrame) -> dict[str, Any]:
    """Return spreads of the flights by one method, and in how many something is so."""
    return {
        **{name: spread(flown[name]) for name in _SPREADS},
        "cheaper_than_natural": int((flown["over_natural"] < 1).sum()),
        "dearer_than_natural": int((flown["over_natural"] > 1).sum()),
        "saturated": int(flown["saturated"].sum()),
    }


def _attempts(tried: DataFrame) -> dict[str, Any]:
    """Return iterations, None where no search converged; and how many did, were best, quickest."""
    done = tried["iterations"][tried["converged"]]
    counts = {name: int(tried[name].sum()) for name in ("converged", "best", "fewest")}
    return {"iterations": spread(done) if len(done) else None, **counts}
