"""Real cases of Lemma 1: the roots (13) of each axis, in a motion about axis a.

On the middle axis both roots are squares, and so is alpha times either: the lemma is real.  On the
third axis one root is minus a square; then the condition of (10), |s_i/s_j| <= 1, and that of (16),
s_j >= s_i, differ, and the line that (10) chooses can have an imaginary amplitude.  On the
circulation axis both roots are squares but alpha times either is minus a square: Omega_a never
vanishes, and no real constants make it a sine amplitude.
"""

from sympy import discriminant

from derivations.lemma1 import INERTIA, Lemma1
from derivations.regular_form import REGULAR
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps._names import symbols

COMPARED = "Lemma 1's roots and rates are those of the regular form, but for signs"

# (13) calls s_i the root with + before the square root: the smaller one, where alpha < 0.
NAMED = Part(
    witness={"c_i": 3, "c_j": 2, "Omega_j": 0, "Omega_k": 4},
    definitions={
        "s_i": "root_j",
        "s_j": "root_k",
        "root_of_discriminant": "alpha*(s_i - s_j)",
    },
    nonnegative=("root_of_discriminant",),
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the signs of both roots for each axis, and when to choose (10) or (11)."""
    _circulating(builder)
    _middle(builder)
    _third(builder)
    _choice(builder)


def _circulating(builder: LedgerBuilder) -> None:
    """Prove that xi is imaginary on the circulation axis: alpha s is minus a square."""
    roots = Part(
        definitions={
            "alpha_a": "-(c_a - c_b)*(c_a - c_d)/(c_b*c_d)",
            "root_b": "-E_b/(c_a*(c_b - c_a))",
            "root_d": "E_d/(c_a*(c_a - c_d))",
        },
    )
    builder.open(join("circulating_axis", *REGULAR, roots))
    outer, inner = {"alpha_a*root_d": "-(lambda_)**2"}, {"alpha_a*root_b": "-(lambda_)**2*m_1"}
    builder.claim("circulating_axis.outer", outer, ["10", "16"], why=COMPARED)
    builder.claim("circulating_axis.inner", inner, ["10", "16"], why=COMPARED)
    squares = {"root_d": "A_a**2", "root_b": "m_1*A_a**2"}
    builder.claim("circulating_axis.roots", squares, ["10", "13"], why=COMPARED)
    # sn(C) = Omega_a/sqrt(s) is beyond 1 for the inner root; for the outer, dn(C) is imaginary.
    builder.claim(
        "circulating_axis.start",
        {
            "root_b - Omega_a**2": "-m*(A_a*cn)**2",
            "root_d - Omega_a**2": "m*(A_a*sn)**2",
        },
        ["12", "footnote 2"],
        why=COMPARED,
    )
    real = {"alpha_a*root_d": "lambda_**2", "alpha_a*root_b": "lambda_**2*m_1"}
    builder.refute("circulating_axis.real_rate", real, {}, ["10", "20", "21"])
    within = {"root_b - Omega_a**2": "m*(A_a*cn)**2"}
    builder.refute("circulating_axis.real_start", within, {}, ["12", "footnote 2"])


def _middle(builder: LedgerBuilder) -> None:
    """Prove that on the middle axis both roots, and alpha times either, are squares."""
    forms = {
        "alpha_b": "-(c_b - c_a)*(c_b - c_d)/(c_a*c_d)",
        "root_a": "E_a/(c_b*(c_a - c_b))",
        "root_d": "E_d/(c_b*(c_b - c_d))",
    }
    roots = {"root_a": "A_b**2", "m*root_d": "A_b**2"}
    rates = {"alpha_b*root_d": "lambda_**2", "alpha_b*root_a": "m*lambda_**2"}
    _state(builder, "middle_axis", forms, roots, rates)


def _third(builder: LedgerBuilder) -> None:
    """Prove that on the third axis one root is minus a square, and alpha times it a square."""
    forms = {
        "alpha_d": "-(c_d - c_a)*(c_d - c_b)/(c_a*c_b)",
        "root_a": "E_a/(c_d*(c_a - c_d))",
        "root_b": "E_b/(c_d*(c_d - c_b))",
    }
    roots = {"root_a": "A_d**2", "m*root_b": "-m_1*A_d**2"}
    rates = {"alpha_d*root_b": "lambda_**2*m_1", "alpha_d*root_a": "-m*lambda_**2"}
    _state(builder, "third_axis", forms, roots, rates)


def _state(
    builder: LedgerBuilder,
    axis: str,
    forms: dict[str, str],
    roots: dict[str, str],
    rates: dict[str, str],
) -> None:
    """State the roots of (13) on an axis, and alpha times them."""
    builder.open(join(axis, *REGULAR, Part(units=("m",), definitions=forms)))
    builder.claim(f"{axis}.roots", roots, ["10", "13"], why=COMPARED)
    builder.claim(f"{axis}.rates", rates, ["10", "16"], why=COMPARED)


def _choice(builder: LedgerBuilder) -> None:
    """Find motions where (10) and (16) choose differently, or (10) takes the root of s_i < 0.

    A point of such a context has the declared signs; that both sides differ there makes one strict.
    """
    differ = Part(
        definitions={"s_j_above_s_i": "s_j - s_i", "ratio_above_1": "s_i**2 - s_j**2"},
        nonnegative=("s_j_above_s_i", "ratio_above_1"),
    )
    lemma = builder.result(Lemma1)
    body = (INERTIA, lemma.moving, lemma.quartic, lemma.roots, NAMED)
    builder.open(join("two_conditions", *body, differ))
    alpha, beta, chi, x = symbols("alpha beta chi x")
    under = compute(alpha * x**2 + beta * x + chi).apply(discriminant, x)
    builder.root("two_conditions.names", "root_of_discriminant", under, ["13", "Remark 1"])
    builder.refute("two_conditions.differ", {"s_i**2": "s_j**2"}, {}, ["10", "16", "Remark 1"])
    negative = Part(
        witness={"Omega_k": 2},
        definitions={"minus_s_i": "-s_i", "ratio_below_1": "s_j**2 - s_i**2"},
        nonnegative=("minus_s_i", "ratio_below_1"),
    )
    builder.open(join("negative_root", *body, negative))
    builder.refute("negative_root.amplitude", {"s_i": "0"}, {}, ["10", "13"])
