"""What the state of a motion changes by with each of its inputs."""

from dataclasses import dataclass

import numpy as np

from rigidsym.errors import InputError


@dataclass(frozen=True, slots=True, eq=False)
class Sensitivity:
    """Derivatives of the state at some times; ... is the shape of the times, after that of bodies.

    attitude (..., 3, 9): a small turn eta of the attitude, as a vector in space, rad: the matrix
    from body to space changes by [eta] times itself.  rates (..., 3, 9): the body rates, rad/s.
    Their columns: the small turn at t = 0 (3, rad), omega0 (3, rad/s) and the principal moments
    (3, kg m^2), in the order in which they are given.  attitude_t, rates_t (..., 3): both by the
    time, rad/s and rad/s^2.

    columns: the names of those that there are, always in this order.  Where only some were asked
    for, attitude and rates have three columns for each of the first three names among them, and
    attitude_t and rates_t are (..., 0) without "t".
    """

    attitude: np.ndarray
    rates: np.ndarray
    attitude_t: np.ndarray
    rates_t: np.ndarray
    columns: tuple[str, ...] = ("attitude0", "omega0", "inertia", "t")

    @property
    def transition(self) -> np.ndarray:
        """(..., 6, 6): the small turn and the rates by those at t = 0.

        Raises InputError without the columns of attitude0 and omega0.
        """
        if not {"attitude0", "omega0"} <= {*self.columns}:
            rule = "a transition needs those of attitude0 and omega0"
            raise InputError("columns", ", ".join(self.columns), rule)
        return np.concatenate([self.attitude[..., :6], self.rates[..., :6]], axis=-2)
