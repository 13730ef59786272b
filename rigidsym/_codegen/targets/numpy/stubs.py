"""Stand-ins for what a generated module defines before its runtime: functions, tables, limits.

Linters and type checkers find the names here.  Each stands for anything.
"""

from typing import Any


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    return None
