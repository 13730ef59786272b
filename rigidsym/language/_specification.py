"""The specification: theorems that a ledger must prove under exactly the given hypotheses.

A specification is made of blocks.  A block is a line that names it and clauses below, one a line or
with ``|`` between them; the items of a clause are separated by ``;`` and continue in lines that are
indented further than their clause.

    hypotheses name                      assumptions of several theorems; `under` includes them
    theorem name: its statement in words

    under A B                            the hypotheses, names and conclusions of other blocks
    vectors v w along a b d epsilon      v is v_a, v_b, v_d; epsilon is the handedness of these axes
    vectors v w along 1 2 3              v is v1, v2, v3; these axes are those of the block if it
                                         names no others
    quaternions q                        q is q_0, q_a, q_b, q_d, or q0, q1, q2, q3
    complex z                            z is z_re, z_im
    matrices R                           R is R11, R12 and so on
    derivatives d: x y                   d(x) and d(y), small changes, are dx and dy
    derivatives d_x: y by z0; p by z0 = 1  d_x(y), for each input x of z0, is y_by_z
    write x = a                          x stands for a
    zero a; b                            a = 0, b = 0
    nonzero a; b                         a != 0, b != 0
    nonnegative a; b                     a >= 0, b >= 0
    positive a                           a >= 0 and a != 0
    roots R = a                          R**2 = a and R >= 0; R moves as the square root of a does
    moving x' = a; y' = ?                time derivatives, known or not; other names are constant
    turning z at a; cis(psi) at b        numbers of modulus 1 that turn at rates a and b
    thetas x = theta1(v, q)              x is a theta function, a derivative of one, or part of it
    start a; b                           a = 0, b = 0 at one instant of the motion
    let x = a                            definitions of names
    with x = a                           definitions of names that would be free otherwise
    without a                            a = 0 is not assumed
    formulas s t                         the published sequences s and t hold: names mean that, too
    formulas s: x y                      of the sequence s the formulas for x and y hold
    then a = b; a = sqrt(b); a >= 0      the conclusions
    varied a = b                         the conclusion a = b and its derivatives by all inputs
    enclosed a = b                       a conclusion that balls confirm at points, by a reference
    cases A, B, C                        the conclusion that exactly one of these theorems applies
    applies A B                          the conclusion that these theorems apply

Any clause may be one for several values of what stands in braces, and so may a whole block:

    then for x j = s 1, c 2: v_{x} = e_{j}     v_s = e_1; v_c = e_2

Names that nothing defines are any real numbers, and constant where nothing moves them.  A theorem
without `moving` is about one instant.  `_notation` defines vectors and derivatives by components.
Items with `d_x` hold for each input x.

Expressions are compared as rational functions of the names that a context does not define: by their
values modulo a prime, at a point that is drawn from a hash of the ledger.  Two expressions of
degree n that differ have the same value with a probability of n/2^255.
"""

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from hashlib import sha256
from typing import Any, NamedTuple, TypeAlias

from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    children,
    names,
    to_text,
)
from rigidsym.language._expression import parse as _parse
from rigidsym.language._notation import ZERO, Notation, derivative, pairs

_NAME = re.compile(r"[A-Za-z_]\w*")
_PRIME = 2**255 - 19
# A proved equation, root or sign: "=", "sqrt" or ">=", and both sides.
Statement: TypeAlias = tuple[str, str, str]
# Ledgers and specifications repeat expressions.
parse = cache(_parse)


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
        """The formula as a statement."""
        return "sqrt" if self.how == "root" else "=", self.name, self.text


class Unproved(ValueError):  # noqa: N818 (a verdict rather than an error)
    """Exception for a theorem of the specification that a ledger does not prove."""


@dataclass(slots=True)
class Theorem:
    """One block of a specification, merged with the blocks that it includes.

    The texts are written by components.
    """

    name: str
    title: str = ""
    is_theorem: bool = False
    zero: set[str] = field(default_factory=set)
    roots: dict[str, str] = field(default_factory=dict)
    nonzero: set[str] = field(default_factory=set)
    nonnegative: set[str] = field(default_factory=set)
    moving: dict[str, str] | None = None
    let: dict[str, str] = field(default_factory=dict)
    thetas: dict[str, str] = field(default_factory=dict)
    start: set[str] = field(default_factory=set)
    formulas: list[tuple[str, tuple[str, ...]]] = field(default_factory=list)
    then: list[Statement] = field(default_factory=list)
    enclosed: list[Statement] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)
    applies: list[str] = field(default_factory=list)
    notation: Notation = field(default_factory=Notation)

    def include(self, other: "Theorem") -> None:
        """Add what another block assumes, defines and concludes."""
        for clause in ("zero", "nonzero", "nonnegative"):
            getattr(self, clause).update(getattr(other, clause))
        self.let |= other.let
        self.roots |= other.roots
        self.notation.include(other.notation)
        if other.moving is not None:
            self.moving = (self.moving or {}) | other.moving
        self.formulas += other.formulas
        self.then += other.then
        self.applies += other.applies

    def fill(self, clause: str, content: str) -> None:
        """Add one clause.

        Raises ValueError if there is no such clause.
        """
        match clause:
            case "vectors" | "quaternions" | "complex" | "matrices":
                self.notation.declare(clause, content)
            case "derivatives":
                self.notation.derive(content)
            case "zero" | "nonzero" | "nonnegative" | "start":
                getattr(self, clause).update(self._expressions(content))
            case "write":
                for item in content.split(";"):
                    name, _, text = item.partition("=")
                    self.notation.named[name.strip()] = self.notation.value(parse(text.strip()))
            case "thetas":
                for item in content.split(";"):
                    name, text = item.strip().split(" = ")
                    parts = {f"{name}_re": f"re({text})", f"{name}_im": f"im({text})"}
                    self.thetas |= parts if name in self.notation.named else {name: text}
            case "positive":
                self.nonzero.update(self._expressions(content))
                self.nonnegative.update(self._expressions(content))
            case "moving":
                self.moving = (self.moving or {}) | dict(self._equations(content, "' ="))
            case "roots":
                roots = dict(self._equations(content, " ="))
                self.roots |= roots
                self.zero |= {_square(name, text) for name, text in roots.items()}
                self.nonnegative |= {*roots}
            case "turning":
                for item in content.split(";"):
                    name, _, rate = item.strip().partition(" at ")
                    x, y = map(to_text, self.notation.value(parse(name)))
                    self.fill("zero", f"{y}**2 + {x}**2 - 1")
                    self.fill("moving", f"{x}' = -({rate})*{y}; {y}' = ({rate})*{x}")
            case "let" | "with":
                self.let |= dict(self._equations(content, " ="))
                for name in self.roots.keys() & self.let.keys():  # A root that is defined.
                    self.zero.discard(_square(name, self.roots.pop(name)))
                if self.moving is not None:  # Defined names do not move by themselves.
                    self.moving = {k: x for k, x in self.moving.items() if k not in self.let}
            case "without":
                self.zero -= {*self._expressions(content)}
            case "formulas":
                sequences, _, wanted = content.partition(":")
                every = tuple(self.notation.all_of(wanted))
                self.formulas += [(name, every) for name in sequences.split()]
            case "then":
                self.then += self._statements(content)
            case "varied":
                self.then += self._statements(content)
                equations = (item.partition(" =") for item in content.split(";"))
                columns = (f"d_x({left}) = d_x({right})" for left, _, right in equations)
                self.then += self._statements("; ".join(columns))
            case "enclosed":
                self.enclosed += self._statements(content)
            case "cases":
                self.cases += [name.strip() for name in content.split(",")]
            case "applies":
                self.applies += content.split()
            case _:
                raise ValueError(f"specification: {clause!r} is no clause")

    def rates(self, values: "Values") -> dict[str, str]:
        """Return the rates, those of roots included, where they are not constant."""
        moving = {**(self.moving or {})}
        for root in self.roots.keys() - moving.keys() if self.moving is not None else ():
            rate = f"D({self.roots[root]})/(2*{root})"
            if values.of(parse(rate)):
                moving[root] = rate
        return moving

    def _components(self, content: str, sign: str) -> Iterator[tuple[Expression, Expression]]:
        """Yield both sides of each item by components, for each input if it has `d_x`."""
        for item in filter(str.strip, content.split(";")):
            left, _, right = (side.strip() for side in item.partition(sign))
            for x in self.notation.inputs if "d_x(" in item else [""]:
                sides = (self.notation.value(parse(side or "0"), x) for side in (left, right))
                yield from pairs(*sides)

    def _expressions(self, content: str) -> Iterator[str]:
        return (to_text(left) for left, _ in self._components(content, "="))

    def _equations(self, content: str, sign: str) -> Iterator[tuple[str, str]]:
        """Yield names and what they are, except d_x of what the input x does not change."""
        for left, right in self._components(content.replace("?", "unknown"), sign):
            if left != ZERO:
                yield to_text(left), "?" if right == Name("unknown") else to_text(right)

    def _statements(self, content: str) -> Iterator[Statement]:
        for item in content.split(";"):
            relation = ">=" if ">=" in item else "="
            for left, right in self._components(item, relation):
                match right:
                    case Call("sqrt", (root,)):
                        yield "sqrt", to_text(left), to_text(root)
                    case _:
                        yield relation, to_text(left), to_text(right)


def _square(root: str, text: str) -> str:
    return to_text(parse(f"{root}**2 - ({text})"))


def read(text: str) -> dict[str, Theorem]:
    """Parse the blocks of a specification.

    Raises ValueError for a malformed block.
    """
    blocks: dict[str, Theorem] = {}
    lines = (line.partition("#")[0].rstrip() for line in text.splitlines())
    texts = filter(None, re.split(r"\n+(?=\S)", "\n".join(lines).strip()))
    for lines_of_block in (one for each in texts for one in _repeated(each)):
        head, *clauses = re.split(r" \| |\n {4}(?=\S)", lines_of_block)
        kind, _, rest = head.strip().partition(" ")
        name, _, title = (part.strip() for part in rest.partition(":"))
        if kind not in ("hypotheses", "theorem") or not _NAME.fullmatch(name) or name in blocks:
            raise ValueError(f"specification: {head!r}: no block, or one of this name is there")
        block = Theorem(name, title, kind == "theorem")
        for clause in (one for each in clauses for one in _repeated(" ".join(each.split()))):
            word, _, content = clause.partition(" ")
            if word == "under":
                for other in content.split():
                    block.include(blocks[other])
                continue
            try:
                block.fill(word, content)
            except (ValueError, SyntaxError) as error:
                raise ValueError(f"specification: {name}: {word}: {error}") from None
        blocks[name] = block
    return blocks


def _repeated(text: str) -> Iterator[str]:
    """Yield a block or a clause once for each of the values that its ``for`` gives to names."""
    repeated = re.fullmatch(r"(\w+) for ([\w ]+) = ([^:]+): (.*)", text, re.DOTALL)
    if not repeated:
        yield text
        return
    word, letters, rows, rest = repeated.groups()
    for row in rows.split(","):
        filled = rest
        for letter, value in zip(letters.split(), row.split(), strict=True):
            filled = filled.replace(f"{{{letter}}}", value)
        yield f"{word} {filled}"


def written(statement: Statement) -> str:
    """Format a statement as text."""
    relation, lhs, rhs = statement
    return f"{lhs} = sqrt({rhs})" if relation == "sqrt" else f"{lhs} {relation} {rhs}"


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
            try:
                lack = next(proved.lacks(theorem), "")
            except Unproved as error:
                lack = str(error)
            if lack:
                raise Unproved(f"theorem {theorem.name} ({theorem.title}): {lack}")
        if name := next(proved.undetermined(theorems(specification).values()), ""):
            raise Unproved(f"the published formula {name} is determined by no theorem")
    except (LookupError, TypeError, AttributeError, SyntaxError) as error:
        raise Unproved(f"its published formulas are not readable: {error}") from None


class Meaningless(ValueError):  # noqa: N818 (so is this)
    """Exception for an expression that has no value in a context."""


class Values:
    """Values of expressions in a context, modulo a prime.

    Values of names that the context does not define are drawn from a seed.
    """

    def __init__(
        self,
        seed: str,
        generators: Iterable[str],
        definitions: Mapping[str, str],
        rates: Mapping[str, str] | None,
    ) -> None:
        self.seed, self.rates = seed, rates
        self.known: dict[Expression, int] = {Name(x): self._drawn(x) for x in generators}
        self.definitions = {x: text for x, text in definitions.items() if Name(x) not in self.known}
        self._begun: set[Expression] = set()

    def _drawn(self, name: str) -> int:
        return int(sha256(f"{self.seed} {name}".encode()).hexdigest(), 16) % _PRIME

    def of(self, tree: Expression) -> int:
        """Return the value of an expression.

        Raises Meaningless if it has none.
        """
        match tree:
            case Number(number):
                return number % _PRIME
            case Name() | Call("D", (Name(),)):
                if tree not in self.known:
                    self.known[tree] = self._first(tree)
                return self.known[tree]
            case Call("neg", (operand,)):
                return -self.of(operand) % _PRIME
            case Call("D", (operand,)):
                return self.of(derivative(operand, _rate))
            case Operation("**", base, Number(exponent)):
                return pow(self.of(base), exponent, _PRIME)
            case Operation(symbol, left, right):
                x, y = self.of(left), self.of(right)
                if symbol == "/" and y:
                    return x * pow(y, -1, _PRIME) % _PRIME
                if symbol in "+-*":
                    return (x + y if symbol == "+" else x - y if symbol == "-" else x * y) % _PRIME
        raise Meaningless(f"{to_text(tree)} has no meaning in the ledger")

    def _first(self, tree: Expression) -> int:
        """Return the value of a defined name, or of the rate of a name."""
        (name,) = names(tree)
        if tree in self._begun:  # Inside its own definition a name means nothing.
            raise Meaningless(f"{name} is defined by itself")
        self._begun.add(tree)
        if name in self.definitions:
            meaning = parse(self.definitions[name])
            return self.of(meaning if tree == Name(name) else derivative(meaning, _rate))
        if tree == Name(name) or self.rates is None or Name(name) not in self.known:
            raise Meaningless(f"{to_text(tree)} has no meaning in the ledger")
        rate = self.rates.get(name, "0")
        return self._drawn(f"D({name})") if rate == "?" else self.of(parse(rate))

    def same(self, left: str, right: str) -> bool:
        """Return whether two expressions have a meaning, and the same one."""
        try:
            return self.of(parse(left)) == self.of(parse(right))
        except Meaningless:
            return False

    def said(self, statement: Statement) -> tuple[str, int, int]:
        """Return a statement by values, an equation by the difference of its sides up to sign."""
        relation, left, right = statement
        x, y = self.of(parse(left)), self.of(parse(right))
        if relation == "=":
            return relation, min((x - y) % _PRIME, (y - x) % _PRIME), 0
        return relation, x, y


def _names(tree: Expression, *, rates: bool) -> set[str]:
    """Return the names in an expression whose rates it has, or the others."""
    match tree:
        case Call("D", (operand,)):
            return {*names(operand)} if rates else set()
        case Name(name):
            return set() if rates else {name}
    return set().union(*(_names(part, rates=rates) for part in children(tree)))


def _reached(found: set[str], from_: Mapping[str, set[str]]) -> set[str]:
    """Return names, those that they are computed from, and so on."""
    waiting = [*found]
    while waiting:
        new = from_.get(waiting.pop(), set()) - found
        found |= new
        waiting += new
    return found


def _rate(name: str) -> Expression:
    return Call("D", (Name(name),))


class Proved:
    """The statements that a ledger claims to prove.

    Checkers decide whether the proofs hold.
    """

    def __init__(self, ledger: Mapping[str, Any]) -> None:
        self.contexts = {context["name"]: context for context in ledger["contexts"]}
        self.facts = {fact["id"]: fact for fact in ledger["facts"]}
        self.proved = [fact for fact in ledger["facts"] if fact["grade"] == "PROVED"]
        self.sequences = sequences(ledger)
        self._seed = sha256(json.dumps(ledger).encode()).hexdigest()
        self._models: dict[str, list[str]] = {}
        self._stated: dict[str, list[Statement]] = {}
        self._partitions: set[tuple[str, ...]] = set()
        self._enclosed: dict[str, list[Statement]] = {}
        for fact in ledger["facts"]:
            if fact["grade"] == "ENCLOSED":
                sides = zip(fact["lhs"], fact["rhs"], strict=True)
                self._enclosed.setdefault(fact["context"], []).extend(("=", *x) for x in sides)
        for fact in self.proved:
            place, kind = fact["context"], fact["kind"]
            relation = {"equal": "=", "root": "sqrt", "nonnegative": ">="}.get(kind)
            if kind == "model":
                self._models.setdefault(place, []).extend(fact["rhs"])
            elif kind == "partition":
                self._partitions.add((place, *fact["rhs"]))
            elif relation:
                right = ["0"] * len(fact["lhs"]) if relation == ">=" else fact["rhs"]
                sides = zip(fact["lhs"], right, strict=True)
                self._stated.setdefault(place, []).extend((relation, *pair) for pair in sides)

    def lacks(self, theorem: Theorem) -> Iterator[str]:
        """Yield one sentence for each part of a theorem that the ledger does not prove."""
        if theorem.name not in self.contexts:
            yield "its hypotheses are not in the ledger"
            return
        try:
            yield from self._lacks(theorem)
        except Meaningless as error:
            yield str(error)

    def _lacks(self, theorem: Theorem) -> Iterator[str]:
        values = self.values(theorem)
        yield from self._unlike(theorem, values)
        formulas = [f for part in theorem.formulas for f in self._formulas(*part)]
        yield from self._unsaid(theorem, values, formulas)
        facts = self.holding(theorem.name, values)
        readings = {
            (name, text)
            for place in self.modelled(theorem.name)
            for name, text in self.contexts[place]["reading"].items()
        }
        for formula in formulas:
            if formula.how == "reading":
                holds = (formula.name, formula.text) in readings
            else:
                holds = _holds(formula.said, facts, values)
            if not holds:
                yield f"its formula {written(formula.said)} is not proved under its hypotheses"
        for statement in theorem.then:
            if not _holds(statement, facts, values):
                yield f"{written(statement)} is not proved under its hypotheses"
        enclosed = {*map(values.said, self._enclosed.get(theorem.name, ()))}
        for statement in theorem.enclosed:
            if not _holds(statement, enclosed, values):
                yield f"{written(statement)} is not enclosed under its hypotheses"
        for other in theorem.applies:
            if other not in self.modelled(theorem.name):
                yield f"theorem {other} is not proved to apply"
        if theorem.cases and (theorem.name, *theorem.cases) not in self._partitions:
            yield f"exactly one of {', '.join(theorem.cases)} is not proved"

    def undetermined(self, specified: Iterable[Theorem]) -> Iterator[str]:
        """Yield the published formulas that no theorem determines.

        A theorem determines the names in its equations, those that it defines, those that are
        free in its hypotheses, and what these are computed from.  A rate determines a
        name, and what that is computed from, if another theorem is about its start.
        """
        determined, moving, starting = set(), set(), set()
        for theorem in specified:
            formulas = [
                (part[0], formula) for part in theorem.formulas for formula in self._formulas(*part)
            ]
            from_: dict[str, set[str]] = {}
            computed = [(x.name, x.text) for _, x in formulas if x.how != "reading"]
            rates = [pair for pair in (theorem.moving or {}).items() if pair[1] != "?"]
            for name, text in (*computed, *theorem.let.items(), *rates):
                from_.setdefault(name, set()).update(names(parse(text)))
            for related in (set(names(parse(text))) for text in theorem.zero):
                for name in related:
                    from_.setdefault(name, set()).update(related)
            sides = [parse(side) for _, *both in theorem.then for side in both]
            free = {*self.contexts[theorem.name]["generators"]}
            said = set().union(theorem.let, free, *(_names(side, rates=False) for side in sides))
            known = _reached(said, from_)
            turned = _reached(set().union(*(_names(side, rates=True) for side in sides)), from_)
            for sequence, formula in formulas:
                key = f"{sequence}: {formula.name}"
                if formula.name in known or formula.how == "reading":
                    determined.add(key)
                if formula.name in turned:
                    moving.add(key)
                if theorem.moving is None:
                    starting.add(key)
        for sequence, entries in self.sequences.items():
            for key in (f"{sequence}: {self.formula(entry).name}" for entry in entries):
                if key not in determined | (moving & starting):
                    yield key

    def values(self, theorem: Theorem) -> Values:
        """Return the values of expressions in the context of a theorem.

        Names that only the theorem, or a context that this one is a model of, defines mean that.
        """
        context = self.contexts[theorem.name]
        definitions = {**theorem.let}
        for place in reversed(self.modelled(theorem.name)):
            definitions |= self.contexts[place]["definitions"]
        return Values(self._seed, context["generators"], definitions, context["rates"])

    def holding(self, name: str, values: Values) -> set[tuple[str, int, int]]:
        """Return the values of what is proved in a context.

        Definitions of other contexts that it is a model of are proved, too.
        """
        found = set()
        for place in self.modelled(name):
            definitions = self.contexts[place]["definitions"] if place != name else {}
            equations = [("=", *pair) for pair in definitions.items()]
            for statement in self._stated.get(place, []) + equations:
                try:
                    found.add(values.said(statement))
                except ValueError:
                    continue
        return found

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

    def _formulas(self, sequence: str, wanted: tuple[str, ...]) -> list[Published]:
        """Return the formulas of a published sequence, or only the wanted ones.

        Raises Unproved if one is missing, or is about itself.
        """
        if sequence not in self.sequences:
            raise Unproved(f"the formula sequence {sequence} is not published")
        found = [self.formula(entry) for entry in self.sequences[sequence]]
        if missing := {*wanted} - {formula.name for formula in found}:
            raise Unproved(f"the formula sequence {sequence} has no formula for {min(missing)}")
        for formula in found:
            if formula.how != "reading" and formula.name in names(parse(formula.text)):
                raise Unproved(f"{sequence}: the formula {written(formula.said)} is about itself")
        return [formula for formula in found if not wanted or formula.name in wanted]

    def _unlike(self, theorem: Theorem, values: Values) -> Iterator[str]:
        """Yield the differences between the hypotheses of a theorem and those of its context."""
        context = self.contexts[theorem.name]
        if (context["rates"] is None) != (theorem.moving is None):
            yield "it is about one instant, or about a motion, where the ledger has the other"
        columns = {"zero": "relations", "nonzero": "units"}
        columns |= {name: name for name in ("nonnegative", "start")}
        for clause, column in columns.items():
            here, there = (
                {_hypothesis(clause, text, values): text for text in texts}
                for texts in (getattr(theorem, clause), context[column])
            )
            yield from _differences(clause, here, there)
        here, there = (
            {
                f"{name} {text if text == '?' else values.of(parse(text))}": f"{name}' = {text}"
                for name, text in rates.items()
            }
            for rates in (theorem.rates(values), context["rates"] or {})
        )
        yield from _differences("moving", here, there)
        here, there = (
            {f"{name} = {text}": f"{name} = {text}" for name, text in thetas.items()}
            for thetas in (theorem.thetas, context["thetas"])
        )
        yield from _differences("thetas", here, there)

    def _unsaid(
        self, theorem: Theorem, values: Values, formulas: Iterable[Published]
    ) -> Iterator[str]:
        """Yield the differences between the definitions of a theorem and those of its context.

        Each name of the theorem or of its formulas has to be defined in the theorem, published, or
        free.
        """
        for name, text in theorem.let.items():
            if not values.same(name, text):
                there = values.definitions.get(name, "free")
                yield f"let {name} = {text}: in the ledger it is {there}"
        computed = [formula for formula in formulas if formula.how != "reading"]
        said = {*theorem.let, *(formula.name for formula in computed)}
        mentioned = {
            name
            for text in (
                *(theorem.zero | theorem.nonzero | theorem.nonnegative | theorem.start),
                *theorem.thetas.values(),
                *(text for text in (theorem.moving or {}).values() if text != "?"),
                *theorem.let.values(),
                *(side for _, *sides in theorem.then + theorem.enclosed for side in sides),
                *(formula.text for formula in computed),
            )
            for name in names(parse(text))
        }
        for name in sorted((mentioned - said) & values.definitions.keys()):
            yield f"{name} = {values.definitions[name]}: the ledger has this name beyond it"


def _differences(clause: str, here: Mapping[str, str], there: Mapping[str, str]) -> Iterator[str]:
    """Yield what only the ledger assumes, and what only the theorem does."""
    for key in sorted(there.keys() - here.keys()):
        yield f"{clause} {there[key]}: the ledger assumes this beyond it"
    for key in sorted(here.keys() - there.keys()):
        yield f"{clause} {here[key]}: this is not assumed in the ledger"


def _hypothesis(clause: str, text: str, values: Values) -> str:
    """Return the value of what is zero, nonzero or nonnegative; signs count for the last alone."""
    value = values.of(parse(text))
    return str(value if clause == "nonnegative" else min(value, -value % _PRIME))


def _holds(statement: Statement, facts: set[tuple[str, int, int]], values: Values) -> bool:
    said = values.said(statement)
    return said in facts or said[:2] == ("=", 0)
