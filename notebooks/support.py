"""What notebooks alone need: ledgers to read from, and matrices of contexts as SymPy's.

Nothing is derived here.  Statements come from a ledger, whether it has just been written by
chapters of `derivations` or replayed from the sealed one; `rigidsym.view.html` shows them.
"""

import re
from collections.abc import Iterable, Mapping
from importlib import import_module
from typing import Any

import sympy
from IPython.display import HTML, Markdown, Math

from derivations import CHAPTERS
from rigidsym.io.ledger import ledger_text
from rigidsym.language.latex import latex
from rigidsym.language.symbols import symbol
from rigidsym.proof.algebra import Book
from rigidsym.proof.algebra.enclosures import encloses
from rigidsym.proof.algebra.su2 import Complex, Matrix
from rigidsym.proof.claims import Claim, claims
from rigidsym.proof.kernel import Element, Grade, Ledger, replay
from rigidsym.proof.paper import EQUATIONS


def derived(*chapters: str) -> Ledger:
    """Run chapters of `derivations`, and those before the last of them, in a new ledger."""
    book = Book()
    for name in CHAPTERS[: max(map(CHAPTERS.index, chapters)) + 1]:
        import_module(f"derivations.{name}").derive(book)
    return book.ledger


def sealed() -> Ledger:
    """The ledger that comes with the project, every certificate replayed in a fresh kernel."""
    return replay(ledger_text(), encloses)


def grades(ledger: Ledger, *facts: str) -> set[Grade]:
    """The grades that facts have in a ledger; KeyError for one that is not there."""
    return {ledger.facts[fact].grade for fact in facts}


def show(ledger: Ledger, *facts: str) -> HTML:
    """Facts of a ledger under each other, as each shows itself; the hypotheses that several have
    in common come with the first."""
    found = claims(ledger)
    first = {ledger.facts[fact].context: fact for fact in reversed(facts)}
    shown = (found[x] if x in first.values() else Claim(found[x].fact) for x in facts)
    return HTML("\n".join(claim._repr_html_() for claim in shown))


def printed(*numbers: str) -> HTML:
    """Equations of the paper under each other, exactly as printed."""
    found = {equation.number: equation for equation in EQUATIONS}
    return HTML("\n".join(found[number]._repr_html_() for number in numbers))


def definitions(ledger: Ledger, context: str, *names: str) -> Math:
    """What names abbreviate in a context."""
    defined = ledger.contexts[context].definitions
    lines = r" \\ ".join(rf"{symbol(n).latex} &= {latex(defined[n])}" for n in names)
    return Math(rf"\begin{{aligned}} {lines} \end{{aligned}}")


def equation(lhs: Any, rhs: Any) -> Math:
    """Two sides, SymPy's or text, as one displayed equation."""
    return Math(rf"\displaystyle {_side(lhs)} = {_side(rhs)}")


def matrix(value: Matrix) -> sympy.Matrix:
    """A matrix over a context's ring as one of SymPy's."""
    a, b, c, d = (number(entry) for entry in value.entries)
    return sympy.Matrix([[a, b], [c, d]])


def number(value: Complex | Element) -> sympy.Expr:
    """An element of a context's ring, or a pair of them, as an expression of SymPy's."""
    if isinstance(value, Complex):
        return number(value.real) + sympy.I * number(value.imag)
    factors = zip(value.ring.units, value.powers, strict=True)
    below = sympy.prod(unit.as_expr() ** power for unit, power in factors if power)
    whole = sympy.cancel(value.numerator.as_expr() / below)
    return whole.expand().xreplace({name: letter(name.name) for name in whole.free_symbols})


def letter(name: str) -> sympy.Expr:
    """What a name of a context stands for, as SymPy prints it: `cos_half_phi1` is cos(phi1/2)."""
    if found := re.fullmatch("(cos|sin)_(half_)?([a-z]+[0-9]?)", name):
        angle = letter(found[3]) / (2 if found[2] else 1)
        return (sympy.cos if found[1] == "cos" else sympy.sin)(angle)
    return sympy.Symbol(symbol(name).latex)


def table(rows: Iterable[Mapping[str, Any]]) -> Markdown:
    """Rows with the same keys as a table."""
    listed = list(rows)
    lines = [
        list(listed[0]),
        ["---"] * len(listed[0]),
        *([*map(str, row.values())] for row in listed),
    ]
    return Markdown("\n".join(f"| {' | '.join(line)} |" for line in lines))


def _side(side: Any) -> str:
    return side if isinstance(side, str) else sympy.latex(side)
