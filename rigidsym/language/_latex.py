r"""LaTeX of the ledger: names, expressions, statements and hypotheses.

MathJax, KaTeX and Matplotlib can all read it.  A name is read from its parts, so that phi1 is
\phi_{1} and c_a_squared is c_{a}^{2}; the tables have what the parts do not say.  Of sums with very
many terms only some are shown, with \cdots in the place of the others.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rigidsym.language._expression import Call, Expression, Name, Number, Operation, parse

GREEK = frozenset(
    ("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu")
    + ("nu", "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega")
    + ("Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega")
)
VARIANTS = {"epsilon": r"\varepsilon"}
MARKS = {"plus": "+", "minus": "-", "star": r"\star", "squared": "2"}
FUNCTIONS = {"cos": r"\cos", "sin": r"\sin"}
PARTS = {"re": r"\operatorname{Re}", "im": r"\operatorname{Im}"}
_UPRIGHT = (r"\mathrm", r"\op")
MOST_TERMS = 9
_SUM, _PRODUCT, _POWER = 1, 2, 3
RELATIONS = (" != ", " >= ", " <= ", " = ", " > ", " < ")
SIGNS = {"!=": r"\neq", ">=": r"\geq", "<=": r"\leq"}
_ZEROS = {"0", "D(0)"}
_FORMS: dict[str, Callable[[str, str], str]] = {
    "equal": lambda left, right: f"{left} = {right}",
    "unequal": lambda left, right: rf"{left} \neq {right}",
    "root": lambda left, right: rf"{left} = \sqrt{{{right}}}",
    "nonnegative": lambda left, right: rf"{left} = {right} \geq 0",
}


@dataclass(frozen=True, slots=True)
class Symbol:
    """A name in LaTeX: the head, which takes an exponent, and the argument that follows it."""

    head: str
    argument: str = ""
    raised: bool = False

    @property
    def latex(self) -> str:
        """The name without an exponent."""
        return f"{self.head} {self.argument}" if self.argument else self.head

    def power(self, exponent: str) -> str:
        """Return the name to a power."""
        head = rf"\left({self.head}\right)" if self.raised else self.head
        return f"{head}^{{{exponent}}} {self.argument}".rstrip()


def symbol(name: str) -> Symbol:
    """Return a name in LaTeX.

    >>> symbol("Omega1").latex, symbol("sin_half_phi2").power("2")
    ('\\\\Omega_{1}', '\\\\sin^{2} \\\\frac{\\\\phi_{2}}{2}')
    """
    base, _, last = name.rpartition("_")
    first, _, rest = name.partition("_")
    if first in FUNCTIONS and rest:
        return _function(FUNCTIONS[first], rest)
    if first == "sqrt" and rest:
        return Symbol(rf"\sqrt{{{symbol(rest).latex}}}", raised=True)
    if base and last in PARTS:
        return Symbol(PARTS[last], symbol(base).latex)
    if base and last == "squared":
        return Symbol(f"{symbol(base.rstrip('_')).latex}^{{2}}", raised=True)
    if base and last == "rate" and (letter := _letter(base.rstrip("0123456789"))):
        return Symbol(rf"\dot{{{letter}}}" + _below(re.findall(r"\d+", base)))
    if first == "minus" and rest:
        return Symbol(rf"\left(-{symbol(rest).latex}\right)")
    return Symbol(_indexed(name), raised=last == "star")


def _function(head: str, argument: str) -> Symbol:
    half, _, angle = argument.partition("_")
    if half != "half":
        return Symbol(head, symbol(argument).latex)
    return (
        Symbol(head, rf"\frac{{{symbol(angle).latex}}}{{2}}")
        if angle
        else Symbol(rf"{head}_{{1/2}}")
    )


def _indexed(name: str) -> str:
    """Return a base with its indices."""
    base, *below = [part for part in name.split("_") if part]
    letters = base.rstrip("0123456789")
    below = [part for part in (base[len(letters) :], *below) if part]
    bar = letters.endswith("bar") and _letter(letters.removesuffix("bar"))
    head = rf"\bar{{{bar}}}" if bar else _letter(letters) or rf"\mathrm{{{letters}}}"
    if below[-1:] == ["star"]:
        return rf"{head}^{{\star}}" + _below(below[:-1])
    return head + _below(below)


def _below(parts: list[str]) -> str:
    def index(part: str) -> str:
        own = part if part.isdigit() else rf"\mathrm{{{part}}}"
        return MARKS.get(part) or _letter(part) or own

    return f"_{{{','.join(map(index, parts))}}}" if parts else ""


def _letter(text: str) -> str:
    """Return a letter, Latin or Greek, in LaTeX; empty for anything else."""
    if text in GREEK:
        return VARIANTS.get(text, f"\\{text}")
    return text if len(text) == 1 and text.isalpha() else ""


def latex(text: str) -> str:
    r"""Return an expression, given as the kernel reads it, in LaTeX.

    >>> latex("(c2 - c3)/c1*Omega2**2")
    '\\frac{\\left(c_{2} - c_{3}\\right) \\Omega_{2}^{2}}{c_{1}}'
    """
    return of(parse(text))


def of(expression: Expression) -> str:
    """Return an expression tree in LaTeX."""
    match expression:
        case Number(value):
            return str(value)
        case Name(name):
            return symbol(name).latex
        case Operation("**", base, Number(1)):
            return of(base)
        case Operation("**", base, exponent):
            if isinstance(base, Name):
                return symbol(base.name).power(of(exponent))
            return f"{_within(base, _POWER + 1)}^{{{of(exponent)}}}"
        case Operation("+" | "-", _, _) | Call("neg", _):
            return _sum(expression)
        case Operation(_, _, _):
            return _product(expression)
        case Call("D", (argument,)):
            if isinstance(argument, Name) and not symbol(argument.name).argument:
                return _dotted(symbol(argument.name))
            return rf"\frac{{d}}{{dt}} {_within(argument, _PRODUCT)}"
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
    """Return the sign in front of a product, and the product without it."""
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
        text = f"{fraction} {_row(others)}" if others else fraction
        if len(others) == 1 and not numbers:
            text = rf"\frac{{{of(others[0])}}}{{{_row(below)}}}"
    else:
        text = rf"\frac{{{_alone(whole)}}}{{{_alone(below)}}}"
    return f"-{text}" if sign < 0 else text


def _alone(factors: Sequence[Expression]) -> str:
    """Return a product that stands alone, where a single sum needs no brackets."""
    return of(factors[0]) if len(factors) == 1 else _row(factors)


def _factors(expression: Expression) -> tuple[list[Expression], list[Expression]]:
    """Return the factors of the numerator and of the denominator."""
    match expression:
        case Operation("*", left, right):
            (above, below), (more, less) = _factors(left), _factors(right)
            return above + more, below + less
        case Operation("/", left, right):
            (above, below), (less, more) = _factors(left), _factors(right)
            return above + more, below + less
    return ([] if expression == Number(1) else [expression]), []


def _row(factors: Sequence[Expression]) -> str:
    """Return factors side by side: numbers first, functions last, where their arguments end."""
    ordered = sorted(factors, key=_place)
    text = ""
    for k, factor in enumerate(ordered):
        base = _base(factor)
        upright = isinstance(base, Name) and symbol(base.name).latex.startswith(_UPRIGHT)
        between = r" \cdot " if _place(factor) == 0 else r" \, " if upright else " "
        text += f"{between if k else ''}{_within(factor, _PRODUCT + 1)}"
    return text or "1"


def _place(factor: Expression) -> int:
    """Return the rank of a factor: numbers, Latin letters, anything else, functions."""
    base = _base(factor)
    if isinstance(base, Name):
        found = symbol(base.name)
        return 3 if found.argument else 1 if found.head[0].isalpha() else 2
    return 0 if isinstance(base, Number) else 2


def _base(factor: Expression) -> Expression:
    is_power = isinstance(factor, Operation) and factor.operator == "**"
    return factor.left if is_power else factor


def _dotted(whole: Symbol) -> str:
    """Return the rate of a name: a dot above a letter, d/dt before anything longer."""
    letter, _, _ = whole.head.partition("_")
    simple = not whole.raised and letter.removeprefix("\\").isalpha()
    return dotted(whole.head) if simple else rf"\frac{{d}}{{dt}} {whole.latex}"


def dotted(head: str) -> str:
    r"""Return the rate of a quantity: \dot{\Omega}_{i}, with the dot on the letter alone."""
    letter, mark, rest = head.partition("_")
    return rf"\dot{{{letter}}}{mark}{rest}"


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


def word(text: str) -> str:
    """Return the name of a context, upright."""
    escaped = text.replace("_", r"\_")
    return rf"\mathrm{{{escaped}}}"


def statements(fact: Mapping[str, Any]) -> list[str]:
    """Return the components of a statement, each once, without those with two equal sides."""
    if fact["kind"] == "model":
        return [word(fact["rhs"][0])]
    if fact["kind"] == "partition":
        return [r" \sqcup ".join(map(word, fact["rhs"]))]
    pairs = dict.fromkeys(zip(fact["lhs"], fact["rhs"], strict=True))
    telling = [pair for pair in pairs if len({*pair} - _ZEROS) > 0 and pair[0] != pair[1]]
    form = _FORMS[fact["kind"]]
    return [form(latex(left), latex(right)) for left, right in telling or pairs]


def turnstile(kind: str) -> str:
    """Return the sign between hypotheses and statement."""
    return {"model": r"\models", "partition": "="}.get(kind, r"\vdash")


def hypotheses(context: Mapping[str, Any]) -> dict[str, list[str]]:
    """Return the assumptions of a context, by kind."""
    rates = context["rates"] or {}

    def known(rate: str) -> str:
        return r"\mathrm{unknown}" if rate == "?" else latex(rate)

    return {
        "relation": [f"{latex(text)} = 0" for text in context["relations"]],
        "unit": [rf"{latex(text)} \neq 0" for text in context["units"]],
        "sign": [rf"{latex(text)} \geq 0" for text in context["nonnegative"]],
        "rate": [f"{latex(f'D({name})')} = {known(rate)}" for name, rate in rates.items()],
        "definition": [f"{latex(k)} := {latex(v)}" for k, v in context["definitions"].items()],
    }


def condition(text: str) -> str | None:
    """Return a condition such as "c_i != c_j" in LaTeX; None for one in words."""
    for sign in RELATIONS:
        left, found, right = text.partition(sign)
        if found:
            try:
                return f"{latex(left)} {SIGNS.get(sign.strip(), sign.strip())} {latex(right)}"
            except (ValueError, SyntaxError):
                return None
    return None


def point(values: Mapping[str, str]) -> list[str]:
    """Return the coordinates of a rational point."""
    return [f"{latex(name)} = {latex(value)}" for name, value in values.items()]


def listed(parts: Sequence[str]) -> str:
    """Return formulas in one line."""
    return r",\quad ".join(parts)
