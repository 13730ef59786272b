r"""Jacobi's elliptic functions sn, cn, dn, am and epsilon for SymPy.

Conventions: the second argument is the parameter m = k^2, as in SymPy's own elliptic integrals;
the definitions are those of DLMF chapter 22, with mc = 1 - m the complement and K = K(m).

* am(u, m) is the integral of dn from 0 to u (DLMF 22.16(i)): for real u and m <= 1 it grows
  without jumps, am(u + 2 K) = am(u) + pi.  For m > 1 it swings, and is arcsin(sn).
* epsilon(u, m) is the integral of dn^2 from 0 to u (DLMF 22.16(ii)): E(am, m) continued past the
  first swing, epsilon(u + 2 K) = epsilon(u) + 2 E.
* d/du: DLMF 22.13(i) for sn, cn, dn; DLMF 22.16 for am and epsilon.
* d/dm, where m is neither 0 nor 1, with D = mc u - epsilon and W = (cn D + sn dn) / (2 mc):

      dam/dm = (dn D + m sn cn) / (2 m mc)
      dsn/dm = cn dam/dm,    dcn/dm = -sn dam/dm
      ddn/dm = -sn W,        depsilon/dm = cn W - u/2

  The first follows from DLMF 19.4(ii) at fixed u = F(am, m), the next three from sn = sin am,
  cn = cos am, dn^2 = 1 - m sn^2, and the last, which is dn dam/dm + (epsilon - u) / (2 m), from
  epsilon = E(am, m).  They are meromorphic in u and m, so they hold for m > 1 on every swing.
  Written for a symbol m, those of am, sn, cn are 0/0 at m = 0 and all are at m = 1, and nearby
  they lose digits; `fdiff` at these two numbers gives the limits, first order in DLMF 22.10(ii).
  SymPy's `series` and `limit` work in u, and raise NotImplementedError in m.
* m = 0 and m = 1: DLMF 22.5(ii); gd(u) is written 2 arctan(tanh(u/2)), which never overflows.

Real u and m give finite real values of all five (DLMF 22.17 for m outside [0, 1]).

Printed code reaches the implementations through the tables `NUMPY` and `MPMATH`, so `lambdify`
works with "numpy", "scipy" and "mpmath"; an entry in a dictionary of the caller's comes first.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp
from sympy import S, atan, cos, sech, sin, tanh
from sympy.core.function import ArgumentIndexError

from rigidsym.language.functions._base import Coded

__all__ = [
    "MPMATH",
    "NUMPY",
    "jacobi_am",
    "jacobi_cn",
    "jacobi_dn",
    "jacobi_epsilon",
    "jacobi_sn",
]


class _Rule(NamedTuple):
    """Derivatives, special values and parity of one of Jacobi's functions.

    `du` and `dm` are the derivatives with respect to u and m.
    """

    du: Callable[[Any, Any], Any]
    dm: Callable[[Any, Any], Any]
    circular: Callable[[Any], Any]  # at m = 0
    hyperbolic: Callable[[Any], Any]  # at m = 1
    origin: int  # at u = 0
    sign: int  # of f(-u) / f(u)


class _Jacobi(Coded):
    """Base class of Jacobi's functions of (u, m), with their properties taken from `_RULES`.

    SymPy counts the arguments of `eval`, which is why they are named there.
    """

    @classmethod
    def eval(cls, u: Any, m: Any) -> Any:  # ty: ignore[incompatible-method-override]
        """Simplify the function at u = 0, m = 0, m = 1 and for negative u."""
        rule = _RULES[cls.__name__]
        if u is S.NaN or m is S.NaN:
            return S.NaN
        if u.is_zero:
            return S(rule.origin)
        if m.is_zero:
            return rule.circular(u)
        if _is_one(m):
            return rule.hyperbolic(u)
        if u.could_extract_minus_sign():
            return rule.sign * cls(-u, m)
        return None

    def fdiff(self, argindex: int = 1) -> Any:
        """Return the derivative with respect to u or m.

        argindex: 1 for u, 2 for m.
        """
        rule = _RULES[type(self).__name__]
        if argindex not in (1, 2):
            raise ArgumentIndexError(self, argindex)
        return (rule.du if argindex == 1 else rule.dm)(*self.args)

    def _over_mpmath(self, *values: Any) -> Any:
        return MPMATH[type(self).__name__](*values)

    def _guard(self, prec: int) -> int:
        return _lost_bits(*(argument._to_mpmath(prec) for argument in self._values()))

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        u, m = (printer._print(argument) for argument in self.args)
        power = "" if exp is None else f"^{{{exp}}}"
        return rf"{self._symbol()}{power}\left({u} \mid {m}\right)"

    def _symbol(self) -> str:
        return rf"\operatorname{{{type(self).__name__.removeprefix('jacobi_')}}}"


class jacobi_sn(_Jacobi):  # noqa: N801 - SymPy's functions are lower case
    """Jacobi's elliptic function sn(u, m), the sine of the amplitude.

    It is odd in u.
    """


class jacobi_cn(_Jacobi):  # noqa: N801
    """Jacobi's elliptic function cn(u, m), the cosine of the amplitude.

    It is even in u.
    """


class jacobi_dn(_Jacobi):  # noqa: N801
    """Jacobi's elliptic function dn(u, m), the derivative of the amplitude.

    It is even in u and equals sqrt(1 - m sn^2), continued from 1 at u = 0.
    """

    def _eval_is_positive(self) -> bool | None:
        u, m = self._values()
        return True if u.is_real and (1 - m).is_nonnegative else None


class jacobi_am(_Jacobi):  # noqa: N801
    """Jacobi's amplitude am(u, m), the integral of dn from 0 to u.

    It is odd in u.
    """


class jacobi_epsilon(_Jacobi):  # noqa: N801
    """Jacobi's epsilon function of (u, m), the integral of dn^2 from 0 to u.

    It is odd in u.
    """

    def _symbol(self) -> str:
        return r"\mathcal{E}"


def _is_one(m: Any) -> bool:
    """Return True if m is 1, either exactly or as a Float.

    SymPy distinguishes the two.
    """
    return m == 1 or m == 1.0


def _functions(u: Any, m: Any) -> tuple[Any, Any, Any]:
    return jacobi_sn(u, m), jacobi_cn(u, m), jacobi_dn(u, m)


def _drift(u: Any, m: Any) -> Any:
    """Return D = (1 - m) u - epsilon, a term of the derivatives with respect to m."""
    return (1 - m) * u - jacobi_epsilon(u, m)


def _am_dm(u: Any, m: Any) -> Any:
    sn, cn, dn = _functions(u, m)
    if m.is_zero:
        return (sn * cn - u) / 4
    if _is_one(m):
        return (u * cn - sn / cn) / 4
    return (dn * _drift(u, m) + m * sn * cn) / (2 * m * (1 - m))


def _tilt(u: Any, m: Any) -> Any:
    """Return a factor of the derivatives of dn and epsilon with respect to m.

    It is W = (cn D + sn dn) / (2 (1 - m)), where D is `_drift`.
    """
    sn, cn, dn = _functions(u, m)
    if _is_one(m):
        return (u * cn + sn / cn) / 4
    return (cn * _drift(u, m) + sn * dn) / (2 * (1 - m))


_RULES = {
    "jacobi_sn": _Rule(
        du=lambda u, m: jacobi_cn(u, m) * jacobi_dn(u, m),
        dm=lambda u, m: jacobi_cn(u, m) * _am_dm(u, m),
        circular=sin,
        hyperbolic=tanh,
        origin=0,
        sign=-1,
    ),
    "jacobi_cn": _Rule(
        du=lambda u, m: -jacobi_sn(u, m) * jacobi_dn(u, m),
        dm=lambda u, m: -jacobi_sn(u, m) * _am_dm(u, m),
        circular=cos,
        hyperbolic=sech,
        origin=1,
        sign=1,
    ),
    "jacobi_dn": _Rule(
        du=lambda u, m: -m * jacobi_sn(u, m) * jacobi_cn(u, m),
        dm=lambda u, m: -jacobi_sn(u, m) * _tilt(u, m),
        circular=lambda u: S.One,
        hyperbolic=sech,
        origin=1,
        sign=1,
    ),
    "jacobi_am": _Rule(
        du=lambda u, m: jacobi_dn(u, m),
        dm=_am_dm,
        circular=lambda u: u,
        hyperbolic=lambda u: 2 * atan(tanh(u / 2)),
        origin=0,
        sign=-1,
    ),
    "jacobi_epsilon": _Rule(
        du=lambda u, m: jacobi_dn(u, m) ** 2,
        dm=lambda u, m: jacobi_cn(u, m) * _tilt(u, m) - u / 2,
        circular=lambda u: u,
        hyperbolic=tanh,
        origin=0,
        sign=-1,
    ),
}


def _lost_bits(*arguments: Any) -> int:
    """Return how many bits the reduction of u by periods may lose."""
    return sum(max(0, int(mp.mag(x))) for x in arguments if x and mp.isfinite(x))


def _mp_am(u: Any, m: Any) -> Any:
    """Return the amplitude am(u, m) of real mpmath numbers.

    The argument is reduced by am(u + 2 K) = am(u) + pi.
    """
    if mp.im(u) or mp.im(m):
        raise ValueError("am is many-valued off the real line: real u and m expected")
    u, m = mp.re(u), mp.re(m)
    if m == 1:
        return 2 * mp.atan(mp.tanh(u / 2))
    if m > 1:
        return mp.asin(mp.re(mp.ellipfun("sn", u, m=m)))
    period = 2 * mp.ellipk(m)
    turns = mp.nint(u / period)
    v = u - turns * period
    return turns * mp.pi + mp.atan2(*(mp.re(mp.ellipfun(kind, v, m=m)) for kind in ("sn", "cn")))


def _mp_epsilon(u: Any, m: Any) -> Any:
    """Compute Jacobi's epsilon from theta functions (DLMF 22.16.30)."""
    if m == 1:
        return mp.tanh(u)
    k, q = mp.ellipk(m), mp.qfrom(m=m)
    scale = mp.pi / (2 * k)
    theta, slope = (mp.jtheta(4, scale * u, q, order) for order in (0, 1))
    return mp.ellipe(m) / k * u + scale * slope / theta


def _mp_function(kind: str) -> Callable[[Any, Any], Any]:
    """Return the mpmath implementation of one of Jacobi's five functions.

    It is evaluated at the working precision.
    """
    function = {"am": _mp_am, "epsilon": _mp_epsilon}.get(
        kind, lambda u, m: mp.ellipfun(kind, u, m=m)
    )

    def evaluate(u: Any, m: Any) -> Any:
        u, m = mp.convert(u), mp.convert(m)
        if not (mp.isfinite(u) and mp.isfinite(m)):
            return mp.nan
        with mp.extraprec(mp.prec + 64 + _lost_bits(u, m)):
            value = function(u, m)
            if not (mp.im(u) or mp.im(m)):
                value = mp.re(value)  # theta functions of m > 1 leave a faint imaginary part
        return +value

    return evaluate


def _np_agm(mc: Any) -> list[tuple[Any, Any]]:
    """List the iterates of the arithmetic-geometric mean of 1 and sqrt(mc) (DLMF 19.8(i)).

    For mc = 0, they are those of 1 and 1.
    """
    b = np.sqrt(np.where(mc == 0, 1.0, mc))
    a = np.ones_like(b)
    steps = [(a, b)]
    while np.any(np.abs(a - b) > 1e-8 * a):  # the next mean is then exact in double precision
        a, b = (a + b) / 2, np.sqrt(a * b)
        steps.append((a, b))
    return steps


def _np_tangents(u: Any, steps: list[tuple[Any, Any]]) -> list[Any]:
    """List tan(am u) for 0 <= u <= K/2 and its descending Landen transforms.

    DLMF 22.7(i) for t = sc / a, with a and b from the AGM: only positive terms are added.
    """
    mean = sum(steps[-1]) / 2
    tangents = [np.tan(mean * u) / mean]
    for a, b in reversed(steps[1:]):
        t = tangents[-1]
        tangents.append(t * np.hypot(1, a * t) / np.hypot(1, b * t))
    return tangents[::-1]


def _np_reduce(u: Any, mc: Any) -> tuple[Any, Any, Any, list[tuple[Any, Any]], list[Any]]:
    """Reduce an argument by half turns, u = 2 K turns + v.

    Return turns, v, whether |v| > K/2, the iterates of the AGM, and the tangents.

    A far |v| is reflected to K - |v| (DLMF 22.4(iii)), so that cn and dn come without
    cancellation.  m = 1, where K is infinite, has its closed forms.
    """
    steps = _np_agm(mc)
    quarter = np.where(mc == 0, 1e300, np.pi / sum(steps[-1]))
    turns = np.rint(u / (2 * quarter))
    v = u - turns * (2 * quarter)
    size = np.abs(v)
    far = size > quarter / 2
    tangents = _np_tangents(np.where(far, quarter - size, size), steps)
    return turns, v, far, steps, tangents


def _np_amplitude(u: Any, m: Any) -> tuple[Any, Any, Any, Any]:
    """Return the half turns in am(u), the sine and cosine of the remainder, and dn."""
    mc = 1 - m
    turns, v, far, _, (t, *_) = _np_reduce(u, mc)
    size, kc = np.abs(v), np.sqrt(mc)
    e = np.exp(-size)
    s = np.where(mc == 0, np.tanh(size), np.where(far, 1.0, t))
    c = np.where(mc == 0, 2 * e / (1 + e * e), np.where(far, kc * t, 1.0))
    norm = np.hypot(s, c)
    return turns, np.copysign(s, v) / norm, c / norm, np.hypot(c, kc * s) / norm


def _np_epsilon(u: Any, m: Any) -> Any:
    """Compute Jacobi's epsilon as E u / K plus Jacobi's zeta function.

    Gauss's transformation (DLMF 19.8(iii)) of the integral of x cos^2 am + y sin^2 am leaves one
    of the same form and a term of zeta, until x = y = E / K.  For m >= 0 no term is negative.
    """
    mc = 1 - m
    _, v, far, steps, tangents = _np_reduce(u, mc)
    x, y, zeta = np.ones_like(mc), mc, np.zeros_like(mc)
    for (a, b), t in zip(steps, tangents, strict=True):
        p, q = np.hypot(1, a * t), np.hypot(1, b * t)
        near = t / (p * (p + q))  # sn cn / (a + dn), where dn^2 = a^2 cn^2 + b^2 sn^2
        gap = x - y
        zeta = zeta + gap * np.where(far, b * t / (q * (a * q + b * p)), near)
        x, y = x - gap / 2, y + gap * (b / (a + b))
    return np.where(mc == 0, np.tanh(u), x * u + np.sign(v) * zeta)[()]


def _np_function(kind: str) -> Callable[[Any, Any], Any]:
    """Return the NumPy implementation of one of Jacobi's five functions.

    Its arguments broadcast.  It returns nan for m > 1.
    """

    @np.errstate(all="ignore")
    def evaluate(u: Any, m: Any) -> Any:
        u, m = np.asarray(u, dtype=float), np.asarray(m, dtype=float)
        if kind == "epsilon":
            return _np_epsilon(u, m)
        turns, sine, cosine, dn = _np_amplitude(u, m)
        if kind == "am":
            return turns * np.pi + np.arctan2(sine, cosine)
        if kind == "dn":
            return dn
        return (1 - 2 * (turns % 2)) * (sine if kind == "sn" else cosine)

    return evaluate


_KINDS = ("sn", "cn", "dn", "am", "epsilon")

NUMPY = {f"jacobi_{kind}": _np_function(kind) for kind in _KINDS}
"""Implementations over NumPy arrays of real u and m <= 1.

Absolute errors are about 1e-15 for small u and grow with the rounding of u / K: 1e-14 at 30.
Those of epsilon are about 1e-15 of its value, or for m < 0 of E |u| / K where that is larger.
"""

MPMATH = {f"jacobi_{kind}": _mp_function(kind) for kind in _KINDS}
"""Implementations over mpmath numbers, at the working precision."""
