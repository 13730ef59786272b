"""Balls at points that nobody chose: a hash of the claim says where, so that no claim fits them.

Numbers come from (0, 1), its ends and (-8, 8); whole ones are small.  Where a relation is between
such names, the last of them is solved for.  What turns out to be no point, or to have no value
there, is passed over; `DUE` points have to be left.
"""

import hashlib

from flint import acb, ctx, fmpq

from rigidsym.proof.checker.enclosures import Values
from rigidsym.proof.checker.language import NAME
from rigidsym.proof.checker.records import Claim, Hypotheses, Refused

DUE, MOST = 40, 400
# The sides agree as far as a draw can show; no claim knows its draws.
BITS, ALIKE = 128, "1e-18"


def look_elsewhere(given: Hypotheses, fact: Claim, free: list[str], whole: list[str]) -> None:
    """Refuse an equation that fails where it was not chosen to be looked at."""
    free = [name for name in given.generators if name in free]
    seen = 0
    with ctx.workprec(BITS):
        for k in range(MOST):
            try:
                values = Values(given, _draw(given, fact, free, whole, k))
                confirmed = values.confirm(fact, ALIKE)
            except (Refused, ArithmeticError):
                continue
            if not confirmed:
                raise Refused(f"balls do not confirm {fact.lhs} = {fact.rhs} at draw {k}")
            seen += 1
            if seen == DUE:
                return
    raise Refused(f"only {seen} of {MOST} draws are points of {given.name}")


def _draw(
    given: Hypotheses, fact: Claim, free: list[str], whole: list[str], k: int
) -> dict[str, acb]:
    found = {}
    for name in free:
        told = repr((fact.context, fact.lhs, fact.rhs, name, k)).encode()
        seed = hashlib.blake2b(told, digest_size=16).digest()
        found[name] = _number(seed, name in whole, name in given.nonnegative)
    for relation in given.relations:
        names = {*NAME.findall(relation)}
        if names <= {*free}:
            name = max(names, key=free.index)
            found[name] = _solve(given, found, name, relation)
    return found


def _number(seed: bytes, whole: bool, positive: bool) -> acb:
    """A number between 0 and 1, near them, or between -8 and 8."""
    part, choice = fmpq(int.from_bytes(seed[:8], "little"), 2**64), seed[8] % 10
    if whole:
        return acb(seed[9] % 9 - 4)
    if choice == 0:
        return acb(part / 4096)
    if choice == 1:
        return acb(1 - part / 4096)
    if choice < 7:
        return acb(part)
    return acb(8 * part if positive or choice == 7 else -8 * part)


def _solve(given: Hypotheses, known: dict[str, acb], name: str, relation: str) -> acb:
    """The name from a relation without its odd, or without its even powers but a constant."""
    at = [Values(given, {**known, name: acb(x)}).read(relation) for x in (-1, 0, 1)]
    if (at[0] - at[2]).contains(0):
        square = at[1] / (at[1] - at[2])
        if not square.real > 0:
            raise Refused(f"{name} is not real")
        return square.sqrt() if known[name].real > 0 else -square.sqrt()
    return at[1] / (at[1] - at[2])
