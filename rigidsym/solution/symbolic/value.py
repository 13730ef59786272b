"""A solution as a value: what SymPy is given, and what it may ask of it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Symbol, bottom_up, latex, sympify
from sympy.logic.boolalg import Boolean

from rigidsym.errors import InputError
from rigidsym.solution.polhode import Regime
from rigidsym.solution.symbolic.constant import Constant
from rigidsym.solution.symbolic.symbols import TIME
from rigidsym.solution.symbolic.taylor import Dynamics


def column(entries: Iterable[Any]) -> ImmutableMatrix:
    """A column of expressions as SymPy writes them: built anew, they would be the same."""
    return ImmutableMatrix([bottom_up(sympify(entry), _again) for entry in entries])


def _polynomial(coefficients: Iterable[Any], step: Expr) -> Expr:
    return Add(*(c * step**k for k, c in enumerate(coefficients)))


def _again(expression: Any) -> Any:
    return expression.func(*expression.args) if expression.args else expression


@dataclass(frozen=True, slots=True)
class Symbolic:
    """Attitude and rates as SymPy's expressions of the time, in one form.

    form: its name.  regime: of the motion whose numbers are in it, or None.  constants: each by
    those before it, or exact numbers.  conditions: what has to hold of them; those that numbers
    make true are left out.  choices: what signs and roots are to be chosen as.  facts: the ids of
    the ledger's facts, definitions and readings that it was put together from.  quantities: the
    energy (J), the momentum (kg m^2 rad/s) and what else the regime has, by the constants.
    Quaternions are scalar first, body to inertial; rates are in body axes, rad/s; t is in s.
    """

    form: str
    regime: Regime | None
    constants: Mapping[Symbol, Expr]
    conditions: tuple[Boolean, ...]
    choices: Mapping[Symbol, str]
    facts: tuple[str, ...]
    quantities: Mapping[str, Expr]
    attitude: ImmutableMatrix = field(repr=False)
    rates: ImmutableMatrix = field(repr=False)
    dynamics: Dynamics = field(repr=False)

    @property
    def t(self) -> Symbol:
        """The time, s."""
        return TIME

    def q(self, t: Any = TIME) -> ImmutableMatrix:
        """The attitude at t, a column of 4, by the constants' symbols or numbers."""
        return self.attitude if t == TIME else self.attitude.subs(TIME, t)

    def omega(self, t: Any = TIME) -> ImmutableMatrix:
        """The body rates at t, rad/s, a column of 3."""
        return self.rates if t == TIME else self.rates.subs(TIME, t)

    def taylor(self, n: int = 6, at: Any = 0) -> tuple[ImmutableMatrix, ImmutableMatrix]:
        """Taylor polynomials of q and omega in t - at, the first n terms of each, by the equations
        of motion: exact from the given state at t = 0, else from q(at) and omega(at).

        Raises InputError for n < 1.
        """
        if n < 1:
            raise InputError("n", n, "a series has at least one term")
        known = self.dynamics
        begin = (known.attitude0, known.omega0) if at == 0 else (self.q(at), self.omega(at))
        q, omega = (
            ImmutableMatrix([_polynomial(row, TIME - at) for row in rows])
            for rows in known.taylor(*begin, n)
        )
        return q, omega

    def explicit(self, expression: Any) -> Any:
        """The expression with every constant put in, down to what is given."""
        while found := expression.atoms(Constant) if self.regime else set():
            expression = expression.xreplace({one: one.value for one in found})
        for symbol, value in reversed([*self.constants.items()]):
            expression = expression.subs(symbol, value)
        return expression

    def _repr_latex_(self) -> str:
        names = (r"q(t)", r"\Omega(t)")
        pairs = zip(names, (self.attitude, self.rates), strict=True)
        rows = r" \\ ".join(f"{name} &= {latex(value)}" for name, value in pairs)
        return rf"$\begin{{aligned}} {rows} \end{{aligned}}$"
