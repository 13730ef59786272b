"""Enclosures of a motion and of its derivatives by all inputs, from the equations of motion alone.

No formula of the ledger is used: the equations are integrated by `_models.solve`.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from flint import arb

from rigidsym._numbers._models import Model, solve
from rigidsym._numbers._motions import Motion
from rigidsym.precise._balls import ball

# The longest step: the sum of the absolute rates times the time.
LONGEST = 1.0
LEAST, HALF = 0.25, arb(1) / 2
INPUTS = ("Omega1", "Omega2", "Omega3", "c1", "c2", "c3")


def euler(factors: Sequence[Any]) -> Any:
    """Return the right side of w_i' = k_i w_j w_k."""
    return lambda w, _: [factor * (w[i - 2] * w[i - 1]) for i, factor in enumerate(factors)]


def product(p: Sequence[Any], q: Sequence[Any]) -> list[Any]:
    """Return the product of two quaternions."""
    (a, b, c, d), (e, f, g, h) = p, q
    return [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g + c * e + d * f - b * h,
        a * h + d * e + b * g - c * f,
    ]


def conjugate(q: Sequence[Any]) -> list[Any]:
    """Return the conjugate of a quaternion."""
    return [q[0], *(-x for x in q[1:])]


def cross(x: Sequence[Any], y: Sequence[Any]) -> list[Any]:
    """Return the vector product."""
    return [x[i - 2] * y[i - 1] - x[i - 1] * y[i - 2] for i in range(3)]


def kinematics(q: Sequence[Any], half: Sequence[Any]) -> list[Any]:
    """Return q' = q (0, w)/2, by half of the rates w."""
    (a, b, c, d), (x, y, z) = q, half
    return [
        -(b * x + c * y + d * z),
        a * x + c * z - d * y,
        a * y + d * x - b * z,
        a * z + b * y - c * x,
    ]


def rotated(q: Sequence[Any], v: Sequence[Any]) -> list[Any]:
    """Return the vector of space that a vector of the body is, R v."""
    return product(product(q, [0 * v[0], *v]), conjugate(q))[1:]


@dataclass
class Course:
    """Values along a motion up to a time: the state and what is integrated beside it.

    `by_input` has the derivatives of the rates, `turned` the small turns of the body in space, by
    each of `INPUTS`; `sums` and `squares` are integrals of the rates and of their squares; `swung`
    """

    time: arb
    omega: list[arb]
    middle: list[arb]
    slack: arb = field(default_factory=lambda: arb(0))
    by_input: dict[str, list[arb]] = field(default_factory=dict)
    turned: dict[str, list[arb]] = field(default_factory=dict)
    sums: list[arb] = field(default_factory=lambda: [arb(0)] * 3)
    squares: list[arb] = field(default_factory=lambda: [arb(0)] * 3)

    @property
    def q(self) -> list[arb]:
        """The unit quaternion."""
        return [x + arb(0, self.slack) for x in self.middle]


class Flow:
    """The flow of Euler's equations and of q' = q (0, Omega)/2 for one body."""

    def __init__(self, motion: Motion) -> None:
        self.motion = motion
        self.c = list(map(ball, motion.inertia))
        self.factors = [(self.c[i - 2] - self.c[i - 1]) / self.c[i] for i in range(3)]
        self.omega0, self.q0 = list(map(ball, motion.omega0)), list(map(ball, motion.attitude0))

    def after(self, time: Fraction | arb, *, varied: bool = False, summed: bool = False) -> Course:
        """Return the course up to a time, with derivatives or with integrals where asked."""
        return self.path(ball(time), varied=varied, summed=summed)[-1]

    def path(self, time: arb, *, varied: bool = False, summed: bool = True) -> list[Course]:
        """Return the courses up to times not far apart, from 0 to a time."""
        course = Course(arb(0), self.omega0, self.q0)
        if varied:
            course.by_input = {
                x: [arb(int(x == f"Omega{i + 1}")) for i in range(3)] for x in INPUTS
            }
            course.turned = {x: [arb(0)] * 3 for x in INPUTS}
        path, sign = [course], 1 if time > 0 else -1
        while True:
            left = time - path[-1].time
            longest = LONGEST / max(float(sum(map(abs, path[-1].omega), arb(0))), LEAST)
            last = float(abs(left)) <= longest
            step = left if last else sign * arb(longest)
            path.append(self._step(path[-1], step, varied, summed or varied))
            if last:
                return path

    def slopes(self, omega: Sequence[arb]) -> list[arb]:
        """Return the derivatives of the rates by the time."""
        return euler(self.factors)(omega, ())

    def _step(self, course: Course, step: arb, varied: bool, summed: bool) -> Course:
        w = solve(euler(self.factors), course.omega, step)
        p = solve(kinematics, [arb(1), arb(0), arb(0), arb(0)], step, [x * HALF for x in w])
        turn = [x.end() for x in p]
        q = product(course.middle, turn)
        rounded = sum((x.rad() ** 2 for x in q), arb(0)).sqrt()
        size = sum((x * x for x in turn), arb(0)).sqrt()
        slack = (course.slack * size + rounded).upper()
        middle = [x.mid() for x in q]
        following = Course(course.time + step, [x.end() for x in w], middle, slack)
        if summed:
            following.sums = _added(course.sums, w)
            following.squares = _added(course.squares, [x * x for x in w])
        if varied:
            rows = _rotation(product(course.q, p))
            for name in INPUTS:  # the small turn has the rate R dOmega
                column = self._varied(name, course.by_input[name], step, w)
                following.by_input[name] = [x.end() for x in column]
                x, y, z = column
                turning = [row[0] * x + row[1] * y + row[2] * z for row in rows]
                following.turned[name] = _added(course.turned[name], turning)
        return following

    def _varied(self, name: str, start: list[arb], step: arb, w: list[Model]) -> list[Model]:
        """Return the derivative of the rates by one input."""
        slopes = [self._slope(i, name) for i in range(3)]
        forced = [slope * (w[i - 2] * w[i - 1]) for i, slope in enumerate(slopes)]

        def right(v: Sequence[Any], given: Sequence[Any]) -> list[Any]:
            w, more = given[:3], given[3:] or [0] * 3
            return [
                self.factors[i] * (v[i - 2] * w[i - 1] + w[i - 2] * v[i - 1]) + more[i]
                for i in range(3)
            ]

        return solve(right, start, step, [*w, *forced] if name.startswith("c") else w)

    def _slope(self, i: int, name: str) -> arb:
        """Return the derivative of a factor of Euler's equations by one input."""
        if not name.startswith("c"):
            return arb(0)
        k = int(name[1:]) - 1
        if k == i:
            return -self.factors[i] / self.c[i]
        return (1 if k == (i - 2) % 3 else -1) / self.c[i]


def _added(before: Sequence[arb], rates: Sequence[Model]) -> list[arb]:
    return [x + rate.integral().end() for x, rate in zip(before, rates, strict=True)]


def _rotation(q: Sequence[Model]) -> list[list[Model]]:
    """Return the rotation matrix of a unit quaternion, from body to space."""
    a, *v = q
    rows = [[v[i] * v[j] * 2 for j in range(3)] for i in range(3)]
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        rows[i][i] = rows[i][i] + a * a * 2 - 1
        rows[i][j] = rows[i][j] - a * v[k] * 2
        rows[j][i] = rows[j][i] + a * v[k] * 2
    return rows
