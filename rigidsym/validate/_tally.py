"""Tallies of the counts and worst errors of a campaign, in bounded memory.

A tally is one flat table of cells.  Merging adds counts and takes the worst, so that tallies give
the same result merged in any order and grouping.
"""

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from rigidsym.validate._measure import Errors
from rigidsym.validate._oracle import Reference
from rigidsym.view._report_data import MOST_CONDITION

# Implementation, measure, view, and part of that view.
Key = tuple[str, str, str, str]
# Stratum, index and time of a state.
Place = tuple[str, int, float]
# The measures with views by distance, time and condition, and histograms.
DRAWN = ("angle", "omega")


@dataclass(frozen=True, slots=True)
class Cell:
    """Entry of a tally: the number of errors, the largest one and the state where it occurred."""

    count: int
    worst: float
    place: Place
    condition: float

    def merged(self, other: "Cell") -> "Cell":
        """Return the cell that combines this cell with another.

        Of equal errors it keeps the one whose place comes first.
        """
        worst = min(self, other, key=lambda cell: (-cell.worst, cell.place))
        return Cell(self.count + other.count, worst.worst, worst.place, worst.condition)


@dataclass(slots=True)
class Tally:
    """Counts and worst errors of a campaign.

    They are a table of cells by key, and the numbers of cases and states by stratum.
    """

    cells: dict[Key, Cell] = field(default_factory=dict)
    cases: Counter[str] = field(default_factory=Counter)
    states: Counter[str] = field(default_factory=Counter)

    def count(self, reference: Reference) -> None:
        """Count a case and its states."""
        self.cases[reference.sample.stratum] += 1
        self.states[reference.sample.stratum] += len(reference.sample.times)

    def add(self, target: str, reference: Reference, errors: Mapping[str, Errors]) -> None:
        """Add the errors of one case to the tally's cells."""
        sample, regime = reference.sample, reference.regime.value
        for measure, found in errors.items():
            worst = _cell(sample.stratum, sample.index, found, int(np.argmax(found.units)))
            whole = Cell(len(found.times), worst.worst, worst.place, worst.condition)
            self.put((target, measure, "stratum", sample.stratum), whole)
            self.put((target, measure, "regime", regime), whole)
            self.put((target, measure, "share", sample.stratum), _beyond(whole, found))
        for measure in DRAWN:
            self._add_plotted(target, measure, reference, errors[measure])

    def _add_plotted(self, target: str, measure: str, reference: Reference, found: Errors) -> None:
        """Add the error of each state to the cells that are plotted.

        These are by decades of properties, and by sizes of the error.
        """
        sample, away = reference.sample, decade(reference.distance)
        for k in range(len(found.times)):
            cell = _cell(sample.stratum, sample.index, found, k)
            self.put((target, measure, "distance", away), cell)
            self.put((target, measure, "turned", decade(abs(cell.place[2]) * reference.rate)), cell)
            part = decade(cell.condition if cell.condition < MOST_CONDITION else math.inf)
            self.put((target, measure, "condition", part), cell)
            self.put((target, measure, f"sizes: {sample.stratum}", half_octave(cell.worst)), cell)

    def put(self, key: Key, cell: Cell) -> None:
        """Merge a cell into the table under a key."""
        known = self.cells.get(key)
        self.cells[key] = cell if known is None else known.merged(cell)

    def copy(self) -> "Tally":
        """Return a copy of the tally.

        It shares the cells, which never change.
        """
        return Tally(dict(self.cells), self.cases.copy(), self.states.copy())

    def merge(self, other: "Tally") -> None:
        """Add the tally of other cases."""
        for key, cell in other.cells.items():
            self.put(key, cell)
        self.cases.update(other.cases)
        self.states.update(other.states)

    def view(self, target: str, measure: str, view: str) -> dict[str, Cell]:
        """Return the tally's cells for an implementation and measure, by values of a property.

        view: the property.  Cells are sorted by name.
        """
        begin = (target, measure, view)
        found = sorted(key for key in self.cells if key[:3] == begin)
        return {key[3]: self.cells[key] for key in found}

    def to_data(self) -> dict[str, Any]:
        """Return the tally as sorted plain data.

        Floats are in hexadecimal.
        """
        rows = []
        for key, cell in sorted(self.cells.items()):
            numbers = cell.worst, cell.place[2], cell.condition
            worst, time, condition = (float(x).hex() for x in numbers)
            rows.append((*key, cell.count, worst, *cell.place[:2], time, condition))
        return {"cells": rows, "cases": self.cases, "states": self.states}

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> "Tally":
        """Create a tally from the data that `to_data` returns."""
        cells = {}
        for *key, count, worst, name, index, time, condition in data["cells"]:
            place = (name, index, float.fromhex(time))
            cell = Cell(count, float.fromhex(worst), place, float.fromhex(condition))
            cells[tuple(key)] = cell
        return cls(cells, Counter(data["cases"]), Counter(data["states"]))


def decade(value: float) -> str:
    """Return the largest power of ten below a number, as text.

    It is "0" for zero and "inf" for infinity.
    """
    if not 0 < value < math.inf:
        return "inf" if value else "0"
    return f"1e{math.floor(math.log10(value)):+d}"


def half_octave(units: float) -> str:
    """Return the largest half-integer power of two below an error, as text.

    It is "0" for errors below a thousandth, where the radii of the balls begin to matter.
    """
    if not 2**-10 < units < math.inf:
        return "0" if units <= 2**-10 else "inf"
    return f"2^{math.floor(2 * math.log2(units)) / 2:+g}"


def _cell(stratum: str, index: int, found: Errors, k: int) -> Cell:
    place = (stratum, index, float(found.times[k]))
    return Cell(1, float(found.units[k]), place, float(found.condition[k]))


def _beyond(worst: Cell, found: Errors) -> Cell:
    """Return a cell that counts the errors beyond their bound.

    It has the largest share of the bound and the number of errors beyond it.
    """
    k = int(np.argmax(found.share))
    place = (*worst.place[:2], float(found.times[k]))
    count = int(np.sum(found.share > 1))
    return Cell(count, float(found.share[k]), place, float(found.condition[k]))
