"""Names and formulas in the prose of chapters."""

import pytest

from rigidsym.view._prose import displayed_formula, escaped, formulas
from rigidsym.view._statements import formula


def test_a_prime_is_a_rate_but_not_in_a_possessive():
    assert formulas("phi1' is it, psi's rate") == r"$\dot{\phi}_{1}$ is it, $\psi$'s rate"
    assert escaped("Omega_i^2 & more_") == r"$\Omega_{i}^{2}$ \& more\_"


def test_the_imaginary_unit_is_no_capital_letter():
    assert formula("re(I*u_1)").latex == r"\operatorname{Re}\left(i u_{1}\right)"


FORMULAS = {
    "T_4 = theta_2(z | q),    z = g (rho beta + i u_1),": [
        r"&T_{4} = \theta_{2}(z \mid q),\quad z = g (\rho \beta + i u_{1}),"
    ],
    "xi = (M x (l - dM))/K^2,    k = (x y/z) e^(-b)": [
        r"&\xi = (M \times (l - dM))/K^{2},\quad k = (x y/z) e^{-b}"
    ],
    "qbar_0 + q_a         = e^(i Lambda t) / N\n    q_b = e^b": [
        r"\bar{q}_{0} + q_{a} &= e^{i \Lambda t} / N",
        "q_{b} &= e^{b}",
    ],
    "a    stands for b\n    c    stands for d": [],
}


@pytest.mark.parametrize("text", FORMULAS)
def test_indented_formulas_become_latex_and_tables_of_words_do_not(text):
    assert displayed_formula(text) == FORMULAS[text]


def test_long_formulas_are_broken_after_commas():
    rows = displayed_formula(
        ",    ".join(f"x_{k} = alpha_{k} + beta_{k} + gamma_{k}" for k in range(8))
    )
    assert len(rows) > 1
    assert all(row.endswith(",") for row in rows[:-1])
