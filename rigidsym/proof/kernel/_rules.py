"""The ledger, and the inference rules that admit facts to it.

A rule checks one fact by its premises and its certificate, and raises if they do not prove it.
Nothing that a fact claims is trusted.  Facts enter by `Ledger.add` alone, and `replay` passes every
fact of a written ledger through it again.
"""

import json
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from enum import StrEnum
from typing import Any

from sympy.polys.rings import PolyElement

from rigidsym.proof.kernel._context import Context
from rigidsym.proof.kernel._language import KernelError, is_name, parse
from rigidsym.proof.kernel._ring import Element, Ring, at
from rigidsym.proof.kernel._theta import Thetas

SCHEMA = "rigidsym.ledger/4"
_LISTS = {"generators", "units", "relations", "nonnegative", "start"}
_LISTS |= {"lhs", "rhs", "premises", "source"}


class Grade(StrEnum):
    """Grade of a fact: assumed, confirmed by ball arithmetic, or proved."""

    ASSUMED = "ASSUMED"  # from worst to best
    ENCLOSED = "ENCLOSED"
    PROVED = "PROVED"


@dataclass(frozen=True, slots=True)
class Fact:
    """A statement in a context, trusted only after `Ledger.add` has admitted it.

    By `kind` and componentwise it states: "equal", lhs = rhs; "root", lhs = +sqrt(rhs);
    "nonnegative", lhs = rhs >= 0; "unequal", both sides differ at some point; "model", the context
    is a model of that in rhs; "partition", each of its points is in exactly one of those in rhs.
    """

    id: str
    context: str
    kind: str
    lhs: tuple[str, ...]
    rhs: tuple[str, ...]
    rule: str
    grade: Grade = Grade.PROVED
    premises: tuple[str, ...] = ()
    source: tuple[str, ...] = ()
    certificate: Mapping[str, Any] = field(default_factory=dict)


# Whether balls agree with a fact of a context at points; it is trusted with grade ENCLOSED.
Encloses = Callable[[Context, Fact, Sequence[Mapping[str, str]]], bool]


@dataclass(slots=True)
class Ledger:
    """The contexts and facts that the kernel has admitted, in order."""

    encloses: Encloses | None = None
    contexts: dict[str, Context] = field(default_factory=dict)
    facts: dict[str, Fact] = field(default_factory=dict)
    rings: dict[str, Ring] = field(default_factory=dict)
    published: dict[str, Any] = field(default_factory=dict)  # an index that proves nothing

    def open(self, context: Context) -> Ring:
        """Check a context and add it to the ledger, or raise KernelError."""
        if not is_name(context.name) or context.name in self.contexts:
            raise KernelError(f"context {context.name!a:.80}: this is no name, or there already")
        try:
            self.rings[context.name] = context.open()
        except Exception as error:
            raise KernelError(f"context {context.name}: {error}") from None
        self.contexts[context.name] = context
        return self.rings[context.name]

    def add(self, fact: Fact) -> Fact:
        """Check a fact and add it to the ledger, or raise KernelError."""
        if not all(map(is_name, fact.id.split("."))) or fact.id in self.facts:
            raise KernelError(f"fact {fact.id!a:.80}: this is no name, or there already")
        try:
            self._check(fact)
        except Exception as error:
            raise KernelError(f"fact {fact.id}: {error}") from None
        self.facts[fact.id] = fact
        return fact

    def _check(self, fact: Fact) -> None:
        if fact.rule not in RULES or fact.context not in self.contexts:
            raise KernelError(f"no rule {fact.rule!a}, or no context {fact.context!a}")
        if missing := {*fact.premises} - self.facts.keys():
            raise KernelError(f"no premises {sorted(missing)!a}")
        kinds, premises, rule = RULES[fact.rule]
        if fact.kind not in kinds or not fact.rhs or len(fact.premises) not in premises:
            raise KernelError(f"rule {fact.rule} does not state this from so many premises")
        context = self.contexts[fact.context]
        if fact.kind in ("equal", "root", "nonnegative"):
            check_nontrivial(context, fact)
        supports = [self.facts[premise].grade for premise in fact.premises]
        supports.append(rule(self, fact, context, self.rings[fact.context]) or Grade.PROVED)
        if fact.grade != (earned := min(supports, key=[*Grade].index)):
            raise KernelError(f"claims {fact.grade}, has earned {earned}")

    def to_text(self) -> str:
        """Return the ledger as JSON text, identical on every machine."""
        contexts, facts = [*self.contexts.values()], [*self.facts.values()]
        data = {"schema": SCHEMA, "contexts": contexts, "facts": facts, "published": self.published}

        def table(record: Context | Fact) -> dict[str, Any]:
            return {each.name: getattr(record, each.name) for each in fields(record)}

        return json.dumps(data, indent=1, ensure_ascii=False, default=table) + "\n"


def replay(text: str, encloses: Encloses | None = None) -> Ledger:
    """Check a written ledger, or raise KernelError at its first invalid entry."""
    ledger = Ledger(encloses)
    try:
        data = json.loads(text)
        if data["schema"] != SCHEMA:
            raise KernelError(f"schema: {data['schema']!a}: this kernel reads {SCHEMA!r}")
        for entry in data["contexts"]:
            ledger.open(Context(**_frozen(entry)))
        for entry in data["facts"]:
            ledger.add(Fact(**_frozen({**entry, "grade": Grade(entry["grade"])})))
        ledger.published = dict(data["published"])
        if ledger.to_text() == text:
            return ledger
    except KernelError:
        raise
    except Exception:  # of another shape
        pass
    raise KernelError(f"not a ledger as this kernel writes it, by the schema {SCHEMA}")


def _frozen(fields: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(x) if key in _LISTS else x for key, x in fields.items()}


def identity(_: Ledger, fact: Fact, context: Context, ring: Ring) -> None:
    """Check an identity by its cofactors.
    numerator(lhs_k - rhs_k) = sum_j cofactor_kj * relation_j     for every component k
    -----------------------------------------------------------------------------------
    Gamma |- lhs = rhs

    If lhs >= 0 is visible, and with lhs**2 for lhs:    Gamma |- lhs = sqrt(rhs)
    If rhs >= 0 is visible:                             Gamma |- lhs = rhs >= 0
    """
    context.check_signs({"root": fact.lhs, "nonnegative": fact.rhs}.get(fact.kind, ()))
    for difference, row in zip(differences(ring, fact), fact.certificate["cofactors"], strict=True):
        for cofactor, relation in zip(map(ring.read, row), ring.relations, strict=True):
            if cofactor.below:
                raise KernelError("a cofactor is no polynomial")
            difference -= (cofactor * Element(relation)).numerator
        if difference:
            raise KernelError("the cofactors do not give lhs - rhs")


def counterexample(_: Ledger, fact: Fact, context: Context, ring: Ring) -> None:
    """Check that the sides of an equation differ at a rational point.
    a rational point of Gamma at which lhs differs from rhs
    -------------------------------------------------------
    Gamma |- lhs != rhs at some point
    """
    if context.thetas or context.start:
        raise KernelError("what is declared of functions may exclude the point")
    point = context.check_point(ring, fact.certificate["point"])
    if not any(at(difference, point) for difference in differences(ring, fact)):
        raise KernelError("both sides agree at this point")


def model(ledger: Ledger, fact: Fact, delta: Context, ring: Ring) -> None:
    """Check that a context satisfies all hypotheses of another one.
    every name of Gamma is a name of Delta, where, by the premises, the relations of Gamma vanish,
    its units are units, its signs are visible, its definitions hold and D reads the same
    ----------------------------------------------------------------------------------------------
    Delta |- model of Gamma
    """
    (gamma,) = (ledger.contexts[name] for name in fact.lhs + fact.rhs)
    premises = [ledger.facts[name] for name in fact.premises]
    if any((x.kind, x.context) != ("equal", fact.context) for x in premises):
        raise KernelError(f"a premise is not an equation of {fact.context}")
    given = [gap for premise in premises for gap in differences(ring, premise) if gap]
    for generator in gamma.generators:
        ring.read(generator)
    if not gamma.thetas.items() <= delta.thetas.items() or not {*gamma.start} <= {*delta.start}:
        raise KernelError(f"what {gamma.name} declares of functions is not declared here")
    zeros = {f"{name} - ({text})" for name, text in gamma.said().items() - delta.said().items()}
    for zero in sorted({*zeros, *gamma.relations} - {*delta.relations}):
        if ring.remainder(ring.read(zero).numerator, *given):
            raise KernelError(f"{zero} = 0 of {gamma.name} does not hold")
    for unit in gamma.units:
        ring.inverse(ring.read(unit))
    delta.check_signs(gamma.nonnegative)


def transfer(ledger: Ledger, fact: Fact, *_: object) -> None:
    """Check a fact carried over from another context whose hypotheses hold in the fact's own.
    Gamma |- statement        Delta |- model of Gamma
    -------------------------------------------------
    Delta |- statement
    """
    there, bridge = (ledger.facts[premise] for premise in fact.premises)
    if (bridge.kind, bridge.context, bridge.rhs) != ("model", fact.context, (there.context,)):
        raise KernelError(f"{bridge.id} does not make this context a model of {there.context}")
    if (fact.kind, fact.lhs, fact.rhs) != (there.kind, there.lhs, there.rhs):
        raise KernelError(f"this is not the statement of {there.id}")


def partition(ledger: Ledger, fact: Fact, whole: Context, _: Ring) -> None:
    """Check that the cases of a context by the sign of a name are complete and disjoint.
    Gamma, x = 0        Gamma, x > 0        Gamma, -x > 0 (not where x >= 0 is visible)
    -----------------------------------------------------------------------------------
    Gamma |- exactly one of these contexts, or of those that premises split them into
    """
    (x,), cases = fact.lhs, fact.certificate["cases"]
    if len(cases) == 2:
        whole.check_signs([x])
    for name, case in zip(cases, whole.cases(x)[: max(len(cases), 2)], strict=True):
        found = ledger.contexts[name]
        if found != replace(case, name=name, witness=found.witness) or not is_name(x):
            raise KernelError(f"{name} is not this case of {whole.name}")
    premises = [ledger.facts[name] for name in fact.premises]
    finer = {x.context: x.rhs for x in premises if x.kind == "partition"}
    if len(finer) < len(premises) or not finer.keys() <= {*cases}:
        raise KernelError("a premise is not the only partition of a case")
    if fact.rhs != tuple(leaf for case in cases for leaf in finer.get(case, (case,))):
        raise KernelError("these are not the cases")


def theta(_: Ledger, fact: Fact, context: Context, __: Ring) -> None:
    """Check equations that follow from an identity of theta functions.
    a sum of products of theta functions is 0, by its Fourier coefficients, at all z_1, ..., z_r
    --------------------------------------------------------------------------------------------
    Gamma |- lhs = rhs     where each lhs_k - rhs_k is +- a part of it at certain z_1, ..., z_r
    """
    thetas, certificate = Thetas(context.ring("I"), context.thetas), fact.certificate
    parts, ring = thetas.at(certificate["identity"], certificate["forms"]), thetas.ring
    for gap in differences(ring, fact):
        if all(ring.remainder(x) for part in parts for x in (gap - part, gap + part)):
            raise KernelError("the identity does not give lhs - rhs")


def start(_: Ledger, fact: Fact, context: Context, ring: Ring) -> None:
    """Check equations by their initial values and their time derivatives.
    Gamma |- lhs = rhs at the start        Gamma, lhs = rhs |- D(lhs - rhs) = 0
    ---------------------------------------------------------------------------
    Gamma |- lhs = rhs

    D(f) = A f, with A made of what Gamma may divide by, has no solution but 0 that is 0 anywhere.
    """
    begun, gaps = [ring.read(text).numerator for text in context.start], differences(ring, fact)
    for gap in gaps:
        if not begun or ring.remainder(gap, *begun):
            raise KernelError("this does not hold at the start")
        if ring.remainder(ring.rate(Element(gap)).numerator, *filter(None, gaps)):
            raise KernelError("this is not closed under d/dt")


def assumption(ledger: Ledger, fact: Fact, context: Context, ring: Ring) -> Grade:
    """Check that an unproved result has a reference and agrees with ball arithmetic.
    a reference that states it, and points where balls, if there are points, do not exclude it
    ------------------------------------------------------------------------------------------
    Gamma, read as its `reading` says |- statement        (grade ASSUMED, with points ENCLOSED)
    """
    reference, points = fact.certificate.get("reference"), fact.certificate.get("points")
    if not isinstance(reference, str) or not reference:
        raise KernelError("an assumption needs a reference")
    differences(ring, fact)
    if points and not (ledger.encloses and ledger.encloses(context, fact, points)):
        raise KernelError("balls have to agree at the points")
    return Grade.ENCLOSED if points else Grade.ASSUMED


# For each rule: the kinds of its statements, its numbers of premises, and its function.
RULES: dict[str, tuple[set[str], Container[int], Callable[..., Grade | None]]] = {
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


def check_nontrivial(context: Context, fact: Fact) -> None:
    """Raise KernelError if a fact has equal sides or repeats a definition."""
    said = {parse(name): text for name, text in context.said().items()}
    for sides in zip(fact.lhs, fact.rhs, strict=True):
        lhs, rhs = map(parse, sides)
        meant = [parse(said[x]) for x in (lhs, rhs) if x in said]
        if lhs == rhs or lhs in meant or rhs in meant:
            raise KernelError(f"{sides[0]:.80} and {sides[1]:.80} are the same by {fact.context}")
