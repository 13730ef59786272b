"""The rates in Jacobi's functions, for every order of the axes, both circulations and all signs.

    Omega_a = sigma A_a dn,    Omega_b = chi A_b sn,    Omega_d = chi tau A_d cn

of (u | m) with u' = lambda and always 0 <= m <= 1.  Put into 2 H and K^2, whose coefficients of
sn^2 vanish, this ansatz gives the amplitudes and m; Euler's equation gives lambda.  The motion is
described by the amplitudes B of the momentum, with B_b^2 = B_d^2 + m B_a^2, and by 1/c_a and
1/c_d = 1/c_a + rho Delta; the middle inertia follows.  rho is the sign of c_a - c_d and tells the
two circulations apart; tau makes lambda positive, and chi = +-1 lets a motion start with
|u| <= K(m).  m = 1 is the separatrix, m = 0 a symmetric body: neither is excluded, and neither
needs a formula of its own.
"""

from typing import Any

from sympy import Expr, S

from derivations.attitude import (
    ENERGY,
    EULER,
    GRADIENT,
    HANDEDNESS,
    INERTIA,
    MOMENTS,
    OMEGA,
    SENSE,
    SIZE,
    H,
    K,
    epsilon,
    sigma,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, jacobi, sign
from rigidsym.proof.algebra._computation import Computation, compute, guess
from rigidsym.proof.algebra._parts import text
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbol, symbols

c_a, c_b, c_d = MOMENTS
rho, chi, tau, i_a, i_b, i_d, Delta = symbols("rho chi tau i_a i_b i_d Delta")
m, m_1, lambda_, u, sn, cn, dn = symbols("m m_1 lambda_ u sn cn dn")
A = A_a, A_b, A_d = symbols("A_a A_b A_d")
B = B_a, B_b, B_d = symbols("B_a B_b B_d")
E_a, E_b, E_d, c_ab, c_ad, c_bd = symbols("E_a E_b E_d c_ab c_ad c_bd")
# The moments enter by these, too: where two of them agree to many digits, a difference known before
# they were rounded has digits that they have lost.
DIFFERENCES = {c_ab: c_a - c_b, c_ad: c_a - c_d, c_bd: c_b - c_d}
# These numbers have no cancellation but the one in E_b, whose sign tells the circulations apart.
EXCESSES = {E_a: 2 * H * c_a - K**2, E_b: K**2 - 2 * H * c_b, E_d: K**2 - 2 * H * c_d}


def unsigned(expression: Computation) -> Computation:
    """Simplify a product by the squares of the signs, which are 1."""
    signs = (epsilon, sigma, rho, chi, tau)
    return expression.factor().subs({x**2: 1 for x in signs}).subs({1 / x: x for x in signs})


def named(expression: Computation) -> Computation:
    """Return a product with names for the differences of moments and for the excesses."""
    names: dict[Expr, Expr] = {}
    for name, form in {**DIFFERENCES, **EXCESSES}.items():
        names |= {form: name, -form: -name}
    return expression.factor().xreplace(names)


def excess(form: Expr) -> Computation:
    """Return a multiple of the energy less K^2, by the rates and the differences of moments."""
    known = compute(form).subs({H: ENERGY, K**2: SIZE}).subs(GRADIENT).expand()
    return sum((named(known.coeff(w**2)) * w**2 for w in OMEGA), compute(S.Zero))


ANSATZ = dict(zip(OMEGA, (sigma * A_a * dn, chi * A_b * sn, chi * tau * A_d * cn), strict=True))


def by_sn(form: Expr) -> list[Computation]:
    """Return the coefficients of 1 and sn^2 in a quadratic form of the rates."""
    moving = compute(form).subs(GRADIENT).subs(ANSATZ)
    squares = {cn**2: 1 - sn**2, dn**2: 1 - m * sn**2}
    whole = moving.subs(squares).expand()
    return [unsigned(whole.coeff(sn, power)) for power in (0, 2)]


ENERGY_0, ENERGY_2 = by_sn(2 * ENERGY)
SIZE_0, SIZE_2 = by_sn(SIZE)
OUTER = compute([ENERGY_0 - 2 * H, SIZE_0 - K**2]).solve_for(A_a**2, A_d**2)
INNER = compute([ENERGY_2, SIZE_2]).solve_for(A_b**2, m)
# Omega_d' by the ansatz, and by Euler's equation.
LAMBDA = (-chi * tau * A_d * lambda_ * sn * dn - EULER[OMEGA[2]].subs(ANSATZ)).solve_for(lambda_)
M_FOUND = INNER[m].subs(OUTER)
SQUARES = {
    A_a: OUTER[A_a**2],
    A_b: INNER[A_b**2].subs(OUTER),
    A_d: OUTER[A_d**2],
    lambda_: unsigned(LAMBDA**2).subs(INNER).subs(OUTER),
}
# What the number half evaluates: each amplitude, rate and parameter from inertia and invariants.
FORMULAS = {
    str(name): named(form).ordered("c_a c_b c_d c_ab c_ad E_a E_d")
    for name, form in SQUARES.items()
}
PARAMETERS = {
    "m": named(M_FOUND).ordered("E_a c_bd E_d c_ab"),
    "m_1": named(1 - M_FOUND).ordered("c_ab c_ad E_b E_d"),
}
ORDER = "c_a c_b c_d c_ab c_ad c_bd Omega_a Omega_b Omega_d"
BY_RATES: dict[str, Any] = {
    "H": guess(
        text(compute(ENERGY).ordered(ORDER), ()), "the kinetic energy, where the derivation begins"
    ),
    **{str(name): excess(form).ordered(ORDER) for name, form in EXCESSES.items()},
}
# At t = 0 these say where on the polhode the motion starts.
START = {
    str(name): unsigned(compute(form - w).solve_for(name))
    for name, (w, form) in zip((dn, sn, cn), ANSATZ.items(), strict=True)
}

# The same by the amplitudes of the momentum, for the motion as numbers describe it.
INVERSES = {c_a: 1 / i_a, c_b: 1 / i_b, c_d: 1 / i_d}
BY_MOMENTUM = {a: b / c for a, b, c in zip(A, B, MOMENTS, strict=True)}


def by_momentum(expression: Computation) -> Computation:
    """Put in the amplitudes of the momentum and the reciprocal moments."""
    return expression.subs(BY_MOMENTUM).subs(INVERSES)


RELATION = by_momentum(SIZE_2)
OF_POLHODE = RELATION.solve_for(m)
BETWEEN = by_momentum(ENERGY_2).subs(m, OF_POLHODE).solve_for(i_b)
MIDDLE = i_a + (BETWEEN - i_a).factor()
TURNING = by_momentum(LAMBDA).subs(i_b, MIDDLE).factor()
# lambda is positive if tau is the sign that it has with tau = 1.
POSITIVE = dict.fromkeys((*B, Delta), 1)
OUTERMOST = {i_d: i_a + rho * Delta}
TAU = TURNING.subs(OUTERMOST).subs({tau: 1, **POSITIVE}).ordered("rho epsilon sigma")

CIRCULATION = sign("rho", "the sign of c_a - c_d")
HALF = sign("chi", "+1 when cn > 0 describes the start, -1 when the other half period does")
POLHODE = Part(
    {
        "i_a": "1/c_a",
        "Delta": "|1/c_d - 1/c_a|",
        "B_a": "amplitude of c_a |Omega_a|",
        "B_d": "amplitude of c_d |Omega_d|",
    },
    units=(i_a, i_a + rho * Delta, Delta, B_a, B_d, rho),
    definitions={c_a: INVERSES[c_a], **OUTERMOST, c_d: INVERSES[c_d]},
    witness={B_a: 7, B_d: 24},
)
SQUARE_OF_B = B_d**2 + m * B_a**2
PARAMETER = Part(
    {"m": "parameter (k^2) of the Jacobi functions", "B_b": "amplitude of c_b |Omega_b|"},
    units=(B_b, SQUARE_OF_B, i_a * SQUARE_OF_B + rho * Delta * B_d**2),
    relations=(RELATION,),
    nonnegative=(B_b,),
)
AMPLITUDES = Part(
    definitions={
        i_b: MIDDLE.subs(OUTERMOST),
        c_b: INVERSES[c_b],
        **DIFFERENCES,
        **BY_MOMENTUM,
        lambda_: unsigned(TURNING.subs(OUTERMOST).subs(tau, TAU)),
        tau: TAU,
        m_1: 1 - m,
    },
    nonnegative=(*A, lambda_),
    reading={
        "lambda_": "rate of the argument u, rad/s",
        **{f"A_{x}": f"amplitude of |Omega_{x}|, rad/s" for x in "abd"},
    },
)
ROTATING = Part(
    definitions={
        w: compute(form).ordered("chi tau sigma A_a A_b A_d") for w, form in ANSATZ.items()
    }
)
# The invariants by the amplitudes; the claims show that they are those of the rates.
INVARIANTS = Part(
    definitions={
        H: (by_momentum(ENERGY_0) / 2).factor().ordered("i_a B_a i_d"),
        E_a: (A_d**2 - named(OUTER[A_d**2])).solve_for(E_a),
        E_b: (m_1 - PARAMETERS["m_1"]).solve_for(E_b).subs(E_d, c_a * c_ad * A_a**2),
        E_d: (A_a**2 - named(OUTER[A_a**2])).solve_for(E_d),
        **{
            x: by_momentum(form.subs(ANSATZ)).ordered("chi tau sigma B_a B_d")
            for x, form in GRADIENT.items()
        },
    },
)
BODY = (HANDEDNESS, SENSE, CIRCULATION, HALF, POLHODE)
FUNCTIONS = jacobi("sn", "cn", "dn", "u", "m", "lambda_")
# Numbers have 1 - m without a difference.
BY_COMPLEMENT = Part(reading={f"{x}n": f"jacobi_{x}n(u, 1 - m_1)" for x in "scd"})
REGULAR = (*BODY, PARAMETER, AMPLITUDES, FUNCTIONS, BY_COMPLEMENT, ROTATING, INVARIANTS)


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, and the amplitudes, lambda and m by inertia and invariants."""
    here = Proofs.open(builder, "regular", *REGULAR)
    here.claim("euler", {rate_of(w): turning for w, turning in EULER.items()}, 5, 10)
    here.formulas(BY_RATES, 6, 15)
    excesses = {name: compute(form).subs(K**2, SIZE) for name, form in EXCESSES.items()}
    here.claim("differences", excesses, 6, 15)
    for name, radicand in FORMULAS.items():
        here.root(name, radicand, 10, 13, 14)
    here.formulas(PARAMETERS, 10, 13, 14)
    here.formulas(START, 12)
    _every_motion(builder)
    _start(builder)
    _signs(builder)


def _every_motion(builder: LedgerBuilder) -> None:
    """Prove that m and squared amplitudes by any inertia and rates meet the relations.

    That the squares are nonnegative and 0 <= m <= 1 is the choice of the axis a, in the chapter
    on regimes; where E_a or E_d vanish the rates are constant.
    """
    squared = {x: symbol(f"{x}_squared") for x in (*A, lambda_, *B)}
    by_squares = {x**2: name for x, name in squared.items()}
    momenta = dict(zip(B, zip(MOMENTS, A, strict=True), strict=True))
    squares = Part(
        units=(
            c_a - c_b,
            c_a - c_d,
            *(excess(EXCESSES[x]).subs(DIFFERENCES) for x in (E_a, E_d)),
        ),
        definitions={
            **{squared[x]: FORMULAS[str(x)] for x in (*A, lambda_)},
            m: PARAMETERS["m"],
            **{squared[b]: c**2 * squared[a] for b, (c, a) in momenta.items()},
        },
    )
    moving = Part(("Omega_a", "Omega_b", "Omega_d"))
    by_rates = Part(definitions=DIFFERENCES | BY_RATES)
    here = Proofs.open(builder, "any_motion", INERTIA, moving, by_rates, squares, static=True)
    middle = RELATION.subs(by_squares).solve_for(squared[B_b])
    here.claim("parameter", {squared[B_b]: middle}, 14)
    by_moments = {i: 1 / c for c, i in zip(MOMENTS, (i_a, i_b, i_d), strict=True)}
    inertia = {1 / c_b: MIDDLE.subs(by_squares).subs(by_moments)}
    here.claim("inertia", inertia, 14)
    turning = unsigned(TURNING**2).subs(by_squares).subs(by_moments)
    here.claim("rate", {squared[lambda_]: turning}, 14)
    a, b, d = (w**2 / squared[x] for w, x in zip(OMEGA, A, strict=True))
    here.evaluate("start", [b + d, a + m * b], 12)


def _start(builder: LedgerBuilder) -> None:
    """Prove that the rates at t = 0 are those given, with u_1 = phase and psi = 0.

    That sn, cn and dn are on the curve of Jacobi's functions is `any_motion.start`.
    """
    others = t, phase, mu, psi_0, kappa, J, J_0 = symbols("t phase mu psi_0 kappa J J_0")
    u_1, psi = symbols("u_1 psi")
    given = Part(
        (*OMEGA, K, *A, *others),
        units=(c_ab, c_ad, E_d, *A),
        definitions={
            **DIFFERENCES,
            **GRADIENT,
            **BY_RATES,
            **PARAMETERS,
            tau: TAU,
            **START,
            u_1: mu * t + phase,
            psi: psi_0 * t + kappa * (J - J_0),
        },
        relations=(K**2 - SIZE, *(x**2 - FORMULAS[str(x)] for x in A), t, J - J_0),
        nonnegative=(K, *A),
    )
    signs = (HANDEDNESS, SENSE, CIRCULATION, HALF)
    here = Proofs.open(builder, "rates_start", *signs, INERTIA, given, static=True)
    size = compute(K**2 - SIZE).solve_for(K**2)
    here.root(K, size, 6, 15)
    for name in map(str, A):
        here.root(name, FORMULAS[name], 10, 13, 14)
    rates = [(builder.value("rates_start", form), form) for form in ANSATZ.values()]
    here.claim("rates", rates, 10)
    here.evaluate("time", [u_1, psi], 20, 21, 33, 34)
    here.evaluate("parameters", [m + m_1], 13, 14)


def _signs(builder: LedgerBuilder) -> None:
    """Prove dn >= 0, cn >= 0 and Delta >= 0 at the start, by the definitions of the signs."""
    outer = {x: form for x, form in ANSATZ.items() if x != OMEGA[1]}
    given = Part(
        ("i_a", "Delta", "A_a", "A_d", "dn", "cn"),
        units=(i_a, i_a + rho * Delta, A_a, A_d),
        definitions={**POLHODE.definitions, c_ad: DIFFERENCES[c_ad], tau: TAU, **outer},
        nonnegative=(A_a, A_d, c_a, c_d, rho * c_ad, sigma * OMEGA[0], chi * tau * OMEGA[2]),
    )
    here = Proofs.open(
        builder, "start_signs", HANDEDNESS, SENSE, CIRCULATION, HALF, given, static=True
    )
    between = (compute(i_d) - OUTERMOST[i_d]).solve_for(Delta)
    apart = named(unsigned(between).subs({i_a: 1 / c_a, i_d: 1 / c_d}))
    forms = {dn: START["dn"], cn: START["cn"], Delta: apart}
    here.sign("signs", forms, 12)
