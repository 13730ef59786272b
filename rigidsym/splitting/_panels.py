"""Adaptive time meshes, refined by local errors and by the smoothness of the torque.

A mesh is chosen panel by panel.  A panel is covered by 1, 2, 4 and at most 32 steps.  It is
accepted when the differences of these decrease and are small, and when the torque, probed along the
panel, is smooth there and its integral is the impulse of the kicks.  Otherwise it is divided:
around a jump or kink where the probes show one, else in the middle.  So no pulse is stepped over,
and steps are short only where they have to be.
"""

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.splitting._stepping import Splitting, State
from rigidsym.splitting._torques import DirectionTorque
from rigidsym.splitting._trajectory import Mesh

# The longest step tried, of the fastest body, rad; the one accepted is a quarter of it, or less.
_LONGEST = 4.0
# Steps in a panel: at most 2 to this power.
_LEVELS = 5
# Probes of a block, at Chebyshev's points, and blocks in the whole run: narrower pulses than some
# three probes, 1/200 of the run, may be missed.
_DEGREE, _BLOCKS = 16, 64
# Number of the last Chebyshev coefficients, which are small for a smooth torque.
_LAST = 4
# Blocks of bodies that are probed at once, some hundred megabytes.
_AT_ONCE = 1 << 17
# Ratio of a second difference to the median of its neighbours that indicates a jump or kink.
_OUTLIER = 6.0
# Relative rounding error of a few steps.
_ROUNDING = 2.0**-50
# Slower bodies are at rest, rad/s.
_REST = 1e-150
# Number of panels from which the total number is estimated.
_FEW = 64
# Length of a short panel, relative to a turn of the body or the run.  _NOISE short panels in a row
# without a smooth torque are noise; _ROW in a row are hopeless if a turn would take _HOPELESS.
_SHORT, _NOISE, _ROW, _HOPELESS = 2.0**-8, 64, 64, 2.0**18

_ANGLES = np.pi * np.arange(_DEGREE, -1, -1) / _DEGREE
_POINTS = (1 + np.cos(_ANGLES)) / 2
_TO_COEFFICIENTS = np.linalg.inv(np.polynomial.chebyshev.chebvander(2 * _POINTS - 1, _DEGREE))
# Integrals of Chebyshev's polynomials over [0, 1].
_INTEGRALS = np.array([0.0 if k % 2 else 1 / (1 - k * k) for k in range(_DEGREE + 1)])
_WEIGHTS = _INTEGRALS @ _TO_COEFFICIENTS

Path = Callable[[np.ndarray], State]
Panel = tuple[float, float]


def rounding(count: float, turned: float) -> float:
    """Estimate the accumulated rounding error of an integration, in rad.

    count: number of kicks; turned: angle by which a body turns, rad.

    >>> 1e-15 < rounding(100.0, 1.0) < 1e-14
    True
    """
    return 2.0**-53 * float(np.sqrt(count)) * (2 + turned)


class HopelessError(ArithmeticError):
    """Error of an integration in which no step size reaches the tolerance.

    The message has the reason.
    """


class Panels(Mesh):
    """Time mesh whose intervals (panels) are chosen one after the other during a run.

    stops: ends of panels, (P + 1,), s, rising; first: the error of all panels together, rad;
    tolerance: a bound of those errors that shorter steps would not reduce by the method's order;
    share: the part of both that is used.
    """

    def __init__(
        self,
        splitting: Splitting,
        start: State,
        stops: np.ndarray,
        tolerance: float,
        first: float,
        share: float,
    ) -> None:
        super().__init__([], [])
        self._splitting = splitting
        torque = splitting.torque
        self._is_steady = isinstance(torque, DirectionTorque) and torque.is_steady
        self._tolerance = tolerance
        self._first, self._unseen = share * first, share * tolerance / 4
        self._begin, self._end = float(stops[0]), float(stops[-1])
        self._span = self._end - self._begin
        self._least = max(2.0**-40 * self._span, 64 * float(np.spacing(np.max(np.abs(stops)))))
        self._ahead = list(pairwise(stops.tolist()))[::-1]
        self._rates = _lengths(start.omega)
        self._least_moment = np.min(splitting.bodies.inertia, axis=-1)
        self._row_begin, self._in_row, self._not_smooth = float(stops[0]), 0, 0
        self.rough: list[float] = []
        self.moves = False
        self.turned = self._kicks = self.misplaced = 0.0
        self.differences = np.zeros(2)

    @property
    def ratio(self) -> float:
        """The factor by which the errors of all intervals decrease when steps are halved."""
        coarse, fine = self.differences
        return float(coarse / fine) if fine else np.inf

    def interval(self, t: float, state: State) -> Panel:
        """Choose the interval that begins at t, and return its end and step size, in s.

        Raises HopelessError, and whatever the torque raises.
        """
        while True:
            begin, end = self._ahead.pop()
            found = self._judged(begin, end, state)
            if not isinstance(found, list):
                self._accept(begin, end, found, state)
                return end, found
            self._ahead += [(a, b) for a, b in pairwise(found) if b > a][::-1]

    def _accept(self, begin: float, end: float, step: float, state: State) -> None:
        self.edges.append(begin)
        self.steps.append(step)
        self.turned += float(np.max(_lengths(state.omega))) * (end - begin)
        self._kicks += (end - begin) / step * len(self._splitting.method.kicks)
        part = max((end - self._begin) / self._span, float(np.finfo(float).tiny))
        # The last run has more steps than this one, by the root of the order.
        more = (self._first / self._tolerance) ** (1 / self._splitting.method.order)
        whole = rounding(more * self._kicks / part, self.turned / part)
        is_far = len(self.edges) > _FEW and whole > 2 * self._tolerance
        if is_far or rounding(self._kicks, self.turned) > self._tolerance:
            raise HopelessError(f"rounding alone amounts to {whole:.0e} rad")

    def _judged(self, begin: float, end: float, state: State) -> float | list[float]:
        """Return the step size for an acceptable interval, or else times that divide it."""
        length, middle = end - begin, [begin, (begin + end) / 2, end]
        is_last = length <= self._least
        fastest = float(np.max(_lengths(state.omega)))
        bodies = state.omega.size // 3
        is_long = fastest * length > _LONGEST or self._blocks(length) > max(1, _AT_ONCE // bodies)
        if is_long and not is_last:
            return middle
        self._rates = np.maximum(self._rates, _lengths(state.omega))
        try:
            with np.errstate(all="ignore"):
                found = self._step(begin, end, state)
        except HopelessError:
            raise
        except Exception:
            # Too long a step may drive the rates beyond all bounds.  The panel is halved so that
            # the states before a failure of the torque are kept.
            if is_last:
                raise
            return middle
        if is_last and (found is None or isinstance(found, list)):
            found = length / 2**_LEVELS or length
        return middle if found is None else found

    def _step(self, begin: float, end: float, state: State) -> float | list[float] | None:
        """Find a step size with which the splitting method is accurate on a time interval.

        Returns the step, or the edges of parts around a jump or kink, or None if the panel must be
        halved.
        """
        length = end - begin
        blocks = self._blocks(length)
        ends = [self._by(begin, length, state, level) for level in (0, 1)]
        if np.max(_lengths(ends[1].omega)) * length > 4 * _LONGEST:
            return None
        path = self._path(begin, length, state, ends[1])
        # Chebyshev's points of all blocks, (M,), and torques there, (M, ..., 3).
        points = (np.arange(blocks)[:, None] + _POINTS[:-1]).ravel()
        times = begin + length * np.append(points, blocks) / blocks
        torques = self._at(path, times)
        weight = self._weights(begin, torques, times)
        unseen = self._unseen * (length / self._span + 1 / _BLOCKS)
        unseen += _ROUNDING * float(np.max(1 + _lengths(state.omega) * self._reach(begin)))
        unseen += _ROUNDING * float(np.max(np.abs(torques) * weight)) * length
        tails = _tails(torques * weight, length / blocks)
        worst = int(np.argmax(tails))
        if not tails[worst] <= unseen:
            some = slice(_DEGREE * worst, _DEGREE * (worst + 1) + 1)
            found = self._located(path, times[some], torques[some], weight, unseen)
            if found is None:
                return None
            self.rough.append(sum(found) / 2)
            return [begin, found[0], min(found[1], end), end]
        # The integral of the torque over all blocks, (..., 3), N m s.
        firsts = torques[:-1].reshape(-1, _DEGREE, *torques.shape[1:])
        inner = np.tensordot(_WEIGHTS[:-1], firsts, (0, 1))
        impulse = length / blocks * np.sum(inner + _WEIGHTS[-1] * torques[_DEGREE::_DEGREE], axis=0)
        differences = [self._apart(*ends, begin)]
        allowed = self._first * length / self._span + unseen
        for level in range(2, _LEVELS + 1):
            ends.append(self._by(begin, length, state, level))
            differences.append(self._apart(*ends[-2:], begin))
            before, last = differences[-2:]
            ratio = min(before / last if last else np.inf, 2.0**self._splitting.method.order)
            error = max(before, last) if ratio < 2 else last / (ratio - 1)
            if not error <= (unseen if ratio < 2 else allowed):
                if not ratio >= 2 or error / allowed > ratio ** (_LEVELS - level):
                    return None
                continue
            step = length / 2**level or length
            kicked = self._kicked(path, begin, step, 2**level)
            if not np.max(_lengths((kicked - impulse) * weight)) <= max(unseen, 8 * last):
                return None
            self._count(end, length, state, torques)
            self.differences += before, last
            return step
        return None

    def _blocks(self, length: float) -> int:
        return 1 if self._is_steady else int(np.ceil(_BLOCKS * length / self._span))

    def _count(self, end: float, length: float, state: State, torques: np.ndarray) -> None:
        """Count consecutive short intervals, and raise HopelessError if there are too many."""
        turn = _LONGEST / max(float(np.max(_lengths(state.omega))), _LONGEST / self._span)
        if length > _SHORT * turn:
            self._row_begin, self._in_row, self._not_smooth = end, 0, 0
            return
        varies = np.ptp(torques, axis=0).max() - 1e-12 * np.abs(torques).max()
        self._in_row += 1
        self._not_smooth += bool(varies > 0 and _tails(torques, 1.0)[0] > 0.02 * varies)
        if self._not_smooth > _NOISE:
            raise HopelessError(f"the torque is not smooth anywhere near t = {end:.6g} s")
        if self._in_row > _ROW and turn / (end - self._row_begin) * self._in_row > _HOPELESS:
            raise HopelessError(f"the torque varies within {length:.0e} s near t = {end:.6g} s")

    def _by(self, begin: float, length: float, state: State, level: int) -> State:
        return self._splitting.advance(state, begin, length / 2**level, 0, 2**level)

    def _apart(self, one: State, other: State, begin: float) -> float:
        """Estimate the final error of a run from two states at the end of an interval."""
        turns = _lengths(rotation_vectors(product(conjugate(one.q), other.q)))
        return float(np.max(turns + _lengths(one.omega - other.omega) * self._reach(begin)))

    def _reach(self, begin: float) -> np.ndarray:
        """Return the sensitivity of the final error to a change of the rates, in s.

        It turns the body until the end of the run, and it is a part of the body's rates.
        """
        parts = np.divide(
            1.0, self._rates, out=np.zeros_like(self._rates), where=self._rates > _REST
        )
        return self._end - begin + parts

    def _path(self, begin: float, length: float, state: State, after: State) -> Path:
        """Return a function that interpolates the states within a time interval.

        It goes from the free motion before the panel to the free motion after it.
        """

        def path(times: np.ndarray) -> State:
            drifts = self._splitting.bodies.drifts
            part = ((times - begin) / length)[:, None]
            one, other = drifts(state, times - begin), drifts(after, times - (begin + length))
            sign = np.copysign(1.0, np.sum(one.q * other.q, axis=-1, keepdims=True))
            q = (1 - part) * one.q + part * sign * other.q
            return State(
                q / np.linalg.norm(q, axis=-1, keepdims=True),
                (1 - part) * one.omega + part * other.omega,
            )

        return path

    def _at(self, path: Path, times: np.ndarray) -> np.ndarray:
        states = path(times)
        return self._splitting.probe(times, states.q, states.omega)

    def _weights(self, begin: float, torques: np.ndarray, times: np.ndarray) -> np.ndarray:
        """Return the sensitivity of the final error to an impulse, in rad/(N m s).

        It has the shape (..., 1).  This also updates the largest rates of the bodies.
        """
        means = (torques[1:] + torques[:-1]) / 2 * _along(np.diff(times), torques)
        gained = np.max(_lengths(np.cumsum(means, axis=0)), axis=0) / self._least_moment
        self._rates = np.maximum(self._rates, gained)
        return (self._reach(begin) / self._least_moment)[..., None]

    def _kicked(self, path: Path, begin: float, step: float, count: int) -> np.ndarray:
        """Return the sum of the kicks of `count` steps along a path of states, in N m s.

        It has the shape (..., 3).
        """
        method = self._splitting.method
        into = (np.arange(count)[:, None] + np.cumsum(method.drifts[:-1])).ravel()
        kicks, found = np.tile(method.kicks, count), np.zeros(3)
        some = max(1, _DEGREE * _AT_ONCE // self._rates.size)
        for first in range(0, into.size, some):
            part = slice(first, first + some)
            torques = self._at(path, begin + step * into[part])
            found = found + np.tensordot(kicks[part], torques, 1)
        return step * found

    def _is_moving(self, path: Path, times: np.ndarray, steps: float, weight: np.ndarray) -> bool:
        """Return True if a jump or kink of the torque depends on the attitude, not on the time.

        It is then not seen at three times with the state of the first.
        """
        first = path(times[[0, 0, 0]])
        found = np.diff(self._splitting.probe(times, first.q, first.omega), 2, axis=0)
        return bool(_lengths(found * weight).max() < steps / 2)

    def _located(
        self, path: Path, times: np.ndarray, torques: np.ndarray, weight: np.ndarray, unseen: float
    ) -> Panel | None:
        """Find a short interval of time that contains a jump or kink of the torque.

        The interval is too short to matter.  Returns None where there is no jump or kink.
        """
        while True:
            # Second divided differences of the worst body, (M - 2,).
            slopes = np.diff(torques * weight, axis=0) / _along(np.diff(times), torques)
            curves = np.diff(slopes, axis=0) / _along(times[2:] - times[:-2], torques)
            bends = np.max(_lengths(curves).reshape(len(curves), -1), axis=1)
            k = int(np.argmax(bends))
            if not bends[k] > _OUTLIER * np.median(bends):
                return None
            part = float(times[k]), float(times[k + 2])
            steps = _lengths(np.diff(torques[k : k + 3], 2, axis=0) * weight).max()
            if (part[1] - part[0]) * steps <= unseen / 4 or part[1] - part[0] <= self._least:
                # Runs of any step have the jump at the same wrong time.
                self.misplaced += (part[1] - part[0]) * float(steps)
                if not self.moves:
                    self.moves = self._is_moving(path, times[k : k + 3], steps, weight)
                return part
            times = np.linspace(*part, _DEGREE + 1)
            torques = self._at(path, times)


def _lengths(vectors: np.ndarray) -> np.ndarray:
    return np.linalg.norm(vectors, axis=-1)


def _along(numbers: np.ndarray, array: np.ndarray) -> np.ndarray:
    """Append axes of length 1 to a vector so that it broadcasts along an array's first axis."""
    return numbers.reshape(-1, *[1] * (array.ndim - 1))


def _tails(torques: np.ndarray, length: float) -> np.ndarray:
    """Return the size of the highest Chebyshev coefficients of the torques in each block.

    It is the largest one over all bodies, times the length.
    """
    count = (len(torques) - 1) // _DEGREE
    blocks = np.array([torques[_DEGREE * k : _DEGREE * (k + 1) + 1] for k in range(count)])
    last = np.tensordot(_TO_COEFFICIENTS[-_LAST:], blocks, (1, 1))
    return length * np.max(_lengths(last).reshape(_LAST, count, -1), axis=(0, 2))
