"""What the parts of the page ask of a report's data."""

from collections.abc import Iterator, Sequence

from rigidsym.view.report_data import ByPart, Cell, Implementation, Report
from rigidsym.view.validation.figures import condition, number, seconds


def modules(data: Report) -> Sequence[Implementation]:
    """The implementations that have to pass."""
    return [one for one in data["implementations"] if not one["peer"]]


def peers(data: Report) -> Sequence[Implementation]:
    """The implementations that are there for comparison."""
    return [one for one in data["implementations"] if one["peer"]]


def beyond(one: Implementation) -> str:
    """The class of what is beyond a bound: bad in a module, a fact about a peer."""
    return "far" if one["peer"] else "beyond"


def passed(data: Report) -> bool:
    """The report's own verdict."""
    return data["passed"]


def anchors(data: Report) -> dict[str, str]:
    """Where on the page the cases that are given in full are, by their names."""
    return {case["case"]: f"case-{k}" for k, case in enumerate(data["worst"], 1)}


def cells(
    implementations: Sequence[Implementation], view: ByPart, measure: str
) -> Iterator[tuple[str, str, Cell]]:
    """Contestant, part and cell of a view that has parts and then measures."""
    for one in implementations:
        for part, found in sorted(one[view].items()):
            if measure in found:
                yield one["name"], part, found[measure]


def worst(
    implementations: Sequence[Implementation], view: ByPart, measure: str
) -> tuple[str, str, Cell] | None:
    """The worst cell of a view by a measure, and whose it is; None where nothing was measured."""
    listed = cells(implementations, view, measure)
    return max(listed, key=lambda found: number(found[2]["units"]), default=None)


def place(cell: Cell) -> str:
    """In words: case, time, and condition where there is one."""
    known = condition(cell["condition"])
    return f"{cell['case']} at t = {seconds(cell['t'])}{known and ', '}{known}"
