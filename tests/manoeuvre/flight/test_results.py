"""Tests of the files of a flight: the same bytes each time, and numbers of the states."""

import io
import json
import zipfile
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from math import radians
from shutil import copy

import numpy as np
import pytest
from manoeuvre_flights import INERTIA, NO_CONTROL, NOTHING, tracked

from rigidsym.errors import InputError
from rigidsym.manoeuvre import plan
from rigidsym.manoeuvre._manoeuvre import manoeuvre
from rigidsym.manoeuvre.flight import _results
from rigidsym.manoeuvre.flight._rotation import angle
from rigidsym.manoeuvre.flight._run import predicted
from rigidsym.manoeuvre.flight._settings import Thrusters

DATED = {"creation_date": "2026-01-01T00:00:00"}
tracked = partial(tracked, message=DATED)


@pytest.fixture(scope="module")
def found():
    return tracked()


@pytest.fixture(scope="module")
def early():
    """A flight without disturbances that ends before the target."""
    return tracked(5, disturbances=NOTHING)


@pytest.fixture(scope="module")
def written(found, tmp_path_factory):
    """A folder with all files of the flight."""
    directory = tmp_path_factory.mktemp("written")
    assert set(found.write(directory)) == set(directory.iterdir())
    return directory


def test_the_files(written):
    drawn = ("attitude", "error", "rates", "torques", "wheels", "disturbances")
    pictures = {f"{picture}.{suffix}" for picture in drawn for suffix in ("svg", "png")}
    sizes = {path.name: path.stat().st_size for path in written.iterdir()}
    assert set(sizes) == pictures | {"run.npz", "summary.json", "attitude.aem"}
    assert min(sizes.values()) > 500


def test_the_same_bytes_twice(written, tmp_path):
    tracked().write(tmp_path)
    for path in written.iterdir():
        assert path.read_bytes() == (tmp_path / path.name).read_bytes(), path.name


def test_the_states(found):
    data = found.to_npz()
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    states = np.load(io.BytesIO(data))
    assert states["t"].tolist() == [k / 10 for k in range(401)]
    np.testing.assert_array_equal(states["q"], found.run.q)
    np.testing.assert_allclose(states["error"], angle(states["reference_q"], states["q"]))
    assert {name for name in states if name.startswith("disturbance_")} == {
        f"disturbance_{name}" for name in ("drag", "gravity_gradient", "radiation", "dipole")
    }
    assert all(len(states[name]) == 401 for name in states)


def test_the_message(found):
    """Each line has q1 q2 q3 qc at a time of the flight, counted from the orbit's epoch."""
    lines = found.to_aem().splitlines()
    assert "START_TIME = 2013-07-17T12:00:00.000" in lines
    assert "REF_FRAME_A = GCRF" in lines
    rows = [line.split() for line in lines if line.startswith("2013-")]
    assert len(rows) == len(found.run.t)
    read = np.array([row[1:5] for row in rows], dtype=float)
    np.testing.assert_allclose(read, np.roll(found.run.q, -1, axis=1), rtol=0, atol=1e-15)


def test_the_summary(found):
    summary, run = json.loads(found.to_json()), found.run
    assert summary["schema"] == "rigidsym.track/1"
    assert summary["transfer"]["omega0"] == [0.01, 0.02, -0.01]
    error = run.error[run.t < 10]
    assert summary["tracking_error"]["max"] == error.max()
    assert summary["tracking_error"]["rms"] == pytest.approx(np.sqrt((error**2).mean()))
    assert summary["target"]["final_error"] == run.error[-1]
    late = run.t >= summary["target"]["settled_at"]
    assert run.error[late].max() <= np.radians(0.1) < run.error[np.argmax(late) - 1]
    assert summary["torque_peak"] == np.abs(run.torque).max(axis=0).tolist()
    assert summary["wheel_momentum_peak"] == np.abs(run.wheel_momentum).max(axis=0).tolist()
    assert summary["flight"]["orbit"]["altitude"] == 600
    assert summary["manoeuvre"]["inertia"] == ["0.0109", "0.04", "0.0506"]
    # Wheels within their limits say nothing.
    assert summary["saturation"]["momentum"] == [0, 0, 0]
    assert not any("limit" in name or "misses" in name for name, _ in found.rows())


def test_a_message_of_a_mission(found):
    names = {"object_name": "NANO", "object_id": "2013-001A", "originator": "US", **DATED}
    lines = replace(found, flight=replace(found.flight, message=names)).to_aem().splitlines()
    assert {f"{name.upper()} = {value}" for name, value in names.items()} <= set(lines)


def test_full_wheels_are_named():
    flown = tracked(60, wheels={"max_momentum": 1e-4})
    told = dict(flown.rows())
    assert flown.missed
    assert told["wheels at their limit of momentum"].startswith("1 for")
    needed = flown.summary()["saturation"]["momentum_needed"]
    # At rest before: the wheels turn against the body, with the whole of its momentum.
    assert max(needed) == pytest.approx(
        np.abs(flown.run.inertia * flown.run.track.omega[flown.run.t < 10]).max(), rel=1e-6
    )
    assert f"{max(needed):.2e}" in told["why it misses"]


def test_thrusters_say_where_they_lead():
    flown = tracked(11, thrusters=Thrusters(), controller=NO_CONTROL, disturbances=NOTHING)
    assert "deg off" in dict(flown.rows())["when thrusters end"]
    summary = json.loads(flown.to_json())["thrusters"]
    assert np.shape(summary["spans"]) == (2, 3, 2)
    assert summary["last"]["error"] == pytest.approx(flown.run.last_burn()["error"])
    assert flown.missed == (summary["last"]["error"] > np.radians(0.1))


def test_a_flight_that_does_not_settle_is_missed():
    flown = tracked(11)
    assert flown.missed
    assert ("settled at the target", "not within 0.1 deg at the end") in flown.rows()


def test_a_flight_that_ends_early_is_not_missed(early):
    assert not early.missed
    rows = {("settled at the target", "not flown"), ("error at the end", "not flown")}
    assert rows <= set(early.rows())


def test_a_flight_without_disturbances(early, tmp_path):
    assert early.write(tmp_path)
    assert json.loads(early.to_json())["disturbance_peak"] == {}


def at(found, *date):
    """Return the flight with another epoch."""
    orbit = replace(found.flight.orbit, epoch=datetime(*date, tzinfo=UTC))
    return replace(found, flight=replace(found.flight, orbit=orbit))


def test_what_cannot_be_written_leaves_nothing(found, tmp_path):
    with pytest.raises(InputError, match="1972 to 9999"):
        at(found, 9999, 12, 31, 23, 59, 59).write(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_no_message_of_another_flight_is_left(found, written, tmp_path, monkeypatch):
    monkeypatch.setattr(_results, "_PICTURES", ())
    copy(written / "attitude.aem", tmp_path)
    paths = at(found, 1971, 12, 31).write(tmp_path)
    assert set(tmp_path.iterdir()) == set(paths)
    assert tmp_path / "attitude.aem" not in paths


@pytest.mark.parametrize(
    ("target", "spin", "trivial"),
    [
        ((-2, 0, 0, 0), (0, 0, 0), True),
        ((1, 0, 0, "1e-9"), (0, 0, 0), False),
        ((1, 0, 0, 0), (0, "1e-9", 0), False),
    ],
)
def test_nothing_to_do_is_told(found, target, spin, trivial):
    asked = manoeuvre(INERTIA, (1, 0, 0, 0), target, 10, target_spin=spin)
    flown = replace(found, manoeuvre=asked)
    assert flown.manoeuvre.trivial == trivial
    assert ("start equals target" in dict(flown.rows())) == trivial


def test_the_prediction_says_both_in_degrees():
    _, told = predicted(radians(2.5), 0.75)
    assert told == "2.500 deg by 1 % of the burst, 0.750 deg by 1 deg of its direction"


def test_a_spin_about_its_axis_misses_by_what_it_turns_too_far():
    best = plan((1, 2, 3), (1, 0, 0, 0), (np.cos(0.5), 0, 0, np.sin(0.5)), 10).best
    name, told = predicted(best.sensitivity.size, best.sensitivity.direction)
    assert name == "the same predicted, uncorrected"
    assert told.startswith(f"{np.degrees(0.01):.3f} deg by 1 %")
