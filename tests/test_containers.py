"""Values of other libraries as input: SciPy's Rotation, pandas, dates and times, units."""

import datetime as dt
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion, integrate, principal_axes, propagate, step
from rigidsym import _inputs as inputs
from rigidsym.io import Track

BODY, RATES = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
MOTION = TorqueFreeMotion(BODY, RATES)
MINUTES = np.array(["2026-01-01T00:00", "2026-01-01T00:01", "2026-01-01T00:02"], "M8[s]")


def same(found, expected):
    for x, y in zip(found, expected, strict=True):
        np.testing.assert_array_equal(x, y)


def test_a_rotation_is_an_attitude_everywhere():
    Rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    many = Rotation.from_rotvec(np.arange(15.0).reshape(5, 3) / 9)
    rows, one = many.as_quat(scalar_first=True), many[3]
    assert TorqueFreeMotion(BODY, RATES, one) == TorqueFreeMotion(BODY, RATES, rows[3])
    for given, q in ((many, rows), (one, rows[3])):
        same(propagate(BODY, RATES, [1.0], given), propagate(BODY, RATES, [1.0], q))
        same(step(BODY, given, RATES, 0.1), step(BODY, q, RATES, 0.1))
        body = principal_axes(np.diag(BODY[::-1]))
        same(body.to_principal(RATES, given), body.to_principal(RATES, q))
        runs = (
            integrate(BODY, x, RATES, lambda t, q, w: 0 * w, [0, 1], step=1) for x in (given, q)
        )
        same(next(runs), next(runs))
    same(
        [Track(np.arange(5.0), many, np.zeros((5, 3))).q],
        [Track(np.arange(5.0), rows, 0 * rows[:, 1:]).q],
    )
    with pytest.raises(InputError, match=r"^attitude0 = .*must be a list of numbers"):
        TorqueFreeMotion(BODY, RATES, many)
    with pytest.raises(InputError, match=r"^omega0 = an array of shape \(4,\): .* 3 numbers"):
        propagate(BODY, one, 1.0)


def test_times_of_numpy_and_python():
    expected = MOTION([0.0, 60.0, 120.0])
    for unit in ("s", "ms", "ns"):
        same(MOTION(MINUTES.astype(f"M8[{unit}]")), expected)
        same(MOTION((MINUTES - MINUTES[0]).astype(f"m8[{unit}]")), expected)
    same(propagate(BODY, RATES, MINUTES), propagate(BODY, RATES, [0.0, 60, 120]))
    minute = np.timedelta64(1, "m"), dt.timedelta(minutes=1)
    for one in minute:
        same(MOTION(one), MOTION(60.0))
        same(step(BODY, (1, 0, 0, 0), RATES, one), step(BODY, (1, 0, 0, 0), RATES, 60.0))
    days = np.array([0, 10**15 + 1], "m8[ns]")
    same(MOTION(days), MOTION([0.0, 1e6 + 1e-9]))
    same(MOTION(np.array([1, -5], "m8[3ms]")), MOTION([0.003, -0.015]))
    same(MOTION(np.array([-1, -1001], "m8[ms]")), MOTION([-0.001, -1.001]))
    same(MOTION(np.array([0, 5], "M8[1500ms]")), MOTION([0.0, 7.5]))
    months = np.array(["2026-01", "2026-03"], "M8[M]")
    same(MOTION(months), MOTION([0.0, 59 * 86400.0]))
    assert inputs.times(np.array([1, -3], "m8[ms]")) == (
        (Fraction(1, 1000), Fraction(-3, 1000)),
        False,
    )
    assert inputs.times(minute[1]) == ((Fraction(60),), True)
    same(MOTION.precise(np.timedelta64(100, "ms"), 20), MOTION.precise("0.1", 20))
    assert MOTION(MINUTES[:0])[0].shape == (0, 4)


def test_times_of_pandas():
    pandas = pytest.importorskip("pandas", reason="needs pandas (extra frames)")
    expected = MOTION([0.0, 60.0, 120.0])
    dates = pandas.DatetimeIndex(MINUTES)
    for zone in (None, "UTC", "Europe/Berlin"):
        local = dates.tz_localize(zone)
        for t in (local, local.to_series(), local - local[0], pandas.Series(local - local[0])):
            same(MOTION(t), expected)
    same(MOTION(pandas.Timedelta("60s")), MOTION(60.0))
    frame = pandas.DataFrame(
        [BODY, BODY[::-1]], index=pandas.MultiIndex.from_tuples([(1, 2), (3, 4)])
    )
    same(propagate(frame, RATES, 1.0), propagate([BODY, BODY[::-1]], RATES, 1.0))
    for t, rule in (
        (pandas.DatetimeIndex([*MINUTES, pandas.NaT]), r"^t\[3\] = NaT: must be a date or a time$"),
        (dates[1], r"^t = .*first of a one-dimensional array \(subtract the epoch"),
        (pandas.MultiIndex.from_tuples([(1, 2)]), "must be an array of numbers"),
        (pandas.period_range("2026", periods=2), "must be an array of numbers"),
    ):
        with pytest.raises(InputError, match=rule):
            MOTION(t)
    for column in (pandas.Series([1, None, 2]), pandas.array([1, None, 2])):
        with pytest.raises(InputError, match=r"^omega0\[1\] = nan: must be finite"):
            propagate(BODY, column, 1.0)


@pytest.mark.parametrize(
    ("t", "rule"),
    [
        (dt.datetime(2026, 1, 1, tzinfo=dt.UTC), "dates count from the first"),
        (np.datetime64("2026-01-01"), "dates count from the first"),
        (np.array([["2026-01-01"]], "M8[D]"), "dates count from the first"),
        (np.array([1], "m8[Y]"), "must be in weeks or shorter"),
        (np.array(["1700-01-01", "2260-01-01"], "M8[ns]"), "too far apart"),
        ([dt.datetime(2026, 1, 1)], "must be an array of numbers"),
    ],
)
def test_times_without_a_value_in_seconds_are_refused(t, rule):
    with pytest.raises(InputError, match=rf"^t = .*{rule}"):
        MOTION(t)


def test_dates_are_no_rates_and_no_steps():
    for field, call in (
        ("omega0", lambda: propagate(BODY, MINUTES, 1.0)),
        ("dt", lambda: step(BODY, (1, 0, 0, 0), RATES, MINUTES)),
    ):
        with pytest.raises(InputError, match=rf"^{field} = .*must be an array of numbers"):
            call()


class Quantity:
    """An array with units, as pint's."""

    units, magnitude = "deg/s", RATES

    def __array__(self, dtype=None, copy=None):
        return np.array(RATES)


class UnitArray(np.ndarray):
    """An array with a unit, as astropy's."""

    unit = "deg/s"


@pytest.mark.parametrize("given", [Quantity(), np.array(RATES).view(UnitArray), [Quantity()] * 3])
def test_units_are_refused_and_not_dropped(given):
    for call in (propagate, TorqueFreeMotion):
        with pytest.raises(InputError, match=r"^omega0 = .*has a unit: give its numbers in rad/s$"):
            call(BODY, given, 1.0) if call is propagate else call(BODY, given)


def test_no_library_is_imported_for_a_check():
    code = (
        "import sys, numpy as np, rigidsym as r\n"
        "m = r.TorqueFreeMotion((1, 2, 2.5), np.array([1.0, 2, 3])[::-1])\n"
        "m(np.array([0, 1], 'm8[s]'))\n"
        "r.propagate(((1, 2, 2.5),) * 2, (1, 2, 3), [1.0])\n"
        "print([x for x in ('scipy', 'pandas', 'xarray', 'dask', 'zarr') if x in sys.modules])\n"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout == "[]\n"
