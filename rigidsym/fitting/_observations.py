"""Kinds of observations: attitudes, rates, directions and values of a user's model.

A kind is one class here, listed in `KINDS`: its residuals and their derivatives, what a search can
start from, the conventions in which others may have written it, and its keys in TOML files.  Its
columns in tables of text are in `_names`.
To add a kind, write its class, list it in `KINDS`, and give `rigidsym.fit` an argument of its name.

Each set of observations has its own times and errors.  Residuals (..., N, width) are computed less
observed values.  Derivatives (..., N, width, 6) are by a small turn of the body, as a rotation
vector along inertial axes, and by its rates.  Leading shapes are those of many motions.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from copy import copy
from dataclasses import dataclass, field
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from rigidsym._engines import batches
from rigidsym.errors import InputError
from rigidsym.quaternions import (
    conjugate,
    cross_matrices,
    inverse_left_jacobian,
    matrices,
    of_rotation_vectors,
    product,
    rotated,
    rotation_vectors,
)

# Sines of angles below it are taken as zero.
_TINY = 1e-8
# Relative step of central differences of a user's model, rad.
_DIFFERENCE = 6e-6
SPIN = "spin"
"The known direction of `Directions` that is the axis of rotation."
# Relative asymmetry of a covariance that counts as rounding.
_SYMMETRY = 1e-9
# Between attitudes no more than _PLAIN apart, rad, the rotation is known without whole turns; rates
# are taken from pairs at most _LARGEST apart.
_PLAIN, _LARGEST = 1.0, 2.0

Model = Callable[[np.ndarray, np.ndarray], np.ndarray]
# Times (N,), s, and rates (N, 3), rad/s along the axes of the body.
RateSeries = list[tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True, eq=False)
class Observations(ABC):
    """Observations of one kind at increasing times, with their errors.

    times (N,): s. values (N, ...). sigma: errors as for `whitening`.

    t, seen, weights: the times, the values as they are compared with a motion, and the matrices
    that whiten their errors.
    """

    kind: ClassVar[str]
    "Name of the argument of `rigidsym.fit`."
    from_arrays: ClassVar[bool] = False
    "Can be given as an array with `times` and `sigma`."
    tells_attitude: ClassVar[bool] = False
    "Determines the attitude of a motion; see `davenport`."
    unit: ClassVar[str] = ""
    "Unit of the values and errors in TOML files."
    conventions: ClassVar[tuple[str, ...]] = ("",)
    "Conventions in which values may be written, the expected one first; see `by_convention`."
    keys: ClassVar[tuple[str, ...]] = ()
    "Keys of its tables in TOML files besides times and sigma."

    times: ArrayLike
    values: ArrayLike
    sigma: ArrayLike | None = None
    t: np.ndarray = field(init=False, repr=False)
    seen: np.ndarray = field(init=False, repr=False)
    weights: np.ndarray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        vars(self)["t"] = _times(f"{self.kind}.times", self.times)
        vars(self)["seen"] = self._read(batches.array(self.kind, self.values))
        weights = whitening(f"sigma.{self.kind}", self.sigma, self.count, self.width)
        vars(self)["weights"] = weights

    @property
    def count(self) -> int:
        """Return the number N of observations."""
        return self.t.size

    @property
    @abstractmethod
    def width(self) -> int:
        """Return the number of residuals of each observation."""

    @property
    @abstractmethod
    def unrelated(self) -> float:
        """Return the mean square of the residuals of a motion unrelated to the data."""

    @abstractmethod
    def _read(self, values: np.ndarray) -> np.ndarray:
        """Convert the user's values to the arrays that are stored.

        Raises InputError for wrong shapes.
        """

    @abstractmethod
    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the residuals of attitudes and rates at the times of observation.

        Residuals have the shape (..., N, width), attitudes (..., N, 4), rates (..., N, 3).
        """

    @abstractmethod
    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals with respect to a small turn and the rates.

        Their shape is (..., N, width, 6).
        """

    def rate_series(self) -> RateSeries:
        """Return time series of body rates that follow from the observations."""
        return []

    def davenport(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return Davenport's matrices, which determine the best rotation of each motion.

        Their shape is (B, 4, 4), for attitudes q (B, N, 4) and rates omega (B, N, 3).

        Their eigenvectors of the largest eigenvalue are the rotations, on the left of q, after
        which the motions agree best with the observations.
        """
        raise NotImplementedError

    def by_convention(self, name: str) -> Self:
        """Reinterpret the observations in another convention.

        name: one of `conventions`.
        """
        return self

    @classmethod
    def from_table(
        cls, where: str, table: Mapping[str, Any], times: np.ndarray, sigma: np.ndarray, unit: float
    ) -> Self:
        """Read the observations from a TOML table.

        The table has `keys`.  Raises InputError.

        sigma: the errors, converted already. unit: of the values, in rad or rad/s.
        """
        raise NotImplementedError

    def whitened(self, rows: np.ndarray) -> np.ndarray:
        """Whiten residuals or derivatives by the errors of the observations.

        The rows (..., N, width, p) are then in units of independent errors.
        """
        return self.weights * rows if self.weights.shape[-1] == 1 else self.weights @ rows

    def some(self, index: np.ndarray) -> Self:
        """Return a subset of the observations."""
        return self.changed(**{name: getattr(self, name)[index] for name in self._by_row})

    def changed(self, **fields: object) -> Self:
        """Return a copy with some stored fields replaced."""
        found = copy(self)
        vars(found).update(fields)
        return found

    def scaled(self, factor: float) -> Self:
        """Return a copy with values and errors converted to another unit."""
        return self.changed(seen=factor * self.seen, weights=self.weights / factor)

    @property
    def _by_row(self) -> tuple[str, ...]:
        return "t", "seen", "weights"

    def _rows(self, values: np.ndarray, width: int) -> np.ndarray:
        if values.shape != (self.count, width):
            rule = f"must have the shape ({self.count}, {width}), a row for each time"
            raise InputError(self.kind, f"an array of shape {values.shape}", rule)
        return values

    def _sizes(self) -> np.ndarray:
        """Return the mean inverse variance (N,) of each observation."""
        return np.sum(self.weights**2, axis=(-2, -1)) / self.weights.shape[-1]


@dataclass(frozen=True, eq=False)
class Attitudes(Observations):
    """Observed attitudes, as quaternions from body to inertial axes.

    The residual is the rotation vector of R_seen^T R, along the axes of the body, rad.

    Parameters
    ----------
    times : (N,)
        Times, s, increasing.
    values : (N, 4)
        Quaternions, scalar first, of either sign and any length.
    sigma : number, (N,), (3, 3) or (N, 3, 3)
        Standard deviations, rad, or covariances of rotation vectors along the axes of the body.
    """

    kind: ClassVar[str] = "attitudes"
    from_arrays: ClassVar[bool] = True
    tells_attitude: ClassVar[bool] = True
    conventions: ClassVar[tuple[str, ...]] = (
        "",
        "scalar last",
        "inertial to body",
        "scalar last and inertial to body",
    )
    keys: ClassVar[tuple[str, ...]] = ("q", "euler_313")
    unit: ClassVar[str] = "rad"
    width: ClassVar[int] = 3
    # The mean square angle of random rotations.
    unrelated: ClassVar[float] = np.pi**2 / 3 + 2

    def _read(self, values: np.ndarray) -> np.ndarray:
        return _unit(self.kind, self._rows(values, 4))

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the rotation vectors from the observed to the computed attitudes."""
        return rotation_vectors(product(conjugate(self.seen), q))

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals with respect to a small turn and the rates.

        They follow from R_seen^T exp(eta) R = R_seen^T R exp(R^T eta).
        """
        found = np.zeros((*residuals.shape, 6))
        found[..., :3] = np.swapaxes(matrices(q) @ inverse_left_jacobian(residuals), -2, -1)
        return found

    def rate_series(self) -> RateSeries:
        """Return mean body rates between the observed attitudes.

        The attitudes of each pair are so far apart that errors count little.

        There are none where whole turns may lie between neighbours.
        """
        if self.count < 2 or np.max(self._turns(1)[1]) > _PLAIN:
            return []
        stride = 1
        while 2 * stride < self.count and np.max(self._turns(2 * stride)[1]) < _LARGEST:
            stride *= 2
        turns, _ = self._turns(stride)
        gaps = self.t[stride:] - self.t[:-stride]
        return [(self.t[:-stride] + gaps / 2, turns / gaps[:, None])]

    def _turns(self, stride: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the rotation vectors between attitudes, in body axes, and their lengths."""
        turns = rotation_vectors(product(conjugate(self.seen[:-stride]), self.seen[stride:]))
        return turns, np.linalg.norm(turns, axis=-1)

    def davenport(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return Davenport's matrices (B, 4, 4), from products of quaternions."""
        between = product(self.seen, conjugate(q))
        return np.einsum("n,bni,bnj->bij", 2 * self._sizes(), between, between)

    def by_convention(self, name: str) -> Self:
        """Reinterpret the quaternions, with the scalar last, inertial to body, or both."""
        q = np.roll(self.seen, 1, axis=-1) if "last" in name else self.seen
        return self.changed(seen=conjugate(q) if "inertial" in name else q)

    @classmethod
    def from_table(
        cls, where: str, table: Mapping[str, Any], times: np.ndarray, sigma: np.ndarray, unit: float
    ) -> Self:
        """Read attitudes from a TOML table, as quaternions or 3-1-3 Euler angles.

        Quaternions are `q`; angles `euler_313` are in degrees, R = Rz(a) Rx(b) Rz(c).
        """
        if ("q" in table) == ("euler_313" in table):
            raise InputError(where, sorted(table), "must have q or euler_313, and not both")
        if "q" in table:
            return cls(times, batches.array(f"{where}.q", table["q"]), sigma)
        angles = batches.array(f"{where}.euler_313", table["euler_313"])
        if angles.ndim != 2 or angles.shape[1] != 3:
            rule = "must have three angles in each row"
            raise InputError(f"{where}.euler_313", f"an array of shape {angles.shape}", rule)
        q = Rotation.from_euler("ZXZ", angles, degrees=True).as_quat(scalar_first=True)
        return cls(times, q, sigma)


@dataclass(frozen=True, eq=False)
class Rates(Observations):
    """Observed body rates, as a gyroscope measures them.

    Parameters
    ----------
    times : (N,)
        Times, s, increasing.
    values : (N, 3)
        Rates, rad/s.
    sigma : number, (N,), (3, 3) or (N, 3, 3)
        Standard deviations, rad/s, or covariances.
    """

    kind: ClassVar[str] = "rates"
    from_arrays: ClassVar[bool] = True
    keys: ClassVar[tuple[str, ...]] = ("omega",)
    unit: ClassVar[str] = "rad/s"
    width: ClassVar[int] = 3

    @property
    def unrelated(self) -> float:
        """Return the mean square of the residuals of a body at rest."""
        return _mean_square(self.seen)

    def _read(self, values: np.ndarray) -> np.ndarray:
        return self._rows(values, 3)

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the computed rates less the observed rates."""
        return omega - self.seen

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals with respect to a small turn and the rates.

        They are zero and the identity.
        """
        return np.broadcast_to(np.eye(3, 6, 3), (*residuals.shape, 6)).copy()

    def rate_series(self) -> RateSeries:
        """Return the observed rates as one time series."""
        return [(self.t, self.seen)]

    @classmethod
    def from_table(
        cls, where: str, table: Mapping[str, Any], times: np.ndarray, sigma: np.ndarray, unit: float
    ) -> Self:
        """Read the rates `omega` from a TOML table."""
        rates = batches.array(f"{where}.omega", _needed(where, table, "omega"))
        return cls(times, rates * unit, sigma)


@dataclass(frozen=True, eq=False)
class Directions(Observations):
    """Directions, such as those of stars, observed in one frame and known in another.

    By default they are known in space and seen along the axes of the body, as a camera sees a star.
    The residual is the arc on the sphere from the observed to the computed direction: two numbers,
    rad.

    Parameters
    ----------
    times : (N,)
        Times, s, increasing.
    values : (N, 3)
        Observed directions, of any length.
    sigma : number, (N,), (2, 2) or (N, 2, 2)
        Standard deviations, rad, or covariances along `tangents` of the observed directions.
    known : (3,), (N, 3) or "spin"
        Known directions, in the other axes; "spin" is the axis of rotation, along the rates, whose
        direction in space is observed.
    seen_in : {"body", "space"}
        Axes of the observed directions; "space" is for a face of the body seen from elsewhere.
    """

    kind: ClassVar[str] = "vectors"
    tells_attitude: ClassVar[bool] = True
    conventions: ClassVar[tuple[str, ...]] = ("", "known and seen exchanged")
    keys: ClassVar[tuple[str, ...]] = ("seen", "known", "seen_in")
    unit: ClassVar[str] = "rad"
    width: ClassVar[int] = 2
    # The mean square angle between random directions.
    unrelated: ClassVar[float] = np.pi**2 / 2 - 2
    known: ArrayLike | str = (0.0, 0.0, 1.0)
    seen_in: str = "body"
    tangents: np.ndarray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.seen_in not in ("body", "space"):
            raise InputError("vectors.seen_in", repr(self.seen_in), "must be 'body' or 'space'")
        vars(self).update(known=self._read_known(), tangents=tangents(self.seen))

    def _read(self, values: np.ndarray) -> np.ndarray:
        return _unit(self.kind, self._rows(values, 3))

    @property
    def _by_row(self) -> tuple[str, ...]:
        return "t", "seen", "weights", "tangents", *(["known"] * (np.ndim(self.known) == 2))

    def _read_known(self) -> ArrayLike | str:
        """Return the known directions with the length 1, or "spin".

        Raises InputError.
        """
        if isinstance(self.known, str):
            if self.known != SPIN:
                raise InputError("vectors.known", repr(self.known), f"must be numbers or '{SPIN}'")
            if self.seen_in != "space":
                rule = f"must be 'space' where the known direction is '{SPIN}'"
                raise InputError("vectors.seen_in", repr(self.seen_in), rule)
            return self.known
        known = batches.array("vectors.known", self.known)
        if known.shape not in ((3,), (self.count, 3)):
            rule = f"must have the shape (3,) or ({self.count}, 3)"
            raise InputError("vectors.known", f"an array of shape {known.shape}", rule)
        return _unit("vectors.known", known)

    def _own(self, omega: np.ndarray) -> np.ndarray:
        """Return the known directions; axes of rotation are (..., N, 3)."""
        if not isinstance(self.known, str):
            return np.asarray(self.known)
        return omega / _size(omega)

    def _computed(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        return rotated(conjugate(q) if self.seen_in == "body" else q, self._own(omega))

    def residuals(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the angular residuals from the observed to the computed directions."""
        there = self._computed(q, omega)
        angle, sine = self._apart(there)
        return (angle / sine)[..., None] * (self.tangents @ there[..., None])[..., 0]

    def _apart(self, there: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the angles from the observed directions, and their sines.

        Both are 1 where the angle is tiny.
        """
        sine = np.linalg.norm(np.cross(self.seen, there), axis=-1)
        angle = np.arctan2(sine, np.sum(self.seen * there, axis=-1))
        tiny = sine < _TINY
        return np.where(tiny, 1.0, angle), np.where(tiny, 1.0, sine)

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals with respect to a small turn and the rates.

        A turn eta moves R^T v by R^T (v x eta), and R b by eta x R b.  Rates w move the axis of
        rotation R w/|w| by R (1 - w w^T/|w|^2)/|w|.
        """
        there = self._computed(q, omega)
        angle, sine = self._apart(there)
        moved = np.zeros((*there.shape, 6))
        if self.seen_in == "body":
            known = np.asarray(self.known)
            moved[..., :3] = np.swapaxes(matrices(q), -2, -1) @ cross_matrices(known)
        else:
            moved[..., :3] = -cross_matrices(there)
        if isinstance(self.known, str):
            own = self._own(omega)
            across = np.eye(3) - own[..., :, None] * own[..., None, :]
            moved[..., 3:] = matrices(q) @ across / _size(omega)[..., None]
        # The derivative of angle/sine by the cosine; its limit at no angle is -1/3.
        cosine = np.sum(self.seen * there, axis=-1)
        slope = np.where(angle == sine, -1 / 3, -(sine - angle * cosine) / sine**3)
        along = self.seen[:, None, :] @ moved
        flat = self.tangents @ there[..., None]
        found = (angle / sine)[..., None, None] * (self.tangents @ moved)
        return found + slope[..., None, None] * flat * along

    def davenport(self, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return Davenport's matrices (B, 4, 4), from pairs of directions in space."""
        known = np.broadcast_to(self._own(omega), q.shape[:-1] + (3,))
        space, body = (known, self.seen) if self.seen_in == "body" else (self.seen, known)
        turned = rotated(q, body)
        cosine = np.sum(turned * space, axis=-1)
        found = np.empty((*cosine.shape, 4, 4))
        found[..., 0, 0] = cosine
        found[..., 0, 1:] = found[..., 1:, 0] = np.cross(turned, space)
        outer = space[..., :, None] * turned[..., None, :]
        own = cosine[..., None, None] * np.eye(3)
        found[..., 1:, 1:] = outer + np.swapaxes(outer, -2, -1) - own
        return np.einsum("n,bnij->bij", self._sizes(), found)

    def by_convention(self, name: str) -> Self:
        """Reinterpret the directions, with the roles of body and space exchanged."""
        if not name or isinstance(self.known, str):
            return self
        return self.changed(seen_in="space" if self.seen_in == "body" else "body")

    @classmethod
    def from_table(
        cls, where: str, table: Mapping[str, Any], times: np.ndarray, sigma: np.ndarray, unit: float
    ) -> Self:
        """Read directions from a TOML table.

        `seen` has the observed directions, `known` the known ones, and `seen_in` the axes.
        """
        seen, known = (_needed(where, table, key) for key in ("seen", "known"))
        return cls(times, seen, sigma, known, table.get("seen_in", "body"))


@dataclass(frozen=True, eq=False)
class Modelled(Observations):
    """Observed values that a user's function computes from states, such as light curves.

    Parameters
    ----------
    times : (N,)
        Times, s, increasing.
    values : (N, k) or (N,)
        Observed values.
    sigma : number, (N,), (k, k) or (N, k, k)
        Standard deviations or covariances.
    model : function
        Computes values (..., N, k) or (..., N) from q (..., N, 4) and omega (..., N, 3).
    jacobian : function
        Computes derivatives (..., N, k, 6) from the same, by a small turn of the body along
        inertial axes and by the rates; central differences of the model where it is None.
    """

    kind: ClassVar[str] = "models"
    model: Model | None = None
    jacobian: Model | None = None

    @property
    def width(self) -> int:
        """Return the number k of values at each time."""
        return self.seen.shape[1]

    @property
    def unrelated(self) -> float:
        """Return the variance of the observed values."""
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
        """Return the model's values less the observed values."""
        return self._modelled(q, omega) - self.seen

    def derivatives(self, q: np.ndarray, omega: np.ndarray, residuals: np.ndarray) -> np.ndarray:
        """Return the derivatives of the model with respect to a small turn and the rates.

        They are those of the user's jacobian, or central differences.
        """
        if self.jacobian is not None:
            return np.asarray(self.jacobian(q, omega), float)
        size = _DIFFERENCE * max(float(np.nanmax(np.abs(omega), initial=0.0)), 1e-30)
        columns = []
        for turn in of_rotation_vectors(_DIFFERENCE * np.eye(3)):
            ahead, behind = (self._modelled(product(x, q), omega) for x in (turn, conjugate(turn)))
            columns.append((ahead - behind) / (2 * _DIFFERENCE))
        for step in size * np.eye(3):
            ahead, behind = (self._modelled(q, omega + x) for x in (step, -step))
            columns.append((ahead - behind) / (2 * size))
        return np.stack(columns, axis=-1)


KINDS: Mapping[str, type[Observations]] = {
    one.kind: one for one in (Attitudes, Rates, Directions, Modelled)
}
"Kinds of observations by name, in the order of the arguments of `rigidsym.fit`."


def tangents(directions: np.ndarray) -> np.ndarray:
    """Return two unit vectors (N, 2, 3) across each direction (N, 3), right-handed with it."""
    least = np.eye(3)[np.argmin(np.abs(directions), axis=-1)]
    first = np.cross(least, directions)
    first /= np.linalg.norm(first, axis=-1, keepdims=True)
    return np.stack([first, np.cross(directions, first)], axis=-2)


def middle(sets: Iterable[Observations]) -> float:
    """Return the middle of the time span of all observations, in s."""
    times = np.concatenate([one.t for one in sets])
    return float(np.min(times) / 2 + np.max(times) / 2)


def whitening(field: str, sigma: ArrayLike | None, count: int, width: int) -> np.ndarray:
    """Return the matrices W for which W e has unit covariance, e being the errors.

    They are (count, 1, 1) or (count, width, width).

    sigma: one standard deviation, (), or one for each observation, (count,); or a covariance
    (width, width), or one for each observation, (count, width, width).  Raises InputError for
    other shapes, deviations that are not positive and matrices that are no covariances.
    """
    if sigma is None:
        rule = "a standard deviation or a covariance is needed, in the observations' units"
        raise InputError(field, "missing", rule)
    errors = batches.array(field, sigma)
    if errors.shape in ((), (count,)):
        for place in np.argwhere(errors <= 0)[:1]:
            rule = "a standard deviation must be positive"
            raise InputError(_indexed(field, place), errors[tuple(place)], rule)
        return np.broadcast_to(1 / errors, (count,))[:, None, None]
    if errors.shape in ((width, width), (count, width, width)):
        return np.broadcast_to(_inverse_cholesky(field, errors), (count, width, width))
    shapes = f"(), ({count},), ({width}, {width}) or ({count}, {width}, {width})"
    raise InputError(field, f"an array of shape {errors.shape}", f"must have the shape {shapes}")


def _inverse_cholesky(field: str, covariances: np.ndarray) -> np.ndarray:
    size = np.max(np.abs(covariances), axis=(-2, -1), keepdims=True)
    skew = np.abs(covariances - np.swapaxes(covariances, -2, -1)) > _SYMMETRY * size
    for place in np.argwhere(np.any(skew, axis=(-2, -1)))[:1]:
        raise InputError(_indexed(field, place), "not symmetric", "a covariance is symmetric")
    least = np.linalg.eigvalsh(covariances)[..., 0]
    for place in np.argwhere(least <= 0)[:1]:
        value = f"has the eigenvalue {least[tuple(place)]:.6g}"
        raise InputError(_indexed(field, place), value, "a covariance must be positive definite")
    return np.linalg.inv(np.linalg.cholesky(covariances))


def _indexed(field: str, place: np.ndarray) -> str:
    return f"{field}[{place[0]}]" if place.size else field


def _needed(where: str, table: Mapping[str, Any], key: str) -> Any:
    if key not in table:
        raise InputError(f"{where}.{key}", "missing", "is needed")
    return table[key]


def _size(omega: np.ndarray) -> np.ndarray:
    """Return the lengths (..., 1) of rates; NaN at rest, where they have no direction."""
    size = np.linalg.norm(omega, axis=-1, keepdims=True)
    return np.where(size == 0, np.nan, size)


def _mean_square(rows: np.ndarray) -> float:
    """Return the mean squared length of the rows of an array.

    Zero is replaced by the smallest normal double.
    """
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
    """Normalise rows to length 1.

    They are scaled first, so that no square overflows or underflows.
    """
    most = np.max(np.abs(rows), axis=-1, keepdims=True)
    for place in np.argwhere(most[..., 0] == 0)[:1]:
        raise InputError(_indexed(name, place), rows[tuple(place)].tolist(), "must not be zero")
    scaled = rows / most
    return scaled / np.linalg.norm(scaled, axis=-1, keepdims=True)
