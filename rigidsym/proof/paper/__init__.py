"""The paper's printed equations, with the ledger's verdict on each."""

from rigidsym.proof.paper._counterexample import Counterexample
from rigidsym.proof.paper._equation import Condition, Equation, Flaw, Reading, Root, Sense
from rigidsym.proof.paper._prose import Judged, judged
from rigidsym.proof.paper._verdicts import EQUATIONS, Ruling, Verdict, verdicts

__all__ = [
    "EQUATIONS",
    "Condition",
    "Counterexample",
    "Equation",
    "Flaw",
    "Judged",
    "Reading",
    "Root",
    "Ruling",
    "Sense",
    "Verdict",
    "judged",
    "verdicts",
]
