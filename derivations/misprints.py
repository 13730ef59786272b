"""What the printed lines need, and where they fail: counterexamples, poles and other readings.

With roots in Omega_i^2 by (13) and (14), (10) to (12), (16), (20) and (21) divide by c_i as if they
were roots in (c_i Omega_i)^2: both cannot be.  Dropping the c_i mends each of them; c_i^2 moved
from the denominator of chi to that of alpha in (14) mends them all at once.
"""

from sympy import MatAdd

from derivations.conjugacy import MOMENTUM
from derivations.euler_lax import INERTIA as MOMENTS
from derivations.lemma1 import INERTIA, SCALED, SINE, Lemma1
from derivations.lie_algebra import Algebra, M, R, combination, commutator, from_quaternion
from derivations.phi1_integral import AMPLITUDE, FUNCTIONS, ThirdKind, constants
from derivations.phi1_integral import sine as sine_of
from rigidsym.proof.algebra import Book, Part, jacobi, join, part_of, sign
from rigidsym.proof.steps import Desk

PRINTED = Part(
    definitions={
        "mu": "s_i/s_j",
        "Omega_i": "zeta*sn",
        "Omega_printed": "zeta/c_i*sn",
        "quartic": "alpha*(s_i - Omega_i**2)*(s_j - Omega_i**2)",
        "quartic_printed": "alpha*(s_i - Omega_printed**2)*(s_j - Omega_printed**2)",
    },
)
PHI1 = Part(
    definitions={
        "s_1": "zeta**2",
        "rate": "K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2)",
        "theta_rate": "xi*dn",
        "sigma": "(2*H*c1 - K**2)/(K*c1*xi)",
    },
)
QUARTER = {
    "sn": "4/5",
    "cn": "3/5",
    "zeta": "3",
    "s_j": "16",
    "root_s": "4",
    "w": "16/5",
    "xi": "8",
}
MOTION_RATES = {
    "Omega1": "K*cos_phi2/c1",
    "Omega2": "K*sin_phi2*sin_phi3/c2",
    "Omega3": "K*sin_phi2*cos_phi3/c3",
}
ON_CIRCLES = ("cos_phi2**2 + sin_phi2**2 - 1", "sin_phi3**2 + cos_phi3**2 - 1")


def derive(book: Book) -> None:
    """(9) and (22) at the start; (10) to (17); (29), (32), (33); (34) to (36)."""
    _start_of_motion(book)
    _axis(book)
    _degenerate(book)
    _start(book)
    _reciprocal(book)
    _poles(book)
    _poles_of_34(book)
    _third_kind(book)
    _amplitude(book)
    _third_kind_printed(book)


def _start_of_motion(book: Book) -> None:
    """R M R^-1 = M at the start says that R M = M R; it holds at R = e, and not everywhere."""
    matrices = {"R": from_quaternion("q"), "M": combination("M1 M2 M3")}
    body = part_of(book.ledger.contexts["moving_body"])
    matrices = {**book.found(Algebra).basis, **matrices}
    desk = Desk.open(book, "any_start", body, matrices=matrices, static=True)
    conjugated, start = R * M * R.I, ["9", "22"]
    at_e = Part(
        witness={f"q{k}": str(int(k == 0)) for k in range(4)},
        relations=("q0 - 1", "q1", "q2", "q3"),
    )
    Desk.open(book, "identity_start", body, at_e, matrices=matrices, static=True)
    quarter_turn = {"q0": "3/5", "q2": "4/5"}
    book.refute("any_start.momentum", desk.entrywise(conjugated, M), quarter_turn, start)
    gap = MatAdd(conjugated, -M)
    book.claim("any_start.commutes", desk.entrywise(gap * R, commutator(R, M)), start)


def _axis(book: Book) -> None:
    """(17) and (14) in other readings."""
    book.refute("axis.rate_with_l_i", {"D(Omega_i)": "(c_j - c_k)/c_i*Omega_i*Omega_k"}, {}, ["17"])
    in_momentum = "alpha/c_i**2*(c_i*Omega_i)**4 + beta*(c_i*Omega_i)**2 + c_i**2*chi"
    book.claim("axis.momentum_quartic", {"D(c_i*Omega_i)**2": in_momentum}, ["14", "Lemma 1"])
    in_momentum = {"alpha*(c_i**2*root_j)**2 + beta*c_i**2*root_j + chi": "0"}
    book.refute("distinct_axis.not_roots_in_momentum", in_momentum, {}, ["13"])


def _degenerate(book: Book) -> None:
    """Where c_i equals another moment, alpha = 0; where the body spins about axis j, s = 0."""
    lemma = book.found(Lemma1)
    moving, quartic = lemma.moving, lemma.quartic
    for other, witness in (("j", {"c_j": "2"}), ("k", {"c_k": "2"})):
        equal = Part(witness=witness, relations=(f"c_i - c_{other}",))
        book.open(join(f"equal_axes_{other}", INERTIA, moving, quartic, equal, static=True))
        book.claim(f"equal_axes_{other}.alpha", {"alpha": "0"}, ["13"])
    spin = Part(witness={"Omega_i": "0", "Omega_k": "0"}, relations=("Omega_i", "Omega_k"))
    book.open(join("spinning", INERTIA, moving, lemma.roots, spin))
    book.claim("spinning.root", {"root_j": "0"}, ["10", "11", "12", "footnote 1"])


def _start(book: Book) -> None:
    """(12) has two real values a period, with opposite cn: Remark 1's sign makes up for either."""
    half = sign("half", "+1 where C_i is the value with cn >= 0, -1 where it is the other one")
    other = Part(
        units=("zeta",),
        definitions={"cn_principal": "half*cn", "S": "sn", "C": "-cn", "E": "dn"},
        nonnegative=("cn_principal",),
    )
    book.open(join("start", SINE, SCALED, PRINTED, half, other))
    point = {"sn": "3/5", "cn": "4/5", "zeta": "1", "s_j": "1", "w": "4/5", "root_s": "1"}
    point["xi"] = "2"
    book.refute("start.over_inertia", {"sn": "c_i*Omega_i/zeta"}, point, ["12"])
    mended = {"sn": "c_i*Omega_printed/zeta"}
    book.claim("start.value_with_14_mended", mended, ["12", "14", "Lemma 1"])
    principal = {"D(Omega_i)": "xi*zeta*cn_principal*dn"}
    left = {**point, "cn": "-4/5", "half": "-1"}
    book.refute("start.principal_value", principal, left, ["footnote 2", "Remark 1"])
    book.claim("start.sign", {"D(Omega_i)": "half*xi*zeta*cn_principal*dn"}, ["Remark 1", "16"])
    book.claim(
        "start.other_value",
        {
            "C**2 + S**2": "1",
            "E**2 + mu*S**2": "1",
            "D(S)": "-xi*C*E",
            "D(C)": "xi*S*E",
            "D(E)": "xi*mu*S*C",
        },
        ["footnote 2", "Remark 1"],
    )


def _reciprocal(book: Book) -> None:
    """Both sides of footnote 1 differentiated and squared, with mu read as the modulus."""
    left = "mu*nu**2*(1 - sn**2)*(1 - mu**2*sn**2)"
    right = "mu*nu**2*(1 - S**2)*(1 - S**2/mu**2)"
    point = {"sqrt_mu": "3/4", "sn": "4/5", "cn": "3/5", "dn": "4/5"}
    book.refute("reciprocal.modulus", {left: right}, point, ["footnote 1"])


def _poles(book: Book) -> None:
    """Where sin(phi2) or cos(phi3) vanish, so do the denominators of (29), (32) and (33)."""
    on_axis = Part(
        witness={"sin_phi2": "0", "cos_phi2": "1", "cos_phi3": "1", "sin_phi3": "0"},
        definitions=MOTION_RATES,
        relations=("sin_phi2",),
    )
    book.open(join("on_axis", MOMENTS, MOMENTUM, on_axis, Part(relations=ON_CIRCLES), static=True))
    book.claim(
        "on_axis.denominators",
        {
            "c3*Omega3": "0",
            "(c2*Omega2)**2 + (c3*Omega3)**2": "0",
            "K**2 - (c1*Omega1)**2": "0",
        },
        ["29", "32", "33"],
    )
    across = Part(
        witness={"cos_phi2": "0", "sin_phi2": "1", "cos_phi3": "0", "sin_phi3": "1"},
        definitions=MOTION_RATES,
        relations=("cos_phi3",),
    )
    book.open(join("across", MOMENTS, MOMENTUM, across, Part(relations=ON_CIRCLES), static=True))
    book.claim("across.denominator", {"c3*Omega3": "0"}, ["29"])


def _poles_of_34(book: Book) -> None:
    """The denominators of (34) are zero where |c1 Omega1| = K."""
    for name, side in (("plus", "K - c1*zeta*sn"), ("minus", "K + c1*zeta*sn")):
        pole = Part(
            witness={
                "K": "1",
                "c1": "1",
                "zeta": "1",
                "sn": "1" if name == "plus" else "-1",
                "cn": "0",
                "mu": "0",
                "dn": "1",
            },
            definitions=sine_of(1).definitions,
            relations=(side,),
        )
        book.open(join(f"pole_{name}", constants(1), FUNCTIONS, pole, static=True))
        book.claim(f"pole_{name}.denominator", {"K**2 - (c1*Omega1)**2": "0"}, ["34"])


def _third_kind(book: Book) -> None:
    """The left side of (36) is not the rate of phi1."""
    integral = {"D(phi1)": "K/c1*t + kappa*Pi"}
    book.refute("third_kind.left_side", integral, {}, ["36"])


def _amplitude(book: Book) -> None:
    """(35): right where mu is the modulus, wrong where it is the parameter."""
    printed = {"D(theta)**2": "xi**2*(1 - mu**2*sn**2)"}
    point = {"sn": "4/5", "cn": "3/5", "dn": "4/5"}
    book.refute("amplitude.printed", printed, point, ["35"])
    of_modulus = jacobi("sn", "cn", "dn", "xi*t + gamma", "mu**2", "xi")
    book.open(join("amplitude_of_modulus", constants(1), of_modulus, AMPLITUDE))
    book.claim("amplitude_of_modulus.printed", printed, ["35"])


def _third_kind_printed(book: Book) -> None:
    """(20), (21) and (36) as printed; and n = s1/K^2 with s1 a root in (c1 Omega1)^2."""
    body = (*book.found(ThirdKind).parts, PHI1)
    printed = Part(
        units=("K - zeta*sn", "K + zeta*sn"),
        definitions={"n_printed": "s_1/K**2", "root_printed": "1 - mu**2*sn**2"},
    )
    book.open(join("theorem1_printed", *body, printed))
    point = {"c1": "2", "K": "4", "sn": "4/5", "cn": "3/5", "dn": "4/5", "mu": "9/16"}
    book.refute(
        "theorem1_printed.n",
        {"K/c1 + kappa*xi/(1 - n_printed*sn**2)": "rate"},
        point,
        ["20", "21"],
    )
    in_momentum = "K*(2*H - (zeta*sn)**2/c1)/(K**2 - (zeta*sn)**2)"
    book.claim(
        "theorem1_printed.with_14_mended",
        {"K/c1 + kappa*xi/(1 - n_printed*sn**2)": in_momentum},
        ["14", "20", "21", "Theorem 1"],
    )
    squared = {"(sigma/(1 - n*sn**2)*theta_rate)**2": "(rate - K/c1)**2*root_printed"}
    book.refute("theorem1_printed.modulus", squared, point, ["36"])
    rest = Part({"sn": "1", "cn": "0", "dn": "0", "mu": "1"}, relations=("mu*sn**2 - 1",))
    book.open(join("amplitude_at_rest", constants(1), FUNCTIONS, rest, static=True))
    book.claim("amplitude_at_rest.denominator", {"dn**2": "0"}, ["36"])
