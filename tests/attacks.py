"""Forged ledgers: one definition is changed and all proofs are redone.

What no longer follows is left out, and what was published of it is taken from definitions.  The
attacker may do more than the kernel lets him: witnesses are not looked at again, and balls agree.
"""

import json
from dataclasses import replace
from typing import Any

from rigidsym.language._expression import Call, Number, Operation, parse, to_text
from rigidsym.language._specification import theorems
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, Ledger
from rigidsym.proof.kernel._ledger import _frozen


class Unwitnessed(Context):
    """Context whose sample point is not checked."""

    __slots__ = ()

    def check_point(self, ring, values):
        """Accept any sample point."""
        return []


def changes(text: str) -> dict[str, str]:
    """Return forged versions of a definition, by the kind of change.

    A version has a flipped sign, a dropped term or factor, or a factor 2.
    """
    tree = parse(text)
    found = {"flipped": _flipped(tree), "doubled": Operation("*", Number(2), tree)}
    if isinstance(tree, Operation) and tree.operator != "**":
        found["dropped"] = tree.left
    return {kind: to_text(changed) for kind, changed in found.items()}


def _flipped(tree):
    match tree:
        case Operation("+" | "-" as sign, left, right):
            return Operation("-" if sign == "+" else "+", left, right)
        case Call("neg", (operand,)):
            return operand
    return Call("neg", (tree,))


def definitions(specification: str, data: Any) -> list[tuple[str, str]]:
    """Return the name and text of each definition in the contexts of a specification."""
    named = theorems(specification)
    contexts = [context for context in data["contexts"] if context["name"] in named]
    return [*dict.fromkeys(pair for c in contexts for pair in c["definitions"].items())]


class Attacker:
    """Forger of ledgers from a valid one."""

    def __init__(self, text: str) -> None:
        self._data, self._ledger = json.loads(text), Ledger()
        for entry in self._data["contexts"]:
            self._ledger.open(Context(**_frozen(entry)))
        for entry in self._data["facts"]:
            fact = Fact(**_frozen({**entry, "grade": Grade(entry["grade"])}))
            self._ledger.facts[fact.id] = fact

    def redefine(self, name: str, text: str, changed: str) -> Any:
        """Return the ledger with one definition of a name replaced everywhere."""
        hit = {c.name for c in self._ledger.contexts.values() if c.definitions.get(name) == text}
        builder = LedgerBuilder()
        builder.ledger = Ledger(lambda *_: True)
        for context in self._ledger.contexts.values():
            self._open(builder.ledger, context, {name: changed} if context.name in hit else {})
        unlike: set[str] = set()
        for fact in self._ledger.facts.values():
            restated = _restated(fact, name, text, changed)
            touched = {fact.context, *fact.rhs} if fact.kind == "model" else {fact.context}
            if restated == fact and not touched & hit and not {*fact.premises} & unlike:
                builder.ledger.facts[fact.id] = fact
                continue
            unlike.add(fact.id)
            _redo(builder, restated)
        data = json.loads(builder.ledger.to_text())
        published = {
            group: self._sequences(builder.ledger, group) for group in ("sequences", "forms")
        }
        return {**self._data, **data, "published": {**self._data["published"], **published}}

    def _open(self, ledger: Ledger, context: Context, changed: dict[str, str]) -> None:
        fields = {name: getattr(context, name) for name in Context.__slots__}
        ledger.rings[context.name] = self._ledger.rings[context.name]
        ledger.contexts[context.name] = context
        if changed:
            given = Unwitnessed(**{**fields, "definitions": {**context.definitions, **changed}})
            del ledger.contexts[context.name]
            try:
                ledger.open(given)
            except (KernelError, ZeroDivisionError):
                ledger.contexts.pop(context.name, None)

    def _sequences(self, ledger: Ledger, group: str) -> dict[str, list[Any]]:
        """Return the published formulas, each by its definition if its fact is lost."""
        return {
            sequence: [self._entry(ledger, entry) for entry in entries]
            for sequence, entries in self._data["published"][group].items()
        }

    def _entry(self, ledger: Ledger, entry: Any) -> Any:
        if "fact" not in entry or entry["fact"] in ledger.facts:
            return entry
        fact = self._ledger.facts[entry["fact"]]
        context = ledger.contexts.get(fact.context)
        if context is None or fact.lhs[0] not in context.definitions:
            return entry
        source = [*fact.source]
        return {"context": context.name, "definition": fact.lhs[0], "source": source}


def _restated(fact: Fact, name: str, text: str, changed: str) -> Fact:
    """Return a fact with the changed definition wherever the fact restates it."""
    if fact.kind not in ("equal", "root"):
        return fact
    pairs = zip(fact.lhs, fact.rhs, strict=True)
    return replace(fact, rhs=tuple(changed if p == (name, text) else p[1] for p in pairs))


def _redo(builder: LedgerBuilder, fact: Fact) -> None:
    """Prove a fact again in the forged ledger, if it still follows."""
    if (
        fact.context not in builder.ledger.contexts
        or {*fact.premises} - builder.ledger.facts.keys()
    ):
        return
    try:
        if fact.rule == "identity":
            builder.decide(fact)
        else:
            builder.ledger.add(fact)
    except (KernelError, ZeroDivisionError, KeyError):
        return
