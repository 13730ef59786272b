"""Real cases of Lemma 1: the roots (13) of each axis, in a motion about axis a.

On the middle axis both roots are squares, and so is alpha times either: the lemma is real.  On the
third axis one root is minus a square; then the condition of (10), |s_i/s_j| <= 1, and that of (16),
s_j >= s_i, differ, and the line that (10) chooses can have an imaginary amplitude.  On the
circulation axis both roots are squares but alpha times either is minus a square: Omega_a never
vanishes, and no real constants make it a sine amplitude.
"""

from typing import Any

from sympy import UnevaluatedExpr, discriminant

from derivations.lemma1 import INERTIA, Lemma1
from derivations.regular_form import REGULAR
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.algebra._computation import compute, ordered
from rigidsym.proof.steps._names import symbols

COMPARED = "Lemma 1's roots and rates are those of the regular form, but for signs"
c_a, c_b, c_d, E_a, E_b, E_d, A_a, A_b, A_d = symbols("c_a c_b c_d E_a E_b E_d A_a A_b A_d")
alpha_a, alpha_b, alpha_d, root_a, root_b, root_d = symbols(
    "alpha_a alpha_b alpha_d root_a root_b root_d"
)
m, m_1, lambda_, sn, cn, Omega_a = symbols("m m_1 lambda_ sn cn Omega_a")
alpha, beta, chi, x, s_i, s_j, root_j, root_k, s_j_above_s_i, ratio_above_1 = symbols(
    "alpha beta chi x s_i s_j root_j root_k s_j_above_s_i ratio_above_1"
)
c_i, c_j, Omega_j, Omega_k, root_of_discriminant, minus_s_i, ratio_below_1 = symbols(
    "c_i c_j Omega_j Omega_k root_of_discriminant minus_s_i ratio_below_1"
)
ORDER = "m m_1 c_a c_b c_d A_a A_d cn sn"
# (13) calls s_i the root with + before the square root: the smaller one, where alpha < 0.
NAMED = Part(
    witness={c_i: 3, c_j: 2, Omega_j: 0, Omega_k: 4},
    definitions={s_i: root_j, s_j: root_k, root_of_discriminant: alpha * (s_i - s_j)},
    nonnegative=(root_of_discriminant,),
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the signs of both roots for each axis, and when to choose (10) or (11)."""
    _circulating(builder)
    forms = {
        alpha_b: -((c_b - c_a) * (c_b - c_d) / (c_a * c_d)),
        root_a: E_a / (c_b * (c_a - c_b)),
        root_d: E_d / (c_b * (c_b - c_d)),
    }
    roots = {root_a: A_b**2, m * root_d: A_b**2}
    rates = {alpha_b * root_d: lambda_**2, alpha_b * root_a: m * lambda_**2}
    _axis(builder, "middle_axis", forms, roots, rates)
    forms = {
        alpha_d: -((c_d - c_a) * (c_d - c_b) / (c_a * c_b)),
        root_a: E_a / (c_d * (c_a - c_d)),
        root_b: E_b / (c_d * (c_d - c_b)),
    }
    roots = {root_a: A_d**2, m * root_b: -m_1 * A_d**2}
    rates = {alpha_d * root_b: lambda_**2 * m_1, alpha_d * root_a: -m * lambda_**2}
    _axis(builder, "third_axis", forms, roots, rates)
    _choice(builder)


def _axis(builder: LedgerBuilder, axis: str, forms: Any, roots: Any, rates: Any) -> None:
    """Prove the roots of (13) on the middle or the third axis, and alpha times them."""
    here = Proofs.open(builder, axis, *REGULAR, Part(units=(m,), definitions=ordered(ORDER, forms)))
    here.claim("roots", ordered(ORDER, roots), 10, 13, why=COMPARED)
    here.claim("rates", rates, 10, 16, why=COMPARED)


def _circulating(builder: LedgerBuilder) -> None:
    """Prove that xi is imaginary on the circulation axis: alpha s is minus a square."""
    forms = {
        alpha_a: -((c_a - c_b) * (c_a - c_d) / (c_b * c_d)),
        root_b: -E_b / (c_a * (c_b - c_a)),
        root_d: E_d / (c_a * (c_a - c_d)),
    }
    here = Proofs.open(
        builder, "circulating_axis", *REGULAR, Part(definitions=ordered(ORDER, forms))
    )
    outer, inner = alpha_a * root_d, alpha_a * root_b
    here.claim("outer", {outer: "-(lambda_)**2"}, 10, 16, why=COMPARED)
    here.claim("inner", {inner: "-(lambda_)**2*m_1"}, 10, 16, why=COMPARED)
    squares = ordered(ORDER, {root_d: A_a**2, root_b: m_1 * A_a**2})
    here.claim("roots", squares, 10, 13, why=COMPARED)
    # sn(C) = Omega_a/sqrt(s) is beyond 1 for the inner root; for the outer, dn(C) is imaginary.
    above, below = (m * UnevaluatedExpr(A_a * f) ** 2 for f in (cn, sn))
    begun = ordered(ORDER, {root_b - Omega_a**2: -above, root_d - Omega_a**2: below})
    here.claim("start", begun, 12, "footnote 2", why=COMPARED)
    real = {outer: lambda_**2, inner: lambda_**2 * m_1}
    here.refute("real_rate", real, 10, 20, 21)
    within = ordered(ORDER, {root_b - Omega_a**2: above})
    here.refute("real_start", within, 12, "footnote 2")


def _choice(builder: LedgerBuilder) -> None:
    """Find motions where (10) and (16) choose differently, or (10) takes the root of s_i < 0.

    A point of such a context has the declared signs; that both sides differ there makes one strict.
    """
    lemma = builder.result(Lemma1)
    body = (INERTIA, lemma.moving, lemma.quartic, lemma.roots, NAMED)
    differ = Part(
        definitions={s_j_above_s_i: s_j - s_i, ratio_above_1: s_i**2 - s_j**2},
        nonnegative=(s_j_above_s_i, ratio_above_1),
    )
    here = Proofs.open(builder, "two_conditions", *body, differ)
    under = compute(alpha * x**2 + beta * x + chi).apply(discriminant, x)
    here.root(root_of_discriminant, under, 13, "Remark 1", fact="names")
    here.refute("differ", {s_i**2: s_j**2}, 10, 16, "Remark 1")
    negative = Part(
        witness={Omega_k: 2},
        definitions={minus_s_i: -s_i, ratio_below_1: s_j**2 - s_i**2},
        nonnegative=(minus_s_i, ratio_below_1),
    )
    Proofs.open(builder, "negative_root", *body, negative).refute("amplitude", {s_i: 0}, 10, 13)
