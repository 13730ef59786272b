"""What `runtime` finds around it in the generated module, for linters and type checkers."""

from typing import Any

from rigidsym.codegen.targets.numpy.double_double import _DoubleDouble, _two_sum

__all__ = [
    "BRANCHES",
    "DECISIVE",
    "INITIAL_STATE",
    "MAX_ANGLE",
    "MAX_RATE",
    "MIN_DISCRIMINANT",
    "MIN_MOMENT_RATIO",
    "NEGLIGIBLE",
    "TOLERATED",
    "_DoubleDouble",
    "_discriminant",
    "_steady_constants",
    "_two_sum",
]

INITIAL_STATE: dict[str, Any] = {}
NEGLIGIBLE = DECISIVE = MIN_DISCRIMINANT = MIN_MOMENT_RATIO = TOLERATED = MAX_ANGLE = MAX_RATE = 1.0
BRANCHES: dict[str, Any] = {}


def _discriminant(*values: Any) -> Any:
    raise NotImplementedError


def _steady_constants(*values: Any) -> Any:
    raise NotImplementedError
