r"""Conversion of LaTeX formulas to one line of plain text for terminals.

Fractions are written with a stroke, in brackets where they need them, matrices row by row; indices
and powers are small where all their characters have a small form.

>>> print(in_unicode(r"\dot\Omega_1=\frac{c_2-c_3}{c_1}\Omega_2\Omega_3,\ \sqrt{1-\mu^2}"))
Ω̇₁=((c₂-c₃)/c₁)Ω₂Ω₃, √(1-μ²)
>>> print(in_unicode(r"y=\frac{\dot q_0}{2\sqrt s}"))
y=q̇₀/(2√s)
"""

import re
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass

# Brackets around a fraction, which go where nothing stands beside it.
_OPEN, _CLOSE = "\ue000", "\ue001"
_BARE = [
    re.compile(rf"(^|[=(\[,;|] ?){_OPEN}([^{_OPEN}{_CLOSE}]*){_CLOSE}($|[=)\],;|])"),
] * 2
# A letter with its accents and small characters, or a number.
_SYMBOL = re.compile(r"(?:\d+|\w[\u0300-\u036f]*)[₀-₎ₐ-ₜᵢ-ᵥⱼ⁰-ⁿ²³¹*]*")
_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[{}_^&]|[^\\{}_^&]")
_SIGNS = {
    **{"vartheta": "ϑ", "pm": "±", "int": "∫", "nabla": "∇", "partial": "∂", "star": "*"},
    **{"le": "≤", "ge": "≥", "ne": "≠", "leftrightarrow": "↔", "cdots": "…", "infty": "∞"},
    **{"cdot": "·", " ": " ", ",": " ", "!": "", ";": " ", "quad": "  "},
    **{"left": "", "right": "", "displaystyle": "", "{": "{", "}": "}"},
}
# Names that are written as they are.
_FUNCTIONS = {"sin", "cos", "tan", "exp", "log", "arg"}
_ACCENTS = {"dot": "\u0307", "bar": "\u0304", "ddot": "\u0308"}
_WORDS = {"mathrm", "text", "operatorname", "mathbf"}
_SUPER = dict(zip("0123456789+-=()niT*", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱᵀ*", strict=True))
_SUB = dict(zip("0123456789+-=()aeijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", strict=True))


def in_unicode(latex: str) -> str:
    """Convert a LaTeX formula to Unicode text.

    Raises ValueError for an unknown command.
    """
    text = _Reader(_TOKEN.findall(latex)).until("")
    for bare in _BARE:
        text = bare.sub(r"\1\2\3", text)
    text = text.replace(_OPEN, "(").replace(_CLOSE, ")")
    return re.sub(r" +", " ", re.sub(r"(?<=[=(\[,±+-]) +(?=sin|cos|tan|exp)", "", text)).strip()


@dataclass(slots=True)
class _Reader:
    """A parser that converts LaTeX tokens to Unicode text."""

    tokens: list[str]
    place: int = 0

    def next(self) -> str:
        """Read the next token and return it.

        Return "" at the end.
        """
        self.place += 1
        return self.tokens[self.place - 1] if self.place <= len(self.tokens) else ""

    def until(self, end: str) -> str:
        """Convert all tokens up to an end token, and skip the end token."""
        parts = []
        while (token := self.next()) not in (end, ""):
            parts.append(self.written(token))
        return "".join(parts)

    def argument(self) -> str:
        """Convert the next argument, which is a group in braces or a single token.

        Blanks before it are skipped.
        """
        while (token := self.next()) == " ":
            pass
        return self.until("}") if token == "{" else self.written(token)

    def written(self, token: str) -> str:
        """Convert a token together with its arguments."""
        if token in _ATOMS:
            return _ATOMS[token](self)
        name = token.removeprefix("\\")
        if name is token:
            return token.strip()
        if name in _SIGNS:
            return _SIGNS[name]
        return self.function(name) if name in _FUNCTIONS else _letter("GREEK {} LETTER {}", name)

    def root(self) -> str:
        """Read the argument of a square root and return the root as text."""
        inside = self.argument()
        return f"√{inside}" if len(inside) == 1 else f"√({inside})"

    def words(self) -> str:
        """Return the characters of a group in braces, blanks included."""
        while (token := self.next()) == " ":
            pass
        if token != "{":
            return token
        begin = self.place
        self.place = self.tokens.index("}", begin) + 1
        return "".join(_SIGNS.get(x[1:], x) for x in self.tokens[begin : self.place - 1])

    def function(self, name: str) -> str:
        """Return a function's name, such as sin, with blanks that separate it from letters."""
        follows = self.tokens[self.place] if self.place < len(self.tokens) else ""
        return f" {name}" if follows in ("^", "_", "(", "\\left", "") else f" {name} "

    def accented(self, mark: str) -> str:
        """Return the next argument with an accent on its first letter."""
        text = self.argument()
        return text[:1] + mark + text[1:]

    def matrix(self) -> str:
        """Return a matrix as text in one line, row by row."""
        self.argument()
        inside = self.until(r"\end")
        self.argument()
        rows = (re.sub(r"\s*&\s*", ", ", row).strip() for row in inside.split("\n"))
        return f"[{'; '.join(rows)}]"


def _letter(form: str, name: str) -> str:
    """Look up a letter by its Unicode name.

    Raises ValueError for an unknown name.
    """
    size = "CAPITAL" if name[:1].isupper() else "SMALL"
    known = "LAMDA" if name.lower() == "lambda" else name.upper()
    try:
        return unicodedata.lookup(form.format(size, known))
    except KeyError:
        raise ValueError(f"{name} has no form in plain text") from None


def _fraction(reader: _Reader) -> str:
    above, below = reader.argument(), reader.argument()
    over = f"({above})" if re.search(r"[-+=]", _outside(above)) else above
    under = below if _SYMBOL.fullmatch(below) or not _outside(below).strip("√") else f"({below})"
    text = f"{over}/{under}"
    return text if text[0].isdigit() and text[-1].isdigit() else f"{_OPEN}{text}{_CLOSE}"


def _outside(text: str) -> str:
    """Return a text without the parts in brackets."""
    while (shorter := re.sub(rf"\([^()]*\)|{_OPEN}[^{_OPEN}{_CLOSE}]*{_CLOSE}", "", text)) != text:
        text = shorter
    return text


def _small(forms: Mapping[str, str], mark: str) -> Callable[[_Reader], str]:
    def read(reader: _Reader) -> str:
        text = reader.argument()
        if all(x in forms for x in text):
            return "".join(forms[x] for x in text)
        return f"{mark}{text}" if len(text) == 1 else f"{mark}({text})"

    return read


_ATOMS: dict[str, Callable[[_Reader], str]] = {
    r"\frac": _fraction,
    r"\tfrac": _fraction,
    r"\sqrt": _Reader.root,
    r"\begin": _Reader.matrix,
    r"\\": lambda reader: "\n",
    r"\mathbb": lambda reader: _letter("DOUBLE-STRUCK {} {}", reader.argument()),
    "{": lambda reader: reader.until("}"),
    "_": _small(_SUB, "_"),
    "^": _small(_SUPER, "^"),
    **{rf"\{name}": _Reader.words for name in _WORDS},
    **{
        rf"\{name}": lambda reader, mark=mark: reader.accented(mark)
        for name, mark in _ACCENTS.items()
    },
}
