"""Jacobi's functions and J over balls, from what a method knows of one quarter of a period.

Conventions: m is the parameter k^2; functions take mc = 1 - m as their last argument, which is 0 on
the separatrix.  J(u) is the integral of sn^2/(1 - n sn^2) from 0 to u.

A method says what sn, cn, dn and J are for |u| <= K/2, and a little beyond.  Whole periods are
added, and past K/2 the argument is reflected to K - |u| (DLMF 22.4(iii)), so nothing is evaluated
near a branch point: with n' = (m - n)/(1 - n),

    J(K - w) = J(K) - (w - mc/(1 - n) J(w, n'))/(1 - n).
"""

from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable
from operator import is_
from typing import Any, TypeVar

from flint import acb, arb

from rigidsym.precise.balls import ball, power

Triple = tuple[arb, arb, arb]
# Functions and constants by the names that formulas use.
Function = Callable[..., arb | acb]
Table = dict[str, Function | arb | acb]
Value = TypeVar("Value")


def quarter_period(mc: arb) -> arb:
    """K(m) = pi/(2 agm(1, sqrt(mc))) (DLMF 19.8.5)."""
    return arb.pi() / (2 * arb(1).agm(mc.sqrt()))


def carlson_f(x: arb, y: arb, z: arb) -> arb:
    """R_F (DLMF 19.16.1)."""
    return acb.elliptic_rf(x, y, z).real


def argument(sn: arb, cn: arb, dn: arb) -> arb:
    """The u with these sn, cn, dn and |u| <= K, or a little more where cn may be negative.

    DLMF 19.25.5; where cn is not positive for sure, of K - |u|, whose sine is cn/dn.
    """
    if cn > 0 or cn.is_zero():
        return sn * carlson_f(cn * cn, dn * dn, arb(1))
    mc = (dn * dn - cn * cn) / (sn * sn)
    rest = cn * carlson_f(sn * sn * mc, mc, dn * dn)
    size = quarter_period(mc) - rest
    return size if sn > 0 else -size


# Of each function: J is asked for with two parameters n in turn.
KEPT = 2


class Functions(ABC):
    """The functions of formulas, by one method; what was evaluated last is kept."""

    # Up to here a state takes some tenths of a second.
    quick_bits = 2**13

    def __init__(self) -> None:
        # Of each function: arguments, and its value, of whatever type that is.
        self._last: dict[Callable[..., object], deque[tuple[tuple[arb | acb, ...], Any]]] = {}

    def table(self) -> Table:
        """The functions by the names that formulas use."""
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
        """The value of a function, the same object where the arguments are the same objects."""
        last = self._last.setdefault(function, deque(maxlen=KEPT))
        for known, value in last:
            if all(map(is_, known, arguments)):
                return value
        value = function(*arguments)
        last.append((arguments, value))
        return value

    def jacobi(self, u: arb, mc: arb) -> Triple:
        """sn, cn, dn of (u | 1 - mc); hyperbolic at mc = 0 and circular at mc = 1 exactly."""
        if mc.is_zero():
            return u.tanh(), u.sech(), u.sech()
        if mc == 1:
            return u.sin(), u.cos(), arb(1)
        return self.between(u, mc)

    def between(self, u: arb, mc: arb) -> Triple:
        """sn, cn, dn where 0 < mc < 1."""
        turns, sign, size, is_reflected = _folded(u, self.kept(quarter_period, mc))
        s, c, d = self.first_half(size, mc)
        if is_reflected:
            s, c, d = _reflected((s, c, d), mc)
        flip = -1 if turns % 2 else 1
        return flip * sign * s, flip * c, d

    def elliptic_j(self, u: arb, n: arb, mc: arb) -> arb:
        """J(u), elementary at mc = 0 and at mc = 1 exactly; needs -1 < n <= 0."""
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
        """sn, cn, dn for |u| <= K/2 and a little beyond."""

    @abstractmethod
    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """J(u) for |u| <= K/2 and a little beyond, n < 1."""

    @abstractmethod
    def complete_j(self, n: arb, mc: arb) -> arb:
        """J(K)."""


def _folded(u: arb, quarter: arb) -> tuple[int, int, arb, bool]:
    """turns, sign, size and whether it is reflected: u = 2 K turns + sign (size or K - size).

    Any turns, sign and reflection would do, as long as |size| < K for sure; else it is no number.
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


def _reflected(functions: Triple, mc: arb) -> Triple:
    """sn, cn, dn of K - w by those of w (DLMF 22.4(iii))."""
    s, c, d = functions
    kc = mc.sqrt()
    return c / d, kc * s / d, kc / d
