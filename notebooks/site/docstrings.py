"""The project's docstrings, which are plain text, as reStructuredText for autodoc.

NumPy's sections become lists; other paragraphs with a drawn line, and indented ones, are kept as
they are drawn; single backticks are code; doctests stay; all other marks mean themselves.
Signatures show ArrayLike and the project's own kinds of input by their names, not by the unions
that these stand for: import this module before modules that take the names.
"""

import re
from collections.abc import Iterable, Iterator
from importlib import import_module
from itertools import groupby, pairwise
from typing import Any, NewType

import numpy.typing
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.ext.napoleon.docstring import NumpyDocstring

ArrayLike = NewType("ArrayLike", object)
ArrayLike.__module__ = "numpy.typing"
vars(numpy.typing)["ArrayLike"] = ArrayLike
# After NumPy's, for this module takes it, and before the modules that take these.
_inputs = import_module("rigidsym._inputs")
ExactNumber = NewType("ExactNumber", object)
Vector3 = NewType("Vector3", object)
Quaternion = NewType("Quaternion", object)
Times = NewType("Times", object)
for _kind in (ExactNumber, Vector3, Quaternion, Times):
    _kind.__module__ = "rigidsym"
    vars(_inputs)[_kind.__name__] = _kind
_SECTION = re.compile("Parameters|Returns|Raises|Examples")


def converted(lines: Iterable[str]) -> list[str]:
    """Convert the lines of a docstring, without its indentation, to reStructuredText."""
    lines = list(lines)
    pairs = enumerate(pairwise(lines))
    heads = (k for k, (head, line) in pairs if _SECTION.fullmatch(head) and set(line) == {"-"})
    first = next(heads, len(lines))
    result: list[str] = []
    for blank, group in groupby(lines[:first], key=lambda line: not line.strip()):
        if not blank:
            result += [*_paragraph(list(group)), ""]
    sections: list[str] = []
    for blank, group in groupby(lines[first:], key=lambda line: not line.strip()):
        rows = list(group)
        doctests = (k for k, row in enumerate(rows) if row.lstrip().startswith(">>>"))
        words = 0 if blank else next(doctests, len(rows))
        sections += [*_inline(rows[:words]), *rows[words:]]
    return [*result, *NumpyDocstring(sections).lines()]


def _paragraph(lines: list[str]) -> Iterator[str]:
    if lines[0].lstrip().startswith(">>>"):
        yield from lines
    elif any(re.fullmatch(r"\s*-{4,}\s*", line) for line in lines) or lines[0].startswith("    "):
        yield from ("::", "", *(f"    {line}" for line in lines))
    else:
        yield from _inline(lines)


def _inline(lines: list[str]) -> list[str]:
    """Lines of words, in which code may go on from one line to the next."""
    parts = "\n".join(lines).split("`")
    written = (
        f"``{' '.join(part.split())}``" if k % 2 else _plain(part) for k, part in enumerate(parts)
    )
    return re.sub(r"(?m)^(\s*)\\([*-] )", r"\1\2", "".join(written)).split("\n")


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
