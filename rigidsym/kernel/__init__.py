"""The trusted core: contexts, facts, rules, grades, certificates and their replay.

It imports `sympy.polys` and the standard library only.  What it guarantees: every fact of a
replayed ledger follows from the hypotheses of its context by polynomial arithmetic over Q.
What it does not: that a context says what its author had in mind (read its `reading`).
"""

from rigidsym.kernel.context import Context
from rigidsym.kernel.fact import Fact, Grade
from rigidsym.kernel.ledger import Ledger, replay
from rigidsym.kernel.ring import Element, KernelError, Ring

__all__ = ["Context", "Element", "Fact", "Grade", "KernelError", "Ledger", "Ring", "replay"]
