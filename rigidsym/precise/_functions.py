"""Jacobi's functions and an integral of the third kind in ball arithmetic, by four methods.

Conventions: m is the parameter k^2; functions take mc = 1 - m as their last argument, which is 0 on
the separatrix.  J(u) is the integral of sn^2/(1 - n sn^2) from 0 to u.

A method computes sn, cn, dn and J for |u| <= K/2, and a little beyond.  Whole periods are added,
and past K/2 the argument is reflected to K - |u| (DLMF 22.4(iii)), so nothing is evaluated near a
branch point: with n' = (m - n)/(1 - n),

    J(K - w) = J(K) - (w - mc/(1 - n) J(w, n'))/(1 - n).

* `landen`: Landen's and Gauss's descending transformations, until trigonometry is near enough;
* `carlson`: Carlson's symmetric integrals, R_F inverted and R_J;
* `quadrature`: the same functions, and J by rigorous integration over the amplitude;
* `theta`: quotients of theta functions.  It has the functions of the theta form, too, in which a
  state needs no branches and no winding numbers, but two of Arb's theta evaluations.
"""

from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable
from operator import is_
from typing import Any, TypeVar

from flint import acb, arb, ctx

from rigidsym.precise._balls import ball, power

Triple = tuple[arb, arb, arb]
# Functions and constants by the names that formulas use.
Function = Callable[..., arb | acb]
Table = dict[str, Function | arb | acb]
Value = TypeVar("Value")
# The last values kept of each function; a state needs J with two parameters n.
KEPT = 2


def quarter_period(mc: arb) -> arb:
    """Compute the complete elliptic integral K(m) by the AGM (DLMF 19.8.5).

    K(m) = pi/(2 agm(1, sqrt(mc))).
    """
    return arb.pi() / (2 * arb(1).agm(mc.sqrt()))


def carlson_f(x: arb, y: arb, z: arb) -> arb:
    """Compute Carlson's elliptic integral R_F (DLMF 19.16.1)."""
    return acb.elliptic_rf(x, y, z).real


def argument(sn: arb, cn: arb, dn: arb) -> arb:
    """Compute the argument u of Jacobi's functions from sn, cn and dn.

    |u| is at most K, or a little more if cn may be negative.

    By DLMF 19.25.5; where cn is not surely positive, for K - |u|, whose sine is cn/dn.
    """
    if cn > 0 or cn.is_zero():
        return sn * carlson_f(cn * cn, dn * dn, arb(1))
    mc = (dn * dn - cn * cn) / (sn * sn)
    rest = cn * carlson_f(sn * sn * mc, mc, dn * dn)
    size = quarter_period(mc) - rest
    return size if sn > 0 else -size


class Functions(ABC):
    """Base class of the functions that formulas need, computed by one method.

    The last values are cached.
    """

    # Up to this precision a state takes some tenths of a second.
    quick_bits = 2**13

    def __init__(self) -> None:
        # Arguments and value, by function.
        self._last: dict[Callable[..., object], deque[tuple[tuple[arb | acb, ...], Any]]] = {}

    def table(self) -> Table:
        """Return the table of functions by the names that formulas use."""
        return {
            "power": lambda x, exponent: power(ball(x), exponent),
            "sqrt": lambda x: x.sqrt(),
            "cos": lambda x: x.cos(),
            "sin": lambda x: x.sin(),
            "jacobi_sn": lambda u, mc: self.kept(self.jacobi, u, mc)[0],
            "jacobi_cn": lambda u, mc: self.kept(self.jacobi, u, mc)[1],
            "jacobi_dn": lambda u, mc: self.kept(self.jacobi, u, mc)[2],
            "jacobi_argument": argument,
            "elliptic_j": self.elliptic_j,
        }

    def kept(self, function: Callable[..., Value], *arguments: arb | acb) -> Value:
        """Evaluate a function, or return its cached value for identical argument objects."""
        last = self._last.setdefault(function, deque(maxlen=KEPT))
        for known, value in last:
            if all(map(is_, known, arguments)):
                return value
        value = function(*arguments)
        last.append((arguments, value))
        return value

    def jacobi(self, u: arb, mc: arb) -> Triple:
        """Return Jacobi's sn, cn and dn of (u | 1 - mc).

        They are elementary where mc is exactly 0 or 1.
        """
        if mc.is_zero():
            return u.tanh(), u.sech(), u.sech()
        if mc == 1:
            return u.sin(), u.cos(), arb(1)
        return self.between(u, mc)

    def between(self, u: arb, mc: arb) -> Triple:
        """Return Jacobi's sn, cn and dn for 0 < mc < 1."""
        turns, sign, size, is_reflected = _folded(u, self.kept(quarter_period, mc))
        s, c, d = self.first_half(size, mc)
        if is_reflected:  # sn, cn, dn of K - w by those of w (DLMF 22.4(iii))
            kc = mc.sqrt()
            s, c, d = c / d, kc * s / d, kc / d
        flip = -1 if turns % 2 else 1
        return flip * sign * s, flip * c, d

    def elliptic_j(self, u: arb, n: arb, mc: arb) -> arb:
        """Return the integral of sn^2/(1 - n sn^2) from 0 to u, for -1 < n <= 0.

        It is elementary where mc is exactly 0 or 1.
        """
        if mc.is_zero():
            root = (-n).sqrt()
            return (u - (root * u.tanh()).atan() / root) / (1 - n)
        if mc == 1:
            return (u - u.sin() * u.cos()) / 2  # n = 0
        turns, sign, size, is_reflected = _folded(u, self.kept(quarter_period, mc))
        whole = self.kept(self.complete_j, n, mc)
        if not is_reflected:
            return 2 * turns * whole + sign * self.first_half_j(size, n, mc)
        share = mc / (1 - n)
        beyond = (size - share * self.first_half_j(size, 1 - share, mc)) / (1 - n)
        return 2 * turns * whole + sign * (whole - beyond)

    @abstractmethod
    def first_half(self, u: arb, mc: arb) -> Triple:
        """Return Jacobi's sn, cn and dn for |u| <= K/2 and a little beyond."""

    @abstractmethod
    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """Return the integral J of sn^2/(1 - n sn^2) from 0 to u, for |u| up to about K/2.

        n < 1, and |u| may be a little beyond K/2.
        """

    @abstractmethod
    def complete_j(self, n: arb, mc: arb) -> arb:
        """Return the complete integral J of sn^2/(1 - n sn^2) from 0 to K."""


def _folded(u: arb, quarter: arb) -> tuple[int, int, arb, bool]:
    """Reduce an argument to at most K/2 in size by periods and reflection.

    Return turns, sign, size and is_reflected: u = 2 K turns + sign (size or K - size).

    Any turns, sign and reflection are right if surely |size| < K; else the size is no number.
    """
    turns = int((u / (2 * quarter)).mid().floor().unique_fmpz() or 0)
    rest = u - 2 * turns * quarter
    if rest.mid() > quarter.mid():
        turns, rest = turns + 1, rest - 2 * quarter
    sign = -1 if rest.mid() < 0 else 1
    size = sign * rest
    is_reflected = not 2 * size.mid() <= quarter.mid()
    if is_reflected:
        size = quarter - size
    return turns, sign, size if abs(size) < quarter else arb.nan(), is_reflected


class Landen(Functions):
    """Functions computed by Landen's and Gauss's descending transformations.

    The transformations end at a parameter m_N.  There |am(u) - u| <= m_N |u|, as 1 - m <= dn <= 1,
    and the integral of the third kind is within the factor 1/sqrt(1 - m_N) of the trigonometric
    one.
    """

    def first_half(self, u: arb, mc: arb) -> Triple:
        """Compute Jacobi's sn, cn and dn by the AGM (DLMF 22.20(ii))."""
        phi = amplitude(u, mc)
        s, c = phi.sin_cos()
        return s, c, (c * c + mc * s * s).sqrt()

    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """Compute the integral of sn^2/(1 - n sn^2) as (Pi - u)/n."""
        s, c, d = self.first_half(u, mc)
        return (_third_kind(s, c, d, n, 1 - mc, mc, u) - u) / n

    def complete_j(self, n: arb, mc: arb) -> arb:
        """Compute the complete integral J(K) as (Pi(n | m) - K)/n."""
        one, zero = arb(1), arb(0)
        quarter = quarter_period(mc)
        return (_third_kind(one, zero, mc.sqrt(), n, 1 - mc, mc, quarter) - quarter) / n


def amplitude(u: arb, mc: arb) -> arb:
    """Compute Jacobi's amplitude am(u | 1 - mc) for |u| <= K."""
    a, b = arb(1), mc.sqrt()
    ratios, narrows = [], True
    while narrows:  # each step halves the gap at least, until it is all rounding or uncertainty
        gap, mean = a - b, (a + b) / 2
        ratios.append(gap / (2 * mean))
        a, b = mean, (a * b).sqrt()
        narrows = 4 * (a - b).abs_upper() < 3 * gap.abs_upper()
    parameter = 1 - (b / a) ** 2
    phi = 2 ** len(ratios) * a * u
    phi += arb(0, (parameter * phi).abs_upper())
    for ratio in reversed(ratios):
        phi = (phi + (ratio * phi.sin()).asin()) / 2
    return phi


def _third_kind(s: arb, c: arb, d: arb, n: arb, m: arb, mc: arb, u: arb) -> arb:
    """Compute Pi(n; phi | m) by Gauss's transformation (DLMF 19.8.20).

    phi is in [0, pi/2].

    rho Pi = 4/(1 + k') Pi_1 + (rho - 1) u - R_C(1/s^2 - 1, 1/s^2 - n), until m is gone.
    """
    if m.abs_upper() < arb(2) ** -ctx.prec:
        root = (1 - n).sqrt()
        value = arb.atan2(root * s, c) / root
        return value + arb(0, (value * m).abs_upper())
    kc = mc.sqrt()
    rho, k_1 = (1 - m / n).sqrt(), m / (1 + kc) ** 2
    d_1 = ((1 - k_1 + d * (1 + k_1)) / (1 + d)).sqrt()
    s_1, c_1 = (1 + kc) * s / (1 + d), 2 * c / ((1 + d) * d_1)
    n_1, mc_1 = n * ((1 + rho) / (1 + kc)) ** 2, 4 * kc / (1 + kc) ** 2
    below = _third_kind(s_1, c_1, d_1, n_1, k_1 * k_1, mc_1, u / (1 + k_1))
    turned = s * acb.elliptic_rc(c * c, 1 - n * s * s).real
    return (4 / (1 + kc) * below + (rho - 1) * u - turned) / rho


class Carlson(Functions):
    """Functions computed by Carlson's symmetric integrals.

    The inverse of R_F is found by Newton's method.  It is proved to be one by a step of interval
    Newton, which maps a ball into its own interior.
    """

    def first_half(self, u: arb, mc: arb) -> Triple:
        """Compute Jacobi's sn, cn and dn from the amplitude phi with F(phi) = u."""
        start = amplitude(u.mid(), mc.mid()).mid()  # any guess would do
        for _ in range(3):
            value, slope = first_kind(start, mc)
            start = (start - (value - u) / slope).mid()
        value, slope = first_kind(start, mc)
        reach = 2 * ((value - u) / slope).abs_upper() + arb(2) ** (-ctx.prec // 2)
        box = start + arb(0, reach)
        phi = start - (value - u) / first_kind(box, mc)[1]
        # R_F gives F(start) only where the cosine is positive.
        if not (box.contains_interior(phi) and start.cos() > 0):
            phi = arb.nan()
        s, c = phi.sin_cos()
        return s, c, _delta(s, c, mc)

    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """Compute the integral J by Carlson's R_J (DLMF 19.25.14).

        J = s^3 R_J(c^2, d^2, 1, 1 - n s^2)/3.
        """
        s, c, d = self.kept(self.first_half, u, mc)
        return s * s * s * acb.elliptic_rj(c * c, d * d, arb(1), 1 - n * s * s).real / 3

    def complete_j(self, n: arb, mc: arb) -> arb:
        """Compute the complete integral J(K) as R_J(0, mc, 1, 1 - n)/3."""
        return acb.elliptic_rj(arb(0), mc, arb(1), 1 - n).real / 3


def first_kind(phi: arb, mc: arb) -> tuple[arb, arb]:
    """Compute the integral of the first kind F(phi) and its derivative.

    F(phi) = s R_F(c^2, d^2, 1); its derivative is 1/d.
    """
    s, c = phi.sin_cos()
    d = _delta(s, c, mc)
    return s * carlson_f(c * c, d * d, arb(1)), 1 / d


def _delta(s: arb, c: arb, mc: arb) -> arb:
    """Compute dn from the sine and cosine of the amplitude without cancellation.

    dn = sqrt(c^2 + mc s^2).
    """
    return (c * c + mc * s * s).sqrt()


class Quadrature(Carlson):
    """Functions with the integral of sn^2/(1 - n sn^2) computed by rigorous quadrature.

    sn, cn and dn are those of `Carlson`.
    """

    quick_bits = 2**10

    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """Compute J by integrating sin^2/((1 - n sin^2) Delta) from 0 to am(u)."""
        s, c, _ = self.kept(self.first_half, u, mc)
        return _integral(arb.atan2(s, c), n, mc)

    def complete_j(self, n: arb, mc: arb) -> arb:
        """Compute the complete integral J(K) by integrating from 0 to pi/2."""
        return _integral(arb.pi() / 2, n, mc)


def _integral(phi: arb, n: arb, mc: arb) -> arb:
    """Integrate sin^2/((1 - n sin^2) Delta) from 0 to phi rigorously."""
    if not (phi.is_finite() and n.is_finite() and mc.is_finite()):
        return arb.nan()
    # No finer than the arguments.
    sharp = [x.rel_accuracy_bits() for x in (phi, mc, 1 - n)]
    tolerance = arb(2) ** -max(1, min(ctx.prec, *sharp))

    def integrand(angle: acb, analytic: bool) -> acb:
        sine, cosine = angle.sin_cos()
        square = sine * sine
        delta = (cosine * cosine + mc * square).sqrt(analytic=analytic)
        return square / ((1 - n * square) * delta)

    return acb.integral(integrand, 0, phi, rel_tol=tolerance, abs_tol=tolerance).real


class Theta(Carlson):
    """Functions computed by theta functions, except `elliptic_j` by Carlson's R_J."""

    quick_bits = 2**14

    def table(self) -> Table:
        """Return the table of functions, with those of the theta form."""
        return {
            **super().table(),
            "pi": arb.pi(),
            "I": acb(0, 1),
            "re": lambda z: z.real,
            "im": lambda z: z.imag,
            "elliptic_k": quarter_period,
            "elliptic_pi": lambda n, mc: quarter_period(mc) + n * self.complete_j(n, mc),
            "nome": _nome,
            "arcsc": _arcsc,
            "theta4": lambda z, q: self.kept(self._theta4, z, q),
            "dtheta4": lambda z, q: _thetas(z, self.kept(_tau, q), 1)[3] / arb.pi(),
        }

    def between(self, u: arb, mc: arb) -> Triple:
        """Compute Jacobi's sn, cn and dn from theta functions (DLMF 22.2.4 to 22.2.6)."""
        scale, tau, two, three, four = self.kept(_constants, mc)
        one_u, two_u, three_u, four_u = (z.real for z in _thetas(acb(scale * u), tau))
        s = three * one_u / (two * four_u)
        return s, four * two_u / (two * four_u), four * three_u / (three * four_u)

    def first_half(self, u: arb, mc: arb) -> Triple:
        """Return Jacobi's sn, cn and dn by theta functions, as `between` does for all u."""
        return self.between(u, mc)

    def _theta4(self, z: acb, q: arb) -> acb:
        return _thetas(z, self.kept(_tau, q))[3]


def _thetas(z: acb, tau: acb, derivative: int = 0) -> tuple[acb, ...]:
    """Compute the theta functions theta_1 to theta_4 of z.

    z is reduced by whole turns 2 pi; Arb takes it in units of pi.
    """
    turns = z / arb.pi()
    whole = (turns.real / 2 + arb(1) / 2).mid().floor()
    return (turns - 2 * whole).modular_theta(tau, derivative)


def _tau(q: arb) -> acb:
    return acb(0, -q.log() / arb.pi())


def _nome(mc: arb) -> arb:
    """Compute the nome exp(-pi K'/K) of Jacobi's functions by the AGM."""
    return (-arb.pi() * arb(1).agm(mc.sqrt()) / arb(1).agm((1 - mc).sqrt())).exp()


def _arcsc(x: arb, mc: arb) -> arb:
    """Compute the inverse of Jacobi's function sc for x >= 0.

    This is the u >= 0 with sc(u | 1 - mc) = x, or F(arctan x).
    """
    square = 1 + x * x
    s, c, dd = x / square.sqrt(), 1 / square.sqrt(), (1 + mc * x * x) / square
    return s * carlson_f(c * c, dd, arb(1))


def _constants(mc: arb) -> tuple[arb, acb, arb, arb, arb]:
    """Return the constants of the theta functions for a complement mc.

    They are pi/(2 K), tau, and theta_2, theta_3, theta_4 of zero.
    """
    tau = _tau(_nome(mc))
    _, two, three, four = (z.real for z in _thetas(acb(0), tau))
    return arb.pi() / (2 * quarter_period(mc)), tau, two, three, four


# The methods whose balls contain the true values.
METHODS = {"theta": Theta, "carlson": Carlson, "landen": Landen, "quadrature": Quadrature}
