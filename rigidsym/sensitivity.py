"""The class `Sensitivity`, which has derivatives with respect to a motion's inputs."""

from dataclasses import dataclass

import numpy as np

from rigidsym.errors import InputError


@dataclass(frozen=True, slots=True, eq=False)
class Sensitivity:
    """Derivatives of states with respect to the inputs of a motion.

    In shapes, ... is the shape of the bodies, then of the times.

    The columns of `attitude` and `rates` are by the small rotation at t = 0 (3, rad), omega0 (3,
    rad/s) and the principal moments (3, kg m^2), in the order of the inputs.

    Parameters
    ----------
    attitude : array (..., 3, 9)
        Derivatives of the attitude as a small rotation eta, a vector in space, rad: the matrix from
        body to space changes by [eta] times itself.
    rates : array (..., 3, 9)
        Derivatives of the body rates, rad/s.
    attitude_t, rates_t : array (..., 3)
        Derivatives of both by the time, rad/s and rad/s^2.
    columns : tuple
        The names of the columns, always in the order "attitude0", "omega0", "inertia", "t".  With
        only some of them, attitude and rates have three columns for each of the first three names
        among them, and attitude_t and rates_t are (..., 0) without "t".
    """

    attitude: np.ndarray
    rates: np.ndarray
    attitude_t: np.ndarray
    rates_t: np.ndarray
    columns: tuple[str, ...] = ("attitude0", "omega0", "inertia", "t")

    @property
    def transition(self) -> np.ndarray:
        """The state transition matrix from t = 0, for a small rotation and the body rates.

        Its shape is (..., 6, 6).  Raises InputError without the columns of attitude0 and omega0.
        """
        if not {"attitude0", "omega0"} <= {*self.columns}:
            rule = "a transition needs those of attitude0 and omega0"
            raise InputError("columns", ", ".join(self.columns), rule)
        return np.concatenate([self.attitude[..., :6], self.rates[..., :6]], axis=-2)
