"""Engines: what turns prepared motions and times into states, by NumPy or by C compiled here.

Both follow one protocol, and their states at given times agree within the errors they are measured
to have.
"""

from rigidsym.engines.arrays import SIZES, columns, is_lenient
from rigidsym.engines.choice import (
    ENGINES,
    EVERY,
    STEPPERS,
    checked,
    engine,
    exact_stepper,
    exactly,
    integrator,
    stepper,
)
from rigidsym.engines.protocol import Engine, EngineError, Outputs, Prepared, States
from rigidsym.engines.steps import Kicks, Stepper

__all__ = [
    "ENGINES",
    "EVERY",
    "SIZES",
    "STEPPERS",
    "Engine",
    "EngineError",
    "Kicks",
    "Outputs",
    "Prepared",
    "States",
    "Stepper",
    "checked",
    "columns",
    "engine",
    "exact_stepper",
    "exactly",
    "integrator",
    "is_lenient",
    "stepper",
]
