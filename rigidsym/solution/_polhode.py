"""Exact classification of a motion by the ledger's partition."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from typing import Any, TypeVar

from rigidsym._inputs import shown
from rigidsym.errors import InputError
from rigidsym.solution._formulas import sealed, sequence
from rigidsym.solution._partition import SIGNS, handedness

_DISCRIMINANT = frozenset({"E_b"})
# Fractions, or floats and arrays of them.
Moment = TypeVar("Moment", Fraction, float)
Value = TypeVar("Value")


class Regime(StrEnum):
    """The dynamical regime of a torque-free motion.

    Every motion is in exactly one regime.

    The rates are constant in the first three, and change in the last four.
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
        """True for a regime with constant rates."""
        return self in (Regime.REST, Regime.SPHERICAL, Regime.SPIN)


@dataclass(frozen=True, slots=True)
class Polhode:
    """The regime of a motion, with the roles of the body's axes and the signs in its formulas.

    `leaf` is the motion's leaf in the ledger's partition.

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
    """Decide the regime of a motion exactly from its moments of inertia and body rates.

    There are three of each.
    """
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
    """Return momentum^2 - 2 energy * middle moment; its sign decides the circulation axis.

    It is E_b = K^2 - 2 H c_b: c_b is the middle moment, K the angular momentum and H the kinetic
    energy.
    """
    axes = sorted(range(3), key=lambda k: inertia[k], reverse=True)
    values: dict[str, Any] = {f"c_{x}": inertia[k] for x, k in zip("abd", axes, strict=True)}
    values |= {f"Omega_{x}": omega[k] for x, k in zip("abd", axes, strict=True)}
    return sequence("constants").up_to(_DISCRIMINANT).evaluate(values, {"power": pow})["E_b"]


class Mode(StrEnum):
    """The axis that the momentum circulates about, named as in astronomy.

    The long axis is that of the smallest moment, the short axis that of the largest.  Source:
    Samarasinha and A'Hearn, Icarus 93 (1991), 194-225.
    """

    SHORT_AXIS = "short-axis mode"
    LONG_AXIS = "long-axis mode"


def mode(polhode: Polhode, inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Mode | None:
    """Decide exactly whether a motion is in short-axis or long-axis mode.

    None on the separatrix, for spin about the middle axis, for spheres, and at rest.
    """
    moments = sorted(inertia)
    if polhode.regime == Regime.SPIN:
        turned = next(c for c, rate in zip(inertia, omega, strict=True) if rate)
        return {moments[2]: Mode.SHORT_AXIS, moments[0]: Mode.LONG_AXIS}.get(turned)
    if polhode.regime in (Regime.SEPARATRIX, Regime.SPHERICAL, Regime.REST):
        return None
    return Mode.SHORT_AXIS if polhode.rho > 0 else Mode.LONG_AXIS


# The choices of Theorem 1 for a motion: the root of (13) that is zeta^2, and the sign of xi.


def sine_axes(polhode: Polhode, i: int) -> tuple[int, int]:
    """Return the two axes other than i, in the order that the sine of rate i needs (Theorem 1).

    They are j and k.  zeta_i^2 is the root of (13) that contains c_j.

    Where i is not the circulation axis, j is, and all is real.  For the circulation axis itself
    no choice is real, and j is the middle axis.
    """
    a, b, _ = polhode.axes
    j = b if i == a else a
    return j, 3 - i - j


def sine_sign(inertia: Sequence[Fraction], omega0: Sequence[Fraction], i: int) -> int:
    """Return the sign of the derivative of rate i at t = 0, for its sine in Theorem 1.

    Remark 1 of the paper needs it.
    """
    torque = (inertia[i - 2] - inertia[i - 1]) * omega0[i - 2] * omega0[i - 1]
    return -1 if torque < 0 else 1


def check_sines(
    field: str, value: str, regime: Regime, omega0: Sequence[Fraction], others_serve: str
) -> None:
    """Check that Theorem 1 holds for a motion and does not divide by zero at t = 0.

    Raises InputError otherwise.
    """
    if regime not in (Regime.LARGEST, Regime.SMALLEST):
        rule = f"has no sines for this motion ({regime})"
        raise InputError(field, value, f"{rule}; {others_serve}")
    _, second, third = omega0
    if third == 0 or (second == 0 and third < 0):
        rule = "Theorem 1 divides by it, or by cos(phi3/2), at the start"
        raise InputError("omega0", shown(omega0), f"{rule}; {others_serve}")
