"""An oracle without elliptic functions: Taylor-series integration of (3) and (5) in mpmath.

Coefficients follow from the products in the equations of motion; the step is chosen so that the
last terms are below the working precision.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from mpmath.ctx_mp import MPContext

ORDER = 60


def integrate(
    inertia: Sequence[Fraction],
    omega0: Sequence[Fraction],
    attitude0: Sequence[Fraction],
    time: Fraction,
    digits: int = 40,
) -> tuple[list[Any], list[Any]]:
    """(q, omega) at one time, good to about `digits` digits."""
    ctx = MPContext()
    ctx.dps = digits + 15
    c = [ctx.convert(x) for x in inertia]
    state = [ctx.convert(x) for x in (*attitude0, *omega0)]
    norm = ctx.sqrt(sum(x * x for x in state[:4]))
    state = [x / norm for x in state[:4]] + state[4:]
    rate = max(abs(x) for x in state[4:]) or ctx.one
    steps = int(abs(ctx.convert(time)) * rate * 3) + 1
    step = ctx.convert(time) / steps
    for _ in range(steps):
        state = [ctx.polyval(series[::-1], step) for series in _series(ctx, c, state)]
    return state[:4], state[4:]


def _series(ctx: Any, c: Sequence[Any], state: Sequence[Any]) -> list[list[Any]]:
    """Taylor coefficients of all seven components about one instant."""
    q, w = [[x] for x in state[:4]], [[x] for x in state[4:]]
    signs = ((-1, 1, 1), (-1, 2, 2), (-1, 3, 3)), ((1, 0, 1), (1, 2, 3), (-1, 3, 2))
    terms = [
        signs[0],
        signs[1],
        ((1, 0, 2), (1, 3, 1), (-1, 1, 3)),
        ((1, 0, 3), (1, 1, 2), (-1, 2, 1)),
    ]
    for k in range(ORDER):
        rates = [sum(s * _product(q[i], w[j - 1], k) for s, i, j in row) / 2 for row in terms]
        spins = [
            (c[(i + 1) % 3] - c[(i + 2) % 3]) / c[i] * _product(w[(i + 1) % 3], w[(i + 2) % 3], k)
            for i in range(3)
        ]
        for series, value in zip((*q, *w), (*rates, *spins), strict=True):
            series.append(value / (k + 1))
    return [*q, *w]


def _product(a: Sequence[Any], b: Sequence[Any], k: int) -> Any:
    return sum(a[i] * b[k - i] for i in range(k + 1))
