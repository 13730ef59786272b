"""Tests of the orbit, the shadow, the Sun and the field by known values."""

from datetime import UTC, datetime
from math import asin

import numpy as np
import ppigrf
import pytest

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import _sky as sky
from rigidsym.manoeuvre.flight._settings import Orbit
from rigidsym.manoeuvre.flight._sky import (
    ASTRONOMICAL_UNIT,
    MU,
    RADIUS,
    SUN_RADIUS,
    Path,
    sunlit,
)

SUN = [ASTRONOMICAL_UNIT, 0.0, 0.0]
EDGE, FAR = asin(RADIUS / 7e6), 4e9
RING = 1 - (asin(RADIUS / FAR) / asin(SUN_RADIUS / (ASTRONOMICAL_UNIT + FAR))) ** 2
NOON = datetime(2000, 1, 1, 12, tzinfo=UTC)


def test_the_papers_orbit():
    path = Path(Orbit(latitude_argument=0.0, node=30.0))
    position, velocity = path(0.0)
    np.testing.assert_allclose(position, path.radius * np.array([np.sqrt(0.75), 0.5, 0]), atol=1e-8)
    assert path.radius == 6978137.0
    assert 2 * np.pi / path.mean_motion == pytest.approx(5801.2, abs=0.1)
    normal = np.cross(position, velocity) / np.linalg.norm(np.cross(position, velocity))
    assert np.degrees(np.arccos(normal[2])) == pytest.approx(97.79)
    assert velocity[2] > 0


def test_the_orbit_is_keplers():
    path = Path(Orbit(latitude_argument=70.0))
    for t in (0.0, 100.0, 4000.0):
        position, velocity = path(t)
        assert position @ velocity == pytest.approx(0, abs=1e-3)
        assert velocity @ velocity * path.radius == pytest.approx(MU)
        step = (path(t + 0.1)[0] - path(t - 0.1)[0]) / 0.2
        np.testing.assert_allclose(step, velocity, rtol=1e-7, atol=1e-3)


@pytest.mark.parametrize(
    ("position", "share", "within"),
    [
        ([7e6, 0, 0], 1, 0),
        ([0, 7e6, 0], 1, 0),
        ([-7e6, 1e6, 0], 0, 0),
        # The edge's own curve hides a little less than half: the Sun is 1/245 of the Earth's width.
        ([-7e6 * np.cos(EDGE), 7e6 * np.sin(EDGE), 0.0], 0.5, 0.01),
        # On the surface, also where rounding puts the position below it.
        ([np.nextafter(RADIUS, 0), 0.0, 0.0], 1, 0),
        ([-np.nextafter(RADIUS, 0), 0.0, 0.0], 0, 0),
        # From afar a ring of the Sun is seen.
        ([-FAR, 0.0, 0.0], RING, 8e-7),
    ],
)
def test_day_and_night(position, share, within):
    assert sunlit(position, SUN) == pytest.approx(share, rel=0, abs=within)


def test_the_shadow_falls_steadily():
    angles = EDGE + np.linspace(-0.006, 0.006, 61)
    shares = [sunlit([-7e6 * np.cos(x), 7e6 * np.sin(x), 0.0], SUN) for x in angles]
    assert shares[0] == 0
    assert shares[-1] == 1
    assert np.all(np.diff(shares) >= 0)
    assert np.max(np.diff(shares)) < 0.06


def test_the_sun_of_the_almanac():
    """Compare with Meeus, Astronomical Algorithms, example 25.b, up to 7 years of precession."""
    (found,) = sky.sun_position(datetime(1992, 10, 13, tzinfo=UTC), np.array([0.0]))
    distance = np.linalg.norm(found)
    assert distance / ASTRONOMICAL_UNIT == pytest.approx(0.99760775, abs=2e-6)
    assert np.degrees(np.arcsin(found[2] / distance)) == pytest.approx(-7.78387, abs=0.1)
    ascension = np.degrees(np.arctan2(found[1], found[0])) % 360
    assert ascension == pytest.approx(198.37817, abs=0.15)


def test_the_earths_turn():
    turns = sky.earth_turn(NOON, np.array([0.0, 86164.0905]))
    # Greenwich sidereal time at that noon is 280.46 degrees; a day of the stars later, again.
    greenwich = np.degrees(np.arctan2(turns[:, 0, 1], turns[:, 0, 0])) % 360
    np.testing.assert_allclose(greenwich, 280.46, atol=0.01)
    np.testing.assert_allclose(turns[0] @ turns[0].T, np.eye(3), atol=1e-14)


def test_the_field_at_a_known_place():
    """Compare with ppigrf's own axes, 30 degrees from the pole and 4 degrees east."""
    epoch = datetime(2021, 3, 28, tzinfo=UTC)
    colatitude, longitude = np.radians([30.0, 4.0])
    across = np.array([np.cos(longitude), np.sin(longitude)])
    up = np.array([*np.sin(colatitude) * across, np.cos(colatitude)])
    (turn,) = sky.earth_turn(epoch, np.array([0.0]))
    (field,) = sky.magnetic_field(epoch, np.array([0.0]), 6.5e6 * (up @ turn)[None])
    radial, south, east = (part.item() * 1e-9 for part in ppigrf.igrf_gc(
        6500, 30.0, 4.0, epoch.replace(tzinfo=None)))  # fmt: skip
    assert np.linalg.norm(field) == pytest.approx(np.hypot(np.hypot(radial, south), east))
    assert turn @ field @ up == pytest.approx(radial)
    assert turn @ field @ [-np.sin(longitude), np.cos(longitude), 0] == pytest.approx(east)


def test_the_field_of_an_orbit_is_that_of_a_dipole_by_and_large():
    path, t = Path(Orbit()), np.linspace(0, 5800, 30)
    positions = np.array([path(x)[0] for x in t])
    field = sky.magnetic_field(datetime(2013, 7, 17, tzinfo=UTC), t, positions)
    up = positions / path.radius
    axis = np.array([0, 0, -1.0])
    dipole = 2.98e-5 * (RADIUS / path.radius) ** 3 * (3 * (up @ axis)[:, None] * up - axis)
    assert np.linalg.norm(field - dipole, axis=1).max() < 1.5e-5
    assert 1.6e-5 < np.linalg.norm(field, axis=1).min() < np.linalg.norm(field, axis=1).max() < 5e-5


@pytest.mark.parametrize("year", [1850, 2200])
def test_years_without_a_field(year):
    with pytest.raises(InputError, match=r"orbit\.epoch = .*known from 1900 to 2030"):
        sky.magnetic_field(datetime(year, 1, 1, tzinfo=UTC), np.array([0.0]), np.ones((1, 3)))


@pytest.mark.parametrize("year", [1800, 2150])
def test_the_sun_of_any_year(year):
    (found,) = sky.sun_position(datetime(year, 6, 21, tzinfo=UTC), np.array([0.0]))
    assert found[2] / np.linalg.norm(found) == pytest.approx(0.3978, abs=2e-3)
