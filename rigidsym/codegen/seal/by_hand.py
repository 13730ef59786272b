"""What is written by hand in a module, word for word; what stands between is left to be read."""

from dataclasses import dataclass
from functools import cached_property

from rigidsym.errors import InputError


@dataclass(frozen=True)
class Between:
    """The text of a file between two parts written by hand, and the number of its first line."""

    file: str
    line: int
    text: str

    @cached_property
    def _lines(self) -> list[str]:
        return self.text.split("\n")

    def at(self, line: int) -> str:
        """Return a line by its number in the file."""
        return self._lines[line - self.line]


def between(file: str, text: str, first: str, last: str) -> Between:
    """What a file has after its first part and before its last, which end with their lines.

    Raises InputError, naming the line, where a part is not there word for word.
    """
    lines, head, tail = (x.split("\n") for x in (text, first.removesuffix("\n"), last))
    for number, wanted in enumerate(head):
        _check(file, lines, number, wanted)
    for back, wanted in enumerate(reversed(tail), 1):
        _check(file, lines, len(lines) - back, wanted)
    if len(head) + len(tail) > len(lines):
        raise InputError(file, f"{len(lines)} lines", "are too few for what is written by hand")
    middle = lines[len(head) : len(lines) - len(tail)]
    return Between(file, len(head) + 1, "".join(f"{line}\n" for line in middle))


def _check(file: str, lines: list[str], number: int, wanted: str) -> None:
    line = lines[number] if 0 <= number < len(lines) else "the end of the file"
    if line != wanted:
        rule = f"is not the line written by hand, {wanted.strip() or 'an empty one'}"
        raise InputError(f"{file}:{number + 1}", line.strip() or "an empty line", rule)
