r"""Jacobi's elliptic functions sn, cn, dn, am and epsilon for SymPy.

SymPy 1.14 has none of them.  This module, `_simplification` and the two that they need import SymPy
and mpmath alone, so they could be offered to SymPy; its pull request 30366 gives sn, cn and dn the
same names and arguments.

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
* m = 0 and m = 1: DLMF 22.5(ii); gd(u) is written 2 arctan(tanh(u/2)), which never overflows.

Real u and m give finite real values of all five (DLMF 22.17 for m outside [0, 1]).

What SymPy does with them:

* It evaluates them at u = 0, K, 2 K, i K' and their sums, takes out whole periods, and reduces
  sn(F(x, m), m) to sin(x).
* `expand_func` applies the addition theorems, Jacobi's imaginary transformation and the
  translations by K and i K'; `rewrite` to sin, cos, jacobi_am, Integral and elliptic_e works where
  it is an identity.
* `simplify` uses sn^2 + cn^2 = 1 and dn^2 + m sn^2 = 1, so `checkodesol` does (`_simplification`).
* `series` works about regular points and poles in u; `limit` in u and m.  `series` in m gives two
  terms about m = 0 or 1, and raises PoleError for more.
* Printers of languages that lack these functions raise an error that says how to name one.

Examples
--------
>>> from sympy import I, elliptic_k, expand_func, simplify, symbols
>>> u, v, m = symbols("u v m")
>>> simplify(jacobi_dn(u, m)**2 + m*jacobi_sn(u, m)**2)
1
>>> jacobi_sn(u + 2*elliptic_k(m), m), jacobi_cn(elliptic_k(m), m)
(-jacobi_sn(u, m), 0)
>>> expand_func(jacobi_sn(u + I*elliptic_k(1 - m), m))
1/(sqrt(m)*jacobi_sn(u, m))
>>> jacobi_cn(u, m).series(u, 0, 4)
1 - u**2/2 + O(u**4)
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from mpmath import mp
from sympy import (
    Dummy,
    Integral,
    Order,
    S,
    atan,
    cos,
    elliptic_e,
    elliptic_f,
    pi,
    sech,
    sin,
    sqrt,
    tanh,
    zoo,
)
from sympy.core.function import ArgumentIndexError, PoleError

from rigidsym.language.functions._arguments import (
    AT_ZERO,
    Argument,
    Values,
    expanded,
    joined,
    shifted,
    split,
)
from rigidsym.language.functions._evaluated import Evaluated

__all__ = [
    "FUNCTIONS",
    "MPMATH",
    "JacobiFunction",
    "jacobi_am",
    "jacobi_cn",
    "jacobi_dn",
    "jacobi_epsilon",
    "jacobi_sn",
]


class _Rule(NamedTuple):
    """Derivatives, special values and symmetries of one of Jacobi's functions.

    `du` and `dm` are the derivatives with respect to u and m.
    """

    du: Callable[[Any, Any], Any]
    dm: Callable[[Any, Any], Any]
    circular: Callable[[Any], Any]  # at m = 0
    hyperbolic: Callable[[Any], Any]  # at m = 1
    origin: int  # at u = 0
    sign: int  # of f(-u) / f(u)


class JacobiFunction(Evaluated):
    """Base class of Jacobi's functions of (u, m), with their properties taken from `_RULES`.

    SymPy counts the arguments of `eval`, which is why they are named there.
    """

    @classmethod
    def eval(cls, u: Any, m: Any) -> Any:  # ty: ignore[incompatible-method-override]
        """Simplify the function at m = 0 and 1, at quarter periods, past whole ones and for -u."""
        rule = _RULES[cls.__name__]
        if u is S.NaN or m is S.NaN:
            return S.NaN
        if u.is_zero:
            return S(rule.origin)
        if m.is_zero:
            return rule.circular(u)
        if _is_one(m):
            return rule.hyperbolic(u)
        if isinstance(u, elliptic_f) and u.args[1] == m:
            return cls._of_integral(u.args[0], m)
        argument = split(u, m)
        if argument.quarters or argument.imaginary:
            return cls._translated(u, argument, m)
        if u.could_extract_minus_sign():
            return rule.sign * cls(-u, m)
        return None

    @classmethod
    def _of_integral(cls, phi: Any, m: Any) -> Any:
        """Return the function of F(phi, m), or None."""
        return None

    @classmethod
    def _translated(cls, u: Any, argument: Argument, m: Any) -> Any:
        """Return the function where u has quarter periods, with at most one of each left.

        Return None where u has that form already.
        """
        rest, *counts = argument
        sign = 1
        if rest.could_extract_minus_sign():
            rest, sign = -rest, _RULES[cls.__name__].sign
            counts = [-count for count in counts]
        if rest.is_zero:
            value = cls._of(shifted(AT_ZERO, m, *counts))
            return zoo if value.has(zoo) else sign * value
        left = joined(Argument(rest, *(count % 2 for count in counts)), m)
        if left == u:
            return None
        whole = [count - count % 2 for count in counts]
        return sign * cls._of(shifted(_values(left, m), m, *whole))

    @classmethod
    def _of(cls, values: Values) -> Any:
        return getattr(values, cls._name())

    @classmethod
    def _name(cls) -> str:
        return cls.__name__.removeprefix("jacobi_")

    def _eval_expand_func(self, **_: Any) -> Any:
        return self._of(expanded(*self._values(), _values))

    def _eval_conjugate(self) -> Any:
        return self.func(*(argument.conjugate() for argument in self._values()))

    def _eval_nseries(self, x: Any, n: int, logx: Any, cdir: int = 0) -> Any:
        u, m = self._values()
        end = m.subs(x, 0)
        if m.has(x) and (end.is_zero or _is_one(end)):
            return self._two_terms(x, n, end)
        if self.func(u.subs(x, 0), m) is S.ComplexInfinity:
            return self._near(x)._eval_nseries(x, n, logx, cdir)
        return super()._eval_nseries(x, n, logx, cdir)

    def _two_terms(self, x: Any, n: int, end: Any) -> Any:
        """Expand to first order about m = 0 or 1, where the derivative in m is a limit."""
        u, m = self._values()
        if n > 2 or u.has(x):
            raise PoleError(f"{self}: about m = {end} two terms are known, for a fixed argument")
        slope = self.func(u, end, evaluate=False).fdiff(2)
        return self.func(u, end) + slope * (m - end) + Order(x**n, x)

    def _eval_as_leading_term(self, x: Any, logx: Any, cdir: Any) -> Any:
        at, (u, _) = self.subs(x, 0), self._values()
        if not at.is_zero and at is not S.ComplexInfinity:
            return super()._eval_as_leading_term(x, logx, cdir) if at.has(S.NaN, zoo) else at
        near = u if u.subs(x, 0).is_zero else self._near(x)
        return near.as_leading_term(x, logx=logx, cdir=cdir)

    def _near(self, x: Any) -> Any:
        """Write the function by those of u less its value at x = 0, a zero or a pole."""
        u, m = self._values()
        begin, step = u.subs(x, 0), Dummy("h")
        return self.func(step + begin, m).expand(func=True).subs(step, (u - begin).expand())

    def _over_mpmath(self, *values: Any) -> Any:
        return MPMATH[type(self).__name__](*values)

    def fdiff(self, argindex: int = 1) -> Any:
        """Return the derivative with respect to u or m.

        argindex: 1 for u, 2 for m.
        """
        rule = _RULES[type(self).__name__]
        if argindex not in (1, 2):
            raise ArgumentIndexError(self, argindex)
        return (rule.du if argindex == 1 else rule.dm)(*self.args)

    def _guard(self, prec: int) -> int:
        return _lost_bits(*(argument._to_mpmath(prec) for argument in self._values()))

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        u, m = (printer._print(argument) for argument in self.args)
        power = "" if exp is None else f"^{{{exp}}}"
        return rf"{self._symbol()}{power}\left({u} \mid {m}\right)"

    def _pretty(self, printer: Any) -> Any:
        name = self._name()
        return printer._helper_print_function(self.func, self.args, func_name=name, delimiter=" | ")

    def _mcode(self, printer: Any) -> str:
        name = {"am": "Amplitude", "epsilon": "Epsilon"}.get(self._name(), self._name().upper())
        return f"Jacobi{name}[{printer.stringify(self.args, ', ')}]"

    def _maple(self, printer: Any) -> str:
        if self._name() == "epsilon":
            return self._code(printer)
        u, m = self.args  # Maple's second argument is the modulus
        return f"Jacobi{self._name().upper()}({printer.stringify((u, sqrt(m)), ', ')})"

    def _symbol(self) -> str:
        return rf"\operatorname{{{self._name()}}}"


class jacobi_sn(JacobiFunction):  # noqa: N801 - SymPy's functions are lower case
    """Jacobi's elliptic function sn(u, m), the sine of the amplitude.

    It is odd in u.
    """

    @classmethod
    def _of_integral(cls, phi: Any, m: Any) -> Any:
        return sin(phi)

    def _eval_rewrite_as_sin(self, u: Any, m: Any, **_: Any) -> Any:
        return sin(jacobi_am(u, m))

    _eval_rewrite_as_jacobi_am = _eval_rewrite_as_sin


class jacobi_cn(JacobiFunction):  # noqa: N801
    """Jacobi's elliptic function cn(u, m), the cosine of the amplitude.

    It is even in u.
    """

    @classmethod
    def _of_integral(cls, phi: Any, m: Any) -> Any:
        return cos(phi)

    def _eval_rewrite_as_cos(self, u: Any, m: Any, **_: Any) -> Any:
        return cos(jacobi_am(u, m))

    _eval_rewrite_as_jacobi_am = _eval_rewrite_as_cos


class jacobi_dn(JacobiFunction):  # noqa: N801
    """Jacobi's elliptic function dn(u, m), the derivative of the amplitude.

    It is even in u and equals sqrt(1 - m sn^2), continued from 1 at u = 0.
    """

    def _eval_is_positive(self) -> bool | None:
        return True if _is_circulating(*self._values()) else None

    def _eval_rewrite_as_jacobi_sn(self, u: Any, m: Any, **_: Any) -> Any:
        return sqrt(1 - m * jacobi_sn(u, m) ** 2) if self.is_positive else None

    def _eval_rewrite_as_jacobi_am(self, u: Any, m: Any, **_: Any) -> Any:
        return sqrt(1 - m * sin(jacobi_am(u, m)) ** 2) if self.is_positive else None


class jacobi_am(JacobiFunction):  # noqa: N801
    """Jacobi's amplitude am(u, m), the integral of dn from 0 to u.

    It is odd in u.
    """

    @classmethod
    def _of_integral(cls, phi: Any, m: Any) -> Any:
        return phi if _is_circulating(phi, m) else None

    @classmethod
    def _translated(cls, u: Any, argument: Argument, m: Any) -> Any:
        rest, quarters, imaginary = argument
        if imaginary:  # am is many-valued there
            return None
        if rest.is_zero:
            return quarters * pi / 2
        if rest.could_extract_minus_sign():
            return -cls(-u, m)
        halves, quarters = divmod(quarters, 2)
        left = joined(Argument(rest, quarters, 0), m)
        return None if left == u else cls(left, m) + halves * pi

    def _eval_expand_func(self, **_: Any) -> Any:
        return self

    def _eval_conjugate(self) -> Any:
        return self if self.is_real else None

    def _eval_rewrite_as_Integral(self, u: Any, m: Any, **_: Any) -> Any:
        x = Dummy("x")
        return Integral(jacobi_dn(x, m), (x, 0, u))


class jacobi_epsilon(JacobiFunction):  # noqa: N801
    """Jacobi's epsilon function of (u, m), the integral of dn^2 from 0 to u.

    It is odd in u.
    """

    def _eval_rewrite_as_elliptic_e(self, u: Any, m: Any, **_: Any) -> Any:
        return elliptic_e(jacobi_am(u, m), m) if _is_circulating(u, m) else None

    def _eval_rewrite_as_Integral(self, u: Any, m: Any, **_: Any) -> Any:
        x = Dummy("x")
        return Integral(jacobi_dn(x, m) ** 2, (x, 0, u))

    def _symbol(self) -> str:
        return r"\mathcal{E}"


def _is_one(m: Any) -> bool:
    """Return True if m is 1, either exactly or as a Float.

    SymPy distinguishes the two.
    """
    return m == 1 or m == 1.0


def _is_circulating(u: Any, m: Any) -> bool:
    """Return True for real u and m <= 1, where am grows without bound."""
    return bool(u.is_real and (1 - m).is_nonnegative)


def _values(u: Any, m: Any) -> Values:
    return Values(*_functions(u, m), jacobi_epsilon(u, m))


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


MPMATH = {f"jacobi_{kind}": _mp_function(kind) for kind in ("sn", "cn", "dn", "am", "epsilon")}
"""Implementations over mpmath numbers, at the working precision."""

FUNCTIONS = (jacobi_sn, jacobi_cn, jacobi_dn, jacobi_am, jacobi_epsilon)
