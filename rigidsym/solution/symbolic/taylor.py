"""Taylor series of a motion, by Euler's equations and q' = q (0, Omega)/2 from one state.

SymPy's `series` of a quotient of square roots of Jacobi's functions does not end in minutes; the
equations give the same coefficients one after the other, by products alone.
"""

from dataclasses import dataclass
from typing import Any

from sympy import Expr

# A column by its Taylor coefficients: one list of them for each entry.
Coefficients = list[list[Any]]
_CYCLIC = ((0, 1, 2), (1, 2, 0), (2, 0, 1))


@dataclass(frozen=True, slots=True)
class Dynamics:
    """What a motion is known by: moments and the state at t = 0, about the axes of its columns.

    handedness: 1, or the symbol that is -1 where these axes are left-handed.
    """

    moments: tuple[Any, ...]
    attitude0: tuple[Any, ...]
    omega0: tuple[Any, ...]
    handedness: Any = 1

    def taylor(self, q: Any, omega: Any, count: int) -> tuple[Coefficients, Coefficients]:
        """The first coefficients of q and of omega, where they start there."""
        turn, rate = [[x] for x in q], [[x] for x in omega]
        for k in range(1, count):
            slopes = [self._turning(turn, rate, i) for i in range(4)]
            slopes += [self._euler(rate, *axes) for axes in _CYCLIC]
            for known, slope in zip((*turn, *rate), slopes, strict=True):
                known.append(slope / k)
        return turn, rate

    def _euler(self, rate: Coefficients, a: int, b: int, d: int) -> Expr:
        c = self.moments
        return self.handedness * (c[b] - c[d]) / c[a] * _product(rate[b], rate[d])

    def _turning(self, q: Coefficients, rate: Coefficients, i: int) -> Expr:
        if i == 0:
            return -sum(_product(q[k + 1], rate[k]) for k in range(3)) / 2
        a, b, d = _CYCLIC[i - 1]
        across = _product(q[b + 1], rate[d]) - _product(q[d + 1], rate[b])
        return (_product(q[0], rate[a]) + self.handedness * across) / 2


def _product(x: list[Any], y: list[Any]) -> Any:
    """The last known coefficient of a product."""
    return sum(one * other for one, other in zip(x, reversed(y), strict=True))
