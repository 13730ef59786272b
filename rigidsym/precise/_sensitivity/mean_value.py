"""Enclosures of attitudes and rates over a box of inputs, by the mean value theorem.

    state  in  state(middle) + S (inputs - middle),

where S contains the sensitivities of all motions of the box, by the ledger's formulas over numbers
with slopes.  As S is itself in S(middle) + s (inputs - middle), this deviation counts half: it is
integrated along the straight line from the middle.  The change of the attitude depends on the
attitude, so it is guessed, as the functions of elapsed time are (see `elapsed`).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import exp, log, pi, sqrt

import numpy as np
from flint import arb, arb_mat

from rigidsym.precise._balls import ball, intersection
from rigidsym.precise._functions import Theta
from rigidsym.precise._sensitivity.box import Box
from rigidsym.precise._sensitivity.columns import NUMBERS, TurnColumns
from rigidsym.precise._sensitivity.elapsed import (
    TRIES,
    Elapsed,
    Range,
    elapsed,
    until_quarter,
    wider,
)
from rigidsym.precise._sensitivity.sloped import Sloped

ONE = arb(0, 1)
_TINY = 1e-300
Rows = list[list[arb]]
# A turn since t = 0 (4), and its changes along the sides of a box (4, m).
Turn = tuple[list[Sloped], list[list[Sloped]]]


@dataclass(frozen=True)
class MeanValue:
    """The mean value form of all motions of a box at one time.

    Numbers have the working precision.

    turn, omega: the turn since t = 0 (4) and the rates (3) of the middle.
    """

    box: Box
    t: arb
    turn: Sequence[arb]
    omega: Sequence[arb]

    @cached_property
    def _functions(self) -> Elapsed:
        """The functions of elapsed time for the motion of the box's midpoint."""
        return elapsed(self.t, *map(ball, self.box.parameters), Theta())

    @cached_property
    def _changes(self) -> Rows:
        """The derivatives (7, m) of turn and rates at the box's midpoint, by `Box.sides`."""
        rates = self.box.point.rates(self.t, self._functions._asdict())
        columns = TurnColumns(self.box.point, self.t, rates, self.box.directions)
        return [*columns.of(self.turn), *columns.of_rates]

    @cached_property
    def columns(self) -> TurnColumns | None:
        """Enclosures of the derivatives of all motions of the box, by `Box.sides`.

        None without an enclosure of the rates.
        """
        functions = self._elapsed()
        if functions is None:
            return None
        rates = self.box.whole.rates(self.t, functions)
        return TurnColumns(self.box.whole, self.t, rates, self.box.directions)

    @cached_property
    def turned(self) -> Turn | None:
        """The turns of all motions since t = 0, with their derivatives.

        None where no guess of the derivatives is right.
        """
        if self.columns is None:
            return None
        image = self._changes[:4]
        for _ in range(TRIES):
            guess = [list(map(wider, row)) for row in image]
            _, changes = self._image(self.columns, guess)
            image = [[x.whole for x in row] for row in changes]
            if not all(x.is_finite() for x in _flat(image)):
                return None
            if all(map(arb.contains_interior, _flat(guess), _flat(image))):
                return self._image(self.columns, image)
        return None

    def _image(self, columns: TurnColumns, guess: Rows) -> Turn:
        """Return a turn computed from guessed derivatives, and the derivatives recomputed from it.

        The derivatives have the shape (4, m).
        """
        turn = []
        for start, row in zip(self.turn, guess, strict=True):
            whole = intersection(start + self.box.reach(row), ONE)
            turn.append(Sloped.of(start, arb_mat([row]), whole, self.box.sides))
        return turn, columns.of(turn)

    def state(self) -> tuple[list[Sloped] | None, list[Sloped] | None]:
        """Return enclosures of the turn since t = 0 (4) and of the rates (3).

        Each is None without an enclosure.
        """
        if self.columns is None:
            return None, None
        wholes = [self.columns.rates[f"Omega{k}"].whole for k in NUMBERS]
        given = zip(self.omega, self.columns.of_rates, wholes, strict=True)
        rates = [self._moved(*x) for x in given]
        if self.turned is None:
            return None, rates
        turn, changes = self.turned
        given = zip(self.turn, changes, (x.whole for x in turn), strict=True)
        return [self._moved(*x) for x in given], rates

    def _moved(self, start: arb, row: Sequence[Sloped], whole: arb) -> Sloped:
        """Enclose a number over the box from its value at the middle and its derivatives.

        On the straight line from the middle, half of the derivatives' deviations counts.
        """
        slopes = [intersection(x.middle + x.deviation() / 2, x.whole) for x in row]
        known = intersection(start + self.box.reach(slopes), whole)
        return Sloped.of(start, arb_mat([slopes]), known, self.box.sides)

    def _elapsed(self) -> dict[str, Sloped] | None:
        """Enclose the functions of elapsed time over the box.

        Return None without an enclosure.
        """
        middles = self._functions
        if self.box.is_sphere:
            still = arb_mat(len(middles), self.box.sides.nrows())
            return self._sloped(middles, still, middles)
        p, r, gap = (self.box.whole.constants[name] for name in ("p", "r", "apart"))
        deviation = arb_mat([[x.deviation()] for x in (p, gap)])
        grows = until_quarter(self.t, *map(ball, self.box.parameters))
        found = Range(self.t, p.whole, r.whole, gap.whole, grows).over(middles, deviation)
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

    @np.errstate(all="ignore")
    def bends(self) -> np.ndarray:
        """Return the derivatives (6, s + n) of the motion's phases by `Box.sides`, in rad.

        Phases are the turn (4), the phase u = lambda t, and u as far as it follows from the quarter
        of a period, log(16 p/(p - r))/2 near the separatrix.
        """
        p, gap = (self.box.whole.constants[x] for x in ("p", "apart"))
        rate, near = float(abs(p.middle) + p.deviation().rad()), abs(float(gap.middle))
        by_rate = by_quarter = 0.0
        if rate > 0:
            u = abs(float(self.t)) * sqrt(rate)
            near = max(near, 16 * rate * exp(-2 * u), _TINY)
            quarters = u / max(pi / 2, log(16 * rate / near) / 2)
            by_rate, by_quarter = 3 * u / (2 * rate), 3 * max(1, quarters) / (2 * near)
        rows = [2 * _doubles(row) for row in self._changes[:4]]
        angle = abs(float(self.t)) * max(abs(float(x)) for x in self.omega)
        for x in ("alpha_a", "alpha_b", "alpha_d"):
            rows.append(angle * _doubles(self.box.whole.constants[x].slopes.entries()))
        rows += [_doubles(x.slopes.entries()) * y for x, y in ((p, by_rate), (gap, by_quarter))]
        return np.array(rows)


def _doubles(row: Sequence[arb]) -> np.ndarray:
    return np.array([float(x.mid()) for x in row])


def _flat(rows: Rows) -> list[arb]:
    return [x for row in rows for x in row]
