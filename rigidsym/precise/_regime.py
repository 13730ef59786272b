"""Exact or uncertain inputs of a motion, and the regime that they determine."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from math import inf

from flint import arb

from rigidsym import _inputs as inputs
from rigidsym._inputs import Number
from rigidsym.errors import InputError
from rigidsym.precise._balls import ball, difference, power, working
from rigidsym.solution._formulas import sealed, sequence
from rigidsym.solution._partition import SIGNED
from rigidsym.solution._polhode import Polhode, classify

BITS = 4096
_E_B = frozenset({"E_b"})
# Inertia, omega0 and attitude0.
ExactInputs = tuple[tuple[Fraction, ...], tuple[Fraction, ...], tuple[Fraction, ...]]


@dataclass(frozen=True)
class MotionInputs:
    """Principal moments, initial body rates and initial attitude of a motion.

    There are three moments, three rates and a quaternion (4) at t = 0.

    Numbers are rational or uncertain.

    The attitude has any length but zero.
    """

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    attitude0: tuple[Number, ...]

    @cached_property
    def polhode(self) -> Polhode:
        """Regime and axes of the motion.

        Raises InputError where uncertain inputs do not decide them.
        """
        return classify_uncertain(self.inertia, self.omega0)

    @property
    def exact(self) -> ExactInputs:
        """The inertia, initial rates and initial attitude as rationals.

        Raises InputError for uncertain inputs.
        """
        given = {"inertia": self.inertia, "omega0": self.omega0, "attitude0": self.attitude0}
        inertia, omega0, attitude0 = (inputs.certain(*named) for named in given.items())
        return inertia, omega0, attitude0

    @property
    def is_uncertain(self) -> bool:
        """True if any input is uncertain."""
        return inputs.is_uncertain(*self.inertia, *self.omega0, *self.attitude0)


def classify_uncertain(inertia: Sequence[Number], omega: Sequence[Number]) -> Polhode:
    """Classify all motions within the radii of uncertain inputs.

    Raises InputError if they have different polhodes.
    """
    polhode = classify(*([inputs.middle(x) for x in values] for values in (inertia, omega)))
    if inputs.is_uncertain(*inertia, *omega):
        with working(BITS):
            for name, value in _deciding(polhode, inertia, omega):
                _check_sign(name, value, inertia, omega)
    return polhode


def _deciding(
    polhode: Polhode, inertia: Sequence[Number], omega: Sequence[Number]
) -> Iterator[tuple[str, arb]]:
    """Yield the quantities whose signs decide the polhode, with their names.

    They must be exactly zero or keep their sign.  They are the differences of the moments, those
    that lead to this leaf of the ledger's partition, and the rate whose sign is sigma.
    """
    w = list(map(ball, omega))
    gaps = {(j, k): difference(inertia[j], inertia[k]) for j, k in combinations(range(3), 2)}
    yield from ((f"inertia[{j}] - inertia[{k}]", gap) for (j, k), gap in gaps.items())
    path = dict(sealed().partition.path(polhode.leaf))
    if path["turning"] == 0:
        yield from ((f"omega0[{k}], of a body at rest,", x) for k, x in enumerate(w))
        return
    if polhode.regime.steady:
        products = ((j, k, gap * w[j] * w[k]) for (j, k), gap in gaps.items())
        yield from ((f"the torque by omega0[{j}] and omega0[{k}]", x) for j, k, x in products)
        yield "omega0", _surest(*w)
        return
    a, b, d = polhode.axes
    if inputs.is_uncertain(*inertia, omega[a], omega[d]):
        if SIGNED in path:
            yield "K^2 - 2 H c_b", _discriminant(inertia, w, polhode.axes)
        yield f"omega0[{a}], about the circulation axis,", w[a]
    yield f"omega0[{b}] or omega0[{d}], at right angles to a spin,", _surest(w[b], w[d])


def _discriminant(inertia: Sequence[Number], w: Sequence[arb], axes: Sequence[int]) -> arb:
    """Compute K^2 - 2 H c_b by the ledger's formula.

    Differences of equal moments are exactly zero.
    """
    known = {}
    for x, k in zip("abd", axes, strict=True):
        known |= {f"c_{x}": ball(inertia[k]), f"Omega_{x}": w[k]}
    a, b, d = axes
    known |= {
        "c_ab": difference(inertia[a], inertia[b]),
        "c_bd": difference(inertia[b], inertia[d]),
    }
    return sequence("constants").up_to(_E_B).evaluate_exactly(known, {"power": power}, ball)["E_b"]


def _surest(*values: arb) -> arb:
    """Return the ball that is farthest from zero, relative to its radius.

    Balls that are exactly zero are left out.
    """
    return min((value for value in values if not value.is_zero()), key=_ratio)


def _ratio(value: arb) -> float:
    """Return the ratio of a ball's radius to its size.

    It is at least 1 if the value may be zero.
    """
    return float(value.rad() / abs(value.mid())) if value.mid() != 0 else inf


def _check_sign(name: str, value: arb, inertia: Sequence[Number], omega: Sequence[Number]) -> None:
    """Check that a quantity is exactly zero or has a certain sign.

    Raises InputError for a ball that contains zero and other numbers.
    """
    if value.is_zero() or not value.contains(0):
        return
    ratio = _ratio(value)
    narrower = "exact" if ratio == inf else f"about {ratio * 1.1 + 0.1:.1f} times narrower"
    rule = f"{name} may be zero or have either sign: the inputs would have to be {narrower}"
    given = f"{inputs.shown(inertia)}, omega0 = {inputs.shown(omega)}"
    raise InputError("inertia", given, rule)
