"""Engines by name; what has to be said about one is said once in a process."""

import threading
import warnings
from functools import cache

from rigidsym.engines.numpy_engine import NumpyEngine
from rigidsym.engines.protocol import Engine
from rigidsym.errors import InputError

ENGINES = ("numpy", "c")
_LOCK = threading.Lock()


def engine(name: str) -> Engine:
    """The engine of a name in ENGINES; without a C compiler, a warning and NumPy's for "c".

    The first call for "c" may compile, for a second or two.  Raises InputError for other names.
    """
    return NumpyEngine() if checked(name) == "numpy" else _c_or_numpy()


def exactly(name: str) -> Engine:
    """The engine of a name and no other; raises InputError where it cannot be had."""
    if checked(name) == "numpy":
        return NumpyEngine()
    found, _ = _obtained()
    if isinstance(found, str):
        raise InputError("engine", name, found)
    return found


def checked(name: str) -> str:
    """The name; raises InputError unless it is in ENGINES."""
    if name not in ENGINES:
        raise InputError("engine", repr(name), f"must be one of: {', '.join(ENGINES)}")
    return name


def forget() -> None:
    """Look for C's engine again when it is next asked for."""
    _obtained.cache_clear()


def _c_or_numpy() -> Engine:
    with _LOCK:
        found, remarks = _obtained()
        heard, remarks[:] = remarks[:], []
    for remark in heard:
        warnings.warn(remark, RuntimeWarning, stacklevel=3)
    return NumpyEngine() if isinstance(found, str) else found


@cache
def _obtained() -> tuple[Engine | str, list[str]]:
    """C's engine or why there is none, looked for once; remarks that nobody has heard yet."""
    # Here, because NumPy's engine needs nothing of it.
    from rigidsym.engines.build import library
    from rigidsym.engines.c_engine import CEngine
    from rigidsym.engines.compiler import CompilerError
    from rigidsym.engines.library import LibraryError

    remarks: list[str] = []
    try:
        return CEngine(library(remarks)), remarks
    except (CompilerError, LibraryError) as error:
        remarks.append(f"engine: {error}: states are computed by NumPy")
        return str(error), remarks
