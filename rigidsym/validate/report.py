"""The validation report: figures by stratum, as JSON and as Markdown."""

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from rigidsym import engines, inputs
from rigidsym.errors import InputError
from rigidsym.validate.measure import BOUND, Measurement, measure
from rigidsym.validate.strata import STRATA, Sample, samples

SCHEMA = "rigidsym.validation/1"
FIELDS = ("angle", "omega", "norm", "energy", "momentum", "share")
CASES, DIGITS, SEED = 15, 25, 1


@dataclass(frozen=True, slots=True)
class StratumReport:
    """The worst figures of one stratum, in units of 2^-53, and the sample that broke or came
    nearest to the bound."""

    name: str
    cases: int
    states: int
    worst: dict[str, float]
    nearest: Sample | None
    nearest_time: float

    @property
    def passed(self) -> bool:
        """Something was tested, and all of it within the bound."""
        return self.states > 0 and self.worst["share"] <= 1


@dataclass(frozen=True, slots=True)
class ValidationReport:
    """All strata of one run."""

    target: str
    cases: int
    digits: int
    seed: int
    strata: tuple[StratumReport, ...]

    @property
    def passed(self) -> bool:
        """Every stratum passed."""
        return all(stratum.passed for stratum in self.strata)

    def to_json(self) -> str:
        """The schema rigidsym.validation/1; figures to three digits."""
        data = {
            "schema": SCHEMA,
            "target": self.target,
            "cases": self.cases,
            "digits": self.digits,
            "seed": self.seed,
            "unit": "2**-53",
            "passed": self.passed,
            "strata": [_stratum_json(stratum) for stratum in self.strata],
        }
        return json.dumps(data, indent=1) + "\n"

    def to_markdown(self) -> str:
        """A table a person can read."""
        lines = [
            f"# Validation of the generated module `{self.target}`",
            "",
            f"Written by `rigidsym validate {self.target} --cases {self.cases} --digits "
            f"{self.digits} --seed {self.seed}`.",
            "",
            "Worst errors against the derivation evaluated by mpmath, in units of 2^-53 "
            "(1.1e-16): rotation angle (rad), |domega|/|omega|, | |q| - 1 |, drift of H and K^2. "
            f"Share: the part of the documented bound {BOUND} that was used.",
            "",
            "| stratum | cases | states | angle | omega | norm | H | K^2 | share | |",
            "|---|---|---|---|---|---|---|---|---|---|",
        ]
        for stratum in self.strata:
            figures = " | ".join(f"{stratum.worst[name]:.3g}" for name in FIELDS)
            mark = "ok" if stratum.passed else "BROKEN"
            lines.append(
                f"| {stratum.name} | {stratum.cases} | {stratum.states} | {figures} | {mark} |"
            )
        return "\n".join(lines) + "\n"


def _stratum_json(stratum: StratumReport) -> dict[str, Any]:
    data: dict[str, Any] = {
        "name": stratum.name,
        "cases": stratum.cases,
        "states": stratum.states,
        "passed": stratum.passed,
        "worst": {name: float(f"{stratum.worst[name]:.3g}") for name in FIELDS},
    }
    if stratum.nearest is not None:
        sample = stratum.nearest
        data["nearest"] = {
            "index": sample.index,
            "inertia": _hex(sample.inertia),
            "omega0": _hex(sample.omega0),
            "attitude0": _hex(sample.attitude0),
            "t": float(stratum.nearest_time).hex(),
        }
    return data


def _hex(values: Iterable[float | Fraction]) -> list[str]:
    """Numbers without loss, as case files take them."""
    return [str(x) if isinstance(x, Fraction) else float(x).hex() for x in values]


def check_target(target: str) -> None:
    """Raise InputError for a target there is no module of, or that does not compile here."""
    if target not in engines.ENGINES:
        raise InputError("target", target, f"must be one of: {', '.join(engines.ENGINES)}")
    engines.exactly(target)


def validate(
    target: str = "numpy",
    cases: int = CASES,
    digits: int = DIGITS,
    seed: int = SEED,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> ValidationReport:
    """Measure a generated module on `cases` samples of every stratum and on the paper's body.

    Raises InputError for an unknown target.
    """
    check_target(target)
    engine = engines.exactly(target)
    inputs.digits(digits)
    drawn = list(samples(cases, seed))
    measured: dict[str, list[Measurement]] = {name: [] for name in ("paper", *STRATA)}
    for done, sample in enumerate(drawn):
        measured[sample.stratum].append(measure(sample, digits, engine))
        progress(done + 1, len(drawn))
    strata = tuple(_summary(name, results) for name, results in measured.items())
    return ValidationReport(target, cases, digits, seed, strata)


def _summary(name: str, results: Iterable[Measurement]) -> StratumReport:
    listed = list(results)
    worst = {f: max((getattr(m, f) for m in listed), default=0.0) for f in FIELDS}
    nearest = max(listed, key=lambda m: m.share, default=None)
    states = sum(m.states for m in listed)
    sample, time = (nearest.sample, nearest.worst_time) if nearest else (None, 0.0)
    return StratumReport(name, len(listed), states, worst, sample, time)
