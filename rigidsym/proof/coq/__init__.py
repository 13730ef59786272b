"""The ledger for Coq: contexts and facts as theorems on real numbers and real functions of time.

Nothing that is written here is trusted: Coq checks every certificate again, by a checker that
`prelude.v` proves sound.  `theorems/`, by hand, says what follows in plain words:
which functions of time are the motion.
"""

from rigidsym.proof.coq.export import Export, export
from rigidsym.proof.coq.facts import SUPPOSED

__all__ = ["SUPPOSED", "Export", "export"]
