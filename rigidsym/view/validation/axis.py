"""An axis of logarithms, with places of their own for zero and for infinity."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

from rigidsym.view import svg as plot

# Exponents below this share a part of the axis, so that the others keep theirs.
KNEE, PART = -20.0, 0.22


@dataclass(frozen=True, slots=True)
class Axis:
    """Exponents from `low` to `high`, drawn from `first` to `last` (pixels).

    What is less than `low` and more than `high` goes to places at the ends, `under` and `over`
    pixels long; 0 where there is no need of one.
    """

    low: float
    high: float
    first: float
    last: float
    under: float = 0.0
    over: float = 0.0

    @property
    def begin(self) -> float:
        """Where exponents begin."""
        return self.first + math.copysign(self.under, self.last - self.first)

    @property
    def end(self) -> float:
        """Where exponents end."""
        return self.last - math.copysign(self.over, self.last - self.first)

    @property
    def knots(self) -> list[tuple[float, float]]:
        """Exponents and where they are drawn, the scale being even between two of them."""
        ends = [(self.low, self.begin), (self.high, self.end)]
        if self.low < KNEE < self.high:
            ends.insert(1, (KNEE, self.begin + PART * (self.end - self.begin)))
        return ends

    @property
    def edges(self) -> list[float]:
        """Where places at the ends are parted from the rest, and scales from each other."""
        ends = [self.begin] * bool(self.under) + [self.end] * bool(self.over)
        return ends + [at for _, at in self.knots[1:-1]]

    def at(self, exponent: float) -> float:
        """Where an exponent is drawn."""
        if exponent < self.low:
            return (self.first + self.begin) / 2
        if exponent > self.high:
            return (self.end + self.last) / 2
        pieces = pairwise(self.knots)
        (low, begin), (high, end) = next(two for two in pieces if exponent <= two[1][0])
        return plot.scale((low, high), begin, end)(exponent)

    @property
    def ticks(self) -> list[float]:
        """Round exponents, few where the scale is small."""
        *far, low, high = [exponent for exponent, _ in self.knots]
        near = [x for x in plot.ticks(low, high, 1.0) if low <= x <= high]
        few = [x for end in far for x in plot.ticks(end, low, (low - end) / 2) if end <= x < low]
        return few + near

    def labelled(self, room: float) -> list[float]:
        """The ticks whose labels have so much room beside those of the places at the ends."""
        ends = [-math.inf] * bool(self.under) + [math.inf] * bool(self.over)
        taken = [self.at(end) for end in ends]
        return [x for x in self.ticks if all(abs(self.at(x) - at) >= room for at in taken)]


def fitted(
    exponents: Iterable[float], first: float, last: float, slot: float, least: float = -math.inf
) -> Axis:
    """The axis that shows all of these; what is below `least` counts as zero."""
    known = list(exponents)
    inside = [x for x in known if x >= least and math.isfinite(x)] or [0.0]
    low, high = math.floor(min(inside)), math.ceil(max(inside))
    under = slot if min(known, default=low) < low else 0.0
    over = slot if max(known, default=high) > high else 0.0
    return Axis(low, max(high, low + 1), first, last, under, over)
