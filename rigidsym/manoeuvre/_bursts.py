"""Costs of motions and their limits, in the units of the dimensionless problem.

Momenta are in the largest moment of inertia over the duration, rates in 1 over the duration.
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._problem import Problem
from rigidsym.manoeuvre._transit import peaks

# Relative room for rounding at limits.
_ROUNDING = 1e-12


@dataclass(frozen=True)
class Bursts:
    """Bursts at both ends of motions that take 1 s, and their limits.

    before, after (3,): momenta outside of the motion, over the largest moment.  max_rate,
    max_burst: limits of rates and of either burst, inf where there is none.
    """

    problem: Problem
    before: np.ndarray
    after: np.ndarray
    max_rate: float
    max_burst: float

    @classmethod
    def of(cls, problem: Problem, manoeuvre: Manoeuvre) -> "Bursts":
        """Return the bursts of a manoeuvre."""
        largest = max(manoeuvre.inertia)

        def momentum(spin: tuple[Fraction, ...]) -> np.ndarray:
            return np.array(
                [float(c * w / largest) for c, w in zip(manoeuvre.inertia, spin, strict=True)]
            )

        rate, burst = manoeuvre.limits.max_rate, manoeuvre.limits.max_burst
        return cls(
            problem,
            momentum(manoeuvre.start_spin),
            momentum(manoeuvre.target_spin),
            np.inf if rate is None else float(rate),
            np.inf if burst is None else float(burst / largest),
        )

    @cached_property
    def spin(self) -> float:
        """Sum of the momenta before and after, a bound of the cost's distance from 2 K."""
        return float(np.linalg.norm(self.before) + np.linalg.norm(self.after))

    def sizes(self, rates: np.ndarray, duration: float) -> np.ndarray:
        """Return the sizes of both bursts (N, 2) of motions with rates (N, 3)."""
        begin = self.problem.inertia * rates
        end = begin @ self.problem.rotation
        bursts = [begin - duration * self.before, duration * self.after - end]
        return np.stack([np.linalg.norm(burst, axis=1) for burst in bursts], axis=1)

    def allowed(self, rates: np.ndarray, duration: float) -> np.ndarray:
        """Return True for each motion (N,) that keeps to the limits."""
        return self.excess(rates, duration) <= 1 + _ROUNDING

    def excess(self, rates: np.ndarray, duration: float) -> np.ndarray:
        """Return the greater ratio (N,) of rate and burst to their limits, for each motion."""
        needed = self.sizes(rates, duration).max(axis=1) / (self.max_burst * duration)
        if np.isfinite(self.max_rate):
            needed = np.maximum(needed, peaks(self.problem, rates) / (self.max_rate * duration))
        return needed

    def most(self, duration: float) -> float:
        """Return a momentum beyond which no motion keeps to the limits."""
        ends = [np.linalg.norm(end) for end in (self.before, self.after)]
        return duration * float(min([self.max_rate, *(self.max_burst + end for end in ends)]))

    @np.errstate(divide="ignore")
    def shortest(self, rates: np.ndarray) -> np.ndarray:
        """Return the shortest duration (N,) in which each motion keeps to the limits; else inf."""
        fastest = np.full(len(rates), np.inf)
        slowest = np.zeros(len(rates))
        if np.isfinite(self.max_rate):
            fastest = self.max_rate / peaks(self.problem, rates)
        begin = self.problem.inertia * rates
        for end, outside in ((begin, self.before), (begin @ self.problem.rotation, self.after)):
            low, high = _within(end, outside, self.max_burst)
            slowest, fastest = np.maximum(slowest, low), np.minimum(fastest, high)
        return np.where(slowest <= fastest * (1 + _ROUNDING), 1 / fastest, np.inf)


@np.errstate(divide="ignore", invalid="ignore")
def _within(end: np.ndarray, outside: np.ndarray, limit: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the interval of factors s (N,) with |s end - outside| within a limit."""
    if not np.isfinite(limit):
        return np.zeros(len(end)), np.full(len(end), np.inf)
    square, mixed = np.sum(end * end, axis=1), end @ outside
    root = mixed * mixed - square * (outside @ outside - limit * limit)
    found = (mixed + np.sqrt(root) * np.array([[-1.0], [1.0]])) / square
    if outside @ outside <= limit * limit:
        found[:, square == 0] = [[0.0], [np.inf]]
    never = np.isnan(found[0]) | (found[1] <= 0)
    return np.where(never, np.inf, np.maximum(found[0], 0)), np.where(never, 0.0, found[1])
