"""A solution as SymPy expressions in time, with its Taylor polynomials.

The polynomials follow from Euler's equations and q' = q (0, Omega)/2: the equations give one
coefficient after the other by products alone.  SymPy's `series` of a quotient of square roots of
Jacobi's functions does not end in minutes.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from operator import mul
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Symbol, bottom_up, latex, sympify
from sympy.logic.boolalg import Boolean

from rigidsym.errors import InputError
from rigidsym.solution._polhode import Regime
from rigidsym.solution._symbolic.symbols import TIME, Constant

# A column by its Taylor coefficients: one list of them for each entry.
Coefficients = list[list[Any]]
_CYCLIC = ((0, 1, 2), (1, 2, 0), (2, 0, 1))


@dataclass(frozen=True, slots=True)
class Dynamics:
    """Moments and initial state of a motion, in the axis order of the solution's vectors.

    handedness: 1, or the symbol that is -1 where these axes are left-handed.
    """

    moments: tuple[Any, ...]
    attitude0: tuple[Any, ...]
    omega0: tuple[Any, ...]
    handedness: Any = 1

    def taylor(self, q: Any, omega: Any, count: int) -> tuple[Coefficients, Coefficients]:
        """Return the first Taylor coefficients of q and omega from their initial values."""
        turn, rate, c = [[x] for x in q], [[x] for x in omega], self.moments
        for k in range(1, count):
            slopes = [self._turning(turn, rate, i) for i in range(4)]
            slopes += [
                self.handedness * (c[j] - c[k]) / c[i] * _product(rate[j], rate[k])
                for i, j, k in _CYCLIC
            ]
            for known, slope in zip((*turn, *rate), slopes, strict=True):
                known.append(slope / k)
        return turn, rate

    def _turning(self, q: Coefficients, rate: Coefficients, i: int) -> Expr:
        if i == 0:
            return -sum(_product(q[k + 1], rate[k]) for k in range(3)) / 2
        a, b, d = _CYCLIC[i - 1]
        across = _product(q[b + 1], rate[d]) - _product(q[d + 1], rate[b])
        return (_product(q[0], rate[a]) + self.handedness * across) / 2


def _product(x: list[Any], y: list[Any]) -> Any:
    """Return the highest-order coefficient of the product of two power series.

    Both series have the same number of terms.
    """
    return sum(one * other for one, other in zip(x, reversed(y), strict=True))


def column(entries: Iterable[Any]) -> ImmutableMatrix:
    """Return a column vector of expressions, rebuilt so that SymPy evaluates each part."""

    def rebuilt(expression: Any) -> Any:
        return expression.func(*expression.args) if expression.args else expression

    return ImmutableMatrix([bottom_up(sympify(entry), rebuilt) for entry in entries])


@dataclass(frozen=True, slots=True)
class Symbolic:
    """Attitude and body rates of a motion as SymPy expressions in time.

    Quaternions are scalar first, body to inertial; rates are in body axes, rad/s; t is in s.

    Attributes
    ----------
    form : str
        The name of the form.
    regime : Regime or None
        The regime of the motion whose numbers it contains; None for free symbols.
    constants : Mapping
        Each constant in earlier constants, or as an exact number.
    conditions : tuple
        The conditions on the constants, without those that numbers make true.
    choices : Mapping
        The choice of each sign and root.
    facts : tuple of str
        The ids of the facts, definitions and readings of the ledger that it follows from.
    quantities : Mapping
        The energy (J), the momentum (kg m^2 rad/s) and others of the regime.
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
        """The SymPy symbol of the time, in s."""
        return TIME

    def q(self, t: Any = TIME) -> ImmutableMatrix:
        """Return the attitude at a time.

        Parameters
        ----------
        t : SymPy expression or number, optional
            The time, s; the symbol t by default.

        Returns
        -------
        ImmutableMatrix
            The unit quaternion (4, 1), scalar first, body to inertial.
        """
        return self.attitude if t == TIME else self.attitude.subs(TIME, t)

    def omega(self, t: Any = TIME) -> ImmutableMatrix:
        """Return the body rates at a time.

        Parameters
        ----------
        t : SymPy expression or number, optional
            The time, s; the symbol t by default.

        Returns
        -------
        ImmutableMatrix
            The rates (3, 1) in body axes, rad/s.
        """
        return self.rates if t == TIME else self.rates.subs(TIME, t)

    def taylor(self, n: int = 6, at: Any = 0) -> tuple[ImmutableMatrix, ImmutableMatrix]:
        """Return Taylor polynomials of q and omega, derived from the equations of motion.

        Parameters
        ----------
        n : int, optional
            The number of terms.
        at : SymPy expression or number, optional
            The time to expand about, s.  At 0 the polynomials start from the exact initial state,
            elsewhere from q(at) and omega(at).

        Returns
        -------
        q, omega : ImmutableMatrix
            Polynomials in t - at: (4, 1), and (3, 1) in rad/s.

        Raises
        ------
        InputError
            For n < 1.
        """
        if n < 1:
            raise InputError("n", n, "a series has at least one term")
        known = self.dynamics
        begin = (known.attitude0, known.omega0) if at == 0 else (self.q(at), self.omega(at))
        powers = [(TIME - at) ** k for k in range(n)]
        q, omega = (
            ImmutableMatrix([Add(*map(mul, row, powers)) for row in rows])
            for rows in known.taylor(*begin, n)
        )
        return q, omega

    def explicit(self, expression: Any) -> Any:
        """Substitute all constants in an expression until only the inputs remain.

        Parameters
        ----------
        expression : SymPy expression or matrix
            For example `q()` or a value of `quantities`.

        Returns
        -------
        SymPy expression or matrix
            The expression in the inputs alone: their symbols, or a motion's numbers.
        """
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
