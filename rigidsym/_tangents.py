"""Changes of quaternions as small rotations in space, for arrays of any library.

`xp` is jax.numpy, torch or numpy.  Quaternions are scalar first, (..., 4); rotations are vectors
(..., 3), rad.
"""

from typing import Any


def rotation(xp: Any, change: Any, q: Any) -> Any:
    """Return the small rotation that a change of a quaternion amounts to.

    It is the vector part of 2 change q^-1.  The quaternion may have any length but zero; a change
    along the quaternion itself is no rotation, because quaternions are normalised.
    """
    unit, scale = _scaled(xp, q)
    vector = unit[..., :1] * change[..., 1:] - change[..., :1] * unit[..., 1:]
    return 2 * scale * (vector + xp.linalg.cross(unit[..., 1:], change[..., 1:]))


def change(xp: Any, rotation: Any, q: Any) -> Any:
    """Return the change of a quaternion by a small rotation: (0, rotation) q / 2."""
    scalar = -(rotation * q[..., 1:]).sum(-1)
    vector = q[..., :1] * rotation + xp.linalg.cross(rotation, q[..., 1:])
    # PyTorch's older vmap has no concatenation.
    return 0.5 * xp.stack([scalar, *(vector[..., k] for k in range(3))], axis=-1)


def transposed_rotation(xp: Any, gradient: Any, q: Any) -> Any:
    """Return a gradient by a quaternion of any length, from that by its small rotation."""
    unit, scale = _scaled(xp, q)
    return 4 * scale * change(xp, gradient, unit)


def transposed_change(xp: Any, gradient: Any, q: Any) -> Any:
    """Return a gradient by a small rotation, from that by the unit quaternion that it changes."""
    return rotation(xp, gradient, q) / 4


def _scaled(xp: Any, q: Any) -> tuple[Any, Any]:
    """Return q over its largest entry, and the number by which this times q^-1 is the conjugate.

    Scaled so, the square of the length is a double.
    """
    size = xp.amax(xp.abs(q), axis=-1, keepdims=True)
    unit = q / size
    return unit, 1 / (size * (unit * unit).sum(-1)[..., None])
