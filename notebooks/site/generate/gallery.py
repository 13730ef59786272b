"""The gallery of the landing page: a picture of each chapter that has one, and a link to it."""

import html
import json
import re
from base64 import b64decode
from collections.abc import Mapping
from typing import Any

# The first of these that an output has is its picture.
_KINDS = {"image/png": "png", "image/jpeg": "jpeg", "image/svg+xml": "svg"}
_BEFORE = "## Install"
_TILE = (
    '<a class="tile" href="guide/{stem}.html"><img src="_static/{file}" alt="" loading="lazy">'
    "<span>{title}</span></a>"
)
_LETTERS = {r"\phi": "φ", r"\varphi": "φ", r"\Pi": "Π", r"\cdot": "·", "_1": "₁", "$": ""}


def pictures(notebooks: Mapping[str, str]) -> dict[str, bytes]:
    """The first picture of each chapter by the name of its file; notebooks are JSON by stem."""
    return {file: data for file, _, _, data in _chapters(notebooks)}


def within(readme: str, notebooks: Mapping[str, str]) -> str:
    """The README with the gallery before how to install; itself where no chapter has a picture."""
    tiles = [
        _TILE.format(stem=stem, file=file, title=html.escape(title))
        for file, stem, title, _ in _chapters(notebooks)
    ]
    if not tiles:
        return readme
    inside = "\n".join(tiles)
    block = f'```{{raw}} html\n<div class="gallery">\n{inside}\n</div>\n```\n'
    return readme.replace(_BEFORE, f"{block}\n{_BEFORE}", 1)


def _chapters(notebooks: Mapping[str, str]) -> list[tuple[str, str, str, bytes]]:
    """File, stem, title and picture of each chapter that has one."""
    chapters = {stem: json.loads(text)["cells"] for stem, text in notebooks.items()}
    found = {stem: _picture(cells) for stem, cells in chapters.items() if stem[:1].isdigit()}
    return [
        (f"gallery-{stem}.{picture[0]}", stem, _title(chapters[stem]), picture[1])
        for stem, picture in found.items()
        if picture
    ]


def _title(cells: list[Any]) -> str:
    """The first heading of a notebook, its formulas in letters."""
    first = next("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    title = re.findall(r"^# (.*)$", first, re.MULTILINE)[0]
    for latex, letter in _LETTERS.items():
        title = title.replace(latex, letter)
    return title


def _picture(cells: list[Any]) -> tuple[str, bytes] | None:
    """Its suffix and what is in its file."""
    for output in (output for cell in cells for output in cell.get("outputs", ())):
        for kind, suffix in _KINDS.items():
            if kind in output.get("data", {}):
                text = "".join(output["data"][kind])
                return suffix, text.encode() if suffix == "svg" else b64decode(text)
    return None
