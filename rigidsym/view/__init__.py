"""Presentation of results as HTML pages, notebook cards, terminal text and pictures."""
