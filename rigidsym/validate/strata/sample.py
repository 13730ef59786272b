"""What a stratum is, and what is drawn from it."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from random import Random

Floats = tuple[float, ...]
Numbers = tuple[float | Fraction, ...]
Exact = tuple[Fraction, ...]


@dataclass(frozen=True, slots=True)
class Motion:
    """Inertia (3) and rates (3), and the attitude (4) where it is not any."""

    inertia: Numbers
    omega0: Numbers
    attitude0: Numbers | None = None


@dataclass(frozen=True, slots=True)
class Sample:
    """One case: inertia (3), rates (3), attitude (4) and times, of the stratum it stands for."""

    stratum: str
    index: int
    inertia: Numbers
    omega0: Numbers
    attitude0: Numbers
    times: Floats

    @property
    def exact(self) -> tuple[Exact, Exact, Exact]:
        """Inertia, rates and attitude, as what their numbers mean."""
        return fractions(self.inertia), fractions(self.omega0), fractions(self.attitude0)

    @property
    def in_doubles(self) -> bool:
        """Whether doubles say all of its numbers."""
        numbers = (*self.inertia, *self.omega0, *self.attitude0)
        return not any(isinstance(x, Fraction) for x in numbers)


Body = Callable[[Random, int], Motion]
Times = Callable[[Random, int, Motion], Floats]


@dataclass(frozen=True, slots=True)
class Stratum:
    """A source of cases by index: `about` says in one line what it covers, and how far.

    size: how many different cases there are, or None where there is no end of them.
    """

    name: str
    about: str
    body: Body
    times: Times
    size: int | None = None


def fractions(values: Numbers) -> Exact:
    """What numbers mean."""
    return tuple(Fraction(x) for x in values)
