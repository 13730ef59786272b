"""Sensitivities by differences of states of many digits, and how far others are from them."""

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from mpmath import matrix, mpf, workdps

from rigidsym import TorqueFreeMotion
from rigidsym.sensitivity import Sensitivity

Numbers = Sequence[Fraction]


def differences(inertia: Numbers, omega0: Numbers, attitude0: Numbers, t: Fraction, step: int):
    """(6, 6): the small turn in space and the rates, by omega0 and the moments.

    Inputs move by 10^-step of their size, either way; the result has about as many digits.
    """
    digits = 2 * step + 50
    columns = matrix(6, 6)
    size = max(map(abs, omega0)) or Fraction(1)
    with workdps(digits + 10):
        for j in range(6):
            wide = (size if j < 3 else inertia[j - 3]) / Fraction(10) ** step
            ends = []
            for change in (wide, -wide):
                inputs = [*omega0, *inertia]
                inputs[j] += change
                motion = TorqueFreeMotion(inputs[3:], inputs[:3], attitude0, allow_nonphysical=True)
                ends.append(motion.precise(t, digits))
            over = mpf(2 * wide.numerator) / wide.denominator
            (q, rates), (other, slower) = ends
            # 2 dq conj(q) has the small turn as its vector part; at either end it is the same.
            for k, value in enumerate(_turn(q - other, (q + other) / 2)):
                columns[k, j] = value / over
            for k in range(3):
                columns[3 + k, j] = (rates[k] - slower[k]) / over
    return columns


def _turn(change, q):
    """2 dq conj(q), its vector part: in space."""
    w, x, y, z = change
    a, b, c, d = q
    return (
        2 * (-w * b + x * a - y * d + z * c),
        2 * (-w * c + x * d + y * a - z * b),
        2 * (-w * d - x * c + y * b + z * a),
    )


def errors(found: Sensitivity, true, inertia: Numbers, omega0: Numbers, t: Fraction) -> list[float]:
    """Return the error of each of the six columns, as a share of the column.

    Turns are times |omega0|, and a moment changes by itself: so all are rates.  Until the body has
    turned by 1 rad a column is taken to be no shorter than the change itself, and never shorter
    than 2^-300 of it.
    """
    size = float(sum(x * x for x in omega0)) ** 0.5 or 1.0
    least = 1.0 if abs(t) * size < 1 else 2.0**-300
    weights = [size] * 3 + [1.0] * 3
    rows = np.concatenate([found.attitude, found.rates])[:, 3:]
    shares = []
    for j in range(6):
        natural = least * (1.0 if j < 3 else size / float(inertia[j - 3]))
        column = [w * true[k, j] for k, w in enumerate(weights)]
        apart = [
            abs(w * float(rows[k, j]) - x)
            for k, (w, x) in enumerate(zip(weights, column, strict=True))
        ]
        shares.append(float(max(apart) / max(natural, *map(abs, column))))
    return shares
