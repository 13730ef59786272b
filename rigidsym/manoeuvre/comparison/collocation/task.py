"""What is minimised, and for which machine."""

from dataclasses import dataclass
from enum import StrEnum


class Model(StrEnum):
    """What torques act against."""

    THRUSTERS = "thrusters"
    "The outside: J w' = -w x J w + u.  Coasting is a natural motion and free."
    WHEELS = "wheels"
    """Wheels that store what the body turns with, so that both together have no momentum:
    J w' = u.  Coasting is a turn at constant rates, about a fixed axis."""


class Cost(StrEnum):
    """What a manoeuvre costs, summed over the axes of the body."""

    FUEL = "fuel"
    "The integral of |u|."
    ENERGY = "energy"
    "The integral of u^2."


@dataclass(frozen=True, slots=True)
class Task:
    """limited: whether the torque of each axis is bounded; else bursts may be as short as the mesh
    allows."""

    model: Model
    cost: Cost
    limited: bool = True

    @property
    def name(self) -> str:
        """In words, for tables and files."""
        return f"{self.model}, {self.cost}" + ("" if self.limited else ", unlimited")
