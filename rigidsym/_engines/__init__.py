"""Engines that compute states: by NumPy, by compiled C, or by another process.

Everything computes by C by default, and by NumPy where there is no C compiler.  The states of
engines at the same times agree within the errors they are measured to have.  A warning about an
engine is given once in a process.
"""

import threading
import warnings
from functools import cache
from importlib import resources
from typing import Any

from rigidsym._engines.arrays import Outputs, States, columns, is_lenient
from rigidsym._engines.base import Engine, Prepared
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym._engines.steps import CStepper, KickInputs, NumpyStepper, Stepper
from rigidsym.errors import EngineError, InputError, unknown

__all__ = [
    "DEFAULT",
    "ENGINES",
    "EVERY",
    "PORTABLE",
    "SAME_BITS",
    "STEPPERS",
    "Engine",
    "EngineError",
    "KickInputs",
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
    "resolved",
    "stepper",
]

# C's engine, or NumPy's without a warning if there is no C compiler.
DEFAULT = "auto"
ENGINES = ("numpy", "c")
_INSTALLED = sorted(
    path.name.removesuffix(".map.json")
    for path in resources.files("rigidsym.generated").iterdir()
    if path.name.endswith(".map.json")
)
# In single precision only `rigidsym.validate` runs a module.
_OTHERS = [name for name in _INSTALLED if name.partition("-")[0] not in (*ENGINES, "c_single")]
# These, the engines on modules in the paper's own form, and those of other targets, which are never
# a default.
EVERY = (*ENGINES, "numpy-pi", "c-pi", *(x for x in _OTHERS if not x.endswith("-step")))
# C without fused multiply-add, which has the same bits on every processor: that of files.
PORTABLE = "c-portable"
# The C modules of the engines that compute in C, for states and for steps.
_COMPILED = {DEFAULT: "c"}
_STEPPERS = {DEFAULT: "c-step", "c": "c-step", PORTABLE: "c-step-portable"}
# Engines of steps, by the names of their modules.
STEPPERS = ("numpy-step", "c-step", *(x for x in _OTHERS if x.endswith("-step")))
# Languages of targets that compute the bits of C without fused multiply-add.
SAME_BITS = ("c", *dict.fromkeys(name.partition("-")[0] for name in _OTHERS))
_LOCK = threading.Lock()
_NUMPY, _NUMPY_STEPS = NumpyEngine(), NumpyStepper()
# C's engines, or the errors that say why there are none, by module and by the name asked for, once
# the user has been warned; and the modules whose errors a warning has told.
_KNOWN: dict[tuple[str, str], Any] = {}
_TOLD: set[str] = set()


def engine(name: str) -> Engine:
    """Return the engine with a given name, or NumPy's engine if there is no C compiler.

    Names are DEFAULT, those in EVERY, and PORTABLE.  Warns if there is no C compiler, but not for
    DEFAULT.  The first call for C's may compile, for some seconds.  Raises InputError for other
    names.
    """
    if checked(name) in _OTHERS:
        return _piped(name)
    module = _COMPILED.get(name, name)
    if module.startswith("c") and not isinstance(found := _compiled(module, name), Exception):
        return found
    return _numpy(name)


def exactly(name: str) -> Engine:
    """Return the engine with a given name, or raise InputError if it is unavailable.

    An engine is unavailable if what it needs, such as a C compiler, is missing.
    """
    return _exactly(checked(name, (*EVERY, PORTABLE)))


def stepper(name: str) -> Stepper:
    """Return the stepper of an engine, or NumPy's stepper if there is no C compiler.

    Warns if there is no C compiler, but not for DEFAULT.
    """
    module = _STEPPERS.get(checked(name, (DEFAULT, *ENGINES, PORTABLE)))
    if module and not isinstance(found := _compiled(module, name), Exception):
        return found
    return _NUMPY_STEPS


def resolved(name: str) -> str:
    """Return the name of an engine, and for DEFAULT that of the engine whose stepper it uses.

    Raises InputError for other names than those of `engine`.
    """
    if checked(name) != DEFAULT:
        return name
    return "numpy" if stepper(DEFAULT) is _NUMPY_STEPS else "c"


def exact_stepper(name: str) -> Stepper:
    """Return the stepper with a given name, or raise InputError if it is unavailable.

    Names are those in STEPPERS.  A stepper is unavailable if what it needs is missing.
    """
    return _exactly(checked(name, STEPPERS))


def integrator() -> CStepper | None:
    """Return the C stepper, which also integrates under torques.

    Returns None without a C compiler.
    """
    found = _compiled("c-step", "c")
    return None if isinstance(found, Exception) else found


def checked(name: str, among: tuple[str, ...] = (DEFAULT, *EVERY, PORTABLE)) -> str:
    """Check the name of an engine and return it.

    Raises InputError unless the name is in `among`.
    """
    if name not in among:
        raise unknown("engine", name, among)
    return name


def forget() -> None:
    """Clear the cache of C engines, so that the next use searches for a compiler again."""
    _obtained.cache_clear()
    _KNOWN.clear()
    _TOLD.clear()


def _exactly(name: str) -> Any:
    if name in _OTHERS:
        return _piped(name)
    found = _obtained(name)[0] if name.startswith("c") else _numpy(name)
    if isinstance(found, Exception):
        raise InputError("engine", name, str(found))
    return found


@cache
def _piped(name: str) -> Any:
    """Return the engine or stepper that asks a process of another target."""
    # Here, because NumPy's engine needs nothing of it.
    from rigidsym._engines.piped import PipedEngine, PipedStepper

    return PipedStepper(name) if name in STEPPERS else PipedEngine(name)


def _numpy(name: str) -> Any:
    """Return the NumPy engine or stepper with a given name."""
    if "-" not in name:
        return _NUMPY
    if name in STEPPERS:
        return _NUMPY_STEPS
    # Here, because the default does not need it.
    from rigidsym.generated import torque_free_pi

    return NumpyEngine(torque_free_pi)


def _compiled(module: str, asked: str) -> Any:
    """Return a C engine, or the error that says why there is none.

    module: the name of the C module; asked: the name of the engine that was asked for.  Problems
    cause a warning, once in a process; a missing compiler is none for DEFAULT.
    """
    found = _KNOWN.get((module, asked))
    if found is None:
        # Here, because NumPy's engine needs nothing of it.
        from rigidsym._engines.build import MissingCompilerError

        with _LOCK:
            found, remarks = _obtained(module)
            new, remarks[:] = remarks[:], []
            is_told = isinstance(found, Exception) and module not in _TOLD
            if is_told and not (asked == DEFAULT and isinstance(found, MissingCompilerError)):
                _TOLD.add(module)
                new.append(f"engine: {found}: states are computed by NumPy")
        for remark in new:
            warnings.warn(remark, RuntimeWarning, stacklevel=3)
        _KNOWN[module, asked] = found
    return found


@cache
def _obtained(name: str) -> tuple[Engine | Stepper | Exception, list[str]]:
    """Build or load a C engine, and return it with the warnings to give.

    If there is no C engine, the first result is the error with the reason.
    """
    # Here, because NumPy's engine needs nothing of it.
    from rigidsym._engines.build import CompilerError, library
    from rigidsym._engines.c_engine import CEngine
    from rigidsym._engines.library import LibraryError

    remarks: list[str] = []
    try:
        found = library(remarks, name)
        return CStepper(found) if "step" in name else CEngine(found), remarks
    except (CompilerError, LibraryError) as error:
        return error, remarks
