"""The book a derivation writes: short ways to open contexts and state claims in a ledger.

Nothing here is trusted.  Every method ends in `Ledger.add`, where the kernel decides.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from rigidsym.algebra.enclosures import encloses
from rigidsym.algebra.normal_form import divide
from rigidsym.kernel import Context, Element, Fact, Grade, KernelError, Ledger, Ring
from rigidsym.kernel.rules import differences

Equations = Mapping[str, str] | Iterable[tuple[Any, Any]]
# A context's name, and what its witness has that its parent's has not.
Case = tuple[str, Mapping[str, str]]


class Book:
    """A ledger being written, with the ring of each context at hand."""

    def __init__(self) -> None:
        self.ledger = Ledger(encloses)

    def open(self, context: Context) -> Ring:
        """Admit a context and return its ring; raises KernelError where the kernel refuses it."""
        return self.ledger.open(context)

    def claim(self, fact_id: str, equations: Equations, source: Iterable[str] = ()) -> Fact:
        """Prove equations componentwise.  The context is the part of the id before the dot."""
        return self._decide(_fact(fact_id, "equal", equations, "identity", source))

    def root(self, fact_id: str, name: str, radicand: str, source: Iterable[str] = ()) -> Fact:
        """Prove name = sqrt(radicand), by its square and the sign of the name."""
        return self._decide(_fact(fact_id, "root", {name: radicand}, "identity", source))

    def sign(self, fact_id: str, forms: Equations, source: Iterable[str] = ()) -> Fact:
        """Prove that quantities are nonnegative, by forms of theirs that show it."""
        return self._decide(_fact(fact_id, "nonnegative", forms, "identity", source))

    def refute(
        self,
        fact_id: str,
        equations: Equations,
        point: Mapping[str, str],
        source: Iterable[str] = (),
    ) -> Fact:
        """Show that equations do not always hold; `point` overrides the context's witness."""
        fact = _fact(fact_id, "unequal", equations, "counterexample", source)
        witness = self.ledger.contexts[fact.context].witness
        return self.ledger.add(replace(fact, certificate={"point": {**witness, **point}}))

    def model(self, context: str, source: str, premises: Iterable[str] = ()) -> Fact:
        """Show that one context is, by the premises, a model of another."""
        name = f"{context}.models_{source}"
        return self._conclude(Fact(name, context, "model", (), (source,), "model"), *premises)

    def suppose(self, fact_id: str, equations: Equations, reference: str, points: Any) -> Fact:
        """State somebody else's result, graded ENCLOSED where balls agree with it at the points."""
        fact = _fact(fact_id, "equal", equations, "assumption", [reference])
        certificate = {"reference": reference, "points": list(points)}
        grade = Grade.ENCLOSED if certificate["points"] else Grade.ASSUMED
        return self.ledger.add(replace(fact, certificate=certificate, grade=grade))

    def split(self, context: str, name: str, *cases: Case) -> None:
        """Open the cases name = 0, > 0 and, if given, < 0 of a context, with their witnesses."""
        whole = self.ledger.contexts[context]
        for (case, witness), sign in zip(cases, ("", name, f"-{name}"), strict=len(cases) != 2):
            more = {"units": (*whole.units, name), "nonnegative": (*whole.nonnegative, sign)}
            more = more if sign else {"relations": (*whole.relations, name)}
            self.open(replace(whole, name=case, witness={**whole.witness, **witness}, **more))

    def partition(self, context: str, name: str, *cases: str) -> Fact:
        """Every point of a context is in exactly one case of `split`, or of its own cases."""
        found = (fact for fact in self.ledger.facts.values() if fact.kind == "partition")
        finer = {fact.context: fact for fact in found if fact.context in cases}
        leaves = [finer[case].rhs if case in finer else (case,) for case in cases]
        fact = Fact(f"{context}.cases", context, "partition", (name,), sum(leaves, ()), "partition")
        whole = replace(fact, certificate={"cases": list(cases)})
        return self._conclude(whole, *(premise.id for premise in finer.values()))

    def carry(self, context: str, fact_ids: Iterable[str]) -> None:
        """Restate facts in a context that is known to be a model of theirs."""
        for fact_id in fact_ids:
            there = self.ledger.facts[fact_id]
            name = f"{context}.{fact_id.split('.')[1]}"
            here = replace(there, id=name, context=context, rule="transfer", certificate={})
            self._conclude(here, fact_id, f"{context}.models_{there.context}")

    def publish(self, programme: str, entries: Iterable[str]) -> None:
        """Offer proved facts, and readings as `context:name:equation`, to the number wing."""
        ledger, listed = self.ledger, list(entries)
        for entry in listed:
            context, name, *_ = [*entry.split(":"), ""]
            fact = ledger.facts.get(entry)
            proved = fact and fact.grade == Grade.PROVED and fact.kind in ("equal", "root")
            if not proved and name not in getattr(ledger.contexts.get(context), "reading", ()):
                raise KernelError(f"{programme}: {entry} is neither a proved fact nor a reading")
        ledger.published[programme] = listed

    def _decide(self, fact: Fact) -> Fact:
        """Admit an identity with the cofactors of its normal form; KernelError if it is none."""
        ring = self.ledger.rings[fact.context]
        divided = [divide(ring, difference) for difference in differences(ring, fact)]
        if any(remainder for _, remainder in divided):
            raise KernelError(f"fact {fact.id}: undecided: the normal form of lhs - rhs is not 0")
        cofactors = [[str(quotient) for quotient in quotients] for quotients, _ in divided]
        return self.ledger.add(replace(fact, certificate={"cofactors": cofactors}))

    def _conclude(self, fact: Fact, *premises: str) -> Fact:
        grades = [fact.grade, *(self.ledger.facts[premise].grade for premise in premises)]
        grade = min(grades, key=list(Grade).index)
        return self.ledger.add(replace(fact, premises=premises, grade=grade))


def _fact(fact_id: str, kind: str, equations: Equations, rule: str, source: Iterable[str]) -> Fact:
    pairs = list(equations.items()) if isinstance(equations, Mapping) else list(equations)
    lhs, rhs = (tuple(map(text, column)) for column in zip(*pairs, strict=True))
    context = fact_id.split(".", maxsplit=1)[0]
    return Fact(fact_id, context, kind, lhs, rhs, rule, source=tuple(source))


def text(side: Any) -> str:
    """What the kernel reads back as this: a text itself, a number, or an element of a ring."""
    if not isinstance(side, Element):
        return str(side)
    factors = zip(side.ring.units, side.powers, strict=True)
    below = "*".join(f"({unit})**{power}" for unit, power in factors if power)
    return f"({side.numerator})/({below})" if below and side.numerator else str(side.numerator)


def equal(lhs: Iterable[Any], rhs: Iterable[Any]) -> list[tuple[Any, Any]]:
    """Componentwise equations between two vectors or matrices."""
    return list(zip(lhs, rhs, strict=True))


def names(ring: Ring, text: str) -> list[Element]:
    """Several quantities of a ring at once: `c1, K = names(ring, "c1 K")`."""
    return [ring.read(name) for name in text.split()]
