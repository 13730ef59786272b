"""Mutants: up to sixteen wrong versions of every statement that a normal form decides.

The same decision refutes a mutant, refuses it because it divides by what the hypotheses do not
cover, or shows that it is equivalent, an identity too.  The ledger keeps the count for every fact;
none is left unaccounted for.  Counts that the builder has from a sealed ledger are kept.
"""

from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._mutants import known_fates, tally


def derive(builder: LedgerBuilder) -> None:
    """Count the mutants of everything decided so far, by fact and by fate."""
    known = known_fates(builder.ledger, builder.sealed) if builder.sealed else {}
    counts = tally(builder.ledger, known)
    builder.ledger.published["mutants"] = counts
    builder.recounted = len(counts) - len(known)
