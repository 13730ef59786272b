"""Printed lines with one coefficient, sign, index, exponent or function changed."""

import re
from collections.abc import Iterator

_TEXT = re.compile(r"\\(?:text|begin|end|mathrm|operatorname|left|right)\{[^{}]*\}")
# What is changed, and what it is changed to: numbers, signs, axes, sine and cosine.
_CHANGES = (
    ("number", re.compile(r"\d"), lambda x: str(int(x) % 3 + 1)),
    ("sign", re.compile(r"(?<![\d\w}])-|(?<=[\d\w})])[-+]"), lambda x: {"+": "-", "-": "+"}[x]),
    ("axis", re.compile(r"(?<=_)[ijkl]"), lambda x: {"i": "j", "j": "k", "k": "i", "l": "i"}[x]),
    ("function", re.compile(r"\\(?:sin|cos)(?![a-z])"), lambda x: r"\sin\cos".replace(x, "")),
    ("function", re.compile(r"(?<=\\mathrm\{)(?:sn|cn|dn)"), lambda x: "cn" if x == "sn" else "sn"),
)


def misprints(latex: str) -> Iterator[tuple[str, str]]:
    """Yield every line that differs from a given one in one place, with the kind of change."""
    spared = [found.span() for found in _TEXT.finditer(latex) if "sn" not in found[0]]
    spared = [span for span in spared if not re.search(r"\{[scd]n\}", latex[slice(*span)])]
    for kind, pattern, change in _CHANGES:
        for found in pattern.finditer(latex):
            begin, end = found.span()
            if not any(first <= begin < last for first, last in spared):
                yield kind, latex[:begin] + change(found[0]) + latex[end:]
