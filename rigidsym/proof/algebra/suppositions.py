"""Whether balls agree with a supposition: where its author looks, and where nobody chose to.

Beside the author's points there are `COUNT` others, whose numbers are a hash of what is claimed:
from (0, 1), from its edges, from (-10, 10), or whole where the certificate says so.  Of names that
a relation ties the last follows from it.  Attempts that are no points of the context, or where a
function has no value, count for nothing.
"""

from collections.abc import Iterator, Mapping, Sequence
from hashlib import sha256

from flint import acb, ctx, fmpq

from rigidsym.proof.algebra.enclosures import BITS, Evaluation, agrees, names, rational
from rigidsym.proof.kernel import Context, Fact, KernelError
from rigidsym.proof.kernel.language import parse

COUNT, ATTEMPTS = 40, 400
FEWER_BITS = 128


def encloses(context: Context, fact: Fact, points: Sequence[Mapping[str, str]]) -> bool:
    """Whether lhs - rhs is enclosed near zero at the points, and at those that are drawn."""
    with ctx.workprec(BITS):
        given = (Evaluation(context, rational(context, point)) for point in points)
        if not all(agrees(at, fact) for at in given):
            return False
    free = [name for name in context.generators if name in points[0]]
    with ctx.workprec(FEWER_BITS):
        return _everywhere(context, fact, free)


def _everywhere(context: Context, fact: Fact, free: Sequence[str]) -> bool:
    """Whether balls agree at as many points as are due; KernelError where there are fewer."""
    found = 0
    for attempt in range(ATTEMPTS):
        try:
            agreed = agrees(_drawn(context, fact, free, attempt), fact)
        except (KernelError, ZeroDivisionError):
            continue
        if not agreed:
            return False
        found += 1
        if found == COUNT:
            return True
    raise KernelError(f"only {found} of {ATTEMPTS} drawn points are points where balls can look")


def _drawn(context: Context, fact: Fact, free: Sequence[str], attempt: int) -> Evaluation:
    known = {name: _number(context, fact, name, attempt) for name in free}
    for name, relation in _ties(context, free):
        sign = -1 if known.pop(name).real < 0 else 1
        known[name] = sign * _solution(context, known, name, relation)
    return Evaluation(context, known)


def _number(context: Context, fact: Fact, name: str, attempt: int) -> acb:
    """A number for a name: the same for the same claim, another for any other."""
    claim = [fact.context, *fact.lhs, "=", *fact.rhs, name, str(attempt)]
    digest = sha256("\n".join(claim).encode()).digest()
    share, kind = fmpq(int.from_bytes(digest[:8]), 2**64), digest[8] % 8
    if name in fact.certificate.get("whole", ()):
        return acb(digest[9] % 7 - 3)
    if kind < 4:
        return acb(share)
    if kind < 6:
        return acb(share / 1000 if kind == 4 else 1 - share / 1000)
    return acb(10 * share if kind == 6 or name in context.nonnegative else -10 * share)


def _ties(context: Context, free: Sequence[str]) -> Iterator[tuple[str, str]]:
    """The last name of each relation between free names, and the relation."""
    for relation in context.relations:
        if (tied := {*names(parse(relation))}) <= {*free}:
            yield max(tied, key=free.index), relation


def _solution(context: Context, known: Mapping[str, acb], name: str, relation: str) -> acb:
    """x of a + b x = 0, or the positive one of a + b x**2 = 0; others are caught as no points."""
    zero, one, less = (
        Evaluation(context, {**known, name: acb(x)}).value(relation) for x in (0, 1, -1)
    )
    value = zero / (zero - one)
    if (one - less).contains(0):
        if not value.real > 0:
            raise KernelError(f"{relation} = 0 has no real {name}")
        value = value.sqrt()
    return value
