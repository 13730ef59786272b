"""The live page: one file with its style, its script and the generated JavaScript in it."""

import re
from importlib import resources
from pathlib import Path

LIVE = Path(__file__).resolve().parents[1] / "live"
MODULE = "torque_free.mjs"
# Fields by the id that their sliders begin with: label, least, largest, step and first value.
_SLIDERS = {
    "c": [(f"c{k}", f"c{k}", 0.1, 3, 0.01, first) for k, first in ((1, 1), (2, 2), (3, 2.5))],
    "omega": [
        (f"omega{k}", f"ω{k}", -3, 3, 0.01, first) for k, first in ((1, 0.02), (2, 2), (3, 0))
    ],
    "view": [
        ("t", "t, s", 0, 100, 0.01, 0),
        ("pace", "pace", 0.1, 5, 0.1, 1),
        ("turn", "view, °", -180, 180, 1, -145),
    ],
}
_SLIDER = (
    '<label class="live-slider" for="live-{name}">{label}'
    '<input type="range" id="live-{name}" min="{least}" max="{most}" step="{step}" value="{first}">'
    '<output for="live-{name}"></output></label>'
)
PLACE = "<!-- pictures, sliders and numbers -->\n"
_PAGE = """\
```{{raw}} html
<style>
{style}</style>
{body}<script type="module">
{module}
{script}</script>
```
"""


def block() -> str:
    """Return what the page has beside words, as Markdown."""
    body = (LIVE / "page.html").read_text("utf-8")
    for name, rows in _SLIDERS.items():
        keys = ("name", "label", "least", "most", "step", "first")
        sliders = (_SLIDER.format(**dict(zip(keys, row, strict=True))) for row in rows)
        body = body.replace(f"SLIDERS_{name}", "".join(sliders))
    return _PAGE.format(
        style=(LIVE / "page.css").read_text("utf-8"),
        body=body,
        module=module(),
        script=(LIVE / "page.js").read_text("utf-8"),
    )


def module() -> str:
    """Return the generated module as part of another script, without comments on its lines.

    Browsers load no module from a file beside a page that is a file itself.
    """
    text = resources.files("rigidsym.generated").joinpath(MODULE).read_text("utf-8")
    bare = re.sub(r"(?<=;) /\* .*? \*/$", "", text, flags=re.MULTILINE)
    return re.sub(r"^export ", "", bare, flags=re.MULTILINE)
