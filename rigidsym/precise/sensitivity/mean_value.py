"""Turns and rates of all motions of a box, by the theorem of the mean:

    state  in  state(middle) + S (inputs - middle),

where S holds the sensitivities of all motions of the box, by the ledger's formulas over numbers
with slopes.  With S itself in S(middle) + s (inputs - middle), what it leaves open counts half: it
is integrated along the straight line from the middle.  The change of the attitude needs the
attitude, so it is guessed, as `over_box` has it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from rigidsym.precise.balls import ball, meeting
from rigidsym.precise.sensitivity.box import Box
from rigidsym.precise.sensitivity.columns import NUMBERS
from rigidsym.precise.sensitivity.elapsed import Elapsed, elapsed, until_quarter
from rigidsym.precise.sensitivity.over_box import REFINED, TRIES, Range, wider
from rigidsym.precise.sensitivity.sloped import Sloped
from rigidsym.precise.sensitivity.turning import changes
from rigidsym.precise.theta import Theta

ONE = arb(0, 1)
Rows = list[list[arb]]
SlopedState = tuple[list[Sloped], list[Sloped]]


@dataclass(frozen=True, slots=True)
class Moving:
    """The turn since t = 0 (4), with what it changes by (4, n), and the rates with their columns,
    by name."""

    turn: list[Sloped]
    changes: list[list[Sloped]]
    rates: Mapping[str, Sloped]

    def wholes(self) -> Rows:
        """The changes as balls (4, n)."""
        return [[x.whole for x in row] for row in self.changes]


@dataclass(frozen=True, slots=True)
class MeanValue:
    """All motions of a box, at the working precision that it was made at."""

    box: Box

    def state(self, t: arb, turn: Sequence[arb], omega: Sequence[arb]) -> SlopedState | None:
        """The turn since t = 0 (4) and the rates (3), of which those of the middle are given."""
        moving = self.moving(t, turn)
        if moving is None:
            return None
        found = [*moving.turn, *(moving.rates[f"Omega{k}"] for k in NUMBERS)]
        rows = [
            *moving.changes,
            *([moving.rates[f"Omega{k}_by_{y}"] for y in self.box.names] for k in NUMBERS),
        ]
        given = zip((*turn, *omega), rows, found, strict=True)
        numbers = [self._moved(start, row, x.whole) for start, row, x in given]
        return numbers[:4], numbers[4:]

    def _moved(self, start: arb, row: Sequence[Sloped], whole: arb) -> Sloped:
        """What derivatives in a box move a number to: on the straight line from the middle half of
        what they leave open."""
        slopes = [meeting(x.middle + x.apart() / 2, x.whole) for x in row]
        return Sloped.of(start, arb_mat([slopes]), whole, self.box.sides)

    def moving(self, t: arb, turn: Sequence[arb]) -> Moving | None:
        """At a time, with the turn since t = 0 of the middle; None where no guess is found."""
        functions = self._elapsed(t)
        if functions is None:
            return None
        rates = self.box.whole.rates(t, functions)
        image = self._at_middle(t, functions, turn)
        for _ in range(TRIES):
            guess = [list(map(wider, row)) for row in image]
            moving = self._image(t, rates, turn, guess)
            image = moving.wholes()
            if not all(x.is_finite() for x in _flat(image)):
                return None
            if all(map(arb.contains_interior, _flat(guess), _flat(image))):
                for _ in range(REFINED):
                    moving = self._image(t, rates, turn, moving.wholes())
                return moving
        return None

    def _at_middle(self, t: arb, functions: Mapping[str, Sloped], turn: Sequence[arb]) -> Rows:
        """What the turn changes by (4, n) there."""
        middles = {name: x.middle for name, x in functions.items()}
        return changes(self.box.point, t, self.box.point.rates(t, middles), turn, self.box.names)

    def _image(
        self, t: arb, rates: Mapping[str, Sloped], turn: Sequence[arb], guess: Rows
    ) -> Moving:
        """What a guess of the turn's changes (4, n) leads to."""
        sides = self.box.sides
        turns = [
            Sloped.of(x, arb_mat([row]), ONE, sides) for x, row in zip(turn, guess, strict=True)
        ]
        found = changes(self.box.whole, t, rates, turns, self.box.names)
        return Moving(turns, found, rates)

    def _elapsed(self, t: arb) -> dict[str, Sloped] | None:
        """The functions of elapsed time over the box; None where nothing is found."""
        middles = elapsed(t, *map(ball, self.box.parameters), Theta())
        if self.box.is_sphere:
            return self._sloped(middles, arb_mat(len(middles), len(self.box.open)), middles)
        p, r, gap = (self.box.whole.constants[name] for name in ("p", "r", "apart"))
        apart = arb_mat([[x.apart()] for x in (p, gap)])
        grows = until_quarter(t, *map(ball, self.box.parameters))
        found = Range(t, p.whole, r.whole, gap.whole, grows).over(middles, apart)
        if found is None:
            return None
        wholes, slopes = found
        by_inputs = slopes * arb_mat([p.slopes.entries(), gap.slopes.entries()])
        return self._sloped(middles, by_inputs, wholes)

    def _sloped(self, middles: Elapsed, slopes: arb_mat, wholes: Elapsed) -> dict[str, Sloped]:
        named = zip(Elapsed._fields, middles, slopes.tolist(), wholes, strict=True)
        return {
            name: Sloped.of(x, arb_mat([row]), whole, self.box.sides)
            for name, x, row, whole in named
        }


def _flat(rows: Rows) -> list[arb]:
    return [x for row in rows for x in row]
