"""phi1 as an elliptic integral of the third kind: equations (34) to (36).

The split (34) is exact wherever Omega1 = zeta sn.  (35) is right only when its mu is read as the
modulus; Lemma 1, and zeta sn(xi t + gamma, mu) of (34), read it as the parameter.  The left side of
(36) is phi1, not its derivative.
"""

from rigidsym.proof.algebra import Book, Part, jacobi, join

CONSTANTS = Part(
    witness={"c1": "1", "H": "1", "K": "2", "zeta": "1", "xi": "1", "mu": "9/16"},
    units=("c1", "K"),
    reading={
        "H": "kinetic energy, J",
        "K": "|M|, kg m^2 rad/s",
        "zeta": "amplitude of Omega1, rad/s",
        "xi": "rate of the argument, rad/s",
        "mu": "parameter (k^2) of the Jacobi functions",
    },
)
SINE = Part(
    units=("K - c1*zeta*sn", "K + c1*zeta*sn"),
    definitions={"Omega1": "zeta*sn"},
)
THIRD_KIND = Part(
    witness={"Pi": "0", "t": "0"},
    definitions={
        "n": "(c1*zeta/K)**2",
        "kappa": "(2*H*c1 - K**2)/(K*c1*xi)",
        "phi1": "K/c1*t + kappa*Pi",
    },
    rates={"Pi": "xi/(1 - n*sn**2)", "t": "1"},
    units=("xi",),
    reading={"Pi": "elliptic_pi(n, jacobi_am(xi*t + gamma, mu), mu)", "t": "time, s"},
)


def derive(book: Book) -> None:
    """(34), its integral (36), and (35) with mu as modulus and as parameter."""
    functions = jacobi("sn", "cn", "dn", "xi*t + gamma", "mu", "xi")
    book.open(join("sine_motion", CONSTANTS, functions, SINE, static=True))
    integrand = "K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2)"
    split = "K/c1 + (2*H*c1 - K**2)/(K*c1)/(1 - (c1*zeta/K)**2*sn**2)"
    book.claim("sine_motion.split", {integrand: split}, ["34"])
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
            definitions=SINE.definitions,
            relations=(side,),
        )
        book.open(join(f"pole_{name}", CONSTANTS, functions, pole, static=True))
        book.claim(f"pole_{name}.denominator", {"K**2 - (c1*Omega1)**2": "0"}, ["34"])
    book.open(join("third_kind", CONSTANTS, functions, SINE, THIRD_KIND))
    book.claim("third_kind.phi1", {"D(phi1)": integrand}, ["19", "33"])
    integral = {"D(phi1)": "K/c1*t + kappa*Pi"}
    book.refute("third_kind.left_side", integral, {}, ["36"])
    book.claim("third_kind.integral", {"phi1": "K/c1*t + kappa*Pi"}, ["36"])
    _amplitude(book, functions)


def _amplitude(book: Book, functions: Part) -> None:
    """(35): right where mu is the modulus, wrong where it is the parameter."""
    amplitude = Part(
        witness={"theta": "0"},
        rates={"theta": "xi*dn"},
        reading={"theta": "jacobi_am(xi*t + gamma, mu)"},
    )
    book.open(join("amplitude", CONSTANTS, functions, amplitude))
    printed = {"D(theta)**2": "xi**2*(1 - mu**2*sn**2)"}
    point = {"sn": "4/5", "cn": "3/5", "dn": "4/5"}
    book.refute("amplitude.printed", printed, point, ["35"])
    book.claim("amplitude.repaired", {"D(theta)**2": "xi**2*(1 - mu*sn**2)"}, ["35"])
    of_modulus = jacobi("sn", "cn", "dn", "xi*t + gamma", "mu**2", "xi")
    book.open(join("amplitude_of_modulus", CONSTANTS, of_modulus, amplitude))
    book.claim("amplitude_of_modulus.printed", printed, ["35"])
