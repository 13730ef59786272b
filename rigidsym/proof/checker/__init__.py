"""Second, independent checker of ledgers.

It decides the same question as `rigidsym.proof.kernel`: does every fact of a ledger follow from the
hypotheses of its context?  It shares no code with the kernel and no algebra system: it uses FLINT's
polynomials, the kernel uses SymPy's.  So a fact that both accept does not rest on a bug in one of
them.  Where points are given, its own balls have to agree with a fact.  A specification lists the
theorems that have to be among the facts.  The checker reads ledgers; it cannot write them.
"""

from rigidsym.proof.checker._records import Refused
from rigidsym.proof.checker._rules import check, grades, require

__all__ = ["Refused", "check", "grades", "require"]
