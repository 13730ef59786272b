"""The spread of costs over manoeuvres, and of the optimiser's iterations, in one picture."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from rigidsym.manoeuvre.comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre.comparison.record import Record
from rigidsym.manoeuvre.comparison.statistics import least
from rigidsym.view.plots.spreads import Panel, spreads

if TYPE_CHECKING:
    from rigidsym.view.plots.figure import Figure

_SHOWN = Task(Model.THRUSTERS, Cost.FUEL)


def picture(records: Sequence[Record]) -> "Figure":
    """A dot for each manoeuvre, a bar at the median: costs by method, iterations by guess."""
    label = "torque integral over the least fuel"
    costs = [
        Panel(f"flown with {model}", label, _costs(records, model), True)
        for model in reversed(Model)
    ]
    solved = f"optimal control: {_SHOWN.name}"
    panels = [*costs, Panel(solved, "iterations of IPOPT", _iterations(records), False)]
    return spreads(panels, "one manoeuvre", "the least fuel")


def _costs(records: Sequence[Record], model: Model) -> Mapping[str, list[float]]:
    return {
        method: [
            record.flown[model.value][method].torque_integral / least(record, model, limited=True)
            for record in records
        ]
        for method in records[0].flown[model.value]
    }


def _iterations(records: Sequence[Record]) -> Mapping[str, list[float]]:
    solved = [record.solved[_SHOWN.name].attempts for record in records]
    return {
        f"{guess},\n{setting}": [float(one[setting][guess].iterations) for one in solved]
        for setting, guesses in solved[0].items()
        for guess in guesses
    }
