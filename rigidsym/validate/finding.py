"""One case, enclosed, and measured of everybody."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TypeGuard

import numpy as np

from rigidsym.validate.bounds import bounds_of
from rigidsym.validate.case_file import hexadecimal
from rigidsym.validate.implementations import Implementation, Steps, implementation
from rigidsym.validate.measure import Errors, measure
from rigidsym.validate.oracle import Reference, enclose
from rigidsym.validate.peers.user_integrator import Function, UserIntegrator
from rigidsym.validate.strata import Sample, stepped
from rigidsym.view.report_data import Figure, Numbers

SCHEMA = "rigidsym.case/2"
# Names of implementations, or implementations and functions by whatever name.
Asked = Iterable[str] | Mapping[str, Implementation | Function]


class FindingData(Numbers):
    """The schema rigidsym.case/2; errors by implementation and measure."""

    schema: str
    case: str
    regime: str
    distance: float
    turned: list[float]
    condition: dict[str, list[Figure]]
    errors: dict[str, dict[str, list[str]]]


@dataclass(frozen=True, slots=True)
class Finding:
    """The truth about a case, and errors by implementation and measure; one that was asked
    for none of the times has none."""

    reference: Reference
    errors: Mapping[str, Mapping[str, Errors]]

    @property
    def sample(self) -> Sample:
        """The case."""
        return self.reference.sample

    def to_data(self) -> FindingData:
        """The schema rigidsym.case/2: inputs without loss, and all errors in units of 2^-53."""
        reference = self.reference
        return {
            "schema": SCHEMA,
            "case": f"{self.sample.stratum}:{self.sample.index}",
            "regime": reference.regime.value,
            "distance": reference.distance,
            **hexadecimal(self.sample),
            "turned": reference.turned.tolist(),
            "condition": {name: _figures(x) for name, x in reference.condition.items()},
            "errors": {
                name: {measure: list(map(str, x.units)) for measure, x in errors.items()}
                for name, errors in self.errors.items()
            },
        }

    def shares(self, name: str) -> dict[str, float]:
        """The largest part of each documented bound that an implementation needs, by measure."""
        errors = self.errors.get(name, {})
        return {measure: float(np.max(x.share, initial=0.0)) for measure, x in errors.items()}

    def share(self, name: str) -> float:
        """The largest part of a documented bound that an implementation needs, of all measures."""
        return max(self.shares(name).values(), default=0.0)


def measure_case(sample: Sample, digits: int, implementations: Asked) -> Finding:
    """Enclose and measure a case, at the times that are within an implementation's reach.

    implementations: targets and "peer NAME"; or by any names engines, peers, and functions such as
    `examine` takes.  With steps among them the sample is what `stepped` makes of it, for all.
    """
    entered = _entered(implementations)
    of_steps = any(isinstance(engine, Steps) for engine in entered.values())
    reference = enclose(stepped(sample) if of_steps else sample, digits)
    errors = {}
    for name, engine in entered.items():
        within = reference.within(getattr(engine, "reach", math.inf))
        if within.sample.times:
            errors[name] = measure(within, engine, bounds_of(name))
    return Finding(reference, errors)


def _figures(values: np.ndarray) -> list[Figure]:
    """Numbers without loss; "inf" for what JSON has no number for."""
    return [x if math.isfinite(x) else str(x) for x in values.tolist()]


def _entered(implementations: Asked) -> dict[str, Implementation]:
    """Engines and peers by name."""
    if isinstance(implementations, Mapping):
        return {
            name: x if _is_ready(x) else UserIntegrator.of(x) for name, x in implementations.items()
        }
    return {name: implementation(name) for name in implementations}


def _is_ready(one: Implementation | Function) -> TypeGuard[Implementation]:
    return hasattr(one, "prepare")
