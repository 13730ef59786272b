"""Whether a stratum notices a fault: its cases are measured until one breaks a bound."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from rigidsym.engines import Engine
from rigidsym.validate.bounds import BOUNDS, bounds_of
from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.mutated_build import mutated_engine
from rigidsym.validate.measure import measure
from rigidsym.validate.oracle import Reference, enclose
from rigidsym.validate.peers.protocol import Solver
from rigidsym.validate.steps import Steps
from rigidsym.validate.strata import count, draw, stepped

# What is noticed without a measure: an error that is no refusal, and the end of the process.
RAISED, CRASHED = "raised", "crashed"


@dataclass(frozen=True, slots=True)
class Detection:
    """The first case of a stratum that a fault breaks a bound in, and the measures that say so."""

    stratum: str
    index: int
    measures: tuple[str, ...]


def references(
    stratum: str, cases: int, digits: int, seed: int, of_steps: bool = False
) -> list[Reference]:
    """The truth about the cases of a stratum, or about what `stepped` makes of them."""
    samples = [draw(stratum, index, seed) for index in range(count(stratum, cases))]
    return [enclose(stepped(sample) if of_steps else sample, digits) for sample in samples]


def detections(fault: Fault, strata: Sequence[Sequence[Reference]]) -> list[Detection]:
    """What the strata notice, at most one case of each."""
    engine, bounds = mutated_engine(fault), bounds_of(fault.target)
    found = (first(engine, stratum, bounds) for stratum in strata)
    return [detection for detection in found if detection]


def first(
    engine: Engine | Solver | Steps,
    stratum: Sequence[Reference],
    bounds: Mapping[str, float] = BOUNDS,
) -> Detection | None:
    """The first case in which an engine breaks a bound, or cannot do what it should."""
    for reference in stratum:
        if measures := broken(engine, reference, bounds):
            return Detection(reference.sample.stratum, reference.sample.index, measures)
    return None


def broken(
    engine: Engine | Solver | Steps, reference: Reference, bounds: Mapping[str, float] = BOUNDS
) -> tuple[str, ...]:
    """The measures by which an engine breaks its bounds in a case."""
    try:
        with np.errstate(all="ignore"):
            errors = measure(reference, engine, bounds)
    except Exception:
        # Faults may raise anything, and whatever it is, it is noticed.
        return (RAISED,)
    return tuple(name for name, found in errors.items() if np.any(found.share > 1))
