"""Validation campaigns that compare an application's true errors with those it promises.

An application is a table of strata, each with a function that draws a case, and a measure.
"""

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from random import Random
from typing import Generic, TypeVar

import numpy as np

from rigidsym.errors import unknown

Case = TypeVar("Case")
HEADS = ("stratum", "cases", "refused", "median", "worst", "worst case", "far off")


@dataclass(frozen=True, slots=True)
class Outcome:
    """Result of one case of an application.

    share: the true error over the promised error, None if the case was refused.
    """

    stratum: str
    index: int
    share: float | None


@dataclass(frozen=True, slots=True)
class Goal:
    """Limits that the results of a campaign must keep.

    refused: the part of cases that may be refused.  most: the share that `part` of the errors may
    reach at most.  worst: the share that all errors may reach at most.
    """

    refused: float
    most: float
    part: float
    worst: float

    def broken(self, outcomes: Sequence[Outcome]) -> Iterator[str]:
        """Yield a sentence for each limit of the goal that the results exceed."""
        shares = [x.share for x in outcomes if x.share is not None]
        refused = len(outcomes) - len(shares)
        if refused > self.refused * len(outcomes):
            yield f"{refused} of {len(outcomes)} cases are refused, above {self.refused:.0%}"
        above = sum(not share <= self.most for share in shares)
        if above > (1 - self.part) * len(shares):
            yield f"{above} of {len(shares)} errors are above {self.most:g} times the promised"
        worst = float(np.max(shares, initial=0.0))
        if not worst <= self.worst:
            yield f"the worst error is {worst:.3g} times the promised, above {self.worst:g}"


@dataclass(frozen=True, slots=True)
class Application(Generic[Case]):
    """Application under test, with its strata of cases, its error measure and its goal.

    measure: returns the true error of a case over the promised one, None if it was refused.
    """

    name: str
    strata: dict[str, Callable[[Random], Case]]
    measure: Callable[[Case], float | None]
    goal: Goal

    def draw(self, stratum: str, index: int, seed: int) -> Case:
        """Draw one random case of a stratum.

        The same seed, stratum and index always give the same case.
        """
        return self.strata[stratum](Random(f"{self.name}:{stratum}:{index}:{seed}"))

    def outcomes(self, cases: int, seed: int, strata: Collection[str] = ()) -> Iterator[Outcome]:
        """Draw and measure cases of each stratum, and yield their outcomes.

        cases: the number in each stratum.  strata: names, all by default.  Raises InputError for a
        stratum that does not exist.
        """
        for name in strata:
            if name not in self.strata:
                raise unknown("stratum", name, self.strata, plain=True)
        for stratum in strata or self.strata:
            for index in range(cases):
                share = self.measure(self.draw(stratum, index, seed))
                yield Outcome(stratum, index, share)

    def rows(self, outcomes: Sequence[Outcome]) -> Iterator[tuple[str, ...]]:
        """Yield a table row with the results of each stratum.

        The columns are those of `HEADS`.
        """
        for stratum in dict.fromkeys(x.stratum for x in outcomes):
            every = [x for x in outcomes if x.stratum == stratum]
            found = sorted((x.share, x.index) for x in every if x.share is not None)
            counts = str(len(every)), str(len(every) - len(found))
            if not found:
                yield stratum, *counts, "", "", "", ""
                continue
            worst, index = found[-1]
            above = sum(not share <= self.goal.most for share, _ in found)
            shares = f"{found[len(found) // 2][0]:.2g}", f"{worst:.3g}"
            far = f"{above} above {self.goal.most:g}"
            yield stratum, *counts, *shares, f"{stratum}:{index}", far
