"""A derivation as an article, line by line: for a terminal, in Markdown, LaTeX and HTML."""

from rigidsym.view.article.formats import FORMATS, article

__all__ = ["FORMATS", "article"]
