"""States by the paper's Theorem 1, with one step of it corrected.

The corrected step is that to y*.  Complex numbers are used.

Rates are zeta sn(xi t + C | mu).  About the two axes that the rates do not circulate about, zeta^2
is the root of (13) with the moment of the circulation axis, and all is real.  About that axis
itself no choice is real: u = xi t + C runs up and down beside K(mu), where

    sn(+-K + i y | mu) = +-1/dn(y | mu'),    mu' = 1 - mu,
    Pi(n; u) - Pi(n; +-K) = i (y + n/(1 - n) Pi(mu'/(1 - n); y | mu'))

(DLMF 22.4(iii), 22.6(iv)).  (18) with every S_i = 1 changes its sign wherever phi3 passes pi: there
Omega2 = 0 > Omega3, and those times are counted.
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from rigidsym._inputs import certain
from rigidsym.errors import InputError
from rigidsym.precise._evaluation import Request, exactly
from rigidsym.precise._floating import CTX, Floating, Point, quarter_period
from rigidsym.precise._regime import MotionInputs
from rigidsym.solution._formulas import sequence
from rigidsym.solution._polhode import check_sines, sine_axes, sine_sign

_SERVE = "theta and mpmath serve"
# Axes 1, 2, 3 by the names of the pull-back, which is for axes of either handedness.
_ABD = ("0", "a", "b", "d")


@dataclass(frozen=True, slots=True)
class _Amplitude:
    """The amplitude am(u), represented by its argument u.

    Formulas only need Pi of it, which has no branches in u.
    """

    u: Point


class _Lines(Floating):
    """Elliptic functions of Theorem 1, on the real line and on complex lines through +-K(mu)."""

    def table(self) -> dict[str, Any]:
        """Return the table of functions by the names that formulas use."""
        return {
            **super().table(),
            "jacobi_sn": self.sn,
            "arcsn": _arcsn,
            "jacobi_am": lambda u, mc: _Amplitude(u),
            "elliptic_pi": lambda n, am, mc: self.third_kind(n, am.u, mc),
        }

    def sn(self, u: Point, mc: Point) -> Point:
        """Compute Jacobi's function sn(u | 1 - mc)."""
        if CTX.im(u) == 0:
            return self._kept("sn", self._real, CTX.re(u), mc)[0]
        return CTX.sign(CTX.re(u)) / self._kept("dn", self._real, CTX.im(u), 1 - mc)[2]

    def third_kind(self, n: Point, u: Point, mc: Point) -> Point:
        """Compute the integral of the third kind Pi(n; am(u) | 1 - mc).

        On the lines across the real line, Pi at +-K is subtracted.
        """
        if CTX.im(u) == 0:
            return self._real_third_kind(n, CTX.re(u), mc)
        y = CTX.im(u)
        part = self._real_third_kind(mc / (1 - n), y, 1 - mc)
        return CTX.mpc(0, y + n / (1 - n) * part)

    def _real(self, u: Point, mc: Point) -> tuple[Point, Point, Point]:
        """Compute Jacobi's sn, cn and dn of a real argument, also for m < 0."""
        turns, v = self._reduced(u, mc)
        m, flip = CTX.fsub(1, mc, exact=True), -1 if turns % 2 else 1
        s, c, d = (CTX.re(CTX.ellipfun(kind, v, m=m)) for kind in ("sn", "cn", "dn"))
        return flip * s, flip * c, d

    def _real_third_kind(self, n: Point, u: Point, mc: Point) -> Point:
        """Compute the integral of the third kind Pi of a real argument.

        R_J (DLMF 19.25.14) gives it within half a period of sn.  For each half period, twice the
        complete integral is added.
        """
        turns, v = self._reduced(u, mc)
        s, c, d = self._real(v, mc)
        part = v + n * s**3 * CTX.elliprj(c * c, d * d, 1, 1 - n * s * s) / 3
        return part + 2 * turns * self._kept("complete", _complete, n, mc) if turns else part


def _complete(n: Point, mc: Point) -> Point:
    """Compute the complete elliptic integral Pi(n | 1 - mc)."""
    return quarter_period(mc) + n * CTX.elliprj(0, mc, 1, 1 - n) / 3


def _arcsn(s: Point, mc: Point) -> Point:
    """Compute the inverse of Jacobi's function sn.

    u with sn(u | 1 - mc) = s is real for |s| <= 1; beyond it is +-(K + i y) with 0 <= y <= K'.
    """
    s = CTX.re(s)
    if abs(s) <= 1:
        return s * CTX.elliprf(1 - s * s, 1 - (1 - mc) * s * s, 1)
    square = min((1 - 1 / (s * s)) / mc, CTX.one)
    y = CTX.sqrt(square) * CTX.elliprf(1 - square, 1 - mc * square, 1)
    return CTX.sign(s) * CTX.mpc(quarter_period(mc), y)


def _number(value: Any) -> Any:
    return value if isinstance(value, _Amplitude) else CTX.convert(value)


class Theorem1:
    """The evaluation of one motion by Theorem 1 at the working precision.

    Raises InputError where the theorem does not hold.
    """

    def __init__(self, given: MotionInputs) -> None:
        self.inertia = certain("inertia", given.inertia)
        self.omega0 = certain("omega0", given.omega0)
        self.polhode, self.functions = given.polhode, _Lines().table()
        check_sines("method", "'theorem1'", self.polhode.regime, self.omega0, _SERVE)
        quaternion = [CTX.convert(x) for x in given.attitude0]
        norm = CTX.norm(quaternion)
        self.start = [x / norm for x in quaternion], [CTX.convert(x) for x in self.omega0]

    def numbers(self, request: Request) -> list[Point]:
        """Return the seven numbers of the requested state."""
        if not isinstance(request, Fraction):
            lacking = "constants of the regular form" if isinstance(request, tuple) else "changes"
            raise InputError("method", "'theorem1'", f"has no {lacking}")
        return [*chain(*self.state(request))]

    def state(self, time: Fraction) -> tuple[list[Point], list[Point]]:
        """Return attitude and rates at one time.

        At t = 0, it is the given state itself.
        """
        if time == 0:
            return self.start
        t = CTX.convert(time)
        sine = sequence("sine_state")
        found = (sine.evaluate({**known, "t": t}, self.functions) for known in self._sines)
        rates = [CTX.re(rate["Omega_i"]) for rate in found]
        known = {**self._front, **self._by_angles(t, rates), "epsilon": 1}
        turned = sequence("turned").evaluate(known, self.functions)
        sign = -1 if self._flips(t) % 2 else 1
        return [sign * turned[f"q_{x}"] for x in _ABD], rates

    @cached_property
    def _sines(self) -> list[dict[str, Any]]:
        """The constants in the sine function zeta sn(xi t + C | mu) of each body rate."""
        return [self._sine(i) for i in range(3)]

    def _sine(self, i: int) -> dict[str, Any]:
        known: dict[str, Any] = {"half": sine_sign(self.inertia, self.omega0, i)}
        for x, n in zip("ijk", (i, *sine_axes(self.polhode, i)), strict=True):
            known |= {f"c_{x}": self.inertia[n], f"Omega_{x}": self.omega0[n]}
        found = exactly(sequence("sine"), known, self.functions, _number)
        return {name: _number(found[name]) for name in ("zeta", "xi", "mu", "C_i")}

    @cached_property
    def _constants(self) -> dict[str, Any]:
        """The constants in Theorem 1's formula of the angle phi1."""
        known: dict[str, Any] = {f"c{k + 1}": x for k, x in enumerate(self.inertia)}
        known |= {f"Omega{k + 1}": x for k, x in enumerate(self.omega0)}
        sine = self._sines[0]
        known |= {"C_1": sine["C_i"], **{name: sine[name] for name in ("zeta", "xi", "mu")}}
        found = exactly(sequence("theorem1"), known, self.functions, _number)
        return {name: _number(value) for name, value in found.items()}

    def _by_angles(self, t: Point, rates: list[Point]) -> dict[str, Any]:
        """Evaluate the quaternion of the paper's (18), with axes 1, 2, 3 named a, b, d."""
        known = {f"Omega{k + 1}": x for k, x in enumerate(rates)}
        known |= {"side": -1 if rates[2] < 0 else 1, "t": t}
        formulas = sequence("theorem1_state")
        found = formulas.evaluate({**self._constants, **known}, self.functions)
        return {f"qbar_{x}": CTX.re(found[f"qbar_{k}"]) for k, x in enumerate(_ABD)}

    @cached_property
    def _front(self) -> dict[str, Any]:
        """The constant quaternion of the paper's equation (37)."""
        begin = self._by_angles(CTX.zero, self.start[1])
        given = {f"q_{x}": value for x, value in zip(_ABD, self.start[0], strict=True)}
        found = sequence("pull_back").evaluate({**begin, **given, "epsilon": 1}, self.functions)
        return {name: found[name] for name in (f"p_{x}" for x in _ABD)}

    def _flips(self, t: Point) -> int:
        """Count the sign flips of the quaternion: zeros of Omega2 at which Omega3 is negative.

        They are at arguments 2 n K.
        """
        (a, *_), c, w, sine = self.polhode.axes, self.inertia, self.omega0, self._sines[1]
        if a == 1:
            return 0
        period = 2 * quarter_period(1 - sine["mu"])
        ends = (sine["C_i"] / period, (sine["xi"] * t + sine["C_i"]) / period)
        low, high = sorted(int(CTX.floor(end)) for end in ends)
        if a == 2:
            return high - low if w[2] < 0 else 0
        # Omega2' = zeta xi (-1)^n has the sign of (c3 - c1) Omega3 Omega1.
        rising = sine["xi"] * CTX.convert((c[2] - c[0]) * w[0])
        return len(range(low + 1 + (low + 1 + (rising > 0)) % 2, high + 1, 2))
