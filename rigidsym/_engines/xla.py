"""Handlers through which XLA calls the compiled engine, compiled and registered at first use."""

import ctypes
import tempfile
import threading
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

from rigidsym._engines import c_engine, exact_stepper, exactly, steps, threads
from rigidsym._engines.build import CompilerError, compile_library, find, package_sources
from rigidsym._inputs import ROUNDING
from rigidsym.errors import InputError

_SOURCE = "xla_calls.c"
# The names of the handlers, for `jax.ffi.ffi_call`.
PROPAGATE, STEP, STATES = "rigidsym_propagate", "rigidsym_step", "rigidsym_states"
_BOUND = (
    *("propagate", "propagate_with_columns", "states_at", "states_with_columns", "last_time"),
    "steps",
)
_FLAGS = ("-std=gnu11", "-O2", "-ffp-contract=off", "-fPIC", "-shared")


_LOCK = threading.Lock()


def registered() -> bool:
    """Compile the handlers for this process, and register them with JAX.

    Returns False where there is no C engine or no C compiler: then JAX calls Python.
    """
    with _LOCK:  # XLA refuses other handlers of these names
        return _registered()


@cache
def _registered() -> bool:
    from jax import ffi

    try:
        library = _compiled(ffi.include_dir())
        engines: tuple[Any, ...] = exactly("c"), exact_stepper("c-step")
    except (CompilerError, InputError, OSError):  # no place to compile, or to load from
        return False
    functions = vars(engines[0].library) | vars(engines[1].library)
    addresses = (ctypes.cast(functions[name], ctypes.c_void_p) for name in _BOUND)
    library.rigidsym_bind((ctypes.c_void_p * len(_BOUND))(*addresses))
    for name in (PROPAGATE, STEP, STATES):
        ffi.register_ffi_target(name, ffi.pycapsule(getattr(library, name)), platform="cpu")
    return True


def _compiled(headers: str) -> Any:
    """Compile the handlers, given the directory of XLA's headers, and load them."""
    sources = {**package_sources("c"), **package_sources("c-step")}
    used = {name: text for name, text in sources.items() if name.endswith(".h")}
    text = resources.files("rigidsym._engines").joinpath(_SOURCE).read_text(encoding="utf-8")
    # Of the work that `threads` shares among threads, and its cost.
    numbers = {
        "PIECE": threads.PIECE,
        "LEAST": threads.LEAST,
        "MOST": threads.MOST,
        "PREPARATION": c_engine.PREPARATION,
        "SENSITIVITY": c_engine.SENSITIVITY,
        "STEP": steps.STEP,
        "ROUNDING": float(ROUNDING).hex(),
    }
    flags = (*_FLAGS, f"-I{headers}", *(f"-D{name}={value}" for name, value in numbers.items()))
    with tempfile.TemporaryDirectory(prefix="rigidsym-", ignore_cleanup_errors=True) as work:
        built = compile_library(find(), {**used, _SOURCE: text}, Path(work), flags)
        return ctypes.CDLL(str(built))
