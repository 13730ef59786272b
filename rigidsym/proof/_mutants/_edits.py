"""Changes of definitions that an attacker may make: signs, exchanges, turns and factors."""

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, TypeAlias

from rigidsym.proof.kernel._language import parse

# The name of a definition, and its text: the same definition may stand in many contexts.
Definition: TypeAlias = tuple[str, str]
# The second name of a pair by the first: parts of a complex number or of a point on a circle, and
# components along b and d, or 2 and 3.
_COMPLEX = ((r"(.*)_re(?=\d?$)(.*)", r"\1_im\2"), (r"cos_(.*)", r"sin_\1"))
_AXES = ((r"(.*_)b(.*)", r"\1d\2"), (r"(.*)2(.*)", r"\g<1>3\2"))


class Edit(NamedTuple):
    """A change of one or two definitions.

    `terms` gives each definition's new text as a sum of texts with factors.  `inverse` says what
    the names meant before, in terms of what they mean now.
    """

    kind: str
    terms: tuple[tuple[Definition, tuple[tuple[str, int], ...]], ...]
    inverse: tuple[tuple[str, str], ...] = ()

    @property
    def texts(self) -> dict[Definition, str]:
        """The new text of each changed definition."""
        said = {1: "{}", -1: "-({})"}
        return {
            place: " + ".join(said.get(n, f"{n}*({{}})").format(text) for text, n in terms)
            for place, terms in self.terms
        }

    def __str__(self) -> str:
        return f"{self.kind} {', '.join(name for (name, _), _ in self.terms)}"


def sign(place: Definition) -> Edit:
    """Return the change of a definition's sign."""
    return Edit("-", ((place, ((place[1], -1),)),), ((place[0], f"(-{place[0]})"),))


def turn(re_: Definition, im: Definition) -> Edit:
    """Return the multiplication of a complex number, or a point on a circle, by i."""
    terms = ((re_, ((im[1], -1),)), (im, ((re_[1], 1),)))
    return Edit("i", terms, ((re_[0], im[0]), (im[0], f"(-{re_[0]})")))


def exchange(one: Definition, other: Definition) -> Edit:
    """Return the exchange of two definitions."""
    terms = ((one, ((other[1], 1),)), (other, ((one[1], 1),)))
    return Edit("<->", terms, ((one[0], other[0]), (other[0], one[0])))


def double(place: Definition) -> Edit:
    """Return the change of a definition to twice its value."""
    return Edit("2", ((place, ((place[1], 2),)),), ((place[0], f"({place[0]}/2)"),))


def edits(definitions: Mapping[str, str]) -> list[Edit]:
    """Return the changes of signs, the exchanges and the turns of definitions in a context."""
    found = [sign(place) for place in definitions.items() if place[1] != "0"]
    for name in definitions:
        for other, is_complex in partners(name, definitions):
            one, two = (name, definitions[name]), (other, definitions[other])
            used = {*reach(one[1], definitions), *reach(two[1], definitions)}
            if one[1] != two[1] and not used & {name, other}:  # no definition is about itself
                found.append(exchange(one, two))
                if is_complex:
                    found.append(turn(one, two))
    return found


def alone(definitions: Mapping[str, str]) -> list[Edit]:
    """Return edits inside single definitions: a factor 2, a term's sign, a lost term or factor."""
    found = []
    for place in definitions.items():
        if place[1] != "0":
            found.append(double(place))
        match parse(place[1]):
            case (_, *_, "+" | "-" | "*" | "/" as operator, last) as tree:
                begun = written(tree[0] if len(tree) == 3 else tree[:-2])
                found.append(Edit("lost term of", ((place, ((begun, 1),)),)))
                if other := {"+": "-", "-": "+"}.get(str(operator), ""):
                    other = f"{begun} {other} ({written(last)})"
                    found.append(Edit("sign in", ((place, ((other, 1),)),)))
    return found


def written(tree: Any) -> str:
    """Return an expression as text, with brackets around each part."""
    match tree:
        case (function, "(", *arguments):
            return f"{function}({', '.join(map(written, arguments))})"
        case ("-", operand):
            return f"-({written(operand)})"
        case (base, "**", exponent):
            return f"({written(base)})**{exponent}"
        case (first, *rest):
            pairs = zip(rest[::2], rest[1::2], strict=True)
            return f"({written(first)})" + "".join(f" {x} ({written(y)})" for x, y in pairs)
    return str(tree)


def partners(name: str, definitions: Mapping[str, str]) -> Iterator[tuple[str, bool]]:
    """Yield names that form a pair with a name, and whether as parts of a complex number."""
    for patterns in (_COMPLEX, _AXES):
        for one, two in patterns:
            found = re.fullmatch(one, name)
            if found and (other := found.expand(two)) in definitions:
                yield other, patterns is _COMPLEX


def reach(text: str, definitions: Mapping[str, str]) -> set[str]:
    """Return the names in an expression and in the definitions that it uses."""
    waiting: list[Any] = [parse(text)]
    seen: set[str] = set()
    while waiting:
        match waiting.pop():
            case str(name) if name not in seen:
                seen.add(name)
                if name in definitions:
                    waiting.append(parse(definitions[name]))
            case (*parts,):
                waiting += parts
    return seen
