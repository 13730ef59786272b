"""The Fourier form: psi and the rates by series in sines and cosines, with constant coefficients.

Each series is the logarithmic derivative of theta_4, or a quotient by it.  Let s(k + 1) = -s(k),
e = +-1, and all k be whole, or all half of odd numbers.  The product

    (sum of s(k) q^(k^2) e^(2ikz), k whole) (sum of a(k) e^(2ikz)),    a(k) = q^k/(1 - e q^(2k))

has at e^(2imz) the coefficient s(m) q^(m^2) U(m), U(m) being the sum over k of the terms
s(k) q^(k^2 - 2mk) a(k).  Of these `fourier_terms` shows by identities that

    term(m + 1) = e term(m) + s(k) q^(k^2 - (2m + 1)k),    a(-k) = -e a(k).

Under k -> 2m + 1 - k the last exponent stays and s turns its sign, so that these add up to 0, and
U(m + 1) = e U(m).  So the product is a multiple of theta_1, theta_2 or theta_3: the series are
multiples of sn (e = 1) and cn (e = -1) where k is half of an odd number, and of dn (e = -1) where
it is whole; which multiples, their values at one instant say.  Where e = 1 and k is whole, a(0) is
left out: then U(0) = 0 and U(m + 1) = U(m) - 1, and 4 times the sum of a(k) sin 2kz, k > 0, is
theta_4'/theta_4.  Its imaginary part is what psi has beside its mean rate (`fourier_form`), term by
term an integral that is elementary (`fourier_phase`).

That sums may be taken in another order and integrated term by term (they converge absolutely while
|Im z| is below that of the pole) is analysis, of which the kernel knows nothing.
"""

from derivations.descended_form import MOTION
from derivations.regular_form import CIRCULATION
from derivations.theta_form import ADDITION, SHIFT
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join, sign

COEFFICIENT = Part(
    witness={"x": "1/2"},
    units=("x", "1 - e*x**2"),
    definitions={"a": "x/(1 - e*x**2)"},
    reading={"x": "nome**k", "a": "a(k)"},
)
# P x**-2 is s(k) nome**(k**2 - 2*(m + 1)*k).
TERMS = Part(
    witness={"P": "1"},
    units=("x**2 - e",),
    definitions={"term": "P*a", "next_term": "P/x**2*a", "a_back": "(1/x)/(1 - e/x**2)"},
    reading={"P": "s(k)*nome**(k**2 - 2*m*k)"},
)
EXPONENT = Part(
    witness={"k": "1", "m": "1"},
    definitions={
        "k_back": "2*m + 1 - k",
        "exponent": "k**2 - (2*m + 1)*k",
        "exponent_back": "k_back**2 - (2*m + 1)*k_back",
    },
)
# The k-th term of theta_4'/theta_4 at v - i rho b, and of what psi/2 has beside its mean rate.
PHASE = Part(
    witness={"k": "1", "rate": "1", **{"cosine": "1", "sine": "0", "cosh_b": "1", "sinh_b": "0"}},
    units=("k",),
    relations=("sine**2 + cosine**2 - 1", "cosh_b**2 - sinh_b**2 - 1"),
    rates={"cosine": "-(2*k*rate)*sine", "sine": "(2*k*rate)*cosine"},
    definitions={
        "e": "1",
        "shifted_im": "-rho*cosine*sinh_b",
        "rest_k": "-2*rho*a*sinh_b/k",
    },
    reading={
        "rate": "mu*g, the rate of v",
        "x": "nome_1**k",
        "cosine": "cos(2*k*v)",
        "sine": "sin(2*k*v)",
        "cosh_b": "cosh(2*k*b)",
        "sinh_b": "sinh(2*k*b)",
        "shifted_im": "im(sin(2*k*(v - rho*I*b)))",
    },
)
REST = Part(
    witness={"rest": "0"},
    units=("1 - n*s**2",),
    definitions={name: ADDITION[name] for name in ("SN_re", "Z_im")},
    rates={"rest": "mu*Z_im"},
    reading={"rest": "the sum of rest_k*sin(2*k*v)"},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the coefficients, the terms of psi, and the rate of their sum."""
    builder.open(
        join("fourier_terms", sign("e", "-1 for cn and dn"), COEFFICIENT, TERMS, static=True)
    )
    step = {"next_term": "e*term + P/x", "a_back": "-e*a"}
    builder.claim("fourier_terms.step", step, ["DLMF 20.5.13", "DLMF 22.11"])
    builder.open(join("fourier_exponents", EXPONENT, static=True))
    builder.claim("fourier_exponents.back", {"exponent_back": "exponent"}, ["DLMF 22.11"])
    builder.open(join("fourier_phase", CIRCULATION, COEFFICIENT, PHASE))
    builder.claim("fourier_phase.term", {"D(rest_k*sine)": "rate*(4*a*shifted_im)"}, ["33", "34"])
    parts = (*MOTION, half_angle("psi", "psi_rate"), SHIFT, REST)
    builder.open(join("fourier_form", *parts))
    builder.model("fourier_form", "descended")
    builder.carry("fourier_form", ["descended.solution"])
    builder.claim("fourier_form.phase", {"D(Lambda*t + rest)": "psi_rate/2"}, ["33", "34"])
