"""Independent check that a ledger proves every theorem of the specification.

A line without indent opens a block, a line indented by four spaces is a clause, and a line
indented further continues the clause before it; `` | `` also separates clauses.
`rigidsym.language._specification` defines each clause.  Here a context is compared with a whole
block at once, and expressions by residues of their own.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from hashlib import sha256
from typing import Any

from rigidsym.proof.checker._language import Form, Forms
from rigidsym.proof.checker._notation import Components, Residues, flat, names_in
from rigidsym.proof.checker._records import Claim, Hypotheses, Refused

Said = tuple[str, Form, Form]
KINDS = {"equal": "=", "root": "root", "nonnegative": "sign"}


@dataclass(slots=True)
class Block:
    """A named section of a specification: hypotheses, definitions and required statements."""

    assumed: dict[str, set[Form]] = field(default_factory=dict)
    # The squares of roots.
    squares: dict[str, Form] = field(default_factory=dict)
    rates: dict[str, Form] | None = None
    named: dict[str, Form] = field(default_factory=dict)
    sequences: list[tuple[str, list[str]]] = field(default_factory=list)
    thetas: dict[str, str] = field(default_factory=dict)
    stated: list[Said] = field(default_factory=list)
    enclosed: list[Said] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)
    applies: set[str] = field(default_factory=set)
    components: Components = field(default_factory=Components)

    def assume(self, clause: str, forms: list[Form]) -> None:
        """Add expressions to one clause, such as `zero` or `nonnegative`."""
        self.assumed.setdefault(clause, set()).update(forms)

    def take(self, other: "Block") -> None:
        """Add all clauses of another block to this one."""
        for clause, forms in other.assumed.items():
            self.assume(clause, [*forms])
        if other.rates is not None:
            self.rates = {**(self.rates or {}), **other.rates}
        self.named.update(other.named)
        self.squares.update(other.squares)
        self.components.take(other.components)
        self.sequences += other.sequences
        self.stated += other.stated
        self.applies |= other.applies

    def items(self, rest: str) -> list[Form]:
        """Return the expressions of a clause by components."""
        return [left for left, _ in self.sides(rest, "=")]

    def sides(self, rest: str, sign: str) -> Iterator[tuple[Form, Form]]:
        """Yield the two sides of each item by components, for one input after the other."""
        for item in rest.split(";"):
            left, _, right = item.partition(sign)
            for x in self.components.inputs(item):
                self.components.x = x
                one, two = flat(self.read(left)), flat(self.read(right or "0"))
                yield from zip(one, two * len(one) if len(two) == 1 else two, strict=True)

    def read(self, text: str) -> Any:
        """Return an expression by components, `unknown` for a rate that is not known."""
        return self.components.read(text.replace("?", "unknown").strip())

    def equations(self, rest: str, sign: str) -> dict[str, Form]:
        """Return what names are; 0 is no name, but a derivative by what does not matter."""
        return {str(name): form for name, form in self.sides(rest, sign) if name != 0}

    def turn(self, name: str, rate: str) -> None:
        """Assume that a number of modulus 1 turns at a rate."""
        x, y = self.read(name)
        self.assume("zero", [("-", ("+", ("**", x, 2), ("**", y, 2)), 1)])
        speed = self.read(rate)
        turned: dict[str, Form] = {x: ("-", ("*", speed, y)), y: ("*", speed, x)}
        self.rates = (self.rates or {}) | turned


@cache
def read(text: str) -> Form:
    """Parse an expression, or return "?", the mark of an unknown rate, unchanged.

    Results are cached.
    """
    return "unknown" if text.strip() == "?" else Forms().read(text.strip())


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
    """Return the lines of blocks and clauses, each once for every row that follows its `for`."""
    lines: list[str] = []
    for line in text.split("\n"):
        line = line.split("#")[0].rstrip()
        if line.startswith("     "):
            lines[-1] += " " + line.strip()
        elif line:
            lines.append(line)
    given: list[list[str]] = []
    for part in "\n".join(lines).replace(" | ", "\n    ").splitlines():
        if part[0] == " " and given:
            given[-1].append(part)
        else:
            given.append([part])
    filled = (line for lines in given for block in _filled(lines) for line in block)
    return [one for line in filled for (one,) in _filled([line])]


def _filled(lines: list[str]) -> list[list[str]]:
    """Fill in braces by the rows of ``for x y = 1 2, 3 4:`` in the first line."""
    word, given, rest = lines[0].partition(" for ")
    if not given or " " in word.strip():
        return [lines]
    letters, _, more = rest.partition(" = ")
    rows, _, first = more.partition(":")
    blocks = []
    for row in rows.split(","):
        blocks.append([word + first, *lines[1:]])
        for letter, value in zip(letters.split(), row.split(), strict=True):
            blocks[-1] = [line.replace("{" + letter + "}", value) for line in blocks[-1]]
    return blocks


def _clause(block: Block, word: str, rest: str, found: dict[str, tuple[bool, Block]]) -> None:
    if word == "under":
        for name in rest.split():
            block.take(found[name][1])
    elif word in ("vectors", "quaternions", "complex", "matrices", "derivatives", "write"):
        block.components.declare(word, rest)
    elif word in ("zero", "nonzero", "nonnegative", "start"):
        block.assume(word, block.items(rest))
    elif word == "thetas":
        for item in rest.split(";"):
            name, function = item.strip().split(" = ")
            if name in block.components.named:
                block.thetas[f"{name}_re"] = f"re({function})"
                block.thetas[f"{name}_im"] = f"im({function})"
            else:
                block.thetas[name] = function
    elif word == "positive":
        block.assume("nonzero", block.items(rest))
        block.assume("nonnegative", block.items(rest))
    elif word == "roots":
        squares = block.equations(rest, " = ")
        block.squares |= squares
        block.assume("zero", [("-", ("**", x, 2), squares[x]) for x in squares])
        block.assume("nonnegative", [*squares])
    elif word == "without":
        block.assumed["zero"] -= {*block.items(rest)}
    elif word == "moving":
        block.rates = {**(block.rates or {}), **block.equations(rest, "' =")}
    elif word == "turning":
        for item in rest.split(";"):
            block.turn(*map(str.strip, item.split(" at ")))
    elif word in ("let", "with"):
        block.named.update(block.equations(rest, " = "))
        for x in block.squares.keys() & block.named.keys():  # This root is given by itself.
            block.assumed["zero"].remove(("-", ("**", x, 2), block.squares.pop(x)))
        rates = block.rates
        block.rates = rates and {x: rates[x] for x in rates.keys() - block.named.keys()}
    elif word == "formulas":
        sequences, _, names = rest.partition(":")
        wanted = [*block.components.parts(names)]
        block.sequences += [(sequence, wanted) for sequence in sequences.split()]
    elif word in ("then", "enclosed"):
        said = block.stated if word == "then" else block.enclosed
        for item in rest.split(";"):
            kind = "sign" if ">=" in item else "="
            for left, right in block.sides(item, ">=" if kind == "sign" else " = "):
                is_root = isinstance(right, tuple) and right[:2] == ("call", "sqrt")
                said.append(("root", left, right[2]) if is_root else (kind, left, right))
    elif word == "varied":
        _clause(block, "then", rest, found)
        items = (item.partition(" = ") for item in rest.split(";"))
        slopes = (f"d_x({left}) = d_x({right})" for left, _, right in items)
        _clause(block, "then", "; ".join(slopes), found)
    elif word == "cases":
        block.cases = [case.strip() for case in rest.split(",")]
    elif word == "applies":
        block.applies |= {*rest.split()}
    else:
        raise Refused(f"specification: {word!a} is no clause")


class Catalogue:
    """Proved facts of a ledger, with its contexts and published formulas."""

    def __init__(
        self, contexts: dict[str, Hypotheses], facts: dict[str, Claim], published: dict[str, Any]
    ) -> None:
        self.contexts, self.facts, self.published = contexts, facts, published
        self.best = [fact for fact in facts.values() if fact.grade == "PROVED"]
        every = [list(contexts.values()), list(facts.values()), published]
        self.seed = sha256(repr(every).encode()).hexdigest()

    def require(self, text: str) -> None:
        """Raise Refused unless the ledger proves every theorem of a specification."""
        for name, (is_theorem, block) in blocks(text).items():
            if is_theorem:
                self._theorem(name, block)

    def _theorem(self, name: str, block: Block) -> None:
        context = self.contexts.get(name)
        if context is None or context.thetas != block.thetas:
            raise Refused(f"theorem {name}: the ledger has not exactly its hypotheses")
        places = self._applicable_contexts(name)
        others = [pair for place in places[1:] for pair in _pairs(self.contexts[place].definitions)]
        own = dict(_pairs(context.definitions))
        rates = None if context.rates is None else dict(_pairs(context.rates))
        residues = Residues(
            self.seed, context.generators, {**block.named, **dict(others[::-1]), **own}, rates
        )
        if _hypotheses(context, rates, residues) != _due(block, residues):
            raise Refused(f"theorem {name}: the ledger has not exactly its hypotheses")
        facts = [said for fact in self.best if fact.context in places for said in _sayings(fact)]
        holds = {0, *_residues([*facts, *(("=", *pair) for pair in others)], residues)}
        readings = {pair for place in places for pair in self.contexts[place].reading.items()}
        proved: set[str] = {*block.named}
        spoken = names_in((*block.named.values(), *(x for said in block.stated for x in said[1:])))
        for entry in (x for part in block.sequences for x in self._entries(*part)):
            if "definition" not in entry and "reading" in entry:
                word = entry["reading"]
                missing = (word, self.contexts[entry["context"]].reading[word]) not in readings
            else:
                said = self._formula(entry)
                proved.add(str(said[1]))
                spoken |= names_in(said[2:])
                missing = said[1] in names_in(said[2:]) or residues.said(said) not in holds
            if missing:
                raise Refused(f"theorem {name}: a published formula is not proved: {entry}")
        for word, form in block.named.items():
            if residues.of(word) != residues.of(form):
                raise Refused(f"theorem {name}: {word} is something else in the ledger")
        spoken |= names_in((*block.assumed.values(), *(block.rates or {}).values()))
        if beyond := (spoken - proved) & residues.meanings.keys():
            raise Refused(f"theorem {name}: it does not say what {min(beyond)} is")
        for said in block.stated:
            if residues.said(said) not in holds:
                raise Refused(f"theorem {name}: it is not proved: {said}")
        believed = [f for f in self.facts.values() if (f.context, f.grade) == (name, "ENCLOSED")]
        enclosed = {*_residues([said for f in believed for said in _sayings(f)], residues)}
        if {*map(residues.said, block.enclosed)} - enclosed:
            raise Refused(f"theorem {name}: an equation is not enclosed")
        if not block.applies <= {*places}:
            raise Refused(f"theorem {name}: another theorem is not proved to apply")
        if block.cases and not any(
            (fact.kind, fact.context, fact.rhs) == ("partition", name, block.cases)
            for fact in self.best
        ):
            raise Refused(f"theorem {name}: the cases are not proved")

    def _applicable_contexts(self, name: str) -> list[str]:
        """Return the names of all contexts whose facts hold in a context, that itself first.

        These are the context itself and all contexts that it is a proved model of.
        """
        found, new = [name], [name]
        while new:
            models = (f for f in self.best if f.kind == "model" and f.context in new)
            new = [*dict.fromkeys(f.rhs[0] for f in models if f.rhs[0] not in found)]
            found += new
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


def _due(block: Block, residues: Residues) -> list[Any]:
    """Return the hypotheses of a theorem as sets of residues; the rates follow."""
    zero, nonzero, start, nonnegative = (
        {*map(residues.of, block.assumed.get(clause, ()))}
        for clause in ("zero", "nonzero", "start", "nonnegative")
    )
    rates = block.rates
    if rates is not None:
        slopes = {x: ("/", ("call", "D", a), ("*", 2, x)) for x, a in block.squares.items()}
        rates = {x: slope for x, slope in slopes.items() if residues.of(slope) != 0} | rates
    unsigned = map(_unsigned, (zero, nonzero, start))
    return [*unsigned, nonnegative, _moving(rates, residues)]


def _hypotheses(
    context: Hypotheses, rates: dict[str, Form] | None, residues: Residues
) -> list[Any]:
    """Return the hypotheses of a context as sets of residues; the rates follow."""
    zero, nonzero, start, nonnegative = (
        {residues.of(read(text)) for text in column}
        for column in (context.relations, context.units, context.start, context.nonnegative)
    )
    return [*map(_unsigned, (zero, nonzero, start)), nonnegative, _moving(rates, residues)]


def _unsigned(found: set[Any]) -> set[Any]:
    return found | {-x for x in found}


def _moving(rates: dict[str, Form] | None, residues: Residues) -> dict[str, Any] | None:
    if rates is None:
        return None
    return {x: rate if rate == "unknown" else residues.of(rate) for x, rate in rates.items()}


def _residues(every: list[Said], residues: Residues) -> Iterator[Any]:
    """Yield what has a meaning in a context, by residues."""
    for said in every:
        try:
            yield residues.said(said)
        except LookupError:
            continue


def _sayings(fact: Claim) -> list[Said]:
    if fact.kind not in KINDS:
        return []
    rights = [0] * len(fact.lhs) if fact.kind == "nonnegative" else map(read, fact.rhs)
    return [(KINDS[fact.kind], read(lhs), rhs) for lhs, rhs in zip(fact.lhs, rights, strict=True)]


def _pairs(table: dict[str, str]) -> list[tuple[str, Form]]:
    return [(name, read(text)) for name, text in table.items()]
