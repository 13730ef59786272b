"""What a representation for notebooks has to be, whatever it shows."""

import re
from html.parser import HTMLParser

VOID = {"br"}


class Balanced(HTMLParser):
    """Every element that is opened is closed, in order."""

    def __init__(self):
        super().__init__()
        self.open, self.seen, self.text = [], set(), []

    def handle_starttag(self, tag, attrs):
        self.seen.add(tag)
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def well_formed(text):
    """The words of a representation that is well formed and in the colours of the page."""
    reader = Balanced()
    reader.feed(text)
    reader.close()
    assert reader.open == []
    assert "script" not in reader.seen
    assert not re.search(r"[: ](black|white)[;\" ]|#000|#fff", text)
    shown = "".join(reader.text)
    assert shown.count(r"\(") == shown.count(r"\)")
    return shown
