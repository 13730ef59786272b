"""Mutants: every statement decided by normal form, made wrong in up to sixteen places.

The same decision refutes a mutant, refuses it because it divides by what the hypotheses do not
cover, or shows that it is equivalent, an identity too.  The ledger keeps the count for every fact;
none is left unaccounted for.  Counts that the book has from a sealed ledger are kept.
"""

from rigidsym.proof.algebra import Book
from rigidsym.proof.algebra.mutants import known_fates, tally


def derive(book: Book) -> None:
    """Count the mutants of everything decided so far, by fact and by fate."""
    known = known_fates(book.ledger, book.sealed) if book.sealed else {}
    counts = tally(book.ledger, known)
    book.ledger.published["mutants"] = counts
    book.recounted = len(counts) - len(known)
