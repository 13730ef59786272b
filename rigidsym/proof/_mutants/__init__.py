"""Mutants of a whole ledger: definitions that are changed together, with all proofs redone.

A ledger of true facts can still give wrong numbers: the definition of a published name may be
another one.  Here an attacker changes up to three definitions, meanings or publications at once,
and carries the change through the ledger, so that the kernel has nothing to refuse.  Then the
specification, or an evaluation of the published formulas, has to refuse the ledger.

`edits` lists changes of definitions, and `forger` makes a ledger with some of them.  `field`
evaluates a context modulo a prime, and `screen` refutes most mutants at such points.
`publications` has the mutants of everything else, and `campaign` decides them all.
"""

from rigidsym.proof._mutants._campaign import FATES, Checks, Tally, run
from rigidsym.proof._mutants._edits import Edit, double, exchange, sign, turn
from rigidsym.proof._mutants._forger import Forger

__all__ = [
    "FATES",
    "Checks",
    "Edit",
    "Forger",
    "Tally",
    "double",
    "exchange",
    "run",
    "sign",
    "turn",
]
