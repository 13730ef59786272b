"""States of many motions with their sensitivities: the one door from fits to the solution."""

import numpy as np

from rigidsym.fitting.parameters import Point
from rigidsym.motion import propagate
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotation_vectors


def states(point: Point, times: np.ndarray, engine: str) -> tuple[np.ndarray, np.ndarray]:
    """q (..., N, 4), omega (..., N, 3) of the principal axes; NaN where there are none."""
    return propagate(point.moments, point.omega, times, point.attitude, engine=engine, errors="nan")


def sensitivities(
    point: Point, times: np.ndarray, engine: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The same, and how turn and rates go with (eta0, omega0, moments): (..., N, 6, 9)."""
    q, omega = states(point, times, engine)
    columns = []
    for k in range(9):
        unit = np.zeros(9)
        unit[k] = 1.0
        h = 1e-6 * [1.0, np.max(np.abs(point.omega)) + 1e-12, np.max(point.moments)][k // 3]
        ends = [
            Point(
                product(of_rotation_vectors(s * h * unit[:3]), point.attitude),
                point.omega + s * h * unit[3:6],
                point.moments + s * h * unit[6:],
                point.mount,
            )
            for s in (1, -1)
        ]
        (qa, wa), (qb, wb) = (
            propagate(
                p.moments, p.omega, times, p.attitude, engine=engine, errors="nan",
                allow_nonphysical=True,
            )
            for p in ends
        )  # fmt: skip
        eta = rotation_vectors(product(qa, conjugate(qb))) / (2 * h)
        columns.append(np.concatenate([eta, (wa - wb) / (2 * h)], axis=-1))
    return q, omega, np.stack(columns, axis=-1)
