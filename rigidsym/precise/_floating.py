"""States by mpmath's functions, each computed twice to estimate its error.

Between the edges, the first computation uses the form with the integral of the third kind and the
second the theta form: they share the functions sn, cn and dn and nothing else.  On the edges, the
second is the first at a higher precision.  A ball here is a number with an estimated error: nothing
proves it.

Conventions are those of `functions`: m is the parameter k^2, functions take mc = 1 - m as their
last argument.  The context is this module's own, so that mpmath's global precision stays as it is.
mpmath keeps constants in memory, which threads must not write at the same time: computations here
must hold the lock of `balls.working`.
"""

from collections.abc import Callable
from typing import Any

from flint import arb
from mpmath import mpf
from mpmath.ctx_mp import MPContext

from rigidsym.precise._balls import of_mpf
from rigidsym.precise._evaluation import Evaluation, Request
from rigidsym.precise._regime import MotionInputs

# A number of the context below, which makes its types mpf and mpc at run time.
Point = Any
CTX = MPContext()
# The bits of the second computation beyond those of the first.
MORE_BITS = 64


class Floating:
    """The mpmath functions that formulas need, with a cache of the last values."""

    def __init__(self) -> None:
        self._last: dict[str, tuple[tuple[Point, ...], Any]] = {}

    def table(self) -> dict[str, Any]:
        """Return the table of functions by the names that formulas use."""
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
        """Return the table of functions, extended by the functions of the theta form."""
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

    def _nome(self, mc: Point) -> Point:
        return self._kept("nome", nome, mc)

    def _jacobi(self, u: Point, mc: Point) -> tuple[Point, Point, Point]:
        return self._kept("jacobi", self.jacobi, u, mc)

    def jacobi(self, u: Point, mc: Point) -> tuple[Point, Point, Point]:
        """Return Jacobi's sn, cn and dn of (u | 1 - mc) for real u.

        They are elementary at mc = 0 and mc = 1.
        """
        if mc == 0:
            return CTX.tanh(u), CTX.sech(u), CTX.sech(u)
        if mc == 1:
            return CTX.sin(u), CTX.cos(u), CTX.one
        turns, v = self._reduced(u, mc)
        q, flip = self._nome(mc), -1 if turns % 2 else 1
        s, c, d = (CTX.re(CTX.ellipfun(kind, v, q=q)) for kind in ("sn", "cn", "dn"))
        return flip * s, flip * c, d

    def elliptic_j(self, u: Point, n: Point, mc: Point) -> Point:
        """Compute the integral of sn^2/(1 - n sn^2) from 0 to u by R_J (DLMF 19.25.14).

        -1 < n <= 0.
        """
        if mc == 0:
            root = CTX.sqrt(-n)
            return (u - CTX.atan(root * CTX.tanh(u)) / root) / (1 - n)
        if mc == 1:
            return (u - CTX.sin(u) * CTX.cos(u)) / 2  # n = 0
        turns, _ = self._reduced(u, mc)
        flip = -1 if turns % 2 else 1
        s, c, d = self._jacobi(u, mc)
        part = flip * s**3 * CTX.elliprj(c * c, d * d, 1, 1 - n * s * s) / 3
        if not turns:
            return part
        whole = self._kept("whole", lambda n, mc: CTX.elliprj(0, mc, 1, 1 - n) / 3, n, mc)
        return 2 * int(turns) * whole + part

    def _reduced(self, u: Point, mc: Point) -> tuple[int, Point]:
        """Reduce an argument to u = 2 K turns + rest with |rest| <= K.

        Return turns and rest.
        """
        quarter = self._kept("quarter", quarter_period, mc)
        turns = int(CTX.nint(u / (2 * quarter)))
        return turns, u - 2 * turns * quarter


def quarter_period(mc: Point) -> Point:
    """Compute the complete elliptic integral K(m) by the AGM (DLMF 19.8.5).

    K(m) = pi/(2 agm(1, sqrt(mc))).
    """
    return CTX.pi / (2 * CTX.agm(1, CTX.sqrt(mc)))


def nome(mc: Point) -> Point:
    """Compute the nome exp(-pi K'/K) of Jacobi's functions."""
    m = CTX.fsub(1, mc, exact=True)
    return CTX.exp(-CTX.pi * CTX.agm(1, CTX.sqrt(mc)) / CTX.agm(1, CTX.sqrt(m)))


def argument(sn: Point, cn: Point, dn: Point) -> Point:
    """Compute the argument u from sn, cn and dn (DLMF 19.25.5).

    cn >= 0, and |u| <= K.
    """
    return sn * CTX.elliprf(cn * cn, dn * dn, 1)


def _arcsc(x: Point, mc: Point) -> Point:
    """Compute the inverse of Jacobi's function sc for x >= 0.

    This is the u >= 0 with sc(u | 1 - mc) = x, or F(arctan x).
    """
    square = 1 + x * x
    return x / CTX.sqrt(square) * CTX.elliprf(1 / square, (1 + mc * x * x) / square, 1)


# Computes states at CTX's precision: an Evaluation or a Theorem1.
Computation = Callable[[MotionInputs], Any]


def third_kind_form(given: MotionInputs) -> Evaluation[Any]:
    """Evaluate a motion by the form with the elliptic integral of the third kind."""
    return Evaluation(given, Floating().table(), CTX.convert)


def theta_form(given: MotionInputs) -> Evaluation[Any]:
    """Evaluate a motion by the theta form of the solution.

    The form with the integral of the third kind replaces it on the separatrix and for symmetric
    bodies.
    """
    return Evaluation(given, Floating().theta_table(), CTX.convert)


class Estimates:
    """One motion computed at two precisions, to estimate its errors.

    mpmath's functions compute it at the working precision and at a higher one.

    first, second: the computations at the lower and the higher precision.
    """

    quick_bits = 2**12

    def __init__(
        self, given: MotionInputs, bits: int, first: Computation, second: Computation
    ) -> None:
        self.bits = bits
        with CTX.workprec(bits):
            self._first = first(given)
        with CTX.workprec(bits + MORE_BITS):
            self._second = second(given)

    @property
    def start(self) -> tuple[list[mpf], list[mpf]]:
        """The attitude and the rates at t = 0."""
        return self._second.start

    def numbers(self, request: Request) -> list[arb]:
        """Return the requested numbers as balls with estimated radii.

        They are the seven of the state at a time, or constants.
        """
        try:
            with CTX.workprec(self.bits):
                first = self._first.numbers(request)
            with CTX.workprec(self.bits + MORE_BITS):
                second = self._second.numbers(request)
        except ZeroDivisionError:  # by a number that is too small for this precision
            return [arb.nan()] * (len(request) if isinstance(request, tuple) else 7)
        return [self._estimated(*pair) for pair in zip(first, second, strict=True)]

    def _estimated(self, first: mpf, second: mpf) -> arb:
        """Return the second of two approximations as a ball whose radius estimates its error.

        The radius is twice the difference of both values and a rounding of the first."""
        if not CTX.isfinite(first) or not CTX.isfinite(second):
            return arb.nan()
        value, other = of_mpf(second), of_mpf(first)
        return value + arb(0, (2 * (value - other)).abs_upper() + abs(value) * arb(2) ** -self.bits)
