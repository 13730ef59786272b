"""Independent check that a ledger proves every theorem of the specification.

A line without indent opens a block, a line indented by four spaces is a clause, and a line
indented further continues the clause before it; `` | `` also separates clauses.
`rigidsym.language._specification` defines each clause.  Here expressions are compared as trees, and
a context is compared with a whole block at once.
"""

from dataclasses import dataclass, field
from functools import cache
from typing import Any

from rigidsym.proof.checker._language import Form, Forms
from rigidsym.proof.checker._records import Claim, Hypotheses, Refused

Said = tuple[str, Form, Form]
KINDS = {"equal": "=", "root": "root", "nonnegative": "sign"}


@dataclass(slots=True)
class Block:
    """A named section of a specification: hypotheses, definitions and required statements."""

    assumed: dict[str, set[Form]] = field(default_factory=dict)
    rates: dict[str, Form] | None = None
    named: dict[str, Form] = field(default_factory=dict)
    sequences: list[tuple[str, list[str]]] = field(default_factory=list)
    stated: list[Said] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)

    def assume(self, clause: str, items: list[str]) -> None:
        """Add expressions to one clause, such as `zero` or `nonnegative`."""
        self.assumed.setdefault(clause, set()).update(map(read, items))

    def take(self, other: "Block") -> None:
        """Add all clauses of another block to this one."""
        for clause, forms in other.assumed.items():
            self.assumed.setdefault(clause, set()).update(forms)
        if other.rates is not None:
            self.rates = {**(self.rates or {}), **other.rates}
        self.named.update(other.named)
        self.sequences += other.sequences
        self.stated += other.stated


@cache
def read(text: str) -> Form:
    """Parse an expression, or return "?", the mark of an unknown rate, unchanged.

    Results are cached.
    """
    return "?" if text.strip() == "?" else Forms().read(text.strip())


def blocks(text: str) -> dict[str, tuple[bool, Block]]:
    """Parse a specification into its named blocks.

    Each block comes with whether it is a theorem.
    """
    found: dict[str, tuple[bool, Block]] = {}
    block = Block()
    for line in _lines(text):
        if line.startswith(" "):
            _clause(block, *line.strip().partition(" ")[::2], found)
            continue
        kind, _, title = line.partition(" ")
        name = title.partition(":")[0].strip()
        if kind not in ("theorem", "hypotheses") or name in found:
            raise Refused(f"specification: {line!a:.60} opens no block")
        block = Block()
        found[name] = kind == "theorem", block
    return found


def _lines(text: str) -> list[str]:
    lines: list[str] = []
    for line in text.split("\n"):
        line = line.split("#")[0].rstrip()
        if line.startswith("     "):
            lines[-1] += " " + line.strip()
        elif line:
            head, *more = line.split(" | ")
            lines += [head, *(f"    {clause.strip()}" for clause in more)]
    return lines


def _clause(block: Block, word: str, rest: str, found: dict[str, tuple[bool, Block]]) -> None:
    items = [item.strip() for item in rest.split(";")]
    if word == "under":
        for name in rest.split():
            block.take(found[name][1])
    elif word == "names":
        block.assume(word, rest.split())
    elif word in ("zero", "nonzero", "nonnegative"):
        block.assume(word, items)
    elif word == "positive":
        block.assume("nonzero", items)
        block.assume("nonnegative", items)
    elif word == "without":
        block.assumed["zero"] -= {*map(read, items)}
    elif word == "moving":
        rates = (item.split("' =") for item in items)
        block.rates = {**(block.rates or {}), **{name.strip(): read(rate) for name, rate in rates}}
    elif word in ("let", "with"):
        for name, form in (item.split(" = ") for item in items):
            block.named[name.strip()] = read(form)
            block.assumed.get("names", set()).discard(name.strip())
            (block.rates or {}).pop(name.strip(), None)
    elif word == "formulas":
        sequences, _, names = rest.partition(":")
        block.sequences += [(sequence, names.split()) for sequence in sequences.split()]
    elif word == "then":
        block.stated += map(_said, items)
    elif word == "cases":
        block.cases = [case.strip() for case in rest.split(",")]
    else:
        raise Refused(f"specification: {word!a} is no clause")


def _said(item: str) -> Said:
    if item.endswith(">= 0"):
        return "sign", read(item[:-4]), 0
    left, right = item.split(" = ")
    if right.startswith("sqrt("):
        return "root", read(left), read(right[4:])
    return "=", read(left), read(right)


class Catalogue:
    """Proved facts of a ledger, with its contexts and published formulas."""

    def __init__(
        self, contexts: dict[str, Hypotheses], facts: dict[str, Claim], published: dict[str, Any]
    ) -> None:
        self.contexts, self.facts, self.published = contexts, facts, published
        self.best = [fact for fact in facts.values() if fact.grade == "PROVED"]

    def require(self, text: str) -> None:
        """Raise Refused unless the ledger proves every theorem of a specification."""
        for name, (is_theorem, block) in blocks(text).items():
            if is_theorem:
                self._theorem(name, block)

    def _theorem(self, name: str, block: Block) -> None:
        context = self.contexts.get(name)
        declares = context is not None and (context.start or context.thetas)
        clauses = ("names", "zero", "nonzero", "nonnegative")
        due = [*(block.assumed.get(clause, set()) for clause in clauses), block.rates]
        if context is None or declares or _hypotheses(context) != due:
            raise Refused(f"theorem {name}: the ledger has not exactly its hypotheses")
        places = self._applicable_contexts(name)
        holds = {said for fact in self.best if fact.context in places for said in _sayings(fact)}
        defined = {
            ("=", *pair) for place in places for pair in _pairs(self.contexts[place].definitions)
        }
        readings = {pair for place in places for pair in self.contexts[place].reading.items()}
        proved: set[str] = {*block.named}
        for sequence, wanted in block.sequences:
            for entry in self._entries(sequence, wanted):
                if "definition" not in entry and "reading" in entry:
                    reading = self.contexts[entry["context"]].reading[entry["reading"]]
                    missing = (entry["reading"], reading) not in readings
                else:
                    said = self._formula(entry)
                    proved.add(str(said[1]))
                    missing = said not in holds | defined
                if missing:
                    raise Refused(f"theorem {name}: a formula of {sequence} is not proved: {entry}")
        _same_names(name, block, context, proved)
        for said in block.stated:
            if said not in holds and (said[0] != "=" or ("=", said[2], said[1]) not in holds):
                raise Refused(f"theorem {name}: it is not proved: {said}")
        if block.cases and not any(
            (fact.kind, fact.context, fact.rhs) == ("partition", name, block.cases)
            for fact in self.best
        ):
            raise Refused(f"theorem {name}: the cases are not proved")

    def _applicable_contexts(self, name: str) -> set[str]:
        """Return the names of all contexts whose facts hold in a context.

        These are the context itself and all contexts that it is a proved model of.
        """
        found, new = {name}, {name}
        while new:
            models = (f for f in self.best if f.kind == "model" and f.context in new)
            new = {fact.rhs[0] for fact in models} - found
            found |= new
        return found

    def _entries(self, sequence: str, wanted: list[str]) -> list[dict[str, Any]]:
        groups = (self.published.get(group, {}) for group in ("sequences", "forms"))
        (entries,) = [group[sequence] for group in groups if sequence in group] or [[]]
        named = {
            entry.get("definition") or entry.get("reading") or str(self._formula(entry)[1]): entry
            for entry in entries
        }
        if missing := {*wanted} - named.keys():
            raise Refused(f"the sequence {sequence} has no formula for {min(missing)}")
        if not entries:
            raise Refused(f"the sequence {sequence} is not published")
        return [named[name] for name in wanted] if wanted else entries

    def _formula(self, entry: dict[str, Any]) -> Said:
        if "definition" in entry:
            name = entry["definition"]
            return "=", name, read(self.contexts[entry["context"]].definitions[name])
        fact = self.facts[entry["fact"]]
        if fact.grade != "PROVED" or len(fact.lhs) != 1 or fact.kind not in ("equal", "root"):
            raise Refused(f"fact {fact.id}: it is published, but is not one proved formula")
        return _sayings(fact)[0]


def _hypotheses(context: Hypotheses) -> list[Any]:
    """Return the hypotheses of a context as sets of expressions.

    The sets are names, zeros, nonzeros and nonnegative expressions; the rates follow.
    """
    rates = None if context.rates is None else {k: read(text) for k, text in context.rates.items()}
    columns = (context.relations, context.units, context.nonnegative)
    return [{*context.generators}, *({*map(read, column)} for column in columns), rates]


def _same_names(name: str, block: Block, context: Hypotheses, proved: set[str]) -> None:
    """Raise Refused unless a context's definitions are those of the theorem.

    The context may define nothing that the theorem does not mention.
    """
    defined = dict(_pairs(context.definitions))
    for word, form in block.named.items():
        if defined.get(word) != form:
            raise Refused(f"theorem {name}: {word} is something else in the ledger")
    if beyond := defined.keys() - proved:
        raise Refused(f"theorem {name}: it says nothing of {min(map(str, beyond))}")


def _sayings(fact: Claim) -> list[Said]:
    if fact.kind not in KINDS:
        return []
    rights = [0] * len(fact.lhs) if fact.kind == "nonnegative" else map(read, fact.rhs)
    return [(KINDS[fact.kind], read(lhs), rhs) for lhs, rhs in zip(fact.lhs, rights, strict=True)]


def _pairs(table: dict[str, str]) -> list[tuple[str, Form]]:
    return [(name, read(text)) for name, text in table.items()]
