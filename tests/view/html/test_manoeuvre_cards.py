"""Plans, transfers and flights show what was asked, what was found, and how it went."""

import pytest
from html_cards import well_formed
from manoeuvre_flights import INERTIA, known, short

from rigidsym import plan
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._results import Tracked

TARGET = ("0.5", "-0.1", "-0.5", "0.7")


def planned(**more):
    return plan(INERTIA, (1, 0, 0, 0), TARGET, 120, engine="numpy", **more)


def tracked(length, duration=10):
    asked, transfer = known(duration=duration, omega0=(0.01, 0.02, -0.01))
    flight = short(length)
    return Tracked(asked, flight, transfer, fly(asked, flight, transfer))


def test_a_plan_shows_what_was_asked_and_all_transfers():
    found = planned(families=3)
    shown = well_formed(found._repr_html_())
    assert shown.startswith("Plan 3 transfers, 120 s")
    assert r"(c_1, c_2, c_3) = (0.0109,\ 0.04,\ 0.0506)" in shown
    assert all(name in shown for name in found.table()[0])
    assert shown.count("circulation about") == 3
    assert "max_" not in shown
    assert "spin" not in shown


def test_limits_and_spins_are_shown_where_they_are_given():
    found = planned(max_rate="0.3", max_burst="0.01", target_spin=(0, 0, "0.01"))
    shown = well_formed(found._repr_html_())
    assert r"\Omega(T^+) = (0,\ 0,\ 0.01)" in shown
    assert "start_spin" not in shown
    assert "max_rate" in shown
    assert "max_burst" in shown


def test_a_transfer_shows_its_bursts_and_its_residual():
    best = planned().best
    shown = well_formed(best._repr_html_())
    assert str(best.motion.regime) in shown
    assert r"({-0.01119},\ {-0.007836},\ 0.01407)" in shown
    assert "< 10^{-1" in shown


def test_rounding_beside_a_spin_is_not_shown():
    best = plan(INERTIA, (1, 0, 0, 0), (0, 0, 0, 1), 120, engine="numpy").best
    shown = well_formed(best._repr_html_())
    assert shown.count(r"(0,\ 0,\ ") == 4
    assert "10^{-2" not in shown


def test_nothing_to_do_is_shown():
    still = plan(INERTIA, (1, 0, 0, 0), (1, 0, 0, 0), 120, engine="numpy")
    assert "rest" in well_formed(still._repr_html_())
    assert "rest" in well_formed(still.best._repr_html_())


@pytest.mark.parametrize(("length", "verdict"), [(40, "settled"), (11, "missed"), (5, "under way")])
def test_a_flight_shows_its_verdict_first(length, verdict):
    flown = tracked(length)
    shown = well_formed(flown._repr_html_())
    assert shown.startswith(f"Flight {verdict} ")
    assert all(name in shown for name, _ in flown.rows()[:-2])
    assert "unexplained" not in shown


def test_a_run_shows_itself():
    run = tracked(11).run
    shown = well_formed(run._repr_html_())
    assert shown.startswith("Flight 11 s, 111 samples")
    assert "torque peaks" in shown
