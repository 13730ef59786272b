"""A box as six flat panels."""

import numpy as np

from rigidsym.manoeuvre.flight.rotation import cross
from rigidsym.manoeuvre.flight.settings import Triple


class Box:
    """Edges `size` (m) along the body axes, its middle `offset` (m) from the centre of mass."""

    def __init__(self, size: Triple, offset: Triple) -> None:
        x, y, z = size
        self._half = 0.5 * np.array(size)
        self._areas = np.array([y * z, z * x, x * y])
        self._offset = np.array(offset)

    def facing(self, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Of the three faces that look towards a unit vector (3,), a row for each axis:

        their areas as seen from there (3,) in m^2, the cosines to their normals (3,), and the
        signs (3,) of these normals along the axes.
        """
        signs = np.where(direction >= 0, 1.0, -1.0)
        cosines = signs * direction
        return self._areas * cosines, cosines, signs

    def torque(self, forces: np.ndarray, signs: np.ndarray) -> np.ndarray:
        """Of forces (3, 3), a row for each face, at the middles of the faces with these normals."""
        total = forces[0] + forces[1] + forces[2]
        arms = (signs * self._half)[:, None] * forces
        # The sum of e_k x (row k): what is not symmetric.
        (_, xy, xz), (yx, _, yz), (zx, zy, _) = arms.tolist()
        return cross(self._offset, total) + np.array([yz - zy, zx - xz, xy - yx])
