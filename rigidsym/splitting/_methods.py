"""Coefficients of splitting methods, which alternate free motions (drifts) and kicks.

Errors are those of Laskar and Robutel (Celestial Mechanics and Dynamical Astronomy 80, 39-62):
with a torque that is epsilon times what turns the body, and steps h, a method of orders (r, s) has
the error O(epsilon h^r + epsilon^2 h^s).
"""

from dataclasses import dataclass
from math import fsum

from rigidsym.errors import unknown

_ROUNDING = 1e-15


@dataclass(frozen=True, slots=True)
class Method:
    """A symmetric splitting method, which alternates drifts and kicks.

    Attributes
    ----------
    drifts, kicks : tuple of float
        Parts of a step, which are the same in reverse order.
    orders : tuple of int
        (r, s) as above.
    source : str
        Source of the coefficients.
    """

    drifts: tuple[float, ...]
    kicks: tuple[float, ...]
    orders: tuple[int, int]
    source: str

    def __post_init__(self) -> None:
        parts = self.drifts, self.kicks
        if len(self.drifts) != len(self.kicks) + 1 or any(x != x[::-1] for x in parts):
            raise ValueError("a symmetric splitting begins and ends with the same drift")
        if any(abs(fsum(x) - 1) > _ROUNDING for x in parts):
            raise ValueError("the parts of a step are a whole step")

    @property
    def order(self) -> int:
        """The order of convergence for a torque of any strength."""
        return min(self.orders)


def _symmetric(
    drifts: tuple[float, ...], kicks: tuple[float, ...], orders: tuple[int, int], source: str
) -> Method:
    """Return the symmetric method that begins with given drifts and kicks."""
    one_kick = len(drifts) == len(kicks)
    whole = _mirrored(drifts, 2 if one_kick else 1), _mirrored(kicks, 1 if one_kick else 2)
    return Method(*whole, orders, source)


def _mirrored(half: tuple[float, ...], middle: int) -> tuple[float, ...]:
    """Return a palindrome of coefficients with the sum 1, given its first half.

    middle: the number of equal coefficients in the middle, which complete the sum.
    """
    rest = (1 - 2 * fsum(half)) / middle
    return (*half, *[rest] * middle, *reversed(half))


_BLANES_MOAN = "Blanes and Moan, J. Computational and Applied Mathematics 142, 313-330, table 2"
METHODS = {
    "strang": _symmetric((), (), (2, 2), "Strang, SIAM J. Numerical Analysis 5, 506-517"),
    "saba2": _symmetric(
        (0.5 - 3**0.5 / 6,),
        (),
        (4, 2),
        "Laskar and Robutel, Celestial Mechanics and Dynamical Astronomy 80, 39-62",
    ),
    "aba84": _symmetric(
        (0.0753469602698928884165, 0.517916854688256782301),
        (0.190225939373676619245, 0.846524070443526257055),
        (8, 4),
        "McLachlan, BIT 35, 258-268",
    ),
    "bm4": _symmetric(
        (0.0792036964311956694337, 0.353172906049773988481, -0.0420650803577195353681),
        (0.209515106613362021274, -0.143851773179818008275),
        (4, 4),
        f"{_BLANES_MOAN}, S6",
    ),
    "bm6": _symmetric(
        (
            0.0502627644003926860212,
            0.413514300428343815063,
            0.0450798897943980629689,
            -0.188054853819568914799,
            0.541960678450780134831,
        ),
        (
            0.148816447901043231921,
            -0.132385865767783647449,
            0.0673076046921844581503,
            0.432666402578173597528,
        ),
        (6, 6),
        f"{_BLANES_MOAN}, S10",
    ),
}
"""By name, in the order of what a step costs."""


def checked(name: str) -> Method:
    """Return the splitting method with a given name.

    Raises InputError for an unknown name.
    """
    if not isinstance(name, str) or name not in METHODS:
        raise unknown("method", name, METHODS)
    return METHODS[name]
