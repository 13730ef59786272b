"""What an article asks of what it shows; the steps and chapters of a derivation are such."""

from collections.abc import Sequence
from typing import Protocol

import sympy


class Named(Protocol):
    """A fact, of which the name is shown."""

    @property
    def id(self) -> str:
        """The name."""
        ...


class Line(Protocol):
    """A step: one line of a derivation."""

    @property
    def why(self) -> str:
        """What is done, in words."""
        ...

    @property
    def shown(self) -> tuple[sympy.Basic, ...]:
        """The equations."""
        ...

    @property
    def conditions(self) -> tuple[sympy.Expr, ...]:
        """What must not be zero."""
        ...

    @property
    def choice(self) -> str:
        """What was chosen, in words."""
        ...

    @property
    def source(self) -> tuple[str, ...]:
        """The paper's numbers."""
        ...

    @property
    def fact(self) -> Named:
        """What the kernel admitted."""
        ...


class Chapter(Protocol):
    """A chapter of a derivation."""

    @property
    def title(self) -> str:
        """Its title."""
        ...

    @property
    def opening(self) -> str:
        """What is done in it, in prose."""
        ...

    @property
    def steps(self) -> Sequence[Line]:
        """Its lines."""
        ...
