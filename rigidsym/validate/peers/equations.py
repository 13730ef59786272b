"""The equations of motion (3) and (5), as integrators take them."""

from collections.abc import Sequence
from typing import Any


def rates(y: Sequence[Any], c: Sequence[Any], half: Any = 0.5) -> list[Any]:
    """The right sides of (3) and (5): y is q, scalar first, then omega; c are the moments.

    Numbers of any kind, or heyoka's expressions; half is 1/2 as that kind has it.

    >>> rates([1.0, 0.0, 0.0, 0.0, 0.0, 0.5, 2.0], [1.0, 2.0, 3.0])
    [-0.0, 0.0, 0.25, 1.0, -1.0, 0.0, -0.0]
    """
    q0, q1, q2, q3, *w = y
    return [
        -half * (q1 * w[0] + q2 * w[1] + q3 * w[2]),
        half * (q0 * w[0] + q2 * w[2] - q3 * w[1]),
        half * (q0 * w[1] + q3 * w[0] - q1 * w[2]),
        half * (q0 * w[2] + q1 * w[1] - q2 * w[0]),
        *((c[k - 2] - c[k - 1]) / c[k] * w[k - 2] * w[k - 1] for k in range(3)),
    ]
