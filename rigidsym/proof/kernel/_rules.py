"""Inference rules, each of which checks one fact by its premises and its certificate.

It returns the grade that the rule itself gives, or raises.  Nothing that a fact claims is trusted.
"""

from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sympy.polys.rings import PolyElement

from rigidsym.proof.kernel._language import KernelError, is_name, parse
from rigidsym.proof.kernel._ring import Element, Ring, at
from rigidsym.proof.kernel._statement import Context, Fact, Grade
from rigidsym.proof.kernel._theta import Thetas

# Whether balls agree with a fact of a context at points; it is trusted with grade ENCLOSED.
Encloses = Callable[[Context, Fact, Sequence[Mapping[str, str]]], bool]


@dataclass(slots=True)
class Admitted:
    """The contexts and facts admitted so far, which are all that a rule may use."""

    encloses: Encloses | None = None
    contexts: dict[str, Context] = field(default_factory=dict)
    facts: dict[str, Fact] = field(default_factory=dict)
    rings: dict[str, Ring] = field(default_factory=dict)


def identity(admitted: Admitted, fact: Fact) -> Grade:
    """Check an identity by its cofactors.
    numerator(lhs_k - rhs_k) = sum_j cofactor_kj * relation_j     for every component k
    -----------------------------------------------------------------------------------
    Gamma |- lhs = rhs

    If lhs >= 0 is visible, and with lhs**2 for lhs:    Gamma |- lhs = sqrt(rhs)
    If rhs >= 0 is visible:                             Gamma |- lhs = rhs >= 0
    """
    ring = admitted.rings[fact.context]
    visible = {"equal": (), "root": fact.lhs, "nonnegative": fact.rhs}
    _check_signs(visible[fact.kind], admitted.contexts[fact.context])
    for difference, row in zip(differences(ring, fact), fact.certificate["cofactors"], strict=True):
        for cofactor, relation in zip(map(ring.read, row), ring.relations, strict=True):
            if cofactor.below:
                raise KernelError("a cofactor is no polynomial")
            if cofactor.numerator:
                difference -= (cofactor * Element(relation)).numerator
        if difference:
            raise KernelError("the cofactors do not give lhs - rhs")
    return Grade.PROVED


def counterexample(admitted: Admitted, fact: Fact) -> Grade:
    """Check that the sides of an equation differ at a rational point.
    a rational point of Gamma at which lhs differs from rhs
    -------------------------------------------------------
    Gamma |- lhs != rhs at some point
    """
    ring, context = admitted.rings[fact.context], admitted.contexts[fact.context]
    if context.thetas or context.start:
        raise KernelError("what is declared of functions may exclude the point")
    point = context.check_point(ring, fact.certificate["point"])
    if not any(at(difference, point) for difference in differences(ring, fact)):
        raise KernelError("both sides agree at this point")
    return Grade.PROVED


def model(admitted: Admitted, fact: Fact) -> Grade:
    """Check that a context satisfies all hypotheses of another one.
    every name of Gamma is a name of Delta, where, by the premises, the relations of Gamma vanish,
    its units are units, its signs are visible, its definitions hold and D reads the same
    ----------------------------------------------------------------------------------------------
    Delta |- model of Gamma
    """
    (gamma,) = (admitted.contexts[name] for name in fact.lhs + fact.rhs)
    delta, ring = admitted.contexts[fact.context], admitted.rings[fact.context]
    given: list[PolyElement] = []
    for premise in (admitted.facts[name] for name in fact.premises):
        if (premise.kind, premise.context) != ("equal", fact.context):
            raise KernelError(f"{premise.id} is not an equation of {fact.context}")
        given += filter(None, differences(ring, premise))
    for generator in gamma.generators:
        ring.read(generator)
    if not gamma.thetas.items() <= delta.thetas.items() or not {*gamma.start} <= {*delta.start}:
        raise KernelError(f"what {gamma.name} declares of functions is not declared here")
    zeros = [f"{name} - ({text})" for name, text in said(gamma).items() - said(delta).items()]
    for zero in sorted({*zeros, *gamma.relations} - {*delta.relations}):
        if ring.remainder(ring.read(zero).numerator, *given):
            raise KernelError(f"{zero} = 0 of {gamma.name} does not hold")
    for unit in gamma.units:
        ring.inverse(ring.read(unit))
    _check_signs(gamma.nonnegative, delta)
    return Grade.PROVED


def transfer(admitted: Admitted, fact: Fact) -> Grade:
    """Check a fact carried over from another context whose hypotheses hold in the fact's own.
    Gamma |- statement        Delta |- model of Gamma
    -------------------------------------------------
    Delta |- statement
    """
    there, bridge = (admitted.facts[premise] for premise in fact.premises)
    if (bridge.kind, bridge.context, bridge.rhs) != ("model", fact.context, (there.context,)):
        raise KernelError(f"{bridge.id} does not make this context a model of {there.context}")
    if (fact.kind, fact.lhs, fact.rhs) != (there.kind, there.lhs, there.rhs):
        raise KernelError(f"this is not the statement of {there.id}")
    return Grade.PROVED


def partition(admitted: Admitted, fact: Fact) -> Grade:
    """Check that the cases of a context by the sign of a name are complete and disjoint.
    Gamma, x = 0        Gamma, x > 0        Gamma, -x > 0 (not where x >= 0 is visible)
    -----------------------------------------------------------------------------------
    Gamma |- exactly one of these contexts, or of those that premises split them into
    """
    whole, (x,), cases = admitted.contexts[fact.context], fact.lhs, fact.certificate["cases"]
    due = whole.cases(x)[: max(len(cases), 2)]
    if len(cases) == 2:
        _check_signs([x], whole)
    for name, case in zip(cases, due, strict=True):
        found = admitted.contexts[name]
        if found != replace(case, name=name, witness=found.witness) or not is_name(x):
            raise KernelError(f"{name} is not this case of {whole.name}")
    finer: dict[str, tuple[str, ...]] = {}
    for premise in (admitted.facts[name] for name in fact.premises):
        if premise.kind != "partition" or premise.context not in {*cases} - finer.keys():
            raise KernelError(f"{premise.id} is not the only partition of a case")
        finer[premise.context] = premise.rhs
    if fact.rhs != tuple(leaf for case in cases for leaf in finer.get(case, (case,))):
        raise KernelError("these are not the cases")
    return Grade.PROVED


def theta(admitted: Admitted, fact: Fact) -> Grade:
    """Check equations that follow from an identity of theta functions.
    a sum of products of theta functions is 0, by its Fourier coefficients, at all z_1, ..., z_r
    --------------------------------------------------------------------------------------------
    Gamma |- lhs = rhs     where each lhs_k - rhs_k is +- a part of it at certain z_1, ..., z_r
    """
    ring, thetas = admitted.rings[fact.context], admitted.contexts[fact.context].thetas
    identity, forms = (fact.certificate[key] for key in ("identity", "forms"))
    parts = [part.numerator for part in Thetas(ring, thetas).at(identity, forms)]
    for gap in differences(ring, fact):
        if all(ring.remainder(x) for part in parts for x in (gap - part, gap + part)):
            raise KernelError("the identity does not give lhs - rhs")
    return Grade.PROVED


def start(admitted: Admitted, fact: Fact) -> Grade:
    """Check equations by their initial values and their time derivatives.
    Gamma |- lhs = rhs at the start        Gamma, lhs = rhs |- D(lhs - rhs) = 0
    ---------------------------------------------------------------------------
    Gamma |- lhs = rhs

    D(f) = A f, with A made of what Gamma may divide by, has no solution but 0 that is 0 anywhere.
    """
    ring = admitted.rings[fact.context]
    begun = [ring.read(text).numerator for text in admitted.contexts[fact.context].start]
    gaps = differences(ring, fact)
    for gap in gaps:
        if not begun or ring.remainder(gap, *begun):
            raise KernelError("this does not hold at the start")
        if ring.remainder(ring.rate(Element(gap)).numerator, *filter(None, gaps)):
            raise KernelError("this is not closed under d/dt")
    return Grade.PROVED


def assumption(admitted: Admitted, fact: Fact) -> Grade:
    """Check that an unproved result has a reference and agrees with ball arithmetic.
    a reference that states it, and points where balls, if there are points, do not exclude it
    ------------------------------------------------------------------------------------------
    Gamma, read as its `reading` says |- statement        (grade ASSUMED, with points ENCLOSED)
    """
    context, reference = admitted.contexts[fact.context], fact.certificate.get("reference")
    if not isinstance(reference, str) or not reference:
        raise KernelError("an assumption needs a reference")
    differences(admitted.rings[fact.context], fact)
    encloses, points = admitted.encloses, fact.certificate.get("points")
    if points and not (encloses and encloses(context, fact, points)):
        raise KernelError("balls have to agree at the points")
    return Grade.ENCLOSED if points else Grade.ASSUMED


# For each rule: the kinds of its statements, its numbers of premises, and its function.
RULES: dict[str, tuple[set[str], Container[int], Callable[[Admitted, Fact], Grade]]] = {
    "identity": ({"equal", "root", "nonnegative"}, {0}, identity),
    "counterexample": ({"unequal"}, {0}, counterexample),
    "model": ({"model"}, range(1000), model),
    "transfer": ({"equal", "root", "nonnegative"}, {2}, transfer),
    "partition": ({"partition"}, range(4), partition),
    "theta": ({"equal"}, {0}, theta),
    "start": ({"equal"}, {0}, start),
    "assumption": ({"equal"}, {0}, assumption),
}


def differences(ring: Ring, fact: Fact) -> list[PolyElement]:
    """Return the numerators of lhs - rhs, or of lhs**2 - rhs for a fact on square roots."""
    sides = zip(map(parse, fact.lhs), map(parse, fact.rhs), strict=True)
    left = [((lhs, "**", 2) if fact.kind == "root" else lhs, rhs) for lhs, rhs in sides]
    return [ring.value((lhs, "-", rhs)).numerator for lhs, rhs in left]


def check_nontrivial(admitted: Admitted, fact: Fact) -> None:
    """Raise KernelError if a fact has equal sides or repeats a definition."""
    same = [(parse(a), parse(b)) for a, b in said(admitted.contexts[fact.context]).items()]
    for sides in zip(fact.lhs, fact.rhs, strict=True):
        lhs, rhs = map(parse, sides)
        if lhs == rhs or (lhs, rhs) in same or (rhs, lhs) in same:
            raise KernelError(f"{sides[0]:.80} and {sides[1]:.80} are the same by {fact.context}")


def said(context: Context) -> dict[str, str]:
    """Return the definitions and known time derivatives of a context as expressions."""
    if context.rates is None:
        return {**context.definitions}
    rates = {**dict.fromkeys(context.generators, "0"), **context.rates}.items()
    return {**context.definitions, **{f"D({name})": text for name, text in rates if text != "?"}}


def _check_signs(texts: Iterable[str], context: Context) -> None:
    """Raise KernelError unless all expressions are visibly nonnegative."""
    waiting, seen = [*map(parse, texts)], {*map(parse, context.nonnegative)}
    while waiting:
        if (tree := waiting.pop()) in seen or isinstance(tree, int):
            continue
        seen.add(tree)
        match tree:  # nonnegative names, combined by +, *, / or even powers
            case str() if tree in context.definitions:
                waiting.append(parse(context.definitions[tree]))
            case (base, "**", int(exponent)):
                waiting += [base] if exponent % 2 else []
            case (*front, "+" | "*" | "/", last):
                waiting += [tuple(front) if len(front) > 1 else front[0], last]
            case _:
                raise KernelError(f"{tree} >= 0 is not visible in {context.name}")
