"""Libraries of the C engine that a wheel brings, so that no compiler is needed.

The folder `shipped` is there in wheels for one platform alone, as `wheels.py` builds them.  It has
one library with the same bits on every processor, and one for each code path, by levels of x86-64.
"""

import ctypes
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from rigidsym._engines.library import Library, LibraryError, load

FOLDER = Path(__file__).parent / "shipped"
# The engines whose modules are in each library.
MODULES = ("c", "c-step", "c-pi")
PORTABLE = "portable"
# Code paths by the level that `processor.c` finds.
PATHS = {0: "arm64", 1: "x86-64", 3: "x86-64-v3", 4: "x86-64-v4"}
_ENDS = {"win32": ".dll", "darwin": ".dylib"}


def library(engine: str, sources: Mapping[str, str]) -> Library | None:
    """Return the shipped library of an engine, or None if there is none.

    Raises LibraryError if it cannot be loaded or was built from other sources.
    """
    module = engine.removesuffix("-portable")
    path = code_path() if module in MODULES else None
    if path is None:
        return None
    return load(_place(path if module == engine else PORTABLE), sources)


@cache
def code_path() -> str | None:
    """Return the name of the code path for this processor, or None without shipped libraries.

    Raises LibraryError if the library that finds it cannot be loaded.
    """
    place = _place(PORTABLE)
    if not place.is_file():
        return None
    try:
        return PATHS[ctypes.CDLL(str(place)).torque_free_processor_level()]
    except (OSError, AttributeError, KeyError) as error:
        raise LibraryError(f"{place} cannot be loaded ({error})") from None


def _place(name: str) -> Path:
    return FOLDER / f"{name}{_ENDS.get(sys.platform, '.so')}"
