"""Formulas as MathML, made when the site is built: no script, no network, text that can be copied.

`latex2mathml` translates; what browsers do not draw of it is put in other words here.  A formula
that it does not know is a warning, and so an error.  The font is STIX Two Math (SIL OFL 1.1).
"""

import re
import unicodedata
import xml.etree.ElementTree as ET
from contextlib import suppress
from functools import cache, partial
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.util import logging

_LOG = logging.getLogger(__name__)
_SPACE = "http://www.w3.org/1998/Math/MathML"
_ACCENTS = frozenset("\u02c6\u02dc\u00af\u2015\u203e\u2192^~")
_DOTS = frozenset("\u02d9\u00a8")
_BARS = frozenset("|\u2016")
_LETTER = re.compile(r"(?:LATIN|GREEK) (CAPITAL|SMALL) LETTER (\w+)|(DIGIT \w+)")
ET.register_namespace("", _SPACE)


class FormulaError(ValueError):
    """A formula that cannot be translated, and why."""


@cache
def mathml(latex: str, display: str) -> str:
    """The formula as MathML; raises FormulaError for what is not understood."""
    try:
        tree = ET.fromstring(convert(_prepared(latex), display=display))
    except Exception as error:
        raise FormulaError(f"{latex}: {type(error).__name__}: {error}") from None
    for element in tree.iter():
        if "\\" in (element.text or ""):
            raise FormulaError(f"{latex}: {element.text} is not known")
        _drawable(element)
    tree.set("alttext", " ".join(latex.split()))
    return ET.tostring(tree, encoding="unicode")


def letters(latex: str) -> str:
    r"""The formula in letters alone, for what shows neither markup nor LaTeX, as a search does.

    >>> letters(r"K\cdot A_1^2")
    'K·A₁²'
    """
    return _lettered(ET.fromstring(mathml(latex, "inline")))


def _lettered(element: ET.Element) -> str:
    parts = [_lettered(child) for child in element]
    tag = element.tag.removeprefix(f"{{{_SPACE}}}")
    if tag in ("msub", "msup", "msubsup"):
        signs = {"msub": "_", "msup": "^", "msubsup": "_^"}[tag]
        return parts[0] + "".join(map(_raised, signs, parts[1:]))
    if tag == "mfrac":
        return "/".join(parts)
    return (element.text or "").strip() + "".join(parts)


def _raised(sign: str, text: str) -> str:
    """The text as an index or as a power: digits have letters of their own."""
    small = dict(zip("0123456789", "₀₁₂₃₄₅₆₇₈₉" if sign == "_" else "⁰¹²³⁴⁵⁶⁷⁸⁹", strict=True))
    if set(text) <= set(small):
        return "".join(small[digit] for digit in text)
    return sign + (text if len(text) == 1 else f"({text})")


def _prepared(latex: str) -> str:
    """Environments under names that are known, and commands that mean nothing here left out."""
    latex = re.sub(
        r"\\(begin|end)\{(?:aligned|align|split|gathered|gather)\}", r"\\\1{align*}", latex
    )
    latex = re.sub(r"\\label\{[^}]*\}|\\(?:no)?number\b", "", latex)
    return latex.replace("\\dfrac", "\\displaystyle\\frac").strip()


def _drawable(element: ET.Element) -> None:
    """What is drawn wrong by itself: styles of letters, boxes, accents and bars."""
    style = element.get("mathvariant")
    if style not in (None, "normal"):
        words = style.upper().replace("BOLD-", "BOLD ")
        element.text = "".join(_styled(x, words) for x in element.text or "")
        del element.attrib["mathvariant"]
    tag = element.tag.removeprefix(f"{{{_SPACE}}}")
    if tag == "menclose" and element.get("notation") == "box":
        element.tag = f"{{{_SPACE}}}mrow"
        element.attrib.clear()
        element.set("class", "boxed")
    if tag == "mover" and (element[1].text or "").strip() in _ACCENTS:
        element.set("accent", "true")
    if tag == "mover" and (element[1].text or "").strip() in _DOTS:
        element[1].set("class", "dot")
    if tag == "mo" and element.text in _BARS and element.get("fence") is None:
        element.attrib.update({"lspace": "0", "rspace": "0", "stretchy": "false"})


def _styled(letter: str, style: str) -> str:
    """The letter of Unicode's mathematical alphabets, or the same where there is none."""
    found = _LETTER.fullmatch(unicodedata.name(letter, ""))
    if not found:
        return letter
    name = found[3] or f"{found[1]} {found[2]}"
    for full in (f"MATHEMATICAL {style} {name}", f"{style} {name}"):
        try:
            return unicodedata.lookup(full)
        except KeyError:
            continue
    return letter


def _written(translator: Any, node: nodes.Element, display: str) -> str:
    try:
        return mathml(_latex(node), display)
    except FormulaError as error:
        _LOG.warning("formula: %s", error, location=node)
        return f"<code>{translator.encode(_latex(node))}</code>"


def _latex(node: nodes.Element) -> str:
    return nodes.Element.astext(node)


def _in_letters(node: nodes.Node) -> None:
    """Let formulas of a title be letters where its text is taken: in the index of the search."""
    for formula in node.findall(nodes.math):
        with suppress(FormulaError):  # the page has the warning
            vars(formula)["astext"] = partial(str, letters(_latex(formula)))


def _indexed(app: Sphinx, env: Any) -> None:
    for title in (*env.titles.values(), *env.longtitles.values()):
        _in_letters(title)


def _resolved(app: Sphinx, tree: nodes.document, name: str) -> None:
    for title in tree.findall(nodes.title):
        _in_letters(title)


def _inline(translator: Any, node: nodes.Element) -> None:
    translator.body.append(_written(translator, node, "inline"))
    raise nodes.SkipNode


def _block(translator: Any, node: nodes.Element) -> None:
    body = _written(translator, node, "block")
    translator.body.append(f'<div class="formula">{body}</div>\n')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the renderer under the name `mathml`."""
    app.connect("env-updated", _indexed)
    app.connect("doctree-resolved", _resolved)
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
