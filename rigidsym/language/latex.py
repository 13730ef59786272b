r"""Expressions of the ledger in LaTeX, within what MathJax, KaTeX and Matplotlib can all read.

Sums of very many terms are shown in part, with \cdots in the place of what is left out.
"""

from collections.abc import Sequence

from rigidsym.language.expression import Call, Expression, Name, Number, Operation, parse
from rigidsym.language.symbols import Symbol, symbol

MOST_TERMS = 9
_SUM, _PRODUCT, _POWER = 1, 2, 3


def latex(text: str) -> str:
    r"""An expression as the kernel reads it, in LaTeX.

    >>> latex("(c2 - c3)/c1*Omega2**2")
    '\\frac{\\left(c_{2} - c_{3}\\right) \\Omega_{2}^{2}}{c_{1}}'
    """
    return of(parse(text))


def of(expression: Expression) -> str:
    """An expression tree in LaTeX."""
    match expression:
        case Number(value):
            return str(value)
        case Name(name):
            return symbol(name).latex
        case Operation("**", base, Number(1)):
            return of(base)
        case Operation("**", base, exponent):
            return _power(base, of(exponent))
        case Operation("+" | "-", _, _) | Call("neg", _):
            return _sum(expression)
        case Operation(_, _, _):
            return _product(expression)
        case Call("D", (argument,)):
            return _rate(argument)
        case Call(function, arguments):
            return rf"{symbol(function).latex}\left({', '.join(map(of, arguments))}\right)"
    raise TypeError(f"{expression!r} is not an expression")


def _sum(expression: Expression) -> str:
    terms = _terms(expression, 1)
    shown = terms if len(terms) <= MOST_TERMS else terms[: MOST_TERMS - 2]
    text = "".join(_signed(sign, term) for sign, term in shown)
    if len(shown) < len(terms):
        text += rf" + \cdots{_signed(*terms[-1])}"
    return f"-{text[3:]}" if text.startswith(" -") else text[3:]


def _signed(sign: int, term: Expression) -> str:
    minus, bare = _sign(term)
    return f" {'-' if sign * minus < 0 else '+'} {_within(bare, _PRODUCT)}"


def _sign(term: Expression) -> tuple[int, Expression]:
    """The sign in front of a product, and the product without it."""
    match term:
        case Call("neg", (inner,)):
            sign, bare = _sign(inner)
            return -sign, bare
        case Operation("*" | "/" as symbol_, left, right):
            sign, bare = _sign(left)
            return sign, Operation(symbol_, bare, right)
    return 1, term


def _terms(expression: Expression, sign: int) -> list[tuple[int, Expression]]:
    match expression:
        case Operation("+" | "-" as operator, left, right):
            other = sign if operator == "+" else -sign
            return [*_terms(left, sign), *_terms(right, other)]
        case Call("neg", (inner,)):
            return _terms(inner, -sign)
    return [(sign, expression)]


def _product(expression: Expression) -> str:
    sign, bare = _sign(expression)
    above, below = _factors(bare)
    whole = [factor for factor in above if factor != Number(1)]
    if not below:
        text = _row(whole)
    elif all(isinstance(factor, Number) for factor in below) and len(whole) > 0:
        numbers = [factor for factor in whole if isinstance(factor, Number)]
        others = [factor for factor in whole if not isinstance(factor, Number)]
        fraction = rf"\frac{{{_row(numbers)}}}{{{_row(below)}}}"
        plain = len(others) == 1 and not numbers
        text = rf"\frac{{{of(others[0])}}}{{{_row(below)}}}" if plain else fraction + _after(others)
    else:
        text = rf"\frac{{{_alone(whole)}}}{{{_alone(below)}}}"
    return f"-{text}" if sign < 0 else text


def _after(factors: Sequence[Expression]) -> str:
    return f" {_row(factors)}" if factors else ""


def _alone(factors: Sequence[Expression]) -> str:
    """A product in a place of its own, where one sum needs no brackets."""
    return of(factors[0]) if len(factors) == 1 else _row(factors)


def _factors(expression: Expression) -> tuple[list[Expression], list[Expression]]:
    """What is above and what is below the line."""
    match expression:
        case Operation("*", left, right):
            (above, below), (more, less) = _factors(left), _factors(right)
            return above + more, below + less
        case Operation("/", left, right):
            (above, below), (less, more) = _factors(left), _factors(right)
            return above + more, below + less
    return ([] if expression == Number(1) else [expression]), []


def _row(factors: Sequence[Expression]) -> str:
    """Factors side by side: numbers first, functions last, where their argument ends with them."""
    ordered = sorted(factors, key=_place)
    text = ""
    for k, factor in enumerate(ordered):
        two_numbers = k and _place(factor) == 0
        apart = r" \cdot " if two_numbers else r" \, " if _is_word(factor) else " "
        text += f"{apart if k else ''}{_within(factor, _PRODUCT + 1)}"
    return text or "1"


def _place(factor: Expression) -> int:
    """Numbers, Latin letters, anything else, functions."""
    base = _base(factor)
    if isinstance(base, Name):
        found = symbol(base.name)
        return 3 if found.argument else 1 if found.head[0].isalpha() else 2
    return 0 if isinstance(base, Number) else 2


def _is_word(factor: Expression) -> bool:
    base = _base(factor)
    return isinstance(base, Name) and symbol(base.name).latex.startswith((r"\mathrm", r"\op"))


def _base(factor: Expression) -> Expression:
    is_power = isinstance(factor, Operation) and factor.operator == "**"
    return factor.left if is_power else factor


def _power(base: Expression, exponent: str) -> str:
    if isinstance(base, Name):
        return symbol(base.name).power(exponent)
    return f"{_within(base, _POWER + 1)}^{{{exponent}}}"


def _rate(argument: Expression) -> str:
    if isinstance(argument, Name) and not symbol(argument.name).argument:
        return _dotted(argument.name, symbol(argument.name))
    return rf"\frac{{d}}{{dt}} {_within(argument, _PRODUCT)}"


def _dotted(name: str, whole: Symbol) -> str:
    """A dot above a letter, d/dt before anything longer."""
    letter, below, index = whole.head.partition("_")
    simple = not whole.raised and letter.removeprefix("\\").isalpha()
    return rf"\dot{{{letter}}}{below}{index}" if simple else rf"\frac{{d}}{{dt}} {whole.latex}"


def _within(expression: Expression, bound: int) -> str:
    text = of(expression)
    return text if _binding(expression) >= bound else rf"\left({text}\right)"


def _binding(expression: Expression) -> int:
    match expression:
        case Operation("+" | "-", _, _) | Call("neg", _):
            return _SUM
        case Operation("*" | "/", _, _):
            return _PRODUCT
        case Operation("**", base, Number(1)):
            return _binding(base)
        case Operation("**", _, _):
            return _POWER
        case Call("D", _) if not of(expression).startswith(r"\dot"):
            return _PRODUCT
    return _POWER + 1
