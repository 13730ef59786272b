"""Sets of states that move with the flow and hardly grow by being wrapped: Lohner's method.

A set is  middle + spread r + frame e:  r is the box of uncertain inputs about their middles, the
same for ever; e holds all that was rounded, cut off or curved on the way, in a frame that is made
orthogonal again at every step (Lohner, in: Computational Ordinary Differential Equations, 1992;
Nedialkov, Jackson, Corliss, Applied Mathematics and Computation 105, 1999).  Each step is the
theorem of the mean: with J the derivatives over the whole set, k the factors of Euler's equations,

    flow(y, k) lies in flow(middle, middle of k) + J_y (y - middle) + J_k (k - middle of k),

along the straight line in states and moments from the middle to a motion of the box: its points
start in the box around the set and the middle, with moments of the box, where the series hold.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from rigidsym.precise.flow import RATES, SIZE, Flow


@dataclass(frozen=True, slots=True)
class Bodies:
    """All bodies and rates of a box r (6) about their middles: the flow of them all, the factors of
    the middle (3), how factors change with r (3, 6), and bounds of the rates (3) at all times."""

    flow: Flow
    middle: Sequence[arb]
    box: arb_mat
    by_box: arb_mat
    shells: Sequence[arb]


@dataclass(frozen=True, slots=True)
class Cloud:
    """Where rates and turn (7, 1) may be after some time."""

    middle: arb_mat
    spread: arb_mat
    frame: arb_mat
    rest: arb_mat

    def apart(self, bodies: Bodies) -> arb_mat:
        """How far from the middle they may be."""
        return self.spread * bodies.box + self.frame * self.rest

    def seen_by(self, turn: arb_mat) -> "Cloud":
        """The same, multiplied by a matrix (7, 7)."""
        return Cloud(turn * self.middle, turn * self.spread, turn * self.frame, self.rest)

    def states(self, bodies: Bodies) -> arb_mat:
        """A box around them: rates keep to their shells, and a quaternion to one."""
        around = (self.middle + self.apart(bodies)).entries()
        limits = [*bodies.shells, *[arb(0, 1)] * 4]
        return arb_mat(SIZE, 1, [x.intersection(y) for x, y in zip(around, limits, strict=True)])

    def moved(self, bodies: Bodies, step: arb) -> "Cloud":
        """After a step of time."""
        middle = bodies.flow.moved(bodies.middle, self.middle, step)
        held = zip(self.states(bodies).entries(), self.middle.entries(), strict=True)
        whole = arb_mat(SIZE, 1, [x.union(y) for x, y in held])
        by_state, by_factors = _split(bodies.flow.derivative(whole, step))
        spread = by_state * self.spread + by_factors * bodies.by_box
        carried = by_state * self.frame
        frame = _orthogonal(carried.mid(), self.rest)
        back = frame.inv()
        lost = (spread - spread.mid()) * bodies.box + (middle - middle.mid())
        rest = (back * carried) * self.rest + back * lost
        return Cloud(middle.mid(), spread.mid(), frame, rest)


def start(omega: Sequence[arb]) -> Cloud:
    """At t = 0: the rates of the middle, and no turn; all else is in the box."""
    middle = arb_mat(SIZE, 1, [*omega, arb(1), *[arb(0)] * 3])
    spread = [int(i == j < RATES) for i in range(SIZE) for j in range(2 * RATES)]
    frame = [int(i == j) for i in range(SIZE) for j in range(SIZE)]
    return Cloud(
        middle.mid(),
        arb_mat(SIZE, 2 * RATES, spread),
        arb_mat(SIZE, SIZE, frame),
        middle - middle.mid(),
    )


def _split(slopes: arb_mat) -> tuple[arb_mat, arb_mat]:
    rows = slopes.tolist()
    return arb_mat([row[:SIZE] for row in rows]), arb_mat([row[SIZE:] for row in rows])


def _orthogonal(columns: arb_mat, rest: arb_mat) -> arb_mat:
    """Columns (7, 7) at right angles, nearly, by Gram and Schmidt: the longest edge first.

    Any frame would do that has an inverse.
    """
    radii = [x.abs_upper() for x in rest.entries()]
    sides = zip(columns.transpose().tolist(), radii, strict=True)
    edges = [[x * r for x in column] for column, r in sides]
    order = sorted(range(SIZE), key=lambda j: -float(_dot(edges[j], edges[j]).mid()))
    found: list[list[arb]] = []
    for j in order:
        column = [row[j] for row in columns.tolist()]
        for other in found * 2:  # twice is enough (Kahan and Parlett)
            share = _dot(column, other)
            column = [(x - share * y).mid() for x, y in zip(column, other, strict=True)]
        length = _dot(column, column).sqrt()
        found.append([(x / length).mid() for x in column])
    return arb_mat(found).transpose()


def _dot(x: Sequence[arb], y: Sequence[arb]) -> arb:
    return sum((a * b for a, b in zip(x, y, strict=True)), arb(0)).mid()
