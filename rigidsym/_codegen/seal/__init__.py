"""Proof by the kernel that printed code equals the derived formulas.

Code generation selects, renames, shares, folds and multiplies out.  Each module here undoes some of
these and compares with the ledger, or with what a special function states:

    structure  every name is set once, before it is used, and every line is needed; functions take
               and give numbers in the order that the runtimes count on; lines put together again
               are the formulas that ledger and special functions state
    facts      every formula that cites a fact, definition or reading of the ledger equals it
    states     rows, gains and states together give the ledger's attitude and rates
    text       printed files read back: statements, numbers, signatures and tables, runtimes
               included, are those of the representation, in order, and all else is what the
               package has written by hand, word for word; digests are those of the files, and the
               map says of each line what its comment says
    bodies     statements of functions read back, compared with their routines, for every language
    trees      readers of languages with the operators of C, and their files

The seal does not cover two things.  Proved bounds and tests show that a special function (nome,
theta series, angles and their reduction) is the standard one.  Tests and validation measure the
representation of the runtimes, which is written, not derived; double-double arithmetic is compared
with exact arithmetic.
"""

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.forms import THETA
from rigidsym._codegen.functions import constants, finished, functions, stated
from rigidsym._codegen.seal import facts, states, structure
from rigidsym._codegen.seal.equality import is_equal
from rigidsym._codegen.seal.text import seal_text
from rigidsym.solution import Solution

__all__ = ["is_equal", "seal", "seal_text"]


def seal(solution: Solution, form: str = THETA, binary: Format = BINARY64) -> int:
    """Prove with the kernel that generated code equals the derived formulas.

    Returns the number of claims that were decided.  Raises InputError, naming the formula, for the
    first formula that the lines do not give.
    """
    origin = stated(solution, form, binary)
    every = tuple(finished(function, binary) for function in origin)
    structure.check_order(every, {number.name for number in constants(binary)})
    if not binary.is_wide:
        structure.check_rounding(every, functions(solution, form, binary))
    structure.check_interfaces(every, form)
    claims = [
        *structure.sharing_claims(origin, every),
        *facts.claims(solution, every, form),
        *states.claims(solution, every, form),
    ]
    for claim in claims:
        claim.decide()
    return len(claims)
