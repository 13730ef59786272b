"""Peers that integrate the equations of motion by SciPy or heyoka.

SciPy's methods are DOP853 and LSODA.
"""

import math
import warnings
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import States
from rigidsym.validate.peers._protocol import Start, checked, needed


def rates(y: Sequence[Any], c: Sequence[Any], half: Any = 0.5) -> list[Any]:
    """Return the time derivatives of a state by the equations of motion.

    These are (3) and (5) of the paper.  y is q, scalar first, then omega; c are the moments.  All
    are numbers of any kind, or heyoka's expressions; half is 1/2 of that kind.

    >>> rates([1.0, 0.0, 0.0, 0.0, 0.0, 0.5, 2.0], [1.0, 2.0, 3.0])
    [-0.0, 0.0, 0.25, 1.0, -1.0, 0.0, -0.0]
    """
    q0, q1, q2, q3, *w = y
    return [
        -half * (q1 * w[0] + q2 * w[1] + q3 * w[2]),
        half * (q0 * w[0] + q2 * w[2] - q3 * w[1]),
        half * (q0 * w[1] + q3 * w[0] - q1 * w[2]),
        half * (q0 * w[2] + q1 * w[1] - q2 * w[0]),
        *((c[k - 2] - c[k - 1]) / c[k] * w[k - 2] * w[k - 1] for k in range(3)),
    ]


class Integrator(ABC):
    """Abstract solver that integrates in one direction from t = 0."""

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Start:
        """Check the inputs of a motion, and normalise its quaternion."""
        return Start.of(inertia, omega0, attitude0)

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """Compute the states of a motion at times in any order.

        From the first row of `follow` that is missing or has no number, states are NaN.
        """
        t = checked(t)
        rows = np.tile(prepared.state, (t.size, 1))
        for sign in (1, -1):
            side = sign * t > 0
            times, places = np.unique(sign * t[side], return_inverse=True)
            if times.size:
                try:
                    found = self.follow(prepared, sign * times)
                except (ArithmeticError, ValueError, RuntimeError):
                    found = np.empty((0, 7))
                good = np.logical_and.accumulate(np.all(np.isfinite(found), axis=1))
                padded = np.full((times.size, 7), np.nan)
                padded[: good.sum()] = found[good]
                rows[side] = padded[places]
        return rows[:, :4], rows[:, 4:]

    @abstractmethod
    def follow(self, start: Start, times: np.ndarray) -> np.ndarray:
        """Integrate a motion from t = 0 in one direction of time.

        Returns rows (n, 7) of states at n times, each farther from zero than the one before.  There
        are fewer rows if the solver gets no farther or has an error of arithmetic, value or run
        time.
        """


# The farthest time of the short strata; 300 rad take some tenths of a second in Python.
_REACH = 300.0
# Of the right sides on one way: 300 rad took up to 31 000 of them.
_MOST_EVALUATIONS = 100_000
# The least that `solve_ivp` takes; from 1e-12 down, this is the most accurate.
_TOLERANCE = 100 * float(np.finfo(float).eps)


class ScipyPeer(Integrator):
    """Peer that uses one method of SciPy's `solve_ivp`.

    The relative tolerance is 2.2e-14.
    """

    reach, double_cover_sign = _REACH, True

    def __init__(self, method: str) -> None:
        self.name, self._method = method.lower(), method
        module, self.version = needed(self.name, "scipy.integrate", "scipy")
        self._solve = module.solve_ivp

    def follow(self, start: Start, times: np.ndarray) -> np.ndarray:
        """Integrate a motion by one call of `solve_ivp`."""
        size, left = math.hypot(*start.omega0) or 1.0, _MOST_EVALUATIONS

        def derivative(t: float, y: np.ndarray) -> list[float]:
            nonlocal left
            if not left:
                raise RuntimeError("the integrator gets nowhere")
            left -= 1
            # Python's own numbers are several times as fast as NumPy's.
            return rates(y.tolist(), start.inertia)

        # LSODA also warns of errors that it returns.
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            found = self._solve(
                derivative,
                (0.0, float(times[-1])),
                np.array(start.state),
                self._method,
                times,
                rtol=_TOLERANCE,
                atol=_TOLERANCE * np.array([1.0] * 4 + [size] * 3),
            )
        # An empty list where it fails before the first of the times.
        return np.reshape(found.y, (7, -1)).T


# heyoka takes 1.3 us for a radian of omega0 t.
_FAR = 1e4
# A step is about half a radian; it is never as short as a twentieth.
_MOST_STEPS = 20 * int(_FAR)


class HeyokaPeer(Integrator):
    """Peer that uses heyoka's `taylor_adaptive`, compiled once for all bodies.

    The tolerance is 1e-16, heyoka's best.  It is relative to the largest of q and omega: at
    fast rates q is less accurate.
    """

    name, reach, double_cover_sign = "heyoka", _FAR, True

    def __init__(self) -> None:
        heyoka, self.version = needed(self.name, "heyoka", "heyoka")
        moments = [heyoka.par[k] for k in range(3)]
        names = heyoka.make_vars("q0", "q1", "q2", "q3", "w1", "w2", "w3")
        system = list(zip(names, rates(names, moments), strict=True))
        blank = [1.0] + [0.0] * 6
        self._integrator = heyoka.taylor_adaptive(system, blank, tol=1e-16, pars=[1.0] * 3)

    def follow(self, start: Start, times: np.ndarray) -> np.ndarray:
        """Integrate a motion by one run of the compiled heyoka integrator."""
        self._integrator.time = 0.0
        self._integrator.pars[:] = start.inertia
        self._integrator.state[:] = start.state
        # The grid has to begin where the integrator is.
        grid = np.concatenate(([0.0], times))
        return self._integrator.propagate_grid(grid, max_steps=_MOST_STEPS)[-1][1:]
