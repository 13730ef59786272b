"""A comparison as files and tables."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import TypedDict

from rigidsym._version import __version__
from rigidsym.io.files import write_bytes, write_text
from rigidsym.manoeuvre.comparison import flights, optima, tables
from rigidsym.manoeuvre.comparison.cases import IMPULSE
from rigidsym.manoeuvre.comparison.collocation.mesh import INTERVALS, POINTS
from rigidsym.manoeuvre.comparison.collocation.solver import (
    MOST_ITERATIONS,
    SETTINGS,
    TOLERANCE,
)
from rigidsym.manoeuvre.comparison.page import page
from rigidsym.manoeuvre.comparison.picture import picture
from rigidsym.manoeuvre.comparison.record import Record, RecordData
from rigidsym.manoeuvre.comparison.statistics import Summary, summary
from rigidsym.manoeuvre.flight.settings import Controller, Wheels
from rigidsym.view.plots import histories as drawing

SCHEMA = "rigidsym.comparison/1"
PACKAGES = ("casadi", "numpy", "scipy")


# In the units of manoeuvre files; those of one thing in a table by its name.
Settings = Mapping[str, float | Mapping[str, object]]


class ComparisonData(TypedDict):
    """The schema rigidsym.comparison/1."""

    schema: str
    command: str
    settings: Settings
    packages: dict[str, str]
    summary: Summary
    manoeuvres: list[RecordData]


@dataclass(frozen=True)
class Comparison:
    """Manoeuvres from 0 on of a seed, and what was found of each."""

    seed: int
    records: tuple[Record, ...]

    @cached_property
    def summary(self) -> Summary:
        """Spreads and counts over the manoeuvres; see `statistics`."""
        return summary(self.records)

    @property
    def command(self) -> str:
        """What leads here."""
        return f"rigidsym compare --manoeuvres {len(self.records)} --seed {self.seed}"

    def to_data(self) -> ComparisonData:
        """The schema rigidsym.comparison/1: no times, so that it is the same on each run."""
        return {
            "schema": SCHEMA,
            "command": self.command,
            "settings": _settings(),
            "packages": {"rigidsym": __version__, **{name: version(name) for name in PACKAGES}},
            "summary": self.summary,
            "manoeuvres": [record.to_data() for record in self.records],
        }

    def to_json(self) -> str:
        """The same as text."""
        return json.dumps(self.to_data(), indent=1) + "\n"

    def tables(self) -> list[tuple[str, Sequence[str], Sequence[Sequence[str]]]]:
        """Titles, columns and rows for reading."""
        return tables.brief(self.summary)

    @property
    def conclusion(self) -> str:
        """What was found, in a sentence."""
        return tables.conclusion(self.summary, len(self.records))

    def write(self, directory: Path) -> list[Path]:
        """Write comparison.json, comparison.md and the picture; raises InputError."""
        text = page(self.command, len(self.records), self.summary)
        written = [
            write_text(directory / "comparison.json", self.to_json()),
            write_text(directory / "comparison.md", text),
        ]
        for suffix, data in drawing.rendered(picture(self.records)).items():
            written.append(write_bytes(directory / f"comparison.{suffix}", data))
        return written


def _settings() -> Settings:
    """What was chosen, in the units of manoeuvre files."""
    return {
        "impulse": IMPULSE,
        "hold": flights.HOLD,
        "period": float(flights.PERIOD),
        "wheels": asdict(Wheels()),
        "controller": asdict(Controller()),
        "intervals": INTERVALS,
        "points": POINTS,
        "tolerance": TOLERANCE,
        "most_iterations": MOST_ITERATIONS,
        "same": optima.SAME,
        "optimiser": {name: dict(options) for name, options in SETTINGS.items()},
    }
