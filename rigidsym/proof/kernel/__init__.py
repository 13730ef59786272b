"""The trusted core: contexts, facts, rules, grades, certificates and their replay.

It imports `sympy.polys` and the standard library.  What a replayed ledger grades PROVED follows by
polynomial arithmetic over Q from a context; whether that says what is meant, `reading` must tell.
To be read in this order: `language`, `ring`, `theta`, `statement`, `rules`, `ledger`.
"""

from rigidsym.proof.kernel.language import KernelError
from rigidsym.proof.kernel.ledger import Ledger, replay
from rigidsym.proof.kernel.ring import Element, Ring
from rigidsym.proof.kernel.statement import Context, Fact, Grade

__all__ = ["Context", "Element", "Fact", "Grade", "KernelError", "Ledger", "Ring", "replay"]
