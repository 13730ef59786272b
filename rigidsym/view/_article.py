"""Conversion of derivations to articles in plain text, Markdown, LaTeX or HTML.

A line has a sentence on the step, its equations with the paper's numbers, the conditions under
which it holds, and the name of its fact.  `line_html`, `line_latex` and `line_text` return one
line, as notebooks show it where the step has just run.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import reduce
from inspect import cleandoc
from itertools import chain
from textwrap import wrap
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
from rigidsym.language._lines import width
from rigidsym.view._cards import Markup, card, code, formula, join, math, muted, tag
from rigidsym.view._pages import render
from rigidsym.view._prose import NAMES, displayed_formula, escaped, formulas
from rigidsym.view._statements import (
    COLUMNS,
    WIDE,
    Code,
    Formula,
    Paragraph,
    Words,
    aligned_rows,
    introduction,
    listed,
    notation,
    numbers,
    stated,
)
from rigidsym.view._statements import (
    formula as formula_of,
)

if TYPE_CHECKING:
    from rigidsym.proof.derivation import Chapter
    from rigidsym.proof.kernel import Context, Fact
    from rigidsym.proof.steps._record import Step

FORMATS = {
    "text": "article.txt",
    "markdown": "article.md",
    "latex": "article.tex",
    "html": "article.html",
}
"The formats that a derivation can be written in, with their templates."
# What a reader of the article needs to know first.
ABOUT = (
    "Numbers of equations are those of the paper.",
    "A context is a list of named quantities, with what they mean and what is supposed of them.",
    "Each statement is about one context, and a small kernel has decided it.",
    "The name beside a statement is that of the fact in the ledger.",
    "Operations that computed a statement are named before it; most are SymPy's methods.",
)
# Constants of a motion, which the paper writes before variables.
CONSTANTS = {
    *("c1", "c2", "c3", "c_i", "c_j", "c_k", "H", "K", "K_squared", "h1", "h2", "h3", "n", "s_i"),
    *("s_j", "alpha", "beta", "chi", "mu", "xi", "zeta", "nu", "kappa", "sqrt_mu", "b_free"),
}
_ROW = "display:flex;justify-content:space-between;align-items:baseline;gap:1em"
_EQUATIONS = "min-width:0;padding-left:1.5em"
_DOT = "\N{COMBINING DOT ABOVE}"


def article(chapters: Iterable["Chapter"], form: str) -> str:
    """Format the chapters of a derivation as an article.

    form: one of `FORMATS`.  Each context is introduced before the first fact that is about it.
    Raises ImportError for HTML if latex2mathml is not installed.
    """
    told = [*chapters]
    contexts = {name: context for chapter in told for name, context in chapter.contexts.items()}
    written = WRITERS[form]
    tools = (breakable, displayed, displayed_formula, escaped, fitted, formulas, markdown_display)
    more = (opening, paragraph_text, tag_text, wrapped)
    text = render(
        FORMATS[form],
        chapters=[*_told(told)],
        about=" ".join(ABOUT),
        notation=notation(contexts.values()),
        written=written,
        **{tool.__name__: tool for tool in (*tools, *more)},
    )
    return text.rstrip("\n") + "\n"


def _told(chapters: Iterable["Chapter"]) -> Iterator[tuple["Chapter", list[Paragraph]]]:
    """Yield chapters with their paragraphs: contexts before their facts, and facts by steps."""
    known: dict[str, Context] = {}
    matrices: dict[str, Any] = {}
    shown: set[str] = set()
    for chapter in chapters:
        found: list[Paragraph] = []
        for fact in chapter.facts:
            for name in (*_about(fact), fact.context):
                if name not in known:
                    context, given = chapter.contexts[name], chapter.matrices.get(name, {})
                    hidden = {x for x in context.definitions if _part_of(x) in given}
                    found += introduction(context, known.values(), hidden)
                    found += _matrices(given, matrices)
                    known[name] = context
            steps = [step for step in chapter.steps if step.fact.id == fact.id]
            for step in steps:
                found += _sought(step, chapter.contexts[fact.context])
                found.append(paragraph(step))
            if not steps:
                found.append(stated(fact, chapter.contexts[fact.context], shown))
            shown.add(fact.id)
        yield chapter, found


def _sought(line: "Step", context: "Context") -> Iterator[Paragraph]:
    """Yield the sentence on names that a line solves for and its context does not have."""
    readings = chain(context.reading.values(), context.reading, context.definitions)
    words = {*context.generators, *re.findall(r"[A-Za-z_]\w*", " ".join(readings))}
    used = {str(x) for equation in line.shown for x in equation.free_symbols}
    matrices = [x for equation in line.shown for x in equation.atoms(sympy.MatrixExpr)]
    sized = {str(x) for matrix in matrices for x in (*matrix.shape, matrix)}
    if unknown := sorted(used - sized - words):
        names = [formula_of(name) for name in unknown]
        yield Paragraph(("To be found: ", *listed(names, " and "), "."))


def _about(fact: "Fact") -> tuple[str, ...]:
    """Return the contexts that a fact is about, besides its own."""
    return fact.rhs if fact.kind in ("model", "partition") else ()


def _part_of(name: str) -> str:
    """Return the matrix whose entry a name is, such as R for R_11_re."""
    return re.sub(r"_[1-3][1-3](_re|_im)?$", "", name)


def _matrices(given: Mapping[str, Any], known: dict[str, Any]) -> Iterator[Paragraph]:
    """Yield what the matrices of a context are, and note it among those that are known."""
    before = [name for name, value in given.items() if known.get(name) == value]
    new = {name: value for name, value in given.items() if name not in before}
    if before:
        symbols = [Formula(latex(sympy.Symbol(name)), name) for name in before]
        yield Paragraph(("With the matrices ", *listed(symbols, " and "), " as before."))
    if new:
        pairs = [(sympy.MatrixSymbol(name, *x.shape), x) for name, x in new.items()]
        rows = aligned_rows((latex(name), "=", latex(value)) for name, value in pairs)
        texts = [pretty(sympy.Eq(name, value, evaluate=False)) for name, value in pairs]
        first = next(iter(new))
        known |= new
        parts = [formula_of(f"{first}_11_{part}") for part in ("re", "im")]
        after = ("The parts of an entry are written ", *listed(parts, " and "), ".")
        if not any(isinstance(x, sympy.MatrixBase) and x.has(sympy.I) for x in known.values()):
            after = ("An entry is written ", parts[0], ".")
        yield Paragraph(("Matrices:",), (), tuple(rows), tuple(texts), (after,))


def paragraph(line: "Step") -> Paragraph:
    """Return a line of a derivation as a paragraph."""
    where = [Formula(latex(condition), pretty(condition)) for condition in provided(line)]
    after = (("where ", *listed(where), "."),) if where else ()
    other = dict.fromkeys(_alternatives(line), "or\n")
    texts = tuple(f"{other.get(k, '')}{pretty(x)}" for k, x in enumerate(line.shown))
    rows = tuple(_line_rows(line))
    return Paragraph((sentence(line),), (), rows, texts, after, numbers(line.source), line.fact.id)


def opening(chapter: "Chapter") -> list[tuple[bool, str]]:
    """Return the paragraphs of a chapter's introduction, and which of them are formulas."""
    parts = [part for part in chapter.opening.strip("\n").split("\n\n") if part.strip()]
    formulas = [part.startswith("    ") for part in parts]
    return [
        (is_formula, cleandoc(part) if is_formula else " ".join(part.split()))
        for part, is_formula in zip(parts, formulas, strict=True)
    ]


def in_text(words: Words) -> str:
    """Write a sentence as plain text."""
    return "".join(
        x if isinstance(x, str) else x.text if isinstance(x, Formula) else x.name for x in words
    )


def in_markdown(words: Words) -> str:
    """Write a sentence in Markdown."""
    return "".join(
        formulas(x)
        if isinstance(x, str)
        else f"${x.latex}$"
        if isinstance(x, Formula)
        else f"`{x.name}`"
        for x in words
    )


def in_latex(words: Words) -> str:
    """Write a sentence in LaTeX."""
    return "".join(
        escaped(x)
        if isinstance(x, str)
        else f"${x.latex}$"
        if isinstance(x, Formula)
        else rf"\texttt{{{breakable(x.name)}}}"
        for x in words
    )


def in_html(words: Words) -> Markup:
    """Write a sentence in HTML, with formulas in MathML."""
    found: list[Any] = []
    for x in words:
        if isinstance(x, Formula):
            found.append(Markup(mathml(x.latex, "inline")))
        elif isinstance(x, Code):
            name = code(x.name)
            found.append(tag("a", name, href=f"#{x.anchor}") if x.anchor else name)
        else:
            parts = re.split(r"(\$[^$]*\$)", formulas(x.replace("`", "")))
            found += [_inline(y.strip("$")) if y[:1] == "$" else y for y in parts]
    return join(*found)


def _inline(text: str) -> Markup:
    """Return a formula of a sentence in HTML; powers of words are raised."""
    if power := re.fullmatch(r"\^\{(.*)\}", text):
        return tag("sup", power[1])
    return Markup(mathml(text, "inline"))


WRITERS: dict[str, Callable[[Words], str]] = {
    "text": in_text,
    "markdown": in_markdown,
    "latex": in_latex,
    "html": in_html,
}
"How each format writes a sentence."


def breakable(name: str) -> str:
    """Return the name of a fact or of a context in LaTeX, which may be broken at its parts."""
    return name.replace("_", r"\_\allowbreak ").replace(".", r".\allowbreak ")


def fitted(row: str) -> str:
    r"""Return a row for LaTeX, which shrinks what is too wide and has no place for a break."""
    left, mark, right = row.partition("&")
    if not mark or width(left) + width(right) <= WIDE + 4:
        return row
    return rf"{left}&\fit{{{right}}}"


def displayed(aligned: Iterable[str]) -> Markup:
    """Return aligned rows of LaTeX in MathML."""
    rows = r" \\ ".join(row if "&" in row else f"&{row}" for row in aligned)
    return Markup(mathml(rf"\begin{{align*}}{rows}\end{{align*}}", "block"))


def markdown_display(rows: Iterable[str], tags: str = "") -> str:
    """Return aligned rows of LaTeX as one formula, tagged with the paper's numbers."""
    return _tagged(_joined(rows), tags)


def mathml(text: str, kind: str) -> str:
    """Convert LaTeX to MathML.

    kind: `inline` or `block`.
    """
    from latex2mathml.converter import convert

    return convert(text, display=kind)


def provided(line: "Step") -> Iterator[sympy.Basic]:
    """Return the conditions under which a derivation step holds, as inequalities."""
    return (sympy.Ne(condition, 0, evaluate=False) for condition in line.conditions)


def line_text(line: "Step") -> str:
    """Format a line of a derivation for a terminal."""
    return paragraph_text(paragraph(line))


def paragraph_text(found: Paragraph) -> str:
    """Format a paragraph of an article for a terminal."""
    head = wrapped(f"{in_text(found.sentence)}  {found.numbers}".strip())
    entries = [wrap(in_text(words), COLUMNS, subsequent_indent="    ") for words in found.entries]
    after = [wrapped(in_text(words)) for words in found.after]
    below = [*found.texts, *chain(*entries), *after]
    below += [f"[{found.fact}]"] if found.fact else []
    rows = [f"    {row}".rstrip() for text in below for row in text.split("\n")]
    return "\n".join([*([head] if head else []), *(["", *rows] if rows and head else rows)])


def wrapped(text: str) -> str:
    """Break a text into lines of a terminal."""
    return "\n".join(wrap(text, COLUMNS)) if len(text) > COLUMNS else text


def sentence(line: "Step") -> str:
    """Return the sentence that explains a derivation step and the choice it makes."""
    formula = NAMES.match(line.why) or re.match(r"\w+\(", line.why)
    words = line.why if formula else line.why[:1].upper() + line.why[1:]
    whole = f"{words}; {line.choice}" if line.choice else words
    return whole if whole.endswith("?") else f"{whole}:"


def _tagged(shown: str, tags: str) -> str:
    """Return equations in LaTeX, tagged with the paper's numbers."""
    return rf"{shown}\tag*{{{tag_text(tags)}}}" if tags else shown


def tag_text(tags: str) -> str:
    """Return sources in LaTeX."""
    return escaped(tags).replace("$R^{-1}$ dR/dt", r"$R^{-1}\dot R$")


def aligned(line: "Step") -> str:
    """Return a derivation line's equations in LaTeX, one below the other."""
    return _joined(_line_rows(line))


def _joined(rows: Iterable[str]) -> str:
    first, *others = rows
    if not others and first.count("&") < 2:  # matrices have marks of their own
        return first.replace("&", "")
    below = r" \\ ".join((first, *others))
    return rf"\begin{{aligned}}{below}\end{{aligned}}"


def _line_rows(line: "Step") -> list[str]:
    """Return the aligned rows of a line's equations; those between tuples are alternatives."""
    other = dict.fromkeys(_alternatives(line), r"\text{or }")
    sides = (equation.args for equation in line.shown)
    return aligned_rows(
        (f"{other.get(k, '')}{latex(left)}", "=", latex(right))
        for k, (left, right) in enumerate(sides)
    )


def _alternatives(line: "Step") -> list[int]:
    """Return the indices of equations that hold instead of those before them."""
    shown = enumerate(line.shown)
    return [k for k, equation in shown if k and isinstance(equation.args[0], sympy.Tuple)]


def line_html(line: "Step") -> str:
    """Return a notebook card that shows a line of a derivation.

    It has the sentence, the fact, the equations and the conditions of the line.
    """
    parts = re.split(r"(\$[^$]*\$)", formulas(sentence(line)))
    said = tag("span", *(math(x.strip("$")) if x.startswith("$") else x for x in parts))
    head = tag("div", said, muted(code(line.fact.id)), style=f"{_ROW};padding-top:.4em")
    equations = tag("div", formula(aligned(line)), style=_EQUATIONS)
    body = tag("div", equations, muted(numbers(line.source)), style=_ROW)
    pairs = [(muted(", "), math(latex(condition))) for condition in provided(line)]
    where = [muted("where "), *[*chain(*pairs)][1:]]
    return card(head, body, tag("div", *where, style=_EQUATIONS) if pairs else "")


def line_latex(line: "Step") -> str:
    """Return a derivation line's equations as one LaTeX display with the paper's numbers."""
    return f"$${_tagged(aligned(line), numbers(line.source))}$$"


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
        case sympy.Tuple():
            return Name(rf"\left({', '.join(map(latex, arguments))}\right)")
        case sympy.Derivative():
            return Name(
                rf"\frac{{\partial {latex(arguments[0])}}}{{\partial {latex(arguments[1][0])}}}"
            )
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


def _has_room(name: str) -> bool:
    """Return whether a name is a letter with an index, above which a dot can stand."""
    letter, _, index = name.partition("_")
    return len(index) <= 1 and len(pretty_symbol(letter.rstrip("0123456789"))) == 1


class _Pretty(PrettyPrinter):
    def _print_Symbol(self, e: sympy.Symbol, bold_name: bool = False) -> prettyForm:
        base, _, last = e.name.rpartition("_")
        if last == "squared" and base:
            return prettyForm(f"{pretty_symbol(base)}\N{SUPERSCRIPT TWO}")
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

    def _print_Derivative(self, deriv: Any) -> prettyForm:
        expression, variable = (self._print(x) for x in (deriv.args[0], deriv.args[1][0]))
        return prettyForm(
            *prettyForm("\N{PARTIAL DIFFERENTIAL}").right(
                expression, "/\N{PARTIAL DIFFERENTIAL}", variable
            )
        )

    def _print_Rate(self, e: Any) -> prettyForm:
        """Print a time derivative, as a dot above a letter or as d/dt before an expression."""
        inner = e.args[0]
        if isinstance(inner, sympy.MatrixSymbol) or (inner.is_Symbol and _has_room(inner.name)):
            return self._print_Symbol(sympy.Symbol(f"{inner.name}_rate"))
        shown: Any = self._print(inner)
        return prettyForm(*prettyForm("d/dt ").right(prettyForm(*shown.parens())))
