"""The printed equations as values, and the verdict that the ledger gives on each."""

from rigidsym.paper.equation import Condition, Equation, Flaw, Reading
from rigidsym.paper.equations import EQUATIONS
from rigidsym.paper.table import row
from rigidsym.paper.verdicts import Ruling, Verdict, verdicts

__all__ = [
    "EQUATIONS",
    "Condition",
    "Equation",
    "Flaw",
    "Reading",
    "Ruling",
    "Verdict",
    "row",
    "verdicts",
]
