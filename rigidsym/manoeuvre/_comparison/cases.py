"""Random manoeuvres from rest to rest: every other one with the paper's body."""

from dataclasses import dataclass
from functools import cached_property
from math import ceil
from typing import Any

import numpy as np

from rigidsym._engines import engine
from rigidsym.manoeuvre._manoeuvre import Manoeuvre, manoeuvre
from rigidsym.manoeuvre._problem import Problem, problem, unit

PAPER = ("0.0109", "0.04", "0.0506")
"Principal moments of the paper's Figure 3, kg m^2."
LARGEST_MOMENTS = 0.02, 0.06
"Range of the largest moment of random bodies, kg m^2: nano-spacecraft as well."
IMPULSE = 1e-3
"""N m s: it decides durations.  In a duration the whole angle can be turned about the axis of the
largest moment at constant rate with this momentum.  A burst of it takes a wheel of the paper 1 s
at its limit; the paper's controller takes 60 percent of the limit, 2 zeta omega_n times it."""
ROUNDED, SHORTEST = 10, 60
"s: durations are whole multiples of the first, and at least the second, 18 times the loop's."
_DIGITS = 6


@dataclass(frozen=True)
class Case:
    """A random manoeuvre and its index; `body` is "paper" or "random"."""

    index: int
    body: str
    manoeuvre: Manoeuvre

    @cached_property
    def problem(self) -> Problem:
        """The dimensionless problem of the manoeuvre; no motion is computed with its engine."""
        asked = self.manoeuvre
        return problem(asked.inertia, asked.start, asked.target, engine("numpy"))

    @cached_property
    def inertia(self) -> np.ndarray:
        """Principal moments (3,), kg m^2."""
        return np.array([float(x) for x in self.manoeuvre.inertia])

    @property
    def duration(self) -> float:
        """Time from the first burst to the last, s."""
        return float(self.manoeuvre.duration or 0)

    @cached_property
    def start(self) -> np.ndarray:
        """Attitude (4,) at t = 0, of length 1."""
        return unit(self.manoeuvre.start)

    @property
    def rotation_vector(self) -> np.ndarray:
        """The turn from start to target as axis times angle (3,), rad, by the shorter way."""
        vector = self.problem.turn[1:]
        return self.problem.angle * vector / np.linalg.norm(vector)

    def to_data(self) -> dict[str, Any]:
        """Return the entries of the schema rigidsym.comparison/1."""
        return {
            "index": self.index,
            "body": self.body,
            "angle": float(np.degrees(self.problem.angle)),
            "manoeuvre": self.manoeuvre.to_data(),
        }


def draw(index: int, seed: int) -> Case:
    """Draw the manoeuvre of an index; attitudes are random in space, with six decimals."""
    rng = np.random.default_rng([seed, index])
    body = "random" if index % 2 else "paper"
    start, target = (_rounded(rng.normal(size=4)) for _ in range(2))
    inertia = PAPER
    if body == "random":
        # Moments of a positive distribution of mass.
        x, y, z = rng.uniform(0.05, 1, size=3)
        moments = np.array([y + z, z + x, x + y])
        inertia = _rounded(moments * rng.uniform(*LARGEST_MOMENTS) / moments.max())
    quickest = Case(index, body, manoeuvre(inertia, start, target, SHORTEST))
    impulse = quickest.inertia.max() * quickest.problem.angle
    duration = max(SHORTEST, ROUNDED * ceil(impulse / IMPULSE / ROUNDED))
    return Case(index, body, manoeuvre(inertia, start, target, duration))


def _rounded(values: np.ndarray) -> tuple[str, ...]:
    return tuple(f"{x:.{_DIGITS}f}" for x in values.tolist())
