"""A derivation as an article, line by line: for a terminal, in Markdown, LaTeX and HTML.

`line_html`, `line_latex` and `line_text` show one line, as notebooks do where a step has run.
"""

from rigidsym.view.article.formats import FORMATS, article, line_text
from rigidsym.view.article.line import line_html, line_latex

__all__ = ["FORMATS", "article", "line_html", "line_latex", "line_text"]
