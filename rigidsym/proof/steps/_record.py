"""Derivation steps as records, and the error for a step that fails."""

from dataclasses import dataclass
from typing import Any

import sympy

from rigidsym.proof.algebra._computation import Computation
from rigidsym.proof.kernel import Fact


class StepError(ValueError):
    """Error for a derivation step that fails.

    The message names the step and gives the reason in one line.
    """


@dataclass(frozen=True, slots=True, repr=False)
class Step:
    """One line of a derivation, with the fact that proves it.

    `verb` names the step, `why` is the reason for it, and `value` is its result.
    `shown` are the equations of the line as unevaluated `Eq` of SymPy, with matrices as symbols.
    `conditions` must not be zero; `choice` tells in words what was chosen.
    """

    verb: str
    why: str
    value: Any
    shown: tuple[sympy.Basic, ...]
    fact: Fact
    conditions: tuple[sympy.Expr, ...] = ()
    choice: str = ""

    @property
    def found(self) -> Computation:
        """The step's value, as a computation by this step."""
        return Computation(self.value, (self.verb,))

    @property
    def source(self) -> tuple[str, ...]:
        """The paper's equations or references that the fact cites."""
        return self.fact.source

    def __getitem__(self, key: Any) -> Any:
        """Return an entry of the step's value.

        For example: `step[Omega1]` or `step[0, 1]`.
        """
        return self.value[key]

    def __repr__(self) -> str:
        equations = "; ".join(f"{left} = {right}" for left, right in (x.args for x in self.shown))
        return f"<{self.verb}: {equations} [{self.fact.id}]>"

    def _repr_html_(self) -> str:
        from rigidsym.view._article import line_html

        return line_html(self)

    def _repr_latex_(self) -> str:
        from rigidsym.view._article import line_latex

        return line_latex(self)

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        """Print the step in IPython's terminal format."""
        from rigidsym.view._article import line_text

        printer.text("..." if cycle else line_text(self))
