"""What a step leaves behind, and how it fails."""

from dataclasses import dataclass, field
from typing import Any

import sympy

from rigidsym.proof.kernel import Fact


class StepError(ValueError):
    """A step that cannot be done: its name and the reason in one line."""


@dataclass(frozen=True, slots=True, repr=False)
class Step:
    """One line of a derivation: what was done, what came of it, and the fact that says so.

    `shown` are the equations of the line as SymPy's `Eq`, unevaluated and with matrices by their
    names; `conditions` are what must not be zero, `choice` says in words what was chosen.
    """

    verb: str
    why: str
    value: Any
    shown: tuple[sympy.Basic, ...]
    fact: Fact
    conditions: tuple[sympy.Expr, ...] = ()
    choice: str = ""
    source: tuple[str, ...] = field(default=())

    def __getitem__(self, key: Any) -> Any:
        """An entry of the value: `step[Omega1]`, `step[0, 1]`."""
        return self.value[key]

    def __repr__(self) -> str:
        equations = "; ".join(f"{left} = {right}" for left, right in (x.args for x in self.shown))
        return f"<{self.verb}: {equations} [{self.fact.id}]>"

    def _repr_html_(self) -> str:
        from rigidsym.view.article import line_html

        return line_html(self)

    def _repr_latex_(self) -> str:
        from rigidsym.view.article import line_latex

        return line_latex(self)

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        """What IPython shows in a terminal."""
        from rigidsym.view.article import line_text

        printer.text("..." if cycle else line_text(self))
