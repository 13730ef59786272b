"""HTML from nested calls; what is not markup yet is escaped, so that no name can break a page."""

import html


class Markup(str):
    """Text that is HTML already."""

    __slots__ = ()


Attribute = str | float | bool | None
# Elements that have no end tag.
VOID = ("meta", "br")


def text(value: object) -> Markup:
    """A value as HTML: escaped, unless it is markup."""
    return value if isinstance(value, Markup) else Markup(html.escape(str(value)))


def join(*parts: object) -> Markup:
    """Parts one after the other."""
    return Markup("".join(map(text, parts)))


def lines(*parts: object) -> Markup:
    """Parts on lines of their own."""
    return Markup("\n".join(map(text, parts)))


def tag(name: str, /, *children: object, **attributes: Attribute) -> Markup:
    """An element; `class_` is the attribute class, None and False are attributes left out.

    >>> tag("p", "1 < 2 ", tag("b", "&"), class_="note", hidden=None)
    '<p class="note">1 &lt; 2 <b>&amp;</b></p>'
    """
    given = "".join(
        f' {_attribute(key)}="{html.escape(_value(value))}"'
        for key, value in attributes.items()
        if value is not None and value is not False
    )
    head = f"<{name}{given}>"
    return Markup(head if name in VOID else f"{head}{join(*children)}</{name}>")


def _attribute(key: str) -> str:
    """SVG has attributes in camel case, none with an underscore."""
    return key.rstrip("_").replace("_", "-")


def _value(value: Attribute) -> str:
    """Pixels to a hundredth."""
    if value is True:
        return ""
    return f"{value:.2f}".rstrip("0").rstrip(".") if isinstance(value, float) else str(value)
