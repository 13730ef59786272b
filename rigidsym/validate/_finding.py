"""Measurement of one case: its enclosure, and the errors of all implementations."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeGuard

import numpy as np

from rigidsym.validate._bounds import bounds_of
from rigidsym.validate._case_file import hexadecimal
from rigidsym.validate._implementations import Implementation, Steps, implementation
from rigidsym.validate._measure import Errors, measure
from rigidsym.validate._oracle import Reference, enclose
from rigidsym.validate.peers._user_integrator import Function, UserIntegrator
from rigidsym.validate.strata import Sample, stepped

SCHEMA = "rigidsym.case/2"
# Names of implementations, or implementations and functions by whatever name.
Asked = Iterable[str] | Mapping[str, Implementation | Function]


@dataclass(frozen=True, slots=True)
class Finding:
    """The reference of a case, and errors by implementation and measure.

    An implementation has no errors if no time is within its reach.
    """

    reference: Reference
    errors: Mapping[str, Mapping[str, Errors]]

    @property
    def sample(self) -> Sample:
        """The case."""
        return self.reference.sample

    def to_data(self) -> dict[str, Any]:
        """Return the schema rigidsym.case/2: exact inputs, and all errors in units of 2^-53."""
        reference = self.reference
        return {
            "schema": SCHEMA,
            "case": f"{self.sample.stratum}:{self.sample.index}",
            "regime": reference.regime.value,
            "distance": reference.distance,
            **hexadecimal(self.sample),
            "turned": reference.turned.tolist(),
            # JSON has no number for infinity.
            "condition": {
                name: [x if math.isfinite(x) else str(x) for x in values.tolist()]
                for name, values in reference.condition.items()
            },
            "errors": {
                name: {measure: list(map(str, x.units)) for measure, x in errors.items()}
                for name, errors in self.errors.items()
            },
        }

    def shares(self, name: str) -> dict[str, float]:
        """Return the largest part of each documented bound that is used, by measure."""
        errors = self.errors.get(name, {})
        return {measure: float(np.max(x.share, initial=0.0)) for measure, x in errors.items()}

    def share(self, name: str) -> float:
        """Return the largest part of any documented bound that is used."""
        return max(self.shares(name).values(), default=0.0)


def measure_case(sample: Sample, digits: int, implementations: Asked) -> Finding:
    """Enclose and measure a case, at the times that are within an implementation's reach.

    Parameters
    ----------
    sample : the case
    digits : digits of the enclosure
    implementations : names of targets and "peer NAME"; or a mapping of any names to engines, peers,
        and functions as `examine` takes them.  With steps among them, the sample of all is changed
        by `stepped`.

    Returns
    -------
    Finding
    """
    if isinstance(implementations, Mapping):
        entered = {
            name: x if _is_ready(x) else UserIntegrator.of(x) for name, x in implementations.items()
        }
    else:
        entered = {name: implementation(name) for name in implementations}
    of_steps = any(isinstance(engine, Steps) for engine in entered.values())
    reference = enclose(stepped(sample) if of_steps else sample, digits)
    errors = {}
    for name, engine in entered.items():
        within = reference.within(getattr(engine, "reach", math.inf))
        if within.sample.times:
            errors[name] = measure(within, engine, bounds_of(name))
    return Finding(reference, errors)


def _is_ready(one: Implementation | Function) -> TypeGuard[Implementation]:
    return hasattr(one, "prepare")
