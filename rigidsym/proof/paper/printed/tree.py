"""What a display is made of: statements, and words between them.

The sides of a statement are expressions of `rigidsym.language`; what these have no form for is a
call: `matrix` of four entries, `bracket`, `at` a time, `d` of a differential, `integral` of a
product with one, `pm` of what has either sign, `abs`, `nabla`, `partial`.  The imaginary unit is
the name `imaginary`, and a bar or a star is part of a name: `Rbar`, `y_star`.
"""

from dataclasses import dataclass
from typing import TypeAlias

from rigidsym.language.expression import Expression


class PrintError(ValueError):
    """A display that cannot be read, or that has no meaning in a context."""


@dataclass(frozen=True, slots=True)
class Statement:
    """Sides with a relation between each two: `=`, `<=`, `>=`, `<`, `>`, `!=`, `<->` or `:`."""

    sides: tuple[Expression, ...]
    relations: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Words:
    """Text between formulas."""

    text: str


Display: TypeAlias = tuple[Statement | Words, ...]
