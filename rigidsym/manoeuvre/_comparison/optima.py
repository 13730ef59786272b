"""Optimal control of a case: each task from each guess, with each setting of the optimiser."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre._comparison.cases import Case
from rigidsym.manoeuvre._comparison.collocation import (
    Cost,
    Driven,
    Guess,
    Mesh,
    Model,
    Task,
    guessed,
    still,
)
from rigidsym.manoeuvre._comparison.flights import constant, turned
from rigidsym.manoeuvre._comparison.optimiser import SETTINGS, Posed, optimum
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._rotation import angle, relative
from rigidsym.manoeuvre.flight._settings import Wheels

TASKS = tuple(
    Task(model, cost, limited)
    for model in Model
    for cost, limited in ((Cost.FUEL, True), (Cost.FUEL, False), (Cost.ENERGY, True))
)
SAME = 1e-4
"Relative difference below which two costs count as the same."


@dataclass(frozen=True, slots=True)
class Attempt:
    """A search from one guess; cost: N m s for fuel, N^2 m^2 s for energy."""

    cost: float
    iterations: int
    converged: bool


@dataclass(frozen=True, slots=True)
class Solved:
    """A task that was solved.

    best: the least cost of all attempts that converged.  miss: degrees from the target at which
    the best torques arrive by another integrator.  attempts: by setting and guess.
    """

    best: float
    miss: float
    attempts: Mapping[str, Mapping[str, Attempt]]

    def to_data(self) -> dict[str, Any]:
        """Return the entries of the schema rigidsym.comparison/1, with who found the best."""
        attempts = {
            setting: {
                guess: {**asdict(one), "best": self.is_best(one)} for guess, one in guesses.items()
            }
            for setting, guesses in self.attempts.items()
        }
        return {"best": self.best, "miss": self.miss, "attempts": attempts}

    def is_best(self, one: Attempt) -> bool:
        """Return whether an attempt found the best cost."""
        return one.converged and one.cost <= self.best * (1 + SAME)


def guesses(case: Case, transfer: Transfer) -> Mapping[str, Guess]:
    """Return the first guesses by name; times from 0 to 1, attitudes relative to the start."""

    def natural(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, omega = transfer.motion(t * case.duration)
        return relative(case.start, q), omega * case.duration

    eigenaxis = partial(turned, case.rotation_vector, constant)
    return {"natural": natural, "eigenaxis": eigenaxis, "still": still}


def solved(case: Case, task: Task, begin: Mapping[str, Guess]) -> tuple[Solved, np.ndarray]:
    """Solve a task from each guess, and return the impulses of the best on the mesh, too.

    These are without units.  The limit of torques is the wheels'.  Raises InputError where no
    attempt converges.
    """
    largest = float(case.inertia.max())
    inertia, mesh = case.inertia / largest, Mesh()
    posed = Posed(inertia, case.turn, Wheels().max_torque * case.duration**2 / largest)
    points = {name: guessed(mesh, inertia, task.model, motion) for name, motion in begin.items()}
    found = {
        setting: {
            name: optimum(task, posed, point, setting, mesh) for name, point in points.items()
        }
        for setting in SETTINGS
    }
    every = [one for several in found.values() for one in several.values() if one.converged]
    if not every:
        rule = f"{task.name}: no optimum was found; another seed has other manoeuvres"
        raise InputError("manoeuvre", case.index, rule)
    best = min(every, key=lambda one: one.cost)
    impulses = best.trajectory.impulses
    arrived, _ = Driven(task.model, inertia, impulses, mesh).end
    # Impulses are in the largest moment over the duration.
    impulse = largest / case.duration
    cost = impulse if task.cost is Cost.FUEL else impulse**2 / case.duration
    attempts = {
        setting: {
            name: Attempt(one.cost * cost, one.iterations, one.converged)
            for name, one in several.items()
        }
        for setting, several in found.items()
    }
    miss = float(np.degrees(angle(case.turn, arrived)))
    return Solved(best.cost * cost, miss, attempts), impulses
