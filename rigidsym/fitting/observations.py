"""What is observed of a body: attitudes, rates, directions, and what a model of the user says.

Each kind has its own times and errors.  Its residuals (..., N, width) are what is computed less
what was seen; derivatives (..., N, width, 6) are by a small turn of the body, as a rotation vector
along inertial axes, and by its rates.  Leading shapes are those of many motions.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from copy import copy
from dataclasses import dataclass, field
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.fitting.covariances import whitening
from rigidsym.fitting.rotations import inverse_right_jacobian
from rigidsym.quaternions import (
    conjugate,
    cross_matrices,
    matrices,
    of_rotation_vectors,
    product,
    rotated,
    rotation_vectors,
)

# Angles below it are as good as none.
_TINY = 1e-8
# Of a rate or an angle, rad: where central differences of a user's model are best.
_DIFFERENCE = 6e-6

Model = Callable[[np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True, slots=True, eq=False)
class Observations(ABC):
    """Values (N, ...) seen at times (N,), s, that grow; errors as `covariances.whitening` says."""

    kind: ClassVar[str]

    times: ArrayLike
    values: ArrayLike
    sigma: ArrayLike | None = None
    t: np.ndarray = field(init=False, repr=False)
    seen: np.ndarray = field(init=False, repr=False)
    weights: np.ndarray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self._keep("t", _times(f"{self.kind}.times", self.times))
        self._keep("seen", self._read(batches.array(self.kind, self.values)))
        weights = whitening(f"sigma.{self.kind}", self.sigma, self.count, self.width)
        self._keep("weights", weights)

    def _keep(self, name: str, value: object) -> None:
        """Past the frozen class, as it is made."""
        object.__setattr__(self, name, value)

    @property
    def count(self) -> int:
        """N, how many there are."""
        return self.t.size

    @property
    @abstractmethod
    def width(self) -> int:
        """How many numbers each of them tells."""

    @property
    @abstractmethod
    def unrelated(self) -> float:
        """The mean square of residuals of a motion that has nothing to do with them."""

    @abstractmethod
    def _read(self, values: np.ndarray) -> np.ndarray:
        """The values as they are kept; raises InputError for other shapes."""

    @abstractmethod
    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Of states (..., N, 4), (..., N, 3) at the times: (..., N, width)."""

    @abstractmethod
    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """Of the residuals by turn and rates: (..., N, width, 6)."""

    def whitened(self, rows: np.ndarray) -> np.ndarray:
        """Rows (..., N, width, p) in units of the errors, which are then independent."""
        return self.weights * rows if self.weights.shape[-1] == 1 else self.weights @ rows

    def some(self, index: np.ndarray) -> Self:
        """Those of an index."""
        return self.changed(**{name: getattr(self, name)[index] for name in self._by_row})

    def changed(self, **fields: object) -> Self:
        """The same with other values of some fields, as they are kept."""
        found = copy(self)
        for name, value in fields.items():
            found._keep(name, value)
        return found

    @property
    def _by_row(self) -> tuple[str, ...]:
        return "t", "seen", "weights"

    def _rows(self, values: np.ndarray, width: int) -> np.ndarray:
        if values.shape != (self.count, width):
            rule = f"must have the shape ({self.count}, {width}), a row for each time"
            raise InputError(self.kind, f"an array of shape {values.shape}", rule)
        return values


@dataclass(frozen=True, slots=True, eq=False)
class Attitudes(Observations):
    """Quaternions (N, 4), scalar first, body to inertial, of either sign and any length.

    The residual is the rotation vector of R_seen^T R, along the axes of the body, rad.
    """

    kind: ClassVar[str] = "attitudes"
    width: ClassVar[int] = 3
    # Of the angle of random rotations.
    unrelated: ClassVar[float] = np.pi**2 / 3 + 2

    def _read(self, values: np.ndarray) -> np.ndarray:
        return _unit(self.kind, self._rows(values, 4))

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """See `Observations`."""
        return rotation_vectors(product(conjugate(self.seen), q))

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """R_seen^T exp(eta) R = R_seen^T R exp(R^T eta)."""
        found = np.zeros((*residuals.shape, 6))
        transposed = np.swapaxes(matrices(q), -2, -1)
        found[..., :3] = inverse_right_jacobian(residuals) @ transposed
        return found


@dataclass(frozen=True, slots=True, eq=False)
class Rates(Observations):
    """Rates (N, 3) along the axes of the body, rad/s, as a gyroscope has them."""

    kind: ClassVar[str] = "rates"
    width: ClassVar[int] = 3

    @property
    def unrelated(self) -> float:
        """Return the mean square of residuals of a motion at rest."""
        return _mean_square(self.seen)

    def _read(self, values: np.ndarray) -> np.ndarray:
        return self._rows(values, 3)

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """See `Observations`."""
        return omega - self.seen

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """See `Observations`."""
        found = np.zeros((*residuals.shape, 6))
        found[..., 3:] = np.eye(3)
        return found


@dataclass(frozen=True, slots=True, eq=False)
class Directions(Observations):
    """Directions (N, 3) of something whose direction is `known`, (3,) or (N, 3), in other axes.

    By default they are known in space and seen along the axes of the body, as a star is by a
    camera; `seen_in="space"` is the reverse, as a face of the body is from elsewhere.  The residual
    is the way on the sphere from what was seen to what is computed: two numbers, rad.
    """

    kind: ClassVar[str] = "vectors"
    width: ClassVar[int] = 2
    # Of the angle between random directions.
    unrelated: ClassVar[float] = np.pi**2 / 2 - 2
    known: ArrayLike = (0.0, 0.0, 1.0)
    seen_in: str = "body"
    tangents: np.ndarray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        super(Directions, self).__post_init__()
        if self.seen_in not in ("body", "space"):
            raise InputError("vectors.seen_in", repr(self.seen_in), "must be 'body' or 'space'")
        known = batches.array("vectors.known", self.known)
        if known.shape not in ((3,), (self.count, 3)):
            rule = f"must have the shape (3,) or ({self.count}, 3)"
            raise InputError("vectors.known", f"an array of shape {known.shape}", rule)
        self._keep("known", _unit("vectors.known", known))
        self._keep("tangents", _tangents(self.seen))

    def _read(self, values: np.ndarray) -> np.ndarray:
        return _unit(self.kind, self._rows(values, 3))

    @property
    def _by_row(self) -> tuple[str, ...]:
        return "t", "seen", "weights", "tangents", *(["known"] * (np.ndim(self.known) == 2))

    def _computed(self, q: np.ndarray) -> np.ndarray:
        known = np.asarray(self.known)
        return rotated(conjugate(q) if self.seen_in == "body" else q, known)

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """See `Observations`."""
        there = self._computed(q)
        angle, sine = self._apart(there)
        return (angle / sine)[..., None] * (self.tangents @ there[..., None])[..., 0]

    def _apart(self, there: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The angle and its sine, both 1 where it is next to none."""
        sine = np.linalg.norm(np.cross(self.seen, there), axis=-1)
        angle = np.arctan2(sine, np.sum(self.seen * there, axis=-1))
        tiny = sine < _TINY
        return np.where(tiny, 1.0, angle), np.where(tiny, 1.0, sine)

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """A turn eta moves R^T v by R^T (v x eta), and R b by eta x R b."""
        there = self._computed(q)
        angle, sine = self._apart(there)
        if self.seen_in == "body":
            known = np.asarray(self.known)
            moved = np.swapaxes(matrices(q), -2, -1) @ cross_matrices(known)
        else:
            moved = -cross_matrices(there)
        # Of angle/sine by the cosine, which is 1/3 less for no angle.
        cosine = np.sum(self.seen * there, axis=-1)
        slope = np.where(angle == sine, -1 / 3, -(sine - angle * cosine) / sine**3)
        along = self.seen[:, None, :] @ moved
        flat = self.tangents @ there[..., None]
        found = np.zeros((*residuals.shape, 6))
        found[..., :3] = (angle / sine)[..., None, None] * (self.tangents @ moved)
        found[..., :3] += slope[..., None, None] * flat * along
        return found


@dataclass(frozen=True, slots=True, eq=False)
class Modelled(Observations):
    """Values (N, k), or (N,), of what `model(q, omega)` says of states: light curves, ranges.

    model: of q (..., N, 4), omega (..., N, 3) -> (..., N, k) or (..., N).  jacobian: of the same,
    (..., N, k, 6), by a small turn of the body along inertial axes and by the rates; differences of
    the model where it is None.
    """

    kind: ClassVar[str] = "models"
    model: Model | None = None
    jacobian: Model | None = None

    @property
    def width(self) -> int:
        """k."""
        return self.seen.shape[1]

    @property
    def unrelated(self) -> float:
        """The variance of the values."""
        return _mean_square(self.seen - np.mean(self.seen, axis=0))

    def _read(self, values: np.ndarray) -> np.ndarray:
        if not callable(self.model):
            raise InputError("models.model", repr(self.model), "must be a function of q and omega")
        whole = values[:, None] if values.ndim == 1 else values
        if whole.ndim != 2:
            rule = f"must have the shape ({self.count}, k)"
            raise InputError(self.kind, f"an array of shape {values.shape}", rule)
        return self._rows(whole, whole.shape[1])

    def _modelled(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        assert self.model is not None
        found = np.asarray(self.model(q, omega), float)
        found = found[..., None] if found.shape == q.shape[:-1] else found
        if found.shape != (*q.shape[:-1], self.width):
            rule = f"for states of shape {q.shape} must be of shape {(*q.shape[:-1], self.width)}"
            raise InputError("models.model", f"an array of shape {found.shape}", rule)
        return found

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """See `Observations`."""
        return self._modelled(q, omega) - self.seen

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """The user's, or central differences of the model."""
        if self.jacobian is not None:
            return np.asarray(self.jacobian(q, omega), float)
        size = _DIFFERENCE * max(float(np.nanmax(np.abs(omega), initial=0.0)), 1e-30)
        columns = []
        for axis in np.eye(3):
            turn = of_rotation_vectors(_DIFFERENCE * axis)
            ahead, behind = (self._modelled(product(x, q), omega) for x in (turn, conjugate(turn)))
            columns.append((ahead - behind) / (2 * _DIFFERENCE))
        for axis in np.eye(3):
            ahead, behind = (self._modelled(q, omega + x * size * axis) for x in (1, -1))
            columns.append((ahead - behind) / (2 * size))
        return np.stack(columns, axis=-1)


def middle(sets: Iterable[Observations]) -> float:
    """Of the first time of all and the last, s."""
    times = np.concatenate([one.t for one in sets])
    return float(np.min(times) / 2 + np.max(times) / 2)


def _mean_square(rows: np.ndarray) -> float:
    """Of the lengths of rows; never zero."""
    return float(np.mean(np.sum(rows**2, axis=-1))) or np.finfo(float).tiny


def _times(name: str, values: ArrayLike) -> np.ndarray:
    times = batches.array(name, values)
    if times.ndim != 1 or not times.size:
        rule = "must be a list of at least one time"
        raise InputError(name, f"an array of shape {times.shape}", rule)
    for k in np.flatnonzero(np.diff(times) <= 0)[:1] + 1:
        raise InputError(f"{name}[{k}]", times[k], "must be later than the time before it")
    return times


def _unit(name: str, rows: np.ndarray) -> np.ndarray:
    """Of length 1, scaled first so that no square overflows or is lost."""
    most = np.max(np.abs(rows), axis=-1, keepdims=True)
    for place in np.argwhere(most[..., 0] == 0)[:1]:
        index = f"[{place[0]}]" if place.size else ""
        raise InputError(f"{name}{index}", rows[tuple(place)].tolist(), "must not be zero")
    scaled = rows / most
    return scaled / np.linalg.norm(scaled, axis=-1, keepdims=True)


def _tangents(directions: np.ndarray) -> np.ndarray:
    """Two unit vectors (N, 2, 3) across each direction, right-handed with it."""
    least = np.eye(3)[np.argmin(np.abs(directions), axis=-1)]
    first = np.cross(least, directions)
    first /= np.linalg.norm(first, axis=-1, keepdims=True)
    return np.stack([first, np.cross(directions, first)], axis=-2)
