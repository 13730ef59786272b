"""Cut a box of inputs into parts where the mean value form of the whole box is too wide.

The excess of the mean value form grows with the square of the box, so parts of it have less.  The
part that reaches farthest beyond its first order is cut next, into slabs across the direction in
which the phases of the motion change most.  The enclosure of each part is rigorous.  The choice of
parts is made in doubles: any parts that cover the box would do.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np
from flint import arb

from rigidsym.precise.sensitivity.box import MARGIN, Slab

# The most parts that are enclosed, and the most directions that one part is cut across.
MOST_PARTS, MOST_SLABS = 32, 3
# After so many parts components that no part has enclosed are given up.
GIVE_UP = 20
# Aim at this change of the phases in a part, rad, and at no more pieces at once.
CHANGE, MOST_PIECES = 0.2, 20
# A part whose phases change by more says nothing, and neither would its pieces.
LOST = 6
# Stop where the balls reach beyond the first order by less than this part of its range.
NEARLY = 0.1
# Components that change by less than this part of the widest one need no parts of their own.
SMALL = 1e-3
_TINY, _HUGE = 1e-300, 1e100


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a box and the enclosure of its states.

    slabs: what cuts the part out of the box.
    state: balls of the attitude and the rates (7).
    first: ends (7, 2) of what the first order gives; (inf, -inf) where there is no enclosure.
    bends: change of phases (6, s + n) by the sides of the box, rad, as `MeanValue.bends` has it.
    reach: radii of these sides (s + n).
    ends: ends (n, 2) of the inputs, less the middles of the whole box.
    """

    slabs: tuple[Slab, ...]
    state: Sequence[arb]
    first: np.ndarray
    bends: np.ndarray
    reach: np.ndarray
    ends: np.ndarray

    @np.errstate(all="ignore")
    def pieces(self) -> list[tuple[Slab, ...]]:
        """Return the slabs of each piece to cut the part into; none where cutting is no use."""
        count, radii = len(self.slabs), (self.ends[:, 1] - self.ends[:, 0]) / 2
        if not np.isfinite(radii).all():
            return []
        bends = np.clip(np.nan_to_num(self.bends), -_HUGE, _HUGE)
        if np.linalg.norm(bends[:-1] * self.reach, axis=0).max() > LOST:
            return []
        gains = np.linalg.norm(bends[:, :count], axis=0) * self.reach[:count]
        best = int(np.argmax(gains)) if count else -1
        if count < min(MOST_SLABS, len(radii)) and radii.min() > _TINY:
            found = np.linalg.svd(bends[:, count:] * radii)
            direction = found.Vh[0] / radii
            terms = np.sort(self.ends * direction[:, None], axis=1)
            # More than the sums are rounded by, so that the pieces cover the part.
            room = MARGIN * (1 + np.abs(terms).sum())
            low, high = (terms.sum(axis=0) + (-room, room)).tolist()
            gain = float(found.S[0]) * (high - low) / 2
            if not count or gain > gains[best]:
                whole = Slab(tuple(direction.tolist()), low, high)
                return [(*self.slabs, piece) for piece in _sliced(whole, gain)]
        if not count:
            return []
        before, after = self.slabs[:best], self.slabs[best + 1 :]
        pieces = _sliced(self.slabs[best], float(gains[best]))
        return [(*before, piece, *after) for piece in pieces]


def parts_of(enclose: Callable[[tuple[Slab, ...]], Part | None], least: float) -> list[Part]:
    """Return parts that cover a box.

    enclose: returns the part that some slabs cut out, and None for an empty one.
    least: a range that needs no parts.
    """
    parts, seen = [part for part in [enclose(())] if part], 1
    while seen < MOST_PARTS:
        worst = _worst(parts, least, seen > GIVE_UP)
        pieces = [] if worst is None else parts[worst].pieces()
        if worst is None or not pieces:
            break
        del parts[worst]
        parts += [part for part in map(enclose, pieces) if part]
        seen += len(pieces)
    return parts


@np.errstate(all="ignore")
def _worst(parts: Sequence[Part], least: float, gives_up: bool) -> int | None:
    """Return the part that reaches farthest beyond the first order; None where none does."""
    first = np.array([part.first for part in parts])
    ends = np.array([[[float(x.lower()), float(x.upper())] for x in p.state] for p in parts])
    low, high = first[:, :, 0].min(axis=0), first[:, :, 1].max(axis=0)
    known = np.isfinite(low)
    size = np.where(known, high - low, 0)
    for part in (slice(4), slice(4, None)):
        size[part] = np.maximum(size[part], max(SMALL * size[part].max(), least))
    beyond = np.maximum(low - ends[:, :, 0], ends[:, :, 1] - high) / size
    beyond[:, ~known] = 0 if gives_up else np.inf
    worst = int(np.argmax(beyond.max(axis=1)))
    return worst if beyond[worst].max() > NEARLY else None


def _sliced(slab: Slab, gain: float) -> list[Slab]:
    count = ceil(min(max(gain / CHANGE, 2), MOST_PIECES))
    ends = np.linspace(slab.low, slab.high, count + 1).tolist()
    return [Slab(slab.direction, *pair) for pair in pairwise(ends)]
