"""Counterexamples as motions: a body and its rates, as `rigidsym.TorqueFreeMotion` takes them."""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

# The names that contexts give to moments of inertia and rates, in the order of the axes.
NAMED = (
    (("c1", "c2", "c3"), ("Omega1", "Omega2", "Omega3")),
    (("c_i", "c_j", "c_k"), ("Omega_i", "Omega_j", "Omega_k")),
)
MOMENTA = ("M1", "M2", "M3")


@dataclass(frozen=True, slots=True)
class Motion:
    """Principal moments of inertia and body rates, about axes 1, 2, 3 (of Lemma 1: i, j, k)."""

    inertia: tuple[Fraction, Fraction, Fraction]
    omega: tuple[Fraction, Fraction, Fraction]

    def to_json(self) -> dict[str, Any]:
        """Plain data for programs."""
        return {"inertia": [*map(str, self.inertia)], "omega": [*map(str, self.omega)]}

    def __str__(self) -> str:
        inertia, omega = (", ".join(map(str, values)) for values in (self.inertia, self.omega))
        return f"c = ({inertia}), Omega = ({omega})"


def motion(inertia: str, omega: str) -> Motion:
    """A motion from rational numbers in a row."""
    (a, b, c), (x, y, z) = (map(Fraction, text.split()) for text in (inertia, omega))
    return Motion((a, b, c), (x, y, z))


# Contexts that name amplitudes, a rate and a parameter have those of this motion at their points;
# its first axis, i of Lemma 1, is the middle one.
ABOUT_MIDDLE = motion("16/25 3600/6409 1", "53/64 -6409/6000 24/25")
BY_AMPLITUDES = {
    "printed_sine": ABOUT_MIDDLE,
    "printed_sine_divided": ABOUT_MIDDLE,
    "printed_under_root": ABOUT_MIDDLE,
    "printed_20": ABOUT_MIDDLE,
    "printed_21": ABOUT_MIDDLE,
    "printed_35": ABOUT_MIDDLE,
    "printed_36": ABOUT_MIDDLE,
    "printed_36_of_modulus": ABOUT_MIDDLE,
}


class Values(Protocol):
    """A context at one point."""

    @property
    def names(self) -> set[str]:
        """What has a value there."""
        ...

    def of(self, name: str) -> Fraction:
        """The value of a name."""
        ...


def motion_at(context: str, values: Values) -> Motion | None:
    """The motion that a point is of, where its context speaks of one.

    Where only the momentum is said, it is that of a body with the moments 2, 3, 5/2.
    """
    if context in BY_AMPLITUDES:
        return BY_AMPLITUDES[context]
    for moments, rates in NAMED:
        if {*moments, *rates} <= values.names:
            c, omega = (tuple(map(values.of, names)) for names in (moments, rates))
            return Motion((c[0], c[1], c[2]), (omega[0], omega[1], omega[2]))
    if {*MOMENTA} <= values.names:
        c = (Fraction(2), Fraction(3), Fraction(5, 2))
        m = [values.of(name) for name in MOMENTA]
        return Motion(c, (m[0] / c[0], m[1] / c[1], m[2] / c[2]))
    return None
