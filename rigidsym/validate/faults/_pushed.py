"""Motions under torques, which show faults of kicks, orbits, and the order of drifts and kicks."""

from dataclasses import dataclass

import numpy as np

from rigidsym._engines import KickInputs, States
from rigidsym._engines.steps import CStepper, NumpyStepper
from rigidsym.splitting import METHODS, KeplerOrbit, integrate
from rigidsym.splitting._torques import DirectionTorque
from rigidsym.validate._implementations import Steps
from rigidsym.validate.strata import Sample

# Far below the change of rates by a torque, and far above rounding.
_BOUND = 1e-11
_BODIES, _STEP, _FIRST, _LAST = 3, 0.1, 200, 206
_METHOD = "aba84"
_TILTED = {"inclination": 0.4, "node": 1.0, "argument": 2.0, "epoch": 0.5}
_SOURCES = (
    np.array([[0.1, 0.3, 1.0], [1.0, -0.2, 0.4], [-0.3, 0.5, 0.2]]),
    *(KeplerOrbit(30.0, 1.5, e, **_TILTED) for e in (0.0, 0.6, 1.6)),
)
# b, k, m and Q of each body, all different.
_COEFFICIENTS = np.sin(np.arange(13.0 * _BODIES)).reshape(_BODIES, 13) / 20


@dataclass(frozen=True, slots=True)
class PushedReference:
    """Bodies like that of a sample, with their states under torques as Python integrates them."""

    sample: Sample
    inertia: np.ndarray
    q: np.ndarray
    omega: np.ndarray
    expected: tuple[States, ...]

    @classmethod
    def of(cls, sample: Sample) -> "PushedReference":
        """Integrate the motions of three bodies of moderate moments and rates."""
        moments, rates, attitude = (
            np.array(x, float) / np.max(np.abs(np.array(x, float)), initial=1e-300)
            for x in (sample.inertia, sample.omega0, sample.attitude0)
        )
        inertia = 0.4 + 0.3 * np.array([np.roll(moments, k) for k in range(_BODIES)])
        q = np.tile(attitude / np.linalg.norm(attitude), (_BODIES, 1))
        omega = rates * np.linspace(0.5, 1.0, _BODIES)[:, None]
        times = np.array([_FIRST, _LAST]) * _STEP
        expected = []
        for source in _SOURCES:
            torque = DirectionTorque(source, _COEFFICIENTS)
            found = integrate(
                inertia, q, omega, torque, times, method=_METHOD, step=_STEP, engine="numpy"
            )
            expected.append((found.q[:, -1], found.omega[:, -1]))
        return cls(sample, inertia, q, omega, tuple(expected))

    def is_missed(self, engine: Steps) -> bool:
        """Return True if an engine's torques, or its states under them, are not those expected."""
        stepper = engine.stepper
        if isinstance(stepper, NumpyStepper):
            given = self.q, _SOURCES[0], _COEFFICIENTS
            expected = DirectionTorque(*given[1:])(0.0, self.q, self.omega)
            return not np.allclose(stepper._module.torque(*given), expected, 0, _BOUND)
        assert isinstance(stepper, CStepper)
        return not all(
            np.allclose(one, other, 0, _BOUND)
            for source, states in zip(_SOURCES, self.expected, strict=True)
            for one, other in zip(self._integrated(stepper, source), states, strict=True)
        )

    def _integrated(self, stepper: CStepper, source: np.ndarray | KeplerOrbit) -> States:
        is_orbit = isinstance(source, KeplerOrbit)
        kicks = KickInputs(
            self.inertia,
            _COEFFICIENTS,
            None if is_orbit else source,
            source.numbers if is_orbit else None,
            np.array(METHODS[_METHOD].drifts),
            np.array(METHODS[_METHOD].kicks),
        )
        q, omega = self.q.copy(), self.omega.copy()
        stepper.integrate(kicks, (0.0, _STEP, _FIRST, _LAST), q, omega)
        return q, omega
