"""Mutants: every statement decided by normal form, made wrong in up to sixteen places.

The same decision refutes a mutant, refuses it because it divides by what the hypotheses do not
cover, or shows that it is equivalent, an identity too.  The ledger keeps the count for every fact;
none is left unaccounted for.
"""

from rigidsym.proof.algebra import Book
from rigidsym.proof.algebra.mutants import tally


def derive(book: Book) -> None:
    """Count the mutants of everything decided so far, by fact and by fate."""
    book.ledger.published["mutants"] = tally(book.ledger)
