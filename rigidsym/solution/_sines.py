"""Choices of Theorem 1 for a motion: the root of (13) for zeta^2, and the sign of xi."""

from collections.abc import Sequence
from fractions import Fraction

from rigidsym._inputs import shown
from rigidsym.errors import InputError
from rigidsym.solution._polhode import Polhode, Regime


def others(polhode: Polhode, i: int) -> tuple[int, int]:
    """Return the other two axes j, k: zeta_i^2 is the root of (13) that contains c_j.

    Where i is not the circulation axis, j is, and all is real.  For the circulation axis itself
    no choice is real, and j is the middle axis.
    """
    a, b, _ = polhode.axes
    j = b if i == a else a
    return j, 3 - i - j


def half(inertia: Sequence[Fraction], omega0: Sequence[Fraction], i: int) -> int:
    """Return the sign of Remark 1, the sign of Omega_i' at t = 0."""
    torque = (inertia[i - 2] - inertia[i - 1]) * omega0[i - 2] * omega0[i - 1]
    return -1 if torque < 0 else 1


def check(
    field: str, value: str, regime: Regime, omega0: Sequence[Fraction], others_serve: str
) -> None:
    """Raise InputError where Theorem 1 does not hold, or divides by zero at the start."""
    if regime not in (Regime.LARGEST, Regime.SMALLEST):
        rule = f"has no sines for this motion ({regime})"
        raise InputError(field, value, f"{rule}; {others_serve}")
    _, second, third = omega0
    if third == 0 or (second == 0 and third < 0):
        rule = "Theorem 1 divides by it, or by cos(phi3/2), at the start"
        raise InputError("omega0", shown(omega0), f"{rule}; {others_serve}")
