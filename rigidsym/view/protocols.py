"""What pictures ask of what they show; `TorqueFreeMotion` and flights are such things."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Protocol, Unpack

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.inputs import MotionInputs
from rigidsym.solution.polhode import Regime


class Motion(Protocol):
    """A motion: its exact numbers, its regime, and states at times."""

    @property
    def exact(self) -> Mapping[str, tuple[Fraction, ...]]:
        """Inertia, omega0 and attitude0."""
        ...

    @property
    def regime(self) -> Regime:
        """The kind of motion."""
        ...

    def __call__(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Attitude and body rates, (N, 4) and (N, 3) at N times in s."""
        ...

    def replace(self, **changes: Unpack[MotionInputs]) -> "Motion":
        """The motion with other inputs."""
        ...


class Burns(Protocol):
    """Torques of one size, on or off."""

    @property
    def begin(self) -> float:
        """When the first one begins, s."""
        ...

    @property
    def end(self) -> float:
        """When the last one is over, s."""
        ...

    def pieces(self, begin: float, end: float) -> list[tuple[float, float]]:
        """The spans between two times in which the torque is constant, s."""
        ...

    def between(self, begin: float, end: float) -> np.ndarray:
        """The mean torque (3,) from one time to another, N m."""
        ...


class Track(Protocol):
    """Attitudes and rates along a flight."""

    @property
    def q(self) -> np.ndarray:
        """(N, 4)."""
        ...

    @property
    def omega(self) -> np.ndarray:
        """(N, 3), rad/s."""
        ...


class Flight(Protocol):
    """A flight at its samples, N of them; vectors in body axes."""

    @property
    def arrival(self) -> float:
        """When the target takes the track's place, s."""
        ...

    @property
    def t(self) -> np.ndarray:
        """(N,), s."""
        ...

    @property
    def q(self) -> np.ndarray:
        """Attitude flown (N, 4)."""
        ...

    @property
    def omega(self) -> np.ndarray:
        """Body rates flown (N, 3), rad/s."""
        ...

    @property
    def track(self) -> Track:
        """The motion that was to be followed, on beyond its arrival."""
        ...

    @property
    def reference(self) -> Track:
        """What was to be followed: the track, then the target."""
        ...

    @property
    def error(self) -> np.ndarray:
        """Angle between what was flown and what was to be followed (N,), rad."""
        ...

    @property
    def wheel_momentum(self) -> np.ndarray:
        """(N, 3), N m s."""
        ...

    @property
    def burns(self) -> Burns | None:
        """Of the thrusters; None where there are none."""
        ...

    @property
    def torque(self) -> np.ndarray:
        """Of the wheels on the body (N, 3), N m."""
        ...

    @property
    def disturbances(self) -> Mapping[str, np.ndarray]:
        """Torques by name, (N, 3) each, N m."""
        ...
