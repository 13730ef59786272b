"""Conversion of derivations to articles in plain text, Markdown, LaTeX or HTML.

A line has a sentence on the step, its equations with the paper's numbers, the conditions under
which it holds, and the name of its fact.  `line_html`, `line_latex` and `line_text` return one
line, as notebooks show it where the step has just run.
"""

import re
from collections.abc import Iterable, Iterator
from functools import reduce
from itertools import chain
from typing import TYPE_CHECKING, Any

import sympy
from sympy.matrices.expressions.adjoint import Adjoint
from sympy.printing.pretty.pretty import PrettyPrinter
from sympy.printing.pretty.pretty_symbology import pretty_symbol, pretty_use_unicode
from sympy.printing.pretty.stringpict import prettyForm

from rigidsym.language import _latex as language
from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    children,
    names,
    to_text,
)
from rigidsym.view._cards import card, code, formula, math, muted, tag
from rigidsym.view._pages import render

if TYPE_CHECKING:
    from rigidsym.proof.derivation import Chapter
    from rigidsym.proof.steps._record import Step

FORMATS = {
    "text": "article.txt",
    "markdown": "article.md",
    "latex": "article.tex",
    "html": "article.html",
}
"The formats that a derivation can be written in, with their templates."
# A row of more letters of LaTeX than these is broken, if it has more than one term.
LONG = 150
# Constants of a motion, which the paper writes before variables.
CONSTANTS = {
    *("c1", "c2", "c3", "c_i", "c_j", "c_k", "H", "K", "K_squared", "h1", "h2", "h3", "n", "s_i"),
    *("s_j", "alpha", "beta", "chi", "mu", "xi", "zeta", "nu", "kappa", "sqrt_mu", "b_free"),
}
# Names of quantities in prose: phi1', Omega_i^2, R^-1; M alone, but not "A" of a sentence.
_GREEK = "|".join(sorted(language.GREEK, key=len, reverse=True))
NAMES = re.compile(
    rf"\b(?P<name>(?:(?:{_GREEK})[1-3]?(?:_[ijk])?|[AcqFMb][0-3](?![0-9])|b_free|K|H|M|R|B|S|sn))\b"
    r"(?P<prime>')?(?:\^(?P<power>-?[0-9]))?"
)
_ROW = "display:flex;justify-content:space-between;align-items:baseline;gap:1em"
_EQUATIONS = "min-width:0;padding-left:1.5em"
_DOT = "\N{COMBINING DOT ABOVE}"


def article(chapters: Iterable["Chapter"], form: str) -> str:
    """Format the chapters of a derivation as an article.

    form: one of `FORMATS`.  Chapters without steps are left out.  Raises ImportError for HTML if
    latex2mathml is not installed.
    """
    tools = (aligned, display, escaped, formulas, latex, line_text, mathml, numbers, prose)
    named = {tool.__name__: tool for tool in (*tools, provided, sentence)}
    text = render(FORMATS[form], chapters=[x for x in chapters if x.steps], **named)
    return text.rstrip("\n") + "\n"


def mathml(text: str, kind: str) -> str:
    """Convert LaTeX to MathML.

    kind: `inline` or `block`.
    """
    from latex2mathml.converter import convert

    return convert(text, display=kind)


def numbers(line: "Step") -> str:
    """Return the numbers of the paper's equations that a line of a derivation cites.

    They are text such as "(31), (32)".
    """
    return ", ".join(f"({n})" if n[0].isdigit() else n for n in line.source)


def provided(line: "Step") -> Iterator[sympy.Basic]:
    """Return the conditions under which a derivation step holds, as inequalities."""
    return (sympy.Ne(condition, 0, evaluate=False) for condition in line.conditions)


def line_text(line: "Step") -> str:
    """Format a line of a derivation for a terminal."""
    where = ["where " + pretty(condition) for condition in provided(line)]
    below = [*map(pretty, line.shown), *where, f"[{line.fact.id}]"]
    rows = [f"    {row}".rstrip() for text in below for row in text.split("\n")]
    return "\n".join([f"{sentence(line)}  {numbers(line)}".rstrip(), "", *rows])


def sentence(line: "Step") -> str:
    """Return the sentence that explains a derivation step and the choice it makes."""
    formula = NAMES.match(line.why) or re.match(r"\w+\(", line.why)
    words = line.why if formula else line.why[:1].upper() + line.why[1:]
    whole = f"{words}; {line.choice}" if line.choice else words
    return whole if whole.endswith("?") else f"{whole}:"


def prose(chapter: "Chapter") -> str:
    """Return the introductory text of a chapter without its formulas."""
    parts = chapter.opening.strip().split("\n\n")
    return "\n\n".join(" ".join(part.split()) for part in parts if not part.startswith("    "))


def formulas(text: str) -> str:
    """Replace the names of quantities in a text by LaTeX formulas."""

    def name(found: re.Match[str]) -> str:
        text = language.symbol(found["name"]).latex
        primed = language.dotted(text) if found["prime"] else text
        return f"${primed}^{{{found['power']}}}$" if found["power"] else f"${primed}$"

    return NAMES.sub(name, text)


def escaped(text: str) -> str:
    """Convert a text to LaTeX, with symbols for quantities and special characters escaped."""
    parts = re.split(r"(\$[^$]*\$)", formulas(text.replace("`", "")))
    special = {**{mark: f"\\{mark}" for mark in "_#%&"}, "^": r"\^{}", "|": r"$\mid$"}
    escapes = str.maketrans(special)
    return "".join(part if part.startswith("$") else part.translate(escapes) for part in parts)


def display(line: "Step", fit: str = "") -> str:
    """Return a derivation line's equations in LaTeX, tagged with the paper's numbers.

    fit: a macro around the equations."""
    shown = f"{fit}{{{aligned(line)}}}" if fit else aligned(line)
    tags = numbers(line).replace("^-1", "^{-1}").replace("R^{-1} dR/dt", r"$R^{-1}\dot R$")
    return rf"{shown}\tag*{{{tags}}}" if tags else shown


def aligned(line: "Step") -> str:
    """Return a derivation line's equations in LaTeX, one below the other."""
    rows = [row for equation in line.shown for row in _rows(equation)]
    if len(rows) == 1:
        return rows[0].replace("&", "")
    below = r" \\ ".join(rows)
    return rf"\begin{{aligned}}{below}\end{{aligned}}"


def _rows(equation: sympy.Basic) -> list[str]:
    """Format an equation as aligned rows of LaTeX.

    A long equation has a row for each term or side.
    """
    left, right = equation.args
    terms = right.args if isinstance(right, sympy.MatAdd) else ()
    if len(terms) < 2 and len(latex(equation)) > 2 * LONG:
        return [f"&{latex(left)}", rf"&\quad = {latex(right)}"]
    if len(terms) < 2 or len(latex(equation)) < LONG:
        return [f"{latex(left)} &= {latex(right)}"]
    first, *rest = map(latex, terms)
    signed = (text if text.startswith("-") else f"+ {text}" for text in rest)
    return [f"{latex(left)} &= {first}", *(rf"&\quad {text}" for text in signed)]


def line_html(line: "Step") -> str:
    """Return a notebook card that shows a line of a derivation.

    It has the sentence, the fact, the equations and the conditions of the line.
    """
    parts = re.split(r"(\$[^$]*\$)", formulas(sentence(line)))
    said = tag("span", *(math(x.strip("$")) if x.startswith("$") else x for x in parts))
    head = tag("div", said, muted(code(line.fact.id)), style=f"{_ROW};padding-top:.4em")
    equations = tag("div", formula(aligned(line)), style=_EQUATIONS)
    body = tag("div", equations, muted(numbers(line)), style=_ROW)
    pairs = [(muted(", "), math(latex(condition))) for condition in provided(line)]
    where = [muted("where "), *[*chain(*pairs)][1:]]
    return card(head, body, tag("div", *where, style=_EQUATIONS) if pairs else "")


def line_latex(line: "Step") -> str:
    """Return a derivation line's equations as one LaTeX display with the paper's numbers."""
    return f"$${display(line)}$$"


def latex(expression: Any) -> str:
    """Convert a SymPy expression, matrix, equation or inequality to LaTeX."""
    if isinstance(expression, sympy.Rel):
        sign = {"==": "=", **language.SIGNS}[expression.rel_op]
        return f"{latex(expression.lhs)} {sign} {latex(expression.rhs)}"
    if isinstance(expression, sympy.MatrixBase):
        rows = r" \\ ".join(" & ".join(map(latex, row)) for row in expression.tolist())
        return rf"\left[\begin{{matrix}}{rows}\end{{matrix}}\right]"
    return _PRINTER.of(_tree(expression))


def _tree(expression: Any) -> Expression:
    """Convert a SymPy expression to this package's own expression tree.

    Parts that this language lacks become names in LaTeX.
    """
    arguments = expression.args
    match expression:
        case sympy.Integer():
            size = Number(abs(int(expression)))
            return Call("neg", (size,)) if expression < 0 else size
        case sympy.Symbol() | sympy.MatrixSymbol():
            return Name(expression.name)
        case sympy.ZeroMatrix():
            return Number(0)
        case sympy.MatAdd():
            return _folded("+", arguments)
        case sympy.MatMul():
            return _matrix_product(expression)
        case sympy.Add():
            ordered = expression.as_ordered_terms()
            first = next((x for x in ordered if not x.could_extract_minus_sign()), ordered[0])
            return _folded("+", [first, *(term for term in ordered if term is not first)])
        case sympy.Pow() if expression.exp == sympy.S.Half:
            return Call("sqrt", (_tree(expression.base),))
        case sympy.Pow() if not expression.exp.is_negative:
            return Operation("**", _tree(expression.base), _tree(expression.exp))
        case sympy.Rational() | sympy.Mul() | sympy.Pow():
            return _quotient(expression)
        case sympy.Inverse():
            return Operation("**", _tree(arguments[0]), Call("neg", (Number(1),)))
        case Adjoint():
            return Operation("**", _tree(arguments[0]), Name(r"\dagger"))
        case sympy.Determinant():
            return Name(rf"\left|{{{latex(arguments[0])}}}\right|")
        case sympy.Integral():
            return Name(rf"\int \left({latex(arguments[0])}\right)\, d{latex(arguments[1][0])}")
        case sympy.Function():
            return Call(expression.func.__name__, tuple(map(_tree, arguments)))
    # The class is of `rigidsym.proof.steps`, which imports this module.
    if type(expression).__name__ == "Rate":
        return Call("D", (_tree(arguments[0]),))
    return Name(sympy.latex(expression))


def _folded(operator: str, parts: Iterable[Any]) -> Expression:
    """Return the expression tree of a sum or product of several SymPy expressions."""
    return reduce(lambda left, right: Operation(operator, left, right), map(_tree, parts))


def _quotient(expression: sympy.Expr) -> Expression:
    """Convert a SymPy product, fraction or negative power to a tree with a leading sign."""
    above, below = sympy.fraction(expression, exact=True)
    negative = above.as_coeff_Mul()[0].is_negative
    if negative:
        above = -above
    tree = _folded("*", sympy.Mul.make_args(above))
    if below != 1:
        tree = Operation("/", tree, _folded("*", sympy.Mul.make_args(below)))
    return Call("neg", (tree,)) if negative else tree


def _matrix_product(expression: sympy.MatMul) -> Expression:
    """Convert a SymPy product of matrices to a tree with a leading sign."""
    first, *rest = map(_tree, expression.args)
    sign, bare = language.signed(first)
    factors = (*([] if bare == Number(1) else [bare]), *rest)
    product = Call("times", factors)
    return Call("neg", (product,)) if sign < 0 else product


def _rank(factor: Expression) -> tuple[int, str]:
    """Return a sort key that puts factors in the usual order of a formula.

    Numbers come first, then constants, variables and functions.
    """
    text = to_text(factor)
    if isinstance(factor, Number):
        return 0, text
    functions = _has_functions(factor)
    moving = functions or bool({*names(factor)} - CONSTANTS)
    is_sum = isinstance(factor, Operation) and factor.operator in ("+", "-")
    return 1 + is_sum + 2 * moving + 2 * functions, text


def _has_functions(expression: Expression) -> bool:
    called = isinstance(expression, Call) and expression.function != "neg"
    return called or any(map(_has_functions, children(expression)))


_PRINTER = language.Printer(_rank, most=None)


def pretty(expression: sympy.Basic, width: int = 100) -> str:
    """Format a SymPy expression in Unicode characters for a terminal."""
    settings = {"use_unicode": True, "wrap_line": True, "num_columns": width}
    before = pretty_use_unicode(True)
    try:
        return _Pretty(settings).doprint(expression)
    finally:
        pretty_use_unicode(before)


class _Pretty(PrettyPrinter):
    def _print_Symbol(self, e: sympy.Symbol, bold_name: bool = False) -> prettyForm:
        base, _, last = e.name.rpartition("_")
        if last == "rate" and base:
            shown = pretty_symbol(base)
            return prettyForm(shown[0] + _DOT + shown[1:])
        return super()._print_Symbol(e, bold_name)

    def _print_MatrixSymbol(self, e: sympy.MatrixSymbol) -> prettyForm:
        return self._print_Symbol(sympy.Symbol(e.name))

    def _print_MatAdd(self, expr: Any) -> prettyForm:
        whole: Any = self._print(expr.args[0])
        for term in expr.args[1:]:
            negative = term.could_extract_minus_sign()
            whole = prettyForm(*whole.right(" - " if negative else " + "))
            whole = prettyForm(*whole.right(self._print(-term if negative else term)))
        return whole

    def _print_Function(self, e: Any, *rest: Any, **settings: Any) -> prettyForm:
        if e.func.__name__ != "D":
            return super()._print_Function(e, *rest, **settings)
        return self._print_Rate(e)

    def _print_Rate(self, e: Any) -> prettyForm:
        """Print a time derivative, as a dot above a letter or as d/dt before an expression."""
        inner = e.args[0]
        if isinstance(inner, sympy.MatrixSymbol) or (inner.is_Symbol and "_" not in inner.name):
            return self._print_Symbol(sympy.Symbol(f"{inner.name}_rate"))
        shown: Any = self._print(inner)
        return prettyForm(*prettyForm("d/dt ").right(prettyForm(*shown.parens())))
