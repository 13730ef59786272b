"""Engines by name; what has to be said about one is said once in a process."""

import threading
import warnings
from functools import cache
from typing import Any

from rigidsym.engines.numpy_engine import NumpyEngine
from rigidsym.engines.protocol import Engine
from rigidsym.engines.steps import CStepper, NumpyStepper, Stepper
from rigidsym.errors import InputError

ENGINES = ("numpy", "c")
# Those and the ones on modules in the paper's own form, which nobody is given unasked.
EVERY = (*ENGINES, "numpy-pi", "c-pi")
# What makes steps, by the names of their modules.
STEPPERS = ("numpy-step", "c-step")
_LOCK = threading.Lock()
_NUMPY_STEPS = NumpyStepper()
# What every caller has been told of.
_TOLD: dict[str, Any] = {}


def engine(name: str) -> Engine:
    """The engine of a name in EVERY; without a C compiler, a warning and NumPy's for C's.

    The first call for C's may compile, for a second or two.  Raises InputError for other names.
    """
    return _c_or_numpy(name) if checked(name).startswith("c") else _numpy(name)


def exactly(name: str) -> Engine:
    """The engine of a name and no other; raises InputError where it cannot be had."""
    return _compiled(name) if checked(name).startswith("c") else _numpy(name)


def checked(name: str, among: tuple[str, ...] = EVERY) -> str:
    """The name; raises InputError unless it is among those."""
    if name not in among:
        raise InputError("engine", repr(name), f"must be one of: {', '.join(among)}")
    return name


def forget() -> None:
    """Look for C's engines again when one is next asked for."""
    _obtained.cache_clear()
    _TOLD.clear()


def stepper(name: str) -> Stepper:
    """What makes steps, by one of ENGINES; as `engine` where there is no compiler."""
    return _c_stepper(checked(name, ENGINES)) or _NUMPY_STEPS


def exact_stepper(name: str) -> Stepper:
    """What makes steps by one of STEPPERS and no other; raises InputError where there is none."""
    return _compiled(name) if checked(name, STEPPERS) == "c-step" else _NUMPY_STEPS


def integrator(name: str) -> CStepper | None:
    """What makes many steps with kicks between them; None but for C's engine with a compiler."""
    return _c_stepper(name)


def _c_stepper(name: str) -> CStepper | None:
    found = _told("c-step", 4) if name == "c" else None
    return found if isinstance(found, CStepper) else None


def _compiled(name: str) -> Any:
    """What C computes by; raises InputError where it cannot be had."""
    found = _obtained(name)[0]
    if isinstance(found, str):
        raise InputError("engine", name, found)
    return found


def _numpy(name: str) -> Engine:
    if name == "numpy":
        return NumpyEngine()
    # Here, because who asks for the default does not need it.
    from rigidsym.generated import torque_free_pi

    return NumpyEngine(torque_free_pi)


def _c_or_numpy(name: str) -> Engine:
    found = _told(name, 4)
    return _numpy(name.replace("c", "numpy", 1)) if isinstance(found, str) else found


def _told(name: str, level: int) -> Any:
    """What `_obtained` has, with a warning for all that nobody has heard."""
    found = _TOLD.get(name)
    if found is None:
        with _LOCK:
            found, remarks = _obtained(name)
            heard, remarks[:] = remarks[:], []
        for remark in heard:
            warnings.warn(remark, RuntimeWarning, stacklevel=level)
        _TOLD[name] = found
    return found


@cache
def _obtained(name: str) -> tuple[Engine | Stepper | str, list[str]]:
    """One of C's engines or why there is none, looked for once; remarks nobody has heard yet."""
    # Here, because NumPy's engine needs nothing of it.
    from rigidsym.engines.build import library
    from rigidsym.engines.c_engine import CEngine
    from rigidsym.engines.compiler import CompilerError
    from rigidsym.engines.library import LibraryError

    remarks: list[str] = []
    try:
        found = library(remarks, name)
        engine = CStepper(found) if name in STEPPERS else CEngine(found)
        return engine, remarks
    except (CompilerError, LibraryError) as error:
        remarks.append(f"engine: {error}: states are computed by NumPy")
        return str(error), remarks
