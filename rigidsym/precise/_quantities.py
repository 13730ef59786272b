"""Energy, momentum, periods and other constants of a motion, in doubles.

The same quantities as expressions are in `motion.symbolic().quantities`.
"""

from dataclasses import dataclass
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from fractions import Fraction
from functools import cached_property
from math import atan2, inf, sqrt, tau

from rigidsym._inputs import decimal
from rigidsym.precise._motion import PreciseMotion
from rigidsym.solution._polhode import Regime

# Digits of each constant, so that results are right as doubles.
_DIGITS = 20
_CONTEXT = Context(prec=_DIGITS, Emax=MAX_EMAX, Emin=MIN_EMIN)
_AMPLITUDES = ("A_a", "A_b", "A_d", "k_c")


@dataclass(frozen=True)
class Quantities:
    """Energy, momentum, periods and other constants of a motion with exact inputs.

    Units are SI and radians.

    Raises InputError where a number is uncertain.
    """

    motion: PreciseMotion

    @cached_property
    def energy(self) -> float:
        """The kinetic energy H, in J."""
        inertia, rates, _ = self.motion.exact
        return float(sum(c * w * w for c, w in zip(inertia, rates, strict=True)) / 2)

    @cached_property
    def momentum(self) -> float:
        """The magnitude K of the angular momentum, in N m s."""
        inertia, rates, _ = self.motion.exact
        return _root(sum((c * w) ** 2 for c, w in zip(inertia, rates, strict=True)))

    @cached_property
    def parameter(self) -> float | None:
        """The parameter m of Jacobi's elliptic functions.

        None where the rates are constant.

        It is 0 for symmetric bodies, and 1 on the separatrix.
        """
        return None if self._steady else self._constant("m")

    @property
    def modulus(self) -> float | None:
        """The modulus k of Jacobi's elliptic functions, the square root of the parameter."""
        return None if self.parameter is None else sqrt(self.parameter)

    @cached_property
    def period(self) -> float | None:
        """The period 4 K(m)/lambda of the body rates, in s.

        It is infinite on the separatrix.

        None where the rates are constant.
        """
        if self._steady:
            return None
        return inf if self._separatrix else self._constant("period")

    @cached_property
    def precession_rate(self) -> float | None:
        """The mean rate of precession about the angular momentum, in rad/s.

        None on the separatrix.
        """
        if self._steady:
            return _root(sum(w * w for w in self.motion.exact[1]))
        if self._separatrix:
            return None
        # A symmetric body does not nod, and J_c is 0/0.
        symmetric = self.motion.polhode.regime == Regime.SYMMETRIC
        return self._constant("psi_0" if symmetric else "psi_mean")

    @cached_property
    def mean_rates(self) -> tuple[float, float, float]:
        """The body rates averaged over a period, in rad/s.

        On the separatrix, they are averaged over all times.

        Only the mean about the circulation axis differs from zero, unless all are constant.
        """
        if self._steady:
            first, second, third = map(float, self.motion.exact[1])
            return first, second, third
        symmetric = self.motion.polhode.regime == Regime.SYMMETRIC
        mean = 0.0 if self._separatrix else self._constant("A_a" if symmetric else "Omega_mean")
        sign = self.motion.polhode.sigma if symmetric else 1
        along = self.motion.polhode.axes[0]
        first, second, third = (sign * mean if k == along else 0.0 for k in range(3))
        return first, second, third

    @property
    def circulation_rate(self) -> float | None:
        """The mean rate of the momentum's circulation in the body, 2 pi/period, in rad/s.

        Zero on the separatrix, None where the rates are constant.
        """
        return None if self.period is None else tau / self.period

    @property
    def phase_per_period(self) -> float | None:
        """The angle of precession about the angular momentum in one period, in rad.

        It includes whole turns.  None without a period, and on the separatrix.
        """
        rate, period = self.precession_rate, self.period
        return None if rate is None or period is None else rate * period

    @cached_property
    def nutation(self) -> tuple[float, float]:
        """The smallest and the largest angle between the circulation axis and the momentum.

        Angles are in rad, from the nearer end of axis a.

        Of the rates A_a dn, A_b sn and A_d cn the first is largest where sn = 0, and smallest,
        k_c A_a, where sn is 1 or -1 (facts regular.dn, descended.k_c).  Both are zero where the
        rates are constant, and the largest is a right angle on the separatrix.
        """
        if self._steady:
            return 0.0, 0.0
        a, b, d = (float(self.motion.exact[0][k]) for k in self.motion.polhode.axes)
        found = self.motion.constants(_AMPLITUDES, _DIGITS)
        along, across, other, least = (float(found[name]) for name in _AMPLITUDES)
        return atan2(d * other, a * along), atan2(b * across, a * along * least)

    @property
    def _steady(self) -> bool:
        return self.motion.polhode.regime.steady

    @property
    def _separatrix(self) -> bool:
        return self.motion.polhode.regime == Regime.SEPARATRIX

    def _constant(self, name: str) -> float:
        return float(self.motion.constants([name], _DIGITS)[name])


def _root(square: Fraction | int) -> float:
    """Return the square root of a rational of any size as a double."""
    return float(_CONTEXT.sqrt(Decimal(decimal(Fraction(square), _DIGITS))))
