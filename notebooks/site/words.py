"""Names in code, which narrow columns may break after a dot or an underscore and nowhere else."""

import re
from typing import Any

from sphinx.application import Sphinx

_CODE = re.compile(r'(<span class="pre">|<code[^>]*>)([^<\s]+)(?=</span>|</code>)')
_PLACE = re.compile(r"(?<=[A-Za-z0-9)\]])([._/=]+)(?=[A-Za-z0-9])")


def breakable(page: str) -> str:
    """Mark the places in a page where its names may be broken.

    >>> breakable('<code class="literal">motion.mean_rates</code>')
    '<code class="literal">motion.<wbr>mean_<wbr>rates</code>'
    """
    return _CODE.sub(lambda found: found[1] + _PLACE.sub(r"\1<wbr>", found[2]), page)


def _marked(app: Sphinx, name: str, template: str, context: dict[str, Any], tree: Any) -> None:
    if "body" in context:
        context["body"] = breakable(context["body"])


def setup(app: Sphinx) -> dict[str, Any]:
    """Mark the names of every page."""
    app.connect("html-page-context", _marked)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
