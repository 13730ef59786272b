"""Time steps of a splitting method for a batch of bodies."""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _engines as engines
from rigidsym._engines import arrays, batches
from rigidsym.errors import InputError
from rigidsym.quaternions import rotated
from rigidsym.splitting._methods import Method
from rigidsym.splitting._orbits import KeplerOrbit
from rigidsym.splitting._torques import DirectionTorque, Torque

# Kicks of bodies in one call of C, some hundredths of a second, after which Ctrl-C is handled.
_AT_ONCE = 1 << 18


@dataclass(slots=True)
class State:
    """Attitudes and body rates of bodies at one time.

    Their shapes are (..., 4) and (..., 3).
    """

    q: np.ndarray
    omega: np.ndarray


@dataclass(frozen=True, slots=True)
class Bodies:
    """Principal moments of bodies, and the engine that computes their free motion.

    inertia: (3,) for all, or of a shape that broadcasts with states.
    """

    inertia: np.ndarray
    engine: str

    def drift(self, state: State, dt: float) -> State:
        """Return the states of the bodies after a torque-free motion of dt seconds.

        States must have been checked before: they go straight to the engine, which takes less time
        than another check.
        """
        # Steps of NumPy take twice as long as its engine for one body alone.
        if self.engine == "c" or (self.engine == "numpy" and state.omega.ndim > 1):
            try:
                return self._stepped(state, dt)
            except engines.EngineError as error:
                # Some body turns further than a step goes, or is refused.
                if error.field != "dt":
                    raise _refused(error) from None
        found = self.drifts(state, np.array([dt]))
        return State(found.q[..., 0, :], found.omega[..., 0, :])

    def _stepped(self, state: State, dt: float) -> State:
        shape = state.omega.shape[:-1]
        rows = arrays.rows(state.q, shape), arrays.rows(state.omega, shape)
        q, omega = after = np.empty_like(rows[0]), np.empty_like(rows[1])
        moments = arrays.row_or_rows(self.inertia, shape)
        engines.stepper(self.engine).step(moments, *rows, np.array([dt]), after)
        return State(q.reshape(*shape, 4), omega.reshape(*shape, 3))

    def drifts(self, state: State, dt: np.ndarray) -> State:
        """Return the states of the bodies after torque-free motions of several durations.

        dt (M,), s; the states have the shapes (..., M, 4) and (..., M, 3).
        """
        moved = engines.engine(self.engine).propagate
        try:
            return State(*moved(self.inertia, state.omega, state.q, dt))
        except engines.EngineError as error:
            raise _refused(error) from None


def _refused(error: engines.EngineError) -> InputError:
    return InputError("torque", "its values so far", f"lead to what is refused, {error}")


@dataclass(slots=True)
class Splitting:
    """Bodies under a torque, with the splitting method that integrates their motion.

    Kicks change the momentum at fixed attitude.  By a torque of attitude and time they are exact;
    by a `rate_dependent` one they follow the Runge-Kutta method of order four. evaluations and
    probes: calls of the torque, in steps and between them.
    """

    bodies: Bodies
    torque: Torque
    method: Method
    rate_dependent: bool
    evaluations: int = field(default=0, init=False)
    probes: int = field(default=0, init=False)

    def advance(self, state: State, begin: float, step: float, first: int, last: int) -> State:
        """Advance the bodies by several steps of equal length.

        These are the steps number `first` to `last` of length `step`, s, counted from the time
        `begin`, s.  Drifts that follow each other are one.
        """
        if (kicks := self._compiled(state)) is not None:
            try:
                after = _advance_in_c(kicks, state, begin, step, (first, last))
            except engines.EngineError:
                # The loop below names the torque, or takes longer drifts than steps can.
                pass
            else:
                self.evaluations += len(kicks.kicks) * (last - first)
                return after
        return self._advanced(state, begin, step, first, last)

    def _compiled(self, state: State) -> engines.KickInputs | None:
        """Return the arguments of an integration in C, or None if C cannot compute this torque."""
        torque = self.torque
        in_c = self.bodies.engine == "c" and not self.rate_dependent
        if not in_c or not isinstance(torque, DirectionTorque):
            return None
        shape, source = state.omega.shape[:-1], torque.source
        on_orbit = isinstance(source, KeplerOrbit)
        return engines.KickInputs(
            inertia=arrays.row_or_rows(self.bodies.inertia, shape),
            coefficients=arrays.row_or_rows(torque.coefficients, shape),
            vector=None if on_orbit else arrays.row_or_rows(source, shape),
            orbit=source.numbers if on_orbit else None,
            drifts=np.array(self.method.drifts),
            kicks=np.array(self.method.kicks),
            more=torque.more,
        )

    def _advanced(self, state: State, begin: float, step: float, first: int, last: int) -> State:
        drifts, kicks = self.method.drifts, self.method.kicks
        pending = 0.0
        for k in range(first, last):
            into = 0.0
            for drift, kick in zip(drifts, kicks, strict=False):
                state = self.bodies.drift(state, (pending + drift) * step)
                pending, into = 0.0, into + drift
                state = self._kicked(state, begin + (k + into) * step, kick * step)
            pending = drifts[-1]
        return self.bodies.drift(state, pending * step) if pending else state

    def _kicked(self, state: State, t: float, dt: float) -> State:
        """Change the rates by a torque that acts for dt seconds at fixed attitude and time."""
        q, omega = state.q, state.omega
        k1 = self.acceleration(t, q, omega)
        if not self.rate_dependent:
            return State(q, omega + dt * k1)
        k2 = self.acceleration(t, q, omega + dt / 2 * k1)
        k3 = self.acceleration(t, q, omega + dt / 2 * k2)
        k4 = self.acceleration(t, q, omega + dt * k3)
        return State(q, omega + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4))

    def acceleration(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the torque divided by the moments of inertia, in rad/s^2.

        Raises InputError for an invalid torque.
        """
        self.evaluations += 1
        return _checked(self.torque(t, q, omega), t, omega.shape) / self.bodies.inertia

    def probe(self, times: np.ndarray, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Evaluate the torque at times between kicks, N m in inertial axes.

        The result has the shape (M, ..., 3) for times (M,). q, omega: attitudes (..., M, 4) and
        rates (..., M, 3).  Raises InputError for a torque that is not finite.
        """
        self.probes += times.size
        found = [
            self._probed(t, State(q[..., k, :], omega[..., k, :]))
            for k, t in enumerate(times.tolist())
        ]
        return rotated(np.moveaxis(q, -2, 0), np.array(found))

    def _probed(self, t: float, state: State) -> np.ndarray:
        if (kicks := self._compiled(state)) is not None:
            # Bodies at rest have, after a kick of a second, the rates that the torque gives them.
            alone = replace(kicks, drifts=np.zeros(2), kicks=np.ones(1))
            resting = State(state.q, np.zeros_like(state.omega))
            try:
                after = _advance_in_c(alone, resting, t, 1.0, (0, 1))
            except engines.EngineError:
                pass
            else:
                return self.bodies.inertia * after.omega
        # A copy: a torque may return the same array each time.
        return _checked(self.torque(t, state.q, state.omega), t, state.omega.shape).copy()


def _checked(torque: ArrayLike, t: float, shape: tuple[int, ...]) -> np.ndarray:
    """Convert the value of a torque to an array of finite numbers.

    Raises InputError for a wrong shape, and for numbers that are not finite.
    """
    array = batches.array("torque", torque, lenient=True)
    if array.shape != shape:
        rule = f"must be of shape {shape}, as omega is (t = {t:.17g} s)"
        raise InputError("torque", f"an array of shape {array.shape}", rule)
    if np.isfinite(array).all():
        return array
    for place in np.argwhere(~np.isfinite(array))[:1]:
        *body, axis = map(int, place)
        where = f"body {', '.join(map(str, body))}, " if body else ""
        raise InputError(
            f"torque[{axis}]", array[tuple(place)], f"must be finite ({where}t = {t:.17g} s)"
        )
    return array


def _advance_in_c(
    found: engines.KickInputs, state: State, begin: float, step: float, numbers: tuple[int, int]
) -> State:
    """Take whole steps by the compiled C library.

    Raises EngineError if the engine refuses.
    """
    shape, (first, last) = state.omega.shape[:-1], numbers
    q, omega = (np.array(arrays.rows(x, shape)) for x in (state.q, state.omega))
    integrator = engines.integrator()
    if integrator is None:
        raise engines.EngineError("engine", "has no compiler")
    some = max(1, _AT_ONCE // (len(q) * len(found.kicks)))
    for start in range(first, last, some):
        span = begin, step, start, min(start + some, last)
        integrator.integrate(found, span, q, omega)
    return State(q.reshape(*shape, 4), omega.reshape(*shape, 3))
