"""What energy and momentum say of the rates at all times, whatever the regime is.

By Euler's equations Omega_i^2 changes at the rate 2 k_i Omega_1 Omega_2 Omega_3, the k_i being
(c_2 - c_3)/c_1 and so on round: Omega_i^2 - (k_i/k_j) Omega_j^2 keeps its value.  So bounds of one
rate are bounds of the others, first of all those that the energy gives.  They are kept as two ends:
the radius of a ball would blur those that are small.
"""

from collections.abc import Sequence
from itertools import permutations

from flint import arb

from rigidsym.precise.balls import power

PASSES = 3


def shells(inertia: Sequence[arb], factors: Sequence[arb], omega: Sequence[arb]) -> list[arb]:
    """Balls that hold the rates (3) at every time, of all bodies and rates within the balls given.

    `factors` (3): the k_i.
    """
    start = [power(w, 2) for w in omega]
    energy = sum((c * s for c, s in zip(inertia, start, strict=True)), arb(0))
    ends = [(arb(0), (energy / c).upper()) for c in inertia]
    for i, j in list(permutations(range(3), 2)) * PASSES:
        linked = [start[i] + factors[i] / factors[j] * (end - start[j]) for end in ends[j]]
        if all(square.is_finite() for square in linked):
            low, high = ends[i]
            least, most = min(x.lower() for x in linked), max(x.upper() for x in linked)
            ends[i] = low.max(least), high.min(most)
    return [_root(*squares, w) for squares, w in zip(ends, omega, strict=True)]


def _root(low: arb, high: arb, start: arb) -> arb:
    """The numbers with squares between these; of one sign where they cannot pass through zero."""
    most = high.max(0).sqrt().upper()
    if not low > 0:
        return arb(0, most)
    return (low.sqrt().union(most)) if start > 0 else (-low.sqrt()).union(-most)
