"""Tables in Markdown."""

from collections.abc import Iterable, Sequence


def row(cells: Iterable[str]) -> str:
    r"""A row; bars inside of cells are no borders.

    >>> row(["size", "|omega|"])
    '| size | \\|omega\\| |'
    """
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"


def table(columns: Sequence[str], rows: Iterable[Iterable[str]]) -> list[str]:
    """The lines of a table."""
    return [row(columns), "|---" * len(columns) + "|", *map(row, rows)]
