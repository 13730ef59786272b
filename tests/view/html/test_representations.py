"""What values show in a notebook: well formed, escaped, in the colours of the page, repeatable."""

import json
import re
import subprocess
import sys
from types import SimpleNamespace

import pytest
from html_cards import well_formed
from validation_reports import whole

from derivations import lie_algebra
from derivations.setting import Setting
from rigidsym import TorqueFreeMotion
from rigidsym.io.cases import paper_case
from rigidsym.io.ledger import ledger_text
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.claims import Claim, claims, load_ipython_extension
from rigidsym.proof.derivation import Chapter, Derivation
from rigidsym.proof.kernel import Grade
from rigidsym.proof.paper import EQUATIONS, Ruling, verdicts
from rigidsym.validate._report import Failure, ValidationReport
from rigidsym.view._cards import TINTS

LEDGER = json.loads(ledger_text())
FACTS = claims()
RULED = {verdict.equation.number: verdict for verdict in verdicts(LEDGER)}


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
    assert equation.latex in well_formed(equation._repr_html_())
    assert equation._repr_latex_() == f"${equation.latex}$"


@pytest.mark.parametrize("number", RULED)
def test_a_verdict_shows_ruling_print_and_derivation(number):
    verdict = RULED[number]
    shown = well_formed(verdict._repr_html_())
    assert f"({number})" in shown
    assert verdict.ruling in shown
    assert verdict.equation.latex in shown
    assert verdict.equation.repair in shown
    assert all(name in shown for name in verdict.proved_by)
    assert ("fails at" in shown) == bool(verdict.counterexample)
    assert verdict._repr_latex_() == f"${verdict.equation.repair or verdict.equation.latex}$"
    assert {*verdict.proved_by, *verdict.refuted_by} <= {*FACTS.behind(verdict)}


def test_few_hypotheses_stand_before_the_turnstile_and_many_by_name():
    assert FACTS["half_tangent.roots"].latex.startswith(r"\mathrm{root}^{2} - y^{2}")
    assert FACTS["body.lax"].latex.startswith(r"\mathrm{body} \vdash")


def test_a_counterexample_shows_its_point():
    shown = well_formed(FACTS["moving_body.print_remark_2a"]._repr_html_())
    assert r"\neq" in shown
    assert r"q_{0} = \frac{3}{5}" in shown


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
    well_formed(FACTS._repr_html_())
    cited = FACTS.citing("34")
    assert "sine_motion.split" in cited
    well_formed(cited._repr_html_())
    with pytest.raises(KeyError):
        FACTS["no.such"]


def builder():
    written = LedgerBuilder()
    written.keep(Setting())
    lie_algebra.derive(written)
    return written


def test_a_ledger_of_the_kernel_shows_the_same_as_its_text():
    ledger = builder().ledger
    for found in (claims(ledger), claims(ledger.to_text())):
        for name, claim in found.items():
            assert claim._repr_html_() == FACTS[name]._repr_html_()


def test_ipython_shows_bare_facts_and_ledgers():
    formatters = pytest.importorskip("IPython.core.formatters")
    formatter = formatters.DisplayFormatter()
    load_ipython_extension(SimpleNamespace(display_formatter=formatter))
    ledger = builder().ledger
    for value in (ledger.facts["SU2.unitary"], ledger):
        data, _ = formatter.format(value)
        assert "SU2.unitary" in well_formed(data["text/html"])


def test_derivations_show_chapters_without_times():
    facts = tuple(builder().ledger.facts.values())
    chapters = [Chapter("lie_algebra", "SU(2) < all", facts, seconds) for seconds in (1.0, 2.0)]
    first, second = (Derivation((chapter,), "")._repr_html_() for chapter in chapters)
    assert first == second
    assert f"{len(facts)} facts in 1 chapter" in well_formed(first)
    assert "SU(2) < all" in well_formed(chapters[0]._repr_html_())


@pytest.mark.parametrize("omega0", [(1, 2, 3), (0, 0, 0), ("1 +/- 1e-9", 2, "-3e-20")])
def test_a_motion_shows_what_it_was_made_from(omega0):
    motion = TorqueFreeMotion(("0.9", 1, 1.5), omega0)
    shown = well_formed(motion._repr_html_())
    assert str(motion.regime) in shown
    assert r"(c_1, c_2, c_3) = (0.9,\ 1,\ 1.5)" in shown
    assert r"\mathrm{rad/s}" in shown
    assert motion._repr_latex_().startswith("$(c_1, c_2, c_3) = ")


def test_a_motion_between_regimes_says_so():
    motion = TorqueFreeMotion((1, 2, "2.25"), ("0.75 +/- 1e-3", "0.5", 1))
    assert "regime not certain" in well_formed(motion._repr_html_())


def test_a_case_shows_its_times():
    assert "181 times, 0 s to 180 s" in well_formed(paper_case()._repr_html_())


def test_a_report_shows_the_verdict_first():
    report = whole()
    shown = well_formed(report._repr_html_())
    assert shown.startswith("Validation passed")
    assert all(stratum in shown for stratum in report.campaign.strata)


def test_a_report_that_fails_says_why():
    report = whole()
    failure = Failure("numpy", "angle", 37.2, "uniform", 1, report.worst[0])
    broken = ValidationReport(report.campaign, report.tally, report.worst, (failure,))
    shown = well_formed(broken._repr_html_())
    assert shown.startswith("Validation NOT PASSED")
    assert failure.line in shown


PROGRAM = """
import hashlib
from rigidsym.io.cases import paper_case
from rigidsym.proof.claims import claims
from rigidsym.view.scenes import momentum_sphere, rolling_ellipsoid, tumbling_body
motion = paper_case().motion
shown = [c._repr_html_() + c._repr_latex_() for c in [*claims().values()][::9]]
shown += [motion._repr_html_(), motion._repr_latex_()]
shown += [draw(motion).to_json() for draw in (momentum_sphere, rolling_ellipsoid, tumbling_body)]
print(hashlib.sha256("".join(shown).encode()).hexdigest())
"""


def test_the_same_bytes_whatever_the_hash_seed():
    found = {
        subprocess.run(
            [sys.executable, "-c", PROGRAM],
            capture_output=True,
            text=True,
            check=True,
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": ":".join(sys.path)},
        ).stdout
        for seed in ("0", "1")
    }
    assert len(found) == 1
