"""What the strata noticed of the faults."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypedDict

from rigidsym.validate.faults.detection import Detection
from rigidsym.validate.faults.fault import KINDS, Fault
from rigidsym.view.markdown import table

SCHEMA = "rigidsym.faults/2"
# More strata than these are counted, not named.
_NAMED = 4


class CaughtData(TypedDict):
    """By what a stratum caught a fault."""

    case: str
    by: list[str]


class FaultData(TypedDict):
    """A fault, and who caught it, by stratum."""

    target: str
    name: str
    kind: str
    old: str
    new: str
    options: list[str]
    caught: dict[str, CaughtData]


class FaultReportData(TypedDict):
    """The schema rigidsym.faults/2; strata: how many each caught, alone, and of how many."""

    schema: str
    targets: list[str]
    cases: int
    digits: int
    seed: int
    passed: bool
    kinds: Mapping[str, str]
    strata: dict[str, dict[str, int]]
    faults: list[FaultData]


@dataclass(frozen=True, slots=True)
class Outcome:
    """A fault, and a detection of each stratum that caught it."""

    fault: Fault
    detections: tuple[Detection, ...]

    @property
    def strata(self) -> tuple[str, ...]:
        """The strata that caught it."""
        return tuple(detection.stratum for detection in self.detections)

    @property
    def measures(self) -> tuple[str, ...]:
        """All measures by which it was caught, each once."""
        return tuple(
            dict.fromkeys(name for detection in self.detections for name in detection.measures)
        )


@dataclass(frozen=True, slots=True)
class FaultReport:
    """All faults of some targets against all strata."""

    targets: tuple[str, ...]
    strata: tuple[str, ...]
    cases: int
    digits: int
    seed: int
    outcomes: tuple[Outcome, ...]

    @property
    def passed(self) -> bool:
        """There are faults of every target, and some stratum caught each of them."""
        named = {outcome.fault.target for outcome in self.outcomes}
        return named == set(self.targets) and not self.missed

    @property
    def missed(self) -> tuple[Fault, ...]:
        """Faults that no stratum caught."""
        return tuple(outcome.fault for outcome in self.outcomes if not outcome.detections)

    @property
    def conclusion(self) -> str:
        """What was found, in a sentence."""
        total, best = len(self.outcomes), max(self.strata, key=self.caught)
        sharpest = f"{best} alone notices {self.caught(best)}"
        if self.missed:
            return f"{len(self.missed)} of {total} faults are NOT noticed; {sharpest}."
        fewest = min((len(outcome.strata) for outcome in self.outcomes), default=0)
        strata = "stratum" if fewest == 1 else "strata"
        return f"Each of {total} faults is noticed, by {fewest} {strata} or more; {sharpest}."

    def caught(self, stratum: str) -> int:
        """How many faults a stratum caught."""
        return sum(stratum in outcome.strata for outcome in self.outcomes)

    def alone(self, stratum: str) -> int:
        """How many faults no other stratum caught."""
        return sum((stratum,) == outcome.strata for outcome in self.outcomes)

    def to_data(self) -> FaultReportData:
        """The schema rigidsym.faults/2."""
        return {
            "schema": SCHEMA,
            "targets": list(self.targets),
            "cases": self.cases,
            "digits": self.digits,
            "seed": self.seed,
            "passed": self.passed,
            "kinds": KINDS,
            "strata": {
                name: {
                    "caught": self.caught(name),
                    "alone": self.alone(name),
                    "of": len(self.outcomes),
                }
                for name in self.strata
            },
            "faults": list(map(_fault, self.outcomes)),
        }

    def to_json(self) -> str:
        """`to_data` as text."""
        return json.dumps(self.to_data(), indent=1, sort_keys=True) + "\n"

    def to_markdown(self) -> str:
        """Two tables: what each stratum caught, and which strata caught each fault."""
        total = len(self.outcomes)
        strata = (
            (name, f"{self.caught(name)} of {total}", str(self.alone(name))) for name in self.strata
        )
        faults = ("fault", "kind", "strata", "which", "by")
        return "\n".join(
            [
                f"{total - len(self.missed)} of {total} faults were caught.",
                "",
                *table(("stratum", "caught", "by no other"), strata),
                "",
                *table(faults, map(self._row, self.outcomes)),
                "",
            ]
        )

    def _row(self, outcome: Outcome) -> tuple[str, ...]:
        fault, strata = outcome.fault, outcome.strata
        if not strata:
            return fault.line, fault.kind, "0", "NOT CAUGHT", ""
        which = ", ".join(strata) if len(strata) <= _NAMED else self._all_but(strata)
        return fault.line, fault.kind, str(len(strata)), which, ", ".join(outcome.measures)

    def _all_but(self, strata: tuple[str, ...]) -> str:
        others = [name for name in self.strata if name not in strata]
        if not others:
            return "all"
        if len(others) <= _NAMED:
            return f"all but {', '.join(others)}"
        return f"{', '.join(strata[:_NAMED])}, ..."


def _fault(outcome: Outcome) -> FaultData:
    fault = outcome.fault
    return {
        "target": fault.target,
        "name": fault.name,
        "kind": fault.kind,
        "old": fault.old,
        "new": fault.new,
        "options": list(fault.options),
        "caught": {
            detection.stratum: {
                "case": f"{detection.stratum}:{detection.index}",
                "by": list(detection.measures),
            }
            for detection in outcome.detections
        },
    }
