"""Export of the ledger of proved facts to Coq, as theorems on real numbers and functions.

The exporter is not trusted: Coq checks every certificate again, by a checker that `prelude.v`
proves sound.  The hand-written `theorems/` state the conclusions: which functions of time are the
motion.
"""

from rigidsym.proof._coq.export import Export, export
from rigidsym.proof._coq.facts import SUPPOSED

__all__ = ["SUPPOSED", "Export", "export"]
