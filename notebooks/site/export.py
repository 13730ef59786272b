"""Single files of notebooks for readers without network: `python notebooks/site/export.py`.

    python notebooks/site/export.py [NAME…] [-o DIR]    DIR/NAME.html, of all of them by default

A file holds all that it shows: formulas are MathML, 3-D pictures stills.  Notebooks are taken as
they are committed, nothing is executed.  Needs the extras `docs` and `lab`.
"""

import argparse
import re
import sys
from collections.abc import Sequence
from html import unescape
from pathlib import Path
from typing import Any

import nbformat
from nbconvert import HTMLExporter

from mathml import mathml
from rigidsym.io._files import write_text

FOLDER = Path(__file__).resolve().parents[1]
# Formulas of Markdown, but not within code; then those of cards.
_MARKED = re.compile(r"(```.*?```|`[^`\n]*`)|\$\$(.+?)\$\$|\$([^$]+?)\$", re.DOTALL)
_CARD = re.compile(r"\\\((.*?)\\\)", re.DOTALL)
_LINK = re.compile(r"\]\((\w+)\.ipynb")
# nbconvert's template loads these from elsewhere.
_LOADED = re.compile(r"<script[^>]*\bsrc=\"https?:[^>]*>.*?</script>", re.DOTALL)
_LIVE = ("application/vnd.plotly.v1+json", "application/javascript")
# What is wider than a phone scrolls by itself; nbconvert's own style cuts it off.
_STYLE = """<style>
.jp-InputArea-editor .highlight pre, .jp-RenderedMarkdown pre { overflow-x: auto; }
.jp-RenderedMarkdown p, .jp-RenderedMarkdown math[display="block"] { overflow: auto hidden; }
.jp-RenderedMarkdown :not(pre) > code { overflow-wrap: anywhere; }
</style>
</head>"""


def exported(notebook: Any) -> str:
    """The notebook as one HTML file that loads nothing."""
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = _LINK.sub(r"](\1.html", _MARKED.sub(_formula, cell.source))
        for output in cell.get("outputs", ()):
            _still(output.get("data", {}))
    page, _ = HTMLExporter(mathjax_url="", require_js_url="").from_notebook_node(notebook)
    return _LOADED.sub("", page).replace("</head>", _STYLE, 1)


def _formula(found: re.Match[str]) -> str:
    code, block, inline = found.groups()
    return code or mathml(block or inline, "block" if block else "inline")


def _still(data: dict[str, Any]) -> None:
    """What needs no script: formulas as MathML, links of tables and cards as they are."""
    for kind in _LIVE:
        data.pop(kind, None)
    latex = data.pop("text/latex", "").strip().strip("$").removeprefix(r"\displaystyle")
    if latex and "text/html" not in data:
        data["text/html"] = f"<div>{mathml(latex, 'block')}</div>"
    for kind, pattern in (("text/html", _CARD), ("text/markdown", _MARKED)):
        if kind in data:
            replaced = _formula if pattern is _MARKED else _card
            data[kind] = pattern.sub(replaced, data[kind])


def _card(found: re.Match[str]) -> str:
    return mathml(unescape(found[1]), "inline")


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the files and say where they are; returns the exit status."""
    parser = argparse.ArgumentParser(prog="notebooks/site/export.py", description="Single files.")
    parser.add_argument("names", metavar="NAME", nargs="*", help="all, unless some are named")
    parser.add_argument("-o", "--output", type=Path, default=Path("build/notebooks"), metavar="DIR")
    options = parser.parse_args(arguments)
    there = sorted(path.stem for path in FOLDER.glob("*.ipynb"))
    for name in options.names or there:
        if name not in there:
            parser.error(f"{name}: must be one of: {', '.join(there)}")
        notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
        print(write_text(options.output / f"{name}.html", exported(notebook)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
