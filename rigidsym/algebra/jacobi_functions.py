r"""Jacobi's elliptic functions for SymPy: `jacobi_sn`, `jacobi_cn`, `jacobi_dn`, `jacobi_am`.

Conventions: the second argument is the parameter m = k^2, as in SymPy's own elliptic integrals;
the definitions are those of DLMF chapter 22, with mc = 1 - m the complement and K = K(m).

* am(u, m) is the integral of dn from 0 to u (DLMF 22.16(i)): for real u and m <= 1 it grows
  without jumps, am(u + 2 K) = am(u) + pi.  For m > 1 it swings, and is arcsin(sn).
* d/du: DLMF 22.13(i) for sn, cn, dn; DLMF 22.16(i) for am.
* d/dm, where m is neither 0 nor 1, with E the incomplete integral `elliptic_e(am, m)`:

      dam/dm = (dn (mc u - E) + m sn cn) / (2 m mc)
      dsn/dm = cn dam/dm,    dcn/dm = -sn dam/dm
      ddn/dm = -sn (cn (mc u - E) + sn dn) / (2 mc)

  The first follows from DLMF 19.4(ii) at fixed u = F(am, m), the others from sn = sin am,
  cn = cos am, dn^2 = 1 - m sn^2.  Written for a symbol m they are 0/0 at m = 0 (not ddn/dm)
  and at m = 1; `fdiff` at these two numbers gives the limits, first order in DLMF 22.10(ii).
  SymPy's `series` and `limit` work in u, and raise NotImplementedError in m.
  For real m > 1 they hold on the first swing only, |u| < K(1/m) / sqrt(m): later E(am, m) is
  no longer the integral of dn^2 that is meant.
* m = 0 and m = 1: DLMF 22.5(ii); gd(u) is written 2 arctan(tanh(u/2)), which never overflows.

Real u and m give finite real values of all four (DLMF 22.17 for m outside [0, 1]).

Printed code reaches the implementations through the tables `NUMPY` and `MPMATH`, so `lambdify`
works with "numpy", "scipy" and "mpmath"; an entry in a dictionary of the caller's comes first.
NumPy has no `elliptic_e`, which d/dm needs; mpmath has.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp
from sympy import Expr, S, atan, cos, elliptic_e, sech, sin, tanh
from sympy.core.function import ArgumentIndexError, DefinedFunction

__all__ = ["MPMATH", "NUMPY", "jacobi_am", "jacobi_cn", "jacobi_dn", "jacobi_sn"]


class _Rule(NamedTuple):
    """What tells one function from the others; `du` and `dm` are its two derivatives."""

    du: Callable[[Any, Any], Any]
    dm: Callable[[Any, Any], Any]
    circular: Callable[[Any], Any]  # at m = 0
    hyperbolic: Callable[[Any], Any]  # at m = 1
    origin: int  # at u = 0
    sign: int  # of f(-u) / f(u)


class _Jacobi(DefinedFunction):
    """A function of (u, m) that follows its rule in `_RULES`.

    SymPy counts the arguments of `eval`, which is why they are named there.
    """

    @classmethod
    def eval(cls, u: Any, m: Any) -> Any:  # ty: ignore[incompatible-method-override]
        """The values at u = 0, m = 0 and m = 1, and parity in u."""
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
        """The derivative with respect to u (1) or m (2)."""
        rule = _RULES[type(self).__name__]
        if argindex not in (1, 2):
            raise ArgumentIndexError(self, argindex)
        return (rule.du if argindex == 1 else rule.dm)(*self.args)

    def _pair(self) -> Any:
        return self.args

    def _eval_is_real(self) -> bool | None:
        u, m = self._pair()
        return True if u.is_real and m.is_real else None

    def _eval_evalf(self, prec: int) -> Any:
        u, m = self._pair()
        wide = 2 * prec + 64  # 1 - m keeps enough digits when m is close to 1
        try:
            wide += _guard(u._to_mpmath(prec))
            with mp.workprec(prec):
                value = MPMATH[type(self).__name__](u._to_mpmath(wide), m._to_mpmath(wide))
        except ValueError:  # an argument that is no number, or am off the real line
            return None
        return Expr._from_mpmath(value, prec)

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        u, m = (printer._print(argument) for argument in self.args)
        power = "" if exp is None else f"^{{{exp}}}"
        name = type(self).__name__.removeprefix("jacobi_")
        return rf"\operatorname{{{name}}}{power}\left({u} \mid {m}\right)"

    def _code(self, printer: Any, table: str) -> str:
        name = type(self).__name__
        if name in printer.known_functions:  # the caller's own implementation
            return printer._print_Function(self)
        arguments = ", ".join(printer._print(argument) for argument in self.args)
        return f"{printer._module_format(f'{__name__}.{table}')}['{name}']({arguments})"

    def _numpycode(self, printer: Any) -> str:
        return self._code(printer, "NUMPY")

    def _mpmathcode(self, printer: Any) -> str:
        return self._code(printer, "MPMATH")


class jacobi_sn(_Jacobi):  # noqa: N801 - SymPy's functions are lower case
    """Jacobi's sn(u, m), odd in u: the sine of `jacobi_am`."""


class jacobi_cn(_Jacobi):  # noqa: N801
    """Jacobi's cn(u, m), even in u: the cosine of `jacobi_am`."""


class jacobi_dn(_Jacobi):  # noqa: N801
    """Jacobi's dn(u, m), even in u: sqrt(1 - m sn^2), continued from 1 at u = 0."""

    def _eval_is_positive(self) -> bool | None:
        u, m = self._pair()
        return True if u.is_real and (1 - m).is_nonnegative else None


class jacobi_am(_Jacobi):  # noqa: N801
    """Jacobi's amplitude am(u, m), odd in u: the integral of `jacobi_dn` from 0."""


def _is_one(m: Any) -> bool:
    """Whether m is the number 1, exact or a Float (SymPy tells the two apart)."""
    return m == 1 or m == 1.0


def _functions(u: Any, m: Any) -> tuple[Any, Any, Any]:
    return jacobi_sn(u, m), jacobi_cn(u, m), jacobi_dn(u, m)


def _drift(u: Any, m: Any) -> Any:
    """mc u - E(am, m), which is all that is not elementary in d/dm."""
    return (1 - m) * u - elliptic_e(jacobi_am(u, m), m)


def _am_dm(u: Any, m: Any) -> Any:
    sn, cn, dn = _functions(u, m)
    if m.is_zero:
        return (sn * cn - u) / 4
    if _is_one(m):
        return (u * cn - sn / cn) / 4
    return (dn * _drift(u, m) + m * sn * cn) / (2 * m * (1 - m))


def _dn_dm(u: Any, m: Any) -> Any:
    sn, cn, dn = _functions(u, m)
    if _is_one(m):
        return -sn * (u * cn + sn / cn) / 4
    return -sn * (cn * _drift(u, m) + sn * dn) / (2 * (1 - m))


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
        dm=_dn_dm,
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
}


def _guard(u: Any) -> int:
    """How many bits the reduction of u by periods may cost."""
    return max(0, int(mp.mag(u))) if u and mp.isfinite(u) else 0


def _mp_am(u: Any, m: Any) -> Any:
    """The amplitude of real u, reduced by its half turns: am(u + 2 K) = am(u) + pi."""
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


def _mp_function(kind: str) -> Callable[[Any, Any], Any]:
    """One of the four over mpmath numbers, to the precision that is set when it is called."""

    def evaluate(u: Any, m: Any) -> Any:
        u, m = mp.convert(u), mp.convert(m)
        if not (mp.isfinite(u) and mp.isfinite(m)):
            return mp.nan
        with mp.extraprec(mp.prec + 64 + _guard(u)):
            value = _mp_am(u, m) if kind == "am" else mp.ellipfun(kind, u, m=m)
            if not (mp.im(u) or mp.im(m)):
                value = mp.re(value)  # theta functions of m > 1 leave a faint imaginary part
        return +value

    return evaluate


def _np_agm(mc: Any) -> list[tuple[Any, Any]]:
    """List the pairs of the AGM of 1 and sqrt(mc) (DLMF 19.8(i)), mc = 0 being put off."""
    b = np.sqrt(np.where(mc == 0, 1.0, mc))
    a = np.ones_like(b)
    steps = [(a, b)]
    while np.any(np.abs(a - b) > 1e-8 * a):  # the next mean is then exact in double precision
        a, b = (a + b) / 2, np.sqrt(a * b)
        steps.append((a, b))
    return steps


def _np_tangent(u: Any, steps: list[tuple[Any, Any]]) -> Any:
    """tan(am u) for 0 <= u <= K/2, by descending Landen transformations.

    DLMF 22.7(i) for t = sc / a, with a and b from the AGM: only positive terms are added.
    """
    mean = sum(steps[-1]) / 2
    t = np.tan(mean * u) / mean
    for a, b in reversed(steps[1:]):
        t = t * np.hypot(1, a * t) / np.hypot(1, b * t)
    return t


def _np_amplitude(u: Any, m: Any) -> tuple[Any, Any, Any, Any]:
    """Half turns of the amplitude of u, the sine and cosine of what is left, and dn.

    Past K/2 the argument is reflected to K - |v| (DLMF 22.4(iii)), so that cn and dn come
    without cancellation.  m = 1, where K is infinite, has its closed form.
    """
    mc = 1 - m
    steps = _np_agm(mc)
    quarter = np.where(mc == 0, 1e300, np.pi / sum(steps[-1]))
    turns = np.rint(u / (2 * quarter))
    v = u - turns * (2 * quarter)
    size = np.abs(v)
    far = size > quarter / 2
    t = _np_tangent(np.where(far, quarter - size, size), steps)
    kc, e = np.sqrt(mc), np.exp(-size)
    s = np.where(mc == 0, np.tanh(size), np.where(far, 1.0, t))
    c = np.where(mc == 0, 2 * e / (1 + e * e), np.where(far, kc * t, 1.0))
    norm = np.hypot(s, c)
    return turns, np.copysign(s, v) / norm, c / norm, np.hypot(c, kc * s) / norm


def _np_function(kind: str) -> Callable[[Any, Any], Any]:
    """One of the four over arrays of real numbers that broadcast; nan where m > 1."""

    @np.errstate(all="ignore")
    def evaluate(u: Any, m: Any) -> Any:
        u, m = np.asarray(u, dtype=float), np.asarray(m, dtype=float)
        turns, sine, cosine, dn = _np_amplitude(u, m)
        if kind == "am":
            return turns * np.pi + np.arctan2(sine, cosine)
        if kind == "dn":
            return dn
        return (1 - 2 * (turns % 2)) * (sine if kind == "sn" else cosine)

    return evaluate


NUMPY = {f"jacobi_{kind}": _np_function(kind) for kind in ("sn", "cn", "dn", "am")}
"""Implementations over NumPy arrays of real u and m <= 1.

Absolute errors are about 1e-15 for small u and grow with the rounding of u / K: 1e-14 at 30.
"""

MPMATH = {f"jacobi_{kind}": _mp_function(kind) for kind in ("sn", "cn", "dn", "am")}
"""Implementations over mpmath numbers, at the working precision."""
