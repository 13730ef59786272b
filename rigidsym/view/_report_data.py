"""The data of a validation report by their keys: the schema rigidsym.validation/3.

Errors are in units of 2^-53; "inf" and "nan" stand for what JSON has no number for.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypedDict

Figure = float | str
# Views that have parts and then measures, and those that have measures and then parts.
ByPart = Literal["strata", "shares", "regimes"]
# Decades of the condition end here: beyond it are exponentials of times.
MOST_CONDITION = 1e40
ByMeasure = Literal["distance", "turned", "condition"]


class Cell(TypedDict):
    """The worst of `count` figures, its condition, case and time; of shares, `units` is the part of
    the bound, and `count` what was beyond it."""

    count: int
    units: Figure
    condition: Figure
    case: str
    t: str


Cells = Mapping[str, Mapping[str, Cell]]
# "name", "about", and the keys of `rigidsym.view._validation.COLUMNS`.
Stratum = Mapping[str, Any]


class Implementation(TypedDict):
    """A measured implementation.

    `share` is the largest part of a bound by stratum; `sizes` are by stratum, measure and half
    octave.
    """

    name: str
    peer: bool
    digest: str | None
    passed: bool
    strata: Cells
    shares: Cells
    share: Mapping[str, Figure]
    regimes: Cells
    sizes: Mapping[str, Mapping[str, Mapping[str, int]]]
    distance: Cells
    turned: Cells
    condition: Cells


class WorstError(TypedDict):
    """The worst of one measure in a case."""

    units: Figure
    condition: Figure
    share: Figure
    t: str


class Numbers(TypedDict):
    """The numbers of a case without loss: doubles in hexadecimal, others as fractions."""

    inertia: list[str]
    omega0: list[str]
    attitude0: list[str]
    times: list[str]


class Case(Numbers):
    """A case with errors by implementation and measure, and the command that runs it again."""

    case: str
    regime: str
    distance: Figure
    errors: Mapping[str, Mapping[str, WorstError]]
    replay: str


class Failure(TypedDict):
    """A broken bound."""

    line: str
    target: str
    measure: str
    stratum: str
    index: int
    share: Figure
    simplest: Case


class Campaign(TypedDict):
    """The options of a campaign."""

    targets: list[str]
    peers: list[str]
    strata: list[str]
    cases: int
    digits: int
    seed: int
    digests: list[str]
    peer_versions: list[str]
    version: str


class Report(TypedDict):
    """A whole report; bounds are in units of 2^-53, `agreement` is the tolerance of the oracles."""

    schema: str
    campaign: Campaign
    command: str
    passed: bool
    complaints: list[str]
    unit: str
    bounds: Mapping[str, float]
    meanings: Mapping[str, str]
    strata: Sequence[Stratum]
    agreement: float
    implementations: Sequence[Implementation]
    worst: Sequence[Case]
    failures: Sequence[Failure]
    run: Mapping[str, Figure | None]
