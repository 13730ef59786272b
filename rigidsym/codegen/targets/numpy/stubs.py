"""What `frame` finds around it in the generated module, for linters and type checkers."""

from typing import Any

from rigidsym.codegen.targets.numpy.double_double import _Pair, _two_sum

__all__ = [
    "BRANCHES",
    "DECISIVE",
    "FAINTEST",
    "FARTHEST",
    "FASTEST",
    "NEGLIGIBLE",
    "START",
    "THINNEST",
    "TOLERATED",
    "_Pair",
    "_excess",
    "_steady_plan",
    "_two_sum",
]

START: dict[str, Any] = {}
NEGLIGIBLE = DECISIVE = FAINTEST = THINNEST = TOLERATED = FARTHEST = FASTEST = 1.0
BRANCHES: dict[str, Any] = {}


def _excess(*values: Any) -> Any:
    raise NotImplementedError


def _steady_plan(*values: Any) -> Any:
    raise NotImplementedError
