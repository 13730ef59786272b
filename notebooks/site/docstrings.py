"""The project's docstrings, which are plain text, as reStructuredText for autodoc.

Paragraphs with a drawn line, and indented ones, are kept as they are drawn; single backticks are
code; doctests stay; all other marks mean themselves.
"""

import re
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx


def converted(lines: Iterable[str]) -> list[str]:
    """The lines of a docstring, without its indentation, as reStructuredText."""
    result: list[str] = []
    for blank, group in groupby(lines, key=lambda line: not line.strip()):
        if not blank:
            result += [*_paragraph(list(group)), ""]
    return result


def _paragraph(lines: list[str]) -> Iterator[str]:
    if lines[0].lstrip().startswith(">>>"):
        yield from lines
    elif any(re.fullmatch(r"\s*-{4,}\s*", line) for line in lines) or lines[0].startswith("    "):
        yield from ("::", "", *(f"    {line}" for line in lines))
    else:
        yield from map(_inline, lines)


def _inline(line: str) -> str:
    bullet = re.match(r"\s*(?:[*-] )?", line)
    start = bullet[0] if bullet else ""
    parts = line[len(start) :].split("`")
    written = (f"``{part}``" if k % 2 else _plain(part) for k, part in enumerate(parts))
    return start + "".join(written)


def _plain(text: str) -> str:
    return re.sub(r"([\\*_|])", r"\\\1", text)


def _process(app: Sphinx, what: str, name: str, value: Any, options: Any, lines: list[str]) -> None:
    lines[:] = converted(lines)


def _signed(
    app: Sphinx, what: str, name: str, value: Any, options: Any, signature: str | None, result: Any
) -> tuple[str | None, Any]:
    """Defaults that are made anew each time are no Python as they are printed."""
    return signature and signature.replace("<factory>", "..."), result


def _badge(ruling: str) -> Any:
    """A role that shows its words as a badge of that verdict."""

    def role(
        name: str, raw: str, text: str, *rest: Any
    ) -> tuple[list[nodes.Node], list[nodes.Node]]:
        return [nodes.inline(raw, text, classes=["badge", ruling])], []

    return role


def setup(app: Sphinx) -> dict[str, Any]:
    """Convert every docstring, and know the badges of verdicts."""
    from rigidsym.proof.paper import Ruling

    app.connect("autodoc-process-docstring", _process)
    app.connect("autodoc-process-signature", _signed)
    for ruling in Ruling:
        app.add_role(f"bdg-{ruling.name.lower()}", _badge(ruling.name.lower()))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
