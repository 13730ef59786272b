"""The regime of a motion whose numbers are uncertain: what decides it has to have one sign."""

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

from flint import arb

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import Uncertain
from rigidsym.precise.balls import ball, working
from rigidsym.solution.polhode import Polhode, Regime, classify

BITS = 4096


def classify_uncertain(inertia: Sequence[Any], omega: Sequence[Any]) -> Polhode:
    """The polhode that all numbers within the radii share; InputError names what keeps it open."""
    middles = [[_middle(x) for x in values] for values in (inertia, omega)]
    polhode = classify(*middles)
    if any(isinstance(x, Uncertain) for x in (*inertia, *omega)):
        with working(BITS):
            for what, value in _deciding(polhode, inertia, omega):
                _decide(what, value, inertia, omega)
    return polhode


def _deciding(
    polhode: Polhode, inertia: Sequence[Any], omega: Sequence[Any]
) -> Iterator[tuple[str, arb]]:
    """What has to be exactly zero, or to keep its sign: moments, steadiness, the separatrix."""
    c, w = [list(map(ball, values)) for values in (inertia, omega)]
    pairs = [*combinations(range(3), 2)]
    yield from ((f"inertia[{j}] - inertia[{k}]", c[j] - c[k]) for j, k in pairs)
    if polhode.regime.steady:
        products = ((j, k, (c[j] - c[k]) * w[j] * w[k]) for j, k in pairs)
        yield from ((f"the torque by omega0[{j}] and omega0[{k}]", x) for j, k, x in products)
        return
    _, b, _ = polhode.axes
    yield "K^2 - 2 H c_b", sum((c[k] * (c[k] - c[b]) * w[k] * w[k] for k in range(3)), arb(0))
    if polhode.regime != Regime.SYMMETRIC:
        yield "omega0 about the circulation axis", w[polhode.axes[0]]


def _decide(what: str, value: arb, inertia: Sequence[Any], omega: Sequence[Any]) -> None:
    if value.is_zero() or not value.contains(0):
        return
    ratio = float(value.rad() / abs(value.mid())) if value.mid() != 0 else None
    narrower = "exact" if ratio is None else f"about {ratio * 1.1 + 0.1:.1f} times narrower"
    rule = f"{what} may have either sign: the inputs would have to be {narrower}"
    given = f"{inputs.shown(inertia)}, omega0 = {inputs.shown(omega)}"
    raise InputError("inertia", given, rule)


def _middle(value: Any) -> Any:
    return value.middle if isinstance(value, Uncertain) else value
