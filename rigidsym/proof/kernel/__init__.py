"""The trusted kernel: contexts, facts, inference rules, certificates and replay.

It imports `sympy.polys` and the standard library.  A fact that a replayed ledger grades PROVED
follows from its context by polynomial arithmetic over Q; what its names mean is for readers.
Read the modules in this order: `language`, `ring`, `theta`, `context`, `rules`.
"""

from rigidsym.proof.kernel._context import Context
from rigidsym.proof.kernel._language import KernelError
from rigidsym.proof.kernel._ring import Element, Ring
from rigidsym.proof.kernel._rules import Fact, Grade, Ledger, replay

__all__ = ["Context", "Element", "Fact", "Grade", "KernelError", "Ledger", "Ring", "replay"]
