"""The motion by Fourier series in v, whose coefficients a plan finds, over NumPy arrays.

psi/2 is Lambda t and the angle of theta_4(v - i rho b | q^2).  The logarithm of that theta function
is a series in cosines of 2 n (v - i rho b), so that

    psi/2 = Lambda t - 2 rho sum q^(2n) sinh(2 n b)/(n (1 - q^(4n))) sin 2nv + constant

(DLMF 20.5.13, integrated), q being the nome of m; sn, cn and dn are series, too (DLMF 22.11).
Terms fall like q^n at least, which near the separatrix is hardly at all.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np

from rigidsym.language.sequence import FormulaSequence
from rigidsym.precise.motion import PreciseMotion
from rigidsym.solution import sealed

MOST = 1000
# What the first term left out is below, of the first of all.
_BITS = 55
_DIGITS = 40
_NAMES = ("k_1", "m", "K", "mu", "phase", "psi_0", "kappa", "n", "A_a", "A_b", "A_d")
_FRONT = ("p_0", "p_a", "p_b", "p_d")
_STATE = ("q_0", "q_a", "q_b", "q_d", "Omega_a", "Omega_b", "Omega_d")
# What a state is made of once sn, cn, dn and psi are known.
_GIVEN = {"u_1", "s", "c", "d", "sn", "cn", "dn", "J", "psi", "cos_half_psi", "sin_half_psi"}


@dataclass(frozen=True, slots=True)
class Fourier:
    """Rates in half turns as two doubles, coefficients of psi, sn, cn and dn, and constants."""

    v: tuple[float, float, float]
    psi: tuple[float, float, float]
    series: Sequence[np.ndarray]
    constants: dict[str, float]
    axes: tuple[int, int, int]

    @property
    def terms(self) -> int:
        """How many terms each of the four series has."""
        return len(self.series[0])

    def states(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(q, omega) at times t (N,): (N, 4) and (N, 3)."""
        v, half_psi = (np.pi * _reduced(t, *rate) for rate in (self.v, self.psi))
        rest, sn, cn, dn = self.series
        x, twice = np.cos(2 * v), np.sin(2 * v)
        odd, even = _summed(sn, x), _summed(cn, x)
        half_psi = half_psi + twice * _second_kind(rest, x)
        values = {
            "sn": np.sin(v) * (odd[0] + odd[1]),
            "cn": np.cos(v) * (even[0] - even[1]),
            "dn": _first_kind(dn, x),
            "cos_half_psi": np.cos(half_psi),
            "sin_half_psi": np.sin(half_psi),
        }
        found = _FORMULAS.evaluate({**self.constants, **values}, {"sqrt": np.sqrt, "power": pow})
        q, omega = np.empty((len(t), 4)), np.empty((len(t), 3))
        q[:, 0] = found["q_0"]
        for name, axis in zip("abd", self.axes, strict=True):
            q[:, 1 + axis], omega[:, axis] = found[f"q_{name}"], found[f"Omega_{name}"]
        return q, omega


_FORMULAS = FormulaSequence(
    (f.name, f.expression) for f in sealed().sequences["state"] if f.name not in _GIVEN
)


def plan(motion: PreciseMotion) -> Fourier | None:
    """The series of a moving body, as many terms as doubles tell; None beyond MOST of them."""
    with mpmath.workdps(_DIGITS):
        known = motion.constants((*_NAMES, *_FRONT), _DIGITS)
        nome = mpmath.qfrom(m=known["m"])
        falling = mpmath.inf if nome == 0 else -mpmath.log(nome)
        if falling * MOST < _BITS * mpmath.log(2):
            return None
        terms = 2 + int(mpmath.ceil(_BITS * mpmath.log(2) / falling))
        return _planned(motion, known, nome, terms)


def _planned(
    motion: PreciseMotion, known: dict[str, mpmath.mpf], nome: mpmath.mpf, terms: int
) -> Fourier:
    polhode = motion.polhode
    k_1, m, quarter = known["k_1"], known["m"], mpmath.ellipk(known["k_1"] ** 2)
    n, momentum = known["n"], known["K"]
    j = (mpmath.ellippi(n, k_1**2) / quarter - 1) / n if n else mpmath.mpf(1) / 2
    rate = (known["psi_0"] + known["kappa"] * known["mu"] * j) / 2
    inertia, _, _ = motion.exact
    moments = dict(zip("abd", (inertia[k] for k in polhode.axes), strict=True))
    amplitude_d = known["A_d"] * _number(moments["d"])
    x = amplitude_d / (mpmath.sqrt(k_1) * (momentum + known["A_a"] * _number(moments["a"])))
    shift = mpmath.pi * mpmath.ellipf(mpmath.atan(x), 1 - k_1**2) / (2 * quarter)
    v_0 = known["phase"] / (2 * quarter)
    series = _coefficients(nome, m, shift, polhode.rho, terms)
    start = sum(c * mpmath.sin(2 * k * mpmath.pi * v_0) for k, c in enumerate(series[0], 1))
    signs = {name: float(getattr(polhode, name)) for name in ("epsilon", "sigma", "chi")}
    constants = {name: float(known[name]) for name in ("K", "A_a", "A_b", "A_d", *_FRONT)}
    constants |= {f"c_{name}": float(moment) for name, moment in moments.items()}
    tau = -polhode.rho * signs["epsilon"] * signs["sigma"]
    return Fourier(
        (*_in_two(known["mu"] / (2 * quarter)), float(v_0)),
        (*_in_two(rate / mpmath.pi), float(-start / mpmath.pi)),
        [np.array([float(c) for c in row]) for row in series],
        constants | signs | {"tau": tau},
        polhode.axes,
    )


def _coefficients(
    q: mpmath.mpf, m: mpmath.mpf, b: mpmath.mpf, rho: int, terms: int
) -> list[list[mpmath.mpf]]:
    """Those of sin 2nv in psi/2, of sin and cos (2n+1)v in sn and cn, of cos 2nv in dn."""
    scale = 2 * mpmath.pi / mpmath.ellipk(m)
    modulus, root = mpmath.sqrt(m), mpmath.sqrt(q)
    count = range(1, terms + 1)
    rest = [
        -2 * rho * q ** (2 * n) * mpmath.sinh(2 * n * b) / (n * (1 - q ** (4 * n))) for n in count
    ]
    odd = [scale / modulus * root * q ** (n - 1) for n in count]
    sn = [a / (1 - q ** (2 * n - 1)) for n, a in zip(count, odd, strict=True)]
    cn = [a / (1 + q ** (2 * n - 1)) for n, a in zip(count, odd, strict=True)]
    dn = [scale / 4, *(scale * q**n / (1 + q ** (2 * n)) for n in count[:-1])]
    return [rest, sn, cn, dn]


def _number(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def _in_two(value: mpmath.mpf) -> tuple[float, float]:
    return float(value), float(value - float(value))


def _reduced(t: np.ndarray, hi: float, lo: float, start: float) -> np.ndarray:
    """(hi + lo) t + start less whole pairs of half turns; t hi by parts of 27 digits."""
    upper = 134217729.0 * t - (134217729.0 * t - t)
    upper_hi = 134217729.0 * hi - (134217729.0 * hi - hi)
    product = hi * t
    error = upper * upper_hi - product + upper * (hi - upper_hi) + (t - upper) * upper_hi
    error += (t - upper) * (hi - upper_hi)
    return (product - 2 * np.rint(product / 2)) + (error + lo * t + start)


def _clenshaw(coefficients: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The last two sums of Clenshaw's recurrence in x = cos 2v."""
    one, other = np.zeros_like(x), np.zeros_like(x)
    for coefficient in coefficients[::-1]:
        one, other = coefficient + 2 * x * one - other, one
    return one, other


def _first_kind(coefficients: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Sum of c_n cos 2nv."""
    one, other = _clenshaw(coefficients, x)
    return one - x * other


def _second_kind(coefficients: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Sum of c_n sin 2nv over sin 2v."""
    return _clenshaw(coefficients, x)[0]


def _summed(coefficients: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Sum of c_n sin (2n+1)v over sin v is the sum of both, of cosines the difference."""
    return _clenshaw(coefficients, x)
