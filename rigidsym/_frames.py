"""States as tables of pandas, datasets of xarray and rotations of SciPy."""

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _containers as containers
from rigidsym import _inputs as inputs
from rigidsym import _layers as layers
from rigidsym.errors import package

if TYPE_CHECKING:
    from pandas import DataFrame
    from scipy.spatial.transform import Rotation
    from xarray import Dataset

ATTITUDE, RATES = ("q0", "q1", "q2", "q3"), ("omega1", "omega2", "omega3")


class Sampled(ABC):
    """Abstract function of time with attitudes and body rates."""

    @abstractmethod
    def __call__(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return q and omega at times, s."""

    def rotation(self, t: ArrayLike) -> "Rotation":
        """Return the attitudes at times as a SciPy Rotation.

        The rotations are from body to inertial axes; times in s.  Needs SciPy.
        """
        try:
            from scipy.spatial.transform import Rotation
        except ImportError:
            raise ImportError("rotation needs SciPy: pip install 'rigidsym[app]'") from None
        return Rotation.from_quat(np.roll(np.asarray(self(t)[0]), -1, axis=-1))

    def to_dataframe(self, t: ArrayLike, *, degrees: bool = False) -> "DataFrame":
        """Return states at times as a pandas DataFrame.

        Needs pandas.

        Parameters
        ----------
        t : array_like (N,)
            Times, s, dates or timedeltas: the index of the frame.
        degrees : bool
            Rates are in deg/s, not in rad/s.

        Returns
        -------
        DataFrame
            With the columns q0 ... q3, omega1 ... omega3.

        Raises
        ------
        InputError
            As a call does.
        """
        return dataframe(t, *self._at(t), degrees)

    def to_xarray(self, t: ArrayLike, *, degrees: bool = False) -> "Dataset":
        """Return states at times as an xarray Dataset.

        Needs xarray.

        Parameters
        ----------
        t : array_like (N,)
            Times, s, dates or timedeltas.
        degrees : bool
            Rates are in deg/s, not in rad/s; their attribute `units` names the unit.

        Returns
        -------
        Dataset
            With the variables q (t, component) and omega (t, axis).

        Raises
        ------
        InputError
            As a call does.
        """
        return dataset(t, *self._at(t), degrees)

    def _at(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return the states (N, 4) and (N, 3) at times, a single one too."""
        q, omega = map(np.asarray, self(t))
        return np.atleast_2d(q), np.atleast_2d(omega)


def dataframe(
    t: Any, q: np.ndarray, omega: np.ndarray, degrees: bool, **columns: np.ndarray
) -> "DataFrame":
    """Return states (..., N, 4) and (..., N, 3) at times (N,) as a DataFrame.

    Its index is t, dates and timedeltas as they are, after the number of the body along each
    leading axis.  columns: more columns, of shapes (..., N).
    """
    pandas: Any = package("pandas", "to_dataframe", "frames")
    times = pandas.Index(_labels(t), name="t")
    rates = np.rad2deg(omega) if inputs.is_true("degrees", degrees) else omega
    more = [x[..., None] for x in columns.values()]
    rows = np.concatenate([q, rates, *more], axis=-1)
    leading = rows.shape[:-2]
    index = times
    if leading:
        names = [*_bodies(leading), "t"]
        levels = [*map(range, leading), times]
        index = pandas.MultiIndex.from_product(levels, names=names)
    names = [*ATTITUDE, *RATES, *columns]
    return pandas.DataFrame(rows.reshape(-1, len(names)), index, names)


def dataset(t: Any, q: np.ndarray, omega: np.ndarray, degrees: bool) -> "Dataset":
    """Return states (..., N, 4) and (..., N, 3) at times (N,) as a Dataset."""
    xarray: Any = package("xarray", "to_xarray", "frames")
    times = np.atleast_1d(containers.unwrapped("t", _labels(t)))
    unit = {"units": "s"} if times.dtype.kind == "f" else {}
    rates = np.rad2deg(omega) if inputs.is_true("degrees", degrees) else omega
    described = {name: dict(x) for name, x in layers.ATTRIBUTES.items()}
    described["omega"]["units"] = "deg/s" if degrees else "rad/s"
    leading = _bodies(q.shape[:-2])
    return xarray.Dataset(
        {
            "q": ((*leading, "t", "component"), q, described["q"]),
            "omega": ((*leading, "t", "axis"), rates, described["omega"]),
        },
        {"t": ("t", times, unit), **layers.LABELS},
    )


def _labels(t: Any) -> Any:
    """Return times as labels: seconds, or dates and timedeltas as they were given."""
    given = containers.unwrapped("t", t)
    if getattr(getattr(given, "dtype", None), "kind", "") in ("m", "M"):
        return t if getattr(t, "ndim", 0) else np.atleast_1d(given)
    return np.atleast_1d(np.asarray(containers.plain("t", t), float))


def _bodies(leading: tuple[int, ...]) -> list[str]:
    """Return the names of leading axes."""
    return ["body"] if len(leading) == 1 else [f"body{k}" for k in range(len(leading))]
