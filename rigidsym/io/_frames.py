"""States as labelled tables: a pandas DataFrame, an xarray Dataset; both are optional."""

from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.errors import package

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset

ATTITUDE = ("q0", "q1", "q2", "q3")
RATES = ("omega1", "omega2", "omega3")


def dataframe(t: np.ndarray, q: np.ndarray, omega: np.ndarray) -> "DataFrame":
    """Return a row for each of N times: index t, columns q0 ... q3 and omega1 ... omega3.

    Raises ImportError if pandas is not installed.
    """
    pandas: Any = package("pandas", "to_dataframe", "frames")
    index = pandas.Index(t, name="t")
    return pandas.DataFrame(np.hstack([q, omega]), index, [*ATTITUDE, *RATES])


def dataset(t: np.ndarray, q: np.ndarray, omega: np.ndarray, rate_unit: str) -> "Dataset":
    """Return variables q (t, component) and omega (t, axis), with units as attributes.

    Raises ImportError if xarray is not installed.
    """
    xarray: Any = package("xarray", "to_xarray", "frames")
    said = {"long_name": "attitude, body to inertial, scalar first", "units": "1"}
    rates = {"long_name": "rates in body axes", "units": rate_unit}
    return xarray.Dataset(
        {"q": (("t", "component"), q, said), "omega": (("t", "axis"), omega, rates)},
        {"t": ("t", t, {"units": "s"}), "component": list(ATTITUDE), "axis": [1, 2, 3]},
    )
