"""SymPy's expressions as the paper writes them: in LaTeX, and in the letters of a terminal."""

from typing import Any

import sympy
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pretty.pretty import PrettyPrinter
from sympy.printing.pretty.pretty_symbology import pretty_symbol, pretty_use_unicode
from sympy.printing.pretty.stringpict import prettyForm

from rigidsym.language._latex import dotted, symbol

# Constants of a motion, which the paper writes before variables.
CONSTANTS = {
    *("c1", "c2", "c3", "c_i", "c_j", "c_k", "H", "K", "K_squared", "h1", "h2", "h3", "n", "s_i"),
    *("s_j", "alpha", "beta", "chi", "mu", "xi", "zeta", "nu", "kappa", "sqrt_mu", "b_free"),
}
_FUNCTIONS = {"jacobi_sn": "sn", "jacobi_cn": "cn", "jacobi_dn": "dn", "jacobi_am": "am"}
_DOT = "\N{COMBINING DOT ABOVE}"


def latex(expression: sympy.Basic) -> str:
    """Return an expression, a matrix expression or an equation in LaTeX."""
    return _Latex().doprint(expression)


def pretty(expression: sympy.Basic, width: int = 100) -> str:
    """Return an expression in two dimensions for a terminal, in Unicode whatever stdout is."""
    settings = {"use_unicode": True, "wrap_line": True, "num_columns": width}
    before = pretty_use_unicode(True)
    try:
        return _Pretty(settings).doprint(expression)
    finally:
        pretty_use_unicode(before)


def _rank(factor: sympy.Expr) -> tuple[int, str]:
    """Return a sort key: numbers, constants, sums of constants, variables, functions last."""
    names = {str(x) for x in factor.free_symbols}
    if factor.is_Number:
        return 0, str(factor)
    functions = bool(factor.atoms(sympy.Function))
    moving = functions or bool(names - CONSTANTS)
    return 1 + factor.is_Add + 2 * moving + 2 * functions, str(factor)


class _Latex(LatexPrinter):
    def __init__(self) -> None:
        super().__init__({"fold_func_brackets": True})

    def _print_Symbol(self, expr: sympy.Symbol, style: str = "plain") -> str:
        return expr.name if "\\" in expr.name else symbol(expr.name).latex

    def _print_MatrixSymbol(self, expr: sympy.MatrixSymbol) -> str:
        return symbol(expr.name).latex

    def _print_Mul(self, expr: Any) -> str:
        above, below = sympy.fraction(expr, exact=True)
        sign = ""
        if above.as_coeff_Mul()[0].is_negative:
            sign, above = "-", -above
        if below == 1:
            return f"{sign}{self._row(above)}"
        inside = [self._row(side, alone=True) for side in (above, below)]
        return rf"{sign}\frac{{{inside[0]}}}{{{inside[1]}}}"

    def _as_ordered_terms(self, expr: sympy.Expr, order: str | None = None) -> list[sympy.Expr]:
        """Return the terms of a sum, a positive one first if there is any."""
        terms = super()._as_ordered_terms(expr, order)
        first = next((x for x in terms if not x.could_extract_minus_sign()), terms[0])
        return [first, *(term for term in terms if term is not first)]

    def _print_MatAdd(self, expr: sympy.MatAdd) -> str:
        terms = [self._print(term) for term in expr.args]
        signed = (t if t.startswith("-") else f"+ {t}" for t in terms[1:])
        return " ".join([terms[0], *signed])

    def _row(self, product: sympy.Expr, alone: bool = False) -> str:
        factors = sorted(sympy.Mul.make_args(product), key=_rank)
        if alone and len(factors) == 1:
            return self._print(factors[0])
        bracketed = [self.parenthesize(factor, PRECEDENCE["Mul"]) for factor in factors]
        return " ".join(x for x, f in zip(bracketed, factors, strict=True) if f != 1) or "1"

    def _print_Function(self, expr: Any, exp: str | None = None) -> str:
        name = expr.func.__name__
        if name == "D":
            inner = self._print(expr.args[0])
            simple = expr.args[0].is_Symbol and "^" not in inner
            text = dotted(inner) if simple else rf"\frac{{d}}{{dt}}\left({inner}\right)"
            return text if exp is None else rf"{text}^{{{exp}}}"
        if name in _FUNCTIONS:
            power = "" if exp is None else f"^{{{exp}}}"
            arguments = r" \mid ".join(map(self._print, expr.args))
            return rf"\mathrm{{{_FUNCTIONS[name]}}}{power}\left({arguments}\right)"
        return super()._print_Function(expr, exp)


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
            shown = self._print(term)
            glue = " - " if term.could_extract_minus_sign() else " + "
            whole = prettyForm(*whole.right(glue))
            whole = prettyForm(*whole.right(self._print(-term) if glue == " - " else shown))
        return whole

    def _print_Function(self, e: Any, *rest: Any, **settings: Any) -> prettyForm:
        if e.func.__name__ != "D":
            return super()._print_Function(e, *rest, **settings)
        inner: Any = self._print(e.args[0])
        if e.args[0].is_Symbol and "_" not in e.args[0].name:
            return self._print_Symbol(sympy.Symbol(f"{e.args[0].name}_rate"))
        return prettyForm(*prettyForm("d/dt ").right(prettyForm(*inner.parens())))

    def _print_Rate(self, e: Any) -> prettyForm:
        inner: Any = self._print(e.args[0])
        if isinstance(e.args[0], sympy.MatrixSymbol):
            return self._print_Symbol(sympy.Symbol(f"{e.args[0].name}_rate"))
        return prettyForm(*prettyForm("d/dt ").right(prettyForm(*inner.parens())))
