"""Integration with automatic steps that meet a tolerance."""

from dataclasses import dataclass, replace

import numpy as np

from rigidsym.errors import PrecisionError
from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.splitting._panels import HopelessError, Panels, rounding
from rigidsym.splitting._stepping import Splitting, State
from rigidsym.splitting._trajectory import Mesh, Trajectory, run

# Error of the first run: at most _FIRST, rad, or the tolerance times _LOOSE to the power of the
# order.
_FIRST, _LOOSE = 0.02, 3.0
# Number of meshes, each finer than the one before, and halvings of the steps of each.
_MESHES, _HALVINGS = 4, 20
# Change of the start of the size of rounding, rad.
_NOTHING = 1e-15
# Difference between runs above which it does not show their order, rad.
_FAR = 0.1
# Steps of a span for a torque that is not smooth.
_COARSE = 128


def chosen(
    splitting: Splitting, start: State, times: np.ndarray, tolerance: float, stops: np.ndarray
) -> Trajectory:
    """Integrate with ever shorter steps until the estimated error meets the tolerance.

    The first run chooses its steps by local errors (`Panels`); each run after it halves them.  The
    error of a run is its difference from the one before, over the ratio at which these differences
    fall, less 1.  Where they fall too slowly, another first run is finer. stops: times at which
    steps begin anew, s, from times[0] to times[-1].  Raises PrecisionError with the reason where no
    step reaches the tolerance; its `trajectory` is the best.
    """
    if times.size == 1:
        return replace(run(splitting, start, times, Mesh(times.tolist(), [1.0])), error=0.0)
    if not start.omega.size:
        mesh = Mesh(stops[:-1].tolist(), np.diff(stops).tolist())
        return replace(run(splitting, start, times, mesh), error=0.0)
    return _Search(splitting, start, times, tolerance, stops).found()


@dataclass(slots=True)
class _Search:
    splitting: Splitting
    start: State
    times: np.ndarray
    tolerance: float
    stops: np.ndarray
    best: Trajectory | None = None
    is_stable: bool = False

    def found(self) -> Trajectory:
        """Return a trajectory whose estimated error is within the tolerance.

        Raises PrecisionError if none is found.
        """
        order = self.splitting.method.order
        first = max(self.tolerance, min(self.tolerance * _LOOSE**order, _FIRST))
        share = 1.0
        for _ in range(_MESHES):
            panels = Panels(self.splitting, self.start, self.stops, self.tolerance, first, share)
            self._refuse_rounding(1, panels)
            try:
                found = self._halved(self._run(panels), panels)
            except HopelessError as hopeless:
                self._follow_coarsely()
                raise self._refused(str(hopeless)) from None
            if found.error is not None and found.error <= self.tolerance:
                return found
            share *= min(self.tolerance / (4 * (found.error or 0)), 0.1)
        raise self._refused("runs with ever shorter steps do not come closer to each other")

    def _halved(self, last: Trajectory, panels: Panels) -> Trajectory:
        """Halve the steps of a run repeatedly, and return the last run.

        It is below the tolerance, or the runs do not converge as they should.
        """
        most, coarsest = 2.0**self.splitting.method.order, last
        ratio, before = min(panels.ratio, most), 0.0
        for k in range(_HALVINGS):
            count = self.splitting.evaluations
            last, other = self._run(last.mesh.halved), last
            apart, count = gap(other, last), self.splitting.evaluations - count
            least = rounding(count, panels.turned)
            if apart <= least:
                ratio = most
            elif k:
                ratio = min(before / apart, most)
            error = apart / (ratio - 1) if ratio > 2 else max(before, apart)
            error += least + panels.misplaced
            seen = {"order": float(np.log2(max(ratio, 1.0))), "rough": tuple(sorted(panels.rough))}
            last = replace(last, error=error, **seen)
            if self.best is None or error <= (self.best.error or 0):
                self.best = last
            # A single difference is only trusted near the tolerance.
            if error <= self.tolerance and (k or apart <= 8 * self.tolerance):
                # Jumps by the attitude have moved as far as the motion, away from short panels.
                moved = gap(coarsest, last) if panels.moves else 0.0
                if moved > self.tolerance:
                    last = self.best = replace(last, error=moved)
                return last
            self._refuse_rounding(count * (error / self.tolerance) ** (1 / np.log2(most)), panels)
            if ratio <= 2 or apart > _FAR:
                self._refuse_chaos(coarsest)
            if apart > _FAR or (k and ratio < most**0.5):
                break
            before = apart
        return last

    def _run(self, mesh: Mesh, start: State | None = None) -> Trajectory:
        return run(self.splitting, start or self.start, self.times, mesh)

    def _refuse_rounding(self, count: float, panels: Panels) -> None:
        """Raise PrecisionError if the rounding error of `count` kicks exceeds the tolerance."""
        least = rounding(count, panels.turned)
        if least > self.tolerance:
            if self.best is None:
                self._follow_coarsely()
            raise self._refused(f"rounding alone amounts to {least:.0e} rad")

    def _refuse_chaos(self, found: Trajectory) -> None:
        """Raise PrecisionError if rounding of the initial state grows beyond the tolerance."""
        if self.is_stable:
            return
        q, omega = self.start.q, self.start.omega
        turned = q + _NOTHING / 2 * q[..., [1, 0, 3, 2]] * [-1.0, 1.0, -1.0, 1.0]
        other = self._run(found.mesh, State(turned, omega * (1 + _NOTHING)))
        apart = gap(found, other)
        if apart > self.tolerance:
            raise self._refused(
                f"motions that begin {_NOTHING:.0e} rad apart are {apart:.1e} rad apart in the end"
            )
        self.is_stable = True

    def _follow_coarsely(self) -> None:
        """Integrate twice with equal steps, and keep the finer run as the best result so far."""
        fastest = np.max(np.linalg.norm(self.start.omega, axis=-1))
        lengths = np.diff(self.stops)
        steps = lengths / (_COARSE * np.ceil(1 + lengths * fastest / 8))
        coarse = self._run(Mesh(self.stops[:-1].tolist(), steps.tolist()))
        fine = self._run(coarse.mesh.halved)
        self.best = replace(fine, error=gap(coarse, fine), order=0.0)

    def _refused(self, reason: str) -> PrecisionError:
        refused = PrecisionError(f"tolerance = {self.tolerance:g}: no step reaches it: {reason}")
        if self.best:
            best = f"the best is {self.best.step:g} s with {self.best.error:.1e} rad"
            refused = PrecisionError(f"{refused}; {best}")
            vars(refused)["trajectory"] = self.best
        return refused


def gap(one: Trajectory, other: Trajectory) -> float:
    """Return the largest difference between the states of two trajectories.

    It is a rotation, rad, or a difference of rates as a part of the largest rate of that body.
    """
    turns = np.linalg.norm(rotation_vectors(product(conjugate(one.q), other.q)), axis=-1)
    rates = np.linalg.norm(one.omega - other.omega, axis=-1)
    sizes = np.max(np.linalg.norm(other.omega, axis=-1), axis=-1, keepdims=True)
    parts = np.divide(rates, sizes, out=np.zeros_like(rates), where=sizes > 0)
    return float(max(np.max(turns), np.max(parts)))
