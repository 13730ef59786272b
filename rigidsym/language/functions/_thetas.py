r"""Real and imaginary parts of Jacobi's theta functions for SymPy.

`theta_re(k, x, y, q, r)` is the real part of the r-th derivative of theta_k(z | q) in z, at
z = x + i y (DLMF 20.2(i)); k is 1 to 4, x, y and the nome 0 <= q < 1 are real.  Parts, not the
complex function, because they are real and have derivatives in a real variable.

* d/dx raises r; d/dy raises r and takes the other part, minus the imaginary one for the real one.
* d/dq: 4 q dtheta/dq = -d^2 theta/dz^2 (DLMF 20.13(i) with q = exp(i pi tau)).
* y = 0: the imaginary part is 0.  x = 0: theta_k(i y) is real for k = 2, 3, 4 and imaginary for 1.
"""

from typing import Any

import numpy as np
from mpmath import mp
from sympy import S
from sympy.core.function import ArgumentIndexError

from rigidsym.language.functions._evaluated import Evaluated

# For q <= 0.97 the last term is below 1e-17 of the largest.
_TERMS = 36


class _Part(Evaluated):
    """Base class of the real and the imaginary part of a theta function."""

    _real_part: bool

    @classmethod
    def eval(cls, k: Any, x: Any, y: Any, q: Any, r: Any) -> Any:  # ty: ignore[incompatible-method-override]
        """Simplify the function to zero on an axis on which it vanishes."""
        if not (k.is_Integer and 1 <= k <= 4 and r.is_Integer and r >= 0):
            raise ValueError(f"{cls.__name__}: k = 1, 2, 3 or 4 and whole r >= 0 expected")
        if y.is_zero and not cls._real_part:
            return S.Zero
        if x.is_zero:
            is_imaginary = (int(k == 1) + int(r)) % 2 == 1
            if is_imaginary == cls._real_part:
                return S.Zero
        return None

    def fdiff(self, argindex: int = 1) -> Any:
        """Return the derivative with respect to x, y or q.

        argindex: 2, 3 or 4.
        """
        k, x, y, q, r = self._values()
        if argindex == 2:
            return type(self)(k, x, y, q, r + 1)
        if argindex == 3:
            return (
                theta_re(k, x, y, q, r + 1) if not self._real_part else -theta_im(k, x, y, q, r + 1)
            )
        if argindex == 4:
            return -type(self)(k, x, y, q, r + 2) / (4 * q)
        raise ArgumentIndexError(self, argindex)

    def _over_mpmath(self, *values: Any) -> Any:
        return MPMATH[type(self).__name__](*values)

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        _, x, y, _, order = self._values()
        k, q, r = (printer._print(self.args[place]) for place in (0, 3, 4))
        z = printer._print(x + S.ImaginaryUnit * y)
        part = "Re" if self._real_part else "Im"
        primes = "" if order == 0 else rf"^{{\left({r}\right)}}"
        text = rf"\operatorname{{{part}}} \theta_{{{k}}}{primes}\left({z} \mid {q}\right)"
        return text if exp is None else rf"\left({text}\right)^{{{exp}}}"


class theta_re(_Part):  # noqa: N801 - SymPy's functions are lower case
    """The real part of the r-th derivative of theta_k(x + i y | q)."""

    _real_part = True


class theta_im(_Part):  # noqa: N801
    """The imaginary part of the r-th derivative of theta_k(x + i y | q)."""

    _real_part = False


def _mp_theta(k: Any, x: Any, y: Any, q: Any, r: Any) -> Any:
    if any(mp.im(value) for value in (x, y, q)):
        raise ValueError("theta: real x, y and q expected")
    k, x, y, q, r = int(k), mp.re(x), mp.re(y), mp.re(q), int(r)
    with mp.extraprec(64 + (max(0, int(mp.mag(x))) if x else 0)):
        return mp.jtheta(k, mp.mpc(x, y), q, r)


def _np_theta(k: Any, x: Any, y: Any, q: Any, r: Any) -> Any:
    """Return the r-th derivative of a theta function by its series in q (DLMF 20.2(i))."""
    z = np.asarray(x, dtype=float) + 1j * np.asarray(y, dtype=float)
    q, r = np.asarray(q, dtype=float), int(r)
    total = np.zeros(np.broadcast(z, q).shape, dtype=complex)
    if k in (3, 4) and r == 0:
        total = total + 1
    for j in range(_TERMS):
        n = j + 1 if k in (3, 4) else j + 0.5
        sign = (-1) ** (j + 1) if k == 4 else (-1) ** j if k == 1 else 1
        phase = 2 * n * z + r * np.pi / 2
        wave = np.sin(phase) if k == 1 else np.cos(phase)
        total = total + 2 * sign * q ** (n * n) * (2 * n) ** r * wave
    return total


NUMPY = {
    "theta_re": lambda *arguments: np.real(_np_theta(*arguments))[()],
    "theta_im": lambda *arguments: np.imag(_np_theta(*arguments))[()],
}
"""Over NumPy arrays of real x and y and q <= 0.97; errors are some 1e-15 of the largest term."""

MPMATH = {
    "theta_re": lambda *arguments: mp.re(_mp_theta(*arguments)),
    "theta_im": lambda *arguments: mp.im(_mp_theta(*arguments)),
}
"""Over mpmath numbers, at the working precision."""
