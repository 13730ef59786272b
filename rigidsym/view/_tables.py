"""Functions that format tables in Markdown and in plain text."""

from collections.abc import Iterable, Sequence


def row(cells: Iterable[str]) -> str:
    r"""Format a row of a Markdown table, with vertical bars in cells escaped.

    >>> row(["size", "|omega|"])
    '| size | \\|omega\\| |'
    """
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"


def table(columns: Sequence[str], rows: Iterable[Iterable[str]]) -> list[str]:
    """Format a table in Markdown, and return its lines."""
    return [row(columns), "|---" * len(columns) + "|", *map(row, rows)]


def columns(title: str, names: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Format a table as plain text with aligned columns.

    >>> print(columns("planets", ("", "moons"), [("Mars", "2"), ("Jupiter", "101")]))
    planets
             moons
    Mars     2
    Jupiter  101
    """
    table = [tuple(names), *map(tuple, rows)]
    table = table if any(names) else table[1:]
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    lines = ("  ".join(map(str.ljust, row, widths)).rstrip() for row in table)
    return "\n".join([title, *lines])
