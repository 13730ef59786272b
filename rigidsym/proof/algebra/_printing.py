"""Printer of SymPy polynomials with a chosen order of names and terms.

SymPy sorts names alphabetically.  A text printed here may become a formula of the number half,
where terms are added in the printed order.  Names have the listed order, terms are sorted by
degree, and positive terms precede negative ones.
"""

from typing import TypeAlias

from sympy import Add, Expr, Integer, Mul

Ranks: TypeAlias = dict[str, int]


def printed(polynomial: Expr, names: str) -> str:
    """Print a polynomial with its names in a chosen order.

    `names` lists all names in that order.
    Raises ValueError for anything but sums, products and natural powers of these names.
    >>> from sympy import symbols
    >>> a, b, e = symbols("a b e")
    >>> printed(e*(2*a**2 - b*e) - a + b, "e b a")
    'b - a + e*(2*a**2 - e*b)'
    """
    return _sum(polynomial, {name: rank for rank, name in enumerate(names.split())})


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
    factors = sorted(_factor(factor, ranks) for factor in Mul.make_args(rest) if factor != 1)
    texts = [text for _, text, _ in factors]
    size = abs(number)
    if size != 1 or not texts:
        texts.insert(0, str(size))
    degree = sum(degree for _, _, degree in factors)
    return degree, bool(number < 0), [rank for rank, _, _ in factors], "*".join(texts)


def _factor(factor: Expr, ranks: Ranks) -> tuple[int, str, int]:
    """Return the rank, text and degree of a factor.

    Sums have the last rank.
    """
    base, exponent = factor.as_base_exp()
    if not (isinstance(exponent, Integer) and exponent > 0):
        raise ValueError(f"{factor}: not a natural power")
    if isinstance(base, Add):
        rank, text = len(ranks), f"({_sum(base, ranks)})"
        degree = max(_term(term, ranks)[0] for term in base.args)
    elif str(base) not in ranks:
        raise ValueError(f"{base}: not one of the names {' '.join(ranks)}")
    else:
        rank, text, degree = ranks[str(base)], str(base), 1
    power = int(exponent)
    return rank, text if power == 1 else f"{text}**{power}", degree * power
