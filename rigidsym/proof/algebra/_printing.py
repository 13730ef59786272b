"""Printer of SymPy expressions with a chosen order of names and terms.

SymPy sorts names alphabetically.  A text printed here may become a formula of the number half,
where terms are added in the printed order.  Names have the listed order, terms are sorted by
degree, and positive terms precede negative ones.  What SymPy's `UnevaluatedExpr` holds together is
printed in parentheses, for numbers that need it worked out first.
"""

from collections.abc import Iterable
from typing import Any, TypeAlias

from sympy import Add, Expr, Function, Mul, Pow, Rational, S, Symbol, UnevaluatedExpr

Ranks: TypeAlias = dict[str, int]


def printed(expression: Expr, names: str | Iterable[str]) -> str:
    """Print a rational expression with its names in a chosen order.

    `names` lists all names in that order.
    Raises ValueError for anything but sums, products, whole powers and D of these names.
    >>> from sympy import symbols
    >>> a, b, e = symbols("a b e")
    >>> printed(e*(2*a**2 - b*e) - a + b, "e b a")
    'b - a + e*(2*a**2 - e*b)'
    >>> printed(-3*a/(2*b*(a - e)**2), "e b a")
    '-3*a/(2*b*(a - e)**2)'
    >>> printed(b*UnevaluatedExpr(a/e)**2, "e b a")
    'b*(a/e)**2'
    """
    functions = [f for f in expression.atoms(Function) if f.func.__name__ != "D"]
    roots = [x for x in expression.atoms(Pow) if not x.exp.is_Integer]
    for strange in (*functions, *roots):
        raise ValueError(f"{strange}: not a whole power of a name")
    return _ranked(expression, _listed(names))


def reading(expression: Expr, names: str | Iterable[str]) -> str:
    """Print what a name stands for: an expression that may have functions and square roots.

    Names that are not listed follow those that are, and I and pi follow them.
    >>> from sympy import Function, sqrt, symbols
    >>> a, b, e = symbols("a b e")
    >>> reading(Function("sn")(b*a + 1, e**2)/sqrt(a), "e b")
    'sn(1 + b*a, e**2)/sqrt(a)'
    """
    others = sorted(map(str, expression.free_symbols))
    return _ranked(expression, (*_listed(names), *others, "I", "pi"))


def _listed(names: str | Iterable[str]) -> Iterable[str]:
    return names.split() if isinstance(names, str) else names


def _ranked(expression: Expr, names: Iterable[str]) -> str:
    return _sum(expression, {name: rank for rank, name in enumerate(dict.fromkeys(names))})


def _sum(total: Expr, ranks: Ranks) -> str:
    terms = sorted(_term(term, ranks) for term in Add.make_args(total))
    text = "".join((" - " if negative else " + ") + text for _, negative, _, text in terms)
    return text[3:] if text.startswith(" + ") else f"-{text[3:]}"


def _term(term: Expr, ranks: Ranks) -> tuple[int, bool, list[int], str]:
    """Return the sort key and the text of a term.

    The key is the degree, whether the term is negative, and the ranks of the factors.  The text
    has no sign.
    """
    number, rest = term.as_coeff_Mul()
    if not isinstance(number, Rational):
        raise ValueError(f"{number}: not a rational number")
    pairs = [_powers(factor) for factor in Mul.make_args(rest) if factor != 1]
    if strange := [base**power for base, power in pairs if not power.is_Integer]:
        raise ValueError(f"{strange[0]}: not a whole power")
    above = sorted(_factor(base, int(power), ranks) for base, power in pairs if power > 0)
    below = sorted(_factor(base, -int(power), ranks) for base, power in pairs if power < 0)
    over, under = [text for _, text, _ in above], [text for _, text, _ in below]
    size = abs(number)
    if size.p != 1 or not over:
        over.insert(0, str(size.p))
    if size.q != 1:
        under.insert(0, str(size.q))
    text = "*".join(over)
    if under:
        text += f"/{under[0]}" if len(under) == 1 else f"/({'*'.join(under)})"
    degree = sum(x for *_, x in above) - sum(x for *_, x in below)
    return degree, bool(number < 0), [rank for rank, _, _ in (*above, *below)], text


def _powers(factor: Expr) -> tuple[Expr, Expr]:
    """Return base and exponent, where the base of a half power is the square root."""
    base, power = factor.as_base_exp()
    if power.is_Rational and not power.is_Integer and (2 * power).is_Integer:
        return Pow(base, S.Half), 2 * power
    return base, power


def _factor(base: Expr, power: int, ranks: Ranks) -> tuple[int, str, int]:
    """Return the rank, text and degree of a factor.

    Sums have the last rank.
    """
    inner: Any = base if isinstance(base, Add) else base.args[0] if base.args else base
    if isinstance(base, Add | UnevaluatedExpr):
        rank, text = len(ranks), f"({_sum(inner, ranks)})"
        degree = max(_term(term, ranks)[0] for term in Add.make_args(inner))
    elif isinstance(base, Function | Pow):
        name = base.func.__name__ if isinstance(base, Function) else "sqrt"
        given: Any = base.args if isinstance(base, Function) else (base.base,)
        rank, degree = len(ranks), 1
        text = f"{name}({', '.join(_sum(x, ranks) for x in given)})"
    elif (text := base.name if isinstance(base, Symbol) else str(base)) not in ranks:
        raise ValueError(f"{base}: not one of the names {' '.join(ranks)}")
    else:
        rank, degree = ranks[text], 1
    return rank, text if power == 1 else f"{text}**{power}", degree * power
