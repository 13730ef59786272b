"""A second, independent checker of the ledger.

It decides the same question as `rigidsym.proof.kernel`: does every fact of a ledger follow from the
hypotheses of its context?  It shares no code with the kernel and no algebra system: polynomials
are FLINT's, where the kernel has SymPy's.  So a fact that both accept does not rest on the bugs
of either one.  Where points are given, its own balls have to agree with a fact.  A specification
says which theorems have to be among the facts.  It reads ledgers; it cannot write them.
"""

from rigidsym.proof.checker.records import Refused
from rigidsym.proof.checker.rules import check, grades

__all__ = ["Refused", "check", "grades"]
