"""Optimal control of a case: each task from each guess, with each setting of the optimiser."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import TypedDict

import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre.comparison import tracks
from rigidsym.manoeuvre.comparison.cases import Case
from rigidsym.manoeuvre.comparison.collocation import (
    Cost,
    Guess,
    Model,
    Optimum,
    Posed,
    Task,
    guessed,
    optimum,
)
from rigidsym.manoeuvre.comparison.collocation.driven import Driven
from rigidsym.manoeuvre.comparison.collocation.guess import still
from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh
from rigidsym.manoeuvre.comparison.collocation.solver import SETTINGS
from rigidsym.manoeuvre.flight.rotation import angle, relative
from rigidsym.manoeuvre.flight.settings import Wheels
from rigidsym.manoeuvre.transfer import Transfer

TASKS = tuple(
    Task(model, cost, limited)
    for model in Model
    for cost, limited in ((Cost.FUEL, True), (Cost.FUEL, False), (Cost.ENERGY, True))
)
SAME = 1e-4
"Relative: costs that differ by less are the same."


class AttemptData(TypedDict):
    """An attempt of the schema rigidsym.comparison/1; best: whether it found the best."""

    cost: float
    iterations: int
    converged: bool
    best: bool


class SolvedData(TypedDict):
    """What was solved, of the same schema; attempts: by setting and guess."""

    best: float
    miss: float
    attempts: dict[str, dict[str, AttemptData]]


@dataclass(frozen=True, slots=True)
class Attempt:
    """cost: N m s for fuel, N^2 m^2 s for energy."""

    cost: float
    iterations: int
    converged: bool


@dataclass(frozen=True, slots=True)
class Solved:
    """best: the least cost of all attempts that converged.  miss: degrees from the target where
    its torques lead by another integrator.  attempts: by setting and guess."""

    best: float
    miss: float
    attempts: Mapping[str, Mapping[str, Attempt]]

    def to_data(self) -> SolvedData:
        """For files, with whether each attempt found the best."""
        attempts = {
            setting: {guess: self._told(one) for guess, one in guesses.items()}
            for setting, guesses in self.attempts.items()
        }
        return {"best": self.best, "miss": self.miss, "attempts": attempts}

    def is_best(self, one: Attempt) -> bool:
        """Whether an attempt arrived where the best did."""
        return one.converged and one.cost <= self.best * (1 + SAME)

    def _told(self, one: Attempt) -> AttemptData:
        return {
            "cost": one.cost,
            "iterations": one.iterations,
            "converged": one.converged,
            "best": self.is_best(one),
        }


def guesses(case: Case, transfer: Transfer) -> Mapping[str, Guess]:
    """Where optimisers begin, by name; times from 0 to 1, attitudes from the start's axes."""

    def natural(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, omega = transfer.motion(t * case.duration)
        return relative(case.start, q), omega * case.duration

    eigenaxis = partial(tracks.turned, case.rotation_vector, tracks.constant)
    return {"natural": natural, "eigenaxis": eigenaxis, "still": still}


def posed(case: Case) -> Posed:
    """A case without units; the torques' limit is the wheels'."""
    largest = case.inertia.max()
    limit = Wheels().max_torque * case.duration**2 / largest
    return Posed(case.inertia / largest, case.turn, float(limit))


def solved(case: Case, task: Task, begin: Mapping[str, Guess]) -> tuple[Solved, np.ndarray]:
    """All attempts at a task, and the impulses of the best, without units, on the mesh.

    Raises InputError where no attempt converges.
    """
    without_units, mesh = posed(case), Mesh()
    points = {
        name: guessed(mesh, without_units.inertia, task.model, motion)
        for name, motion in begin.items()
    }
    found = {
        setting: {
            name: optimum(task, without_units, point, setting, mesh)
            for name, point in points.items()
        }
        for setting in SETTINGS
    }
    every = [one for several in found.values() for one in several.values() if one.converged]
    if not every:
        rule = f"{task.name}: no optimum was found; another seed has other manoeuvres"
        raise InputError("manoeuvre", case.index, rule)
    best = min(every, key=lambda one: one.cost)
    motion = Driven(task.model, without_units.inertia, best.trajectory.impulses, mesh)
    attempts = {
        setting: {name: _attempt(case, task, one) for name, one in several.items()}
        for setting, several in found.items()
    }
    miss = float(np.degrees(angle(case.turn, motion.end[0])))
    return Solved(_cost(case, task, best), miss, attempts), best.trajectory.impulses


def _attempt(case: Case, task: Task, one: Optimum) -> Attempt:
    return Attempt(_cost(case, task, one), one.iterations, one.converged)


def _cost(case: Case, task: Task, one: Optimum) -> float:
    """In units: impulses are in the largest moment over the duration."""
    impulse = float(case.inertia.max()) / case.duration
    return one.cost * (impulse if task.cost is Cost.FUEL else impulse**2 / case.duration)
