"""Which kind of motion it is, decided exactly from exact inputs, by what the ledger proves."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from typing import Any, TypeVar

from rigidsym.solution.formulas import sealed, sequence
from rigidsym.solution.signs import SIGNS, handedness

_DISCRIMINANT = frozenset({"E_b"})
# Fractions, or floats and arrays of them.
Moment = TypeVar("Moment", Fraction, float)
Value = TypeVar("Value")


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
    """The regime, with the leaf of the ledger's partition that it is, and the axes by what they do.

    `axes` are the indices (0, 1, 2) of the circulation axis a, the middle axis b and the third d;
    `epsilon` is +1 when they are right-handed, `sigma` the sign of Omega_a, `rho` the sign of
    c_a - c_d, and `chi` that of -rho epsilon sigma Omega_d (+1 for zeros).  Where rates are
    constant, a is the axis of largest inertia.
    """

    regime: Regime
    leaf: str
    axes: tuple[int, int, int]
    epsilon: int
    sigma: int
    rho: int
    chi: int


_REGIMES = {
    **{"rest": Regime.REST, "spherical": Regime.SPHERICAL},
    **{f"spin_{k}": Regime.SPIN for k in (1, 2, 3)},
    **{
        f"{body}_{x}": Regime.SPIN
        for body in ("oblate", "prolate")
        for x in ("polar", "equatorial")
    },
    **{"oblate_motion": Regime.SYMMETRIC, "prolate_motion": Regime.SYMMETRIC},
    **{"separatrix_motion": Regime.SEPARATRIX},
    **{"largest": Regime.LARGEST, "smallest": Regime.SMALLEST},
}


def classify(inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Polhode:
    """Decide the regime from exact inertia (3 numbers) and body rates (3 numbers)."""
    solution = sealed()
    low, middle, high = sorted(range(3), key=lambda k: inertia[k])
    order = (high, middle, low)
    moments, rates = (tuple(values[k] for k in order) for values in (inertia, omega))
    leaf = solution.partition.leaf(moments, rates)
    a, b, d = order if leaf.side >= 0 else (low, middle, high)
    known = {"epsilon": handedness(a, b, d), "c_ad": inertia[a] - inertia[d]}
    known |= {"Omega_a": omega[a], "Omega_d": omega[d]}
    signs = solution.evaluated["signs"].evaluate(known, {"choose": _chosen})
    return Polhode(_REGIMES[leaf.name], leaf.name, (a, b, d), *(int(signs[name]) for name in SIGNS))


def _chosen(x: Fraction, y: Fraction, one: int, other: int) -> int:
    return one if x <= y else other


def discriminant(inertia: Sequence[Moment], omega: Sequence[Value]) -> Value:
    """E_b = K^2 - 2 H c_b, b being the middle axis: its sign tells the circulations apart."""
    axes = sorted(range(3), key=lambda k: inertia[k], reverse=True)
    values: dict[str, Any] = {f"c_{x}": inertia[k] for x, k in zip("abd", axes, strict=True)}
    values |= {f"Omega_{x}": omega[k] for x, k in zip("abd", axes, strict=True)}
    return sequence("constants").up_to(_DISCRIMINANT).evaluate(values, {"power": pow})["E_b"]
