"""The book a derivation writes: short ways to open contexts and state claims in a ledger.

Nothing here is trusted.  Every method ends in `Ledger.add`, where the kernel decides.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from rigidsym.kernel import Context, Element, Fact, Grade, KernelError, Ledger, Ring

Equations = Mapping[str, str] | Iterable[tuple[Any, Any]]


class Book:
    """A ledger being written, with the ring of each context at hand."""

    def __init__(self) -> None:
        self.ledger = Ledger()

    def open(self, context: Context) -> Ring:
        """Admit a context and return its ring; raises KernelError where the kernel refuses it."""
        return self.ledger.open(context)

    def claim(self, fact_id: str, equations: Equations, source: Iterable[str] = ()) -> Fact:
        """Prove equations componentwise.  The context is the part of the id before the dot."""
        return self.ledger.prove(_fact(fact_id, "equal", equations, "identity", source))

    def root(self, fact_id: str, name: str, radicand: str, source: Iterable[str] = ()) -> Fact:
        """Prove name = sqrt(radicand), by its square and the declared sign of the name."""
        return self.ledger.prove(_fact(fact_id, "root", {name: radicand}, "root", source))

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

    def model(self, context: str, source: str) -> Fact:
        """Show that one context is a model of another, so that facts can be carried over."""
        return self.ledger.add(
            Fact(f"{context}.models_{source}", context, "model", (), (source,), "model")
        )

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

    def _conclude(self, fact: Fact, *premises: str) -> Fact:
        grades = [self.ledger.facts[premise].grade for premise in premises]
        grade = min(grades, key=list(Grade).index)
        return self.ledger.add(replace(fact, premises=premises, grade=grade))


def _fact(fact_id: str, kind: str, equations: Equations, rule: str, source: Iterable[str]) -> Fact:
    pairs = list(equations.items()) if isinstance(equations, Mapping) else list(equations)
    lhs, rhs = (tuple(str(side) for side in column) for column in zip(*pairs, strict=True))
    context = fact_id.split(".", maxsplit=1)[0]
    return Fact(fact_id, context, kind, lhs, rhs, rule, source=tuple(source))


def equal(lhs: Iterable[Any], rhs: Iterable[Any]) -> list[tuple[Any, Any]]:
    """Componentwise equations between two vectors or matrices."""
    return list(zip(lhs, rhs, strict=True))


def names(ring: Ring, text: str) -> list[Element]:
    """Several quantities of a ring at once: `c1, K = names(ring, "c1 K")`."""
    return [ring.read(name) for name in text.split()]
