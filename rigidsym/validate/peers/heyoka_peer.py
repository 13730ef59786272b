"""heyoka: Taylor's method at the precision of doubles, compiled for the machine."""

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import States
from rigidsym.validate.peers.equations import rates
from rigidsym.validate.peers.initial_state import Start, both_ways
from rigidsym.validate.peers.protocol import needed

# It takes 1.3 us for a radian of omega0 t.
_REACH = 1e4
# A step is about half a radian; it is never as short as a twentieth.
_MOST_STEPS = 20 * int(_REACH)


class HeyokaPeer:
    """`taylor_adaptive` at 1e-16, its best; compiled once, for all bodies, as it is made.

    The tolerance is of the largest of q and omega: at fast rates q gets less than its share.
    """

    name, reach, double_cover_sign = "heyoka", _REACH, True

    def __init__(self) -> None:
        heyoka, self.version = needed(self.name, "heyoka", "heyoka")
        moments = [heyoka.par[k] for k in range(3)]
        names = heyoka.make_vars("q0", "q1", "q2", "q3", "w1", "w2", "w3")
        system = list(zip(names, rates(names, moments), strict=True))
        blank = [1.0] + [0.0] * 6
        self._integrator = heyoka.taylor_adaptive(system, blank, tol=1e-16, pars=[1.0] * 3)

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Start:
        """See `Peer`."""
        return Start.of(inertia, omega0, attitude0)

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """See `Peer`."""
        return both_ways(prepared, t, lambda times: self._followed(prepared, times))

    def _followed(self, prepared: Start, times: np.ndarray) -> np.ndarray:
        self._integrator.time = 0.0
        self._integrator.pars[:] = prepared.inertia
        self._integrator.state[:] = prepared.state
        # The grid has to begin where the integrator is.
        grid = np.concatenate(([0.0], times))
        return self._integrator.propagate_grid(grid, max_steps=_MOST_STEPS)[-1][1:]
