"""Tallies: what a campaign keeps of its cases, in the same memory however many there are.

A tally is one flat table of cells.  Merging adds counts and takes the worst, so that tallies may be
merged in any order and grouping, and always give the same.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TypedDict

import numpy as np

from rigidsym.validate.measure import Errors
from rigidsym.validate.oracle import Reference
from rigidsym.view.report_data import MOST_CONDITION

# Who was measured, by which measure, looked at how, and which part of that view.
Key = tuple[str, str, str, str]
# Stratum, index and time of a state.
Place = tuple[str, int, float]
# What has views by distance, time and condition, and histograms.
DRAWN = ("angle", "omega")


@dataclass(frozen=True, slots=True)
class Cell:
    """How many figures, the worst of them in units of 2^-53, its place and its condition."""

    count: int
    worst: float
    place: Place
    condition: float

    def merged(self, other: "Cell") -> "Cell":
        """Both together; of figures equally bad the one whose place comes first."""
        worst = min(self, other, key=lambda cell: (-cell.worst, cell.place))
        return Cell(self.count + other.count, worst.worst, worst.place, worst.condition)


# Key, count, worst, place and condition, floats in hexadecimal; a list once JSON had it.
Row = tuple[str, str, str, str, int, str, str, int, str, str]


class TallyData(TypedDict):
    """A tally as JSON takes it."""

    cells: list[Row]
    cases: dict[str, int]
    states: dict[str, int]


@dataclass(slots=True)
class Tally:
    """Cells by key, and how many cases and states of each stratum there were."""

    cells: dict[Key, Cell] = field(default_factory=dict)
    cases: dict[str, int] = field(default_factory=dict)
    states: dict[str, int] = field(default_factory=dict)

    def count(self, reference: Reference) -> None:
        """Count a case and its states."""
        for counts, more in ((self.cases, 1), (self.states, len(reference.sample.times))):
            name = reference.sample.stratum
            counts[name] = counts.get(name, 0) + more

    def add(self, target: str, reference: Reference, errors: Mapping[str, Errors]) -> None:
        """Take in what was measured of one case."""
        sample, regime = reference.sample, reference.regime.value
        for measure, found in errors.items():
            worst = _cell(sample.stratum, sample.index, found, int(np.argmax(found.units)))
            whole = Cell(len(found.times), worst.worst, worst.place, worst.condition)
            self.put((target, measure, "stratum", sample.stratum), whole)
            self.put((target, measure, "regime", regime), whole)
            self.put((target, measure, "share", sample.stratum), _beyond(whole, found))
        for measure in DRAWN:
            self._draw(target, measure, reference, errors[measure])

    def _draw(self, target: str, measure: str, reference: Reference, found: Errors) -> None:
        """What plots show, state by state: decades, and half octaves of the error."""
        sample, away = reference.sample, decade(reference.distance)
        for k in range(len(found.times)):
            cell = _cell(sample.stratum, sample.index, found, k)
            self.put((target, measure, "distance", away), cell)
            self.put((target, measure, "turned", decade(abs(cell.place[2]) * reference.rate)), cell)
            part = decade(cell.condition if cell.condition < MOST_CONDITION else math.inf)
            self.put((target, measure, "condition", part), cell)
            self.put((target, measure, f"sizes: {sample.stratum}", half_octave(cell.worst)), cell)

    def put(self, key: Key, cell: Cell) -> None:
        """Merge a cell into its place."""
        known = self.cells.get(key)
        self.cells[key] = cell if known is None else known.merged(cell)

    def copy(self) -> "Tally":
        """The same for now; cells never change."""
        return Tally(dict(self.cells), dict(self.cases), dict(self.states))

    def merge(self, other: "Tally") -> None:
        """Take in another tally, of other cases."""
        for key, cell in other.cells.items():
            self.put(key, cell)
        for mine, theirs in ((self.cases, other.cases), (self.states, other.states)):
            for name, more in theirs.items():
                mine[name] = mine.get(name, 0) + more

    def view(self, target: str, measure: str, view: str) -> dict[str, Cell]:
        """The parts of a view, in the order of their names."""
        begin = (target, measure, view)
        found = sorted(key for key in self.cells if key[:3] == begin)
        return {key[3]: self.cells[key] for key in found}

    def to_data(self) -> TallyData:
        """As JSON takes it: sorted, floats in hexadecimal."""
        rows = [
            (*key, cell.count, _hex(cell.worst), *_written(cell.place), _hex(cell.condition))
            for key, cell in sorted(self.cells.items())
        ]
        return {"cells": rows, "cases": self.cases, "states": self.states}

    @classmethod
    def from_data(cls, data: TallyData) -> "Tally":
        """The inverse of `to_data`."""
        cells = {}
        for target, measure, view, part, count, worst, name, index, time, condition in data[
            "cells"
        ]:
            place = (name, index, float.fromhex(time))
            cell = Cell(count, float.fromhex(worst), place, float.fromhex(condition))
            cells[target, measure, view, part] = cell
        return cls(cells, dict(data["cases"]), dict(data["states"]))


def decade(value: float) -> str:
    """The power of ten below a number, "0" for zero and "inf" beyond all."""
    if not 0 < value < math.inf:
        return "inf" if value else "0"
    return f"1e{math.floor(math.log10(value)):+d}"


def half_octave(units: float) -> str:
    """The power of the square root of two below a number of units, in halves; "0" for less than
    a thousandth, where the balls' own radii begin to be seen."""
    if not 2**-10 < units < math.inf:
        return "0" if units <= 2**-10 else "inf"
    return f"2^{math.floor(2 * math.log2(units)) / 2:+g}"


def _cell(stratum: str, index: int, found: Errors, k: int) -> Cell:
    place = (stratum, index, float(found.times[k]))
    return Cell(1, float(found.units[k]), place, float(found.condition[k]))


def _beyond(worst: Cell, found: Errors) -> Cell:
    """The largest part of the bound, and how many figures are beyond it."""
    k = int(np.argmax(found.share))
    place = (*worst.place[:2], float(found.times[k]))
    count = int(np.sum(found.share > 1))
    return Cell(count, float(found.share[k]), place, float(found.condition[k]))


def _written(place: Place) -> tuple[str, int, str]:
    return place[0], place[1], _hex(place[2])


def _hex(value: float) -> str:
    return float(value).hex()
