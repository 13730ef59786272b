"""Engines on faulty texts of the generated modules; the installed modules stay as they are."""

import tempfile
from importlib import resources
from pathlib import Path
from types import ModuleType
from typing import Any

from rigidsym.codegen.forms import STEP, split
from rigidsym.engines import Engine, build
from rigidsym.engines.c_engine import CEngine
from rigidsym.engines.compiler import FLAGS, compile_library, find
from rigidsym.engines.library import load
from rigidsym.engines.numpy_engine import NumpyEngine
from rigidsym.engines.steps import CStepper, NumpyStepper
from rigidsym.validate.faults.fault import FILES, Fault
from rigidsym.validate.steps import Steps

# Every faulty module is compiled for a second of use.  What decides the last digits stays.
_QUICK = tuple("-O0" if flag == "-O3" else flag for flag in FLAGS)


def mutated_engine(fault: Fault) -> Engine | Steps:
    """The engine that runs on a faulty module; raises StaleFaultError as `Fault.applied`."""
    return on_text(fault.target, faulty(fault), fault.options)


def faulty(fault: Fault) -> str:
    """The installed module of a fault's target with the fault."""
    return fault.applied(installed(FILES[fault.target]))


def on_text(target: str, text: str, options: tuple[str, ...] = ()) -> Engine | Steps:
    """The engine of a target on another text of its module, compiled with more options."""
    language, _ = split(target)
    return _numpy(target, text) if language == "numpy" else _c(target, text, options)


def installed(name: str) -> str:
    """A generated file as it is in the package."""
    return resources.files("rigidsym.generated").joinpath(name).read_text(encoding="utf-8")


def _numpy(target: str, text: str) -> Engine | Steps:
    # It has what its text defines.
    module: Any = ModuleType("torque_free")
    exec(compile(text, FILES[target], "exec"), module.__dict__)
    return Steps(NumpyStepper(module)) if split(target)[1] == STEP else NumpyEngine(module)


def _c(target: str, text: str, options: tuple[str, ...]) -> Engine | Steps:
    sources = {name: installed(name) for name in build.FILES[target]} | {FILES[target]: text}
    with tempfile.TemporaryDirectory(prefix="rigidsym-", ignore_cleanup_errors=True) as work:
        built = compile_library(find(), sources, Path(work), (*_QUICK, *options))
        library: Any = load(built, sources)
        return Steps(CStepper(library)) if split(target)[1] == STEP else CEngine(library)
