r"""Line breaks in long LaTeX formulas.

A row is broken before a plus or a minus sign, or between two factors, at the outermost place where
it fits.  Fractions and roots that are too wide are written with a slash and a power, so that they
can be broken, too.  Brackets around a break do not stretch.
"""

import re
from collections.abc import Iterator, Sequence

# An environment, such as a matrix, is one token: no row ends inside it.
_TOKENS = re.compile(r"\\begin\{(\w+)\}.*?\\end\{\1\}|\\[a-zA-Z]+|\\.|\s+|.", re.DOTALL)
_OPEN, _CLOSE = (r"\left(", r"\bigl("), (r"\right)", r"\bigr)")
# Widths of tokens, in digits of the font.
_WIDTHS = {
    **{r"\frac": 0.5, r"\sqrt": 1.5, r"\quad": 2.0, r"\,": 0.3, r"\bigl": 0.0, r"\bigr": 0.0},
    **{r"\cos": 3.0, r"\sin": 2.6, r"\neq": 2.7, r"\geq": 2.7, r"\cdot": 1.6, r"\big": 0.0},
    **{r"\dot": 0.0, r"\bar": 0.0, r"\mathrm": 0.0, r"\operatorname": 0.5, r"\text": 0.0},
    **{"=": 2.7, "+": 2.5, "-": 2.5, " ": 0.0, "(": 1.2, ")": 1.2, ",": 0.9},
    **{r"\left": 0.0, r"\right": 0.0, r"\mid": 1.8, r"\displaystyle": 0.0},
}
_SMALL = 0.72
# A word that ends with one of these is not the end of a factor.
_OPERATORS = {r"\cos", r"\sin", r"\cdot", r"\,", r"\mid", "=", "+", "-", ",", "(", r"\quad"}
# A row is at least this full, if it can be broken there.
_FULL = 0.4


def width(text: str) -> float:
    r"""Estimate the width of a formula in widths of a digit.

    >>> width("x + 10") < width(r"\frac{x + 10}{\Omega_{1}^{2}}") < width("x + 10 y")
    True
    """
    total, scale, tokens = 0.0, 1.0, _tokens(text)
    place = 0
    while place < len(tokens):
        token = tokens[place]
        place += 1
        if token in ("^", "_"):
            scale = _SMALL
            continue
        if token == r"\frac":
            total += max(map(width, tokens[place : place + 2])) + _WIDTHS[token]
            place += 2
        elif token.startswith(r"\begin"):
            inside = token[token.index("}") + 1 : token.rindex(r"\end")]
            lines = [line.split("&") for line in inside.split(r"\\")]
            total += sum(max(map(width, column)) + 1.5 for column in zip(*lines, strict=True))
        elif token.startswith("{"):
            total += scale * width(token[1:-1])
        else:
            total += scale * _width_of(token)
        scale = 1.0
    return total


def _width_of(token: str) -> float:
    if token.isspace():
        return 0.0
    if token.isalpha():
        return 1.45 if token.isupper() else 1.05
    return _WIDTHS.get(token, 1.1)


def _tokens(text: str) -> list[str]:
    """Split a formula into commands, characters and groups in braces."""
    found: list[str] = []
    depth = 0
    for token in (match.group() for match in _TOKENS.finditer(text)):
        if depth:
            found[-1] += token
        else:
            found.append(" " if token.isspace() else token)
        depth += (token == "{") - (token == "}")
    return found


def rows(text: str, most: float) -> list[str]:
    """Break a formula into rows that are at most `most` digits wide, as far as it has places."""
    if width(text) <= most:
        return [text]
    found, rest = [], _flat(_tokens(text), most)
    while width("".join(rest)) > most and (place := _place(rest, most)):
        found.append(rest[:place])
        after = "".join(rest[place:]).lstrip()
        sign = after[0] in "+-"
        rest = _tokens(after if sign else rf"\cdot {after}")
        most = most if len(found) > 1 else most - _WIDTHS[r"\quad"]
    return ["".join(row).strip() for row in _unstretched([*found, rest])]


def _flat(tokens: Sequence[str], most: float) -> list[str]:
    """Write fractions and roots that are too wide with a slash and a power."""
    found: list[str] = []
    place = 0
    while place < len(tokens):
        token, place = tokens[place], place + 1
        if token == r"\frac":
            above, below = tokens[place : place + 2]
            place += 2
            if max(width(above), width(below)) > most / 2:
                above, below = (_bracketed(part[1:-1], most) for part in (above, below))
                found += [*above, r"\big", "/", *below]
                continue
            found += [token, above, below]
        elif token == r"\sqrt" and width(tokens[place]) > most / 2:
            found += [*_bracketed(tokens[place][1:-1], most), "^", "{1/2}"]
            place += 1
        else:
            found.append(token)
    return found


def _bracketed(text: str, most: float) -> list[str]:
    inner = _flat(_tokens(text), most)
    if len(inner) == 1:
        return inner
    return [r"\left", "(", *inner, r"\right", ")"]


def _place(tokens: Sequence[str], most: float) -> int:
    """Return where a row ends, or 0 if it cannot be broken."""
    best: tuple[tuple[bool, int, int], int] | None = None
    reached = 0.0
    for place, depth, is_sum in _places(tokens):
        reached = width("".join(tokens[:place]))
        if reached > most:
            break
        rank = (reached < _FULL * most, 2 * depth + (not is_sum), -place)
        if best is None or rank < best[0]:
            best = rank, place
    return best[1] if best else 0


def _places(tokens: Sequence[str]) -> Iterator[tuple[int, int, bool]]:
    """Yield the places between tokens at which a row can end.

    Each comes with the number of brackets around it, and whether a sign follows.
    """
    depth = 0
    for place, token in enumerate(tokens):
        if token in ("(", r"\{", "["):
            depth += 1
        elif token in (")", r"\}", "]"):
            depth -= 1
        elif token == " " and 0 < place < len(tokens) - 1:
            before, after = tokens[place - 1], tokens[place + 1]
            if before in _OPERATORS or after in ("=", r"\cdot", r"\mid", r"\,", "{", r"\neq"):
                continue
            if after.startswith("{"):
                continue
            if after in ("+", "-"):
                yield place, depth, True
            elif before not in (r"\right", r"\left"):
                yield place, depth, False


def _unstretched(parts: Sequence[Sequence[str]]) -> list[list[str]]:
    r"""Write \bigl and \bigr for brackets that are not closed in their row."""
    found = [list(row) for row in parts]
    opened: list[tuple[int, int]] = []
    for k, row in enumerate(found):
        for place, token in enumerate(row):
            if token == r"\left":
                opened.append((k, place))
            elif token == r"\right" and opened:
                j, start = opened.pop()
                if j != k:
                    found[j][start], row[place] = r"\bigl", r"\bigr"
    return found
