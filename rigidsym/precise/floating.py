"""The functions of formulas by mpmath's own: ellipfun, elliprf, elliprj, jtheta and the AGM.

Conventions are those of `amplitude`: m is the parameter k^2, functions take mc = 1 - m as their
last argument.  Numbers are points, without radii.  Their context is this module's own, so that
nobody's precision is changed; mpmath keeps constants in memory that threads must not fill at once,
so whoever computes here holds the lock of `balls.working`.
"""

from collections.abc import Callable
from typing import Any

from mpmath.ctx_mp import MPContext

# Of mpmath's numbers: mpf and mpc of the context below, whose types it makes as it runs.
Point = Any
CTX = MPContext()


class Floating:
    """The table of functions at one precision; what was evaluated last is kept."""

    def __init__(self) -> None:
        self._last: dict[str, tuple[tuple[Point, ...], Any]] = {}

    def table(self) -> dict[str, Any]:
        """The functions and constants by the names that formulas use."""
        return {
            "power": lambda x, exponent: x**exponent,
            "sqrt": CTX.sqrt,
            "cos": CTX.cos,
            "sin": CTX.sin,
            "jacobi_sn": lambda u, mc: self._jacobi(u, mc)[0],
            "jacobi_cn": lambda u, mc: self._jacobi(u, mc)[1],
            "jacobi_dn": lambda u, mc: self._jacobi(u, mc)[2],
            "jacobi_argument": argument,
            "elliptic_j": self.elliptic_j,
        }

    def theta_table(self) -> dict[str, Any]:
        """The same with those of the theta form."""
        return {
            **self.table(),
            "pi": +CTX.pi,
            "I": CTX.j,
            "re": CTX.re,
            "im": CTX.im,
            "elliptic_k": quarter_period,
            "nome": self._nome,
            "arcsc": _arcsc,
            "theta4": lambda z, q: self._kept("theta4", lambda z, q: CTX.jtheta(4, z, q), z, q),
            "dtheta4": lambda z, q: CTX.jtheta(4, z, q, 1),
        }

    def _kept(self, name: str, function: Callable[..., Any], *arguments: Point) -> Any:
        kept = self._last.get(name)
        if kept is None or kept[0] != arguments:
            self._last[name] = kept = (arguments, function(*arguments))
        return kept[1]

    def _quarter(self, mc: Point) -> Point:
        return self._kept("quarter", quarter_period, mc)

    def _nome(self, mc: Point) -> Point:
        return self._kept("nome", nome, mc)

    def _jacobi(self, u: Point, mc: Point) -> tuple[Point, Point, Point]:
        return self._kept("jacobi", self.jacobi, u, mc)

    def jacobi(self, u: Point, mc: Point) -> tuple[Point, Point, Point]:
        """sn, cn, dn of (u | 1 - mc) for real u; hyperbolic at mc = 0 and circular at mc = 1."""
        if mc == 0:
            return CTX.tanh(u), CTX.sech(u), CTX.sech(u)
        if mc == 1:
            return CTX.sin(u), CTX.cos(u), CTX.one
        turns, v = self._reduced(u, mc)
        q, flip = self._nome(mc), -1 if turns % 2 else 1
        s, c, d = (CTX.re(CTX.ellipfun(kind, v, q=q)) for kind in ("sn", "cn", "dn"))
        return flip * s, flip * c, d

    def elliptic_j(self, u: Point, n: Point, mc: Point) -> Point:
        """The integral of sn^2/(1 - n sn^2) from 0 to u, by R_J (DLMF 19.25.14); -1 < n <= 0."""
        if mc == 0:
            root = CTX.sqrt(-n)
            return (u - CTX.atan(root * CTX.tanh(u)) / root) / (1 - n)
        if mc == 1:
            return (u - CTX.sin(u) * CTX.cos(u)) / 2  # n = 0
        turns, _ = self._reduced(u, mc)
        flip = -1 if turns % 2 else 1
        s, c, d = self._jacobi(u, mc)
        part = flip * s**3 * CTX.elliprj(c * c, d * d, 1, 1 - n * s * s) / 3
        return 2 * int(turns) * self._kept("whole", _complete_j, n, mc) + part if turns else part

    def _reduced(self, u: Point, mc: Point) -> tuple[int, Point]:
        """Turns and rest of u = 2 K turns + rest, |rest| <= K."""
        quarter = self._quarter(mc)
        turns = int(CTX.nint(u / (2 * quarter)))
        return turns, u - 2 * turns * quarter


def quarter_period(mc: Point) -> Point:
    """K(m) = pi/(2 agm(1, sqrt(mc))) (DLMF 19.8.5)."""
    return CTX.pi / (2 * CTX.agm(1, CTX.sqrt(mc)))


def nome(mc: Point) -> Point:
    """exp(-pi K'/K)."""
    m = CTX.fsub(1, mc, exact=True)
    return CTX.exp(-CTX.pi * CTX.agm(1, CTX.sqrt(mc)) / CTX.agm(1, CTX.sqrt(m)))


def argument(sn: Point, cn: Point, dn: Point) -> Point:
    """The u with these sn, cn >= 0, dn and |u| <= K (DLMF 19.25.5)."""
    return sn * CTX.elliprf(cn * cn, dn * dn, 1)


def _complete_j(n: Point, mc: Point) -> Point:
    """J(K) = R_J(0, mc, 1, 1 - n)/3."""
    return CTX.elliprj(0, mc, 1, 1 - n) / 3


def _arcsc(x: Point, mc: Point) -> Point:
    """The u >= 0 with sc(u | 1 - mc) = x >= 0: F(arctan x)."""
    square = 1 + x * x
    return x / CTX.sqrt(square) * CTX.elliprf(1 / square, (1 + mc * x * x) / square, 1)
