"""Engines: they compute states from prepared motions and times, by NumPy or by C compiled here.

Their states at the same times agree within the errors they are measured to have.  A warning about
an engine is given once in a process.
"""

import threading
import warnings
from functools import cache
from typing import Any

from rigidsym._engines.arrays import Outputs, States, columns, is_lenient
from rigidsym._engines.base import Engine, Prepared
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym._engines.steps import CStepper, Kicks, NumpyStepper, Stepper
from rigidsym.errors import EngineError, InputError

__all__ = [
    "ENGINES",
    "EVERY",
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

ENGINES = ("numpy", "c")
# These and the engines on modules in the paper's own form, which are never a default.
EVERY = (*ENGINES, "numpy-pi", "c-pi")
# Engines of steps, by the names of their modules.
STEPPERS = ("numpy-step", "c-step")
_LOCK = threading.Lock()
_NUMPY, _NUMPY_STEPS = NumpyEngine(), NumpyStepper()
# C's engines, or why there is none, once the user has been warned.
_WARNED: dict[str, Any] = {}


def engine(name: str) -> Engine:
    """Return the engine of a name in EVERY; without a C compiler, NumPy's for C's and a warning.

    The first call for C's may compile, for a second or two.  Raises InputError for other names.
    """
    if checked(name).startswith("c"):
        found = _compiled_or_reason(name)
        if not isinstance(found, str):
            return found
    return _numpy(name)


def exactly(name: str) -> Engine:
    """Return the engine of this name; raise InputError where there is no compiler for it."""
    return _compiled(name) if checked(name).startswith("c") else _numpy(name)


def checked(name: str, among: tuple[str, ...] = EVERY) -> str:
    """Return the name; raise InputError unless it is among those."""
    if name not in among:
        raise InputError("engine", repr(name), f"must be one of: {', '.join(among)}")
    return name


def forget() -> None:
    """Look for C's engines again at their next use."""
    _obtained.cache_clear()
    _WARNED.clear()


def stepper(name: str) -> Stepper:
    """Return the steps by one of ENGINES; NumPy's, with a warning, without a compiler."""
    if checked(name, ENGINES) == "c" and isinstance(x := _compiled_or_reason("c-step"), CStepper):
        return x
    return _NUMPY_STEPS


def exact_stepper(name: str) -> Stepper:
    """Return the steps of this name in STEPPERS; raise InputError where there is no compiler."""
    return _compiled(name) if checked(name, STEPPERS) == "c-step" else _NUMPY_STEPS


def integrator(name: str) -> CStepper | None:
    """Return the integrator under torques: None but for C's engine with a compiler."""
    found = _compiled_or_reason("c-step") if name == "c" else None
    return found if isinstance(found, CStepper) else None


def _compiled(name: str) -> Any:
    """Return an engine in C; raise InputError where there is none."""
    found = _obtained(name)[0]
    if isinstance(found, str):
        raise InputError("engine", name, found)
    return found


def _numpy(name: str) -> Engine:
    """Return NumPy's engine of the form that a name has."""
    if "-" not in name:
        return _NUMPY
    # Here, because the default does not need it.
    from rigidsym.generated import torque_free_pi

    return NumpyEngine(torque_free_pi)


def _compiled_or_reason(name: str) -> Any:
    """Return what `_obtained` does, with a warning to the caller's caller at the first time."""
    found = _WARNED.get(name)
    if found is None:
        with _LOCK:
            found, remarks = _obtained(name)
            new, remarks[:] = remarks[:], []
        for remark in new:
            warnings.warn(remark, RuntimeWarning, stacklevel=3)
        _WARNED[name] = found
    return found


@cache
def _obtained(name: str) -> tuple[Engine | Stepper | str, list[str]]:
    """Return one of C's engines, or why there is none, and warnings that were not given yet."""
    # Here, because NumPy's engine needs nothing of it.
    from rigidsym._engines.build import library
    from rigidsym._engines.c_engine import CEngine
    from rigidsym._engines.compiler import CompilerError
    from rigidsym._engines.library import LibraryError

    remarks: list[str] = []
    try:
        found = library(remarks, name)
        return CStepper(found) if name in STEPPERS else CEngine(found), remarks
    except (CompilerError, LibraryError) as error:
        remarks.append(f"engine: {error}: states are computed by NumPy")
        return str(error), remarks
