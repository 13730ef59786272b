"""One case, enclosed, and measured of everybody."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from rigidsym.validate.contestants import contestant
from rigidsym.validate.measure import Errors, measure
from rigidsym.validate.oracle import Reference, enclose
from rigidsym.validate.strata import Sample


@dataclass(frozen=True, slots=True)
class Finding:
    """The truth about a case, and errors by contestant and measure; a contestant that was asked
    for none of the times has none."""

    reference: Reference
    errors: Mapping[str, Mapping[str, Errors]]

    @property
    def sample(self) -> Sample:
        """The case."""
        return self.reference.sample

    def shares(self, name: str) -> dict[str, float]:
        """The largest part of each documented bound that a contestant needs, by measure."""
        errors = self.errors.get(name, {})
        return {measure: float(np.max(x.share, initial=0.0)) for measure, x in errors.items()}

    def share(self, name: str) -> float:
        """The largest part of a documented bound that a contestant needs, of all measures."""
        return max(self.shares(name).values(), default=0.0)


def look(sample: Sample, digits: int, contestants: Iterable[str]) -> Finding:
    """Enclose and measure a case, at the times that are within a contestant's reach."""
    reference = enclose(sample, digits)
    errors = {}
    for name in contestants:
        engine = contestant(name)
        within = reference.within(getattr(engine, "reach", math.inf))
        if within.sample.times:
            errors[name] = measure(within, engine)
    return Finding(reference, errors)
