"""Whether a stratum notices a fault: its cases are measured until one breaks a bound.

Faults in states are looked for in states, those in sensitivities in their columns.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rigidsym.engines import Engine
from rigidsym.validate import sensitivities
from rigidsym.validate.bounds import WIDER
from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.mutated_build import mutated_engine
from rigidsym.validate.measure import measure
from rigidsym.validate.oracle import Reference, enclose
from rigidsym.validate.sensitivities import ColumnsReference
from rigidsym.validate.strata import count, draw

# What is noticed without a measure: an error that is no refusal, and the end of the process.
RAISED, CRASHED = "raised", "crashed"
# The measure of faults in sensitivities.
COLUMNS = "sensitivities"
# Columns are so many numbers that few cases of a stratum say what there is to say.
MOST_CASES = 3
AnyReference = Reference | ColumnsReference


@dataclass(frozen=True, slots=True)
class Detection:
    """The first case of a stratum that a fault breaks a bound in, and the measures that say so."""

    stratum: str
    index: int
    measures: tuple[str, ...]


def references(stratum: str, cases: int, digits: int, seed: int) -> list[Reference]:
    """The truth about the states of a stratum's cases."""
    return [
        enclose(draw(stratum, index, seed), digits, with_condition=False)
        for index in range(count(stratum, cases))
    ]


def columns_references(stratum: str, cases: int, digits: int, seed: int) -> list[ColumnsReference]:
    """The truth about the sensitivities of a stratum's first cases."""
    few = range(count(stratum, min(cases, MOST_CASES)))
    return [ColumnsReference.of(draw(stratum, index, seed), digits) for index in few]


def detections(fault: Fault, strata: Sequence[Sequence[AnyReference]]) -> list[Detection]:
    """What the strata notice, at most one case of each."""
    engine, wider = mutated_engine(fault), WIDER.get(fault.target, 1.0)
    found = (first(engine, stratum, wider) for stratum in strata)
    return [detection for detection in found if detection]


def first(engine: Engine, stratum: Sequence[AnyReference], wider: float = 1.0) -> Detection | None:
    """The first case in which an engine breaks a bound, or cannot do what it should.

    wider: how many times BOUNDS its bounds are.
    """
    for reference in stratum:
        if measures := broken(engine, reference, wider):
            return Detection(reference.sample.stratum, reference.sample.index, measures)
    return None


def broken(engine: Engine, reference: AnyReference, wider: float = 1.0) -> tuple[str, ...]:
    """The measures by which an engine breaks its bounds in a case."""
    try:
        with np.errstate(all="ignore"):
            if isinstance(reference, ColumnsReference):
                return (COLUMNS,) if sensitivities.share(engine, reference) > 1 else ()
            errors = measure(reference, engine, wider)
    except Exception:
        # Faults may raise anything, and whatever it is, it is noticed.
        return (RAISED,)
    return tuple(name for name, found in errors.items() if np.any(found.share > 1))
