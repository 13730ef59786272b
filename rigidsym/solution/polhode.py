"""Which kind of motion it is, decided exactly from exact inputs, by what the ledger proves."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction

from rigidsym.solution.formulas import sealed, sequence

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


# The leaves of the ledger's partition: which regime it is, and which of the axes is a, 1 being that
# of the largest moment.
_LEAVES = {
    "rest": (Regime.REST, 1),
    "spherical": (Regime.SPHERICAL, 1),
    "spin_1": (Regime.SPIN, 1),
    "spin_2": (Regime.SPIN, 1),
    "spin_3": (Regime.SPIN, 3),
    "oblate_polar": (Regime.SPIN, 1),
    "oblate_equatorial": (Regime.SPIN, 1),
    "oblate_motion": (Regime.SYMMETRIC, 1),
    "prolate_polar": (Regime.SPIN, 3),
    "prolate_equatorial": (Regime.SPIN, 1),
    "prolate_motion": (Regime.SYMMETRIC, 3),
    "separatrix_motion": (Regime.SEPARATRIX, 1),
    "largest": (Regime.LARGEST, 1),
    "smallest": (Regime.SMALLEST, 3),
}


def classify(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Polhode:
    """Decide the regime from exact inertia (3 numbers) and body rates (3 numbers)."""
    low, middle, high = sorted(range(3), key=lambda k: inertia[k])
    order = (high, middle, low)
    moments, rates = (tuple(values[k] for k in order) for values in (inertia, omega))
    regime, first = _LEAVES[sealed().partition.leaf(moments, rates)]
    axes = order if first == 1 else (low, middle, high)
    epsilon = 1 if axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1
    sigma = -1 if omega[axes[0]] < 0 else 1
    rho = 1 if first == 1 else -1
    chi = -1 if -rho * epsilon * sigma * omega[axes[2]] < 0 else 1
    return Polhode(regime, axes, epsilon, sigma, rho, chi)


def discriminant(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Fraction:
    """E_b = K^2 - 2 H c_b, b being the middle axis: its sign tells the circulations apart."""
    axes = sorted(range(3), key=lambda k: inertia[k], reverse=True)
    values = {f"c_{x}": inertia[k] for x, k in zip("abd", axes, strict=True)}
    values |= {f"Omega_{x}": omega[k] for x, k in zip("abd", axes, strict=True)}
    return sequence("constants").up_to(_DISCRIMINANT).evaluate(values, {"power": pow})["E_b"]
