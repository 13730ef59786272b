"""Observations that come with the package: radar data of Toutatis and a simulated T-handle."""

import csv
from collections.abc import Collection
from dataclasses import dataclass
from importlib import resources

import numpy as np
from scipy.spatial.transform import Rotation

from rigidsym.errors import InputError
from rigidsym.io import _epochs as epochs

TOUTATIS_EPOCH = "1992-12-02T00:00:00"
"The epoch of its times, in UTC."
YEARS = (1992, 1996, 2000, 2004, 2008)
# Standard deviations of angles in the paper, deg.
_EARLY, _LATE, _LATE_FROM = 15.0, 20.0, 2004


@dataclass(frozen=True, slots=True, eq=False)
class RadarObservations:
    """Radar observations of a body, as attitudes and spin vectors.

    dates: in UTC; times (N,), s; q (N, 4): body to inertial; omega (N, 3): rad/s along the body's
    axes; sigma (N,): standard deviations by which the paper weights attitudes, rad.
    """

    dates: tuple[str, ...]
    times: np.ndarray
    q: np.ndarray
    omega: np.ndarray
    sigma: np.ndarray


def text(name: str) -> str:
    """Return the text of a data file of the package."""
    return resources.files("rigidsym.fitting").joinpath("data", name).read_text("utf-8")


def toutatis(years: Collection[int] = (1992,)) -> RadarObservations:
    """Return the radar observations of asteroid (4179) Toutatis from given years.

    Source: Takahashi, Busch and Scheeres, The Astronomical Journal 146:95 (2013), table 3; see the
    head of data/toutatis.csv on its transcription.  Each year is a motion of its own, because tidal
    torques at flybys, most of all in 2004, change it.

    Parameters
    ----------
    years : collection of int
        Some of YEARS.

    Returns
    -------
    RadarObservations
        The observations of these years.

    Raises
    ------
    InputError
        For other years.
    """
    for year in years:
        if year not in YEARS:
            raise InputError("years", year, f"must be of: {', '.join(map(str, YEARS))}")
    lines = (x for x in text("toutatis.csv").splitlines() if not x.startswith("#"))
    rows = list(csv.DictReader(lines))
    rows = [row for row in rows if int(row["date"][:4]) in years]
    zero = epochs.parse("epoch", TOUTATIS_EPOCH, "UTC")
    ticks = [epochs.parse("date", row["date"], "UTC") - zero for row in rows]
    angles, rates = (
        np.array([[float(row[name]) for name in names] for row in rows])
        for names in (("alpha", "beta", "gamma"), ("omega1", "omega2", "omega3"))
    )
    late = np.array([int(row["date"][:4]) >= _LATE_FROM for row in rows])
    return RadarObservations(
        tuple(row["date"] for row in rows),
        np.array([tick / epochs.SECOND for tick in ticks]),
        Rotation.from_euler("ZXZ", angles, degrees=True).as_quat(scalar_first=True),
        np.deg2rad(rates) / 86400,
        np.deg2rad(np.where(late, _LATE, _EARLY)),
    )
