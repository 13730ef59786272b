"""The regime of a motion whose numbers are uncertain: what decides it has to have one sign."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from math import inf

from flint import arb

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import Number, Uncertain
from rigidsym.precise.balls import ball, difference, working
from rigidsym.solution.polhode import Polhode, Regime, classify

BITS = 4096


def classify_uncertain(inertia: Sequence[Number], omega: Sequence[Number]) -> Polhode:
    """The polhode that all numbers within the radii share; InputError names what keeps it open."""
    middles = [[_middle(x) for x in values] for values in (inertia, omega)]
    polhode = classify(*middles)
    if inputs.is_uncertain(*inertia, *omega):
        with working(BITS):
            for what, value in _deciding(polhode, inertia, omega):
                _decide(what, value, inertia, omega)
    return polhode


def _deciding(
    polhode: Polhode, inertia: Sequence[Number], omega: Sequence[Number]
) -> Iterator[tuple[str, arb]]:
    """What has to be exactly zero, or to keep its sign."""
    w = list(map(ball, omega))
    pairs = [*combinations(range(3), 2)]
    gaps = {(j, k): difference(inertia[j], inertia[k]) for j, k in pairs}
    yield from ((f"inertia[{j}] - inertia[{k}]", gap) for (j, k), gap in gaps.items())
    if polhode.regime.steady:
        products = ((j, k, gap * w[j] * w[k]) for (j, k), gap in gaps.items())
        yield from ((f"the torque by omega0[{j}] and omega0[{k}]", x) for j, k, x in products)
        yield from _resting(polhode, w)
        return
    a, b, d = polhode.axes
    if inputs.is_uncertain(*inertia, omega[a], omega[d]):
        if polhode.regime != Regime.SYMMETRIC:
            yield "K^2 - 2 H c_b", _excess(inertia, w, polhode.axes)
        yield f"omega0[{a}], about the circulation axis,", w[a]
    yield f"omega0[{b}] or omega0[{d}], at right angles to a spin,", _surest(w[b], w[d])


def _resting(polhode: Polhode, w: Sequence[arb]) -> Iterator[tuple[str, arb]]:
    if polhode.regime == Regime.REST:
        yield from ((f"omega0[{k}], of a body at rest,", x) for k, x in enumerate(w))
    else:
        yield "omega0", _surest(*w)


def _excess(inertia: Sequence[Number], w: Sequence[arb], axes: Sequence[int]) -> arb:
    a, b, d = axes
    return (
        ball(inertia[a]) * difference(inertia[a], inertia[b]) * w[a] * w[a]
        + ball(inertia[d]) * difference(inertia[d], inertia[b]) * w[d] * w[d]
    )


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


def _middle(value: Number) -> Fraction:
    return value.middle if isinstance(value, Uncertain) else value
