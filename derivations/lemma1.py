"""Lemma 1: one rate by itself, equations (10) to (17), footnote 1 and Remark 1.

(i, j, k) is any cyclic order of the axes, so each claim stands for all three.  By (6), the square
of Omega_i' is a quadratic in Omega_i^2 with the coefficients (14); it factors over H, K and the
inertias, which gives the roots (13) without a square root.  These are roots in Omega_i^2.  (10) to
(12), (16), (20) and (21) divide by c_i as if they were roots in (c_i Omega_i)^2: both cannot be,
and dropping the c_i mends it.  On the circulation axis the printed form is real only by way of
complex constants: there alpha s_j is minus a square for either root.
"""

from derivations.regular_form import REGULAR
from rigidsym.algebra import Book, Part, jacobi, join

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
    units=("s_j", "c_i", "zeta", "alpha"),
    definitions={"s_i": "zeta**2", "mu": "s_i/s_j"},
    relations=("xi**2 - alpha*s_j",),
    reading={
        "zeta": "sqrt(s_i)",
        "xi": "sqrt(alpha s_j)",
        "s_j": "the root that is not s_i",
    },
)


def derive(book: Book) -> None:
    """(17); (13) and (14); (10), (12) and (16) as printed and mended; footnote 1 and (11)."""
    book.open(join("axis", INERTIA, MOVING, QUARTIC))
    book.claim("axis.rate", {"D(Omega_i)": "delta_i*Omega_j*Omega_k"}, ["17"])
    quartic = "alpha*Omega_i**4 + beta*Omega_i**2 + chi"
    book.claim("axis.quartic", {"D(Omega_i)**2": quartic}, ["14"])
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
    _coinciding(book)
    _sine(book)
    _reciprocal(book)
    _imaginary(book)


def _coinciding(book: Book) -> None:
    """Where c_i equals another moment, alpha = 0 and (13) divides by zero."""
    for other, witness in (("j", {"c_j": "2"}), ("k", {"c_k": "2"})):
        equal = Part(witness=witness, relations=(f"c_i - c_{other}",))
        book.open(join(f"equal_axes_{other}", INERTIA, MOVING, QUARTIC, equal, static=True))
        book.claim(f"equal_axes_{other}.alpha", {"alpha": "0"}, ["13"])


def _sine(book: Book) -> None:
    """Omega_i = sqrt(s_i) sn solves the quadratic with roots s_i, s_j; over c_i it does not."""
    functions = jacobi("sn", "cn", "dn", "xi*t + C_i", "s_i/s_j", "xi")
    # dn^2 = 1 - mu sn^2 has the fraction mu = s_i/s_j: w = sqrt(s_j) dn keeps it polynomial.
    scaled = Part(
        witness={"sn": "0", "cn": "1", "w": "2", "root_s": "2"},
        units=("root_s",),
        definitions={"dn": "w/root_s"},
        relations=("cn**2 + sn**2 - 1", "root_s**2 - s_j", "w**2 + s_i*sn**2 - s_j"),
        rates={"sn": "xi*cn*dn", "cn": "-xi*sn*dn", "w": "-xi*s_i/root_s*sn*cn"},
        reading=functions.reading,
    )
    printed = Part(
        definitions={
            "Omega_i": "zeta*sn",
            "Omega_printed": "zeta/c_i*sn",
            "quartic": "alpha*(s_i - Omega_i**2)*(s_j - Omega_i**2)",
            "quartic_printed": "alpha*(s_i - Omega_printed**2)*(s_j - Omega_printed**2)",
        },
    )
    book.open(join("sine", SINE, scaled, printed))
    book.claim("sine.solves", {"D(Omega_i)**2": "quartic"}, ["10"])
    book.refute("sine.over_inertia", {"D(Omega_printed)**2": "quartic_printed"}, {}, ["10", "11"])
    book.claim("sine.slope", {"D(Omega_i)": "xi*zeta*cn*dn"}, ["16"])
    book.refute("sine.slope_over_inertia", {"D(Omega_i)": "xi*zeta/c_i*cn*dn"}, {}, ["16"])
    book.claim("sine.start", {"sn": "Omega_i/zeta"}, ["12"])
    start = {
        "sn": "3/5",
        "cn": "4/5",
        "zeta": "1",
        "s_j": "1",
        "w": "4/5",
        "root_s": "1",
        "xi": "2",
    }
    book.refute("sine.start_over_inertia", {"sn": "c_i*Omega_i/zeta"}, start, ["12"])


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


def _imaginary(book: Book) -> None:
    """On the circulation axis, alpha s is minus a square for both roots: xi is imaginary."""
    printed = Part(
        definitions={
            "alpha_a": "-(c_a - c_b)*(c_a - c_d)/(c_b*c_d)",
            "root_b": "-E_b/(c_a*(c_b - c_a))",
            "root_d": "E_d/(c_a*(c_a - c_d))",
        },
    )
    book.open(join("circulating_axis", *REGULAR, printed))
    book.claim("circulating_axis.outer", {"alpha_a*root_d": "-(lambda_)**2"}, ["10", "16"])
    book.claim("circulating_axis.inner", {"alpha_a*root_b": "-(lambda_)**2*m_1"}, ["10", "16"])
