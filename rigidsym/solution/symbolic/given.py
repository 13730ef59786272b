"""A motion as SymPy's numbers."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from rigidsym.solution.polhode import Polhode


@dataclass(frozen=True, slots=True)
class Given:
    """A motion in exact numbers: moments, rates, a unit quaternion, and its kind."""

    inertia: tuple[Any, ...]
    omega0: tuple[Any, ...]
    attitude0: tuple[Any, ...]
    polhode: Polhode
    exact: tuple[Sequence[Fraction], Sequence[Fraction]]
