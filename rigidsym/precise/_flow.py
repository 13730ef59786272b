"""Bounds and Taylor series of the motions that start in a box of inputs.

Energy and momentum bound the rates in every regime (`rate_bounds`).  The flow has the unknowns
y = (w, p), rates and the turn since t = 0 as a quaternion:

    w_i' = k_i w_j w_k,  (i, j, k) = (1, 2, 3) and round;     p' = p (0, w)/2,

so y' = A(y) y/2 with A linear in y, and the derivative V of y by its start and by the k_i obeys
V' = A(y) V + (0 | w_j w_k).  Coefficients computed over a box hold those of every motion that
starts in it.  The remainder is Lagrange's: the coefficient of order N over all that these motions
ever reach, times step^N; that of V, by the chain rule, also times V itself.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import permutations

from flint import arb, arb_mat

from rigidsym._inputs import Number
from rigidsym.precise._balls import ball, difference, power

RATES, SIZE, COLUMNS = 3, 7, 10
LONGEST = 8
# Rounds in which the bounds of all rates improve each other.
PASSES = 3
# The components of p (0, w): sign, component of p and component of w of each term.
_PRODUCT = (
    ((-1, 1, 0), (-1, 2, 1), (-1, 3, 2)),
    ((1, 0, 0), (1, 2, 2), (-1, 3, 1)),
    ((1, 0, 1), (1, 3, 0), (-1, 1, 2)),
    ((1, 0, 2), (1, 1, 1), (-1, 2, 0)),
)


def euler_factor(inertia: Sequence[Number], k: int) -> arb:
    """Return the factor (c_i - c_j)/c_k of Euler's equations."""
    return difference(inertia[k - 2], inertia[k - 1]) / ball(inertia[k])


def rate_bounds(inertia: Sequence[arb], factors: Sequence[arb], omega: Sequence[arb]) -> list[arb]:
    """Return balls that enclose the body rates (3) at all times.

    They hold for all bodies and initial rates in the given balls.

    By Euler's equations Omega_i^2 changes at the rate 2 k_i Omega_1 Omega_2 Omega_3, where k_i are
    the `factors` (3), so Omega_i^2 - (k_i/k_j) Omega_j^2 is constant.  Bounds of one rate give
    bounds of the others; the first ones follow from the energy.  They are kept as two ends: the
    radius of a ball would blur small ones.
    """
    start = [power(w, 2) for w in omega]
    energy = sum((c * s for c, s in zip(inertia, start, strict=True)), arb(0))
    ends = [(arb(0), (energy / c).upper()) for c in inertia]
    for i, j in list(permutations(range(3), 2)) * PASSES:
        linked = [start[i] + factors[i] / factors[j] * (end - start[j]) for end in ends[j]]
        if all(square.is_finite() for square in linked):
            low, high = ends[i]
            least, most = min(x.lower() for x in linked), max(x.upper() for x in linked)
            ends[i] = low.max(least), high.min(most)
    bounds = []
    for (low, high), w in zip(ends, omega, strict=True):
        most = high.max(0).sqrt().upper()
        if low > 0:  # the rate keeps its sign
            least = low.sqrt()
            bounds.append(least.union(most) if w > 0 else (-least).union(-most))
        else:
            bounds.append(arb(0, most))
    return bounds


@dataclass(frozen=True, slots=True)
class Flow:
    """Taylor series of the flow for all motions that start in a box and stay in a tube.

    factors (3): those of Euler's equations. starts (7, 1): the box. tube (7, 1): the motions
    never leave it.

    terms: the number of terms. tick: called at every term.
    """

    factors: Sequence[arb]
    starts: arb_mat
    tube: arb_mat
    terms: int
    tick: Callable[[], None] = lambda: None
    cut: arb = field(init=False)
    "The largest of the first coefficients that are cut off."

    def __post_init__(self) -> None:
        series, columns = _derivatives(self.factors, self.tube, self.terms + 1, self.tick)
        rows = [sum(map(abs, row), arb(0)) for row in columns[-1].tolist()]
        object.__setattr__(self, "cut", max_of([*rows, *series[-1].entries()]))

    def step(self, bits: int) -> arb:
        """Return the longest time step for which the series has about `bits` correct bits."""
        return (arb(2) ** -bits / self.cut).root(self.terms).min(LONGEST)

    def moved(self, factors: Sequence[arb], y: arb_mat, step: arb) -> arb_mat:
        """Return an enclosure of all states (7, 1) after a time step.

        It holds for all starts in y and all such factors.
        """
        series, _ = _series(factors, y, self.terms, self.tick)
        return _summed(series, step, self._remainder(y, step))

    def derivative(self, y: arb_mat, step: arb) -> arb_mat:
        """Return the derivatives (7, 10) of the states after a time step.

        They are those by the start and by the factors, for all starts in y.
        """
        columns = _derivatives(self.factors, y, self.terms, self.tick)[1]
        return _summed(columns, step, self._remainder(y, step))

    def _remainder(self, y: arb_mat, step: arb) -> arb:
        """Return a bound of the truncation error of the Taylor series.

        It is infinite for starts outside of the box.

        |dw/dw_0| <= e, |dw/dk| <= w^2 h e, |dp/dp_0| = 1, |dp/dw_0| <= p h e/2 and |dp/dk| <=
        p w^2 h^2 e/2 after a time h, where e = exp(2 k w h): their rates say so, by Gronwall.
        """
        if not self.starts.contains(y):
            return arb.pos_inf()
        w, p = norm(self.tube.entries()[:RATES]), norm(self.tube.entries()[RATES:])
        growth = (2 * max_of(self.factors) * w * abs(step)).exp()
        slopes = (1 + abs(step)) ** 2 * (1 + w * w) * (1 + p) * growth
        return self.cut * slopes * abs(step) ** self.terms


def _derivatives(
    factors: Sequence[arb], y: arb_mat, terms: int, tick: Callable[[], None]
) -> tuple[list[arb_mat], list[arb_mat]]:
    """Return the Taylor coefficients of the state, and of its matrix of derivatives."""
    series, slopes = _series(factors, y, terms, tick)
    columns = [arb_mat(SIZE, COLUMNS, 1)]
    for n in range(terms - 1):
        tick()
        # The n-th coefficients of w_j w_k, in the columns of the factors.
        direct = arb_mat(SIZE, COLUMNS)
        for i in range(RATES):
            j, k = (i + 1) % 3, (i + 2) % 3
            squares = (series[m][j, 0] * series[n - m][k, 0] for m in range(n + 1))
            direct[i, SIZE + i] = sum(squares, arb(0))
        products = (slopes[i] * columns[n - i] for i in range(n + 1))
        columns.append(sum(products, direct) * (1 / arb(n + 1)))
    return series, columns


def _series(
    factors: Sequence[arb], y: arb_mat, terms: int, tick: Callable[[], None]
) -> tuple[list[arb_mat], list[arb_mat]]:
    """Return the Taylor coefficients of the state, and of the matrix `_slope` of each."""
    series, slopes = [y], [_slope(factors, y)]
    for n in range(terms - 1):
        tick()
        products = (slopes[i] * series[n - i] for i in range(n + 1))
        series.append(sum(products, arb_mat(SIZE, 1)) * (1 / arb(2 * n + 2)))
        slopes.append(_slope(factors, series[-1]))
    return series, slopes


def _slope(factors: Sequence[arb], y: arb_mat) -> arb_mat:
    """Return the matrix A(y) (7, 7) of the differential equation y' = A(y) y/2."""
    w, p = y.entries()[:RATES], y.entries()[RATES:]
    slope = [[arb(0)] * SIZE for _ in range(SIZE)]
    for i, factor in enumerate(factors):
        j, k = (i + 1) % 3, (i + 2) % 3
        slope[i][j], slope[i][k] = factor * w[k], factor * w[j]
    for row, products in zip(slope[RATES:], _PRODUCT, strict=True):
        for sign, i, j in products:
            row[j], row[RATES + i] = sign * p[i] / 2, sign * w[j] / 2
    return arb_mat(slope)


def multiplied(q: Sequence[arb]) -> arb_mat:
    """Return the matrix (7, 7) that multiplies the quaternion of a state by q.

    It keeps the rates and maps a turn p to q p.
    """
    matrix = [[arb(int(i == j)) for j in range(SIZE)] for i in range(SIZE)]
    for part, row, products in zip(q, matrix[RATES:], _PRODUCT, strict=True):
        row[RATES:] = [part, *[arb(0)] * 3]
        for sign, i, j in products:
            row[RATES + 1 + j] = sign * q[i]
    return arb_mat(matrix)


def _summed(terms: Sequence[arb_mat], step: arb, remainder: arb) -> arb_mat:
    """Sum a Taylor series and add the remainder to the radius of every entry."""
    value = terms[-1]
    for term in reversed(terms[:-1]):
        value = value * step + term
    around = arb(0, remainder.abs_upper())
    return value + arb_mat(value.nrows(), value.ncols(), [around] * len(value.entries()))


def norm(values: Sequence[arb]) -> arb:
    """Return an upper bound of the Euclidean norm of a vector of balls."""
    return sum((power(x, 2) for x in values), arb(0)).upper().sqrt().upper()


def max_of(values: Sequence[arb]) -> arb:
    """Return an upper bound of the absolute values of several balls."""
    first, *others = (abs(x).upper() for x in values)
    for other in others:
        first = first.max(other)
    return first
