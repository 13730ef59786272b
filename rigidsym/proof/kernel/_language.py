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

_NATURAL = r"(?:0|[1-9][0-9]{0,999}+)(?![A-Za-z_0-9])"
_TOKEN = rf"{_NATURAL}|[A-Za-z_][A-Za-z_0-9]*+|\*\* *{_NATURAL}|[-+*/(),]"
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
    if not isinstance(text, str) or len(text) > 20_000 or not _TEXT.fullmatch(text):
        raise KernelError(f"{text!a:.80} is not an expression")
    tokens = ["", *reversed(re.findall(_TOKEN, text))]  # the next one is the last
    tree = _chain(tokens, 0, 50)
    if tokens != [""]:
        raise KernelError(f"{text!a:.80} is not an expression: it ends before {tokens[-1]!r}")
    return tree


def _chain(tokens: list[str], binding: int, room: int) -> Tree:
    """Parse a chain of operators with a precedence above `binding`."""
    tree = _factor(tokens, room)
    while (binds := _BINDS.get(tokens[-1], 0)) > binding:
        begun = tree if isinstance(tree, tuple) and _BINDS.get(tree[1]) == binds else (tree,)
        tree = (*begun, tokens.pop(), _chain(tokens, binds, room))
    return tree


def _factor(tokens: list[str], room: int) -> Tree:
    """Parse a sign with its factor, or a quantity with its power."""
    if room < 0:
        raise KernelError("not an expression: more than 50 brackets and signs are open")
    if tokens[-1] == "-":
        return tokens.pop(), _factor(tokens, room - 1)
    base: Tree = tokens.pop() if is_name(tokens[-1]) else ""
    if tokens[-1] == "(":
        inside: list[Tree] = []
        while not inside or (base and tokens[-1] == ","):
            tokens.pop()
            inside.append(_chain(tokens, 0, room - 1))
        if tokens.pop() != ")":
            raise KernelError(f"not an expression: a bracket after {base!r} is not closed")
        base = (base, "(", *inside) if base else inside[0]
    elif not base:
        if not (token := tokens.pop()).isdigit():
            raise KernelError(f"not an expression: {token!r} stands where a quantity is due")
        base = int(token)
    return (base, "**", int(tokens.pop()[2:])) if tokens[-1].startswith("**") else base
