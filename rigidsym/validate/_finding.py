"""Measurement of single validation cases, and their case files.

`rigidsym propagate` reads case files, too.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.io.cases import load_case
from rigidsym.validate._bounds import bounds_of
from rigidsym.validate._implementations import Implementation, Steps, implementation
from rigidsym.validate._measure import Errors, measure
from rigidsym.validate._oracle import Reference, enclose
from rigidsym.validate._singles import Singles, SingleSteps
from rigidsym.validate.peers._user_integrator import Function, UserIntegrator
from rigidsym.validate.strata import Sample, stepped
from rigidsym.validate.strata._singles import in_singles
from rigidsym.view._report_data import Data

SCHEMA = "rigidsym.case/2"
_FIELDS = ("inertia", "omega0", "attitude0", "times")
# Names of implementations, or implementations and functions by whatever name.
Asked = Iterable[str] | Mapping[str, Implementation | Function]


@dataclass(frozen=True, slots=True)
class Finding:
    """Result of one validation case.

    It has the true states, and the errors of each implementation by measure.  An implementation has
    no errors if no time is within its reach.
    """

    reference: Reference
    errors: Mapping[str, Mapping[str, Errors]]

    @property
    def sample(self) -> Sample:
        """The sample that was measured."""
        return self.reference.sample

    def to_data(self) -> dict[str, Any]:
        """Return the case's exact inputs and its errors as plain data.

        The schema is rigidsym.case/2; errors are in units of 2^-53.
        """
        reference = self.reference
        return {
            "schema": SCHEMA,
            "case": self.sample.name,
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
        """Return the largest ratio of error to documented bound for each measure."""
        errors = self.errors.get(name, {})
        return {measure: float(np.max(x.share, initial=0.0)) for measure, x in errors.items()}

    def share(self, name: str) -> float:
        """Return the largest ratio of error to documented bound over all measures."""
        return max(self.shares(name).values(), default=0.0)


def measure_case(sample: Sample, digits: int, implementations: Asked) -> Finding:
    """Compute the true states of a case, and measure the errors of implementations.

    Each implementation is measured at the times that are within its reach.

    Parameters
    ----------
    sample : the case
    digits : digits of the enclosure
    implementations : names of targets and "peer NAME"; or a mapping of any names to engines, peers,
        and functions as `examine` takes them.  With steps among them, the sample of all is changed
        by `stepped`, and by `in_singles` with targets in single precision among them.

    Returns
    -------
    Finding
    """
    if isinstance(implementations, Mapping):
        entered: dict[str, Any] = {
            name: x if hasattr(x, "prepare") else UserIntegrator.of(x)
            for name, x in implementations.items()
        }
    else:
        entered = {name: implementation(name) for name in implementations}
    kinds = {type(engine) for engine in entered.values()}
    if kinds & {Steps, SingleSteps}:
        sample = stepped(sample)
    if kinds & {Singles, SingleSteps}:
        sample = in_singles(sample, 24 if SingleSteps in kinds else 48)
    reference = enclose(sample, digits)
    errors = {}
    for name, engine in entered.items():
        within = reference.within(getattr(engine, "reach", math.inf))
        if within.sample.times:
            errors[name] = measure(within, engine, bounds_of(name))
    return Finding(reference, errors)


def hexadecimal(sample: Sample) -> Data:
    """Return the inputs and times of a sample as text, with doubles in hexadecimal.

    Other numbers are written as fractions.
    """
    found: Any = {
        name: [str(x) if isinstance(x, Fraction) else float(x).hex() for x in getattr(sample, name)]
        for name in _FIELDS
    }
    return found


def case_text(sample: Sample, remarks: Iterable[str] = ()) -> str:
    """Return the text of a case file in TOML."""
    numbers, lines = hexadecimal(sample), [f"# {remark}" for remark in remarks]
    for name in _FIELDS:
        listed = ", ".join(f'"{x}"' for x in numbers[name])
        lines.append(f"{name} = [{listed}]")
    return "\n".join(lines) + "\n"


def file_name(sample: Sample) -> str:
    """Return the name of a sample's case file, made of its stratum and index."""
    return f"{'-'.join(sample.stratum.replace(',', '').split())}-{sample.index}.toml"


def read_case(path: str) -> Sample:
    """Read a sample from a case file.

    Times are rounded to doubles.  Raises InputError if it is no case file.
    """
    case = load_case(path)
    numbers = (tuple(map(_simplest_type, values)) for values in case.motion.exact.values())
    return Sample(path, 0, *numbers, tuple(inputs.doubles("times", case.times)))


def _simplest_type(value: Fraction) -> float | Fraction:
    """Convert a fraction to a float if that is exact, else return the fraction."""
    nearest = float(value) if abs(value) < 2**1023 else 0.0
    return nearest if Fraction(nearest) == value else value
