"""Epochs are exact to 1e-14 s across midnights, years and leap seconds."""

from datetime import date, datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st
from leap_seconds import TAI_MINUS_UTC

from rigidsym import InputError
from rigidsym.io import _epochs as epochs


def after(epoch, seconds, system="UTC", digits=3):
    return epochs.printed(
        epochs.later(epochs.parse("epoch", epoch, system), seconds), system, digits
    )


@pytest.mark.parametrize(
    ("epoch", "seconds", "system", "expected"),
    [
        ("2026-01-01T00:00:00", 0, "UTC", "2026-01-01T00:00:00.000"),
        ("2026-01-01T00:00:00Z", 86399.999, "UTC", "2026-01-01T23:59:59.999"),
        ("2024-060T12:00:00", 86400.0, "TT", "2024-03-01T12:00:00.000"),
        ("2026-01-01T00:00:00.125", -0.25, "GPS", "2025-12-31T23:59:59.875"),
        ("2016-12-31T23:59:59.5", 0.5, "UTC", "2016-12-31T23:59:60.000"),
        ("2016-12-31T23:59:59.5", 1.25, "UTC", "2016-12-31T23:59:60.750"),
        ("2016-12-31T23:59:59.5", 1.5, "UTC", "2017-01-01T00:00:00.000"),
        ("2016-12-31T23:59:60.5", 0.5, "UTC", "2017-01-01T00:00:00.000"),
        ("2017-01-01T00:00:00", -1.0, "UTC", "2016-12-31T23:59:60.000"),
        ("2016-12-31T23:59:59.5", 0.5, "TAI", "2017-01-01T00:00:00.000"),
        ("1972-01-01T00:00:00", 27 * 365.25 * 86400.0, "UTC", "1998-12-31T17:59:39.000"),
        ("0001-01-01T00:00:00", 0.0, "TAI", "0001-01-01T00:00:00.000"),
        ("9999-12-31T23:59:59", 0.999, "TAI", "9999-12-31T23:59:59.999"),
    ],
)
def test_seconds_after_an_epoch(epoch, seconds, system, expected):
    assert after(epoch, float(seconds), system) == expected


@pytest.mark.parametrize(("day", "offset"), TAI_MINUS_UTC.items())
def test_leap_seconds_are_those_of_the_iers(day, offset):
    midnight = f"{day}T00:00:00"
    utc, tai = (epochs.parse("epoch", midnight, system) for system in ("UTC", "TAI"))
    assert utc - tai == (offset - TAI_MINUS_UTC["1972-01-01"]) * epochs.SECOND
    if day != "1972-01-01":
        evening = f"{date.fromisoformat(day) - timedelta(1)}T23:59:60"
        assert epochs.parse("epoch", evening, "UTC") == utc - epochs.SECOND


def test_utc_falls_back_by_27_seconds_since_1972():
    days = (datetime(2026, 1, 1) - datetime(1972, 1, 1)).days
    assert after("1972-01-01T00:00:00", days * 86400.0) == "2025-12-31T23:59:33.000"


@given(
    st.datetimes(datetime(1600, 1, 1), datetime(2400, 1, 1)),
    st.integers(-(10**15), 10**15),
)
def test_other_systems_count_as_calendars_do(start, microseconds):
    text = start.isoformat(timespec="microseconds")
    later = start + timedelta(microseconds=microseconds)
    found = after(text, microseconds / 1e6, "TAI", 6)
    assert found == later.isoformat(timespec="microseconds")


@given(st.integers(63_000_000_000, 65_000_000_000), st.integers(0, epochs.SECOND - 1))
def test_what_is_printed_is_parsed_again(seconds, fraction):
    instant = seconds * epochs.SECOND + fraction
    for system in epochs.TIME_SYSTEMS:
        text = epochs.printed(instant, system, epochs.DECIMALS)
        assert epochs.parse("epoch", text, system) == instant


def test_decimals_are_as_many_as_are_needed():
    def count(*seconds):
        return epochs.decimals([epochs.later(0, t) for t in seconds])

    assert count(0.0, 1.0, 86400.0) == count(0.125) == count(-0.5) == 3
    assert count(0.0, 0.1, 0.0001) == 4
    assert count(120.1, 1e6 + 0.1) == 3
    assert count(1e-14) == count(1 / 3) == 14


@pytest.mark.parametrize(
    ("text", "system", "rule"),
    [
        ("now", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("2026-01-01", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("2026-01-01 00:00:00", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("2026-01-01T00:00:00.", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("2026-01-01T00:00:00+01:00", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("2026-01-01T00:00:00\n", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("\u0662026-01-01T00:00:00", "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        (None, "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        (20260101, "UTC", "must be YYYY-MM-DDThh:mm:ss"),
        ("2026-02-29T00:00:00", "UTC", "there is no such day"),
        ("2026-366T00:00:00", "UTC", "there is no such day"),
        ("2026-000T00:00:00", "UTC", "there is no such day"),
        ("9999-366T00:00:00", "TAI", "there is no such day"),
        ("0000-01-01T00:00:00", "TAI", "there is no such day"),
        ("2026-01-01T24:00:00", "UTC", "there is no such time of that day in UTC"),
        ("2026-01-01T23:60:00", "UTC", "there is no such time of that day in UTC"),
        ("2026-12-31T23:59:60", "UTC", "there is no such time of that day in UTC"),
        ("2016-12-31T22:59:60", "UTC", "there is no such time of that day in UTC"),
        ("2016-12-31T23:59:60", "TAI", "there is no such time of that day in TAI"),
        ("2026-01-01T00:00:00Z", "TAI", "Z stands for UTC, not for TAI"),
        ("2026-01-01T00:00:00.123456789012345", "UTC", "must have at most 14 decimals"),
        ("1971-12-31T23:59:59", "UTC", "UTC has had SI seconds since 1972: take TAI"),
    ],
)
def test_bad_epochs_are_one_line(text, system, rule):
    with pytest.raises(InputError) as refused:
        epochs.parse("epoch", text, system)
    assert refused.value.field == "epoch"
    assert rule in str(refused.value)
    assert len(str(refused.value).splitlines()) == 1


@pytest.mark.parametrize(
    ("epoch", "seconds", "system"),
    [
        ("9999-12-31T23:59:59", 1.0, "TAI"),
        ("0001-01-01T00:00:00", -1.0, "TAI"),
        ("1972-01-01T00:00:00", -1.0, "UTC"),
        ("2026-01-01T00:00:00", 1e300, "UTC"),
    ],
)
def test_times_that_no_epoch_can_be_printed_for(epoch, seconds, system):
    with pytest.raises(InputError, match=r"^times = a time of the track: must lie in the years"):
        after(epoch, seconds, system)


@pytest.mark.parametrize("system", ["UT1", "utc", "", None, ["UTC"]])
def test_other_time_systems_are_refused(system):
    with pytest.raises(InputError, match=r"^time_system = .*: must be one of: UTC, TAI, TT, GPS"):
        epochs.parse("epoch", "2026-01-01T00:00:00", system)
