"""The tokens of printed LaTeX; what only makes room is left out."""

import re
from collections.abc import Iterator

from rigidsym.proof.paper.printed.tree import PrintError

_TOKEN = re.compile(
    r"\\text\{[^{}]*\}|\\(?:mathrm|operatorname|begin|end)\{[A-Za-z]+\}|\\mathrm\s*[A-Za-z]"
    r"|\\left\||\\right\||\\[A-Za-z]+|\\[ ,;:!]|\\\\|[A-Za-z]|[0-9]|[-+=<>/^_&{}()\[\]|,;:]"
)
_ROOM = {r"\ ", r"\,", r"\;", r"\:", r"\!", r"\left", r"\right"}


def tokens(latex: str) -> Iterator[str]:
    """The tokens from left to right; raises PrintError for what is none."""
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
