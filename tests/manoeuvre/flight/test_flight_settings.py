"""Tests of settings from files, and of the one line that refuses a bad one."""

import re
import tomllib
from datetime import UTC, datetime
from fractions import Fraction
from importlib import resources
from types import MappingProxyType

import pytest

from rigidsym.errors import InputError
from rigidsym.io._attitude_ephemeris import UNNAMED
from rigidsym.manoeuvre._manoeuvre import FLIGHT, PAPER, open_manoeuvre
from rigidsym.manoeuvre.flight._settings import Flight, Thrusters, read

COMMENTED = {"thrusters", "message"}


def test_the_shipped_file_is_what_is_default():
    asked, tables = open_manoeuvre("paper")
    assert set(tables) >= FLIGHT - COMMENTED
    assert set(Flight.__slots__) == FLIGHT
    assert read(tables) == read({}) == Flight()
    assert asked.duration == 120
    assert sum(x * x for x in asked.target) == 1


def test_the_shipped_file_names_every_setting():
    _, tables = open_manoeuvre("paper")
    for name in FLIGHT - COMMENTED:
        known = set(getattr(Flight(), name).__slots__) - {"max_momentum"}
        assert set(tables[name]) == known


def test_what_the_shipped_file_has_commented_is_what_is_default():
    text = resources.files("rigidsym.manoeuvre").joinpath(PAPER).read_text("utf-8")
    tables = tomllib.loads(re.sub("^# ", "", text[text.index("# [thrusters]") :], flags=re.M))
    assert set(tables) == COMMENTED
    found = read(tables)
    assert found.thrusters == Thrusters()
    assert set(tables["thrusters"]) == set(Thrusters.__slots__)
    assert found.message == {**UNNAMED, "creation_date": "2013-07-17T12:00:00"}
    assert not found.controller.natural_frequency


def test_thrusters_leave_the_controller_that_is_given():
    assert read({"thrusters": {}, "controller": {}}).controller == Flight().controller


def test_numbers_may_be_strings():
    found = read({"run": {"length": "3/2", "period": "0.05"}, "orbit": {"altitude": "550.5"}})
    assert (found.run.length, found.run.period) == (Fraction(3, 2), Fraction(1, 20))
    assert found.orbit.altitude == 550.5


@pytest.mark.parametrize(
    "text", ["2020-01-02T03:04:05Z", "2020-01-02T03:04:05", "2020-01-02T05:04:05+02:00"]
)
def test_epochs_are_in_utc(text):
    found = read(tomllib.loads(f"[orbit]\nepoch = {text}"))
    assert found.orbit.epoch == datetime(2020, 1, 2, 3, 4, 5, tzinfo=UTC)


BAD = {
    "thrust": ("[thrusters]\ntorque = 0", "thrusters.torque = 0: must be above zero"),
    "bit": ("[thrusters]\nmin_impulse = -1", "thrusters.min_impulse = -1: must not be negative"),
    "centre": ("[thrusters]\ncentred = 1", "thrusters.centred = 1: must be true or false"),
    "name": ('[message]\nobject_name = "Nano"', "message.object_name = 'Nano': must be all upper"),
    "number": ("[message]\nobject_id = 1", "message.object_id = 1: must be text"),
    "frame": ('[message]\nepoch = "x"', "message = epoch: is not one of: creation_date, object_id"),
    "written": ('[message]\ncreation_date = "x"', "message.creation_date = 'x': must be YYYY-MM"),
    "plain": ("message = 1", "message = 1: must be a table of creation_date, object_id"),
    "orbit.height": ("[orbit]\nheight = 1", "orbit = height: is not one of: altitude, epoch"),
    "below": ("[orbit]\naltitude = -10", "orbit.altitude = -10: must be above the surface, km"),
    "on": ("[orbit]\naltitude = 0", "orbit.altitude = 0: must be above the surface, km"),
    "low": ("[orbit]\naltitude = 99.9", "altitude = 99.9: must be at least 100 km: no circular"),
    "far": ("[orbit]\naltitude = 1e9", "orbit.altitude = 1000000000.0: must be at most 100000 km"),
    "tilt": ("[orbit]\ninclination = 181", "orbit.inclination = 181: must be from 0 to 180"),
    "day": ('[orbit]\nepoch = "monday"', "orbit.epoch = 'monday': must be a date and time"),
    "early": (
        "[orbit]\nepoch = 0001-01-01T00:00:00+23:00",
        "orbit.epoch = 0001-01-01T00:00:00+23:00: must be in the years 1 to 9999, UTC",
    ),
    "late": ("[orbit]\nepoch = 9999-12-31T23:00:00-02:00", "-02:00: must be in the years 1 to 99"),
    "nan": ("[orbit]\nnode = nan", "orbit.node = nan: must be finite"),
    "inf": ("[wheels]\nmax_torque = inf", "wheels.max_torque = inf: must be finite"),
    "none": ("[wheels]\nmax_torque_rate = 0", "wheels.max_torque_rate = 0: must be from 1e-12"),
    "slow": (
        "[wheels]\nmax_torque_rate = 1e-320\nmax_momentum = 1.0",
        "wheels.max_torque_rate = 1e-320: must be from 1e-12 to 1e+12 N m/s",
    ),
    "store": ("[wheels]\nmax_momentum = 1e7", "max_momentum = 10000000.0: must be above zero, and"),
    "empty": ("[wheels]\nmax_momentum = 0", "max_momentum = 0: must be above zero, and at most"),
    "stored": ("[wheels]\nmomentum = [0, 0, -1e200]", "wheels.momentum[2] = -1e+200: must be at"),
    "air": ("[spacecraft]\ndrag_coefficient = 1e300", "drag_coefficient = 1e+300: must be from 0"),
    "magnet": ("[spacecraft]\ndipole = [1e308, 0, 0]", "dipole[0] = 1e+308: must be at most 1e+06"),
    "big": ("[spacecraft]\nsize = [1, 1, 2000]", "spacecraft.size[2] = 2000.0: must be at most"),
    "beside": ("[spacecraft]\noffset = [1e9, 1, 1]", "offset[0] = 1000000000.0: must be at most"),
    "huge": (
        '[wheels]\nmax_torque = "1e999"',
        "wheels.max_torque = [1.00000000000E+999]: is beyond",
    ),
    "full": ("[wheels]\nmax_momentum = 1\nmomentum = [0, -2, 0]", "wheels.momentum[1] = -2.0: is"),
    "gain": ("[controller]\nnatural_frequency = -0.1", "natural_frequency = -0.1: must not be neg"),
    "damping": ("[controller]\ndamping_ratio = -1", "damping_ratio = -1: must not be negative"),
    "switch": ("[controller]\nfeedforward = 1", "feedforward = 1: must be true or false"),
    "drag": ('[disturbances]\ndrag = "no"', "disturbances.drag = 'no': must be true or false"),
    "which": ("[disturbances]\nwind = true", "disturbances = wind: is not one of: dipole, drag"),
    "edge": ("[spacecraft]\nsize = [1, 0, 1]", "spacecraft.size[1] = 0.0: must be above zero"),
    "two": ("[spacecraft]\ndipole = [1, 2]", "spacecraft.dipole = [1, 2]: must have 3 numbers"),
    "word": ('[spacecraft]\noffset = [1, "x", 2]', "spacecraft.offset[1] = 'x': must be a finite"),
    "share": ("[spacecraft]\nspecular = 1.5", "specular = 1.5: must be a share, from 0 to 1"),
    "shares": ("[spacecraft]\nspecular = 0.6\ndiffuse = 0.5", "diffuse = 0.5: with specular"),
    "length": ("[run]\nlength = 0", "run.length = 0: must be above zero, and at most 100000 s"),
    "period": ("[run]\nlength = 1\nperiod = 2", "run.period = 2.0: must not be longer"),
    "instant": ("[run]\nlength = 1e-300\nperiod = 1e-300", "1e-300: must be at least 1e-09 s"),
    "long": ("[run]\nlength = 1e9", "run.length = 1000000000.0: must be above zero, and at"),
    "many": ("[run]\nperiod = 1e-9", "run.period = 1e-09: is for 1000000 samples at most"),
    "sharp": ("[run]\ntolerance = 1e-20", "run.tolerance = 1e-20: must be from 1e-14 to 1e-3"),
    "uncertain": ('[orbit]\naltitude = "600 +/- 1"', "orbit.altitude = '600 +/- 1': must be"),
    "table": ("orbit = 600", "orbit = 600: must be a table of altitude, epoch"),
}


@pytest.mark.parametrize(("text", "message"), BAD.values(), ids=BAD)
def test_what_cannot_be_is_refused_in_one_line(text, message):
    with pytest.raises(InputError) as refused:
        read(tomllib.loads(text))
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_table_is_any_mapping_and_nothing_else():
    paper = read({"orbit": MappingProxyType({"altitude": 700})})
    assert paper.orbit == read({"orbit": {"altitude": 700}}).orbit
    for table in (None, paper.orbit):
        with pytest.raises(InputError, match=r"^orbit = .*: must be a table of "):
            read({"orbit": table})
    with pytest.raises(InputError, match=r"^wheels\.max_momentum = None: must be a number$"):
        read({"wheels": {"max_momentum": None}})
