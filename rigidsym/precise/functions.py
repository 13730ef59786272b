"""The special functions of the solution in one mpmath context, by complementary parameter.

Conventions: m is the parameter k^2; each function takes mc = 1 - m as its last argument.  J is
Fukushima's associate integral of the third kind in terms of u: the integral from 0 to u of
sn^2/(1 - n sn^2).
"""

from collections.abc import Callable
from typing import Any


class EllipticFunctions:
    """sn, cn, dn, J and the inverse of sn over one mpmath context `ctx`."""

    def __init__(self, ctx: Any) -> None:
        self.ctx = ctx
        self._reduced: dict[Any, Any] = {}

    def table(self) -> dict[str, Callable[..., Any]]:
        """The functions by the names that formulas use."""
        return {
            "sqrt": self.ctx.sqrt,
            "cos": self.ctx.cos,
            "sin": self.ctx.sin,
            "jacobi_sn": lambda u, mc: self.jacobi(u, mc)[0],
            "jacobi_cn": lambda u, mc: self.jacobi(u, mc)[1],
            "jacobi_dn": lambda u, mc: self.jacobi(u, mc)[2],
            "jacobi_argument": self.argument,
            "elliptic_j": self.elliptic_j,
        }

    def quarter_period(self, mc: Any) -> Any:
        """K(m) = pi / (2 agm(1, sqrt(mc))); needs mc > 0 (DLMF 19.8.5)."""
        return self.ctx.pi / (2 * self.ctx.agm(1, self.ctx.sqrt(mc)))

    def jacobi(self, u: Any, mc: Any) -> tuple[Any, Any, Any]:
        """sn, cn, dn of (u | 1 - mc); hyperbolic at mc = 0 (DLMF 22.5(ii))."""
        ctx = self.ctx
        if mc == 0:
            return ctx.tanh(u), ctx.sech(u), ctx.sech(u)
        if (u, mc) not in self._reduced:
            turns, v = self._reduce(u, mc)
            m = max(ctx.zero, 1 - mc)
            sn, cn, dn = (ctx.ellipfun(kind, v, m=m) for kind in ("sn", "cn", "dn"))
            sign = -1 if turns % 2 else 1
            self._reduced = {(u, mc): (sign * sn, sign * cn, dn)}
        return self._reduced[u, mc]

    def _reduce(self, u: Any, mc: Any) -> tuple[int, Any]:
        """u = 2 K k + v with |v| <= K."""
        period = 2 * self.quarter_period(mc)
        turns = int(self.ctx.nint(u / period))
        return turns, u - turns * period

    def argument(self, sn: Any, cn: Any, dn: Any) -> Any:
        """The u in [-K, K] with these sn, cn >= 0, dn (DLMF 19.25.5)."""
        return sn * self.ctx.elliprf(cn**2, dn**2, 1)

    def elliptic_j(self, u: Any, n: Any, mc: Any) -> Any:
        """J by Carlson's R_J (DLMF 19.25.14), whole periods added; needs -1 < n <= 0."""
        ctx = self.ctx
        sn, cn, dn = self.jacobi(u, mc)
        if mc == 0:
            root = ctx.sqrt(-n)
            return (u - ctx.atan(root * sn) / root) / (1 - n)
        turns, v = self._reduce(u, mc)
        part = abs(sn) ** 3 * ctx.elliprj(cn**2, dn**2, 1, 1 - n * sn**2) / 3
        whole = 2 * turns * ctx.elliprj(0, mc, 1, 1 - n) / 3 if turns else 0
        return whole + (part if v >= 0 else -part)
