"""Presentation of results as HTML pages, notebook cards, terminal text and pictures."""

from rigidsym._lazy import lazily

__getattr__, __dir__ = lazily(__name__, {})
