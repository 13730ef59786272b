"""Theorem 1 and its true domain: equations (18) to (21), (36) and Remark 2.

(18) is R of (25) written as a quaternion, with F1, F2 the cosine and sine of phi2/2 and F3, F4
those of phi3/2.  (19) takes them from x = cos(phi2) and y = tan(phi3) with constant signs.  For F1
and F2 that is right: phi2 stays in [0, pi].  For F3 and F4 it is right only while cos(phi3) > 0,
that is while c3 Omega3 > 0: beyond a zero of Omega3, y* is minus the cotangent of phi3/2, and no
signs S3, S4 mend that.  With s1 the root in Omega_1^2 (Lemma 1), n in (20) and (21) lacks c1^2.
"""

from derivations.conjugacy import ANGLES, rotation
from derivations.phi1_integral import CONSTANTS, SINE, THIRD_KIND
from rigidsym.algebra import Book, Part, equal, jacobi, join, names
from rigidsym.algebra.su2 import from_quaternion

# cos(phi3) = side * rho with rho = 1/sqrt(1 + y^2) > 0: side tells the half plane phi3 is in.
TANGENT = Part(
    witness={"cos_half": "3/5", "sin_half": "4/5", "side": "-1"},
    units=("side", "cos_half**2 - sin_half**2", "1 + side*(cos_half**2 - sin_half**2)"),
    relations=("sin_half**2 + cos_half**2 - 1", "side**2 - 1"),
    definitions={
        "cos_phi3": "cos_half**2 - sin_half**2",
        "sin_phi3": "2*sin_half*cos_half",
        "rho": "side*cos_phi3",
        "y": "sin_phi3/cos_phi3",
        "y_star": "y/(1 + 1/rho)",
    },
    nonnegative=("rho",),
    reading={
        "rho": "1/sqrt(1 + y**2)",
        "side": "the sign of cos(phi3), that is of c3 Omega3",
        "cos_half": "cos(phi3/2)",
        "sin_half": "sin(phi3/2)",
    },
)


def derive(book: Book) -> None:
    """(18); (19) on both sides of Omega3 = 0; (20) and (21); (36)."""
    ring = book.open(join("theorem1", *ANGLES, static=True))
    cosine, sine = names(ring, "cos_half_phi1 sin_half_phi1")
    F1, F2, F3, F4 = names(ring, "cos_half_phi2 sin_half_phi2 cos_half_phi3 sin_half_phi3")
    quaternion = (
        F1 * (cosine * F3 - sine * F4),
        F1 * (sine * F3 + cosine * F4),
        F2 * (cosine * F3 + sine * F4),
        F2 * (sine * F3 - cosine * F4),
    )
    book.claim("theorem1.quaternion", equal(rotation(ring), from_quaternion(quaternion)), ["18"])
    book.claim(
        "theorem1.outer_halves",
        {
            "cos_half_phi2**2": "(1 + cos_phi2)/2",
            "sin_half_phi2**2": "(1 - cos_phi2)/2",
        },
        ["19"],
    )
    _inner_halves(book)
    _third_kind(book)


def _inner_halves(book: Book) -> None:
    """y* = tan(phi3/2) where c3 Omega3 > 0, and -cot(phi3/2) where it is negative."""
    book.open(join("half_angle_step", TANGENT, static=True))
    tangent = {"y_star*cos_half": "sin_half"}
    book.claim("half_angle_step.rho", {"rho**2*(1 + y**2)": "1"}, ["19"])
    book.refute("half_angle_step.everywhere", tangent, {}, ["19", "Remark 2"])
    right = Part(
        relations=("side - 1",), witness={"cos_half": "4/5", "sin_half": "3/5", "side": "1"}
    )
    book.open(join("half_angle_right", TANGENT, right, static=True))
    book.claim("half_angle_right.tangent", tangent, ["19"])
    book.claim(
        "half_angle_right.squares",
        {
            "cos_half**2*(1 + y_star**2)": "1",
            "sin_half**2*(1 + y_star**2)": "y_star**2",
        },
        ["19"],
    )
    left = Part(relations=("side + 1",))
    book.open(join("half_angle_left", TANGENT, left, static=True))
    book.claim("half_angle_left.cotangent", {"y_star*sin_half": "-cos_half"}, ["19"])
    book.claim(
        "half_angle_left.squares",
        {
            "sin_half**2*(1 + y_star**2)": "1",
            "cos_half**2*(1 + y_star**2)": "y_star**2",
        },
        ["19", "Remark 2"],
    )


def _third_kind(book: Book) -> None:
    """phi1' with n = c1^2 s1/K^2, but not with n = s1/K^2; and (36)."""
    functions = jacobi("sn", "cn", "dn", "f", "mu", "xi")
    printed = Part(
        units=("K - zeta*sn", "K + zeta*sn", "dn"),
        definitions={
            "s_1": "zeta**2",
            "n_printed": "s_1/K**2",
            "rate": "K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2)",
            "theta_rate": "xi*dn",
            "sigma": "(2*H*c1 - K**2)/(K*c1*xi)",
            "root_of_modulus": "1 - mu**2*sn**2",
        },
    )
    book.open(join("theorem1_phi1", CONSTANTS, functions, SINE, THIRD_KIND, printed))
    book.claim("theorem1_phi1.n", {"n": "c1**2*s_1/K**2", "kappa": "sigma"}, ["20", "21"])
    book.claim("theorem1_phi1.rate", {"K/c1 + kappa*xi/(1 - n*sn**2)": "rate"}, ["20", "21"])
    point = {"c1": "2", "K": "4", "sn": "4/5", "cn": "3/5", "dn": "4/5", "mu": "9/16"}
    book.refute(
        "theorem1_phi1.printed_n",
        {"K/c1 + kappa*xi/(1 - n_printed*sn**2)": "rate"},
        point,
        ["20", "21"],
    )
    integrand = "K/c1 + sigma/(1 - (c1*zeta/K)**2*sn**2)/dn*theta_rate"
    book.claim("theorem1_phi1.by_amplitude", {integrand: "rate"}, ["36"])
    squared = {"(sigma/(1 - n*sn**2)*theta_rate)**2": "(rate - K/c1)**2*root_of_modulus"}
    book.refute("theorem1_phi1.modulus", squared, point, ["36"])
