"""Conversion between SymPy expressions and the names of a context.

The kernel has names only: `cos_half_phi1` is a generator whose reading is cos(phi1/2).  SymPy works
with the function if a reading is one; `Dictionary` converts between the two.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import sympy
from sympy import Expr, Mul
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from rigidsym.language._expression import parse
from rigidsym.language.functions._translation import BY_PARAMETER, sympified
from rigidsym.proof.algebra import Part
from rigidsym.proof.algebra._computation import Computation, compute, computed, plain
from rigidsym.proof.algebra._rational import factor
from rigidsym.proof.kernel import Context
from rigidsym.proof.steps._record import StepError


def symbol(name: str) -> sympy.Symbol:
    """Return SymPy's real symbol for a name."""
    return sympy.Symbol(name, real=True)


def symbols(text: str) -> tuple[sympy.Symbol, ...]:
    """Return SymPy's real symbols for several names.

    For example: `symbols("c1 c2 c3")`.
    """
    return tuple(map(symbol, text.split()))


def read(text: str) -> sympy.Expr:
    """Convert an expression of the ledger to SymPy.

    All symbols are real.  The text may also be a name's reading.
    """
    return sympified(parse(text), symbol, BY_PARAMETER)


def expressions(table: Mapping[Any, Any]) -> dict[sympy.Symbol, Computation]:
    """Return definitions or rates of a part as expressions of real symbols, by name."""
    found = {}
    for name, side in table.items():
        value = compute(read(side) if isinstance(side, str) else side)
        whole = sympy.sympify(value.value)
        real = {x: symbol(str(x)) for x in whole.free_symbols}
        found[symbol(str(name))] = replace(value, value=whole.xreplace(real))
    return found


def unfold(expression: Expr | Computation, *parts: Part) -> Computation:
    """Replace names by their definitions in parts, until none of these names is left."""
    found, table = compute(expression), {}
    for part in parts:
        table |= expressions(part.definitions)
    while known := {x: table[x] for x in found.free_symbols if x in table}:
        found = found.xreplace(known)
    return found


class Dictionary:
    """Two-way mapping between the names of a context and the functions they stand for."""

    def __init__(self, context: Context) -> None:
        self.context = context

    @cached_property
    def names(self) -> Mapping[Any, sympy.Symbol]:
        """The name of each function, such as cos_half_phi1 for cos(phi1/2)."""
        found = {}
        for name, reading in self.context.reading.items():
            try:
                meaning = read(reading)
            except (ValueError, SyntaxError):
                continue  # words
            if isinstance(meaning, sympy.Function):
                found[meaning] = symbol(name)
        return found

    @cached_property
    def functions(self) -> Mapping[sympy.Symbol, sympy.Expr]:
        """The function of each name, such as cos(phi1/2) for cos_half_phi1."""
        return {name: function for function, name in self.names.items()}

    def named(self, expression: sympy.Expr) -> sympy.Expr:
        """Replace functions in an expression by their names."""
        return sympy.sympify(expression).xreplace(dict(self.names))

    def meant(self, expression: sympy.Expr) -> sympy.Expr:
        """Replace names in an expression by their functions."""
        return expression.xreplace(dict(self.functions))

    def text(self, expression: sympy.Expr | Computation | int) -> str:
        """Convert a SymPy expression to text that the kernel can parse.

        Raises StepError if a part has no name.
        """
        named = self.named(sympy.sympify(plain(expression)))
        strange = [f for f in named.atoms(sympy.Function) if f.func.__name__ != "D"]
        if strange := sorted(map(str, (*strange, *named.atoms(sympy.core.numbers.ImaginaryUnit)))):
            raise StepError(f"{strange[0]} has no name in {self.context.name}")
        return computed(_Printer().doprint(named), expression)


class _Printer(StrPrinter):
    """Printer of SymPy expressions with quotients in place of negative powers."""

    def _print_Pow(self, expr: sympy.Pow, rational: bool = False) -> str:
        base, exponent = expr.as_base_exp()
        if not exponent.is_Integer:
            raise StepError(f"{expr}: the kernel knows whole powers only")
        inner = self.parenthesize(base, PRECEDENCE["Pow"])
        if exponent > 0:
            return inner if exponent == 1 else f"{inner}**{exponent}"
        return f"1/{inner}" if exponent == -1 else f"1/{inner}**{-exponent}"


def collected(expression: Expr) -> Expr:
    """Rewrite an expression as one fraction with factored numerator and denominator.

    Each factor has its shorter form and sign.
    """
    above, below = sympy.fraction(factor(expression))
    sign_above, above = _side(above)
    sign_below, below = _side(below)
    return sign_above * sign_below * above / below


def positive(expression: Expr) -> Expr:
    """Return an expression or its negative, whichever begins without a minus sign."""
    return -expression if str(expression).startswith("-") else expression


def _side(side: Expr) -> tuple[int, Expr]:
    """Write a product as a sign times the shorter of its factored and expanded forms.

    No factor of that form begins with a minus sign.
    """
    sign, factors = 1, []
    for each in Mul.make_args(side):
        base, power = each.as_base_exp()
        if base.is_Add and str(base).startswith("-"):
            base, sign = -base, sign * (-1 if power % 2 else 1)
        factors.append(base**power)
    product = Mul(*factors)
    sums = [x for x in factors if x.is_Add]
    whole = sympy.expand(Mul(*sums))
    if len(sums) > 1 and sympy.count_ops(whole) <= sympy.count_ops(Mul(*sums)):
        flip = -1 if str(whole).startswith("-") else 1
        rest = [x for x in factors if not x.is_Add]
        return sign * flip, Mul(*rest, flip * whole)
    return sign, product
