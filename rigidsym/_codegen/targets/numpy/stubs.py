"""Names that `runtime` finds around it in the generated module, for linters and type checkers."""

from collections.abc import Callable
from typing import TypedDict, TypeVar

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import (
    _DoubleDouble,
    _largest,
    _ldexp,
    _power,
    _product_error,
    _reversed,
    _sqrt,
    _taken,
    _two_sum,
    _where,
)

__all__ = [
    "BRANCHES",
    "DECISIVE",
    "INITIAL_STATE",
    "MAX_ANGLE",
    "MAX_CIRCULAR",
    "MAX_RATE",
    "MAX_REAL",
    "MIN_DISCRIMINANT",
    "MIN_MOMENT_RATIO",
    "NEGLIGIBLE",
    "SENSITIVITY",
    "TOLERATED",
    "_DoubleDouble",
    "_circulation",
    "_discriminant",
    "_largest",
    "_ldexp",
    "_power",
    "_product_error",
    "_reversed",
    "_sqrt",
    "_steady_constants",
    "_taken",
    "_two_sum",
    "_where",
    "never",
]

Value = TypeVar("Value")
Arrays = Callable[..., tuple[np.ndarray, ...]]


class Step(TypedDict):
    """A function of constants, the names of what it takes, and of what it gives."""

    constants: Arrays
    given: tuple[str, ...]
    names: tuple[str, ...]


class Branch(Step):
    """The functions of a branch: angles by rates and time, states by angles and shape.

    `fast` are the rates that limit the time.
    """

    angles: Arrays
    state: Arrays
    rates: tuple[str, ...]
    shape: tuple[str, ...]
    fast: tuple[str, ...]
    steady: bool


INITIAL_STATE: Step = {"constants": lambda: (), "given": (), "names": ()}
NEGLIGIBLE = DECISIVE = MIN_DISCRIMINANT = MIN_MOMENT_RATIO = TOLERATED = 1.0
MAX_CIRCULAR = MAX_ANGLE = MAX_RATE = MAX_REAL = MAX_STEP = 1.0
STEPS = LAST = 1
never = 1.0
BRANCHES: dict[str, Branch] = {}


class Part(Step, total=False):
    """The functions of a part of the sensitivities.

    `state` of the quantities `timed`, then of constants gives the results; `angles` are by rates
    and time.
    """

    angles: Arrays
    state: Arrays
    rates: tuple[str, ...]
    timed: tuple[str, ...]
    shape: tuple[str, ...]
    results: tuple[str, ...]


SENSITIVITY: dict[str, Part] = {}


def _discriminant(*values: Value) -> Value:
    raise NotImplementedError


def _circulation(*values: float | np.ndarray) -> np.ndarray:
    raise NotImplementedError


def _steady_constants(*values: _DoubleDouble | np.ndarray) -> tuple[np.ndarray, ...]:
    raise NotImplementedError


def _derived(*values: _DoubleDouble | np.ndarray) -> tuple[np.ndarray, ...]:
    raise NotImplementedError


_step_body = _step_start = _step_first = _step_doubled = _step_projected = _derived
_step_second_half = _step_last_projected = _step_last_second_half = _step_rates = _derived
_step_shortest_before = _step_front = _step_shortest = _step_attitude = _step_kick = _derived
