"""Mutants of a whole ledger: definitions that are changed together, with all proofs redone.

A ledger of true facts can still give wrong numbers: the definition of a published name may be
another one.  Here an attacker changes up to three definitions, meanings or publications at once,
and carries the change through the ledger, so that the kernel has nothing to refuse.  Then the
specification, or an evaluation of the published formulas, has to refuse the ledger.

`edits` lists the changes, and `forger` makes a ledger with some of them.
"""

from rigidsym.proof.mutants._edits import Edit, double, exchange, sign, turn
from rigidsym.proof.mutants._forger import Forger

__all__ = ["Edit", "Forger", "double", "exchange", "sign", "turn"]
