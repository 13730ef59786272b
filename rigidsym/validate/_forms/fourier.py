"""Computation of states by Fourier series in NumPy.

sn, cn and dn are multiples of series with the ledger's coefficients a(k), q being the nome of m.
The factors follow from values that are 1: sn a quarter period after u = 0, cn and dn at u = 0.
psi/2 is Lambda t and a series of the ledger's terms in q^2, the imaginary part of the logarithm of
theta_4(v - i rho b | q^2).  Terms fall like q^k at least, which near the separatrix is hardly at
all.  The state is the ledger's, printed by codegen.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath
import numpy as np

from rigidsym._codegen.functions import fourier
from rigidsym._codegen.targets.numpy import emit
from rigidsym.errors import InputError
from rigidsym.generated import torque_free
from rigidsym.precise._motion import PreciseMotion
from rigidsym.solution import sealed
from rigidsym.solution._formulas import AXES, sequence
from rigidsym.solution._polhode import Regime
from rigidsym.validate.strata._sample import fractions

MOST = 1000
# The first term left out is below 2^-55 of the first of all.
_BITS = 55
_DIGITS = 40
_FROM_START = {"K", "A_a", "A_b", "A_d", "p_0", "p_a", "p_b", "p_d"}
_OF_SHIFT = ("beta", "g", "nome_1")
_POWER = {"power": pow}
# The limit of small nomes, in symmetric bodies and beside spins: one harmonic of each.
_LIMIT = [[mpmath.mpf(0)], *([mpmath.mpf(1)] for _ in range(3))]


@dataclass(frozen=True, slots=True)
class Fourier:
    """Fourier series of one motion, prepared for evaluation."""

    v: tuple[float, float, float]
    psi: tuple[float, float, float]
    series: Sequence[np.ndarray]
    constants: dict[str, float]
    axes: tuple[int, int, int]

    @property
    def terms(self) -> int:
        """The number of terms of each Fourier series."""
        return len(self.series[0])

    def states(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Evaluate the Fourier series, and return the states at times.

        These are q (N, 4) and omega (N, 3) at t (N,).
        """
        v, half_psi = (np.pi * _reduced(t, *rate) for rate in (self.v, self.psi))
        rest, sn, cn, dn = self.series
        x, twice = np.cos(2 * v), np.sin(2 * v)
        odd, even = _clenshaw(sn, x), _clenshaw(cn, x)
        half_psi = half_psi + twice * _clenshaw(rest, x)[0]
        last, before = _clenshaw(dn, x)
        q_0, q_a, q_b, q_d, *rates = state()(
            sn=np.sin(v) * (odd[0] + odd[1]),
            cn=np.cos(v) * (even[0] - even[1]),
            dn=last - x * before,
            cos_half_psi=np.cos(half_psi),
            sin_half_psi=np.sin(half_psi),
            **self.constants,
        )
        q, omega = np.empty((len(t), 4)), np.empty((len(t), 3))
        q[:, 0] = q_0
        for part, rate, axis in zip((q_a, q_b, q_d), rates, self.axes, strict=True):
            q[:, 1 + axis], omega[:, axis] = part, rate
        return q, omega


class Series:
    """Engine that computes states by Fourier series.

    It refuses motions that need more than MOST terms.
    """

    def prepare(self, inertia: Any, omega0: Any, attitude0: Any) -> Fourier:
        """Compute the Fourier series of a motion from its inputs.

        These are exact numbers or float64.
        """
        exact = fractions(inertia), fractions(omega0), fractions(attitude0)
        series = plan(PreciseMotion(*exact))
        if series is None:
            raise InputError("terms", f"more than {MOST}", "Fourier series do not serve here")
        return series

    prepare_exactly = prepare

    def states(self, prepared: Fourier, t: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return the states of a prepared motion at times."""
        return prepared.states(t)


@cache
def state() -> Callable[..., tuple[np.ndarray, ...]]:
    """Generate, from the derived formulas, the function that turns Fourier sums into states."""
    function = fourier.state(sealed())
    namespace: dict[str, Any] = dict(vars(torque_free))
    exec("\n".join(emit.function_lines(function).text), namespace)
    return namespace[function.name]


def plan(motion: PreciseMotion) -> Fourier | None:
    """Compute the Fourier series of a motion with enough terms for double precision.

    Returns None for more than MOST terms, and where rates are constant or not periodic.
    """
    if motion.polhode.regime.steady or motion.polhode.regime == Regime.SEPARATRIX:
        return None
    with mpmath.workdps(_DIGITS):
        symmetric = motion.polhode.regime == Regime.SYMMETRIC
        rates = ("psi_0",) if symmetric else ("period", "psi_mean")
        shift = sequence("theta").up_to(frozenset(_OF_SHIFT)).used & {"A_a", "A_d"}
        wanted = sorted({*_FROM_START, "mu", "phase", "k_1", "m_c"} | shift)
        known = motion.constants((*wanted, *rates), _DIGITS)
        if symmetric:
            v, psi, series = known["mu"] / mpmath.pi, known["psi_0"], _LIMIT
        else:
            v, psi, series = 2 / known["period"], known["psi_mean"], _series(motion, known)
        return _made(motion, known, (v, psi / (2 * mpmath.pi)), series) if series else None


def _series(motion: PreciseMotion, known: dict[str, mpmath.mpf]) -> list[list[mpmath.mpf]] | None:
    """Return the coefficients of a motion's Fourier series.

    Returns None if they need more than MOST terms.
    """
    if known["m_c"] == 1:
        return _LIMIT
    formulas = sequence("theta").up_to(frozenset(_OF_SHIFT))
    found = formulas.evaluate({**known, **_moments(motion)}, _FUNCTIONS)
    nome = mpmath.sqrt(found["nome_1"])
    terms = 2 + int(mpmath.ceil(-_BITS * mpmath.log(2) / mpmath.log(nome)))
    if terms > MOST:
        return None
    return _coefficients(nome, found["g"] * found["beta"], motion.polhode.rho, terms)


def _quarter_period(mc: mpmath.mpf) -> mpmath.mpf:
    """Return the quarter period K(m) of the Jacobi elliptic functions.

    It is pi/(2 agm(1, sqrt(mc))) (DLMF 19.8.5), with mc = 1 - m.
    """
    return mpmath.pi / (2 * mpmath.agm(1, mpmath.sqrt(mc)))


# Functions take mc = 1 - m, as those of `rigidsym.precise` do.
_FUNCTIONS = {
    "pi": mpmath.pi,
    "sqrt": mpmath.sqrt,
    "elliptic_k": _quarter_period,
    "nome": lambda mc: mpmath.exp(-mpmath.pi * _quarter_period(1 - mc) / _quarter_period(mc)),
    "arcsc": lambda x, mc: mpmath.ellipf(mpmath.atan(x), 1 - mc),
    **_POWER,
}


def _moments(motion: PreciseMotion) -> dict[str, mpmath.mpf]:
    inertia, axes = motion.exact[0], motion.polhode.axes
    exact = {f"c_{x}": inertia[k] for x, k in zip(AXES, axes, strict=True)}
    return {name: mpmath.mpf(x.numerator) / x.denominator for name, x in exact.items()}


def _made(
    motion: PreciseMotion,
    known: dict[str, mpmath.mpf],
    rates: tuple[mpmath.mpf, mpmath.mpf],
    series: list[list[mpmath.mpf]],
) -> Fourier:
    """Assemble prepared Fourier series from their coefficients and rates.

    rates: those of v and psi/2, in half turns.
    """
    polhode, (v, half_psi) = motion.polhode, rates
    v_0 = known["phase"] * v / known["mu"]
    start = sum(c * mpmath.sin(2 * k * mpmath.pi * v_0) for k, c in enumerate(series[0], 1))
    signs = {name: float(getattr(polhode, name)) for name in ("epsilon", "sigma", "chi")}
    values = {name: known[name] for name in _FROM_START} | _moments(motion)
    tau = -polhode.rho * signs["epsilon"] * signs["sigma"]
    return Fourier(
        (float(v), float(v - float(v)), float(v_0)),
        (float(half_psi), float(half_psi - float(half_psi)), float(-start / mpmath.pi)),
        [np.array([float(c) for c in row]) for row in series],
        {name: float(value) for name, value in values.items()} | signs | {"tau": tau},
        polhode.axes,
    )


def _coefficients(q: mpmath.mpf, b: mpmath.mpf, rho: int, terms: int) -> list[list[mpmath.mpf]]:
    """Return the Fourier coefficients of psi/2, sn, cn and dn."""
    whole = [mpmath.mpf(k) for k in range(1, terms + 1)]
    halves = [k - mpmath.mpf(1) / 2 for k in whole]
    rest = [
        {"x": q ** (2 * k), "rho": rho, "sinh_b": mpmath.sinh(2 * k * b), "k": k} for k in whole
    ]
    sn = [_coefficient(1, q**k) for k in halves]
    cn = [_coefficient(-1, q**k) for k in halves]
    dn = [_coefficient(-1, q**0), *(2 * _coefficient(-1, q**k) for k in whole[:-1])]
    quarter = sum(c * (-1) ** k for k, c in enumerate(sn))
    return [
        [sequence("fourier_rest").evaluate(x, _POWER)["rest_k"] for x in rest],
        [c / quarter for c in sn],
        [c / sum(cn) for c in cn],
        [c / sum(dn) for c in dn],
    ]


def _coefficient(e: int, x: mpmath.mpf) -> mpmath.mpf:
    return sequence("fourier").evaluate({"e": e, "x": x}, _POWER)["a"]


def _reduced(t: np.ndarray, hi: float, lo: float, start: float) -> np.ndarray:
    """Compute an angle (hi + lo) t + start, reduced to one turn.

    The product of t and hi is exact.
    """
    upper = 134217729.0 * t - (134217729.0 * t - t)
    upper_hi = 134217729.0 * hi - (134217729.0 * hi - hi)
    product = hi * t
    error = upper * upper_hi - product + upper * (hi - upper_hi) + (t - upper) * upper_hi
    error += (t - upper) * (hi - upper_hi)
    return (product - 2 * np.rint(product / 2)) + (error + lo * t + start)


def _clenshaw(coefficients: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the last two sums of Clenshaw's recurrence for Fourier series.

    They are b_0 and b_1, for x = cos 2v.  The sum of c_k cos 2kv is b_0 - x b_1, that of c_k sin
    (2k + 2)v over sin 2v is b_0, and those of c_k sin and cos (2k + 1)v over sin v and cos v are
    b_0 + b_1 and b_0 - b_1.
    """
    one, other = np.zeros_like(x), np.zeros_like(x)
    for coefficient in coefficients[::-1]:
        one, other = coefficient + 2 * x * one - other, one
    return one, other
