"""Texts and cards of values are well formed, escaped, reproducible and short."""

import copy
import json
import os
import pickle
import re
import subprocess
import sys
from fractions import Fraction
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from html_cards import well_formed
from manoeuvre_flights import INERTIA, known, short
from validation_reports import whole

from derivations import lie_algebra
from derivations.setting import Setting
from rigidsym import TorqueFreeMotion, generate, plan
from rigidsym.io.cases import paper_case
from rigidsym.io.ledger import ledger_text
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._results import Tracked
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.claims import Claim, claims, load_ipython_extension
from rigidsym.proof.derivation import Chapter, Derivation
from rigidsym.proof.kernel import Grade
from rigidsym.proof.paper import EQUATIONS, Ruling, verdicts
from rigidsym.solution import sealed
from rigidsym.validate._report import Failure, ValidationReport
from rigidsym.view._cards import TINTS
from rigidsym.view._motions import number

LEDGER = json.loads(ledger_text())
FACTS = claims()
RULED = {verdict.equation.number: verdict for verdict in verdicts(LEDGER)}
BODY, RATES = ("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")
SMALLEST = "circulation about the axis of smallest inertia"
START, TARGET = (1, 0, 0, 0), ("0.5", "-0.1", "-0.5", "0.7")


def card_of(value):
    """Return the words of a value's card, which is well formed."""
    return well_formed(value._repr_html_())


@pytest.mark.parametrize("name", FACTS)
def test_a_fact_shows_hypotheses_statement_and_grade(name):
    claim = FACTS[name]
    html = claim._repr_html_()
    shown = well_formed(html)
    assert name in shown
    assert claim.grade in shown
    assert re.search(r"\\vdash|\\models|=", shown)
    assert claim._repr_latex_() == f"${claim.latex}$"
    assert len(html) < 60_000


@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda e: e.number)
def test_an_equation_shows_the_print(equation):
    assert equation.latex in card_of(equation)
    assert equation._repr_latex_() == f"${equation.latex}$"


@pytest.mark.parametrize("number", RULED)
def test_a_verdict_shows_ruling_print_and_derivation(number):
    verdict = RULED[number]
    shown, equation = card_of(verdict), verdict.equation
    parts = (f"({number})", verdict.ruling, equation.latex, equation.repair, *verdict.proved_by)
    assert [part for part in parts if part not in shown] == []
    assert ("fails at" in shown) == bool(verdict.counterexample)
    assert verdict._repr_latex_() == f"${equation.repair or equation.latex}$"
    assert {*verdict.proved_by, *verdict.refuted_by} <= {*FACTS.behind(verdict)}


def test_few_hypotheses_stand_before_the_turnstile_and_many_by_name():
    assert FACTS["half_tangent.roots"].latex.startswith(r"\mathrm{root}^{2} - y^{2}")
    assert FACTS["body.lax"].latex.startswith(r"\mathrm{body} \vdash")


def test_every_grade_and_ruling_has_its_tint():
    assert {*map(str, Grade), *map(str, Ruling)} <= {*TINTS}


def test_what_is_embedded_is_escaped():
    fact = {"id": "<script>x", "context": "a<b", "kind": "equal", "lhs": ["a"], "rhs": ["b"]}
    fact |= {"grade": "<i>", "rule": "&", "source": ["<script>"]}
    shown = Claim(fact)._repr_html_()
    assert "<script" not in shown
    assert "&lt;script&gt;x" in shown
    well_formed(shown)


def test_facts_are_listed_and_chosen():
    assert len(FACTS) == len(LEDGER["facts"])
    card_of(FACTS)
    cited = FACTS.citing("34")
    assert "sine_motion.split" in cited
    card_of(cited)
    with pytest.raises(KeyError):
        FACTS["no.such"]


@pytest.fixture(scope="module")
def ledger():
    """The kernel's ledger of one chapter."""
    written = LedgerBuilder()
    written.keep(Setting())
    lie_algebra.derive(written)
    return written.ledger


def test_a_ledger_of_the_kernel_shows_the_same_as_its_text(ledger):
    for found in (claims(ledger), claims(ledger.to_text())):
        for name, claim in found.items():
            assert claim._repr_html_() == FACTS[name]._repr_html_()


def test_ipython_shows_bare_facts_and_ledgers(ledger):
    formatters = pytest.importorskip("IPython.core.formatters")
    formatter = formatters.DisplayFormatter()
    load_ipython_extension(SimpleNamespace(display_formatter=formatter))
    for value in (ledger.facts["SU2.unitary"], ledger):
        data, _ = formatter.format(value)
        assert "SU2.unitary" in well_formed(data["text/html"])


def test_derivations_show_chapters_without_times(ledger):
    facts = tuple(ledger.facts.values())
    chapters = [Chapter("lie_algebra", "SU(2) < all", facts, seconds) for seconds in (1.0, 2.0)]
    first, second = (Derivation((chapter,), "")._repr_html_() for chapter in chapters)
    assert first == second
    assert f"{len(facts)} facts in 1 chapter" in well_formed(first)
    assert "SU(2) < all" in card_of(chapters[0])


@pytest.mark.parametrize("omega0", [(1, 2, 3), (0, 0, 0), ("1 +/- 1e-9", 2, "-3e-20")])
def test_a_motion_shows_what_it_was_made_from(omega0):
    motion = TorqueFreeMotion(("0.9", 1, 1.5), omega0)
    shown = card_of(motion)
    assert str(motion.regime) in shown
    assert r"(c_1, c_2, c_3) = (0.9,\ 1,\ 1.5)" in shown
    assert r"\mathrm{rad/s}" in shown
    assert motion._repr_latex_().startswith("$(c_1, c_2, c_3) = ")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (FACTS["moving_body.print_remark_2a"], (r"\neq", r"q_{0} = \frac{3}{5}")),
        (
            TorqueFreeMotion((1, 2, "2.25"), ("0.75 +/- 1e-3", "0.5", 1)),
            ("regime not certain",),
        ),
        (paper_case(), ("181 times, 0 s to 180 s",)),
    ],
    ids=["counterexample", "regimes", "times"],
)
def test_a_card_has_the_words(value, words):
    shown = card_of(value)
    assert all(word in shown for word in words)


def test_a_report_shows_the_verdict_first():
    report = whole()
    shown = card_of(report)
    assert shown.startswith("Validation passed")
    assert all(stratum in shown for stratum in report.campaign.strata)
    failure = Failure("numpy", "angle", 37.2, "uniform", 1, report.worst[0])
    broken = ValidationReport(report.campaign, report.tally, report.worst, (failure,))
    shown = card_of(broken)
    assert shown.startswith("Validation NOT PASSED")
    assert failure.line in shown


def planned(target=TARGET, **more):
    return plan(INERTIA, START, target, 120, engine="numpy", **more)


@pytest.fixture(scope="module")
def found():
    return planned(families=3)


def test_a_plan_shows_what_was_asked_and_all_transfers(found):
    shown = card_of(found)
    assert shown.startswith("Plan 3 transfers, 120 s")
    assert r"(c_1, c_2, c_3) = (0.0109,\ 0.04,\ 0.0506)" in shown
    assert all(name in shown for name in found.table()[0])
    assert shown.count("circulation about") == 3
    assert "max_" not in shown
    assert "spin" not in shown


def test_a_plan_has_a_line_for_each_transfer(found):
    title, names, *rows = repr(found).splitlines()
    assert title == "Plan: 120 s"
    assert "cost (N m s)" in names
    assert len(rows) == 3
    regimes = [one.motion.regime for one in found.transfers]
    assert all(row.endswith(regime) for row, regime in zip(rows, regimes, strict=True))
    assert max(map(len, rows)) < 170


def test_transfers_and_manoeuvres_take_a_line(found):
    best = repr(found.best)
    assert best.startswith("<Transfer omega0=(-0.0111854, ")
    assert f"{found.best.cost:.6g} N m s" in best
    asked = "from (1, 0, 0, 0) to (0.5, '-0.1', -0.5, '0.7') in 120 s"
    assert repr(found.manoeuvre).startswith(f"<Manoeuvre {asked}, inertia=")


@pytest.mark.parametrize(
    ("asked", "of_plan", "of_best", "absent"),
    [
        ({}, [], [r"({-0.01119},\ {-0.007836},\ 0.01407)", "< 10^{-1"], []),
        (
            {"max_rate": "0.3", "max_burst": "0.01", "target_spin": (0, 0, "0.01")},
            [r"\Omega(T^+) = (0,\ 0,\ 0.01)", "max_rate", "max_burst"],
            [],
            ["start_spin"],
        ),
        ({"target": START}, ["rest"], ["rest"], []),
    ],
)
def test_plans_and_transfers_show_what_belongs_to_them(asked, of_plan, of_best, absent):
    plan = planned(**asked)
    shown, best = card_of(plan), card_of(plan.best)
    assert str(plan.best.motion.regime) in best
    assert all(text in shown for text in of_plan)
    assert all(text in best for text in of_best)
    assert not any(text in shown for text in absent)


def test_rounding_beside_a_spin_is_not_shown():
    shown = card_of(planned((0, 0, 0, 1)).best)
    assert shown.count(r"(0,\ 0,\ ") == 4
    assert "10^{-2" not in shown


def tracked(length):
    asked, transfer = known(duration=10, omega0=(0.01, 0.02, -0.01))
    flight = short(length)
    return Tracked(asked, flight, transfer, fly(asked, flight, transfer))


@pytest.mark.parametrize(("length", "verdict"), [(40, "settled"), (11, "missed"), (5, "under way")])
def test_a_flight_shows_its_verdict_first(length, verdict):
    flown = tracked(length)
    shown = card_of(flown)
    assert shown.startswith(f"Flight {verdict} ")
    assert all(name in shown for name, _ in flown.rows()[:-2])
    assert "unexplained" not in shown
    if length == 11:
        shown = card_of(flown.run)
        assert shown.startswith("Flight 11 s, 111 samples")
        assert "torque peaks" in shown


def test_a_flight_in_a_terminal_has_its_errors():
    flown = tracked(20)
    shown = repr(flown)
    assert shown.startswith("Flight")
    assert "tracking error, greatest and rms" in shown
    assert repr(flown.run).startswith("Flight: 20 s, ")
    assert len(shown) < 1500


def test_a_motion_in_a_terminal_has_its_numbers_as_given_and_its_regime():
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
def test_long_numbers_are_cut_after_a_dozen_digits(value):
    assert len(number(value)) < 30
    assert number(value).endswith("...'")


def test_big_things_are_short():
    modules = generate("numpy"), generate("c")
    things = [*modules, sealed(), paper_case(), *EQUATIONS, *RULED.values()]
    assert max(len(repr(thing)) for thing in things) < 300
    assert "torque_free.py (" in repr(modules[0])
    assert "<Verdict on (10): misprint>" in map(repr, RULED.values())


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


PROGRAM = """
from rigidsym.io.cases import paper_case
from rigidsym.proof.claims import claims
from rigidsym.proof.derivation import derive
from rigidsym.view._article import article
from rigidsym.view.scenes import momentum_sphere, rolling_ellipsoid, tumbling_body
motion = paper_case().motion
chapters = derive(("euler_lax", "kinematics")).chapters
shown = [c._repr_html_() + c._repr_latex_() for c in [*claims().values()][::9]]
shown += [motion._repr_html_(), motion._repr_latex_()]
shown += [draw(motion).to_json() for draw in (momentum_sphere, rolling_ellipsoid, tumbling_body)]
print(*(article(chapters, form) for form in ("text", "latex")), *shown, sep="\\f")
"""


def test_the_same_bytes_whatever_the_hash_seed():
    fixed = {"PYTHONPATH": ":".join(sys.path), "PYTHONIOENCODING": "utf-8"}
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", PROGRAM],
            stdout=subprocess.PIPE,
            env={**os.environ, **fixed, "PYTHONHASHSEED": seed},
        )
        for seed in ("1", "2")
    ]
    first, second = (run.communicate()[0] for run in runs)
    assert [run.returncode for run in runs] == [0, 0]
    assert first == second
    for text in first.split(b"\f")[:2]:
        assert b"body.lax" in text.replace(rb".\allowbreak ", b".")
