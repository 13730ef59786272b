"""Builder of a ledger, with methods to add contexts and to prove facts.

Nothing here is trusted.  Every method ends in `Ledger.add`, where the kernel decides.
"""

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import reduce
from operator import mul, truediv
from typing import Any, TypeAlias, TypeVar

from sympy import Expr

from rigidsym.proof.algebra import _parts
from rigidsym.proof.algebra._computation import (
    Computation,
    Printed,
    Standing,
    explained,
    restated,
    standing,
)
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.algebra._normal_form import divide, nested
from rigidsym.proof.algebra._rational import cancel
from rigidsym.proof.algebra._witness import witness
from rigidsym.proof.kernel import Context, Element, Fact, Grade, KernelError, Ledger, Ring
from rigidsym.proof.kernel._rules import differences

Result = TypeVar("Result")
# An expression that `text` converts to the kernel's language.
Side: TypeAlias = str | int | Element | Expr | Computation
Equations: TypeAlias = Mapping[Any, Side] | Iterable[tuple[Side, Side]]
# Numbers of the paper's equations, or texts.
Source: TypeAlias = Iterable[int | str]
Point: TypeAlias = Mapping[str, str]
# A published formula: {"fact": id}, or a name that a context defines or reads as a function,
# {"context": name, "definition" or "reading": name, "source": equations of the paper}.
Entry: TypeAlias = Mapping[str, str | list[str]]


class LedgerBuilder:
    """A ledger under construction, with its derivation steps and results of chapters.

    `sealed` is the text of a written ledger, whose counts of mutants are kept for facts that are
    unchanged.  `recounted` is the number of facts whose mutants were counted again.
    """

    def __init__(self, sealed: str = "") -> None:
        self.ledger = Ledger(encloses)
        self.sealed, self.recounted = sealed, 0
        # The steps of the derivation, in order, for readers; no fact rests on them.
        self.steps: list[Any] = []
        # The matrices of contexts as they were given, for readers, too.
        self.matrices: dict[str, Mapping[str, Any]] = {}
        self._results: dict[type, Any] = {}

    def keep(self, result: Any) -> None:
        """Store a chapter's result, so that later chapters can find it by its type."""
        self._results[type(result)] = result

    def __contains__(self, kind: type) -> bool:
        """Return whether a chapter has stored a result of the given type."""
        return kind in self._results

    def result(self, kind: type[Result]) -> Result:
        """Return the result of the given type that an earlier chapter stored."""
        if kind not in self._results:
            raise LookupError(f"no chapter has found {kind.__name__} yet")
        return self._results[kind]

    def open(self, context: Context) -> Ring:
        """Add a context to the ledger and return its ring.

        Its witness is found; the one given has values to prefer.
        Raises KernelError if the kernel refuses the context.
        """
        try:
            point = witness(context, context.ring())
        except KernelError as error:
            raise KernelError(f"context {context.name}: {error}") from None
        return self.ledger.open(replace(context, witness=point))

    def claim(
        self,
        fact_id: str,
        equations: Equations,
        source: Source = (),
        law: str = "",
        why: str = "",
    ) -> Fact:
        """Prove equations by their normal form.

        The part of the id before the dot is the context.  Each component is proved by itself.
        Typed equations are a `law`, or `why` says why they were not computed.
        """
        fact = self._fact(fact_id, "equal", equations, "identity", source)
        return self.decide(explained(fact, law, why))

    def value(self, context: str, expression: Side) -> Computation:
        """Compute what an expression is in a context: zero, a number or a short expression.

        Definitions are put in, D is carried out by the rates of the context, and the numerator and
        the denominator are reduced by its relations.
        """
        found, ring = self.ledger.contexts[context], self.ledger.rings[context]
        element = ring.read(text(expression, (*found.generators, *found.definitions)))
        below = reduce(mul, element.below.elements(), ring.poly(1))
        sides = (divide(ring, side)[1].as_expr() for side in (element.numerator, below))
        return Computation(cancel(truediv(*sides)), ("value",))

    def evaluate(self, fact_id: str, sides: Iterable[Side], source: Source = ()) -> Fact:
        """Prove what expressions are, each by its computed value."""
        context = fact_id.split(".", maxsplit=1)[0]
        return self.claim(fact_id, [(side, self.value(context, side)) for side in sides], source)

    def compare(
        self,
        fact_id: str,
        equations: Equations,
        points: Iterable[Point] = (),
        source: Source = (),
    ) -> Fact | None:
        """Prove equations that the paper prints, or refute them at a rational point.

        The points tried are the given ones, the witness of the context, points that differ from it
        in one name, and one that a search finds.  Return None if the normal form is not zero, but
        the sides agree at all these points.
        """
        fact = self._fact(fact_id, "equal", equations, "identity", source)
        sides = {side: tuple(map(Printed, getattr(fact, side))) for side in ("lhs", "rhs")}
        fact = replace(fact, **sides)
        try:
            return self.decide(fact)
        except KernelError as error:
            if "undecided" not in str(error):
                raise
        refuted = replace(fact, kind="unequal", rule="counterexample")
        names = self.ledger.contexts[fact.context].witness
        near = ({name: value} for value in ("2", "1/2", "-1", "3") for name in names)
        for point in (*points, {}, *near):
            with suppress(KernelError):
                return self._refute(refuted, point)
        return self._counterexample(refuted, {})

    def root(self, fact_id: str, name: Any, radicand: Side, source: Source = ()) -> Fact:
        """Prove that a quantity is the square root of another.

        The proof uses the square of `name` and its sign.
        """
        return self.decide(self._fact(fact_id, "root", {name: radicand}, "identity", source))

    def sign(self, fact_id: str, forms: Equations, source: Source = ()) -> Fact:
        """Prove that quantities are nonnegative by rewriting them in a visibly nonnegative form."""
        return self.decide(self._fact(fact_id, "nonnegative", forms, "identity", source))

    def refute(
        self,
        fact_id: str,
        equations: Equations,
        point: Point,
        source: Source = (),
    ) -> Fact:
        """Refute equations at a rational point.

        `point` overrides values of the context's witness.  If the sides agree there, the search
        goes on for a point where they do not.
        """
        fact = self._fact(fact_id, "unequal", equations, "counterexample", source)
        try:
            return self._refute(fact, point)
        except KernelError:
            if (found := self._counterexample(fact, point)) is None:
                raise
            return found

    def _refute(self, fact: Fact, point: Point) -> Fact:
        whole = {**self.ledger.contexts[fact.context].witness, **point}
        return self.ledger.add(replace(fact, certificate={"point": whole}))

    def _counterexample(self, fact: Fact, point: Point) -> Fact | None:
        """Refute equations at a point that a search finds, if it finds one."""
        context, ring = self.ledger.contexts[fact.context], self.ledger.rings[fact.context]
        near = replace(context, witness={**context.witness, **point})
        for difference in differences(ring, fact):
            with suppress(KernelError):
                return self._refute(fact, witness(near, ring, difference))
        return None

    def theta(
        self,
        fact_id: str,
        equations: Equations,
        identity: str,
        forms: Mapping[str, str],
        source: Source = (),
    ) -> Fact:
        """Prove equations by substituting linear forms into a theta-function identity."""
        fact = self._fact(fact_id, "equal", equations, "theta", source)
        certificate = {"identity": identity, "forms": dict(forms)}
        return self.ledger.add(replace(fact, certificate=certificate))

    def start(self, fact_id: str, equations: Equations, source: Source = ()) -> Fact:
        """Prove equations from their initial values and their time derivatives.

        They hold at the initial instant, and d/dt preserves them.
        """
        return self.ledger.add(self._fact(fact_id, "equal", equations, "start", source))

    def begin(
        self,
        context: str,
        zero: Iterable[Side],
        names: str,
        sides: Iterable[Side],
        *source: int | str,
    ) -> None:
        """Prove what expressions are at the instant at which a motion starts, where more is zero.

        The instant is a context of its own, where the formulas for the names are proved again.
        """
        whole = self.ledger.contexts[context]
        instant = f"{context}_start"
        known = (*whole.generators, *whole.definitions)
        relations = (*whole.relations, *(text(x, known) for x in zero))
        self.open(replace(whole, name=instant, relations=relations, rates=None))
        for name in names.split():
            fact = self.ledger.facts[f"{context}.{name}"]
            place = {"id": f"{instant}.{name}", "context": instant}
            self.decide(replace(fact, **place, rule="identity", premises=()))
        self.evaluate(f"{instant}.start", sides, source)

    def model(self, context: str, source: str, premises: Iterable[str] = ()) -> Fact:
        """Prove that a context satisfies all hypotheses of another one.

        It is then called a model of the other one.
        The premises are facts that the proof may use.
        """
        name = f"{context}.models_{source}"
        return self._conclude(Fact(name, context, "model", (), (source,), "model"), *premises)

    def assume(
        self,
        fact_id: str,
        equations: Equations,
        reference: str,
        points: Iterable[Point],
        whole: Iterable[str] = (),
    ) -> Fact:
        """Add an unproved result with a reference to the literature.

        Its grade is ENCLOSED if ball arithmetic confirms it at the given points.  Without points,
        it is ASSUMED.

        It is also evaluated at points drawn by a hash, where the names in `whole` are integers.
        """
        fact = self._fact(fact_id, "equal", equations, "assumption", [reference])
        certificate: dict[str, Any] = {"reference": reference, "points": list(points)}
        if names := list(whole):
            certificate["whole"] = names
        grade = Grade.ENCLOSED if certificate["points"] else Grade.ASSUMED
        return self.ledger.add(replace(fact, certificate=certificate, grade=grade))

    def split(self, context: str, name: str, *cases: str) -> None:
        """Split a context into cases by the sign of a named quantity.

        The cases are name = 0, name > 0 and, if given, name < 0.
        """
        whole = self.ledger.contexts[context]
        for case, part in zip(cases, whole.cases(name)[: len(cases)], strict=True):
            self.open(replace(part, name=case))

    def partition(self, context: str, name: str, *cases: str) -> Fact:
        """Prove that each point of a context lies in exactly one of its cases.

        A case that has a partition of its own is replaced by its cases.
        """
        found = (fact for fact in self.ledger.facts.values() if fact.kind == "partition")
        finer = {fact.context: fact for fact in found if fact.context in cases}
        leaves = [finer[case].rhs if case in finer else (case,) for case in cases]
        fact = Fact(f"{context}.cases", context, "partition", (name,), sum(leaves, ()), "partition")
        whole = replace(fact, certificate={"cases": list(cases)})
        return self._conclude(whole, *(premise.id for premise in finer.values()))

    def carry(self, context: str, fact_ids: Iterable[str]) -> None:
        """Carry facts over to another context that satisfies their hypotheses.

        This has to be proved before, by `model`.
        """
        for fact_id in fact_ids:
            there = self.ledger.facts[fact_id]
            name = f"{context}.{fact_id.split('.')[1]}"
            here = replace(there, id=name, context=context, rule="transfer", certificate={})
            self._conclude(here, fact_id, f"{context}.models_{there.context}")

    def publish(self, sequence: str, entries: Iterable[Entry], group: str = "sequences") -> None:
        """Publish a named sequence of formulas for numerical use.

        The formulas are in order of evaluation.
        Each entry is a proved fact, or a name's definition or reading in a context.
        """
        listed = list(entries)
        for entry in listed:
            if not self._is_known(entry):
                raise KernelError(
                    f"{sequence}: {entry} is no proved fact, definition or reading of a name"
                )
        self.ledger.published.setdefault(group, {})[sequence] = listed

    def _is_known(self, entry: Entry) -> bool:
        """Return whether the ledger contains the formula that an entry publishes.

        That is a proved formula, or the definition or reading of a name.
        """
        if "fact" in entry:
            fact = self.ledger.facts.get(str(entry["fact"]))
            kinds = ("equal", "root")
            return fact is not None and fact.grade == Grade.PROVED and fact.kind in kinds
        context = self.ledger.contexts.get(str(entry["context"]))
        if context is None:
            return False
        if "definition" in entry:
            return entry["definition"] in context.definitions
        return entry["reading"] in context.reading

    def decide(self, fact: Fact) -> Fact:
        """Prove an identity by polynomial division and add it to the ledger.

        The cofactors of the division are its certificate.
        Raises KernelError if the normal form is not zero.
        """
        ring = self.ledger.rings[fact.context]
        gaps = [*differences(ring, fact)]
        divided = [divide(ring, gap) for gap in gaps]
        if any(remainder for _, remainder in divided):
            raise KernelError(f"fact {fact.id}: undecided: the normal form of lhs - rhs is not 0")
        cofactors = [[*map(nested, quotients)] for quotients, _ in divided]
        if standing(fact) == Standing.GUESSED:
            said = {relation.monic() for relation in ring.relations}
            fact = restated(fact, (bool(gap) and gap.monic() in said for gap in gaps))
        return self.ledger.add(replace(fact, certificate={"cofactors": cofactors}))

    def _fact(
        self, fact_id: str, kind: str, equations: Equations, rule: str, source: Source
    ) -> Fact:
        pairs = list(equations.items()) if isinstance(equations, Mapping) else list(equations)
        context = fact_id.split(".", maxsplit=1)[0]
        found = self.ledger.contexts.get(context)
        names = () if found is None else (*found.generators, *found.definitions)
        lhs, rhs = (tuple(text(x, names) for x in column) for column in zip(*pairs, strict=True))
        return Fact(fact_id, context, kind, lhs, rhs, rule, source=tuple(map(str, source)))

    def _conclude(self, fact: Fact, *premises: str) -> Fact:
        grades = [self.ledger.facts[premise].grade for premise in premises]
        grade = min([fact.grade, *grades], key=[*Grade].index)
        return self.ledger.add(replace(fact, premises=premises, grade=grade))


def facts(context: str, names: str) -> list[Entry]:
    """Return the entries that publish facts of a context for numerical use.

    For example: `facts("regular", "H E_a")`.
    """
    return [{"fact": f"{context}.{name}"} for name in names.split()]


def definitions(context: str, names: str, *source: int | str) -> list[Entry]:
    """Return the entries that publish definitions of a context for numerical use.

    `source` are the equations of the paper that use them.
    """
    return _said("definition", context, names, source)


def readings(context: str, names: str, *source: int | str) -> list[Entry]:
    """Return the entries that publish which standard functions a context's names denote.

    `source` are the equations of the paper that use them.
    """
    return _said("reading", context, names, source)


def _said(how: str, context: str, names: str, source: Source) -> list[Entry]:
    cited = [*map(str, source)]
    return [{"context": context, how: name, "source": [*cited]} for name in names.split()]


def text(side: Side, names: Iterable[str] = ()) -> str:
    """Convert a number, an expression or a ring element to text that the kernel can parse.

    The names of an expression are printed in the given order.
    """
    if not isinstance(side, Element):
        return _parts.text(side, names)
    below = "*".join(f"({unit})**{power}" for unit, power in side.below.items())
    return f"({side.numerator})/({below})" if below and side.numerator else str(side.numerator)


def equal(lhs: Iterable[Side], rhs: Iterable[Side]) -> list[tuple[Side, Side]]:
    """Return the equations between corresponding entries of two vectors or matrices.

    Trivial equations are left out.
    """
    return [(x, y) for x, y in zip(lhs, rhs, strict=True) if str(x) != str(y)]
