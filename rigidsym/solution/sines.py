"""The choices of Theorem 1 for one motion: which root of (13) is zeta^2, and the sign of xi."""

from collections.abc import Sequence
from fractions import Fraction

from rigidsym.errors import InputError
from rigidsym.inputs import shown
from rigidsym.solution.polhode import Polhode, Regime


def others(polhode: Polhode, i: int) -> tuple[int, int]:
    """The other two axes j, k, zeta_i^2 being the root of (13) that has c_j.

    About the two axes that the rates do not circulate about, j is the one they do, and all is
    real; about that one no choice is real, and j is the middle axis.
    """
    a, b, _ = polhode.axes
    j = b if i == a else a
    return j, 3 - i - j


def half(inertia: Sequence[Fraction], omega0: Sequence[Fraction], i: int) -> int:
    """Remark 1's sign: that of the rate of Omega_i, which grows with xi where C_i is."""
    torque = (inertia[i - 2] - inertia[i - 1]) * omega0[i - 2] * omega0[i - 1]
    return -1 if torque < 0 else 1


def check(
    field: str, value: str, regime: Regime, omega0: Sequence[Fraction], others_serve: str
) -> None:
    """Raise InputError for a motion that Theorem 1 is not about, and for one it cannot start at."""
    if regime not in (Regime.LARGEST, Regime.SMALLEST):
        rule = f"has no sines for this motion ({regime})"
        raise InputError(field, value, f"{rule}; {others_serve}")
    _, second, third = omega0
    if third == 0 or (second == 0 and third < 0):
        rule = "Theorem 1 divides by it, or by cos(phi3/2), at the start"
        raise InputError("omega0", shown(omega0), f"{rule}; {others_serve}")


def serving(regime: Regime) -> str:
    """The elementary form of a regime, or the one for all that lies between the edges."""
    return {
        Regime.SEPARATRIX: "separatrix",
        Regime.SYMMETRIC: "symmetric",
        Regime.SPHERICAL: "sphere",
        Regime.SPIN: "spin",
        Regime.REST: "spin",
    }.get(regime, "pi")
