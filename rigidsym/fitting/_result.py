"""Fitted motions, with their periods and predictions."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from rigidsym._frames import RATES, dataframe
from rigidsym.fitting._parameters import Point
from rigidsym.motion import TorqueFreeMotion
from rigidsym.solution._polhode import Mode

if TYPE_CHECKING:
    from pandas import DataFrame


@dataclass(frozen=True, slots=True)
class Periods:
    """The periods of a tumbling body, in s, as astronomers define them.

    None stands for no period.

    Attributes
    ----------
    rotation : float or None
        Period of the rates, in which a long-axis mode turns once about the long axis, and in which
        the long axis of a short-axis mode rolls to and fro.
    precession : float or None
        Mean period in which the circulation axis goes round the momentum.
    """

    rotation: float | None
    precession: float | None


def periods(motion: TorqueFreeMotion) -> Periods:
    """Return the periods of rotation and precession of a motion.

    Constant rates have one period, that of the turn, which is returned as the precession.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion.

    Returns
    -------
    Periods
        Rotation and precession, s.
    """
    rotation, mean = motion.period, motion.precession_rate
    if mean is None or mean == 0:
        return Periods(None, None)
    if rotation is None or not math.isfinite(rotation) or motion.mode is None:
        return Periods(None, 2 * math.pi / abs(mean))
    # The body turns about its momentum by psi and about its circulation axis by phi: in one period
    # of the rates they differ by a whole turn, in opposite senses for the two modes.
    turn = 2 * math.pi / rotation
    rate = mean - turn if motion.mode is Mode.LONG_AXIS else mean + turn
    return Periods(rotation, 2 * math.pi / abs(rate) if rate else math.inf)


@dataclass(frozen=True, slots=True)
class Prediction:
    """Predicted attitudes and rates of the observed axes, with their covariance.

    Attributes
    ----------
    q : (..., 4)
        Attitudes.
    omega : (..., 3)
        Rates, rad/s.
    covariance : (..., 6, 6)
        Covariance of a small turn along inertial axes, rad, and of the rates, rad/s.
    t : (...)
        Times, s.
    """

    q: np.ndarray
    omega: np.ndarray
    covariance: np.ndarray
    t: np.ndarray

    @property
    def attitude_sigma(self) -> np.ndarray:
        """Return the standard deviation of the attitude about its most uncertain axis, in rad."""
        return np.sqrt(np.linalg.eigvalsh(self.covariance[..., :3, :3])[..., -1])

    def to_dataframe(self) -> "DataFrame":
        """Return the prediction as a pandas DataFrame with the times as its index.

        Its columns are q0 ... q3, omega1 ... omega3, attitude_sigma (rad), and omega1_sigma ...
        omega3_sigma (rad/s).  Needs pandas.
        """
        rates = np.sqrt(np.diagonal(self.covariance, axis1=-2, axis2=-1)[..., 3:])
        errors = {f"{name}_sigma": np.atleast_1d(x) for name, x in zip(RATES, rates.T, strict=True)}
        sigma = np.atleast_1d(self.attitude_sigma)
        q, omega = np.atleast_2d(self.q), np.atleast_2d(self.omega)
        return dataframe(self.t, q, omega, False, attitude_sigma=sigma, **errors)


@dataclass(frozen=True, eq=False)
class Alternative:
    """One of several motions that may fit the observations, with its chi2.

    `point` is its state at the epoch of the problem.
    """

    motion: TorqueFreeMotion
    point: Point
    chi2: float

    @property
    def mount(self) -> np.ndarray:
        """Return the rotation (4,) from the principal axes to the observed axes."""
        return self.point.mount

    @property
    def mode(self) -> Mode | None:
        """Return the mode of the motion, as `TorqueFreeMotion.mode` does."""
        return self.motion.mode

    @cached_property
    def periods(self) -> Periods:
        """Return the periods of rotation and precession, in s."""
        return periods(self.motion)

    @property
    def moments(self) -> np.ndarray:
        """Return the moments of inertia (3,).

        They are in kg m^2, or in units of the largest.
        """
        return np.array(self.motion.exact["inertia"], float)
