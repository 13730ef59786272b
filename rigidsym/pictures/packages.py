"""The packages that draw, or one line that says which is missing."""

from importlib import import_module
from typing import Any


def package(name: str, user: str) -> Any:
    """A module by its name; raises ImportError with one line where it is not installed."""
    try:
        return import_module(name)
    except ImportError:
        needed = name.partition(".")[0]
        message = f"{user} needs {needed} (extra lab): pip install 'rigidsym[lab]'"
        raise ImportError(message) from None
