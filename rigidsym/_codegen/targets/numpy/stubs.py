"""Placeholders for the names that a generated NumPy module defines before its runtime.

These are functions, tables and limits.  Linters and type checkers find the names here.  Each stands
for anything.
"""

from typing import Any


def __getattr__(name: str) -> Any:
    if name.startswith("__") or not (name.isupper() or name.startswith("_") or name == "never"):
        raise AttributeError(name)
    return None
