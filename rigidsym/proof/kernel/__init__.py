"""The trusted core: contexts, facts, rules, grades, certificates and their replay.

It imports `sympy.polys` and the standard library.  A fact that a replayed ledger grades PROVED
follows from its context by polynomial arithmetic over Q.  Whether it says what is meant depends on
the meanings of the names, which readers have to judge (`reading`).
Read the modules in this order: `language`, `ring`, `theta`, `statement`, `rules`, `ledger`.
"""

from rigidsym.proof.kernel.language import KernelError
from rigidsym.proof.kernel.ledger import Ledger, replay
from rigidsym.proof.kernel.ring import Element, Ring
from rigidsym.proof.kernel.statement import Context, Fact, Grade

__all__ = ["Context", "Element", "Fact", "Grade", "KernelError", "Ledger", "Ring", "replay"]
