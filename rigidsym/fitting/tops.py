"""Symmetric tops that attitudes show: a grid of precession and rotation rates, solved in batch.

Of a symmetric top R(t) = A Rz(W t) Ry(theta) Rz(psi(t)) P, where P takes the symmetry axis to z.
For a rate W of precession the axis goes round a cone: a linear regression gives A and theta.  What
is left is an angle psi, and a rate w of rotation shows in how far psi - w t is constant.  By the
momentum, moments across and along the axis have the ratio 1 + w / (W cos theta): above 1 for
long-axis modes, from 1/2 to 1 for short-axis modes, and no body has less.  Source: Samarasinha and
A'Hearn, Icarus 93 (1991), 194-225.
"""

from dataclasses import dataclass

import numpy as np

from rigidsym.quaternions import matrices

# Bodies near 1/2 are let in with what noise makes of it, as flat ones.
_LEAST, _FLAT, _NEEDLE = 0.4, 0.52, 50.0


@dataclass(frozen=True, slots=True)
class Tops:
    """B of them: rates omega (B, 3) at the time asked for, along the axes observed; `axis` (B,),
    which of the frames has the symmetry axis for its z; ratio (B,) of moments; misfit (B,)."""

    omega: np.ndarray
    axis: np.ndarray
    ratio: np.ndarray
    misfit: np.ndarray


def tops(q: np.ndarray, t: np.ndarray, at: float, frames: np.ndarray, rates: np.ndarray) -> Tops:
    """All tops on a grid that a body can be, from attitudes q (N, 4) at times t (N,).

    at: when rates are wanted.  frames (F, 4): quaternions from the axes observed to axes with the
    symmetry axis as z.  rates (G,): of precession, and both ways of rotation, rad/s, above zero.
    """
    seen = matrices(q) @ np.swapaxes(matrices(frames), -2, -1)[:, None]
    turn, tilt, cone = _cones(seen[..., 2], t - at, rates)
    angles = _angles(seen, turn, tilt, t - at, rates)
    both = np.concatenate([-rates[::-1], rates])
    waves = np.exp(1j * angles) @ np.exp(-1j * np.outer(t - at, both)) / t.size
    shape = waves.shape
    misfit = cone[..., None] + 2 * (1 - np.abs(waves))
    with np.errstate(divide="ignore"):
        ratio = 1 + both / (rates[:, None] * np.cos(tilt)[..., None])
    good = (ratio > _LEAST) & np.isfinite(misfit)
    omega = _omega(np.angle(waves), tilt, rates, both)
    omega = np.einsum("fji,fgwj->fgwi", matrices(frames), omega)
    axis = np.broadcast_to(np.arange(shape[0])[:, None, None], shape)
    return Tops(omega[good], axis[good], np.clip(ratio[good], _FLAT, _NEEDLE), misfit[good])


def moments(ratio: np.ndarray) -> np.ndarray:
    """(B, 3), along frames whose z is the symmetry axis."""
    return np.stack([ratio, ratio, np.ones_like(ratio)], axis=-1)


def _cones(
    axes: np.ndarray, t: np.ndarray, rates: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of axes (F, N, 3) in space and each rate: A (F, G, 3, 3), theta (F, G), misfit (F, G)."""
    phase = rates[:, None] * t
    waves = np.stack([np.ones_like(phase), np.cos(phase), np.sin(phase)], axis=-1)
    inverse = np.linalg.pinv(waves)
    columns = np.einsum("gkn,fni->fgik", inverse, axes)
    left = axes[:, None] - np.einsum("fgik,gnk->fgni", columns, waves)
    centre, one, other = np.moveaxis(columns, -1, 0)
    x, z = _unit(one), _unit(np.cross(one, other))
    tilt = np.arctan2(
        (np.linalg.norm(one, axis=-1) + np.linalg.norm(other, axis=-1)) / 2,
        np.sum(centre * z, axis=-1),
    )
    turn = np.stack([x, np.cross(z, x), z], axis=-1)
    return turn, tilt, np.mean(np.sum(left**2, axis=-1), axis=-1)


def _unit(vectors: np.ndarray) -> np.ndarray:
    with np.errstate(invalid="ignore", divide="ignore"):
        return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _angles(
    seen: np.ndarray, turn: np.ndarray, tilt: np.ndarray, t: np.ndarray, rates: np.ndarray
) -> np.ndarray:
    """psi (F, G, N): the turn about z that is left."""
    about_z = matrices(_quaternion(2, rates[:, None] * t))
    about_y = matrices(_quaternion(1, tilt))
    before = turn[:, :, None] @ about_z @ about_y[:, :, None]
    left = np.swapaxes(before, -2, -1) @ seen[:, None]
    return np.arctan2(left[..., 1, 0] - left[..., 0, 1], left[..., 0, 0] + left[..., 1, 1])


def _quaternion(axis: int, angle: np.ndarray) -> np.ndarray:
    found = np.zeros((*angle.shape, 4))
    found[..., 0], found[..., 1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
    return found


def _omega(psi: np.ndarray, tilt: np.ndarray, rates: np.ndarray, both: np.ndarray) -> np.ndarray:
    """W along the momentum and w along z, in the frame: (F, G, 2 G, 3)."""
    across, along = np.sin(tilt)[..., None], np.cos(tilt)[..., None] + np.zeros_like(psi)
    momentum = np.stack([-across * np.cos(psi), across * np.sin(psi), along], axis=-1)
    found = rates[:, None, None] * momentum
    found[..., 2] += both
    return found
