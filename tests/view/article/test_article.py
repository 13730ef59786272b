"""A derivation as an article: every step in every form, the same bytes, and LaTeX that compiles."""

import os
import re
import shutil
import subprocess
import sys

import pytest
import sympy
from html_cards import Elements
from sympy.printing.pretty.pretty_symbology import pretty_use_unicode

from derivations import FORWARD
from derivations.setting import Setting
from rigidsym._cli import main
from rigidsym.proof.algebra import LedgerBuilder, Part
from rigidsym.proof.derivation import Derivation, derive
from rigidsym.proof.steps import Rate, Scope, Step, differentiate, matrix, rate_of, solve
from rigidsym.proof.steps._names import symbol, symbols
from rigidsym.view._article import FORMATS, article, latex, numbers, pretty

# What may stick out of a line, in points of TeX.
STICKS_OUT = 1.0


@pytest.fixture(scope="module")
def derivation() -> Derivation:
    return derive((), setting=Setting())


def written(derivation: Derivation, form: str) -> str:
    if form == "html":
        pytest.importorskip("latex2mathml", reason="needs latex2mathml (extra docs)")
    return article(derivation.chapters, form)


def bare(text: str) -> str:
    """Without what LaTeX needs to break and to escape the name of a fact."""
    return text.replace(r"\_\allowbreak ", "_").replace(r".\allowbreak ", ".")


@pytest.mark.parametrize("form", FORMATS)
def test_every_step_is_in_every_form_in_its_order(derivation, form):
    text = bare(written(derivation, form))
    place = 0
    for chapter in derivation.chapters:
        assert chapter.steps
        for step in chapter.steps:
            name = {"latex": f"\\fact{{{step.fact.id}}}", "markdown": f"`{step.fact.id}`",
                    "html": f">{step.fact.id}<", "text": f"[{step.fact.id}]"}[form]  # fmt: skip
            place = text.index(name, place)


@pytest.mark.parametrize("form", FORMATS)
def test_the_numbers_of_the_paper_are_there(derivation, form):
    text = written(derivation, form)
    steps = [step for chapter in derivation.chapters for step in chapter.steps]
    cited = {numbers(step) for step in steps if all(n[0].isdigit() for n in step.source)} - {""}
    assert len(cited) > 20
    assert {number for number in cited if number not in text} == set()


def test_all_chapters_up_to_theorem_1_are_in_it(derivation):
    assert [chapter.name for chapter in derivation.chapters] == list(FORWARD)
    text = article(derivation.chapters, "text")
    assert all(chapter.title in text for chapter in derivation.chapters)


def test_conditions_are_said_where_they_arise(derivation):
    steps = [step for chapter in derivation.chapters for step in chapter.steps]
    conditions = sum(len(step.conditions) for step in steps)
    assert conditions > 5
    assert article(derivation.chapters, "text").count("    where ") >= conditions - 2
    assert article(derivation.chapters, "markdown").count(r"\neq 0") == conditions


def test_what_is_free_is_said(derivation):
    assert "b_free is free" in article(derivation.chapters, "text")


@pytest.mark.parametrize("form", FORMATS)
def test_no_line_is_ragged(derivation, form):
    text = written(derivation, form)
    assert text.endswith("\n") or form in ("text", "markdown")
    assert not [line for line in text.splitlines() if line != line.rstrip()]


PROGRAM = """
from rigidsym.proof.derivation import derive
from rigidsym.view._article import article
chapters = derive(("euler_lax", "kinematics")).chapters
print(article(chapters, "text"), article(chapters, "latex"), sep="\\f")
"""


def test_the_same_bytes_whatever_the_hash_seed():
    found = {
        subprocess.run(
            [sys.executable, "-c", PROGRAM], capture_output=True, check=True,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONIOENCODING": "utf-8"},
        ).stdout
        for seed in ("1", "2")
    }  # fmt: skip
    assert len(found) == 1
    for text in found.pop().split(b"\f"):
        assert b"body.lax" in text.replace(rb".\allowbreak ", b".")


VARIANTS = [
    Setting(),
    Setting((3, 1, 3), 2, sympy.Integer(1), -1),
    Setting(lagrangian=f"{Setting().lagrangian} + h1*Omega1"),
]


@pytest.mark.parametrize("setting", VARIANTS, ids=str)
def test_latex_compiles_and_nothing_sticks_out(setting, tmp_path):
    pdflatex = shutil.which("pdflatex")
    if pdflatex is None:
        pytest.skip("pdflatex is not installed (Debian: texlive-latex-recommended)")
    source = tmp_path / "article.tex"
    source.write_text(article(derive((), setting=setting).chapters, "latex"), "utf-8")
    command = [pdflatex, "-interaction=nonstopmode", "-halt-on-error", source.name]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    log = (tmp_path / "article.log").read_text("utf-8", errors="replace")
    assert ran.returncode == 0, log[-2000:]
    assert not [line for line in log.splitlines() if line.startswith("!")]
    wide = [float(x) for x in re.findall(r"Overfull \\hbox \(([0-9.]+)pt", log)]
    assert max(wide, default=0.0) <= STICKS_OUT


def test_html_is_well_formed(derivation):
    text = written(derivation, "html")
    assert text.startswith("<!doctype html>\n")
    Elements(text)
    steps = [step for chapter in derivation.chapters for step in chapter.steps]
    assert text.count("<math") == sum(len(s.shown) + len(s.conditions) for s in steps)


def test_html_passes_a_parser_of_html5(derivation):
    html5lib = pytest.importorskip("html5lib", reason="needs html5lib, of no extra")
    html5lib.HTMLParser(strict=True).parse(written(derivation, "html"))


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
    assert path.read_text("utf-8").startswith("## SU(2)")


def test_output_that_is_no_file_is_one_line(capsys):
    arguments = ["derive", "lie_algebra", "--show", "-o", "/dev/null/inside"]
    assert main(arguments) == 2
    assert "output = /dev/null/inside: cannot be written" in capsys.readouterr().err


def test_show_and_json_are_not_together(capsys):
    assert main(["derive", "lie_algebra", "--show", "--json"]) == 2
    assert "json = given: is not for --show and --format" in capsys.readouterr().err


R, M = matrix("R"), matrix("M")
MOVED = rate_of(symbol("Omega_i"))


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (MOVED, r"\dot{\Omega}_{i}"),
        (MOVED**2, r"\dot{\Omega}_{i}^{2}"),
        (rate_of(symbol("x") * symbol("y")), r"\frac{d}{dt}\left(x y\right)"),
        (Rate(R), r"\dot{R}"),
        (Rate(R * M), r"\frac{d}{dt}\left(R M\right)"),
        (symbol("alpha") * symbol("Omega_i") ** 4, r"\alpha \Omega_{i}^{4}"),
    ],
)
def test_latex_as_the_paper_writes_it(expression, text):
    assert latex(expression) == text


@pytest.mark.parametrize("expression", [Rate(R * M), rate_of(symbol("x") * symbol("y"))])
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


x, y, a = symbols("x y a")


def solved(source: tuple[str, ...] = ("28",)) -> Step:
    part = Part(witness={"x": "1", "y": "1", "a": "1"}, units=("a",))
    scope = Scope.open(LedgerBuilder(), "plane", part, static=True)
    return solve(scope, "plane.found", [(a * x, y)], [x], "solve for M1 < M2", source)


def test_a_line_of_html_has_all_that_is_to_be_said_and_no_raw_angle_bracket():
    html = solved()._repr_html_()
    assert r"x = \frac{y}{a}" in html
    assert "(28)" in html
    assert "<code>plane.found</code>" in html
    assert r"where </span><span>\(a \neq 0\)" in html
    assert r"Solve for <span>\(M_{1}\)</span> &lt; <span>\(M_{2}\)</span>:" in html


def test_a_line_without_conditions_has_no_where():
    moving = Part(witness={"x": "1"}, rates={"x": "2*x"})
    step = differentiate(
        Scope.open(LedgerBuilder(), "moving", moving), "moving.x", x**2, "its rate"
    )
    assert "where" not in step._repr_html_()
    assert step._repr_latex_() == r"$$\frac{d}{dt}\left(x^{2}\right) = 4 x^{2}$$"


def test_a_line_of_latex_is_tagged_by_the_papers_numbers():
    assert solved()._repr_latex_() == r"$$x = \frac{y}{a}\tag*{(28)}$$"
    bare = solved(("R^-1 dR/dt",))._repr_latex_()
    assert bare.endswith(r"\tag*{$R^{-1}\dot R$}$$")


def test_several_equations_are_aligned():
    part = Part(witness={"x": "1", "y": "1"})
    scope = Scope.open(LedgerBuilder(), "plane", part, static=True)
    step = solve(scope, "plane.found", [(x + y, 1), (x - y, 3)], [x, y], "both")
    assert step._repr_latex_() == r"$$\begin{aligned}x &= 2 \\ y &= -1\end{aligned}$$"


def test_a_terminal_shows_the_line_in_two_dimensions():
    from IPython.lib import pretty as terminal

    shown = terminal.pretty(solved())
    assert shown.splitlines()[0] == "Solve for M1 < M2:  (28)"
    assert "[plane.found]" in shown
    assert repr(solved()) == "<solve: x = y/a [plane.found]>"


def test_constants_come_before_what_moves_and_sums_begin_with_a_plus():
    K, mu, rate = symbols("K mu Omega1")
    assert latex(sympy.cos(x) * rate * K) == r"K \Omega_{1} \cos {x}"
    assert latex(1 - mu * sympy.sin(x) ** 2) == r"1 - \mu \sin^{2} {x}"
    assert latex(-x - symbol("y")) == "-x - y"
