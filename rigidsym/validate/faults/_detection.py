"""Detection of faults by measuring faulty modules until an error bound is broken.

Faults in states and steps are looked for in states, those in sensitivities in their columns.  The
installed modules stay as they are.
"""

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any, cast

import numpy as np

from rigidsym._codegen.forms import STEP, split
from rigidsym._engines import Engine
from rigidsym._engines.build import FLAGS, compile_library, find
from rigidsym._engines.c_engine import CEngine
from rigidsym._engines.library import load
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym._engines.piped import PipedEngine, PipedStepper
from rigidsym._engines.steps import CStepper, NumpyStepper
from rigidsym.io._files import write_all
from rigidsym.validate import _sensitivities as sensitivities
from rigidsym.validate._bounds import BOUNDS, bounds_of
from rigidsym.validate._implementations import Steps
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import Reference, enclose
from rigidsym.validate._sensitivities import ColumnsReference
from rigidsym.validate._singles import TARGETS as SINGLES
from rigidsym.validate._singles import Singles, SingleSteps
from rigidsym.validate.faults._fault import Fault
from rigidsym.validate.faults._printed import faulty
from rigidsym.validate.faults._pushed import PushedReference
from rigidsym.validate.peers._protocol import Solver
from rigidsym.validate.strata import count, draw, stepped
from rigidsym.validate.strata._singles import in_singles

# Detections without a measure: an error that is no refusal, and the end of the process.
RAISED, CRASHED = "raised", "crashed"
# The measures of faults in sensitivities, and in motions under torques.
COLUMNS, TORQUES = "sensitivities", "torques"
# These have so many numbers that few cases of a stratum are enough.
MOST_CASES = 4
Measured = Engine | Steps | Singles | SingleSteps
AnyReference = Reference | ColumnsReference | PushedReference
# Every faulty module is compiled for a second of use.  What decides the last digits stays.
_QUICK = tuple("-O0" if flag == "-O3" else flag for flag in FLAGS)


def mutated_engine(fault: Fault) -> Measured:
    """Return an engine that runs a generated module with an injected fault."""
    return on_files(fault.target, faulty(fault), fault.options)


def on_files(target: str, files: Mapping[str, str], options: tuple[str, ...] = ()) -> Measured:
    """Return a target's engine that runs changed files of its module.

    options: of the compiler, beyond the usual ones.
    """
    language, form = split(target)
    if language == "numpy":
        ((name, text),) = files.items()
        module: Any = ModuleType("torque_free")
        exec(compile(text, name, "exec"), module.__dict__)
        return Steps(NumpyStepper(module)) if form == STEP else NumpyEngine(module)
    with tempfile.TemporaryDirectory(prefix="rigidsym-", ignore_cleanup_errors=True) as work:
        if target in SINGLES:
            found = load(compile_library(find(), files, Path(work), _QUICK), files).raw
            return SingleSteps(found) if form == STEP else Singles(found)
        if language != "c":
            # The process has read the files when this returns.
            home = Path(work)
            write_all(home, files)
            return Steps(PipedStepper(target, home)) if form == STEP else PipedEngine(target, home)
        built = compile_library(find(), files, Path(work), (*_QUICK, *options))
        library: Any = load(built, files)
        return Steps(CStepper(library)) if form == STEP else CEngine(library)


@dataclass(frozen=True, slots=True)
class Detection:
    """The first case of a stratum in which a fault breaks an error bound.

    measures: those whose bounds are broken.
    """

    stratum: str
    index: int
    measures: tuple[str, ...]


def references(
    stratum: str, cases: int, digits: int, seed: int, shown_in: str = "states"
) -> list[Any]:
    """Compute the true states or sensitivities of a stratum's cases.

    shown_in: states and steps have a `Reference` for each case, "sensitivities" a
    `ColumnsReference`, "torques" a `PushedReference`; see `Fault.shown_in`.
    """
    most = min(cases, MOST_CASES) if shown_in in (COLUMNS, TORQUES) else cases
    samples = [draw(stratum, index, seed) for index in range(count(stratum, most))]
    if shown_in == COLUMNS:
        return [ColumnsReference.of(sample, digits) for sample in samples]
    if shown_in == TORQUES:
        return [PushedReference.of(sample) for sample in samples]
    of, _, precision = shown_in.partition(" in ")
    if of == "steps":
        samples = list(map(stepped, samples))
    if precision:
        samples = [in_singles(x, 24 if of == "steps" else 48) for x in samples]
    return [enclose(sample, digits, with_condition=False) for sample in samples]


def detections(fault: Fault, strata: Sequence[Sequence[AnyReference]]) -> list[Detection]:
    """Return the first detection of a fault in each stratum where it is detected."""
    engine, bounds = mutated_engine(fault), bounds_of(fault.target)
    found = (first(engine, stratum, bounds) for stratum in strata)
    return [detection for detection in found if detection]


def first(
    engine: Measured | Solver,
    stratum: Sequence[AnyReference],
    bounds: Mapping[str, float] = BOUNDS,
) -> Detection | None:
    """Return the first case in which an engine breaks a bound or raises an unexpected exception."""
    for reference in stratum:
        if measures := broken(engine, reference, bounds):
            return Detection(reference.sample.stratum, reference.sample.index, measures)
    return None


def broken(
    engine: Measured | Solver, reference: AnyReference, bounds: Mapping[str, float] = BOUNDS
) -> tuple[str, ...]:
    """Return the names of the measures whose bounds an engine breaks in a case."""
    try:
        with np.errstate(all="ignore"):
            if isinstance(reference, ColumnsReference):
                # Only engines with sensitivities have faults there.
                share = sensitivities.share(cast("Engine", engine), reference)
                return (COLUMNS,) if share > 1 else ()
            if isinstance(reference, PushedReference):
                return (TORQUES,) if reference.is_missed(cast("Steps", engine)) else ()
            errors = measure(reference, engine, bounds)
    except Exception:
        # A fault may raise anything, and any error is a detection.
        return (RAISED,)
    return tuple(name for name, found in errors.items() if np.any(found.share > 1))
