"""The printed equations as values, and the verdict that the ledger gives on each."""

from rigidsym.paper.equations import EQUATIONS, Equation
from rigidsym.paper.verdicts import Ruling, Verdict, verdicts

__all__ = ["EQUATIONS", "Equation", "Ruling", "Verdict", "verdicts"]
