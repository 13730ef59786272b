"""What the paper prints, read: LaTeX to trees, and trees to the language of a context.

The parser is the project's own: SymPy's `parse_latex` evaluates while it reads, and knows neither
Lie brackets nor functions of a time, "when" or lists of equations.
"""

from rigidsym.proof.paper.printed.interpreter import PLAIN, Second, Vocabulary, in_names
from rigidsym.proof.paper.printed.parser import parse
from rigidsym.proof.paper.printed.translation import Translation, translate
from rigidsym.proof.paper.printed.tree import Display, PrintError, Statement, Words

__all__ = [
    "PLAIN",
    "Display",
    "PrintError",
    "Second",
    "Statement",
    "Translation",
    "Vocabulary",
    "Words",
    "in_names",
    "parse",
    "translate",
]
