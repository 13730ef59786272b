"""Articles have every fact in every form, define their symbols, and their LaTeX compiles."""

import re
import shutil
import subprocess
import sys
from functools import cache
from itertools import chain
from pathlib import Path

import pytest
import sympy
from browsers import chromium, needs_browser
from html_cards import Elements
from sympy.printing.pretty.pretty_symbology import pretty_use_unicode

from derivations import CHAPTERS, FORWARD
from derivations.setting import Setting
from rigidsym._cli import main
from rigidsym.proof.algebra import LedgerBuilder, Part
from rigidsym.proof.algebra._computation import Standing, joined, reasons, standing
from rigidsym.proof.derivation import derive
from rigidsym.proof.steps import Rate, Scope, Step, differentiate, matrix, rate_of, solve
from rigidsym.proof.steps._names import symbol, symbols
from rigidsym.view._article import (
    FORMATS,
    _told,
    article,
    latex,
    markdown_display,
    opening,
    pretty,
)
from rigidsym.view._prose import displayed_formula
from rigidsym.view._statements import numbers

# What may stick out of a line, in points of TeX.
STICKS_OUT = 1.0
VARIANTS = [
    Setting(),
    Setting((3, 1, 3), 2, sympy.Integer(1), -1),
    Setting(lagrangian=f"{Setting().lagrangian} + h1*Omega1 - c12*Omega1*Omega2"),
    Setting((3, 2, 1), 1, sympy.Integer(1), group="SO3"),
]
# How each form shows the name of a fact, without what LaTeX needs to break and to escape it.
NAMED = {"text": "[{}]", "markdown": "`{}`", "latex": r"\fact{{{}}}", "html": ">{}<"}


@cache
def derived(k=0):
    """Return the chapters of a variant, derived once."""
    return derive((), setting=VARIANTS[k]).chapters


@cache
def of_the_paper():
    """Return the paper's derivation, derived once."""
    return derive()


def whole():
    return of_the_paper().chapters


def every_step():
    return [step for chapter in whole() for step in chapter.steps]


@cache
def written(form):
    if form == "html":
        pytest.importorskip("latex2mathml", reason="needs latex2mathml (extra docs)")
    return article(whole(), form)


@pytest.mark.parametrize("form", FORMATS)
def test_facts_are_in_every_form_in_their_order_and_with_their_numbers(form):
    text = written(form)
    bare = text.replace(r"\_\allowbreak ", "_").replace(r".\allowbreak ", ".")
    facts = [fact for chapter in whole() for fact in chapter.facts]
    assert len(facts) > 600
    place = 0
    for fact in facts:
        place = bare.index(NAMED[form].format(fact.id), place)
    cited = {numbers(s.source) for s in every_step() if all(n[0].isdigit() for n in s.source)}
    assert len(cited) > 20
    assert {number for number in cited if number not in text} == set()


def test_every_chapter_has_an_article_of_its_own():
    assert [chapter.name for chapter in whole()] == list(CHAPTERS)
    for chapter in whole():
        text = article([chapter], "text")
        assert chapter.title in text
        assert all(f"[{fact.id}]" in text for fact in chapter.facts)
        about = {fact.context for fact in chapter.facts}
        assert all(re.search(rf"^Context {name}[:.,]", text, re.MULTILINE) for name in about)


# Words of LaTeX that are no names: of layout, of functions and of constants.
LAYOUT = {
    *("begin", "end", "left", "right", "frac", "sqrt", "cos", "sin", "tan", "tanh", "sinh", "cosh"),
    *("exp", "mathrm", "operatorname", "quad", "cdot", "text", "dot", "bar", "big", "bigl", "bigr"),
    *("geq", "neq", "mid", "matrix", "int", "partial", "dagger"),
}
NAME = re.compile(
    r"\\(?:mathrm|operatorname|text)\{(?P<word>[^}]*)\}"
    r"|\\(?P<command>[A-Za-z]+)|(?P<letter>[A-Za-z])"
)
INDEX = re.compile(r"_\{((?:[^{}]|\{[^{}]*\})*)\}")
CONSTANTS = {"i", "I", "d", "e", "or ", "matrix", "pi"}


def symbols_of(row):
    """Return the letters and words of a row of LaTeX, without indices."""
    bare = INDEX.sub("", row.replace(r"\frac{d}{dt}", ""))
    words = {m["word"] or m["command"] or m["letter"] for m in NAME.finditer(bare)}
    return {x for x in words if x not in LAYOUT | CONSTANTS}


def introduced(paragraph):
    """Return the symbols that a paragraph on a context introduces."""
    parts = [*paragraph.sentence, *chain(*paragraph.entries, *paragraph.after)]
    texts = [*paragraph.rows, *(x.latex for x in parts if hasattr(x, "latex"))]
    return set().union(*map(symbols_of, texts)) if texts else set()


@pytest.mark.parametrize("alone", [False, True])
def test_symbols_are_defined_before_they_are_used(alone):
    groups = [[chapter] for chapter in whole()] if alone else [whole()]
    for chapters in groups:
        known = {"jacobi", "sn", "cn", "dn", "am", "Pi", "mathbb"}
        for _, paragraphs in _told(chapters):
            for paragraph in paragraphs:
                if paragraph.fact:
                    used = (
                        set().union(*map(symbols_of, paragraph.rows)) if paragraph.rows else set()
                    )
                    assert used <= known, (paragraph.fact, used - known)
                else:
                    known |= introduced(paragraph)


@pytest.mark.parametrize("form", FORMATS)
def test_no_line_is_ragged(form):
    assert written(form).endswith("\n")
    assert not [line for line in written(form).splitlines() if line != line.rstrip()]


def test_all_chapters_up_to_theorem_1_are_in_it():
    assert [chapter.name for chapter in derived(1)] == list(FORWARD)
    assert all(chapter.title in article(derived(1), "text") for chapter in derived(1))


def test_conditions_and_free_quantities_are_said():
    conditions = sum(len(step.conditions) for step in every_step())
    assert conditions > 5
    lines = [line for line in written("markdown").splitlines() if line.startswith("where ")]
    assert sum(line.count(r"\neq 0$") for line in lines) == conditions
    assert "b_free is free" in written("text")


@pytest.mark.parametrize("k", [None, *range(1, len(VARIANTS))])
def test_latex_compiles_and_nothing_sticks_out(k, tmp_path):
    pdflatex = shutil.which("pdflatex")
    if pdflatex is None:
        pytest.skip("pdflatex is not installed (Debian: texlive-latex-recommended)")
    source = tmp_path / "article.tex"
    text = written("latex") if k is None else article(derived(k), "latex")
    assert r"\cdots" not in text  # no sum is shown in part
    source.write_text(text, "utf-8")
    command = [pdflatex, "-interaction=nonstopmode", "-halt-on-error", source.name]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    log = (tmp_path / "article.log").read_text("utf-8", errors="replace")
    assert ran.returncode == 0, log[-2000:]
    assert not [line for line in log.splitlines() if line.startswith("!")]
    wide = [float(x) for x in re.findall(r"Overfull \\[hv]box \(([0-9.]+)pt", log)]
    assert max(wide, default=0.0) <= STICKS_OUT


def test_html_is_well_formed():
    text = written("html")
    assert text.startswith("<!doctype html>\n")
    Elements(text)
    shown = [paragraph for _, found in _told(whole()) for paragraph in found if paragraph.rows]
    parts = [part for chapter in whole() for is_formula, part in opening(chapter) if is_formula]
    formulas = [part for part in parts if displayed_formula(part)]
    assert len(formulas) > 20
    assert text.count('<div class="equations"') == len(shown) + len(formulas)
    assert "merror" not in text
    anchors = re.findall(r' id="([^"]+)"', text)
    assert len(anchors) == len({*anchors})
    assert {*re.findall(r'href="#([^"]+)"', text)} <= {*anchors}


@needs_browser
def test_pages_fit_a_phone_and_fractions_do_not_collide(tmp_path):
    page = tmp_path / "article.html"
    page.write_text(written("html"), "utf-8")
    with chromium(tmp_path / "profile") as browser:
        phone = {"width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True}
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", phone)
        browser.get(page.as_uri())
        assert browser.execute_script("return document.documentElement.scrollWidth") <= 390
        # Rows of equations one below the other: pairs whose fractions overlap, and how many.
        collide, rows = browser.execute_script(COLLISIONS)
        assert rows > 1000
        assert collide == []
        # What is wider than the page scrolls by itself.
        assert browser.execute_script(SCROLLING) > 100


COLLISIONS = """
let collide = [], rows = 0;
for (const table of document.querySelectorAll('.equations > math mtable')) {
  let below = -Infinity;
  for (const row of table.children) {
    const parts = [...row.querySelectorAll('mfrac, mn, mi')].map(x => x.getBoundingClientRect());
    if (!parts.length) continue;
    rows += 1;
    const top = Math.min(...parts.map(x => x.top));
    if (top < below) collide.push(row.textContent.slice(0, 60));
    below = Math.max(...parts.map(x => x.bottom));
  }
}
return [collide, rows];
"""
SCROLLING = """
const wide = x => x.scrollWidth > x.clientWidth;
return [...document.querySelectorAll('.equations')].filter(wide).length;
"""


def test_html_passes_a_parser_of_html5():
    html5lib = pytest.importorskip("html5lib", reason="needs html5lib, of no extra")
    html5lib.HTMLParser(strict=True).parse(written("html"))


def test_without_latex2mathml_it_is_one_line(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    assert main(["derive", "lie_algebra", "--format", "html"]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "--format html needs latex2mathml" in captured.err.splitlines()[-1]


def test_output_makes_its_folder(tmp_path, capsys):
    path = tmp_path / "not" / "there" / "article.md"
    assert main(["derive", "lie_algebra", "--format", "markdown", "-o", str(path)]) == 0
    assert capsys.readouterr().out == ""
    assert "\n## SU(2)" in path.read_text("utf-8")


def test_alternatives_and_slopes_are_told_from_equations_that_hold_together():
    text = written("latex")
    assert r"\frac{\partial H}{\partial M_{1}} = \frac{M_{1}}{c_{1}}".replace(" =", " &=") in text
    names, choices = (
        r"\left(\zeta^{2}, \xi^{2}, \mu\right) &= ",
        (
            r"\left(s_{i}, \alpha s_{j}, \frac{s_{i}}{s_{j}}\right)",
            r"\left(s_{j}, \alpha s_{i}, \frac{s_{j}}{s_{i}}\right)",
        ),
    )
    assert names + choices[0] + " \\\\\n" + r"\text{or }" + names + choices[1] in text
    matrix = r"\begin{matrix}0 & \frac{1}{2} \\ -\frac{1}{2} & 0\end{matrix}"
    assert rf"A_{{2}} &= \left[{matrix}\right]" in text


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["-o", "/dev/null/inside"], "output = /dev/null/inside: cannot be written"),
        (["--json"], "json = given: is not for --show and --format"),
    ],
)
def test_options_that_do_not_fit_are_one_line(options, message, capsys):
    assert main(["derive", "lie_algebra", "--show", *options]) == 2
    assert message in capsys.readouterr().err


R, M = matrix("R"), matrix("M")
MOVED = rate_of(symbol("Omega_i"))
x, y, a, K, mu, OMEGA = symbols("x y a K mu Omega1")


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (MOVED, r"\dot{\Omega}_{i}"),
        (MOVED**2, r"\dot{\Omega}_{i}^{2}"),
        (rate_of(x * y), r"\frac{d}{dt}\left(x y\right)"),
        (Rate(R), r"\dot{R}"),
        (Rate(R * M), r"\frac{d}{dt}\left(R M\right)"),
        (symbol("alpha") * symbol("Omega_i") ** 4, r"\alpha \Omega_{i}^{4}"),
        # Constants come before what moves, and sums begin with a plus.
        (sympy.cos(x) * OMEGA * K, r"K \Omega_{1} \cos {x}"),
        (1 - mu * sympy.sin(x) ** 2, r"1 - \mu \sin^{2} {x}"),
        (-x - y, "-x - y"),
        (-(x**2) / (2 * y), r"-\frac{x^{2}}{2 y}"),
        (sympy.sqrt(x) / y, r"\frac{\sqrt{x}}{y}"),
        (x**-y / 2, r"\frac{x^{-y}}{2}"),
        (1 / sympy.sqrt(x), r"\frac{1}{\sqrt{x}}"),
        (M * R - R * M, "M R - R M"),
        (-R.I * M, "-R^{-1} M"),
        (
            sympy.Matrix([[-sympy.I / 2, 1]]),
            r"\left[\begin{matrix}-\frac{i}{2} & 1\end{matrix}\right]",
        ),
        (sympy.Ne(x, 0), r"x \neq 0"),
    ],
)
def test_latex_as_the_paper_writes_it(expression, text):
    assert latex(expression) == text


@pytest.mark.parametrize("expression", [Rate(R * M), rate_of(x * y)])
def test_the_rate_of_a_product_in_a_terminal(expression):
    assert pretty(expression).startswith("d/dt (")
    assert pretty(Rate(R * M)) == "d/dt (R\N{DOT OPERATOR}M)"


def test_lines_do_not_depend_on_the_encoding_of_stdout():
    column = sympy.Matrix([sympy.Symbol("Omega1") / 2, 1])
    expected = pretty(column)
    before = pretty_use_unicode(False)
    try:
        assert pretty(column) == expected
        assert not pretty_use_unicode()
    finally:
        pretty_use_unicode(before)


def opened(**part):
    return Scope.open(LedgerBuilder(), "plane", Part(**part), static="rates" not in part)


def solved(source: tuple[str, ...] = ("28",)) -> Step:
    scope = opened(witness={"x": "1", "y": "1", "a": "1"}, units=("a",))
    return solve(scope, "plane.found", [(a * x, y)], [x], "solve for M1 < M2", source)


def moved() -> Step:
    scope = opened(witness={"x": "1"}, rates={"x": "2*x"})
    return differentiate(scope, "plane.x", x**2, "its rate")


def both() -> Step:
    scope = opened(witness={"x": "1", "y": "1"})
    return solve(scope, "plane.found", [(x + y, 1), (x - y, 3)], [x, y], "both")


@pytest.mark.parametrize(
    ("step", "text"),
    [
        (solved, r"x = \frac{y}{a}\tag*{(28)}"),
        (lambda: solved(("R^-1 dR/dt",)), r"x = \frac{y}{a}\tag*{$R^{-1}\dot R$}"),
        (moved, r"\frac{d}{dt}\left(x^{2}\right) = 4 x^{2}"),
        (both, r"\begin{aligned}x &= 2 \\ y &= -1\end{aligned}"),
    ],
)
def test_a_line_of_latex_is_aligned_and_tagged_by_the_papers_numbers(step, text):
    assert step()._repr_latex_() == f"$${text}$$"


def test_a_single_row_keeps_the_columns_of_its_matrices():
    row = r"R &= \left[\begin{matrix}1 & 0 \\ 0 & 1\end{matrix}\right]"
    assert markdown_display([row]) == rf"\begin{{aligned}}{row}\end{{aligned}}"
    assert markdown_display(["x &= 2"]) == "x = 2"


def test_a_line_of_html_has_all_that_is_to_be_said_and_no_raw_angle_bracket():
    html = solved()._repr_html_()
    assert r"x = \frac{y}{a}" in html
    assert "(28)" in html
    assert "<code>plane.found</code>" in html
    assert r"where </span><span>\(a \neq 0\)" in html
    assert r"Solve for <span>\(M_{1}\)</span> &lt; <span>\(M_{2}\)</span>:" in html
    assert "where" not in moved()._repr_html_()


def test_a_terminal_shows_the_line_in_two_dimensions():
    from IPython.lib import pretty as terminal

    shown = terminal.pretty(solved())
    assert shown.splitlines()[0] == "Solve for M1 < M2:  (28)"
    assert "[plane.found]" in shown
    assert repr(solved()) == "<solve: x = y/a [plane.found]>"


@pytest.mark.parametrize("form", ["latex", "markdown"])
def test_the_gradient_of_the_energy_is_no_rate(form):
    assert written(form).count(r"\frac{\partial H}{\partial M_{1}}") == 2  # derived, and printed
    assert r"\dot{H} &= \frac{M_{1}}{c_{1}}" not in written(form)


# What an article says of facts that were typed.

# A law is what results are held against: a hypothesis, a definition, an equation of motion.
LAWS = """
(3), q' = q (0, Omega)/2 with |q| = 1
(33), which phi1 was integrated from
Euler's equations for the direction of the momentum
Euler's equations, times the moments
X and Y of the double time satisfy the equations of X and Y
a change is the derivative by the parameter that D is about
a fixed direction turns in the body by its cross product with the rates
a point of the unit circle that turns at a rate
an integral has its integrand as rate
equations that S_t, C_t and D_t are the solutions of
equations that sn, cn and dn are the solutions of (DLMF 22.13)
phi1 has the rate (32), as `third_kind.phi1` says
s is the small turn along the momentum
the curves of sn, cn and dn
the energy and the square of the momentum stay what they are at t = 0
the potential falls by the work of its torque
the same as `eliminated.square`, with names for its coefficients
the size of the momentum stays what it is
w is the stereographic projection of the direction of the momentum
what changes with the time has its rate as change
"""


def of(kind):
    return [fact for chapter in whole() for fact in chapter.facts if standing(fact) == kind]


def test_laws_are_those_of_a_list_and_every_guess_has_a_reason():
    assert {why for fact in of(Standing.STATED) for why in reasons(fact)} == {*LAWS.split("\n")} - {
        ""
    }
    assert all(reasons(fact) for fact in of(Standing.GUESSED))


def test_results_about_matrices_are_guesses_and_no_laws():
    guessed = {fact.id for fact in of(Standing.GUESSED)}
    assert {"body.lax", "reduced.conjugate", "moving_body.momentum_is_constant"} <= guessed


def test_nine_in_ten_published_facts_are_computed():
    published = of_the_paper().published["facts"]
    assert published.total() == len(of_the_paper().formulas)
    assert published[Standing.COMPUTED] >= 0.9 * published.total()
    assert published[Standing.STATED] == 0
    by_hand = [fact.id for fact in of(Standing.COMPUTED) if joined(fact)]
    assert len(of_the_paper().formulas.intersection(by_hand)) <= 5


def test_the_page_on_proofs_has_these_counts():
    page = Path(__file__).parents[2] / "notebooks" / "site" / "pages" / "proofs.md"
    rows = dict(re.findall(r"^\| (\w+) \| (\d+ \| \d+) \|$", page.read_text("utf-8"), re.M))
    published = of_the_paper().published["facts"]
    assert rows == {str(kind): f"{len(of(kind))} | {published[kind]}" for kind in Standing}
