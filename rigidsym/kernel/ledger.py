"""The ledger: contexts and facts in the order they were admitted, as deterministic JSON.

`Ledger.add` is the only gate: `replay` passes all that is in a written ledger through it again.
"""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import Any

from rigidsym.kernel.ring import KernelError, Ring
from rigidsym.kernel.rules import RULES
from rigidsym.kernel.statement import Context, Fact, Grade

SCHEMA = "rigidsym.ledger/1"
_LISTS = {"generators", "units", "relations", "nonnegative", "lhs", "rhs", "premises", "source"}


@dataclass(slots=True)
class Ledger:
    """Everything admitted so far; `published` is an index for readers, and proves nothing."""

    encloses: Callable[[Context, Fact, Any], bool] | None = None  # is trusted with grade ENCLOSED
    contexts: dict[str, Context] = field(default_factory=dict)
    facts: dict[str, Fact] = field(default_factory=dict)
    published: dict[str, list[str]] = field(default_factory=dict)
    rings: dict[str, Ring] = field(default_factory=dict)

    def open(self, context: Context) -> Ring:
        """Admit a context; raises KernelError where it is not closed, inhabited or new."""
        if context.name in self.contexts:
            raise KernelError(f"context {context.name} is already there")
        self.rings[context.name], self.contexts[context.name] = context.open(), context
        return self.rings[context.name]

    def add(self, fact: Fact) -> Fact:
        """Admit a fact if its rule accepts it with the grade it claims; KernelError otherwise."""
        unknown = {*fact.premises, fact.context, fact.rule} - {*self.facts, *self.rings, *RULES}
        if unknown or fact.id in self.facts:
            raise KernelError(f"fact {fact.id} is there already, or rests on {sorted(unknown)}")
        try:
            kinds, rule = RULES[fact.rule]
            if fact.kind not in kinds.split() or not fact.rhs:
                raise KernelError(f"rule {fact.rule} states {kinds!r}, of something")
            grades = [rule(self, fact), *(self.facts[premise].grade for premise in fact.premises)]
        except Exception as error:
            raise KernelError(f"fact {fact.id}: {error}") from None
        if fact.grade != (earned := min(grades, key=list(Grade).index)):
            raise KernelError(f"fact {fact.id}: claims {fact.grade}, has earned {earned}")
        self.facts[fact.id] = fact
        return fact

    def to_text(self) -> str:
        """The ledger as JSON text, the same on every machine."""
        contexts, facts = (list(map(asdict, x.values())) for x in (self.contexts, self.facts))
        data = {"schema": SCHEMA, "contexts": contexts, "facts": facts, "published": self.published}
        return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def replay(text: str, encloses: Callable[[Context, Fact, Any], bool] | None = None) -> Ledger:
    """Check a written ledger from nothing; raises KernelError at the first thing not in order."""
    try:
        data, ledger = json.loads(text), Ledger(encloses)
        if data["schema"] != SCHEMA:
            raise KernelError(f"schema: {data['schema']!r}: this kernel reads {SCHEMA!r}")
        for context in data["contexts"]:
            ledger.open(Context(**_frozen(context)))
        for fact in data["facts"]:
            ledger.add(Fact(**_frozen({**fact, "grade": Grade(fact["grade"])})))
        ledger.published = data["published"]
    except Exception as error:
        known = isinstance(error, KernelError)
        raise error if known else KernelError(f"not a ledger: {error!r}") from None
    if ledger.to_text() != text:
        raise KernelError("not a ledger as this kernel writes it")
    return ledger


def _frozen(fields: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(x) if key in _LISTS else x for key, x in fields.items()}
