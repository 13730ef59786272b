"""Symmetric tops that fit attitudes: a grid of precession and rotation rates, solved in batch.

A symmetric top has R(t) = A Rz(W t) Ry(theta) Rz(psi(t)) P, where P takes the symmetry axis to z.
At a precession rate W the axis describes a cone: a linear regression gives A and theta.  The angle
psi remains, and a rotation rate w fits if psi - w t is nearly constant.  By the momentum, moments
across and along the axis have the ratio 1 + w / (W cos theta): above 1 for long-axis modes, from
1/2 to 1 for short-axis modes; no body has less.  Source: Samarasinha and A'Hearn, Icarus 93
(1991), 194-225.
"""

from dataclasses import dataclass

import numpy as np

from rigidsym.fitting._rotations import about
from rigidsym.quaternions import matrices

# The least ratio of moments, below 1/2 because of noise; ratios are then kept between the others.
_LEAST, _FLAT, _NEEDLE = 0.4, 0.52, 50.0


@dataclass(frozen=True, slots=True)
class Tops:
    """B symmetric tops: rates, symmetry axes, ratios of moments, and misfits.

    omega (B, 3): at the time asked for, along the observed axes; axis (B,): index of the frame
    that has the symmetry axis for its z; ratio (B,): of moments; misfit (B,).
    """

    omega: np.ndarray
    axis: np.ndarray
    ratio: np.ndarray
    misfit: np.ndarray


def tops(q: np.ndarray, t: np.ndarray, at: float, frames: np.ndarray, rates: np.ndarray) -> Tops:
    """Return all tops of a grid that a body can be, from attitudes q (N, 4) at times t (N,).

    at: the time of the rates. frames (F, 4): quaternions from the observed axes to axes with the
    symmetry axis as z. rates (G,): of precession, and both ways of rotation, rad/s, positive.
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


def _cones(
    axes: np.ndarray, t: np.ndarray, rates: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fit cones to axes (F, N, 3) in space; return A (F, G, 3, 3), theta and misfit (F, G)."""
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
    """Return psi (F, G, N), the remaining turn about z."""
    about_z = matrices(about(2, rates[:, None] * t))
    about_y = matrices(about(1, tilt))
    before = turn[:, :, None] @ about_z @ about_y[:, :, None]
    left = np.swapaxes(before, -2, -1) @ seen[:, None]
    return np.arctan2(left[..., 1, 0] - left[..., 0, 1], left[..., 0, 0] + left[..., 1, 1])


def _omega(psi: np.ndarray, tilt: np.ndarray, rates: np.ndarray, both: np.ndarray) -> np.ndarray:
    """Return rates (F, G, 2 G, 3) in the frame: W along the momentum plus w along z."""
    across, along = np.sin(tilt)[..., None], np.cos(tilt)[..., None] + np.zeros_like(psi)
    momentum = np.stack([-across * np.cos(psi), across * np.sin(psi), along], axis=-1)
    found = rates[:, None, None] * momentum
    found[..., 2] += both
    return found
