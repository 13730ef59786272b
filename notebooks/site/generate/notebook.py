"""A committed notebook as the site shows it: as it is, its 3-D pictures drawn without network."""

import html
import json
import re
from collections.abc import Mapping
from typing import Any

from generate.links import within
from mathml import mathml

PLOTLY = "application/vnd.plotly.v1+json"
# Only a running kernel can show these.
_LIVE = ("application/vnd.jupyter.widget-view+json", "application/javascript")
_HEIGHT = 480
_FORMULA = re.compile(r"\\\((.*?)\\\)", re.DOTALL)
_SCRIPT = """<script src="../_static/plotly.min.js"></script>
<script src="../_static/pictures.js"></script>"""
_PICTURE = """<div id="{name}" class="plotly-picture" style="height: {height}px"></div>
<script>drawPicture("{name}", {figure});</script>"""


def shown(text: str, stem: str, pages: Mapping[str, str]) -> str:
    """The notebook's JSON, changed where a page needs it: links, pictures, live widgets."""
    notebook = json.loads(text)
    notebook["metadata"].pop("widgets", None)
    pictures = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "markdown":
            cell["source"] = within("".join(cell["source"]), pages)
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            if PLOTLY in data:
                output["data"] = {"text/html": _picture(data[PLOTLY], stem, pictures)}
                pictures += 1
            else:
                _without_live(data)
                _with_formulas(data)
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


def has_pictures(text: str) -> bool:
    """Whether a notebook needs plotly."""
    return PLOTLY in text


def _picture(figure: Any, stem: str, number: int) -> str:
    """The library comes with the first picture of a page."""
    written = json.dumps(figure, ensure_ascii=False).replace("</", "<\\/")
    height = figure.get("layout", {}).get("height") or _HEIGHT
    drawn = _PICTURE.format(name=f"picture-{stem}-{number}", figure=written, height=height)
    return drawn if number else f"{_SCRIPT}\n{drawn}"


def _with_formulas(data: dict[str, Any]) -> None:
    """Formulas of cards as MathML; raises FormulaError for one that is not understood."""
    if "text/html" in data:
        whole = "".join(data["text/html"])
        data["text/html"] = _FORMULA.sub(lambda m: mathml(html.unescape(m[1]), "inline"), whole)


def _without_live(data: dict[str, Any]) -> None:
    if len(data) > 1:
        for kind in _LIVE:
            data.pop(kind, None)
