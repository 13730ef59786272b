"""Inference rules, and the check that applies them to a whole ledger.

A rule raises Refused, or returns the grade of the fact for premises of the best grade.
"""

from collections.abc import Callable, Container, Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from flint import fmpq_mpoly

from rigidsym.proof.checker._enclosures import check_drawn_points, check_point
from rigidsym.proof.checker._language import is_name
from rigidsym.proof.checker._records import Claim, Hypotheses, Refused, fill, fits, load
from rigidsym.proof.checker._ring import Quotient, Ring
from rigidsym.proof.checker._specification import Catalogue
from rigidsym.proof.checker._theory import Theory

Left = TypeVar("Left")
Right = TypeVar("Right")


@dataclass(slots=True)
class Accepted:
    """The contexts and facts that the checker has accepted so far.

    A fact may rest on no others.
    """

    theories: dict[str, Theory] = field(default_factory=dict)
    facts: dict[str, Claim] = field(default_factory=dict)

    def open(self, given: Hypotheses) -> None:
        """Check a context and accept it.

        Raises Refused if the context is invalid or its name is taken.
        """
        if given.name in self.theories:
            raise Refused("this name is taken")
        self.theories[given.name] = Theory(given)

    def accept(self, fact: Claim) -> None:
        """Check a fact and accept it.

        Raises Refused unless its rule holds and gives the grade that the fact claims.
        """
        if not all(map(is_name, fact.id.split("."))):
            raise Refused("this id is not made of names")
        if fact.id in self.facts or not {*fact.premises} <= self.facts.keys():
            raise Refused("this id is taken, or a premise is not a fact so far")
        if fact.context not in self.theories or fact.rule not in RULES:
            raise Refused(f"no context {fact.context!a} or no rule {fact.rule!a}")
        kinds, premises, rule = RULES[fact.rule]
        if fact.kind not in kinds or not fact.rhs or len(fact.premises) not in premises:
            raise Refused(f"rule {fact.rule} does not make this of {len(fact.premises)} premises")
        if fact.kind in ("equal", "root", "nonnegative"):
            check_nontrivial(self, fact)
        grades = [rule(self, fact), *(self.facts[premise].grade for premise in fact.premises)]
        if fact.grade != (earned := min(grades, key=WORST_TO_BEST.index)):
            raise Refused(f"claims {fact.grade}, has earned {earned}")
        self.facts[fact.id] = fact


def identity(so_far: Accepted, fact: Claim) -> str:
    """Check an identity by the cofactors in its certificate.

    They have to combine the relations to lhs - rhs times a product of units.
    For a root, lhs**2 replaces lhs, which has to be visibly nonnegative.  For a sign, the right
    sides have to be visibly nonnegative.
    """
    theory = so_far.theories[fact.context]
    for text in {"root": fact.lhs, "nonnegative": fact.rhs}.get(fact.kind, []):
        if not theory.shows_sign(text):
            raise Refused(f"{text} is not seen to be nonnegative")
    ring, gaps = theory.ring, _gaps(so_far, fact)
    rows = fact.certificate.get("cofactors")
    if not isinstance(rows, list) or not all(fits(row, list[str]) for row in rows):
        raise Refused("the certificate holds no table of cofactors")
    for gap, row in _pairs(gaps, rows):
        if not _gives(ring, _combination(ring, row), gap):
            raise Refused("the cofactors do not give the difference of the sides")
    return "PROVED"


def counterexample(so_far: Accepted, fact: Claim) -> str:
    """Check that the sides of an equation differ at a rational point of the context."""
    values: Any = fact.certificate.get("point")
    if not fits(values, dict[str, str]):
        raise Refused("the certificate holds no point")
    theory = so_far.theories[fact.context]
    if theory.given.thetas or theory.given.start:
        raise Refused("not every point is one of the functions that are declared")
    at = theory.point(values)
    if not any(gap.above(*at) for gap in _gaps(so_far, fact)):
        raise Refused("both sides agree at the point")
    return "PROVED"


def model(so_far: Accepted, fact: Claim) -> str:
    """Check that a context satisfies all hypotheses of another one.

    The other one is named in rhs.  Its rates have to hold, too.  Premises may be used.
    """
    if fact.lhs or len(fact.rhs) != 1 or fact.rhs[0] not in so_far.theories:
        raise Refused("a model is of exactly one context")
    here, there = so_far.theories[fact.context], so_far.theories[fact.rhs[0]].given
    declared = so_far.theories[fact.context].given
    if (
        not {*there.start} <= {*declared.start}
        or not there.thetas.items() <= declared.thetas.items()
    ):
        raise Refused("a start, or what is declared a theta function, does not carry over")
    given = [gap.above for equation in _equations(so_far, fact) for gap in _gaps(so_far, equation)]
    if any(here.ring.remainder(zero.above, given) for zero in _zeros(here.ring, there)):
        raise Refused("a relation, definition or rate does not carry over")
    for unit in there.units:
        here.ring.inverse(here.ring.read(unit))
    if not all(map(here.shows_sign, there.nonnegative)):
        raise Refused("a sign does not carry over")
    return "PROVED"


def transfer(so_far: Accepted, fact: Claim) -> str:
    """Check a fact carried over from another context whose hypotheses hold in the fact's own."""
    there, bridge = (so_far.facts[premise] for premise in fact.premises)
    if (bridge.kind, bridge.context, bridge.rhs) != ("model", fact.context, [there.context]):
        raise Refused("the second premise does not make this context a model of the first's")
    if (fact.kind, fact.lhs, fact.rhs) != (there.kind, there.lhs, there.rhs):
        raise Refused("the statement is not that of the first premise")
    return "PROVED"


def partition(so_far: Accepted, fact: Claim) -> str:
    """Check that the cases of a context by the sign of a name are complete and disjoint.

    The cases are x = 0, x > 0 and, unless x >= 0 is visible, x < 0.
    A motion stays in its case: since x = 0 is closed under d/dt, D(x) is a multiple of x, and no
    motion crosses x = 0.  A premise may split a case further.
    """
    whole = so_far.theories[fact.context]
    cases: Any = fact.certificate.get("cases")
    if len(fact.lhs) != 1 or not is_name(x := fact.lhs[0]) or not fits(cases, list[str]):
        raise Refused("a partition is by one name, into a list of cases")
    signs = "0+" if len(cases) == 2 and whole.shows_sign(x) else "0+-"
    for name, sign in _pairs(cases, [*signs]):
        if name not in so_far.theories:
            raise Refused(f"no context {name!r}")
        if not _is_case(so_far.theories[name].given, whole.given, x, sign):
            raise Refused(f"{name} is not the case where the sign of {x} is {sign}")
    if fact.rhs != _leaves(cases, [so_far.facts[premise] for premise in fact.premises]):
        raise Refused("these are not the cases")
    return "PROVED"


def theta(so_far: Accepted, fact: Claim) -> str:
    """Check equations that follow from an identity of theta functions.

    Each lhs - rhs has to be, up to sign, the real or imaginary part of the identity.
    """
    theory = so_far.theories[fact.context]
    identity: Any = fact.certificate.get("identity")
    forms: Any = fact.certificate.get("forms")
    if not isinstance(identity, str) or not fits(forms, dict[str, str]):
        raise Refused("the certificate holds no identity, or no forms")
    values = theory.thetas.values(identity, forms)
    for gap in _gaps(so_far, fact):
        if all(theory.ring.remainder(gap.above + x) for value in values for x in (value, -value)):
            raise Refused("the identity is not that lhs is rhs")
    return "PROVED"


def start(so_far: Accepted, fact: Claim) -> str:
    """Check equations by their initial values and their time derivatives.

    They have to hold at the start, and d/dt has to preserve them.
    The gaps f satisfy f' = A f, whose only solution with a zero is 0.
    """
    theory, gaps = so_far.theories[fact.context], _gaps(so_far, fact)
    above = [gap.above for gap in gaps]
    if not theory.start or any(theory.ring.remainder(gap, theory.start) for gap in above):
        raise Refused("lhs is not rhs at the start")
    slopes = [theory.ring.rate(theory.ring.over_one(gap)).above for gap in above]
    if any(theory.ring.remainder(slope, above) for slope in slopes):
        raise Refused("lhs = rhs is not closed under d/dt")
    return "PROVED"


def assumption(so_far: Accepted, fact: Claim) -> str:
    """Check that an unproved result has a reference and agrees with ball arithmetic."""
    reference, points = fact.certificate.get("reference"), fact.certificate.get("points", [])
    if not isinstance(reference, str) or not reference:
        raise Refused("an assumption needs a reference")
    if not isinstance(points, list) or not all(fits(point, dict[str, str]) for point in points):
        raise Refused("points are a list of names with numbers")
    whole = fact.certificate.get("whole", [])
    if not fits(whole, list[str]):
        raise Refused("whole is no list of names")
    _gaps(so_far, fact)
    for point in points:
        check_point(so_far.theories[fact.context].given, fact, point)
    if points:
        check_drawn_points(so_far.theories[fact.context].given, fact, [*points[0]], whole)
    return "ENCLOSED" if points else "ASSUMED"


# For each rule: the kinds of its statements, its numbers of premises, and its function.
RULES: dict[str, tuple[set[str], Container[int], Callable[[Accepted, Claim], str]]] = {
    "identity": ({"equal", "root", "nonnegative"}, {0}, identity),
    "counterexample": ({"unequal"}, {0}, counterexample),
    "model": ({"model"}, range(1000), model),
    "transfer": ({"equal", "root", "nonnegative"}, {2}, transfer),
    "partition": ({"partition"}, range(4), partition),
    "theta": ({"equal"}, {0}, theta),
    "start": ({"equal"}, {0}, start),
    "assumption": ({"equal"}, {0}, assumption),
}


def check_nontrivial(so_far: Accepted, fact: Claim) -> None:
    """Raise Refused if a fact has equal sides or repeats a definition of its context."""
    for lhs, rhs in _pairs(fact.lhs, fact.rhs):
        if so_far.theories[fact.context].states(lhs, rhs):
            raise Refused(f"{lhs!a:.80} and {rhs!a:.80} are the same by the context")


def _gaps(so_far: Accepted, fact: Claim) -> list[Quotient]:
    """Return the difference lhs - rhs of each component of a fact.

    For a square root it is lhs**2 - rhs.
    """
    read, power = so_far.theories[fact.context].ring.read, 2 if fact.kind == "root" else 1
    return [read(lhs) ** power - read(rhs) for lhs, rhs in _pairs(fact.lhs, fact.rhs)]


def _combination(ring: Ring, row: list[str]) -> fmpq_mpoly:
    """Return the linear combination of a ring's relations with given cofactors.

    Raises Refused for a cofactor with a denominator.
    """
    total = ring.one * 0
    for text, relation in _pairs(row, ring.relations):
        cofactor = ring.read(text)
        if cofactor.below != ring.one:
            raise Refused("a cofactor is not a polynomial")
        total += cofactor.above * relation
    return total


def _gives(ring: Ring, combination: fmpq_mpoly, gap: Quotient) -> bool:
    """Return whether a combination of relations proves that lhs - rhs vanishes.

    It does if it is this difference (`gap`) times a product of units.
    Then the gap vanishes where the combination does.
    """
    if combination == gap.above or not combination or not gap.above:
        return combination == gap.above  # the product is gap.below
    factor, rest = divmod(combination * gap.below, gap.above)
    return not rest and ring.scale(factor) == 1


def _equations(so_far: Accepted, fact: Claim) -> list[Claim]:
    """Return the premises of a model fact, which have to be equations in its context.

    Raises Refused if one is not.
    """
    premises = [so_far.facts[premise] for premise in fact.premises]
    if any((p.kind, p.context) != ("equal", fact.context) for p in premises):
        raise Refused("a premise is not an equation of this context")
    return premises


def _zeros(ring: Ring, there: Hypotheses) -> list[Quotient]:
    """Return the expressions that another context's hypotheses set to zero.

    They follow from its relations, definitions and rates.
    """
    read, name, rate = ring.read, ring.name, ring.rate
    zeros = [name(generator) - name(generator) for generator in there.generators]
    zeros += [*map(read, there.relations)]
    zeros += [name(defined) - read(text) for defined, text in there.definitions.items()]
    if there.rates is not None:
        rates = {**dict.fromkeys(there.generators, "0"), **there.rates}
        zeros += [rate(name(moving)) - read(text) for moving, text in rates.items() if text != "?"]
    return zeros


def _is_case(case: Hypotheses, whole: Hypotheses, x: str, sign: str) -> bool:
    """Return whether a context is the case of another one with a given sign of x.

    It may add only this sign.
    Its name and its witness may differ.
    """
    more = replace(whole, name=case.name, witness=case.witness)
    if sign == "0":
        return case == replace(more, relations=[*whole.relations, x])
    signed = [*whole.nonnegative, x if sign == "+" else f"-{x}"]
    return case == replace(more, units=[*whole.units, x], nonnegative=signed)


def _leaves(cases: list[str], premises: list[Claim]) -> list[str]:
    """Return the cases of a partition, with split cases replaced by their own cases."""
    finer = {premise.context: premise.rhs for premise in premises if premise.kind == "partition"}
    if len(finer) < len(premises) or not finer.keys() <= {*cases}:
        raise Refused("a premise is not a partition of a case, or not the only one")
    return [leaf for case in cases for leaf in finer.get(case, [case])]


def _pairs(left: list[Left], right: list[Right]) -> list[tuple[Left, Right]]:
    if len(left) != len(right):
        raise Refused(f"{len(left)} items where {len(right)} are due")
    return list(zip(left, right, strict=True))


WORST_TO_BEST = ["ASSUMED", "ENCLOSED", "PROVED"]


def check(text: str, specification: str = "") -> int:
    """Check a ledger and return its number of facts.

    Raises Refused if anything is wrong.
    """
    return sum(grades(text, specification).values())


def grades(text: str, specification: str = "") -> dict[str, int]:
    """Check a ledger and count its facts by grade.

    Raises Refused if anything is wrong or missing.
    """
    with _naming("ledger"):
        contexts, claims, published = load(text)
    accepted = Accepted()
    for entry in contexts:
        with _naming("context", entry, "name"):
            accepted.open(fill(Hypotheses, entry))
    for entry in claims:
        with _naming("fact", entry, "id"):
            accepted.accept(fill(Claim, entry))
    given = {name: theory.given for name, theory in accepted.theories.items()}
    with _naming("specification"):
        Catalogue(given, accepted.facts, published).require(specification)
    found = [fact.grade for fact in accepted.facts.values()]
    return {grade: found.count(grade) for grade in reversed(WORST_TO_BEST) if grade in found}


def require(specification: str, ledger: Mapping[str, Any]) -> None:
    """Check that the facts of a ledger, whose proofs are not looked at, state a specification.

    Raises Refused for the first theorem that they do not state.
    """
    with _naming("specification"):
        given = {entry["name"]: fill(Hypotheses, entry) for entry in ledger["contexts"]}
        facts = {entry["id"]: fill(Claim, entry) for entry in ledger["facts"]}
        Catalogue(given, facts, ledger["published"]).require(specification)


@contextmanager
def _naming(kind: str, entry: object = None, key: str = "") -> Generator[None]:
    """Convert any error in a `with` block to a `Refused` that names the ledger entry.

    Its message is one line.
    """
    try:
        yield
    except (ValueError, ArithmeticError, LookupError, RecursionError, MemoryError) as error:
        name = entry.get(key) if isinstance(entry, dict) else ""
        printable = name if str(name).isascii() and str(name).isprintable() else ascii(name)
        culprit = f"{kind} {printable}" if name != "" else kind
        reason = str(error) or type(error).__name__
        raise Refused(" ".join(f"{culprit}: {reason}".split())) from None
