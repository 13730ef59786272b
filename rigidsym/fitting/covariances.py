"""What users say of errors, as matrices that make errors independent and of size one."""

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import batches
from rigidsym.errors import InputError

_SYMMETRY = 1e-9


def whitening(field: str, sigma: ArrayLike | None, count: int, width: int) -> np.ndarray:
    """W (count, 1, 1) or (count, width, width): errors e have W e of covariance one.

    sigma: one standard deviation, (), or one for each observation, (count,); or a covariance
    (width, width), or one for each observation, (count, width, width).  Raises InputError for
    other shapes, deviations that are not positive and matrices that are no covariances.
    """
    if sigma is None:
        rule = "a standard deviation or a covariance is needed, in the observations' units"
        raise InputError(field, "missing", rule)
    given = batches.array(field, sigma)
    if given.shape in ((), (count,)):
        return _of_deviations(field, given, count)
    if given.shape in ((width, width), (count, width, width)):
        return np.broadcast_to(_of_covariances(field, given), (count, width, width))
    shapes = f"(), ({count},), ({width}, {width}) or ({count}, {width}, {width})"
    raise InputError(field, f"an array of shape {given.shape}", f"must have the shape {shapes}")


def _of_deviations(field: str, given: np.ndarray, count: int) -> np.ndarray:
    for place in np.argwhere(given <= 0)[:1]:
        name = f"{field}[{place[0]}]" if place.size else field
        raise InputError(name, given[tuple(place)], "a standard deviation must be positive")
    return np.broadcast_to(1 / given, (count,))[:, None, None]


def _of_covariances(field: str, given: np.ndarray) -> np.ndarray:
    """Inverse Cholesky factors."""
    size = np.max(np.abs(given), axis=(-2, -1), keepdims=True)
    skew = np.abs(given - np.swapaxes(given, -2, -1)) > _SYMMETRY * size
    for place in np.argwhere(np.any(skew, axis=(-2, -1)))[:1]:
        raise InputError(_place(field, place), "not symmetric", "a covariance is symmetric")
    least = np.linalg.eigvalsh(given)[..., 0]
    for place in np.argwhere(least <= 0)[:1]:
        value = f"has the eigenvalue {least[tuple(place)]:.6g}"
        raise InputError(_place(field, place), value, "a covariance must be positive definite")
    return np.linalg.inv(np.linalg.cholesky(given))


def _place(field: str, place: np.ndarray) -> str:
    return f"{field}[{place[0]}]" if place.size else field
