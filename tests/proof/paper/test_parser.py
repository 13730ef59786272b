"""The parser reads all LaTeX of the paper and refuses anything else."""

import pytest

from rigidsym.language._expression import to_text
from rigidsym.proof.paper import EQUATIONS
from rigidsym.proof.paper._printed import PrintError, Statement, Words, parse

LINES = [(e.number, text) for e in EQUATIONS for text in (e.latex, e.repair) if text]


def shown(latex):
    """Return the statements of a display as texts."""
    pieces = []
    for piece in parse(latex):
        if isinstance(piece, Words):
            pieces.append(f'"{piece.text}"')
        else:
            signs = (*piece.relations, "")
            sides = zip(map(to_text, piece.sides), signs, strict=True)
            pieces.append(" ".join(x for side in sides for x in side).rstrip())
    return pieces


@pytest.mark.parametrize(("number", "latex"), LINES)
def test_every_printed_line_and_every_repair_is_read(number, latex):
    display = parse(latex)
    assert display
    assert all(isinstance(piece, Statement | Words) for piece in display)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\frac K{c_1}t", ["K / c_1 * t"]),
        (r"\tfrac12(a+b)c", ["1 / 2 * (a + b) * c"]),
        (r"\frac{\mathrm iK}2", ["imaginary * K / 2"]),
        (r"c_1^2\Omega_1^2", ["c_1**2 * Omega_1**2"]),
        (r"-c_2\Omega_2+a", ["-(c_2 * Omega_2) + a"]),
        (r"n=s_1/K^2", ["n = s_1 / K**2"]),
        (r"\cos\tfrac{\phi_1}2F_3", ["cos(phi_1 / 2) * F_3"]),
        (r"\mathrm{sn}^2(\xi t+\gamma,\mu)", ["sn(xi * t + gamma, mu)**2"]),
        (r"\mathrm{sn}^{-1}\!\left(x,\ m\right)", ["arcsn(x, m)"]),
        (r"\kappa\,\Pi(n;\vartheta|m)+D", ["kappa * Pi(n, vartheta, m) + D"]),
        (r"e^{-\mathrm i\phi_3}\sin\phi_2", ["e**(-(imaginary * phi_3)) * sin(phi_2)"]),
        (r"\exp(\phi_1A_1)\exp(\phi_2A_2)", ["exp(phi_1 * A_1) * exp(phi_2 * A_2)"]),
        (r"[A_1,A_3]=-A_2", ["bracket(A_1, A_3) = -A_2"]),
        (r"\bar R^{-1}\dot{\bar R}", ["Rbar**(-1) * D(Rbar)"]),
        (r"\dot\Omega_i(0)", ["at(D(Omega_i), 0)"]),
        (r"M(t)=R(t)^{-1}M(0)R(t)", ["at(M, t) = at(R, t)**(-1) * at(M, 0) * at(R, t)"]),
        (r"\sqrt{1+y^{\star2}}", ["sqrt(1 + y_star**2)"]),
        (r"\pm\sqrt{s_i}\,t+C_i", ["pm(sqrt(s_i) * t) + C_i"]),
        (r"\sigma\int f\,d\vartheta", ["sigma * integral(f * d(vartheta))"]),
        (r"\left|\frac{s_i}{s_j}\right|\le1", ["abs(s_i / s_j) <= 1"]),
        (r"|z_1|^2+|z_2|^2=1", ["abs(z_1)**2 + abs(z_2)**2 = 1"]),
        (r"a=b;\ c=f,\ l\ne k\ne i", ["a = b", "c = f", "l != k != i"]),
        (r"\begin{pmatrix}a&-b\\c&0\end{pmatrix}", ["matrix(a, -b, c, 0)"]),
        (r"a=b\ \text{when}\ |m|>1", ["a = b", '"when"', "abs(m) > 1"]),
        (
            r"x=a\ \text{when}\ s\ge0,\ b\ \text{otherwise}",
            ["x = a", '"when"', "s >= 0", "x = b", '"otherwise"'],
        ),
    ],
)
def test_the_papers_vocabulary(latex, expected):
    assert shown(latex) == expected


@pytest.mark.parametrize(
    "latex",
    [
        *(r"a=b)", r"a=(b", r"a=b}", r"\frac{a}", r"a=", r"a^"),
        *(r"\begin{pmatrix}a&b\\c\end{pmatrix}", r"[a,b", r"\lambda=1", r"a=b@c", r"a+", r"\sqrt"),
        *(r"S_i=\pm",),
    ],
)
def test_what_is_left_over_or_missing_is_an_error(latex):
    with pytest.raises(PrintError):
        parse(latex)
