"""Names and formulas in the prose of chapters, as LaTeX.

The docstrings of chapters are plain text: `formulas` finds the names of quantities in a sentence,
and `displayed_formula` converts an indented formula as a whole.
"""

import re

from rigidsym.language import _latex as language
from rigidsym.language._lines import width
from rigidsym.view._statements import WIDE

# Names of quantities in prose: phi1', Omega_i^2, R^-1; M alone, but not "A" of a sentence.  The
# prime of a possessive, as in psi's, is none.
_GREEK = "|".join(sorted(language.GREEK, key=len, reverse=True))
NAMES = re.compile(
    rf"\b(?P<name>(?:(?:{_GREEK})[1-3]?(?:_[0-9a-z])?|[AcqFMb][0-3](?![0-9])|[A-Za-z]_[0-9a-z]"
    r"|b_free|K|H|M|R|B|S|sn))\b"
    r"(?P<prime>'(?!\w))?(?:\^(?P<power>-?[0-9]))?"
)
# Powers of other names and of units: kg m^2.
_POWERS = re.compile(r"(?<=[\w)])\^(-?[0-9]+)\b")
# Words that name functions.
_FUNCTIONS = {"sin", "cos", "tan", "tanh", "arctan", "exp", "arg"}
_OPERATORS = {"sn", "cn", "dn", "Im", "Re"}
_SIGNS = {"|": r" \mid ", "+-": r"\pm ", "\N{MULTIPLICATION SIGN}": r"\times ", "int": r"\int "}
# The cross product, which is an x between two vectors.
_CROSS = " \N{MULTIPLICATION SIGN} "
_TOKEN = re.compile(r"\s{2,}|\+-|[A-Za-z]\w*'*|\^-?\d+|\^\(|\s|.")


def formulas(text: str) -> str:
    """Replace the names of quantities in a text by LaTeX formulas."""

    def name(found: re.Match[str]) -> str:
        text = language.symbol(found["name"]).latex
        primed = language.dotted(text) if found["prime"] else text
        return f"${primed}^{{{found['power']}}}$" if found["power"] else f"${primed}$"

    parts = re.split(r"(\$[^$]*\$)", NAMES.sub(name, text))
    return "".join(x if x[:1] == "$" else _POWERS.sub(r"$^{\1}$", x) for x in parts)


def escaped(text: str) -> str:
    """Convert a text to LaTeX, with symbols for quantities and special characters escaped."""
    parts = re.split(r"(\$[^$]*\$)", formulas(text.replace("`", "")))
    special = {mark: f"\\{mark}" for mark in "_#%&{}"} | {"^": r"\^{}", "|": r"$\mid$"}
    escapes = str.maketrans(special)
    return "".join(part if part.startswith("$") else part.translate(escapes) for part in parts)


def displayed_formula(part: str) -> list[str]:
    r"""Return an indented formula of a docstring as aligned rows; none for a table of words.

    >>> displayed_formula("X' = Y,    a(k) = q^k/(1 - q^(2k)),  starting at 0")
    ["&X' = Y,\\quad a(k) = q^{k}/(1 - q^{2k}),\\quad\\text{ starting at } 0"]
    """
    lines = [line.strip() for line in part.splitlines()]
    if not all("=" in line for line in lines):
        return []
    found = [row for line in lines for row in _broken(_row(line))]
    if len(found) == len(lines) > 1:  # the signs of equality below one another
        return [row.replace("=", "&=", 1) for row in found]
    return [f"&{row}" for row in found]


def _broken(row: str) -> list[str]:
    """Break a row that is too wide after a comma."""
    found: list[str] = []
    for part in row.split(r",\quad"):
        longer = rf"{found[-1]},\quad{part}" if found else part
        if found and width(longer) <= WIDE:
            found[-1] = longer
        else:
            found.append(part.strip())
    return [*(f"{part}," for part in found[:-1]), *found[-1:]]


def _row(line: str) -> str:
    """Return a line of a formula in LaTeX."""
    found, depth, raised = "", 0, []
    for token in _TOKEN.findall(_raised(re.sub(r"\s+=", " =", line))):
        if token == "^(":
            raised.append(depth)
            found += "^{"
        elif token == ")" and raised and raised[-1] == depth:
            raised.pop()
            found += "}"
        else:
            depth += {"(": 1, ")": -1}.get(token, 0)
            found += _token(token)
    together = re.sub(r"\s*\}\s*\\text\{", " ", found)
    spaced = re.sub(r"(?<=\w) \\text\{", r"\\text{ ", together)
    ended = re.sub(r"(\\text\{[^}]*?) \}(?=[(),]|$)", r"\1}", spaced)
    return re.sub(r"\s+", " ", ended).strip()


def _raised(line: str) -> str:
    """Put named exponents of a line in parentheses, and write products of vectors with a cross."""
    return re.sub(r"\^([A-Za-z]\w*)", r"^(\1)", re.sub(r"(?<=[\w)]) x (?=[\w(])", _CROSS, line))


def _token(token: str) -> str:
    """Return a token of a formula as LaTeX."""
    if token.isspace():
        return r"\quad " if len(token) > 1 else " "
    if token in _SIGNS:
        return _SIGNS[token]
    if not token[0].isalpha():
        return f"^{{{token[1:]}}}" if token[0] == "^" else token
    name = token.rstrip("'")
    primes, base = token[len(name) :], name.partition("_")[0]
    if name in _FUNCTIONS:
        return rf"\{name} "
    if name in _OPERATORS:
        return rf"\operatorname{{{name}}} "
    letters = base.rstrip("0123456789").removesuffix("bar")
    if letters[:1] == "d" and len(letters) == 2:
        return f"d{language.symbol(name[1:]).latex}{primes}"
    if letters in language.GREEK or len(letters) == 1 or "_" in name:
        return f"{language.symbol(name).latex}{primes}"
    return rf"\text{{{token} }}"
