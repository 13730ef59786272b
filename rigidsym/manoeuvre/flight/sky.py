"""Where the Sun stands, how the Earth is turned, and its magnetic field along an orbit."""

import warnings
from collections.abc import Generator
from contextlib import contextmanager
from datetime import datetime

import erfa
import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight.earth import ASTRONOMICAL_UNIT

DAY = 86400.0


def terrestrial_time(epoch: datetime, t: np.ndarray) -> tuple[float, np.ndarray]:
    """Two-part Julian dates (TT) of the times t (N,) s after an epoch in UTC."""
    with _without_doubt():
        first, second = erfa.utctai(*_utc(epoch))
    return erfa.taitt(first, second + np.asarray(t) / DAY)


def _utc(epoch: datetime) -> tuple[float, float]:
    seconds = epoch.second + 1e-6 * epoch.microsecond
    date = (epoch.year, epoch.month, epoch.day, epoch.hour, epoch.minute, seconds)
    with _without_doubt():
        return erfa.dtf2d("UTC", *date)


@contextmanager
def _without_doubt() -> Generator[None]:
    """Years before 1960 or to come have unsure leap seconds, some an unsure Sun: no matter."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", erfa.ErfaWarning)
        yield


def sun_position(epoch: datetime, t: np.ndarray) -> np.ndarray:
    """Of the Sun from the Earth's middle, inertial, m, (N, 3), as it is at the times t (N,).

    The aberration of its light, 20 arc seconds, is left out.
    """
    with _without_doubt():
        heliocentric, _ = erfa.epv00(*terrestrial_time(epoch, t))
    return -ASTRONOMICAL_UNIT * heliocentric["p"]


def earth_turn(epoch: datetime, t: np.ndarray) -> np.ndarray:
    """Rotations (N, 3, 3), inertial to Earth-fixed, by precession, nutation and the Earth's angle.

    UT1 is taken as UTC (15 arc seconds at most) and the polar motion (half of one) as none.
    """
    whole, part = _utc(epoch)
    universal = (whole, part + np.asarray(t) / DAY)
    return erfa.c2t06a(*terrestrial_time(epoch, t), *universal, 0.0, 0.0)


def magnetic_field(epoch: datetime, t: np.ndarray, position: np.ndarray) -> np.ndarray:
    """The Earth's field (IGRF), inertial, T, (N, 3), at inertial positions (N, 3) in m.

    Raises InputError for an epoch that the field's coefficients do not cover.
    """
    import ppigrf

    instant = epoch.replace(tzinfo=None)
    covered = ppigrf.ppigrf.read_shc()[0].index
    if not covered[0] <= instant <= covered[-1]:
        years = f"from {covered[0].year} to {covered[-1].year}"
        raise InputError("orbit.epoch", epoch.isoformat(), f"the Earth's field is known {years}")
    turn = earth_turn(epoch, t)
    fixed = np.einsum("nij,nj->ni", turn, position)
    radius = np.linalg.norm(fixed, axis=1)
    colatitude = np.arccos(fixed[:, 2] / radius)
    longitude = np.arctan2(fixed[:, 1], fixed[:, 0])
    parts = ppigrf.igrf_gc(radius / 1e3, np.degrees(colatitude), np.degrees(longitude), instant)
    local = 1e-9 * np.stack([part[0] for part in parts], axis=1)
    axes = _local_axes(colatitude, longitude)
    return np.einsum("nji,nj->ni", turn, np.einsum("nkj,nk->nj", axes, local))


def _local_axes(colatitude: np.ndarray, longitude: np.ndarray) -> np.ndarray:
    """Unit vectors upwards, southwards and eastwards as rows (N, 3, 3), Earth-fixed."""
    c, s = np.cos(colatitude), np.sin(colatitude)
    cosine, sine, none = np.cos(longitude), np.sin(longitude), np.zeros_like(longitude)
    rows = ((s * cosine, s * sine, c), (c * cosine, c * sine, -s), (-sine, cosine, none))
    return np.moveaxis(np.array(rows), -1, 0)
