"""Grammar and parser of all expressions in a ledger.

    expression = term (("+" | "-") term)*
    term       = factor (("*" | "/") factor)*
    factor     = "-" factor | power
    power      = quantity ["**" natural]
    quantity   = natural | name | name "(" expression ("," expression)* ")" | "(" expression ")"
    natural    = "0" | a digit from 1 to 9 and at most 999 more digits
    name       = ASCII letters, digits and "_", no digit first; none of Python's keywords

Spaces may stand between these, nothing else may.  A text has at most 20,000 characters, and at most
50 brackets and signs are open at a time.  Python reads such a text in the same way.
"""

import re
from functools import cache
from keyword import iskeyword
from typing import Any, TypeAlias

LONGEST, DEEPEST = 20_000, 50
_NAME = r"[A-Za-z_][A-Za-z_0-9]*+"
_TOKEN = rf"(?:0|[1-9][0-9]{{0,999}}+)(?![A-Za-z_0-9])|{_NAME}|\*\*|[-+*/(),]"
_TEXT = re.compile(rf"(?:{_TOKEN})(?: *+(?:{_TOKEN}))*+")
_BINDS = {"+": 1, "-": 1, "*": 2, "/": 2}
# A number, a name, or tokens: ("-", x), (x, "**", 2), ("f", "(", x, y), (x, "+", y, "-", z).
Tree: TypeAlias = int | str | tuple[Any, ...]


class KernelError(ValueError):
    """Error for an expression, context, fact or certificate that the kernel refuses."""


def is_name(text: str) -> bool:
    """Return whether a text is a valid name."""
    return text.isascii() and text.isidentifier() and not iskeyword(text)


@cache
def parse(text: str) -> Tree:
    """Parse an expression into a syntax tree, or raise KernelError."""
    if not isinstance(text, str) or len(text) > LONGEST:
        raise KernelError(f"{text!a:.80}: not a text of at most {LONGEST} characters")
    if not _TEXT.fullmatch(text):
        raise KernelError(f"{text!a:.80}: not an expression: made of something else")
    tokens = ["", *reversed(re.findall(_TOKEN, text))]  # the next one is the last
    try:
        tree = _chain(tokens, 0, DEEPEST)
        _take(tokens, "")
    except KernelError as error:
        raise KernelError(f"{text!r:.80}: not an expression: {error}") from None
    return tree


def _chain(tokens: list[str], binding: int, room: int) -> Tree:
    """Parse a chain of operators with a precedence above `binding`."""
    tree = _factor(tokens, room)
    while (binds := _BINDS.get(tokens[-1], 0)) > binding:
        begun = tree if isinstance(tree, tuple) and _BINDS.get(tree[1]) == binds else (tree,)
        tree = (*begun, tokens.pop(), _chain(tokens, binds, room))
    return tree


def _factor(tokens: list[str], room: int) -> Tree:
    if room < 0:
        raise KernelError(f"more than {DEEPEST} brackets and signs are open")
    if tokens[-1] == "-":
        return tokens.pop(), _factor(tokens, room - 1)
    base = _quantity(tokens, room)
    return (base, tokens.pop(), _natural(tokens)) if tokens[-1] == "**" else base


def _quantity(tokens: list[str], room: int) -> Tree:
    name = tokens.pop() if is_name(tokens[-1]) else ""
    if tokens[-1] != "(":
        return name or _natural(tokens)
    inside: list[Tree] = []
    while not inside or (name and tokens[-1] == ","):
        _take(tokens, "," if inside else "(")
        inside.append(_chain(tokens, 0, room - 1))
    _take(tokens, ")")
    return (name, "(", *inside) if name else inside[0]


def _natural(tokens: list[str]) -> int:
    if not (token := tokens.pop()).isdigit():
        raise KernelError(f"{token!r} stands where a quantity is due")
    return int(token)


def _take(tokens: list[str], due: str) -> None:
    if (token := tokens.pop()) != due:
        raise KernelError(f"{token!r} stands where {due!r} is due")
