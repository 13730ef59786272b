"""The regime of a motion whose numbers are uncertain: what decides it has to have one sign."""

from collections.abc import Iterator, Sequence
from itertools import combinations
from math import inf

from flint import arb

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import Number
from rigidsym.precise.balls import ball, difference, power, working
from rigidsym.solution.formulas import sealed, sequence
from rigidsym.solution.partition import SIGNED
from rigidsym.solution.polhode import Polhode, classify

BITS = 4096
_E_B = frozenset({"E_b"})


def classify_uncertain(inertia: Sequence[Number], omega: Sequence[Number]) -> Polhode:
    """The polhode that all numbers within the radii share; InputError names what keeps it open."""
    middles = [[inputs.middle(x) for x in values] for values in (inertia, omega)]
    polhode = classify(*middles)
    if inputs.is_uncertain(*inertia, *omega):
        with working(BITS):
            for what, value in _deciding(polhode, inertia, omega):
                _decide(what, value, inertia, omega)
    return polhode


def _deciding(
    polhode: Polhode, inertia: Sequence[Number], omega: Sequence[Number]
) -> Iterator[tuple[str, arb]]:
    """What has to be exactly zero, or to keep its sign: the order of the moments, what the ledger's
    partition asks on the way to this leaf, and the rate that sigma is the sign of."""
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
    """E_b by the ledger's formula, with differences that are exactly zero where moments agree."""
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
    """The one that is farthest from zero for its radius."""
    given = [value for value in values if not value.is_zero()]
    return min(given, key=_ratio)


def _ratio(value: arb) -> float:
    """Radius over size: 1 or more where it may be zero."""
    return float(value.rad() / abs(value.mid())) if value.mid() != 0 else inf


def _decide(what: str, value: arb, inertia: Sequence[Number], omega: Sequence[Number]) -> None:
    if value.is_zero() or not value.contains(0):
        return
    ratio = _ratio(value)
    narrower = "exact" if ratio == inf else f"about {ratio * 1.1 + 0.1:.1f} times narrower"
    rule = f"{what} may be zero or have either sign: the inputs would have to be {narrower}"
    given = f"{inputs.shown(inertia)}, omega0 = {inputs.shown(omega)}"
    raise InputError("inertia", given, rule)
