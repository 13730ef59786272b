"""The Fourier form: psi and the rates by series in sines and cosines, with constant coefficients.

Each series is the logarithmic derivative of theta_4, or a quotient by it.  Let s(k + 1) = -s(k),
e = +-1, and all k be whole, or all half of odd numbers.  The product

    (sum of s(k) q^(k^2) e^(2 i k z)) (sum of a(k) e^(2 i k z)),    a(k) = q^k/(1 - e q^(2k))

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

from sympy import I, cosh, sin, sinh
from sympy import cos as cosine_of

from derivations.descended_form import MOTION
from derivations.regular_form import CIRCULATION
from derivations.theta_form import ADDITION, SHIFT, Lambda, Z_im, mu, n, psi_rate, rho, s, t
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle, sign
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbol, symbols

x, a, e, P, k, m, rate, rest, rest_k = symbols("x a e P k m rate rest rest_k")
term, next_term, a_back = symbols("term next_term a_back")
k_back, exponent, exponent_back = symbols("k_back exponent exponent_back")
cosine, sine, cosh_b, sinh_b, shifted_im = symbols("cosine sine cosh_b sinh_b shifted_im")

# Only with these coefficients does each term of U(m + 1) follow from that of U(m).
STEP = P * a / x**2 - e * P * a
unit = symbol("unit")
A = compute(STEP - P / x).solve_for(a).subs(e * x**2, 1 - unit).subs(unit, 1 - e * x**2)
COEFFICIENT = Part(
    {x: "nome**k"},
    units=(x, 1 - e * x**2),
    definitions={a: A.ordered("e")},
    reading={"a": "a(k)"},
)
# P x**-2 is s(k) nome**(k**2 - 2*(m + 1)*k).
TERMS = Part(
    {P: "s(k)*nome**(k**2 - 2*m*k)"},
    units=(x**2 - e,),
    definitions={term: P * a, next_term: P * a / x**2, a_back: A.subs(x, 1 / x)},
)
POWER = compute(k**2 - (2 * m + 1) * k)
EXPONENT = Part(
    (k, m),
    definitions={
        k_back: 2 * m + 1 - k,
        exponent: POWER,
        exponent_back: POWER.subs(k, k_back),
    },
)
# The k-th term of theta_4'/theta_4 at v - i rho b, and of what psi/2 has beside its mean rate.
angle, depth = symbols("angle depth")
PARTS = {
    sin(angle): sine,
    cosine_of(angle): cosine,
    sinh(depth * rho): rho * sinh_b,
    cosh(depth * rho): cosh_b,
}
SHIFTED = compute(sin(angle - I * rho * depth)).expand(trig=True).subs(PARTS).coeff(I)
SLOPES = {cosine: -2 * k * rate * sine, sine: 2 * k * rate * cosine}
TERM = rate * 4 * a * SHIFTED
REST_K = (rest_k * compute(sine).subs(SLOPES) - TERM).solve_for(rest_k)
PHASE = Part(
    (k, rate, cosine, sine, cosh_b, sinh_b),
    units=(k,),
    relations=(sine**2 + cosine**2 - 1, cosh_b**2 - sinh_b**2 - 1),
    rates=SLOPES,
    definitions={e: 1, shifted_im: SHIFTED, rest_k: REST_K.ordered("rho a sinh_b k")},
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
    {rest: "the sum of rest_k*sin(2*k*v)"},
    units=(1 - n * s**2,),
    definitions={name: ADDITION[name] for name in ("SN_re", "Z_im")},
    rates={rest: mu * Z_im},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the coefficients, the terms of psi, and the rate of their sum."""
    here = Proofs.open(
        builder, "fourier_terms", sign("e", "-1 for cn and dn"), COEFFICIENT, TERMS, static=True
    )
    back = (A.subs({x: 1 / x, e: 1 / e}) / A).cancel()  # e is 1/e
    step = {next_term: e * term + compute(STEP).subs(a, A).cancel(), a_back: back * a}
    here.claim("step", step, "DLMF 20.5.13", "DLMF 22.11")
    here = Proofs.open(builder, "fourier_exponents", EXPONENT, static=True)
    reflected = POWER.subs(k, 2 * m + 1 - k).expand()
    here.claim("back", {exponent_back: reflected}, "DLMF 22.11")
    here = Proofs.open(builder, "fourier_phase", CIRCULATION, COEFFICIENT, PHASE)
    slope = (REST_K * compute(sine).subs(SLOPES)).subs(sinh_b, -shifted_im / (rho * cosine))
    here.claim("term", {rate_of(rest_k * sine): slope}, 33, 34)
    parts = (*MOTION, half_angle("psi", "psi_rate"), SHIFT, REST)
    here = Proofs.open(builder, "fourier_form", *parts)
    here.model("descended")
    here.carry("descended", "solution")
    # By `theta_form.phase`, Lambda is half the rate of psi less mu Z_im.
    whole = compute(Lambda * t + rest)
    grown = (whole.diff(t) + whole.diff(rest) * mu * Z_im).subs(Lambda, psi_rate / 2 - mu * Z_im)
    here.claim("phase", {rate_of(Lambda * t + rest): grown}, 33, 34)
