"""SciPy's integrators: Dormand and Prince's method of order 8, and LSODA."""

import math
import warnings

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import States
from rigidsym.validate.peers.equations import rates
from rigidsym.validate.peers.initial_state import Start, both_ways
from rigidsym.validate.peers.protocol import needed

# The farthest time of the short strata; 300 rad take some tenths of a second in Python.
_REACH = 300.0
# Of the right sides on one way: 300 rad took up to 31 000 of them.
_MOST_EVALUATIONS = 100_000
# The least that `solve_ivp` takes, and of 1e-12 to this the one nearest to the truth.
_TOLERANCE = 100 * float(np.finfo(float).eps)


class ScipyPeer:
    """`solve_ivp` by one of its methods, at 2.2e-14 of unit quaternions and of |omega0|."""

    reach, double_cover_sign = _REACH, True

    def __init__(self, method: str) -> None:
        self.name, self._method = method.lower(), method
        module, self.version = needed(self.name, "scipy.integrate", "scipy")
        self._solve = module.solve_ivp

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Start:
        """See `Peer`."""
        return Start.of(inertia, omega0, attitude0)

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """See `Peer`."""
        return both_ways(prepared, t, lambda times: self._followed(prepared, times))

    def _followed(self, prepared: Start, times: np.ndarray) -> np.ndarray:
        size = math.hypot(*prepared.omega0) or 1.0
        # LSODA warns of what it reports, too.
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            found = self._solve(
                _Counted(prepared.inertia),
                (0.0, float(times[-1])),
                np.array(prepared.state),
                self._method,
                times,
                rtol=_TOLERANCE,
                atol=_TOLERANCE * np.array([1.0] * 4 + [size] * 3),
            )
        # An empty list where it fails before the first of the times.
        return np.reshape(found.y, (7, -1)).T


class _Counted:
    """The right sides for one body, a limited number of times."""

    def __init__(self, inertia: tuple[float, ...]) -> None:
        self._inertia, self._left = inertia, _MOST_EVALUATIONS

    def __call__(self, t: float, y: np.ndarray) -> list[float]:
        if not self._left:
            raise RuntimeError("the integrator gets nowhere")
        self._left -= 1
        # Python's own numbers are several times as fast as NumPy's.
        return rates(y.tolist(), self._inertia)
