"""Condition numbers: what relative changes of the inputs make of a state, by its sensitivities.

Rates, moments and the time each change by so much of themselves, which a matrix (3, 7) turns into
the small turn of the attitude, in rad, and another into the change of the rates over |omega|.  The
condition is the length of the matrix (Frobenius): the root mean square of what independent changes
of one come to, and at most sqrt(3) times the most that changes of length one can.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction

import numpy as np
from flint import arb

from rigidsym.precise.balls import ball, power
from rigidsym.validate.strata import Sample

# Of `sensitivity.point.listed`: three numbers of the state move with six inputs after the three of
# the attitude at t = 0, and with the time.
_ROWS, _COLUMNS = 3, 9
_BLOCK = _ROWS * _COLUMNS


def condition(
    sample: Sample, omega: Sequence[Sequence[arb]], sensitivities: Sequence[Sequence[arb]]
) -> Mapping[str, np.ndarray]:
    """Of angle and of omega, (N,) each, by the rates (N, 3) and what `listed` has of each time.

    Infinite where it is beyond binary64.
    """
    inertia, omega0, _ = sample.exact
    given, rows = list(map(ball, (*omega0, *inertia))), []
    for time, rates, row in zip(sample.times, omega, sensitivities, strict=True):
        size = sum((power(x, 2) for x in rates), arb(0)).sqrt()
        inputs = [*given, ball(Fraction(time))]
        over = inputs if size.is_zero() else [x / size for x in inputs]
        rows.append([*_entries(row, 0, inputs), *_entries(row, 1, over)])
    turns, changes = np.split(np.array(rows).reshape(len(rows), -1), 2, axis=1)
    return {"angle": _lengths(turns), "omega": _lengths(changes)}


def _entries(row: Sequence[arb], k: int, inputs: Sequence[arb]) -> list[float]:
    """Of the matrix of small turns (k = 0) or of rates (1), by so much of the inputs (7)."""
    block, by_time = row[k * _BLOCK :], row[2 * _BLOCK + k * _ROWS :]
    return [
        float(slope * x)
        for i in range(_ROWS)
        for slope, x in zip(
            [*block[_COLUMNS * i + 3 : _COLUMNS * (i + 1)], by_time[i]], inputs, strict=True
        )
    ]


def _lengths(rows: np.ndarray) -> np.ndarray:
    """Of rows (N, k), safe from overflow."""
    largest = np.max(np.abs(rows), axis=1, initial=0.0)
    scale = np.where((largest > 0) & np.isfinite(largest), largest, 1.0)
    return scale * np.linalg.norm(rows / scale[:, None], axis=1)
