"""Elliptic functions in ball arithmetic, with rigorous error bounds.

Jacobi's functions come from their definition alone, the inverse phi = am(u) of

    u = F(phi),    F' = 1/Delta,    Delta = sqrt(1 - m*sin(phi)**2),    F(0) = 0:

sn = sin(phi), cn = cos(phi), dn = Delta.  No theta function and no addition theorem is used, only
the period F(phi + pi) = F(phi) + 2 K, which is that of Delta.
"""

import cmath
from collections.abc import Callable

from flint import acb, arb, ctx

from rigidsym.proof.checker._records import Refused

STEPS = 64
NEWTON = 20
EVALUATIONS = 20_000


def jacobi(u: acb, m: acb) -> tuple[acb, acb, acb]:
    """Return Jacobi's functions sn, cn and dn at (u | m).

    The domain is |Im u| < K' and 0 < m < 1.
    """
    phi, turns = _amplitude(u, m)
    _, s, c, d = _first(phi, m)
    return (-s, -c, d) if turns % 2 else (s, c, d)


def epsilon(u: acb, m: acb) -> acb:
    """Return Jacobi's epsilon function, the integral of dn**2 from 0 to u.

    It is E(phi) at phi = am(u), since dn is Delta and du is dphi/Delta.
    """
    phi, turns = _amplitude(u, m)
    first, s, c, d = _first(phi, m)
    carlson = acb.elliptic_rd(*_doubled(c, d)) / 4 + 3 / ((1 + c) * (1 + d))
    return first - m * s**3 * carlson / 3 + 2 * turns * acb.elliptic_e(m)


def inverse_sc(x: acb, m: acb) -> acb:
    """Return the real u that solves sc(u | m) = x.

    It is F(arctan(x)).
    """
    return _first(acb(real(x).atan()), between(arb(0), m, arb(1)))[0]


def third_kind_of_argument(u: acb, n: acb, m: acb) -> acb:
    """Integrate sn**2/(1 - n*sn**2) from 0 to a real u.

    The substitution is phi = am(u).
    """
    phi, turns = _amplitude(acb(real(u)), m)
    return _third(lambda square: square, n, phi + turns * acb.pi(), m)


def third_kind(n: acb, phi: acb, m: acb) -> acb:
    """Return Legendre's integral of the third kind, Pi(n; phi | m), for a real phi."""
    return _third(lambda square: acb(1), n, acb(real(phi)), m)


def real(value: acb) -> arb:
    """Convert a complex ball to a real ball.

    Raises Refused unless the ball is exactly real and finite.
    """
    if not (value.imag == 0 and value.is_finite()):
        raise Refused("a function of real numbers gets another value")
    return value.real


def between(low: arb | None, value: acb, high: arb) -> acb:
    """Check that a ball is real and lies strictly between two bounds, and return it.

    Raises Refused for any other ball.
    """
    number = real(value)
    if not number < high or not (low is None or low < number):
        raise Refused("a function gets a value out of its range")
    return acb(number)


def _amplitude(u: acb, m: acb) -> tuple[acb, int]:
    """Return the Jacobi amplitude of u, reduced by a multiple of pi.

    Returns phi and k with am(u) = phi + k*pi, where phi is on the branch of `_first`.
    """
    m = between(arb(0), m, arb(1))
    if not u.is_finite() or not abs(u.imag) < acb.elliptic_k(1 - m).real:
        raise Refused("an argument of Jacobi's functions is not below the pole i*K'")
    period = 2 * acb.elliptic_k(m)
    turns = round(float((u / period).real.mid()))
    return _inverse(u - turns * period, m), turns


def _inverse(u: acb, m: acb) -> acb:
    """Enclose the solution phi of F(phi) = u by an interval Newton method.

    The result holds the solutions for all u in the ball.
    It starts from a root found by plain Newton steps.
    Where Newton's operator maps a ball into its interior, it holds exactly one zero.  If the ball
    meets the strip |Re phi| < pi/2, `_first` has continued F from 0 to there: phi is am(u).
    """
    phi = acb(_guess(complex(u), float(m.real)))
    step, near = acb(1), arb(2) ** -(ctx.prec // 2)
    for _ in range(NEWTON):
        if step.abs_upper() < near:
            break
        value, *_, slope = _first(phi, m)
        step = (value - u) * slope
        phi = (phi - step).mid()
    value, *_, slope = _first(phi, m)
    reach = arb(0, 2 * ((value - u) * slope).abs_upper() + near)
    ball = phi + acb(reach, 0 if u.imag == 0 else reach)
    newton = phi - (value - u) / (1 / _first(ball, m)[-1])
    flat = newton.imag == ball.imag == 0
    inside = ball.real.contains_interior(newton.real) and (
        flat or ball.imag.contains_interior(newton.imag)
    )
    if not inside or not ball.real.abs_lower() < arb.pi() / 2:
        raise Refused("Newton's method does not enclose an amplitude")
    return newton


def _guess(u: complex, m: float) -> complex:
    """Approximate the Jacobi amplitude of u by Runge-Kutta steps.

    They solve phi' = Delta.
    """

    def slope(phi: complex) -> complex:
        return cmath.sqrt(1 - m * cmath.sin(phi) ** 2)

    phi, step = 0j, u / STEPS
    for _ in range(STEPS):
        first = slope(phi)
        second = slope(phi + first * step / 2)
        third = slope(phi + second * step / 2)
        phi += step / 6 * (first + 2 * second + 2 * third + slope(phi + third * step))
    return phi


def _first(phi: acb, m: acb) -> tuple[acb, acb, acb, acb]:
    """Return Legendre's integral F(phi | m) with sin(phi), cos(phi) and Delta(phi).

    All are continued analytically from phi = 0.
    The domain is the strip |Re phi| < pi/2 and some of what lies beyond it.
    F = s*R_F(c**2, Delta**2, 1).  Doubling its arguments once by hand, with the roots c and Delta,
    takes it across the cut that c**2 runs into at the sides of the strip: the doubled ones are
    products of two numbers with positive real parts, where R_F is analytic.
    """
    s, c = phi.sin_cos()
    square = 1 - m * s**2
    d = square.sqrt()
    if not (c + d).real > 0 or not (1 + c).real > 0 or not (square.real > 0 or square.imag != 0):
        raise Refused("an amplitude is not where its functions are analytic")
    value = s * acb.elliptic_rf(*_doubled(c, d))
    return acb(value.real) if phi.imag == 0 else value, s, c, d


def _doubled(c: acb, d: acb) -> tuple[acb, acb, acb]:
    """Return the arguments of Carlson's R_F after one duplication step.

    They are (x + y)/4 for x = c**2, d**2, 1, where y = c*d + d + c.
    """
    return (c + d) * (c + 1) / 4, (d + c) * (d + 1) / 4, (1 + c) * (1 + d) / 4


def _third(above: Callable[[acb], acb], n: acb, phi: acb, m: acb) -> acb:
    """Integrate an elliptic integrand of the third kind from 0 to a real phi.

    The integrand is above(sin**2)/((1 - n*sin**2)*Delta).
    """
    n, m = between(None, n, arb(1)), between(None, m, arb(1))

    def integrand(theta: acb, analytic: bool) -> acb:
        square = theta.sin() ** 2
        return above(square) / ((1 - n * square) * (1 - m * square).sqrt(analytic=analytic))

    goal = arb(2) ** (-ctx.prec * 3 // 4)
    return acb.integral(integrand, 0, phi, rel_tol=goal, abs_tol=goal, eval_limit=EVALUATIONS)
