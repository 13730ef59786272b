"""Parser and translator of the LaTeX formulas that the paper prints.

The project has its own parser because SymPy's `parse_latex` evaluates while it reads, and supports
neither Lie brackets nor functions of time, conditions or lists of equations.
"""

from rigidsym.proof.paper._printed.interpreter import (
    PLAIN,
    Second,
    Translation,
    Vocabulary,
    in_names,
    translate,
)
from rigidsym.proof.paper._printed.parser import Display, PrintError, Statement, Words, parse

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
