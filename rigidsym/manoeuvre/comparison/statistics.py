"""Spreads of figures over manoeuvres, and who was better how often."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TypedDict

import numpy as np

from rigidsym.manoeuvre.comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre.comparison.flights import METHODS, Flown
from rigidsym.manoeuvre.comparison.optima import TASKS, Attempt, Solved
from rigidsym.manoeuvre.comparison.record import Record

Spread = Mapping[str, float]


class FlownSpread(TypedDict):
    """Of the flights by one method: spreads, and in how many manoeuvres something was so."""

    torque_integral: Spread
    torque_square: Spread
    torque_peak: Spread
    error_at_duration: Spread
    error_after_hold: Spread
    over_natural: Spread
    over_least_fuel: Spread
    over_least_square: Spread
    cheaper_than_natural: int
    dearer_than_natural: int
    saturated: int


class AttemptSpread(TypedDict):
    """Of the attempts from one guess: iterations, None where none converged; how many did, found
    the best, and were quickest."""

    iterations: Spread | None
    converged: int
    best: int
    fewest: int


# By setting of the optimiser and guess.
Attempts = Mapping[str, Mapping[str, AttemptSpread]]


class SolvedSpread(TypedDict):
    """Of a task: the largest miss, degrees, and what its attempts gave."""

    miss: float
    attempts: Attempts


class Summary(TypedDict):
    """Flights by actuators and method, ideal bursts by actuators and way, optima by task."""

    flown: Mapping[str, Mapping[str, FlownSpread]]
    ideal: Mapping[str, Mapping[str, Spread]]
    optimal: Mapping[str, SolvedSpread]


def spread(values: Iterable[float]) -> Spread:
    """Least, quartiles and most.

    >>> spread([4, 1, 2, 3, 5])["median"]
    3.0
    """
    found = np.quantile(list(values), [0, 0.25, 0.5, 0.75, 1]).tolist()
    return dict(zip(("min", "q1", "median", "q3", "max"), found, strict=True))


def summary(records: Sequence[Record]) -> Summary:
    """All of it, for files and pages."""
    return {
        "flown": {model.value: _flown(records, model) for model in Model},
        "ideal": {model.value: _ideal(records, model) for model in Model},
        "optimal": {task.name: _optimal(records, task) for task in TASKS},
    }


def least(record: Record, model: Model, limited: bool, cost: Cost = Cost.FUEL) -> float:
    """The least cost that was found for a manoeuvre, N m s of fuel, N^2 m^2 s of energy."""
    return record.solved[Task(model, cost, limited).name].best


def _flown(records: Sequence[Record], model: Model) -> dict[str, FlownSpread]:
    return {method: _method(records, model, method) for method in METHODS}


def _method(records: Sequence[Record], model: Model, method: str) -> FlownSpread:
    """Spreads, counts, and the torque integral over that of the natural motion."""
    flown: list[Flown] = [record.flown[model.value][method] for record in records]
    natural = [record.flown[model.value]["natural"].torque_integral for record in records]
    ratios = [one.torque_integral / x for one, x in zip(flown, natural, strict=True)]
    return {
        "torque_integral": spread(one.torque_integral for one in flown),
        "torque_square": spread(one.torque_square for one in flown),
        "torque_peak": spread(one.torque_peak for one in flown),
        "error_at_duration": spread(one.error_at_duration for one in flown),
        "error_after_hold": spread(one.error_after_hold for one in flown),
        "over_natural": spread(ratios),
        "over_least_fuel": spread(
            one.torque_integral / least(record, model, limited=True)
            for one, record in zip(flown, records, strict=True)
        ),
        "over_least_square": spread(
            one.torque_square / least(record, model, limited=True, cost=Cost.ENERGY)
            for one, record in zip(flown, records, strict=True)
        ),
        "cheaper_than_natural": sum(x < 1 for x in ratios),
        "dearer_than_natural": sum(x > 1 for x in ratios),
        "saturated": sum(one.saturated for one in flown),
    }


def _ideal(records: Sequence[Record], model: Model) -> dict[str, Spread]:
    """Over the least fuel without limits of the torque."""
    ways = records[0].ideal[model.value]
    return {
        way: spread(
            record.ideal[model.value][way] / least(record, model, limited=False)
            for record in records
        )
        for way in ways
    }


def _optimal(records: Sequence[Record], task: Task) -> SolvedSpread:
    solved = [record.solved[task.name] for record in records]
    return {
        "miss": max(one.miss for one in solved),
        "attempts": {
            setting: {guess: _attempts(solved, setting, guess) for guess in guesses}
            for setting, guesses in solved[0].attempts.items()
        },
    }


def _attempts(solved: Sequence[Solved], setting: str, guess: str) -> AttemptSpread:
    """See `AttemptSpread`."""
    tried = [one.attempts[setting][guess] for one in solved]
    done = [one.iterations for one in tried if one.converged]
    return {
        "iterations": spread(done) if done else None,
        "converged": len(done),
        "best": sum(one.is_best(tried[k]) for k, one in enumerate(solved)),
        "fewest": sum(_is_quickest(one.attempts[setting], guess) for one in solved),
    }


def _is_quickest(attempts: Mapping[str, Attempt], guess: str) -> bool:
    """Whether no other guess of the same setting took fewer iterations."""
    ends = [one.iterations for one in attempts.values() if one.converged]
    return attempts[guess].converged and attempts[guess].iterations == min(ends)
