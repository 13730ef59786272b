"""The specification: theorems that a ledger must prove under exactly the given hypotheses.

A specification is made of blocks.  A block is a line that names it and clauses below, one a line or
with ``|`` between them; the items of a clause are separated by ``;`` and continue in lines that are
indented further than their clause.

    hypotheses name                      assumptions of several theorems; `under` includes them
    theorem name: its statement in words

    under A B                            the hypotheses of other blocks
    names x y                            real numbers
    zero a; b                            a = 0, b = 0
    nonzero a; b                         a != 0, b != 0
    nonnegative a; b                     a >= 0, b >= 0
    positive a                           a >= 0 and a != 0
    moving x' = a; y' = ?                time derivatives, known or not; other names are constant
    let x = a                            definitions of names
    with x = a                           definitions of names that would be free otherwise
    without a                            a = 0 is not assumed
    formulas s t                         the published sequences s and t hold: names mean that, too
    formulas s: x y                      of the sequence s the formulas for x and y hold
    then a = b; a = sqrt(b); a >= 0      the conclusions
    cases A, B, C                        the conclusion that exactly one of these theorems applies

A theorem without `moving` is about one instant.  Texts are compared word for word, spaces aside.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, NamedTuple, TypeAlias

CLAUSES = {
    *("under", "names", "zero", "nonzero", "nonnegative", "positive", "moving", "let", "with"),
    *("without", "formulas", "then", "cases"),
}
_NAME = re.compile(r"[A-Za-z_]\w*")
# A proved equation, root or sign: "=", "sqrt" or ">=", and both sides.
Statement: TypeAlias = tuple[str, str, str]


class Published(NamedTuple):
    """A published formula, with its name, its context and how it is justified.

    It is a definition, a reading, a fact or a root.  A root is the square root of its text.
    """

    how: str
    context: str
    name: str
    text: str

    @property
    def said(self) -> Statement:
        """The formula as a statement, without spaces."""
        return "sqrt" if self.how == "root" else "=", self.name, _spaceless(self.text)


class Unproved(ValueError):  # noqa: N818 (a verdict rather than an error)
    """Exception for a theorem of the specification that a ledger does not prove."""


@dataclass(slots=True)
class Theorem:
    """One block of a specification, merged with the blocks that it includes.

    The texts have no spaces.
    """

    name: str
    title: str = ""
    is_theorem: bool = False
    names: set[str] = field(default_factory=set)
    zero: set[str] = field(default_factory=set)
    nonzero: set[str] = field(default_factory=set)
    nonnegative: set[str] = field(default_factory=set)
    moving: dict[str, str] | None = None
    let: dict[str, str] = field(default_factory=dict)
    formulas: list[tuple[str, tuple[str, ...]]] = field(default_factory=list)
    then: list[Statement] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)


def read(text: str) -> dict[str, Theorem]:
    """Parse the blocks of a specification.

    Raises ValueError for a malformed block.
    """
    blocks: dict[str, Theorem] = {}
    for head, clauses in _blocks(text):
        kind, _, rest = head.partition(" ")
        name, _, title = (part.strip() for part in rest.partition(":"))
        if kind not in ("hypotheses", "theorem") or not _NAME.fullmatch(name) or name in blocks:
            raise ValueError(f"specification: {head!r}: no block, or one of this name is there")
        block = Theorem(name, title, kind == "theorem")
        for clause, content in clauses:
            _fill(block, clause, content, blocks)
        blocks[name] = block
    return blocks


def _blocks(text: str) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Yield the first line and the clauses of each block in a specification."""
    lines = (line.partition("#")[0].rstrip() for line in text.splitlines())
    for block in filter(None, re.split(r"\n+(?=\S)", "\n".join(lines).strip())):
        head, *clauses = re.split(r" \| |\n {4}(?=\S)", block)
        pairs = [" ".join(clause.split()).partition(" ")[::2] for clause in clauses]
        for clause, _ in pairs:
            if clause not in CLAUSES:
                raise ValueError(f"specification: {clause!r} is no clause")
        yield head.strip(), pairs


def _fill(block: Theorem, clause: str, content: str, blocks: Mapping[str, Theorem]) -> None:
    items = ["".join(item.split()) for item in content.split(";") if item.strip()]
    match clause:
        case "under":
            for name in content.split():
                _include(block, blocks[name])
        case "names":
            block.names |= {*content.split()}
        case "zero" | "nonzero" | "nonnegative":
            getattr(block, clause).update(items)
        case "positive":
            block.nonzero |= {*items}
            block.nonnegative |= {*items}
        case "moving":
            block.moving = (block.moving or {}) | dict(item.split("'=") for item in items)
        case "let" | "with":
            block.let |= dict(item.split("=") for item in items)
            block.names -= {*block.let}
            if block.moving is not None:  # Defined names do not move by themselves.
                block.moving = {k: x for k, x in block.moving.items() if k not in block.let}
        case "without":
            block.zero -= {*items}
        case "formulas":
            sequences, _, names = content.partition(":")
            block.formulas += [(name, tuple(names.split())) for name in sequences.split()]
        case "then":
            block.then += map(_statement, items)
        case "cases":
            block.cases += [name.strip() for name in content.split(",")]


def _include(block: Theorem, other: Theorem) -> None:
    for clause in ("names", "zero", "nonzero", "nonnegative"):
        getattr(block, clause).update(getattr(other, clause))
    block.let |= other.let
    if other.moving is not None:
        block.moving = (block.moving or {}) | other.moving
    block.formulas += other.formulas
    block.then += other.then


def _statement(item: str) -> Statement:
    if item.endswith(">=0"):
        return ">=", item.removesuffix(">=0"), "0"
    lhs, _, rhs = item.partition("=")
    root = re.fullmatch(r"sqrt\((.*)\)", rhs)
    return ("sqrt", lhs, root[1]) if root else ("=", lhs, rhs)


def written(statement: Statement) -> str:
    """Format a statement as text."""
    relation, lhs, rhs = statement
    if relation == ">=":
        return f"{lhs} >= 0"
    return f"{lhs} = {rhs}" if relation == "=" else f"{lhs} = sqrt({rhs})"


@cache
def theorems(specification: str) -> dict[str, Theorem]:
    """Return the theorems of a specification by name."""
    return {name: block for name, block in read(specification).items() if block.is_theorem}


def sequences(ledger: Mapping[str, Any]) -> dict[str, list[Any]]:
    """Return all formula sequences that a ledger publishes.

    Some are for numerical code, and others for readers.
    """
    published = ledger["published"]
    return {**published.get("sequences", {}), **published.get("forms", {})}


def require(specification: str, ledger: "Mapping[str, Any] | Proved") -> None:
    """Check that a ledger proves every theorem of a specification.

    Raises Unproved for the first theorem that it does not prove.
    """
    try:
        proved = ledger if isinstance(ledger, Proved) else Proved(ledger)
        for theorem in theorems(specification).values():
            if lack := next(proved.lacks(theorem), ""):
                raise Unproved(f"theorem {theorem.name} ({theorem.title}): {lack}")
    except (LookupError, TypeError, AttributeError) as error:
        raise Unproved(f"its published formulas are not readable: {error}") from None


class Proved:
    """The statements that a ledger claims to prove.

    Checkers decide whether the proofs hold.
    """

    def __init__(self, ledger: Mapping[str, Any]) -> None:
        self.contexts = {context["name"]: context for context in ledger["contexts"]}
        self.facts = {fact["id"]: fact for fact in ledger["facts"]}
        self.proved = [fact for fact in ledger["facts"] if fact["grade"] == "PROVED"]
        self.sequences = sequences(ledger)
        self._models: dict[str, list[str]] = {}
        self._stated: dict[str, set[Statement]] = {}
        self._partitions: set[tuple[str, ...]] = set()
        for fact in self.proved:
            place, kind = fact["context"], fact["kind"]
            relation = {"equal": "=", "root": "sqrt", "nonnegative": ">="}.get(kind)
            if kind == "model":
                self._models.setdefault(place, []).extend(fact["rhs"])
            elif kind == "partition":
                self._partitions.add((place, *fact["rhs"]))
            elif relation:
                self._stated.setdefault(place, set()).update(
                    (relation, _spaceless(lhs), "0" if relation == ">=" else _spaceless(rhs))
                    for lhs, rhs in zip(fact["lhs"], fact["rhs"], strict=True)
                )

    def lacks(self, theorem: Theorem) -> Iterator[str]:
        """Yield one sentence for each part of a theorem that the ledger does not prove."""
        context = self.contexts.get(theorem.name)
        if context is None:
            yield "its hypotheses are not in the ledger"
            return
        yield from _unlike(theorem, context)
        places = self.modelled(theorem.name)
        facts = set().union(*(self._stated.get(place, set()) for place in places))
        definitions, readings = (
            {
                ("=", name, _spaceless(text))
                for place in places
                for name, text in self.contexts[place][column].items()
            }
            for column in ("definitions", "reading")
        )
        formulas = [f for part in theorem.formulas for f in self._formulas(*part)]
        yield from _unsaid(theorem, context, {f.name for f in formulas if f.how != "reading"})
        for formula in formulas:
            if formula.said not in (readings if formula.how == "reading" else facts | definitions):
                yield f"its formula {written(formula.said)} is not proved under its hypotheses"
        for said in theorem.then:
            relation, lhs, rhs = said
            reversed_ = (relation, rhs, lhs) if relation == "=" else said
            if not {said, reversed_} & facts:
                yield f"{written(said)} is not proved under its hypotheses"
        if theorem.cases and (theorem.name, *theorem.cases) not in self._partitions:
            yield f"exactly one of {', '.join(theorem.cases)} is not proved"

    def modelled(self, name: str) -> list[str]:
        """Return a context and all contexts of which it is a model, directly or indirectly."""
        places = [name]
        for place in places:
            places += (other for other in self._models.get(place, ()) if other not in places)
        return places

    def formula(self, entry: Mapping[str, Any]) -> Published:
        """Return the formula of an entry in a published sequence.

        Raises Unproved for a fact that is not one proved formula.
        """
        for how, column in (("definition", "definitions"), ("reading", "reading")):
            if how in entry:
                context, name = self.contexts[entry["context"]], entry[how]
                return Published(how, context["name"], name, context[column][name])
        fact = self.facts.get(entry["fact"])
        proved = fact is not None and fact["grade"] == "PROVED" and len(fact["lhs"]) == 1
        if not proved or fact["kind"] not in ("equal", "root"):
            raise Unproved(f"{entry['fact']} is published but is not one proved formula")
        how = "root" if fact["kind"] == "root" else "fact"
        return Published(how, fact["context"], fact["lhs"][0], fact["rhs"][0])

    def _formulas(self, sequence: str, names: Iterable[str]) -> list[Published]:
        """Return the formulas of a published sequence.

        If `names` are given, return only the formulas that set them.
        """
        wanted = {*names}
        if sequence not in self.sequences:
            raise Unproved(f"the formula sequence {sequence} is not published")
        found = [self.formula(entry) for entry in self.sequences[sequence]]
        if missing := wanted - {formula.name for formula in found}:
            raise Unproved(f"the formula sequence {sequence} has no formula for {min(missing)}")
        return [formula for formula in found if not wanted or formula.name in wanted]


def _unlike(theorem: Theorem, context: Mapping[str, Any]) -> Iterator[str]:
    """Yield the differences between the hypotheses of a theorem and those of its context."""
    rates = context["rates"]
    if (rates is None) != (theorem.moving is None):
        yield "it is about one instant, or about a motion, where the ledger has the other"
    for text in (*context["start"], *context["thetas"].values()):
        yield f"{text}: the ledger declares this beyond it"
    columns = {"zero": "relations", "nonzero": "units", "nonnegative": "nonnegative"}
    here = {clause: getattr(theorem, clause) for clause in ("names", *columns)}
    there = {clause: {*map(_spaceless, context[name])} for clause, name in columns.items()}
    there["names"] = {*context["generators"]}
    here["moving"], there["moving"] = (
        {f"{name}' = {_spaceless(text)}" for name, text in (moving or {}).items()}
        for moving in (theorem.moving, rates)
    )
    for clause, texts in here.items():
        for text in sorted(there[clause] - texts):
            yield f"{clause} {text}: the ledger assumes this beyond it"
        for text in sorted(texts - there[clause]):
            yield f"{clause} {text}: this is not assumed in the ledger"


def _unsaid(theorem: Theorem, context: Mapping[str, Any], published: set[str]) -> Iterator[str]:
    """Yield the differences between the definitions of a theorem and those of its context.

    A definition that only the context has counts, unless it is among the published formulas.
    """
    definitions = {name: _spaceless(text) for name, text in context["definitions"].items()}
    for name, text in theorem.let.items():
        if definitions.get(name) != text:
            yield f"let {name} = {text}: in the ledger it is {definitions.get(name, 'nothing')}"
    for name in definitions.keys() - theorem.let.keys() - published:
        yield f"{name} = {definitions[name]}: the ledger has this name beyond it"


def _spaceless(text: str) -> str:
    return text.replace(" ", "")
