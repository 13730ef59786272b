"""States by Taylor series of the equations of motion, without elliptic functions.

The equations are (3) and (5).

They share no formula with the other methods, and are mpmath's numbers, not balls.  Order and
step are those of Jorba and Zou (Experimental Mathematics 14, 2005): at d digits an order of about
d ln(10)/2 is cheapest, and the step is where the last two terms reach the tolerance.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import ceil, log

from mpmath import mpf
from mpmath.ctx_mp import MPContext

GUARD_DIGITS = 15
# The components of p Omega: sign, component of p and component of Omega of each term.
_KINEMATICS = (
    ((-1, 1, 0), (-1, 2, 1), (-1, 3, 2)),
    ((1, 0, 0), (1, 2, 2), (-1, 3, 1)),
    ((1, 0, 1), (1, 3, 0), (-1, 1, 2)),
    ((1, 0, 2), (1, 1, 1), (-1, 2, 0)),
)


def integrate(
    inertia: Sequence[Fraction],
    omega0: Sequence[Fraction],
    attitude0: Sequence[Fraction],
    time: Fraction,
    digits: int = 40,
) -> tuple[list[mpf], list[mpf]]:
    """Integrate the equations of motion to one time by Taylor series.

    Parameters
    ----------
    inertia, omega0, attitude0 : sequences of Fraction
        Principal moments (3), kg m^2; body rates (3), rad/s; quaternion (4) of any length but zero.
    time : Fraction
        The time, s.
    digits : int, optional
        Errors of q are about 10^-digits, those of omega about 10^-digits times |omega0|.  The
        guard digits cover the instability of the middle axis for about 30 rad.

    Returns
    -------
    q, omega : list of mpf
        The unit quaternion (4) and the body rates (3), rad/s.
    """
    ctx = MPContext()
    turned = abs(time) * max(map(abs, omega0))
    ctx.dps = digits + GUARD_DIGITS + len(str(int(turned)))
    order, tolerance = ceil(ctx.dps * log(10) / 2), ctx.mpf(10) ** -ctx.dps
    # Moments may agree to more digits than these: their differences are taken before rounding.
    ratios = [(inertia[k - 2] - inertia[k - 1]) / inertia[k] for k in range(3)]
    factors, q, w = ([ctx.convert(x) for x in values] for values in (ratios, attitude0, omega0))
    norm = ctx.norm(q)
    q = [x / norm for x in q]
    forward, left = 1 if time > 0 else -1, abs(ctx.convert(time))
    while left > 0:
        series = _rate_series(ctx, factors, w, order)
        turning = _attitude_series(ctx, q, series, order)
        step = min([left, *(_step(ctx, part, tolerance) for part in (series, turning))])
        w, q = ([ctx.polyval(x[::-1], forward * step) for x in part] for part in (series, turning))
        left -= step
    return q, w


def _rate_series(
    ctx: MPContext, factors: Sequence[mpf], w: Sequence[mpf], order: int
) -> list[list[mpf]]:
    """Return the Taylor coefficients of the body rates, by Euler's equations."""
    series = [[x] for x in w]
    for n in range(order):
        products = [ctx.fdot(series[k - 2], series[k - 1][::-1]) for k in range(3)]
        for x, factor, product in zip(series, factors, products, strict=True):
            x.append(factor * product / (n + 1))
    return series


def _attitude_series(
    ctx: MPContext, q: Sequence[mpf], omega: Sequence[Sequence[mpf]], order: int
) -> list[list[mpf]]:
    """Return the Taylor coefficients of the quaternion from those of the rates."""
    series = [[x] for x in q]
    for n in range(order):
        turned = [x[n::-1] for x in omega]
        rates = [
            sum(sign * ctx.fdot(series[j], turned[k]) for sign, j, k in row) for row in _KINEMATICS
        ]
        for x, rate in zip(series, rates, strict=True):
            x.append(rate / (2 * (n + 1)))
    return series


def _step(ctx: MPContext, series: Sequence[Sequence[mpf]], tolerance: mpf) -> mpf:
    """Return the time step at which the last two terms are `tolerance` times the first."""
    sizes = [max(map(abs, terms)) for terms in zip(*series, strict=True)]
    last = [(n, sizes[n]) for n in (len(sizes) - 2, len(sizes) - 1) if sizes[n]]
    return min((ctx.root(tolerance * sizes[0] / x, n) for n, x in last), default=ctx.inf)
