"""Expressions of special functions as text: sums with whole coefficients, and Horner's scheme."""

from collections.abc import Mapping, Sequence


def linear(terms: Mapping[str, int]) -> str:
    """The sum of coefficient times name; the name "1" stands for the number.

    >>> linear({"1": 1, "a": -4, "b": 1, "c": 0})
    '1 - 4*a + b'
    """
    text = ""
    for name, factor in terms.items():
        if not factor:
            continue
        size = abs(factor)
        term = str(size) if name == "1" else name if size == 1 else f"{size}*{name}"
        if text:
            text += f" {'-' if factor < 0 else '+'} {term}"
        else:
            text = f"-{term}" if factor < 0 else term
    return text or "0"


def horner(variable: str, coefficients: Sequence[str]) -> str:
    """The polynomial with these coefficients, lowest first.

    >>> horner("x", ["a", "b", "c"])
    'a + x*(b + x*c)'
    """
    first, *rest = coefficients
    if not rest:
        return first
    inner = horner(variable, rest)
    return f"{first} + {variable}*({inner})" if len(rest) > 1 else f"{first} + {variable}*{inner}"
