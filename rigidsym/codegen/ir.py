"""The intermediate form: named lets with provenance, grouped into functions.

Input and output of every pass are tuples of `Let`; no pass looks at the target's language.
"""

from dataclasses import dataclass

from rigidsym.solution.expression import Expression, to_text


@dataclass(frozen=True, slots=True)
class Let:
    """targets = expression, with the equations and facts that say so.

    One target, unless the expression calls a function that returns several values.
    """

    targets: tuple[str, ...]
    expression: Expression
    source: tuple[str, ...]
    facts: tuple[str, ...]

    def __str__(self) -> str:
        return f"{', '.join(self.targets)} = {to_text(self.expression)}"


@dataclass(frozen=True, slots=True)
class Function:
    """A straight-line function: parameters, lets, and the names it returns."""

    name: str
    summary: str
    parameters: tuple[str, ...]
    lets: tuple[Let, ...]
    results: tuple[str, ...]
