"""Derived text in C as statements, without comments and without what no derived line has."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from rigidsym.codegen.seal.by_hand import Between
from rigidsym.errors import InputError

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
# A backslash, or a trigraph, could end a comment early; the rest is what no derived line needs.
_STRANGE = re.compile(r"\\|\?\?|[^\n -~]")
_FOREIGN = re.compile(r"//|/\*|[^\w\s(){}\[\]+*/,;.=<>&-]")
# A loop, a number that is a pair, or what ends with a semicolon or begins or ends a block.
_STATEMENT = re.compile(r"\s*(for \([^(){}]*\) \{|[^;{}]*= \{[^;{}]*\};|[^;{}]*[;{}])")


class Statement(NamedTuple):
    """A statement, spaced as if it were in one line, and the line that it begins in."""

    line: int
    text: str


def statements(file: str, derived: Between) -> Iterator[Statement]:
    """Raises InputError, naming the line, for a character that derived text does not have."""
    _refuse(file, derived, _STRANGE)
    blank = Between(file, derived.line, _COMMENT.sub(_spaces, derived.text))
    _refuse(file, blank, _FOREIGN)
    text, begin, line = blank.text, 0, blank.line
    end = len(text.rstrip())
    while begin < end:
        found = _STATEMENT.match(text, begin)
        if not found:
            raise InputError(f"{file}:{line}", text[begin:].strip(), "does not end")
        line += text.count("\n", begin, found.start(1))
        yield Statement(line, " ".join(found[1].split()))
        line += text.count("\n", found.start(1), found.end())
        begin = found.end()


def _spaces(comment: re.Match[str]) -> str:
    """As many lines."""
    return " " + "\n" * comment[0].count("\n")


def _refuse(file: str, text: Between, what: re.Pattern[str]) -> None:
    found = what.search(text.text)
    if found:
        number = text.text.count("\n", 0, found.start())
        line = text.text.split("\n")[number].strip()
        rule = f"derived text has no {found[0].strip()!r}"
        raise InputError(f"{file}:{number + text.line}", line, rule)
