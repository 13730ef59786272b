"""The ledger: contexts and facts in the order they were admitted, as deterministic JSON.

`Ledger.add` is the only gate.  `replay` opens a written ledger by passing every context and every
fact through that gate again, so nothing in the file is believed because it is in the file.
"""

import json
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from rigidsym.kernel.context import Context
from rigidsym.kernel.fact import Fact, Grade
from rigidsym.kernel.ring import KernelError, Ring
from rigidsym.kernel.rules import RULES, differences

SCHEMA = "rigidsym.ledger/1"
_LISTS = {"generators", "units", "relations", "nonnegative", "lhs", "rhs", "premises", "source"}


@dataclass(slots=True)
class Ledger:
    """Everything admitted so far; `published` is an index for readers, and proves nothing."""

    contexts: dict[str, Context] = field(default_factory=dict)
    facts: dict[str, Fact] = field(default_factory=dict)
    published: dict[str, list[str]] = field(default_factory=dict)
    rings: dict[str, Ring] = field(default_factory=dict)

    def open(self, context: Context) -> Ring:
        """Admit a context; raises KernelError where it is not closed, inhabited or new."""
        if context.name in self.contexts:
            raise KernelError(f"context {context.name} is already there")
        self.rings[context.name] = context.open()
        self.contexts[context.name] = context
        return self.rings[context.name]

    def add(self, fact: Fact) -> Fact:
        """Admit a fact if its rule accepts it with the grade it claims; KernelError otherwise."""
        unknown = {*fact.premises} - self.facts.keys() | {fact.rule} - RULES.keys()
        unknown |= {fact.context} - self.rings.keys()
        if unknown or fact.id in self.facts:
            raise KernelError(f"fact {fact.id} is there already, or rests on {sorted(unknown)}")
        try:
            grade = RULES[fact.rule](self, fact)
        except Exception as error:
            raise KernelError(f"fact {fact.id}: {error}") from None
        grades = [grade, *(self.facts[premise].grade for premise in fact.premises)]
        earned = min(grades, key=list(Grade).index)
        if fact.grade != earned:
            raise KernelError(f"fact {fact.id}: claims {fact.grade}, has earned {earned}")
        self.facts[fact.id] = fact
        return fact

    def prove(self, fact: Fact) -> Fact:
        """Decide an identity by normal form and admit it; KernelError where it is not one."""
        ring = self.rings[fact.context]
        divided = [ring.reduce(difference) for difference in differences(ring, fact)]
        if any(remainder for _, remainder in divided):
            raise KernelError(f"fact {fact.id}: undecided: the normal form of lhs - rhs is not 0")
        cofactors = [[str(quotient) for quotient in quotients] for quotients, _ in divided]
        return self.add(replace(fact, certificate={"cofactors": cofactors}))

    def to_text(self) -> str:
        """The ledger as JSON text, the same on every machine."""
        data = {
            "schema": SCHEMA,
            "contexts": list(map(asdict, self.contexts.values())),
            "facts": list(map(asdict, self.facts.values())),
            "published": self.published,
        }
        return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def replay(text: str) -> Ledger:
    """Check a written ledger from nothing; raises KernelError at the first thing not in order."""
    try:
        data = json.loads(text)
        if data["schema"] != SCHEMA:
            raise KernelError(f"schema: {data['schema']!r}: this kernel reads {SCHEMA!r}")
        ledger = Ledger()
        for context in data["contexts"]:
            ledger.open(Context(**_frozen(context)))
        for fact in data["facts"]:
            ledger.add(Fact(**_frozen({**fact, "grade": Grade(fact["grade"])})))
        ledger.published = data["published"]
    except KernelError:
        raise
    except Exception as error:
        raise KernelError(f"not a ledger: {error!r}") from None
    if ledger.to_text() != text:
        raise KernelError("not a ledger as this kernel writes it")
    return ledger


def _frozen(fields: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(x) if key in _LISTS else x for key, x in fields.items()}
