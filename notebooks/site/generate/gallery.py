"""The gallery of the landing page: a picture of each chapter, and a link to it.

A tile is small: it shows the part of a picture that can be read there.  Chapter 1 has no picture of
its own; its tile shows the verdicts on the printed equations.
"""

import html
import json
import re
from base64 import b64decode
from collections.abc import Mapping
from io import BytesIO
from typing import Any

from PIL import Image

from mathml import letters

# The first of these that an output has is its picture.
_KINDS = ("image/png", "image/jpeg")
_BEFORE = "## Install"
_TILE = (
    '<a class="tile" href="guide/{stem}.html"><img src="_static/{file}" alt="" loading="lazy">'
    "<span>{title}</span></a>"
)
# Of chapters by their stems: which of their pictures, and the part from left, top to right, bottom.
_PARTS = {
    "00_start_here": (0, (0.02, 0.1, 0.45, 0.72)),
    "02_from_lax_pair_to_k_a1": (0, (0.04, 0.13, 0.36, 0.9)),
    "03_the_phi1_integral_and_pi": (0, (0.07, 0.05, 0.47, 0.85)),
    "04_no_sign_functions": (1, (0.07, 0.37, 0.87, 0.62)),
    "05_edges": (4, (0.14, 0.2, 0.9, 0.82)),
    "06_theta_functions": (2, (0.11, 0.12, 0.44, 0.82)),
    "07_fifty_digits_and_a_proof": (0, (0.1, 0.08, 0.99, 0.86)),
    "08_code_you_can_fly": (0, (0.1, 0.08, 0.99, 0.86)),
    "09_validation": (0, (0.33, 0.05, 0.66, 0.32)),
    "10_a_manoeuvre_from_start_to_stop": (0, (0.14, 0.12, 0.88, 0.8)),
    "11_derive_your_own": (0, (0.04, 0.13, 0.43, 0.9)),
    "12_toutatis_from_twelve_looks": (0, (0.66, 0.12, 0.97, 0.8)),
    "13_how_a_tumbling_body_forgets": (0, (0.09, 0.1, 0.49, 0.84)),
}
_WHOLE = (0, (0.0, 0.0, 1.0, 1.0))
_SIZE = (480, 360)
_VERDICTS = "01_the_paper_line_by_line"
_RULINGS = {
    "holds": "#1a7f4b",
    "conditional": "#1f6fb2",
    "misprint": "#b3341f",
    "ambiguous": "#8a5a00",
    "open": "#666",
}


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
    found = []
    for stem, cells in chapters.items():
        if not stem[:1].isdigit():
            continue
        if stem == _VERDICTS:
            found.append((f"gallery-{stem}.svg", stem, _title(cells), _squares()))
        elif picture := _picture(cells, *_PARTS.get(stem, _WHOLE)):
            found.append((f"gallery-{stem}.png", stem, _title(cells), picture))
    return found


def _title(cells: list[Any]) -> str:
    """The first heading of a notebook, its formulas in letters."""
    first = next("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    title = re.findall(r"^# (.*)$", first, re.MULTILINE)[0]
    return re.sub(r"\$([^$]+)\$", lambda formula: letters(formula[1]), title)


def _picture(
    cells: list[Any], number: int, part: tuple[float, float, float, float]
) -> bytes | None:
    """A part of a chapter's picture as PNG; None if it has no picture of that number."""
    outputs = (output.get("data", {}) for cell in cells for output in cell.get("outputs", ()))
    shown = (next((data[kind] for kind in _KINDS if kind in data), None) for data in outputs)
    found = [picture for picture in shown if picture]
    if len(found) <= number:
        return None
    image = Image.open(BytesIO(b64decode("".join(found[number])))).convert("RGB")
    (wide, high), (left, top, right, bottom) = image.size, part
    image = image.crop((left * wide, top * high, right * wide, bottom * high))
    image.thumbnail(_SIZE)
    buffer = BytesIO()
    image.save(buffer, "png")
    return buffer.getvalue()


def _squares() -> bytes:
    """Every printed equation as a square in the colour of its verdict, as SVG."""
    from rigidsym.io.ledger import ledger_data, ledger_text
    from rigidsym.proof.paper import verdicts

    ruled = verdicts(ledger_data(ledger_text()))
    rulings = [verdict.ruling.name.lower() for verdict in ruled]
    squares = [
        f'<rect x="{12 + 36 * (k % 8)}" y="{6 + 36 * (k // 8)}" width="30" height="30" rx="5" '
        f'fill="{_RULINGS[ruling]}"/>'
        for k, ruling in enumerate(rulings)
    ]
    high = 6 + 36 * -(-len(rulings) // 8)
    opening = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 306 {high}">'
    return "\n".join([opening, *squares, "</svg>\n"]).encode()
