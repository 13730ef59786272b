"""Conversion of attitudes and directions from the conventions of others."""

import numpy as np
from scipy.spatial.transform import Rotation

from rigidsym.errors import InputError
from rigidsym.fitting._observations import tangents

# Largest entry of R R^T - 1 that rounding in a file explains.
_ORTHONORMAL = 0.01


def quaternions(attitude: str, values: np.ndarray, lines: list[int]) -> np.ndarray:
    """Convert attitudes (N, k) of one form to quaternions (N, 4), scalar first.

    Euler angles i-j-k, rad, are R = R_i(angle1) R_j(angle2) R_k(angle3); matrices are given by
    rows.  lines (N,): the numbers of the lines they are from.  Raises InputError for matrices that
    are no rotations.
    """
    if attitude == "quaternion":
        return values
    if attitude == "quaternion-scalar-last":
        return np.roll(values, 1, axis=-1)
    if attitude == "matrix":
        matrices = values.reshape(-1, 3, 3)
        off = np.max(np.abs(matrices @ np.swapaxes(matrices, -2, -1) - np.eye(3)), axis=(-2, -1))
        volume = np.linalg.det(matrices)
        for k in np.flatnonzero(~((off < _ORTHONORMAL) & (volume > 0)))[:1]:
            rule = (
                f"is no rotation: R R^T differs from 1 by {off[k]:.2g}, det R is {volume[k]:.2g};"
            )
            rule += " check --columns r11=NAME,r12=NAME,…,r33=NAME"
            raise InputError(f"line {lines[k]}, r11 … r33", values[k].round(3).tolist(), rule)
        return Rotation.from_matrix(matrices).as_quat(scalar_first=True)
    axes = "".join("XYZ"[int(x) - 1] for x in attitude.removeprefix("euler"))
    return Rotation.from_euler(axes, values).as_quat(scalar_first=True)


def directions(longitude: np.ndarray, latitude: np.ndarray) -> np.ndarray:
    """Convert longitudes and latitudes, rad, or right ascensions and declinations, to vectors."""
    across = np.cos(latitude)
    parts = [across * np.cos(longitude), across * np.sin(longitude), np.sin(latitude)]
    return np.stack(parts, axis=-1)


def covariances(longitude: np.ndarray, latitude: np.ndarray, sigma: np.ndarray) -> np.ndarray:
    """Convert errors (N, 2) of longitude and latitude to covariances (N, 2, 2) of directions.

    Errors of longitude are those of the angle itself, and count cos(latitude) on the sphere.
    """
    east = np.stack([-np.sin(longitude), np.cos(longitude), np.zeros_like(longitude)], axis=-1)
    there = directions(longitude, latitude)
    turn = tangents(there) @ np.stack([east, np.cross(there, east)], axis=-1)
    sizes = sigma * np.stack([np.cos(latitude), np.ones_like(latitude)], axis=-1)
    return turn @ (sizes[:, :, None] ** 2 * np.eye(2)) @ np.swapaxes(turn, -2, -1)
