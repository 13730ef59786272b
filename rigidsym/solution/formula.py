"""One formula of the solution, and what the ledger has it from."""

from dataclasses import dataclass

from rigidsym.language.expression import Expression


@dataclass(frozen=True, slots=True)
class Formula:
    """name = expression, by what the ledger has it from; `source` lists equations of the paper.

    `fact` is the id of a proved fact, or "definition context.name" or "reading context.name" where
    that context says so, or "choice context.name" of a sign that makes its hypotheses hold;
    `context` has its hypotheses.  Functions of a parameter m take its complement 1 - m as their
    last argument.
    """

    name: str
    expression: Expression
    fact: str
    context: str
    source: tuple[str, ...]

    @property
    def is_reading(self) -> bool:
        """Whether the expression is the standard function that a name stands for."""
        return self.fact.startswith("reading ")
