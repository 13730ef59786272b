"""Checks that a page or card is well-formed HTML."""

import re
from html.parser import HTMLParser

VOID = {"br", "meta"}


class Elements(HTMLParser):
    """Parser of HTML elements with their attributes.

    It fails for tags that are not closed in order.
    """

    def __init__(self, text):
        super().__init__()
        self.open, self.found, self.words = [], [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        assert len(dict(attrs)) == len(attrs), attrs
        self.found.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)

    def all(self, tag, class_=None):
        wanted = ((name, given) for name, given in self.found if name == tag)
        return [a for _, a in wanted if class_ is None or class_ in a.get("class", "").split()]


def well_formed(text):
    """Check that an HTML card is well formed and has no fixed colours; return its words."""
    elements = Elements(text)
    assert not elements.all("script")
    assert not re.search(r"[: ](black|white)[;\" ]|#000|#fff", text)
    shown = "".join(elements.words)
    assert shown.count(r"\(") == shown.count(r"\)")
    return shown
