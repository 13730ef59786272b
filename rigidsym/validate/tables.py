"""Tables for a terminal: a whole validation, and one case at all of its times."""

from collections.abc import Sequence

from rigidsym.validate.finding import Finding
from rigidsym.validate.report import ValidationReport
from rigidsym.validate.tally import DRAWN, Cell

Table = tuple[Sequence[str], Sequence[Sequence[str]]]


def summary(report: ValidationReport) -> Table:
    """Strata; of each implementation its worst angle and rates, and the part of a bound used."""
    campaign, tally = report.campaign, report.tally
    columns = ["stratum", "cases", "states"]
    for name in campaign.implementations:
        columns += [f"{name}: angle", "rates", "share"]
    rows = []
    for stratum in campaign.strata:
        row = [stratum, *(str(x.get(stratum, 0)) for x in (tally.cases, tally.states))]
        for name in campaign.implementations:
            cells = (tally.cells.get((name, measure, "stratum", stratum)) for measure in DRAWN)
            row += [*map(_units, cells), _share(report.share(name, stratum))]
        rows.append(row)
    return columns, rows


def case(finding: Finding) -> Table:
    """Times, angles turned, and errors of each implementation with the condition of the problem."""
    columns = ["t (s)", "turned (rad)", "condition"]
    for name in finding.errors:
        columns += [f"{name}: angle", "rates"]
    reference = finding.reference
    rows = []
    for k, time in enumerate(finding.sample.times):
        condition = reference.condition["angle"][k]
        row = [repr(time), f"{reference.turned[k]:.3g}", f"{condition:.1g}"]
        for errors in finding.errors.values():
            row += [
                _figure(x) for m in DRAWN for x in errors[m].units[errors[m].times == time][:1]
            ] or ["not asked", ""]
        rows.append(row)
    return columns, rows


def _units(cell: Cell | None) -> str:
    return "not asked" if cell is None else _figure(cell.worst)


def _figure(units: float) -> str:
    return f"{units:.2f}" if units < 1000 else f"{units:.1e}"


def _share(share: float) -> str:
    return f"{share:.0%}" if share < 10 else f"{share:.1e}"
