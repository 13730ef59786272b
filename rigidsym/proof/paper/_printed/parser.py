"""Recursive-descent parser of the LaTeX that the paper prints.

    display   = {statement | words | "," | ";"}
    statement = sum {relation sum}
    sum       = [sign] product {sign product}
    product   = factor {["/"] factor}
    factor    = quantity ["^" exponent]

Adjacent factors form a product; a function without brackets has one quantity as its argument.  A
name before (t) or a number in brackets is evaluated at that time, a name before a list is applied
to it, and a name before any other brackets is a factor.

The sides of a statement are expressions of `rigidsym.language`.  Other forms are calls: `matrix`
of four entries, `bracket`, `at` a time, `d` of a differential, `integral` of a product with a
differential, `pm` of a quantity of either sign, `abs`, `nabla`, `partial`.  The imaginary unit is
the name `imaginary`, and a bar or a star is part of a name: `Rbar`, `y_star`.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

from rigidsym.language._expression import Call, Expression, Name, Number, Operation


class PrintError(ValueError):
    """Error for a printed formula that cannot be parsed or translated."""


@dataclass(frozen=True, slots=True)
class Statement:
    """Expressions joined by relations such as = or <=.

    The relations are `=`, `<=`, `>=`, `<`, `>`, `!=`, `<->` and `:`.
    """

    sides: tuple[Expression, ...]
    relations: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Words:
    """Words that are printed between formulas."""

    text: str


Display: TypeAlias = tuple[Statement | Words, ...]


_TOKEN = re.compile(
    r"\\text\{[^{}]*\}|\\(?:mathrm|operatorname|begin|end)\{[A-Za-z]+\}|\\mathrm\s*[A-Za-z]"
    r"|\\left\||\\right\||\\[A-Za-z]+|\\[ ,;:!]|\\\\|[A-Za-z]|[0-9]|[-+=<>/^_&{}()\[\]|,;:]"
)
_ROOM = {r"\ ", r"\,", r"\;", r"\:", r"\!", r"\left", r"\right"}


def tokens(latex: str) -> Iterator[str]:
    """Yield the tokens of a LaTeX formula.

    Raises PrintError for anything else.
    """
    place = 0
    while place < len(latex):
        if latex[place].isspace():
            place += 1
            continue
        found = _TOKEN.match(latex, place)
        if not found:
            raise PrintError(f"{latex[place : place + 20]!r}: not a token of printed LaTeX")
        place = found.end()
        if found[0] not in _ROOM:
            yield found[0]


RELATIONS = {
    "=": "=",
    r"\le": "<=",
    r"\ge": ">=",
    "<": "<",
    ">": ">",
    r"\ne": "!=",
    r"\leftrightarrow": "<->",
    ":": ":",
}
SIGNS = {"+": "+", "-": "-", r"\pm": "pm"}
LETTERS = (
    *("alpha", "beta", "gamma", "delta", "zeta", "vartheta", "kappa", "mu", "xi", "sigma", "phi"),
    *("chi", "Omega", "Pi", "dagger"),
)
GREEK = frozenset(f"\\{name}" for name in LETTERS)
FUNCTIONS = frozenset([r"\cos", r"\sin", r"\tan", r"\exp", r"\det"])
NAMED = frozenset(["sn", "cn", "dn", "am", "sgn"])
PREFIXES = {r"\nabla": "nabla", r"\partial": "partial", "d": "d"}
# What opens a form, the call that it makes ("" for none), and what separates and closes its parts.
BRACKETS = {
    "(": ("", (")",)),
    "|": ("abs", ("|",)),
    r"\left|": ("abs", (r"\right|",)),
    "[": ("bracket", (",", "]")),
    r"\begin{pmatrix}": ("matrix", ("&", "\\\\", "&", r"\end{pmatrix}")),
}


@lru_cache
def parse(latex: str) -> Display:
    """Parse a displayed formula into statements and words.

    Raises PrintError for anything else.
    """
    reader = _Reader(latex)
    return _cases(reader.display())


def _cases(found: list[Statement | Words]) -> Display:
    """Add the missing left side to the last case of a definition by cases."""
    for k, (piece, after) in enumerate(zip(found, [*found[1:], None], strict=False)):
        otherwise = isinstance(after, Words) and after.text == "otherwise"
        if otherwise and isinstance(piece, Statement) and not piece.relations:
            stated = [p for p in found[:k] if isinstance(p, Statement)]
            left = next(p.sides[0] for p in reversed(stated) if p.relations[:1] == ("=",))
            found[k] = Statement((left, *piece.sides), ("=",))
    return tuple(found)


class _Reader:
    """Recursive-descent parser of one displayed formula."""

    def __init__(self, latex: str) -> None:
        self.latex, self.tokens, self.place = latex, [*tokens(latex), ""], 0

    @property
    def next(self) -> str:
        """The next token."""
        return self.tokens[self.place]

    def take(self, due: str = "") -> str:
        """Return the next token and advance.

        Raises PrintError if another token is due.
        """
        if (due and self.next != due) or not self.next:
            raise PrintError(
                f"{self.latex!r}: {self.next or 'the end'!r} stands where {due or 'more'!r} is due"
            )
        self.place += 1
        return self.tokens[self.place - 1]

    def display(self) -> list[Statement | Words]:
        """Parse the whole displayed formula."""
        found: list[Statement | Words] = []
        while self.next:
            if self.next in ",;":
                self.take()
            elif self.next.startswith(r"\text{"):
                found.append(Words(self.take()[len(r"\text{") : -1].strip()))
            else:
                found.append(self.statement())
                if self.next and self.next not in ",;" and not self.next.startswith(r"\text{"):
                    self.take(",")
        return found

    def statement(self) -> Statement:
        """Parse a statement, which is expressions joined by relations."""
        sides, relations = [self.sum()], []
        while self.next in RELATIONS:
            relations.append(RELATIONS[self.take()])
            sides.append(self.sum())
        return Statement(tuple(sides), tuple(relations))

    def sum(self) -> Expression:
        """Parse a sum of signed terms."""
        total: Expression | None = None
        while total is None or self.next in SIGNS:
            sign = SIGNS[self.take()] if self.next in SIGNS else "+"
            alone = sign == "pm" and self.next.startswith(r"\text{")
            term = Number(1) if alone else self.product()
            if sign == "pm":
                term = Call("pm", (term,))
            if total is None:
                total = Call("neg", (term,)) if sign == "-" else term
            else:
                total = Operation("-" if sign == "-" else "+", total, term)
        return total

    def product(self) -> Expression:
        """Parse a product of adjacent factors and quotients."""
        total = self.factor()
        while self.next == "/" or self.begins():
            operator = "/" if self.next == "/" else "*"
            if operator == "/":
                self.take()
            total = Operation(operator, total, self.factor())
        return total

    def begins(self) -> bool:
        """Return whether the next token begins a factor."""
        token = self.next
        return (
            token.isalnum()
            or token in ("(", "[", r"\left|", r"\frac", r"\tfrac", r"\sqrt", r"\int", r"\mathbb")
            or token in (r"\dot", r"\bar", r"\nabla", r"\partial")
            or token in GREEK | FUNCTIONS
            or token.startswith((r"\mathrm", r"\operatorname", r"\begin"))
        )

    def factor(self) -> Expression:
        """Parse a quantity with an optional exponent."""
        return self.power(self.quantity())

    def power(self, base: Expression) -> Expression:
        """Parse the exponent after a base, if there is one."""
        if self.next != "^":
            return base
        self.take()
        return Operation("**", base, self.argument())

    def argument(self) -> Expression:
        """Parse one argument of a LaTeX command.

        It is a group in braces, or one token.
        """
        if self.next != "{":
            return self.letter() if not self.next.isdigit() else Number(int(self.take()))
        self.take()
        found = self.sum()
        self.take("}")
        return found

    def quantity(self) -> Expression:
        """Parse a number, a symbol, a function call or a bracketed expression."""
        token = self.next
        if token in BRACKETS:
            return self.enclosed()
        if name := self.function():
            return self.applied(name)
        if token in PREFIXES:
            self.take()
            return Call(PREFIXES[token], (self.symbol(),))
        match token:
            case r"\frac" | r"\tfrac":
                self.take()
                return Operation("/", self.argument(), self.argument())
            case r"\int":
                self.take()
                return Call("integral", (self.product(),))
            case r"\sqrt":
                self.take()
                return Call("sqrt", (self.argument(),))
        if not token.isdigit():
            return self.symbol()
        digits = self.take()
        while self.next.isdigit():
            digits += self.take()
        return Number(int(digits))

    def enclosed(self) -> Expression:
        """Parse an expression in brackets.

        It is a sum, an absolute value, a Lie bracket or a matrix.
        """
        name, due = BRACKETS[self.take()]
        parts = []
        for token in due:
            parts.append(self.sum())
            self.take(token)
        return Call(name, tuple(parts)) if name else parts[0]

    def function(self) -> str:
        """Return the name of the next token if it is a function, else ""."""
        token = self.next
        name = token.rpartition("{")[2].rstrip("}").removeprefix("\\")
        known = token in FUNCTIONS or (token.endswith("}") and name in NAMED)
        return name if known or (token == r"\Pi" and self.tokens[self.place + 1] == "(") else ""

    def applied(self, name: str) -> Expression:
        """Parse the exponent and the arguments of a function.

        sn^2 u is (sn u)^2.
        """
        self.take()
        exponent = None
        if self.next == "^":
            self.take()
            exponent = self.argument()
        inverse = exponent == Call("neg", (Number(1),))
        arguments = self.list() if self.next == "(" else (self.quantity(),)
        found = Call(f"arc{name}" if inverse else name, arguments)
        return found if inverse or exponent is None else Operation("**", found, exponent)

    def list(self) -> tuple[Expression, ...]:
        """Parse a list of arguments in brackets.

        A comma, a semicolon or a bar separates them.
        """
        self.take("(")
        found = [self.sum()]
        while self.next in (",", ";", "|"):
            self.take()
            found.append(self.sum())
        self.take(")")
        return tuple(found)

    def symbol(self) -> Expression:
        """Parse a symbol with its indices and its argument, if it has one."""
        found = self.letter()
        bare = found.arguments[0] if isinstance(found, Call) and found.function == "D" else found
        if isinstance(bare, Name):
            named = Name(bare.name + self.below() + self.star())
            found = Call("D", (named,)) if found is not bare else named
        if self.next != "(":
            return found
        after = self.tokens[self.place + 1 : self.place + 3]
        if after[1:] == [")"] and (after[0] == "t" or after[0].isdigit()):
            (time,) = self.list()
            return Call("at", (found, time))
        return self.list_of(found)

    def list_of(self, found: Expression) -> Expression:
        """Parse a name that is applied to several arguments.

        One sum in brackets is left as a factor.
        """
        start = self.place
        arguments = self.list()
        if len(arguments) > 1 and isinstance(found, Name):
            return Call(found.name, arguments)
        self.place = start
        return found

    def letter(self) -> Expression:
        """Parse a Latin or Greek letter, possibly with a dot or a bar."""
        token = self.take()
        if token in (r"\dot", r"\bar"):
            inner = self.group()
            base = inner.name if isinstance(inner, Name) else ""
            return Call("D", (inner,)) if token == r"\dot" else Name(f"{base}bar")
        if token == r"\mathbb":
            return Name(self.take())
        if token.startswith(r"\mathrm") and token[-1] == "i":
            return Name("imaginary")
        if token in GREEK or (token.isalpha() and token.isascii()):
            return Name(token.removeprefix("\\"))
        raise PrintError(f"{self.latex!r}: {token!r} stands where a quantity is due")

    def group(self) -> Expression:
        """Parse a letter with or without braces."""
        if self.next != "{":
            return self.letter()
        self.take()
        found = self.letter()
        self.take("}")
        return found

    def below(self) -> str:
        """Parse a subscript, if there is one."""
        if self.next != "_":
            return ""
        self.take()
        if self.next != "{":
            return f"_{self.take()}"
        self.take()
        index = ""
        while self.next != "}":
            index += self.take()
        self.take()
        return f"_{index}"

    def star(self) -> str:
        """Parse a star in an exponent, if there is one.

        The rest of the exponent is left.
        """
        ahead = self.tokens[self.place : self.place + 3]
        if ahead[:2] == ["^", r"\star"]:
            self.place += 2
            return "_star"
        if ahead == ["^", "{", r"\star"]:
            del self.tokens[self.place + 2]
            return "_star"
        return ""
