"""The packages of extras, or one line that says which are missing."""

from importlib import import_module
from importlib.util import find_spec
from typing import Any


def package(name: str, user: str) -> Any:
    """A module of the extra `lab` by its name; raises ImportError, in one line, without it."""
    try:
        return import_module(name)
    except ImportError:
        raise _missing(user, [name.partition(".")[0]], "lab") from None


def require(user: str, *names: str, extra: str = "app") -> None:
    """Raise ImportError, in one line, for the packages of these names that are not installed.

    They are looked for and not imported: some take long.
    """
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        raise _missing(user, missing, extra)


def _missing(user: str, names: list[str], extra: str) -> ImportError:
    needed = ", ".join(names)
    message = f"{user} needs {needed} (extra {extra}): pip install 'rigidsym[{extra}]'"
    return ImportError(message, name=names[0])
