"""What is printed against what was derived: decided by the kernel, formula by formula.

Code generation selects, renames, shares, folds and multiplies out.  Each module here undoes one
of these and compares with the ledger, or with what a special function states:

    order     every name is set once, before it is used, and every line is needed
    frame     functions take and give numbers in the order that the runtimes count on
    sharing   lines put together again are the formulas that ledger and special functions state
    facts     formulas that name a fact, definition or reading of the ledger are it
    states    rows, gains and states together are the ledger's attitude and rates
    text      printed files read back: numbers, signatures, lines and tables are what they print,
              in order, and all else is what the package has written by hand, word for word
    places    what the map tells of each line is what its comment says
    by_hand   cuts out what is written by hand;  digests  are those of the files

Not seen: whether a special function (nome, theta series, angles and their reduction) is the
standard one that it stands for, which its proved bounds and tests speak of, and what the runtimes
make of it all.  Of these the arithmetic of pairs is held against exact arithmetic by tests.
"""

from rigidsym.codegen.seal.decide import seal
from rigidsym.codegen.seal.equality import is_equal
from rigidsym.codegen.seal.text import seal_text

__all__ = ["is_equal", "seal", "seal_text"]
