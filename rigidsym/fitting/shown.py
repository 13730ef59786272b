"""A fit as users have it: what was found, and how it shows itself."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rigidsym.fitting import output, report
from rigidsym.fitting.found import Found
from rigidsym.view.fits import fit_card
from rigidsym.view.text import columns

if TYPE_CHECKING:
    from rigidsym.view.plots.figure import Figure

# Of the tables, those of which a fit tells by itself.
_FIRST = 3


@dataclass(frozen=True, repr=False, eq=False)
class Fit(Found):
    """The motion that observations show; see `Found` for what it has."""

    def plot(self) -> "Figure":
        """The residuals, in units of their errors (needs matplotlib)."""
        return output.residuals(self)

    def tables(self) -> list[report.Table]:
        """A title, columns and rows each, for reading."""
        return report.tables(self)

    def to_json(self) -> str:
        """Schema rigidsym.fit/1."""
        return report.to_json(self)

    def write(self, directory: Path) -> list[Path]:
        """Write fit.json, the motion as a case file, a page, and pictures where there is
        matplotlib."""
        return output.write(self, directory)

    def __repr__(self) -> str:
        shown = [columns(*table) for table in self.tables()[:_FIRST]]
        return "\n\n".join([report.title(self), *shown])

    def _repr_html_(self) -> str:
        return fit_card(report.title(self), self.tables()[:_FIRST])
