"""Forged ledgers: definitions are changed together and all proofs are redone.

What no longer follows is left out, and what was published of it is restated or taken from
definitions.  The forger may do more than the kernel lets him: witnesses are not looked at again,
and balls agree.
"""

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from rigidsym.proof._mutants._edits import Edit
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, Ledger
from rigidsym.proof.kernel._rules import _frozen


class Unwitnessed(Context):
    """Context whose sample point is not checked."""

    __slots__ = ()

    def check_point(self, ring: Any, values: Any) -> list[Any]:
        """Accept any sample point."""
        return []


class Forger:
    """Maker of forged ledgers from a valid one."""

    def __init__(self, text: str) -> None:
        self._data, self._ledger = json.loads(text), Ledger()
        for entry in self._data["contexts"]:
            self._ledger.open(Context(**_frozen(entry)))
        for entry in self._data["facts"]:
            fact = Fact(**_frozen({**entry, "grade": Grade(entry["grade"])}))
            self._ledger.facts[fact.id] = fact
        published = (self._data["published"][group].values() for group in ("sequences", "forms"))
        entries = [entry for group in published for sequence in group for entry in sequence]
        ids = {entry["fact"] for entry in entries if "fact" in entry}
        self._formulas = {(f.lhs, f.rhs) for f in map(self._ledger.facts.__getitem__, ids)}

    def forge(self, mutant: Iterable[Edit], reuse: bool = True) -> Any:
        """Return the ledger with some definitions changed wherever they stand.

        Facts that the change cannot concern are reused; without `reuse` every proof is redone.
        """
        edits = list(mutant)
        texts = {place: text for edit in edits for place, text in edit.texts.items()}
        inverse = {name: old for edit in edits for name, old in edit.inverse}
        builder = LedgerBuilder()
        builder.ledger = Ledger(lambda *_: True)
        contexts = self._ledger.contexts.values()
        hit = {c.name for c in contexts if texts.keys() & c.said().items()}
        for context in contexts:
            self._open(builder.ledger, context, texts if context.name in hit else {})
        unlike: set[str] = set()
        for fact in self._ledger.facts.values():
            touched = {fact.context, *fact.rhs} if fact.kind == "model" else {fact.context}
            if reuse and not touched & hit and not {*fact.premises} & unlike:
                builder.ledger.facts[fact.id] = fact
                continue
            restated = [_restated(fact, texts)]
            if (fact.lhs, fact.rhs) in self._formulas:
                restated.append(_substituted(fact, inverse))
            unlike.add(fact.id)
            any(_redo(builder, one) for one in restated)
        data = json.loads(builder.ledger.to_text())
        published = {
            group: self._sequences(builder.ledger, group) for group in ("sequences", "forms")
        }
        return {**self._data, **data, "published": {**self._data["published"], **published}}

    def _open(self, ledger: Ledger, context: Context, texts: Mapping[tuple[str, str], str]) -> None:
        if not texts:
            ledger.rings[context.name] = self._ledger.rings[context.name]
            ledger.contexts[context.name] = context
            return
        fields: dict[str, Any] = {name: getattr(context, name) for name in Context.__slots__}
        changed = {name: texts.get((name, text), text) for name, text in context.said().items()}
        fields["definitions"] = {name: changed[name] for name in context.definitions}
        if context.rates is not None:
            fields["rates"] = {x: changed.get(f"D({x})", text) for x, text in context.rates.items()}
        try:
            ledger.open(Unwitnessed(**fields))
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


def _restated(fact: Fact, texts: Mapping[tuple[str, str], str]) -> Fact:
    """Return a fact with the changed definitions wherever the fact restates them."""
    if fact.kind not in ("equal", "root"):
        return fact
    pairs = zip(fact.lhs, fact.rhs, strict=True)
    return replace(fact, rhs=tuple(texts.get(pair, pair[1]) for pair in pairs))


def _substituted(fact: Fact, inverse: Mapping[str, str]) -> Fact:
    """Return a published formula that gives its name the new value, from the new values.

    This is the old formula with each changed name replaced by what it was.
    """
    changed = re.sub(r"[A-Za-z_]\w*", lambda x: inverse.get(x[0], x[0]), fact.rhs[0])
    name = fact.lhs[0]
    if (was := inverse.get(name)) == f"(-{name})":
        changed = f"-({changed})"
    elif was == f"({name}/2)":
        changed = f"2*({changed})"
    return replace(fact, rhs=(changed, *fact.rhs[1:]))


def _redo(builder: LedgerBuilder, fact: Fact) -> bool:
    """Prove a fact again in the forged ledger, and return whether it still follows."""
    if (
        fact.context not in builder.ledger.contexts
        or {*fact.premises} - builder.ledger.facts.keys()
    ):
        return False
    try:
        if fact.rule == "identity":
            builder.decide(fact)
        else:
            builder.ledger.add(fact)
    except (KernelError, ZeroDivisionError, KeyError):
        return False
    return True
