"""All that is found of one manoeuvre."""

from collections.abc import Mapping
from dataclasses import dataclass

from rigidsym.manoeuvre.comparison.cases import Case, CaseData
from rigidsym.manoeuvre.comparison.flights import Flown
from rigidsym.manoeuvre.comparison.optima import Solved, SolvedData


class RecordData(CaseData):
    """A record of the schema rigidsym.comparison/1."""

    flown: dict[str, dict[str, dict[str, float]]]
    ideal: dict[str, dict[str, float]]
    optimal: dict[str, SolvedData]


@dataclass(frozen=True, slots=True)
class Record:
    """flown: by actuators and method.  ideal: by actuators and way, N m s.  solved: by task."""

    case: Case
    flown: Mapping[str, Mapping[str, Flown]]
    ideal: Mapping[str, Mapping[str, float]]
    solved: Mapping[str, Solved]

    def to_data(self) -> RecordData:
        """For files."""
        return {
            **self.case.to_data(),
            "flown": {
                model: {name: one.to_data() for name, one in methods.items()}
                for model, methods in self.flown.items()
            },
            "ideal": {name: dict(ways) for name, ways in self.ideal.items()},
            "optimal": {name: one.to_data() for name, one in self.solved.items()},
        }
