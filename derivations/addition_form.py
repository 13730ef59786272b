"""The motion from any state, by functions of the elapsed time alone: addition theorems at work.

Let alpha be the coefficients of Euler's equations, Omega_a' = alpha_a Omega_b Omega_d and so on,
and S_t, C_t, D_t the functions of time with

    S_t' = C_t D_t,    C_t' = -p S_t D_t,    D_t' = -r S_t C_t,    starting at 0, 1, 1.

With p = lambda^2 and r = m lambda^2 they are sn(lambda t | m)/lambda, cn and dn; but p and r are
polynomials in the rates at t = 0, and nothing divides by a modulus, an amplitude or a difference of
moments.  So neither phase nor regime is asked for: symmetric bodies, the separatrix and constant
rates are points like others.  Axes a, b, d may be in any order; in that of the regular form, where
b is the middle one, 0 <= r <= p.  The integrals of Omega^2, which the attitude's changes need,
follow from that of S_t^2.
"""

from derivations.attitude import HANDEDNESS, INERTIA
from rigidsym.proof.algebra import LedgerBuilder, Part, jacobi, join

FORCES = {
    "alpha_a": "epsilon*(c_b - c_d)/c_a",
    "alpha_b": "epsilon*(c_d - c_a)/c_b",
    "alpha_d": "epsilon*(c_a - c_b)/c_d",
}
MEANING = {name: f"the coefficient of Omega_{name[-1]}' in Euler's equations" for name in FORCES}
BODY = Part(definitions=FORCES, reading=MEANING)
# The same by themselves, whatever they are.
COEFFICIENTS = Part(
    witness={"alpha_a": "1/3", "alpha_b": "-1", "alpha_d": "1"},
    reading=MEANING,
)
GIVEN = Part(
    witness={"Omega_a0": "1", "Omega_b0": "0", "Omega_d0": "1"},
    definitions={
        "g_a": "alpha_a*Omega_b0**2 - alpha_b*Omega_a0**2",
        "g_d": "alpha_d*Omega_b0**2 - alpha_b*Omega_d0**2",
        "p": "alpha_d*g_a",
        "r": "alpha_a*g_d",
    },
    reading={f"Omega_{x}0": f"body rate about axis {x} at t = 0, rad/s" for x in "abd"},
)
FUNCTIONS = Part(
    witness={"S_t": "0", "C_t": "1", "D_t": "1"},
    relations=("C_t**2 + p*S_t**2 - 1", "D_t**2 + r*S_t**2 - 1"),
    rates={"S_t": "C_t*D_t", "C_t": "-p*S_t*D_t", "D_t": "-r*S_t*C_t"},
    reading={
        "S_t": "sn(lambda t | m)/lambda with p = lambda^2 and r = m lambda^2, or its limit",
        "C_t": "cn(lambda t | m)",
        "D_t": "dn(lambda t | m)",
    },
)
TIME = Part(witness={"t": "0"}, rates={"t": "1"}, reading={"t": "time, s"})
SQUARED = Part(
    witness={"E_t": "0"},
    rates={"E_t": "S_t**2"},
    reading={"E_t": "the integral of S_t^2 from 0 to t"},
)
OVER_SQUARE = Part(
    witness={"F_t": "0"},
    units=("D_t",),
    rates={"F_t": "S_t**2/D_t**2"},
    reading={"F_t": "the integral of S_t^2/D_t^2 from 0 to t"},
)
RATES = Part(
    units=("below",),
    definitions={
        "below": "1 - alpha_a*alpha_d*Omega_b0**2*S_t**2",
        "Omega_a": "(Omega_a0*D_t + alpha_a*Omega_b0*Omega_d0*S_t*C_t)/below",
        "Omega_b": "(Omega_b0*C_t*D_t + alpha_b*Omega_d0*Omega_a0*S_t)/below",
        "Omega_d": "(Omega_d0*C_t + alpha_d*Omega_a0*Omega_b0*S_t*D_t)/below",
    },
)
# Where p is not zero they are Jacobi's.
BY_JACOBI = Part(
    witness={"lambda_": "1", "m": "1/2"},
    units=("lambda_",),
    definitions={
        "p": "lambda_**2",
        "r": "m*lambda_**2",
        "S_t": "sn/lambda_",
        "C_t": "cn",
        "D_t": "dn",
    },
    reading={"lambda_": "sqrt(p)", "m": "r/p"},
)
# The integrals of Omega_b^2, and of the others where b is not an axis of symmetry.
INTEGRALS = Part(
    units=("alpha_b",),
    definitions={
        "I_b": "g_a*g_d*E_t + Omega_b0*Omega_b*S_t",
        "I_a": "Omega_a0**2*t + alpha_a/alpha_b*(I_b - Omega_b0**2*t)",
        "I_d": "Omega_d0**2*t + alpha_d/alpha_b*(I_b - Omega_b0**2*t)",
    },
)
START = Part(relations=("t", "S_t", "C_t - 1", "D_t - 1", "E_t"))
OTHERS = {"a": ("b", "d"), "b": ("d", "a"), "d": ("a", "b")}
EULER = {f"D(Omega_{x})": f"alpha_{x}*Omega_{y}*Omega_{z}" for x, (y, z) in OTHERS.items()}


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, the functions, the integrals of squared rates, and the start."""
    parts = (GIVEN, FUNCTIONS, TIME, SQUARED, RATES)
    builder.open(join("addition", HANDEDNESS, INERTIA, BODY, *parts))
    builder.claim("addition.euler", EULER, ["5", "10"])
    invariants = [" + ".join(f"c_{x}**{n}*Omega_{x}{{0}}**2" for x in "abd") for n in (1, 2)]
    kept = {form.format(""): form.format("0") for form in invariants}
    builder.claim("addition.invariants", kept, ["6", "15"])
    builder.open(
        join("addition_by_jacobi", BY_JACOBI, jacobi("sn", "cn", "dn", "u", "m", "lambda_"))
    )
    rates = {f"D({name})": rate for name, rate in FUNCTIONS.rates.items()}
    curves = dict.fromkeys(FUNCTIONS.relations, "0")
    builder.claim("addition_by_jacobi.functions", rates | curves, ["10", "DLMF 22.13"])
    builder.open(join("addition_integrals", COEFFICIENTS, *parts, INTEGRALS))
    squares = {f"D(I_{x})": f"Omega_{x}**2" for x in "abd"}
    builder.claim("addition_integrals.squares", squares, ["10"])
    still = [Part(part.witness, reading=part.reading) for part in (FUNCTIONS, TIME, SQUARED)]
    parts = (COEFFICIENTS, GIVEN, *still, RATES, INTEGRALS, START)
    builder.open(join("addition_start", *parts, static=True))
    start = {f"Omega_{x}": f"Omega_{x}0" for x in "abd"} | {f"I_{x}": "0" for x in "abd"}
    builder.claim("addition_start.rates", start, ["12"])
