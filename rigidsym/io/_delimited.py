"""Reader of text tables: delimiters, quotes, comments, the header, and where the data begin.

Nothing is guessed.  Where a table does not have the form that it is read in, an error names the
option that would read it.
"""

import csv
import re
import shlex
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rigidsym.errors import InputError

DELIMITERS = {"tab": "\t", "space": " "}
"Delimiters by name; any other is one character."
COMMENTS = "#%"
_BEGINS = f" \t{COMMENTS}"
# Cells of a line with blanks between them.
_CELL = re.compile(r'"((?:[^"]|"")*)"|(\S+)')
NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?", re.ASCII)


@dataclass(frozen=True, slots=True)
class Delimited:
    """A table of text cells.

    header: names of the columns; "#1", "#2" and so on where the file has none.  rows: the number of
    the line in the file, and its cells, as many as the header has.  title: the number of a comment
    that may have the names where there is no header, or 0.
    """

    header: tuple[str, ...]
    rows: tuple[tuple[int, tuple[str, ...]], ...]
    title: int = 0


def parse(
    text: str, delimiter: str = ",", header_line: int | None = None, data_line: int = 1
) -> Delimited:
    """Parse a table with a line of names, or without one if half of its first line is numbers.

    Empty lines and lines that begin with # or % are comments.

    header_line: the number of the line of names, which may be a comment; the first line otherwise.
    data_line: the number of the line where data may begin.  Raises InputError.
    """
    lines = text.removeprefix("\ufeff").splitlines()
    split = _splitter(delimiter)
    for name, number in (("header_line", header_line or 1), ("data_line", data_line)):
        if not 1 <= number <= max(len(lines), 1):
            raise InputError(name, number, f"must be a line of the file, which has {len(lines)}")
    listed, titles = [], {}
    for k, line in enumerate(lines, 1):
        if k <= (header_line or 0) or not line.strip():
            continue
        if line.lstrip()[0] in COMMENTS:
            titles[len(split(line.strip(_BEGINS)))] = k
        else:
            listed.append((k, split(line)))
    if not listed:
        raise InputError("observations", "the file", "has no lines of data")
    if header_line:
        header = split(lines[header_line - 1].strip(_BEGINS))
    elif is_numeric(listed[0][1]):
        width = len(listed[0][1])
        header = [f"#{k}" for k in range(1, width + 1)]
        rows = tuple(_row(header, *one) for one in listed if one[0] >= data_line)
        return Delimited(tuple(header), rows, titles.get(width, 0))
    else:
        header = listed.pop(0)[1]
    rest = [one for one in listed if one[0] >= data_line]
    if len(header) == 1 and rest:
        marks = ("tab", ";", "|", "space") if len(rest[0][1]) == 1 else ("tab", ";", "|")
        used = [x for x in marks if DELIMITERS.get(x, x) in header[0] and delimiter != x]
        if used:
            rule = f"is one column: add --delimiter {shlex.quote(used[0])}"
            raise InputError("header", repr(header[0]), rule)
    if rest and not any(map(str.isdigit, "".join(rest[0][1]))):
        rule = f"has no numbers: add --data-line {rest[0][0] + 1} if the data begin there"
        raise InputError(f"line {rest[0][0]}", ", ".join(rest[0][1]), rule)
    return Delimited(tuple(header), tuple(_row(header, *one) for one in rest))


def _splitter(delimiter: str) -> Callable[[str], list[str]]:
    """Return the function that splits a line into cells without blanks around them."""
    mark = DELIMITERS.get(delimiter, delimiter)
    if not isinstance(mark, str) or len(mark) != 1 or mark.isalnum() or mark in "\"'.+-\r\n":
        rule = f"must be one character such as ';', or one of: {', '.join(DELIMITERS)}"
        raise InputError("delimiter", repr(delimiter), rule)
    if mark == " ":
        return lambda line: [a.replace('""', '"') or b for a, b in _CELL.findall(line)]

    def split(line: str) -> list[str]:
        try:
            cells = next(csv.reader([line], delimiter=mark, skipinitialspace=True), [])
        except csv.Error as error:
            raise InputError("observations", line, f"is no line of a table: {error}") from None
        return [cell.strip() for cell in cells]

    return split


def is_numeric(cells: Sequence[str]) -> bool:
    """Return True if half of the cells or more are numbers, so that they are no names."""
    numbers = sum(bool(NUMBER.fullmatch(x.replace(",", "."))) for x in cells)
    return 0 < len(cells) <= 2 * numbers


def _row(header: list[str], line: int, cells: list[str]) -> tuple[int, tuple[str, ...]]:
    """Check that a row has as many cells as the header; empty ones at its end may be too many."""
    while len(cells) > len(header) and not cells[-1]:
        cells = cells[:-1]
    if len(cells) > len(header):
        rule = f"a line has more cells: line {line} has {len(cells)}; name or remove them"
        if not any(NUMBER.fullmatch(x) for x in cells):
            rule += f", or add --header-line {line} if it has the names"
        raise InputError("header", f"{len(header)} columns", rule)
    if len(cells) < len(header):
        rule = f"must be {len(header)} as in the header: fill in cells, or leave them empty"
        raise InputError(f"line {line}", f"{len(cells)} cells", rule)
    return line, tuple(cells)
