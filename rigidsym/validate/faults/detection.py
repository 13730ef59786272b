"""Whether a stratum notices a fault: its cases are measured until one breaks a bound.

Faults in states are looked for in states, those in sensitivities in their columns.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from rigidsym.engines import Engine
from rigidsym.validate import sensitivities
from rigidsym.validate.bounds import BOUNDS, bounds_of
from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.mutated_build import mutated_engine
from rigidsym.validate.measure import measure
from rigidsym.validate.oracle import Reference, enclose
from rigidsym.validate.peers.protocol import Solver
from rigidsym.validate.sensitivities import ColumnsReference
from rigidsym.validate.steps import Steps
from rigidsym.validate.strata import Sample, count, draw, stepped

# What is noticed without a measure: an error that is no refusal, and the end of the process.
RAISED, CRASHED = "raised", "crashed"
# The measure of faults in sensitivities.
COLUMNS = "sensitivities"
# Columns are so many numbers that few cases of a stratum say what there is to say.
MOST_CASES = 4
AnyReference = Reference | ColumnsReference


@dataclass(frozen=True, slots=True)
class Detection:
    """The first case of a stratum that a fault breaks a bound in, and the measures that say so."""

    stratum: str
    index: int
    measures: tuple[str, ...]


def references(stratum: str, cases: int, digits: int, seed: int) -> list[Reference]:
    """The truth about the states of a stratum's cases."""
    return [enclose(x, digits, with_condition=False) for x in _samples(stratum, cases, seed)]


def steps_references(stratum: str, cases: int, digits: int, seed: int) -> list[Reference]:
    """The truth about what `stepped` makes of a stratum's cases."""
    samples = map(stepped, _samples(stratum, cases, seed))
    return [enclose(sample, digits, with_condition=False) for sample in samples]


def _samples(stratum: str, cases: int, seed: int) -> Iterator[Sample]:
    return (draw(stratum, index, seed) for index in range(count(stratum, cases)))


def columns_references(stratum: str, cases: int, digits: int, seed: int) -> list[ColumnsReference]:
    """The truth about the sensitivities of a stratum's first cases."""
    few = _samples(stratum, min(cases, MOST_CASES), seed)
    return [ColumnsReference.of(sample, digits) for sample in few]


def detections(fault: Fault, strata: Sequence[Sequence[AnyReference]]) -> list[Detection]:
    """What the strata notice, at most one case of each."""
    engine, bounds = mutated_engine(fault), bounds_of(fault.target)
    found = (first(engine, stratum, bounds) for stratum in strata)
    return [detection for detection in found if detection]


def first(
    engine: Engine | Solver | Steps,
    stratum: Sequence[AnyReference],
    bounds: Mapping[str, float] = BOUNDS,
) -> Detection | None:
    """The first case in which an engine breaks a bound, or cannot do what it should."""
    for reference in stratum:
        if measures := broken(engine, reference, bounds):
            return Detection(reference.sample.stratum, reference.sample.index, measures)
    return None


def broken(
    engine: Engine | Solver | Steps, reference: AnyReference, bounds: Mapping[str, float] = BOUNDS
) -> tuple[str, ...]:
    """The measures by which an engine breaks its bounds in a case."""
    try:
        with np.errstate(all="ignore"):
            if isinstance(reference, ColumnsReference):
                # What has no sensitivities is asked for none.
                share = sensitivities.share(cast("Engine", engine), reference)
                return (COLUMNS,) if share > 1 else ()
            errors = measure(reference, engine, bounds)
    except Exception:
        # Faults may raise anything, and whatever it is, it is noticed.
        return (RAISED,)
    return tuple(name for name, found in errors.items() if np.any(found.share > 1))
