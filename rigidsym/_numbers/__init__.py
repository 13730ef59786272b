"""Published sequences against enclosures of the equations of motion, at motions drawn by a hash.

This is where the two halves meet: a ledger says which formulas it publishes and what their
functions mean, and Taylor series of the equations of motion say what the numbers have to be.  The
check reads neither the specification nor the proofs.
"""

import json

from flint import ctx

from rigidsym._numbers._claims import CLAIMS, Case
from rigidsym._numbers._contexts import Contexts
from rigidsym._numbers._models import TERMS
from rigidsym._numbers._motions import motions
from rigidsym._numbers._values import Sequences
from rigidsym.errors import LedgerError, PrecisionError
from rigidsym.language._specification import Proved
from rigidsym.precise._balls import ball, working

BITS = 80


def check_numbers(text: str) -> tuple[int, int]:
    """Compare every published formula of a ledger with the equations of motion.

    Return the numbers of motions and of formulas.  Raises LedgerError, which names a sequence, an
    output and a motion, for a ledger whose formulas have other values, or that publishes formulas
    which no comparison depends on.
    """
    try:
        ledger = json.loads(text)
        sequences = Sequences(Proved(ledger))
        contexts = Contexts(ledger, sequences.functions)
    except (ValueError, LookupError, TypeError, AttributeError):
        raise LedgerError("ledger: its contexts and sequences are not readable") from None
    count, terms = 0, ctx.cap
    with working(BITS):
        ctx.cap = TERMS
        try:
            for motion in motions(text):
                case, count = Case(motion, sequences), count + 1
                try:
                    for compare, applies in CLAIMS:
                        if applies(motion):
                            compare(case)
                except (PrecisionError, ZeroDivisionError) as error:
                    place = f"sequence {sequences.last}"
                    raise LedgerError(f"ledger: {place}: {error}, for {motion}") from None
                contexts.inhabit(case.worlds, ball(motion.time), motion)
        finally:
            ctx.cap = terms
    if empty := sorted(contexts.contexts.keys() - contexts.inhabited):
        raise LedgerError(f"ledger: context {empty[0]}: no motion has values of all its names")
    if left := sequences.left():
        sequence, output = left[0]
        raise LedgerError(f"ledger: sequence {sequence}: {output} is compared with nothing")
    return count, sum(len(x.formulas) for x in sequences.sequences.values())
