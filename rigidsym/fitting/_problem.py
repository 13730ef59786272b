"""The least-squares problem of a fit, with its residuals and their derivatives."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _inputs as inputs
from rigidsym._engines import DEFAULT, batches, checked
from rigidsym.errors import InputError, unknown
from rigidsym.fitting._observations import KINDS, Observations, middle, whitening
from rigidsym.fitting._parameters import (
    Parameters,
    Point,
    observed_derivatives,
    sensitivities,
    states,
)

INERTIA = ("ratios", "known", "tensor")

Sigma = ArrayLike | Mapping[str, ArrayLike] | None
SetsLike = Observations | Sequence[Observations] | ArrayLike | None
"One kind of observations, as the user gives them."


@dataclass(frozen=True, slots=True)
class Prior:
    """A Gaussian prior on the moments of inertia.

    It has their means (3,) and the matrix (3, 3) that whitens their errors.
    """

    moments: np.ndarray
    weights: np.ndarray


@dataclass(frozen=True)
class Problem:
    """A least-squares problem with one residual for each observed number.

    Parameters are those of the state at `epoch`, s.  It lies amid the observations, because next to
    a separatrix errors grow by exp(rate time) both ways, beyond the precision of doubles.
    """

    sets: tuple[Observations, ...]
    parameters: Parameters
    prior: Prior | None = None
    engine: str = DEFAULT
    epoch: float = 0.0

    @cached_property
    def times(self) -> np.ndarray:
        """Return the distinct times (N,) of observation, in s."""
        return np.unique(np.concatenate([one.t for one in self.sets]))

    @cached_property
    def indices(self) -> list[np.ndarray]:
        """Return the indices of each set's times in `times`."""
        return [np.searchsorted(self.times, one.t) for one in self.sets]

    @cached_property
    def since(self) -> np.ndarray:
        """Return the times (N,) since the epoch, in s."""
        return self.times - self.epoch

    @property
    def span(self) -> float:
        """Return the time span of the observations and the epoch, in s.

        It is the span of the observations, or their distance from the epoch if that is larger.
        """
        return float(max(np.ptp(self.times), np.max(np.abs(self.since))))

    @cached_property
    def rows(self) -> list[np.ndarray]:
        """Return the indices (N, width) of each set's residuals."""
        sizes = [one.count * one.width for one in self.sets]
        ends = np.cumsum([0, *sizes])
        return [
            np.arange(first, first + size).reshape(one.count, one.width)
            for first, size, one in zip(ends, sizes, self.sets, strict=False)
        ]

    @property
    def count(self) -> int:
        """Return the number of residuals."""
        own = sum(one.count * one.width for one in self.sets)
        return own + (3 if self.prior else 0)

    def residuals(self, point: Point) -> np.ndarray:
        """Return the whitened residuals (..., count) at a point."""
        return self.state_residuals(point, *states(point, self.since, self.engine))

    def state_residuals(self, point: Point, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the whitened residuals of given states of the principal axes.

        Attitudes have the shape (..., N, 4), rates (..., N, 3).
        """
        return self._rows(point, *point.in_observed_axes(q, omega))[0]

    def linearised(self, point: Point, own: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the whitened residuals at a point and their derivatives.

        Residuals have the shape (..., count), derivatives (..., count, p).

        own (..., 12, p): see `Parameters.derivatives`.
        """
        q, omega, sensitivity = sensitivities(point, self.since, self.engine)
        seen = point.in_observed_axes(q, omega)
        moved = observed_derivatives(point, *seen, sensitivity, own)
        residuals, slopes = self._rows(point, *seen, moved)
        if self.prior:
            slopes.append(self.prior.weights @ own[..., 6:9, :])
        return residuals, np.concatenate(slopes, axis=-2)

    def _rows(
        self, point: Point, q: np.ndarray, omega: np.ndarray, moved: np.ndarray | None = None
    ) -> tuple[np.ndarray, list[np.ndarray]]:
        """Return the whitened residuals of states, and for each observation set their derivatives.

        Residuals have the shape (..., count), derivatives (..., M, p).

        moved (..., N, 6, p): derivatives of turn and rates; without them there are no others.
        """
        residuals, slopes = [], []
        for one, at in zip(self.sets, self.indices, strict=True):
            state = q[..., at, :], omega[..., at, :]
            found = one.residuals(*state)
            residuals.append(_flat(one.whitened(found[..., None]))[..., 0])
            if moved is not None:
                slope = one.derivatives(*state, found) @ moved[..., at, :, :]
                slopes.append(_flat(one.whitened(slope)))
        if self.prior:
            residuals.append((point.moments - self.prior.moments) @ self.prior.weights.T)
        return np.concatenate(residuals, axis=-1), slopes


def _flat(rows: np.ndarray) -> np.ndarray:
    """Merge the axes of observations and of their components.

    Return (..., N, width, p) as (..., N width, p).
    """
    *leading, count, width, p = rows.shape
    return rows.reshape(*leading, count * width, p)


def observation_sets(
    times: ArrayLike | None, by_kind: Mapping[str, SetsLike], sigma: Sigma
) -> tuple[Observations, ...]:
    """Convert the user's observations to a tuple of observation sets.

    `times` and `sigma` belong to those that are given as arrays.

    They have the order of their kinds.  Raises InputError.
    """
    asked = {kind: value for kind, value in by_kind.items() if value is not None}
    if isinstance(sigma, Mapping):
        for name in sigma:
            if name not in (*KINDS, "moments"):
                raise unknown("sigma", name, (*KINDS, "moments"), plain=True)
    elif sigma is not None and len(asked) > 1:
        raise InputError("sigma", "one for all", f"give one for each of: {', '.join(asked)}")
    errors = sigma if isinstance(sigma, Mapping) else dict.fromkeys(asked, sigma)
    found = [
        one
        for kind, value in asked.items()
        for one in _sets(KINDS[kind], value, times, errors.get(kind))
    ]
    if not found:
        raise InputError("observations", "none", f"give {', '.join(by_kind)}, or some of them")
    if len(np.unique(np.concatenate([one.t for one in found]))) == 1:
        rule = "all observations are at one time, and show no motion"
        raise InputError("times", found[0].t[0], rule)
    return tuple(found)


def _sets(
    kind: type[Observations], value: Any, times: ArrayLike | None, sigma: Any
) -> Iterable[Observations]:
    if isinstance(value, Observations):
        value = [value]
    if isinstance(value, list | tuple) and value and isinstance(value[0], Observations):
        for one in value:
            if not isinstance(one, kind):
                raise InputError(kind.kind, type(one).__name__, f"must be {kind.__name__}")
        return value
    if not kind.from_arrays:
        rule = f"must be rigidsym.fitting.{kind.__name__}, or a list of them"
        raise InputError(kind.kind, type(value).__name__, rule)
    if times is None:
        raise InputError("times", "missing", f"{kind.kind} given as an array need them")
    return [kind(times, value, sigma)]


def posed(
    sets: tuple[Observations, ...],
    inertia: str,
    moments: ArrayLike | None,
    sigma: Sigma,
    engine: str,
) -> tuple[Problem, np.ndarray | None]:
    """Return the least-squares problem of a fit and the user's moments.

    The moments (3,) are known, guessed, or the means of a prior; None where they are not given.

    Raises InputError.
    """
    if inertia not in INERTIA:
        if not isinstance(inertia, str):
            rule, step = f"must be one of: {', '.join(INERTIA)}", "numbers are given as moments="
            raise InputError("inertia", repr(inertia), rule, next_step=step)
        raise unknown("inertia", inertia, INERTIA)
    known = None
    if moments is not None:
        exact = inputs.certain("moments", inputs.inertia(moments, next_step=""))
        known = np.array(inputs.doubles("moments", exact))
    if inertia == "known" and known is None:
        raise InputError("moments", "missing", 'inertia="known" needs them')
    prior = _prior(known, sigma, inertia)
    parameters = Parameters(
        shape=inertia != "known", scale=prior is not None, axes=inertia == "tensor"
    )
    found = Problem(sets, parameters, prior, checked(engine), middle(sets))
    if found.count < parameters.count:
        rule = f"are fewer than the {parameters.count} parameters"
        raise InputError("observations", f"{found.count} numbers", rule)
    return found, known


def _prior(known: np.ndarray | None, sigma: Sigma, inertia: str) -> Prior | None:
    """Return the prior on the moments that `sigma["moments"]` defines, if any."""
    if not isinstance(sigma, Mapping) or "moments" not in sigma:
        return None
    if known is None or inertia == "known":
        rule = 'is about moments that are given, and inertia="ratios" or "tensor"'
        raise InputError("sigma.moments", "given", rule)
    errors = batches.array("sigma.moments", sigma["moments"])
    matrix = np.diag(errors**2) if errors.shape == (3,) else errors
    weights = whitening("sigma.moments", matrix, 1, 3)[0]
    return Prior(known, weights * np.eye(3) if weights.shape == (1, 1) else weights)
