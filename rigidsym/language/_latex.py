r"""Conversion of names, expressions, statements and hypotheses to LaTeX.

MathJax, KaTeX and Matplotlib can all read it.  A name is read from its parts, so that phi1 is
\phi_{1} and c_a_squared is c_{a}^{2}; the tables have what the parts do not say.  `Printer` writes
expression trees: those of the ledger, and those that `rigidsym.view._article` makes of SymPy's.
"""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
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
JACOBI = {f"jacobi_{name}": rf"\operatorname{{{name}}}" for name in ("sn", "cn", "dn", "am")}
# Functions that formulas of the ledger are read as, besides Jacobi's.
HEADS = {
    "jacobi_argument": r"\operatorname{arg}",
    "elliptic_k": r"\operatorname{K}",
    "elliptic_pi": r"\Pi",
    "elliptic_j": r"\operatorname{J}",
    **{name: rf"\operatorname{{{name}}}" for name in ("arcsc", "arcsn", "nome")},
    **{f"dtheta{k}": rf"\theta_{{{k}}}'" for k in (1, 2, 3, 4)},
    "re": r"\operatorname{Re}",
    "im": r"\operatorname{Im}",
}
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
    """The LaTeX form of a name, split into a head and an argument.

    The head takes exponents.
    """

    head: str
    argument: str = ""
    raised: bool = False

    @property
    def latex(self) -> str:
        """The LaTeX text of the name without an exponent."""
        return f"{self.head} {self.argument}" if self.argument else self.head

    def power(self, exponent: str) -> str:
        """Return the LaTeX text of the name raised to a power."""
        head = rf"\left({self.head}\right)" if self.raised else self.head
        return f"{head}^{{{exponent}}} {self.argument}".rstrip()


def symbol(name: str) -> Symbol:
    """Return the LaTeX form of a name.

    A name with a backslash is LaTeX already and stays as it is.

    >>> symbol("Omega1").latex, symbol("sin_half_phi2").power("2")
    ('\\\\Omega_{1}', '\\\\sin^{2} \\\\frac{\\\\phi_{2}}{2}')
    """
    if "\\" in name:
        return Symbol(name)
    if name == "I":  # the imaginary unit
        return Symbol("i")
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
    if not angle:
        return Symbol(rf"{head}_{{1/2}}")
    return Symbol(head, rf"\frac{{{symbol(angle).latex}}}{{2}}")


def _indexed(name: str) -> str:
    """Return the LaTeX text of a name with its indices."""
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
    """Return the LaTeX text of a Latin or Greek letter.

    Return an empty text for any other name.
    """
    if text in GREEK:
        return VARIANTS.get(text, f"\\{text}")
    return text if len(text) == 1 and text.isalpha() else ""


def place(factor: Expression) -> Any:
    """Return the sort key that orders the factors of a printed product.

    Numbers are first, then Latin letters, then anything else; functions are last, where their
    arguments end.
    """
    base = _base(factor)
    if isinstance(base, Name):
        found = symbol(base.name)
        return 3 if found.argument else 1 if found.head[0].isalpha() else 2
    return 0 if isinstance(base, Number) else 2


@dataclass(frozen=True, slots=True)
class Printer:
    r"""A printer that converts expression trees to LaTeX.

    rank: the sort key of factors in a product.  most: the number of terms of a sum that are shown,
    with \cdots in the place of the others; None for all.  along: the name by which D is the
    derivative, if it is not the time.
    """

    rank: Callable[[Expression], Any] = place
    most: int | None = MOST_TERMS
    along: str = ""

    def of(self, expression: Expression) -> str:
        """Convert an expression tree to LaTeX."""
        match expression:
            case Number(value):
                return str(value)
            case Name(name):
                return symbol(name).latex
            case Operation("**", base, Number(1)):
                return self.of(base)
            case Operation("**", base, exponent):
                return self._power(base, self.of(exponent))
            case Operation("+" | "-", _, _) | Call("neg", _):
                return self._sum(expression)
            case Operation(_, _, _):
                return self._product(expression)
            case Call("times", factors):
                return " ".join(self._within(factor, _PRODUCT) for factor in factors)
            case Call("sqrt", (argument,)):
                return rf"\sqrt{{{self.of(argument)}}}"
            case Call("D", (argument,)) if self.along:
                return self._slope(argument)
            case Call("D", (Name(name),)):
                return self._rate(symbol(name))
            case Call("D", (argument,)):
                return rf"\frac{{d}}{{dt}}\left({self.of(argument)}\right)"
            case Call(function, arguments):
                head, inside = self._call(function, arguments)
                return f"{head}{inside}"
        raise TypeError(f"{expression!r} is not an expression")

    def _slope(self, argument: Expression) -> str:
        by = rf"\partial {symbol(self.along).latex}"
        if isinstance(argument, Name):
            return rf"\frac{{\partial {self.of(argument)}}}{{{by}}}"
        return rf"\frac{{\partial}}{{{by}}}\left({self.of(argument)}\right)"

    def _power(self, base: Expression, exponent: str) -> str:
        """Return the LaTeX text of a power.

        The exponent of a function stands before its argument.
        """
        match base:
            case Name(name):
                return symbol(name).power(exponent)
            case Call(function, arguments) if function in FUNCTIONS or function in JACOBI:
                head, inside = self._call(function, arguments)
                return f"{head}^{{{exponent}}}{inside}"
        return f"{self._within(base, _POWER + 1)}^{{{exponent}}}"

    def _call(self, function: str, arguments: Sequence[Expression]) -> tuple[str, str]:
        """Return the LaTeX texts of a function's name and of its arguments.

        The arguments are in brackets where they need them.
        """
        if function in FUNCTIONS:
            return FUNCTIONS[function], f" {{{self._within(arguments[0], _PRODUCT)}}}"
        between = r" \mid " if function in JACOBI else ", "
        inside = rf"\left({between.join(map(self.of, arguments))}\right)"
        head = JACOBI.get(function) or HEADS.get(function) or symbol(function).latex
        return head, inside

    @staticmethod
    def _rate(whole: Symbol) -> str:
        """Return the LaTeX text of a time derivative.

        It is a dot above a single letter, and d/dt before a longer name.
        """
        letter, _, _ = whole.head.partition("_")
        simple = not whole.raised and letter.removeprefix("\\").isalpha() and not whole.argument
        return dotted(whole.head) if simple else rf"\frac{{d}}{{dt}} {whole.latex}"

    def _sum(self, expression: Expression) -> str:
        terms = _terms(expression, 1)
        shown = terms
        if self.most is not None and len(terms) > self.most:
            shown = terms[: self.most - 2]
        text = "".join(self._signed(sign, term) for sign, term in shown)
        if len(shown) < len(terms):
            text += rf" + \cdots{self._signed(*terms[-1])}"
        return f"-{text[3:]}" if text.startswith(" -") else text[3:]

    def _signed(self, sign: int, term: Expression) -> str:
        minus, bare = signed(term)
        return f" {'-' if sign * minus < 0 else '+'} {self._within(bare, _PRODUCT)}"

    def _product(self, expression: Expression) -> str:
        sign, bare = signed(expression)
        above, below = _factors(bare)
        whole = [factor for factor in above if factor != Number(1)]
        numbers = [factor for factor in whole if isinstance(factor, Number)]
        others = [factor for factor in whole if not isinstance(factor, Number)]
        if not below:
            text = self._row(whole)
        elif whole and all(isinstance(factor, Number) for factor in below):
            if len(others) == 1 and not numbers:
                text = rf"\frac{{{self.of(others[0])}}}{{{self._row(below)}}}"
            else:
                text = rf"\frac{{{self._row(numbers)}}}{{{self._row(below)}}}"
                text += f" {self._row(others)}" if others else ""
        else:
            text = rf"\frac{{{self._alone(whole)}}}{{{self._alone(below)}}}"
        return f"-{text}" if sign < 0 else text

    def _alone(self, factors: Sequence[Expression]) -> str:
        """Return the LaTeX text of a numerator or denominator.

        A single factor that is a sum has no brackets.
        """
        return self.of(factors[0]) if len(factors) == 1 else self._row(factors)

    def _row(self, factors: Iterable[Expression]) -> str:
        """Return the LaTeX text of a product, with its factors sorted."""
        text = ""
        for k, factor in enumerate(sorted(factors, key=self.rank)):
            base = _base(factor)
            upright = isinstance(base, Name) and symbol(base.name).latex.startswith(_UPRIGHT)
            between = r" \cdot " if isinstance(base, Number) else r" \, " if upright else " "
            text += f"{between if k else ''}{self._within(factor, _PRODUCT + 1)}"
        return text or "1"

    def _within(self, expression: Expression, bound: int) -> str:
        text = self.of(expression)
        return text if self._binding(expression) >= bound else rf"\left({text}\right)"

    def _binding(self, expression: Expression) -> int:
        match expression:
            case Operation("+" | "-", _, _) | Call("neg", _):
                return _SUM
            case Operation("*" | "/", _, _) | Call("times", _):
                return _PRODUCT
            case Operation("**", base, Number(1)):
                return self._binding(base)
            case Operation("**", _, _):
                return _POWER
            case Call("D", _) if not self.of(expression).startswith(r"\dot"):
                return _PRODUCT
        return _POWER + 1


def signed(term: Expression) -> tuple[int, Expression]:
    """Split a product into its sign and the product without its sign."""
    match term:
        case Call("neg", (inner,)):
            sign, bare = signed(inner)
            return -sign, bare
        case Operation("*" | "/" as symbol_, left, right):
            sign, bare = signed(left)
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


def _factors(expression: Expression) -> tuple[list[Expression], list[Expression]]:
    """Return the factors of a product's numerator and denominator as two lists."""
    match expression:
        case Operation("*" | "/" as operator, left, right):
            (above, below), (more, less) = _factors(left), _factors(right)
            if operator == "/":
                more, less = less, more
            return above + more, below + less
    return ([] if expression == Number(1) else [expression]), []


def _base(factor: Expression) -> Expression:
    is_power = isinstance(factor, Operation) and factor.operator == "**"
    return factor.left if is_power else factor


def dotted(head: str) -> str:
    r"""Put a dot above the letter of a LaTeX name.

    For example, \Omega_{i} becomes \dot{\Omega}_{i}.
    """
    letter, mark, rest = head.partition("_")
    return rf"\dot{{{letter}}}{mark}{rest}"


of = Printer().of


def latex(text: str, along: str | None = None, most: int | None = MOST_TERMS) -> str:
    r"""Convert an expression of the ledger to LaTeX.

    along: the name by which D differentiates, if it is not the time.  most: the number of terms of
    a sum that are shown; None for all.

    >>> latex("(c2 - c3)/c1*Omega2**2")
    '\\frac{\\left(c_{2} - c_{3}\\right) \\Omega_{2}^{2}}{c_{1}}'
    """
    plain = not along and most == MOST_TERMS
    return (of if plain else Printer(most=most, along=along or "").of)(parse(text))


def word(text: str) -> str:
    """Return the LaTeX text of a context's name, in upright letters."""
    escaped = text.replace("_", r"\_")
    return rf"\mathrm{{{escaped}}}"


def statements(fact: Mapping[str, Any]) -> list[str]:
    """Return the distinct components of a statement in LaTeX.

    Components with two equal sides are left out.
    """
    if fact["kind"] == "model":
        return [word(fact["rhs"][0])]
    if fact["kind"] == "partition":
        return [r" \sqcup ".join(map(word, fact["rhs"]))]
    pairs = dict.fromkeys(zip(fact["lhs"], fact["rhs"], strict=True))
    telling = [pair for pair in pairs if len({*pair} - _ZEROS) > 0 and pair[0] != pair[1]]
    form = _FORMS[fact["kind"]]
    return [form(latex(left), latex(right)) for left, right in telling or pairs]


def turnstile(kind: str) -> str:
    """Return the LaTeX symbol between the hypotheses and the statement of a fact."""
    return {"model": r"\models", "partition": "="}.get(kind, r"\vdash")


def hypotheses(context: Mapping[str, Any]) -> dict[str, list[str]]:
    """Return the assumptions of a context in LaTeX, grouped by kind."""
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
    """Return a condition such as "c_i != c_j" in LaTeX.

    Return None for a condition in words.
    """
    for sign in RELATIONS:
        left, found, right = text.partition(sign)
        if found:
            try:
                return f"{latex(left)} {SIGNS.get(sign.strip(), sign.strip())} {latex(right)}"
            except (ValueError, SyntaxError):
                return None
    return None


def point(values: Mapping[str, str]) -> list[str]:
    """Return the coordinates of a rational point in LaTeX."""
    return [f"{latex(name)} = {latex(value)}" for name, value in values.items()]


def listed(parts: Iterable[str]) -> str:
    """Join LaTeX formulas into one line."""
    return r",\quad ".join(parts)
