r"""Legendre's integral of the third kind as a function of Jacobi's argument, for SymPy.

`jacobi_pi(n, u, m)` is Pi(n; am(u | m) | m), the integral of 1/(1 - n sn^2(v | m)) over v from 0
to u (DLMF 22.16.32 with 19.2.7); n is first and m = k^2 last, as in SymPy's `elliptic_pi`.  For
real u, m <= 1 and n < 1 it grows without jumps: Pi(u + 2 K) = Pi(u) + 2 Pi(n | m).  On the real
line and on those through +-K across it the path around the poles is known (first along the real
line), so u lies there, and n and m are real.

* d/du is 1/(1 - n sn^2); `fdiff` raises ArgumentIndexError for n and m.
* n = 0: u.  m = 1: (u + sqrt(-n) arctan(sqrt(-n) tanh u))/(1 - n).
* `rewrite(elliptic_pi)` gives Legendre's form.
"""

from typing import Any

import numpy as np
from mpmath import mp
from sympy import S, atan, elliptic_pi, sqrt, tanh
from sympy.core.function import ArgumentIndexError

from rigidsym.language.functions import _arrays as arrays
from rigidsym.language.functions._arguments import Argument, joined, split
from rigidsym.language.functions._evaluated import Evaluated
from rigidsym.language.functions._jacobi import jacobi_am, jacobi_sn

_ROUNDS = 14  # of duplication: the rest is below 4^-84 of the arguments' spread


class jacobi_pi(Evaluated):  # noqa: N801 - SymPy's functions are lower case
    """The elliptic integral of the third kind, as a function of Jacobi's argument u.

    This is Pi(n; am(u | m) | m).

    It is odd in u, and equals the integral of 1/(1 - n sn^2) from 0 to u.
    """

    @classmethod
    def eval(cls, n: Any, u: Any, m: Any) -> Any:  # ty: ignore[incompatible-method-override]
        """Simplify the function at K, n = 0, m = 1, past whole periods and for negative u."""
        if u.is_zero:
            return S.Zero
        if n.is_zero:
            return u
        if m == 1:
            root = sqrt(-n)
            return (u + root * atan(root * tanh(u))) / (1 - n)
        rest, quarters, imaginary = split(u, m)
        if rest.is_zero and not imaginary:
            return quarters * elliptic_pi(n, m)
        if rest.could_extract_minus_sign():
            return -cls(n, -u, m)
        if whole := quarters - quarters % 2:
            left = joined(Argument(rest, quarters - whole, imaginary), m)
            return cls(n, left, m) + whole * elliptic_pi(n, m)
        return None

    def fdiff(self, argindex: int = 1) -> Any:
        """Return the derivative with respect to u."""
        n, u, m = self._values()
        if argindex != 2:
            raise ArgumentIndexError(self, argindex)
        return 1 / (1 - n * jacobi_sn(u, m) ** 2)

    def _eval_is_real(self) -> bool | None:
        return super()._eval_is_real() if (1 - self._values()[0]).is_positive else None

    def _eval_rewrite_as_elliptic_pi(self, n: Any, u: Any, m: Any, **_: Any) -> Any:
        return elliptic_pi(n, jacobi_am(u, m), m)

    def _over_mpmath(self, *values: Any) -> Any:
        return _mp_pi(*values)

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        n, u, m = (printer._print(argument) for argument in self._values())
        power = "" if exp is None else f"^{{{exp}}}"
        amplitude = rf"\operatorname{{am}}\left({u} \mid {m}\right)"
        return rf"\Pi{power}\left({n}; {amplitude} \mid {m}\right)"

    def _pretty(self, printer: Any) -> Any:
        return printer._print(self.rewrite(elliptic_pi))


def _mp_pi(n: Any, u: Any, m: Any) -> Any:
    """Compute Pi from Carlson's R_J (DLMF 19.25.14), after reducing u by half turns."""
    n, u, m = map(mp.convert, (n, u, m))
    if mp.im(n) or mp.im(m) or mp.re(m) > 1 or mp.re(n) >= 1:
        raise ValueError("jacobi_pi: real n < 1 and m <= 1 expected")
    n, m = mp.re(n), mp.re(m)
    if mp.im(u):
        return _mp_across(n, u, m)
    u = mp.re(u)
    with mp.extraprec(mp.prec + 64 + (max(0, int(mp.mag(u))) if u else 0)):
        if m == 1:
            root = mp.sqrt(-n)
            return +mp.re((u + root * mp.atan(root * mp.tanh(u))) / (1 - n))
        period = 2 * mp.ellipk(m)
        turns = mp.nint(u / period)
        v = u - turns * period
        s, c, d = (mp.re(mp.ellipfun(kind, v, m=m)) for kind in ("sn", "cn", "dn"))
        value = v + n * s**3 * mp.elliprj(c * c, d * d, 1, 1 - n * s * s) / 3
        if turns:
            value += turns * (period + 2 * n * mp.elliprj(0, 1 - m, 1, 1 - n) / 3)
    return +value


def _mp_across(n: Any, u: Any, m: Any) -> Any:
    """Compute Pi for complex arguments u = +-K + i y.

    Pi(+-K + i y) = Pi(+-K) + i (y + n/(1 - n) Pi(m'/(1 - n); y | m')), where m' = 1 - m.
    """
    with mp.extraprec(64):
        quarter, y = mp.ellipk(m), mp.im(u)
        if abs(abs(mp.re(u)) - quarter) > mp.ldexp(quarter, -mp.prec // 4):
            raise ValueError("jacobi_pi: u on the real line or on those through +-K expected")
        complete = mp.sign(mp.re(u)) * _mp_pi(n, quarter, m)
        return complete + mp.mpc(0, y + n / (1 - n) * _mp_pi((1 - m) / (1 - n), y, 1 - m))


def _np_pi(n: Any, u: Any, m: Any) -> Any:
    """Compute Pi for NumPy arrays of real numbers.

    The arrays broadcast; m < 1 and n < 1.
    """
    n, u, m = (np.asarray(x, dtype=float) for x in (n, u, m))
    mc = 1 - m
    period = 2 * np.pi / sum(arrays.agm(np.asarray(mc))[-1])  # 2 K by the AGM
    turns = np.rint(u / period)
    v = u - turns * period
    s, c, d = (arrays.NUMPY[f"jacobi_{kind}"](v, m) for kind in ("sn", "cn", "dn"))
    part = v + n * s**3 * _np_rj(c * c, d * d, 1 - n * s * s) / 3
    whole = period + 2 * n * _np_rj(np.zeros_like(mc), mc, 1 - n) / 3
    return (part + turns * whole)[()]


def _np_rj(x: Any, y: Any, p: Any) -> Any:
    """Compute Carlson's R_J(x, y, 1, p) by duplication (DLMF 19.26.18).

    x >= 0, y >= 0, not both 0; p > 0.
    """
    x, y, p = np.broadcast_arrays(x, y, p)
    z = np.ones_like(p)
    total, scale = np.zeros_like(p), 1.0
    for _ in range(_ROUNDS):
        rx, ry, rz, rp = map(np.sqrt, (x, y, z, p))
        step = rx * ry + ry * rz + rz * rx
        d = (rp + rx) * (rp + ry) * (rp + rz)
        e = (p - x) * (p - y) * (p - z) / (d * d)
        total = total + scale / d * _np_rc1(e)
        x, y, z, p = ((value + step) / 4 for value in (x, y, z, p))
        scale /= 4
    mean = (x + y + z + 2 * p) / 5
    e2, e3, e4, e5 = _symmetric(*(1 - value / mean for value in (x, y, z)))
    series = (
        1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    )
    return scale * series / (mean * np.sqrt(mean)) + 6 * total


def _symmetric(x: Any, y: Any, z: Any) -> tuple[Any, Any, Any, Any]:
    """Return the symmetric functions E_2 to E_5 in the series of R_J (DLMF 19.36(i))."""
    p = -(x + y + z) / 2
    e2 = x * y + x * z + y * z - 3 * p * p
    e3 = x * y * z + 2 * e2 * p + 4 * p**3
    return e2, e3, (2 * x * y * z + e2 * p + 3 * p**3) * p, x * y * z * p * p


def _np_rc1(e: Any) -> Any:
    """Compute Carlson's R_C(1, 1 + e).

    It is arctan(sqrt e)/sqrt e, or artanh(sqrt(-e))/sqrt(-e) where e < 0.
    """
    root = np.sqrt(np.where(np.abs(e) < 1e-8, 1.0, np.abs(e)))
    far = np.where(e > 0, np.arctan(root), np.arctanh(np.minimum(root, 1 - 1e-16))) / root
    return np.where(np.abs(e) < 1e-8, 1 - e / 3 + e * e / 5, far)


NUMPY = {"jacobi_pi": _np_pi}
"""Over NumPy arrays of real n < 1, real u and m < 1; errors are some 1e-15 of the value."""

MPMATH = {"jacobi_pi": _mp_pi}
"""Over mpmath numbers, at the working precision."""
