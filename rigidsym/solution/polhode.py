"""Which kind of motion it is, decided exactly from exact inputs."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from itertools import combinations

from rigidsym.solution.formulas import sequence

_DISCRIMINANT = frozenset({"E_b"})


class Regime(StrEnum):
    """The family a motion belongs to; every motion is in exactly one.

    The first three have constant rates, the last four move.
    """

    REST = "rest"
    SPHERICAL = "spherical"
    SPIN = "spin"
    SYMMETRIC = "symmetric"
    SEPARATRIX = "separatrix"
    LARGEST = "circulation about the axis of largest inertia"
    SMALLEST = "circulation about the axis of smallest inertia"

    @property
    def steady(self) -> bool:
        """True where the rates are constant, and the attitude one exponential."""
        return self in (Regime.REST, Regime.SPHERICAL, Regime.SPIN)


@dataclass(frozen=True, slots=True)
class Polhode:
    """The regime, and the axes by what they do.

    `axes` are the indices (0, 1, 2) of the circulation axis a, the middle axis b and the third d;
    `epsilon` is +1 when they are right-handed, `sigma` the sign of Omega_a, `rho` the sign of
    c_a - c_d, and `chi` that of -rho epsilon sigma Omega_d (+1 for zeros).
    """

    regime: Regime
    axes: tuple[int, int, int]
    epsilon: int
    sigma: int
    rho: int
    chi: int


def classify(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Polhode:
    """Decide the regime from exact inertia (3 numbers) and body rates (3 numbers)."""
    low, middle, high = sorted(range(3), key=lambda k: inertia[k])
    E_b = discriminant(inertia, omega)
    axes = (low, middle, high) if E_b < 0 else (high, middle, low)
    if _steady(inertia, omega):
        regime = _steady_regime(inertia, omega)
    else:
        regime = _moving_regime(inertia, E_b)
    epsilon = 1 if axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1
    sigma = -1 if omega[axes[0]] < 0 else 1
    rho = 1 if axes[0] == high else -1
    chi = -1 if -rho * epsilon * sigma * omega[axes[2]] < 0 else 1
    return Polhode(regime, axes, epsilon, sigma, rho, chi)


def _steady(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> bool:
    return all(
        (inertia[j] - inertia[k]) * omega[j] * omega[k] == 0 for j, k in combinations(range(3), 2)
    )


def discriminant(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Fraction:
    """E_b = K^2 - 2 H c_b, b being the middle axis: its sign tells the circulations apart."""
    axes = sorted(range(3), key=lambda k: inertia[k], reverse=True)
    values = {f"c_{x}": inertia[k] for x, k in zip("abd", axes, strict=True)}
    values |= {f"Omega_{x}": omega[k] for x, k in zip("abd", axes, strict=True)}
    return sequence("constants").up_to(_DISCRIMINANT).evaluate(values, {"power": pow})["E_b"]


def _steady_regime(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Regime:
    if not any(omega):
        return Regime.REST
    return Regime.SPHERICAL if len(set(inertia)) == 1 else Regime.SPIN


def _moving_regime(inertia: Sequence[Fraction], E_b: Fraction) -> Regime:
    if len(set(inertia)) == 2:
        return Regime.SYMMETRIC
    if E_b == 0:
        return Regime.SEPARATRIX
    return Regime.LARGEST if E_b > 0 else Regime.SMALLEST
