"""What is printed against what was derived: decided by the kernel, formula by formula.

Code generation selects, renames, shares, folds and multiplies out.  Each module here undoes one
of these and compares with the ledger, or with what a special function states:

    order     every name is set once, before it is used, and every line is needed
    sharing   lines put together again are the formulas that ledger and special functions state
    facts     formulas that name a fact, definition or reading of the ledger are it
    states    rows, gains and states together are the ledger's attitude and rates
    text      printed files read back as the lines

Not seen: whether a special function (nome, theta series, angles and their reduction) is the
standard one that it stands for, which its proved bounds and tests speak of, and what the runtimes
make of it all.
"""

from rigidsym.codegen.seal.decide import seal
from rigidsym.codegen.seal.equality import is_equal
from rigidsym.codegen.seal.text import seal_text

__all__ = ["is_equal", "seal", "seal_text"]
