"""A step shows itself as a line: what was done, its equations, numbers, conditions and fact."""

import sympy

from rigidsym.proof.algebra import Book, Part
from rigidsym.proof.steps import Desk, Step, differentiate, solve
from rigidsym.proof.steps.names import symbol, symbols

x, y, a = symbols("x y a")


def solved(source: tuple[str, ...] = ("28",)) -> Step:
    part = Part(witness={"x": "1", "y": "1", "a": "1"}, units=("a",))
    desk = Desk.open(Book(), "plane", part, static=True)
    return solve(desk, "plane.found", [(a * x, y)], [x], "solve for M1 < M2", source)


def test_a_line_of_html_has_all_that_is_to_be_said_and_no_raw_angle_bracket():
    html = solved()._repr_html_()
    assert r"x = \frac{y}{a}" in html
    assert "(28)" in html
    assert "<code>plane.found</code>" in html
    assert r"where </span><span>\(a \neq 0\)" in html
    assert r"Solve for <span>\(M_{1}\)</span> &lt; <span>\(M_{2}\)</span>:" in html


def test_a_line_without_conditions_has_no_where():
    moving = Part(witness={"x": "1"}, rates={"x": "2*x"})
    step = differentiate(Desk.open(Book(), "moving", moving), "moving.x", x**2, "its rate")
    assert "where" not in step._repr_html_()
    assert step._repr_latex_() == r"$$\frac{d}{dt}\left(x^{2}\right) = 4 x^{2}$$"


def test_a_line_of_latex_is_tagged_by_the_papers_numbers():
    assert solved()._repr_latex_() == r"$$x = \frac{y}{a}\tag*{(28)}$$"
    bare = solved(("R^-1 dR/dt",))._repr_latex_()
    assert bare.endswith(r"\tag*{$R^{-1}\dot R$}$$")


def test_several_equations_are_aligned():
    part = Part(witness={"x": "1", "y": "1"})
    desk = Desk.open(Book(), "plane", part, static=True)
    step = solve(desk, "plane.found", [(x + y, 1), (x - y, 3)], [x, y], "both")
    assert step._repr_latex_() == r"$$\begin{aligned}x &= 2 \\ y &= -1\end{aligned}$$"


def test_a_terminal_shows_the_line_in_two_dimensions():
    from IPython.lib.pretty import pretty

    shown = pretty(solved())
    assert shown.splitlines()[0] == "Solve for M1 < M2:  (28)"
    assert "[plane.found]" in shown
    assert repr(solved()) == "<solve: x = y/a [plane.found]>"


def test_constants_come_before_what_moves_and_sums_begin_with_a_plus():
    from rigidsym.view.article.mathematics import latex

    K, mu, rate = symbols("K mu Omega1")
    assert latex(sympy.cos(x) * rate * K) == r"K \Omega_{1} \cos {x}"
    assert latex(1 - mu * sympy.sin(x) ** 2) == r"1 - \mu \sin^{2} {x}"
    assert latex(-x - symbol("y")) == "-x - y"


def test_a_terminal_shows_the_rate_of_a_product():
    from rigidsym.proof.steps import Rate, matrix
    from rigidsym.view.article.mathematics import pretty

    R, M = matrix("R"), matrix("M")
    assert pretty(Rate(R * M)) == "d/dt (R\N{DOT OPERATOR}M)"
