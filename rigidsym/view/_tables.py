"""Tables in Markdown and in plain text."""

from collections.abc import Iterable, Sequence


def row(cells: Iterable[str]) -> str:
    r"""Return a table row in Markdown, with bars in cells escaped.

    >>> row(["size", "|omega|"])
    '| size | \\|omega\\| |'
    """
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"


def table(columns: Sequence[str], rows: Iterable[Iterable[str]]) -> list[str]:
    """Return the lines of a table in Markdown."""
    return [row(columns), "|---" * len(columns) + "|", *map(row, rows)]


def columns(title: str, names: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table as text with aligned columns.

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
