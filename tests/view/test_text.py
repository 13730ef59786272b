"""What objects say in a terminal: short, and what their cards say."""

import copy
import pickle
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from manoeuvre_flights import INERTIA, known, short

from rigidsym import TorqueFreeMotion, generate, plan
from rigidsym.io.cases import paper_case
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._results import Tracked
from rigidsym.proof.paper import EQUATIONS, verdicts
from rigidsym.solution import sealed
from rigidsym.view._motions import number

BODY, RATES = ("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")
SMALLEST = "circulation about the axis of smallest inertia"


def test_a_motion_says_its_numbers_as_they_were_given_and_its_regime():
    exact = TorqueFreeMotion(BODY, RATES)
    given = f"inertia={BODY}, omega0={RATES}"
    assert repr(exact) == f"<TorqueFreeMotion {given}: {SMALLEST}>"
    doubles = TorqueFreeMotion([float(x) for x in BODY], [float(x) for x in RATES])
    assert repr(doubles) == repr(exact).replace("'", "")
    turned = exact.replace(attitude0=(1, "1/3", 0, 0.5), omega0=(1, 0, 0))
    assert ", attitude0=(1, '1/3', 0, 0.5): spin>" in repr(turned)
    vague = exact.replace(omega0=("0 +/- 1", 0, 0))
    assert repr(vague).endswith("omega0=('0 +/- 1', 0, 0): regime not certain>")


@pytest.mark.parametrize(
    "value", [Fraction(1, 3**90), Fraction(10**400 + 1, 10**405), Fraction(2, 3) * 10**5000]
)
def test_long_numbers_are_told_by_a_dozen_digits(value):
    assert len(number(value)) < 30
    assert number(value).endswith("...'")


@pytest.fixture(scope="module")
def found():
    return plan(INERTIA, (1, 0, 0, 0), ("0.5", "-0.1", "-0.5", "0.7"), 120, families=3)


def test_a_plan_has_a_line_for_each_transfer(found):
    title, names, *rows = repr(found).splitlines()
    assert title == "Plan: 120 s"
    assert "cost (N m s)" in names
    assert len(rows) == 3
    regimes = [one.motion.regime for one in found.transfers]
    assert all(row.endswith(regime) for row, regime in zip(rows, regimes, strict=True))
    assert max(map(len, rows)) < 170


def test_what_a_plan_is_made_of_takes_a_line(found):
    best = repr(found.best)
    assert best.startswith("<Transfer omega0=(-0.0111854, ")
    assert f"{found.best.cost:.6g} N m s" in best
    asked = "from (1, 0, 0, 0) to (0.5, '-0.1', -0.5, '0.7') in 120 s"
    assert repr(found.manoeuvre).startswith(f"<Manoeuvre {asked}, inertia=")


def test_big_things_are_short():
    ledger = ledger_data(ledger_text())
    things = [generate("numpy"), generate("c"), sealed(), paper_case(), *EQUATIONS]
    things += verdicts(ledger)
    assert max(len(repr(thing)) for thing in things) < 300
    assert "torque_free.py (" in repr(generate("numpy"))
    assert "<Verdict on (10): misprint>" in map(repr, verdicts(ledger))


def test_a_flight_says_how_it_went():
    asked, transfer = known(duration=10, omega0=(0.01, 0.02, -0.01))
    flight = short(20)
    run = fly(asked, flight, transfer)
    shown = repr(Tracked(asked, flight, transfer, run))
    assert shown.startswith("Flight")
    assert "tracking error, greatest and rms" in shown
    assert repr(run).startswith("Flight: 20 s, ")
    assert len(shown) < 1500


def test_numbers_print_the_digits_that_are_certain():
    motion = TorqueFreeMotion(BODY, RATES)
    q, omega = motion.precise("180", digits=30)
    more = motion.precise("180", digits=60)[0][0]
    text = mpmath.nstr(more, 30)
    assert str(q[0]) == text
    assert f"mpf('{text}')" in repr(q)
    assert all(len(str(x).strip("-").removeprefix("0.").lstrip("0")) == 30 for x in (*q, *omega))
    assert (
        str(motion.precise([0, 1], digits=1000)[0][1, 0])[:32]
        == mpmath.nstr(motion.precise(1, digits=40)[0][0], 40)[:32]
    )


def test_they_are_numbers_of_mpmath_in_all_else():
    x = TorqueFreeMotion(BODY, RATES).precise("180", digits=50)[0][0]
    assert isinstance(x, mpmath.mpf)
    with mpmath.workdps(200):
        plain = mpmath.mpf(x)
        assert plain == x
        assert hash(plain) == hash(x)
        assert x - plain == 0
        assert mpmath.sqrt(x) == mpmath.sqrt(plain)
    assert type(x + 1) is type(-x) is type(abs(x)) is mpmath.mpf
    assert float(x) == np.array([x]).astype(float)[0] == float(plain)
    for same in (pickle.loads(pickle.dumps(x)), copy.deepcopy(x)):
        assert same == x
        assert repr(same) == repr(x)
