"""One context of a ledger under construction, where facts go by their own names."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rigidsym.proof.algebra._builder import LedgerBuilder
from rigidsym.proof.algebra._computation import Computation
from rigidsym.proof.algebra._parts import Part, join
from rigidsym.proof.kernel import Fact


@dataclass(frozen=True, slots=True)
class Proofs:
    """Methods of the builder that prove facts in one context.

    `name` is the name of the context.  Sources are numbers of the paper's equations, or texts.
    """

    builder: LedgerBuilder
    name: str

    @classmethod
    def open(
        cls, builder: LedgerBuilder, name: str, *parts: Part, static: bool = False
    ) -> "Proofs":
        """Join parts into a context and add it to the ledger.

        `static` leaves out the time derivative.
        """
        builder.open(join(name, *parts, static=static))
        return cls(builder, name)

    def claim(
        self, fact: Any, equations: Any, *source: int | str, law: str = "", why: str = ""
    ) -> Fact:
        """Prove equations by their normal form; see `LedgerBuilder.claim`."""
        return self.builder.claim(self._id(fact), equations, source, law, why)

    def formulas(self, table: Mapping[Any, Any], *source: int | str) -> None:
        """Prove a formula for each name, as a fact of that name."""
        for name, form in table.items():
            self.claim(name, {name: form}, *source)

    def root(self, name: Any, radicand: Any, *source: int | str, fact: str = "") -> Fact:
        """Prove that a name is the square root of another quantity, as a fact of that name."""
        return self.builder.root(self._id(fact or name), name, radicand, source)

    def sign(self, fact: str, forms: Any, *source: int | str) -> Fact:
        """Prove that quantities are nonnegative by forms that show it."""
        return self.builder.sign(self._id(fact), forms, source)

    def refute(
        self, fact: str, equations: Any, *source: int | str, point: Mapping[str, str] | None = None
    ) -> Fact:
        """Refute equations at a rational point, which is searched from the one given."""
        return self.builder.refute(self._id(fact), equations, point or {}, source)

    def value(self, side: Any) -> Computation:
        """Compute what an expression is: zero, a number or a short expression."""
        return self.builder.value(self.name, side)

    def evaluate(self, fact: str, sides: Iterable[Any], *source: int | str) -> Fact:
        """Prove what expressions are, each by its computed value."""
        return self.builder.evaluate(self._id(fact), sides, source)

    def start(self, fact: str, equations: Any, *source: int | str) -> Fact:
        """Prove equations that hold at the initial instant and that d/dt preserves."""
        return self.builder.start(self._id(fact), equations, source)

    def begin(self, zero: Any, names: str, sides: Any, *source: int | str) -> "Proofs":
        """Prove what expressions are at the start; return that instant, see `LedgerBuilder`."""
        self.builder.begin(self.name, zero, names, sides, *source)
        return Proofs(self.builder, f"{self.name}_start")

    def model(self, other: str, *premises: Any) -> None:
        """Prove that the context is a model of another one, by facts proved in it."""
        self.builder.model(self.name, other, map(self._id, premises))

    def carry(self, other: str, *facts: Any) -> None:
        """Carry facts over from another context, which this one is a model of."""
        self.builder.carry(self.name, [f"{other}.{fact}" for fact in facts])

    def _id(self, fact: Any) -> str:
        return f"{self.name}.{fact}"
