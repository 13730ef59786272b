"""How the notebooks show what the project proves: facts, verdicts and matrices as mathematics.

Nothing is derived here.  Statements come from a ledger, whether it has just been written by
chapters of `derivations` or replayed from the sealed one; here they are only typeset.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from importlib import import_module
from math import prod
from typing import Any

import sympy
from IPython.display import Markdown, Math

from derivations import CHAPTERS
from rigidsym.algebra import Book
from rigidsym.algebra.enclosures import encloses
from rigidsym.algebra.su2 import Complex, Matrix
from rigidsym.kernel import Element, Fact, Grade, Ledger, replay
from rigidsym.kernel.ring import at
from rigidsym.paper import EQUATIONS, Flaw, Reading, Ruling, Verdict
from rigidsym.solution import ledger_text
from rigidsym.solution.expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    names,
    parse,
)

LONG = 110  # sides of statements with more characters are described, not printed

BADGES = {
    Ruling.HOLDS: ("✔", "#1a7f37"),
    Ruling.CONDITIONAL: ("✔", "#9a6700"),
    Ruling.MISPRINT: ("✘", "#cf222e"),
    Ruling.AMBIGUOUS: ("≟", "#8250df"),
    Ruling.OPEN: ("?", "#57606a"),
    Grade.PROVED: ("✔", "#1a7f37"),
    Grade.ENCLOSED: ("◎", "#9a6700"),
}


# Ledgers


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


# What is shown


def badge(value: Ruling | Grade) -> str:
    """A ruling or a grade as a coloured word, which stays a word where colours are not shown."""
    sign, colour = BADGES.get(value, ("?", "#57606a"))
    return f'<span style="color: {colour}">**{sign} {value.value}**</span>'


def show(ledger: Ledger, *facts: str) -> Markdown:
    """Facts with their grade, what they state and what they suppose not to be zero."""
    return Markdown("\n\n".join(_fact(ledger, ledger.facts[fact]) for fact in facts))


def definitions(ledger: Ledger, context: str, *names: str) -> Markdown:
    """What names abbreviate in a context."""
    defined = ledger.contexts[context].definitions
    return Markdown("\n\n".join(f"$${_name(n)} = {latex(defined[n])}$$" for n in names))


def printed(*numbers: str) -> Markdown:
    """Equations of the paper, exactly as printed."""
    found = {equation.number: equation for equation in EQUATIONS}
    return Markdown(
        "\n\n".join(f"*Printed:* {_tag(n)}\n\n$${found[n].latex}$$" for n in numbers),
    )


def page(ledger: Ledger, verdict: Verdict) -> Markdown:
    """The verdict on one printed equation: print, mended form, hypotheses, counterexamples."""
    return Markdown("\n\n".join(_verdict(ledger, verdict)))


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
    return sympy.Symbol(_name(name))


def values(ledger: Ledger, fact: str) -> tuple[list[Fraction], list[Fraction]]:
    """Both sides of a refuted statement at its counterexample, in exact numbers."""
    there = ledger.facts[fact]
    context, ring = ledger.contexts[there.context], ledger.rings[there.context]
    point = context.check_point(ring, there.certificate["point"])

    def value(text: str) -> Fraction:
        element = ring.read(text)
        units = (at(unit, point) ** p for unit, p in zip(ring.units, element.powers, strict=True))
        return Fraction(str(at(element.numerator, point) / prod(units)))

    return [value(text) for text in there.lhs], [value(text) for text in there.rhs]


# Facts


def _fact(ledger: Ledger, fact: Fact) -> str:
    relation = {"equal": "=", "root": "=", "nonnegative": "=", "unequal": r"\not\equiv"}
    head = f"{badge(fact.grade)} &nbsp;`{fact.id}`"
    if fact.kind not in relation:
        return head
    pairs = list(zip(fact.lhs, fact.rhs, strict=True))
    open_pairs = [pair for pair in pairs if pair[0] != pair[1]]
    size = f"{len(pairs)} component{'s' if len(pairs) > 1 else ''}"
    if not open_pairs:
        return f"{head} &nbsp;({size}, the same on both sides once multiplied out)"
    if max(len(side) for pair in open_pairs for side in pair) > LONG:
        return f"{head} &nbsp;({size}, long polynomials)"
    lines = [
        rf"{latex(left)} {relation[fact.kind]} {_right(fact, right)}" for left, right in open_pairs
    ]
    row, column = r",\qquad ".join(lines), r" \\ ".join(lines)
    short = len(row) < 130
    body = row if short else rf"\begin{{gathered}} {column} \end{{gathered}}"
    return f"{head}\n\n$${body}$$"


def _right(fact: Fact, text: str) -> str:
    if fact.kind == "root":
        return rf"+\sqrt{{{latex(text)}}}"
    return latex(text) + (r"\ \ge 0" if fact.kind == "nonnegative" else "")


# Verdicts


def _verdict(ledger: Ledger, verdict: Verdict) -> Iterator[str]:
    equation, mended = verdict.equation, verdict.ruling == Ruling.MISPRINT
    yield "<hr>"
    yield f"**{_tag(equation.number)}** &nbsp; {badge(verdict.ruling)}"
    yield f"$${equation.latex}$$"
    if mended:
        yield "*Derived, in its place:*"
        yield f"$${equation.repair}$$"
    yield f"*{'Why' if mended else 'Read as'}:* {_prose(equation.reading)}."
    if verdict.conditions:
        yield "*Hypotheses:* " + ", &nbsp; ".join(map(_condition, verdict.conditions)) + "."
    yield from (_counterexample(ledger, fact) for fact in equation.refuted_by)
    if equation.readings:
        yield "*Ways to read it:*"
        yield "\n".join(_reading(ledger, reading) for reading in equation.readings)
    if equation.flaws:
        yield "*In the print:*"
        yield "\n".join(f"* {f.value}: {_flaw(f, text)}" for f, text in equation.flaws.items())
    names = ", ".join(f"`{name}`" for name in equation.proved_by)
    yield f"*Rests on* {names}: {', '.join(sorted(grades(ledger, *equation.proved_by)))}."


def _reading(ledger: Ledger, reading: Reading) -> str:
    """One reading, and both sides of what refutes it."""
    word = "fails" if reading.refuted_by else "holds"
    line = f"* {word}: *{_prose(reading.text)}*; {_prose(reading.implies)}"
    found = ", ".join(
        rf"`{name}`: ${_fraction(x)} \ne {_fraction(y)}$"
        for name in reading.refuted_by
        for _, _, x, y in [_failing(ledger, name)]
    )
    return f"{line} ({found})" if found else line


def _failing(ledger: Ledger, name: str) -> tuple[str, str, Fraction, Fraction]:
    """The first component that fails at a counterexample: both sides and their values there."""
    fact = ledger.facts[name]
    sides = zip(fact.lhs, fact.rhs, *values(ledger, name), strict=True)
    return next(side for side in sides if side[2] != side[3])


def _counterexample(ledger: Ledger, name: str) -> str:
    """Where a statement fails: the point, the statement, and both sides there."""
    fact = ledger.facts[name]
    left, right, x, y = _failing(ledger, name)
    point = ", ".join(
        f"${_name(key)}={_fraction(value)}$" for key, value in fact.certificate["point"].items()
    )
    fails = rf"{_fraction(x)} \ne {_fraction(y)}"
    if max(len(left), len(right)) <= LONG:
        fails = rf"{latex(left)} = {latex(right)}\quad\text{{fails:}}\quad {fails}"
    else:
        fails = rf"\text{{one side and the other:}}\quad {fails}"
    where = _definitions(ledger, fact, left, right)
    return f"*Counterexample* `{name}`: at {point}{where}\n\n$${fails}$$"


def _definitions(ledger: Ledger, fact: Fact, *sides: str) -> str:
    """What the long names in a statement abbreviate."""
    defined = ledger.contexts[fact.context].definitions
    used = dict.fromkeys(name for side in sides for name in names(parse(side)))
    told = [
        f"${_name(name)} = {latex(defined[name])}$"
        for name in used
        if name in defined and "mathrm" in _name(name) and max(map(len, sides)) <= LONG
    ]
    return f", where {', '.join(told)}" if told else ""


def _tag(number: str) -> str:
    if number[0].isdigit():
        return f"({number})"
    return "the display without a number" if "dt" in number else number[0].upper() + number[1:]


def _condition(text: str) -> str:
    for word, sign in ((" != ", r"\ne"), (" >= ", r"\ge"), (" > ", ">"), (" = ", "=")):
        if word in text:
            sides = text.split(word)
            try:
                return f"${latex(sides[0])} {sign} {latex(sides[1])}$"
            except (SyntaxError, ValueError):
                return f"${sides[0]} {sign} {sides[1]}$"
    return _prose(text)


# Quantities in a sentence: Greek words, and letters with an index; each with its power, if any.
_QUANTITY = re.compile(
    r"(?<![\w\\])((?:Omega|alpha|beta|chi|kappa|delta|phi|mu|zeta|xi)(?:_?[0-9a-z])?(?![a-z])"
    r"|[A-Za-z]_[0-9a-z]+|[cFSKAqs][0-4](?!\w))('?)(\^[0-9])?(?!\w)"
)


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _prose(text: str) -> str:
    """A sentence of plain text in Markdown, which must not take c_i and y* for emphasis."""

    def plain(part: str) -> str:
        for word, sign in (("<=", "≤"), (">=", "≥"), ("!=", "≠")):
            part = part.replace(word, sign)
        part = re.sub(r"\^(-?[0-9])", lambda found: found[1].translate(_RAISED), part)
        return re.sub(r"([_*^|\\<>#\[\]])", r"\\\1", part)

    parts, end = [], 0
    for found in _QUANTITY.finditer(text):
        parts += [
            plain(text[end : found.start()]),
            f"${_name(found[1])}{found[2]}{found[3] or ''}$",
        ]
        end = found.end()
    return "".join((*parts, plain(text[end:])))


def _quantity(name: str, prime: str, power: str) -> str:
    return f"{_dotted(_name(name)) if prime else _name(name)}{power}"


def _flaw(flaw: Flaw, text: str) -> str:
    return f"${text}$" if flaw == Flaw.UNDEFINED else _prose(text)


def _fraction(value: Any) -> str:
    fraction = Fraction(value)
    if fraction.denominator == 1:
        return str(fraction)
    sign = "-" if fraction < 0 else ""
    return rf"{sign}\tfrac{{{abs(fraction.numerator)}}}{{{fraction.denominator}}}"


# Expressions


def _side(side: Any) -> str:
    return side if isinstance(side, str) else sympy.latex(side)


_GREEK = {
    *("alpha", "beta", "gamma", "delta", "zeta", "theta", "kappa", "lambda", "mu", "nu", "xi"),
    *("rho", "sigma", "tau", "phi", "psi", "chi", "omega"),
}
_FIXED = {
    "K_squared": "K^2",
    "Pi": r"\Pi",
    "Pi_c": r"\Pi_{\mathrm{c}}",
    "Pi_later": r"\Pi_{\mathrm{later}}",
    "y_star": r"y^\star",
    "epsilon": r"\varepsilon",
    "sine": r"\sin\vartheta",
    "cosine": r"\cos\vartheta",
    "theta": r"\vartheta",
    **{f"{name}_half": rf"\{name}\tfrac{{\phi_{{3}}}}{{2}}" for name in ("cos", "sin")},
    **{name: rf"\mathrm{{{name}}}" for name in ("sn", "cn", "dn")},
}


def _name(name: str) -> str:
    """A name of a context in LaTeX."""
    if name in _FIXED:
        return _FIXED[name]
    if found := re.fullmatch("(cos|sin)_(half_)?([a-z]+[0-9]?)", name):
        angle = _name(found[3])
        return rf"\{found[1]}" + (rf"\tfrac{{{angle}}}{{2}}" if found[2] else f" {angle}")
    if found := re.fullmatch("sqrt_(.+)|root_(s)", name):
        return rf"\sqrt{{{_name(found[1] or 's_j')}}}"
    if found := re.fullmatch("(.+)_rate", name):
        return _dotted(_name(found[1])) if "_" not in found[1] else _words(name)
    head, index = re.findall("^([A-Za-z]+)_?(.*)$", name)[0]
    lower = head.lower()
    symbol = rf"\{head}" if lower in _GREEK else head if len(head) == 1 else ""
    if not symbol:
        return _words(name)
    if not index:
        return symbol
    return (
        rf"{symbol}_{{{index}}}" if len(index) < 3 else rf"{symbol}_{{\mathrm{{{_spaced(index)}}}}}"
    )


def _words(name: str) -> str:
    return rf"\mathrm{{{_spaced(name)}}}"


def _spaced(name: str) -> str:
    return name.replace("_", r"\ ")


def latex(text: str) -> str:
    """A side of a statement in LaTeX, term by term as it is written."""
    return _latex(parse(text))[0]


_SUM, _NEGATIVE, _PRODUCT, _POWER, _ATOM = range(5)


def _latex(expression: Expression) -> tuple[str, int]:
    match expression:
        case Number(value):
            return str(value), _ATOM
        case Name(name):
            found = _name(name)
            return found, _POWER if "^" in found or found.startswith((r"\cos", r"\sin")) else _ATOM
        case Call("neg", (operand,)):
            return f"-{_within(operand, _PRODUCT)}", _NEGATIVE
        case Call("D", (Name(name),)):
            return _dotted(_name(name)), _ATOM
        case Call("D", (operand,)):
            return rf"\frac{{d}}{{dt}}\left({_latex(operand)[0]}\right)", _PRODUCT
        case Operation("/", Call("neg", (left,)), right):
            return f"-{_latex(Operation('/', left, right))[0]}", _NEGATIVE
        case Operation("/", left, right):
            return rf"\frac{{{_latex(left)[0]}}}{{{_latex(right)[0]}}}", _PRODUCT
        case Operation("*", left, right):
            first, second = _within(left, _NEGATIVE), _within(right, _PRODUCT)
            dot = r"\cdot " if second[0].isdigit() else r"\,"
            return f"{first}{dot}{second}", _NEGATIVE if first[0] == "-" else _PRODUCT
        case Operation("**", Name(name), Number(power)) if name.startswith(("cos_", "sin_")):
            function, angle = _name(name)[:4], _name(name)[4:]
            return rf"{function}^{{{power}}}{angle}", _POWER
        case Operation("**", left, Number(1)):
            return _latex(left)
        case Operation("**", left, right):
            return rf"{_within(left, _ATOM)}^{{{_latex(right)[0]}}}", _POWER
        case Operation(sign, left, right):
            return f"{_latex(left)[0]} {sign} {_within(right, _PRODUCT)}", _SUM
    raise ValueError(f"{expression!r}: not part of a statement")


def _dotted(symbol: str) -> str:
    """The time derivative of a symbol, the dot over its letter alone."""
    found = re.fullmatch(r"(\\?[A-Za-z]+)(_\{.*\})?", symbol)
    return rf"\dot{{{found[1]}}}{found[2] or ''}" if found else rf"\frac{{d}}{{dt}} {symbol}"


def _within(expression: Expression, bound: int) -> str:
    found, own = _latex(expression)
    return found if own >= bound else rf"\left({found}\right)"


def table(rows: Iterable[Mapping[str, Any]]) -> Markdown:
    """Rows with the same keys as a table."""
    listed = list(rows)
    lines = [
        list(listed[0]),
        ["---"] * len(listed[0]),
        *([*map(str, row.values())] for row in listed),
    ]
    return Markdown("\n".join(f"| {' | '.join(line)} |" for line in lines))
