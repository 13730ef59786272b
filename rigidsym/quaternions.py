"""Operations on arrays of quaternions with the scalar first.

Quaternions have the shape (..., 4) and vectors (..., 3); leading shapes broadcast.
"""

import numpy as np

# Below this angle sin x = x in binary64.
_TINY = 1e-8
# [e_k] times a vector is e_k x that vector.
_CROSS = np.cross(np.eye(3), np.eye(3)[:, None])


def product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the Hamilton product of two quaternions.

    >>> product(np.array([0.0, 1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0, 0.0]))
    array([0., 0., 0., 1.])
    """
    scalar = p[..., :1] * q[..., :1] - np.sum(p[..., 1:] * q[..., 1:], axis=-1, keepdims=True)
    vector = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + np.cross(p[..., 1:], q[..., 1:])
    return np.concatenate([scalar, vector], axis=-1)


def conjugate(q: np.ndarray) -> np.ndarray:
    """Return the conjugate of a quaternion, which is the inverse of a unit quaternion."""
    return q * [1.0, -1.0, -1.0, -1.0]


def rotated(q: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Rotate vectors by unit quaternions."""
    scalar, axis = q[..., :1], q[..., 1:]
    twice = 2 * np.cross(axis, vectors)
    return vectors + scalar * twice + np.cross(axis, twice)


def cross_matrices(vectors: np.ndarray) -> np.ndarray:
    """Return the skew-symmetric matrices of the cross product with given vectors.

    For vectors v (..., 3) they have the shape (..., 3, 3).
    """
    return np.tensordot(vectors, _CROSS, 1)


def matrices(q: np.ndarray) -> np.ndarray:
    """Convert unit quaternions to rotation matrices.

    Their shape is (..., 3, 3).
    """
    turn = cross_matrices(q[..., 1:])
    return np.eye(3) + 2 * q[..., :1, None] * turn + 2 * turn @ turn


def of_matrix(m: np.ndarray) -> np.ndarray:
    """Convert a rotation matrix to a unit quaternion whose scalar part is not negative.

    The root is taken of the largest of four squares (Shepperd, J. Guidance and Control 1, 1978).
    """
    k = int(np.argmax([np.trace(m), *np.diag(m)])) - 1
    if k < 0:
        q = np.array([1 + np.trace(m), m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])
    else:
        i, j = (k + 1) % 3, (k + 2) % 3
        q = np.empty(4)
        q[0], q[1 + k] = m[j, i] - m[i, j], 1 + m[k, k] - m[i, i] - m[j, j]
        q[1 + i], q[1 + j] = m[i, k] + m[k, i], m[j, k] + m[k, j]
    return np.copysign(1.0, q[0]) * q / np.linalg.norm(q)


def rotation_vectors(quaternions: np.ndarray) -> np.ndarray:
    """Convert unit quaternions to their shortest rotation vectors, in rad."""
    scalar, vector = quaternions[..., :1], quaternions[..., 1:]
    length = np.linalg.norm(vector, axis=-1, keepdims=True)
    half = np.arctan2(length, np.abs(scalar))
    ratio = np.where(length < _TINY, 1.0, half / np.where(length < _TINY, 1.0, length))
    return 2 * np.copysign(1.0, scalar) * ratio * vector


def inverse_left_jacobian(vectors: np.ndarray) -> np.ndarray:
    """Return the inverse left Jacobian matrices of rotation vectors.

    For vectors (..., 3) they have the shape (..., 3, 3).  It is the derivative of a rotation vector
    by a small rotation that follows it.

    Angles are below a whole turn, rad.  Source: Sola, Deray and Atchuthan, arXiv:1812.01537, (146).

    >>> inverse_left_jacobian(np.array([np.pi, 0.0, 0.0])).round(3)
    array([[ 1.   ,  0.   ,  0.   ],
           [ 0.   ,  0.   ,  1.571],
           [ 0.   , -1.571,  0.   ]])
    """
    angle = np.linalg.norm(vectors, axis=-1)[..., None, None]
    safe = np.where(angle == 0, 1.0, angle)
    cross = cross_matrices(vectors)
    across = np.where(angle == 0, 0.0, 1 - safe / 2 / np.tan(safe / 2))
    return np.eye(3) - cross / 2 + across / safe * (cross @ (cross / safe))


def of_rotation_vectors(vectors: np.ndarray) -> np.ndarray:
    """Convert rotation vectors, rad, to unit quaternions.

    >>> of_rotation_vectors(np.array([np.pi, 0.0, 0.0])).round(12)
    array([0., 1., 0., 0.])
    """
    half = np.linalg.norm(vectors, axis=-1, keepdims=True) / 2
    # NumPy's sinc has a factor pi.
    return np.concatenate([np.cos(half), np.sinc(half / np.pi) / 2 * vectors], axis=-1)
