"""Reference sensitivities by differences of precise states, and errors of sensitivities."""

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from rigidsym import TorqueFreeMotion
from rigidsym.precise._balls import ball, bits_of, working
from rigidsym.sensitivity import Sensitivity

Numbers = Sequence[Fraction]


def differences(
    inertia: Numbers, omega0: Numbers, attitude0: Numbers, times: Numbers, step: int, digits: int
) -> np.ndarray:
    """Return reference derivatives of the states by central differences.

    They are those of turn and rates (N, 6, 7) by omega0, the moments and the time.  Inputs are
    moved by 10^-step of their size, either way; states have `digits` digits.
    """

    def states(rates: Numbers, moments: Numbers, at: Numbers):
        motion = TorqueFreeMotion(moments, rates, attitude0, allow_nonphysical=True)
        return motion.enclose(at, digits)

    size, part = max(map(abs, omega0)) or Fraction(1), Fraction(1, 10**step)
    here, columns = states(omega0, inertia, times)[0], []
    for k in range(7):
        wide = part * (size if k < 3 else inertia[k - 3] if k < 6 else 1 / size)
        ends = []
        for change in (wide, -wide):
            given, moved = [*omega0, *inertia], change if k == 6 else 0
            if k < 6:
                given[k] += change
            ends.append(states(given[:3], given[3:], [t + moved for t in times]))
        columns.append(_quotients(*ends, here, 2 * wide, digits))
    return np.stack(columns, axis=-1)


def _quotients(after, before, here, step, digits):
    """Return the difference quotients of attitudes, as small turns in space, and of rates.

    They have the shape (N, 6); a small turn is 2 dq q*.
    """
    with working(bits_of(digits)):
        rows = []
        for (p, w), (q, v), r in zip(
            zip(*after, strict=True), zip(*before, strict=True), here, strict=True
        ):
            d = [(x - y) / ball(step) for x, y in zip(p, q, strict=True)]
            turn = [2 * (d[k] * r[0] - d[0] * r[k] - d[1 + k % 3] * r[1 + (k + 1) % 3]
                         + d[1 + (k + 1) % 3] * r[1 + k % 3]) for k in (1, 2, 3)]  # fmt: skip
            rows.append([*turn, *((x - y) / ball(step) for x, y in zip(w, v, strict=True))])
        return np.array([[float(x) for x in row] for row in rows])


def errors(
    found: Sensitivity, true: np.ndarray, inertia: Numbers, omega0: Numbers, t: Fraction
) -> np.ndarray:
    """Return the relative error of each of the six sensitivity columns.

    Turns are times |omega0|, and a moment changes by itself: so all are rates.  Until the body has
    turned by 1 rad a column is taken to be no shorter than the change itself, and never shorter
    than 2^-300 of it.
    """
    size = float(sum(x * x for x in omega0)) ** 0.5 or 1.0
    least = 1.0 if abs(t) * size < 1 else 2.0**-300
    weights = np.array([[size]] * 3 + [[1.0]] * 3)
    natural = least * np.array([1.0] * 3 + [size / float(c) for c in inertia])
    columns, rows = weights * true, weights * np.concatenate([found.attitude, found.rates])[:, 3:]
    return np.max(np.abs(rows - columns), axis=0) / np.maximum(
        natural, np.max(np.abs(columns), axis=0)
    )
