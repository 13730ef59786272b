"""Lemma 1: one rate by itself, equations (10) to (17), footnote 1 and Remark 1.

(i, j, k) is any cyclic order of the axes, so each claim stands for all three.  By (6), the square
of Omega_i' is a quadratic in Omega_i^2 with the coefficients (14); it factors over H, K and the
inertias, which gives the roots (13) without a square root.  These are roots in Omega_i^2.  (10) to
(12), (16), (20) and (21) divide by c_i as if they were roots in (c_i Omega_i)^2: both cannot be.
Dropping the c_i mends each of them; c_i^2 moved from the denominator of chi to that of alpha in
(14) mends them all at once, as then (13) gives the roots in (c_i Omega_i)^2.
"""

from rigidsym.proof.algebra import Book, Part, jacobi, join, sign

INERTIA = Part(
    witness={"c_i": "2", "c_j": "3", "c_k": "1"},
    units=("c_i", "c_j", "c_k"),
    reading={f"c_{x}": f"moment of inertia about axis {x}, kg m^2" for x in "ijk"},
)
QUARTIC = Part(
    definitions={
        "alpha": "-(c_i - c_j)*(c_i - c_k)/(c_j*c_k)",
        "beta": "(4*c_j*c_k*H - 2*c_i*(c_j + c_k)*H + 2*c_i*K_squared - (c_j + c_k)*K_squared)"
        "/(c_i*c_j*c_k)",
        "chi": "-(2*c_j*H - K_squared)*(2*c_k*H - K_squared)/(c_i**2*c_j*c_k)",
    },
)
ROOTS = Part(
    units=("c_i - c_j", "c_i - c_k"),
    definitions={
        "root_j": "(K_squared - 2*H*c_j)/(c_i*(c_i - c_j))",
        "root_k": "(K_squared - 2*H*c_k)/(c_i*(c_i - c_k))",
    },
    reading={"root_j": "one root in Omega_i^2", "root_k": "the other root in Omega_i^2"},
)
MOVING = Part(
    witness={"Omega_i": "1", "Omega_j": "2", "Omega_k": "3"},
    definitions={
        "H": "(c_i*Omega_i**2 + c_j*Omega_j**2 + c_k*Omega_k**2)/2",
        "K_squared": "(c_i*Omega_i)**2 + (c_j*Omega_j)**2 + (c_k*Omega_k)**2",
        "delta_i": "(c_j - c_k)/c_i",
    },
    rates={
        "Omega_i": "(c_j - c_k)/c_i*Omega_j*Omega_k",
        "Omega_j": "(c_k - c_i)/c_j*Omega_k*Omega_i",
        "Omega_k": "(c_i - c_j)/c_k*Omega_i*Omega_j",
    },
)
# s_i = zeta^2 and s_j are the roots, xi = sqrt(alpha s_j); H and K follow from the roots.
SINE = Part(
    witness={"zeta": "1", "s_j": "4", "xi": "4", "c_i": "2", "alpha": "4"},
    units=("s_j", "c_i"),
    definitions={"s_i": "zeta**2", "mu": "s_i/s_j"},
    relations=("xi**2 - alpha*s_j",),
    reading={
        "zeta": "sqrt(s_i)",
        "xi": "sqrt(alpha s_j)",
        "s_j": "the root that is not s_i",
    },
)

# dn^2 = 1 - mu sn^2 has the fraction mu = s_i/s_j: w = sqrt(s_j) dn keeps it polynomial.
SCALED = Part(
    witness={"sn": "0", "cn": "1", "w": "2", "root_s": "2"},
    units=("root_s",),
    definitions={"dn": "w/root_s"},
    relations=("cn**2 + sn**2 - 1", "root_s**2 - s_j", "w**2 + s_i*sn**2 - s_j"),
    rates={"sn": "xi*cn*dn", "cn": "-xi*sn*dn", "w": "-xi*s_i/root_s*sn*cn"},
    reading=jacobi("sn", "cn", "dn", "xi*t + C_i", "s_i/s_j", "xi").reading,
)
# What (10) prints, and the quadratic with the roots s_i and s_j for either rate.
PRINTED = Part(
    definitions={
        "Omega_i": "zeta*sn",
        "Omega_printed": "zeta/c_i*sn",
        "quartic": "alpha*(s_i - Omega_i**2)*(s_j - Omega_i**2)",
        "quartic_printed": "alpha*(s_i - Omega_printed**2)*(s_j - Omega_printed**2)",
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


def derive(book: Book) -> None:
    """(17); (13) and (14); (10) and (16) as printed and mended; (12), the signs; footnote 1."""
    book.open(join("axis", INERTIA, MOVING, QUARTIC))
    book.claim("axis.rate", {"D(Omega_i)": "delta_i*Omega_j*Omega_k"}, ["17"])
    book.refute("axis.rate_with_l_i", {"D(Omega_i)": "delta_i*Omega_i*Omega_k"}, {}, ["17"])
    quartic = "alpha*Omega_i**4 + beta*Omega_i**2 + chi"
    book.claim("axis.quartic", {"D(Omega_i)**2": quartic}, ["14"])
    in_momentum = "alpha/c_i**2*(c_i*Omega_i)**4 + beta*(c_i*Omega_i)**2 + c_i**2*chi"
    book.claim("axis.momentum_quartic", {"D(c_i*Omega_i)**2": in_momentum}, ["14", "Lemma 1"])
    _roots(book)
    _degenerate(book)
    _sine(book)
    _start(book)
    _reciprocal(book)


def _roots(book: Book) -> None:
    """(13) gives the roots of (14) in Omega_i^2, and not in (c_i Omega_i)^2."""
    book.open(join("distinct_axis", INERTIA, MOVING, QUARTIC, ROOTS))
    book.claim(
        "distinct_axis.roots",
        {
            "alpha*root_j**2 + beta*root_j + chi": "0",
            "alpha*root_k**2 + beta*root_k + chi": "0",
        },
        ["13"],
    )
    book.claim(
        "distinct_axis.discriminant",
        {"beta**2 - 4*alpha*chi": "(alpha*(root_j - root_k))**2"},
        ["13"],
    )
    in_momentum = {"alpha*(c_i**2*root_j)**2 + beta*c_i**2*root_j + chi": "0"}
    book.refute("distinct_axis.not_roots_in_momentum", in_momentum, {}, ["13"])


def _degenerate(book: Book) -> None:
    """Where c_i equals another moment, alpha = 0; where the body spins about axis j, s = 0."""
    for other, witness in (("j", {"c_j": "2"}), ("k", {"c_k": "2"})):
        equal = Part(witness=witness, relations=(f"c_i - c_{other}",))
        book.open(join(f"equal_axes_{other}", INERTIA, MOVING, QUARTIC, equal, static=True))
        book.claim(f"equal_axes_{other}.alpha", {"alpha": "0"}, ["13"])
    spin = Part(witness={"Omega_i": "0", "Omega_k": "0"}, relations=("Omega_i", "Omega_k"))
    book.open(join("spinning", INERTIA, MOVING, ROOTS, spin))
    book.claim("spinning.root", {"root_j": "0"}, ["10", "11", "12", "footnote 1"])


def _sine(book: Book) -> None:
    """Omega_i = sqrt(s_i) sn solves the quadratic with roots s_i, s_j; over c_i it does not."""
    book.open(join("sine", SINE, SCALED, PRINTED))
    book.claim("sine.solves", {"D(Omega_i)**2": "quartic"}, ["10"])
    book.refute("sine.over_inertia", {"D(Omega_printed)**2": "quartic_printed"}, {}, ["10", "11"])
    book.claim("sine.slope", {"D(Omega_i)": "xi*zeta*cn*dn"}, ["16"])
    book.refute("sine.slope_over_inertia", {"D(Omega_i)": "xi*zeta/c_i*cn*dn"}, {}, ["16"])

    under_root = "alpha*(s_i - s_i/c_i*sn**2)*(s_j - s_i/c_i*sn**2)"
    book.refute("sine.inertia_under_root", {"s_i/c_i*D(sn)**2": under_root}, {}, ["10"])
    # With roots in (c_i Omega_i)^2 the quadratic in Omega_i^2 has the roots s_i/c_i^2, s_j/c_i^2.
    scaled = "(s_i/c_i**2 - Omega_printed**2)*(s_j/c_i**2 - Omega_printed**2)"
    rate = "D(Omega_printed)**2"
    book.refute("sine.roots_in_momentum", {rate: f"alpha*{scaled}"}, {}, ["10"])
    book.claim("sine.with_14_mended", {rate: f"c_i**2*alpha*{scaled}"}, ["10", "14", "Lemma 1"])
    slope = {"D(Omega_printed)": "xi*zeta/c_i*cn*dn"}
    book.claim("sine.slope_with_14_mended", slope, ["14", "16", "Lemma 1"])
    modulus = {"D(Omega_i)**2": "(zeta*xi)**2*(1 - sn**2)*(1 - mu**2*sn**2)"}
    book.refute("sine.modulus", modulus, QUARTER, ["10", "Lemma 1"])


def _start(book: Book) -> None:
    """(12) has two real values a period, with opposite cn: Remark 1's sign makes up for either."""
    half = sign("half", "+1 where C_i is the value with cn >= 0, -1 where it is the other one")
    other = Part(
        units=("zeta",),
        definitions={"cn_principal": "half*cn", "S": "sn", "C": "-cn", "E": "dn"},
        nonnegative=("cn_principal",),
    )
    book.open(join("start", SINE, SCALED, PRINTED, half, other))
    book.claim("start.value", {"sn": "Omega_i/zeta"}, ["12"])
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
    """sqrt(mu) sn(u | mu), dn and cn satisfy what defines sn, cn and dn of (sqrt(mu) u | 1/mu)."""
    modulus = Part(
        witness={"sqrt_mu": "2", "nu": "1"},
        units=("sqrt_mu",),
        definitions={"mu": "sqrt_mu**2"},
        reading={"nu": "rate of the argument u"},
    )
    functions = jacobi("sn", "cn", "dn", "u", "sqrt_mu**2", "nu")
    other = Part(definitions={"S": "sqrt_mu*sn", "C": "dn", "E": "cn"})
    book.open(join("reciprocal", modulus, functions, other))
    book.claim(
        "reciprocal.footnote",
        {
            "C**2 + S**2": "1",
            "E**2 + S**2/mu": "1",
            "D(S)": "sqrt_mu*nu*C*E",
            "D(C)": "-sqrt_mu*nu*S*E",
            "D(E)": "-sqrt_mu*nu/mu*S*C",
        },
        ["footnote 1", "11"],
    )
    # Both sides differentiated and squared, with mu read as the modulus.
    left = "mu*nu**2*(1 - sn**2)*(1 - mu**2*sn**2)"
    right = "mu*nu**2*(1 - S**2)*(1 - S**2/mu**2)"
    point = {"sqrt_mu": "3/4", "sn": "4/5", "cn": "3/5", "dn": "4/5"}
    book.refute("reciprocal.modulus", {left: right}, point, ["footnote 1"])
