"""The ledger: contexts and facts in order of admission, written as deterministic JSON.

Facts enter by `Ledger.add` alone; `replay` passes every fact of a written ledger through it again.
"""

import json
from dataclasses import dataclass, field, fields
from typing import Any

from rigidsym.proof.kernel._language import KernelError, is_name
from rigidsym.proof.kernel._ring import Ring
from rigidsym.proof.kernel._rules import RULES, Admitted, Encloses, check_nontrivial
from rigidsym.proof.kernel._statement import Context, Fact, Grade, weakest

SCHEMA = "rigidsym.ledger/4"
_LISTS = {"generators", "units", "relations", "nonnegative", "start"}
_LISTS |= {"lhs", "rhs", "premises", "source"}


@dataclass(slots=True)
class Ledger(Admitted):
    """The contexts and facts that the kernel has admitted, in order."""

    published: dict[str, Any] = field(default_factory=dict)  # an index that proves nothing

    def open(self, context: Context) -> Ring:
        """Check a context and add it to the ledger, or raise KernelError."""
        if context.name in self.contexts:
            raise KernelError(f"context {context.name} is already there")
        self.rings[context.name] = context.open()
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
        if fact.kind in ("equal", "root", "nonnegative"):
            check_nontrivial(self, fact)
        supports = [self.facts[premise].grade for premise in fact.premises]
        if fact.grade != (earned := weakest([rule(self, fact), *supports])):
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
    try:
        data, ledger = json.loads(text), Ledger(encloses)
        if data["schema"] != SCHEMA:
            raise KernelError(f"schema: {data['schema']!r}: this kernel reads {SCHEMA!r}")
        for entry in data["contexts"]:
            ledger.open(Context(**_frozen(entry)))
        for entry in data["facts"]:
            ledger.add(Fact(**_frozen({**entry, "grade": Grade(entry["grade"])})))
        ledger.published = dict(data["published"])
    except Exception as error:
        known = isinstance(error, KernelError)
        raise error if known else KernelError(f"not a ledger: {error!r}") from None
    if ledger.to_text() != text:
        raise KernelError("not a ledger as this kernel writes it")
    return ledger


def _frozen(fields: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(x) if key in _LISTS else x for key, x in fields.items()}
