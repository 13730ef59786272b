"""The Pi form: psi/2 as a rate times time and a periodic rest, with one integral of the third kind.

J of the descended form grows without end.  Its mean slope j = J_c/K_1 goes into the rate,

    psi/2 = Lambda t + rest - rest_0,    Lambda = (psi_0 + kappa mu j)/2

and rest = kappa (J - j u_1)/2 has the period 2 K_1 (period_functions.later), so that a state needs
J for |u_1| <= K_1.  That is for moduli that are not near one.

On the separatrix K_1 is infinite, and near it the rest is a small difference.  So psi/2 is measured
from what it is on the saddle, H t/K: with x, y, z of the theta form

    psi/2 = (H/K) t - rho (arctan(k_1^2 (x y/z) s c/d) + g_1 u_1 + g_2 L) + constant        (near)
    psi/2 = (H/K) t + rho (g_1 v + h_2 L(v)) + constant,    v = K_1 - u_1                   (far)

where L is the integral of s^2/(1 - n_2 s^2), that is of s^2/(c^2 + delta s^2).  The first is J
after a change of its parameter (DLMF 19.21.12), the second the same from the other end of the
quarter period.  g_1, g_2 and h_2 vanish on the separatrix, and no term is the difference of others.
"""

from typing import Any

from sympy import I, S, atan, factor_terms

from derivations.descended_form import MOTION
from derivations.theta_form import (
    DOUBLED,
    KAPPA,
    POLE,
    SHIFT,
    B_a,
    B_d,
    C_b,
    K,
    Lambda,
    R,
    X_im,
    X_re,
    Y,
    c,
    cos_half_psi,
    d,
    k_1,
    kappa,
    mu,
    n,
    parts,
    psi_0,
    psi_rate,
    rho,
    s,
    sin_half_psi,
    t,
    whole,
    x,
    y,
    z,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle
from rigidsym.proof.algebra._computation import Computation, compute, guess
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbol, symbols

psi, rest, rest_0, j, J, J_0, K_1, alpha = symbols("psi rest rest_0 j J J_0 K_1 alpha")
u_1, phase, H, m_c, L = symbols("u_1 phase H m_c L")
delta, n_2, g, g_1, g_2, h_2, slope = symbols("delta n_2 g g_1 g_2 h_2 slope")
T_size, T_re, T_im, T_rate, V_re, V_im = symbols("T_size T_re T_im T_rate V_re V_im")
s_v, c_v_squared, d_v_squared = symbols("s_v c_v_squared d_v_squared")

# J is j u_1 and a periodic part: what grows with time is Lambda t.
J_periodic, J_start = symbols("J_periodic J_start")
GROWN = {J: J_periodic + j * (mu * t + phase), J_0: J_start + j * phase}
HALF = compute((psi_0 * t + kappa * (J - J_0)) / 2).subs(GROWN).expand()
LAMBDA = HALF.coeff(t).factor()
REST = HALF.coeff(J_periodic) * (J - j * u_1)
REST_0 = -HALF.coeff(J_start) * (J_0 - j * phase)
MEAN = Part(
    {j: "(elliptic_pi(n, 1 - m_c)/elliptic_k(1 - m_c) - 1)/n"},
    definitions={
        Lambda: LAMBDA.ordered("psi_0 kappa mu"),
        rest: REST,
        rest_0: REST_0.ordered("kappa J_0 j"),
    },
)

# On the saddle Omega_a is 0, so that 1 - k_1 s^2 is 0 and psi' is 2 H/K.  Elsewhere psi'/2 is less
# by rho mu g times a gap, which is 1 where s is 0.
FACTOR = compute(s**2 / (1 - n * s**2))
HALF_RATE = (psi_0 + kappa * mu * FACTOR) / 2
BY_SHIFT = HALF_RATE.subs({kappa: KAPPA, n: POLE})
SADDLE_RATE = BY_SHIFT.subs(s**2, 1 / k_1)
G = ((SADDLE_RATE - psi_0 / 2) / (rho * mu)).cancel()
GAP = ((SADDLE_RATE - BY_SHIFT) / (rho * mu * G)).cancel()
LAST_GAP = GAP.subs(s**2, 1)  # at the end of a quarter period
G_1 = g * LAST_GAP.subs(k_1**2 * x**2, z**2 - 1).subs(k_1 - 1, -m_c / (1 + k_1))
# The change of the parameter is (1 - n) (1 - n_2) = 1 - k_1^2, and z^2 is 1 - n.
DELTA = compute(z**2 * delta - m_c).solve_for(delta)
OLD = compute((1 - n) * (1 - n_2) - 1 + k_1**2).solve_for(n)
TANGENT = slope * s * c / (z * d)


def moving(form: Any) -> Computation:
    """Return the time derivative of a function of s, c and d."""
    rates = {s: mu * c * d, c: -mu * s * d, d: -mu * k_1**2 * s * c}
    return sum((compute(form).diff(x) * rate for x, rate in rates.items()), compute(S.Zero))


# The squared length of the vector (z d, slope s c) has the factor 1 - n s^2.  The other factor is
# linear in s^2: it is z^2 where s is 0, and m_c where s is 1.
LENGTH = compute((z * d) ** 2 + (slope * s * c) ** 2)
BY_S = LENGTH.subs({d**2: 1 - k_1**2 * s**2, c**2: 1 - s**2, slope: k_1**2 * x * y})
OTHER = (BY_S.subs({y**2: 1 + x**2, z**2: 1 - POLE}) / (1 - POLE * s**2)).cancel()
FIRST, LAST = (OTHER.subs(s, end).subs({1 - POLE: z**2, 1 - k_1**2: m_c}) for end in (0, 1))
SQUARE = FIRST * (1 - n * s**2) * (c**2 + (LAST / FIRST).subs(DELTA, delta) * s**2)
# c^2 + delta s^2 is 1 - n_2 s^2.
T_RATE = (
    moving(-rho * atan(TANGENT)).factor().subs(LENGTH, z**2 * (1 - n * s**2) * (1 - n_2 * s**2))
)
# The rest of psi'/2 is -rho mu (g_1 + g_2 s^2/(1 - n_2 s^2)).  Where s is 1, g_1 alone makes the
# gap, so that g_2 undoes the arctangent there.
LAST_RATE = T_RATE.subs(c, 0).subs({s: 1, d**2: m_c})
G_2 = (LAST_RATE * (1 - n_2) / (rho * mu)).subs(n, 1 - z**2).subs(slope, k_1**2 * x * y)
# From the other end, h_2/g_1 is the gap's relative difference from its last value, divided by the
# integrand of L.
RATIO = (GAP / LAST_GAP - 1) * (1 - POLE * s**2) / (1 - s**2) * (1 - k_1**2) / (1 - POLE)
H_2 = g_1 * RATIO.cancel().subs(x**2, -n / k_1**2).subs(n, OLD).cancel()
# s, c and d of v = K_1 - u_1 (DLMF 22.4(iii)), the last two by their squares.
OF_V = {s_v: c / d, c_v_squared: m_c * s**2 / d**2, d_v_squared: m_c / d**2}
PATH = compute(-mu * s_v**2 / (c_v_squared + delta * s_v**2))
FAR_RATE = PATH.subs(OF_V).subs(delta, DELTA).factor()
# After every K_1 of u_1 the arctangent and the rest add up to alpha more: J is j K_1 there.
slower = symbol("slower")
TURNED = compute(K_1 * g * (u_1 - slower * J)).subs(J, J_periodic + j * u_1).expand()
ALPHA = TURNED.coeff(u_1).apply(factor_terms).subs(slower, k_1 - n)

# Coefficients by the shift of the theta form; g mu is what the saddle's rate differs by.
SADDLE = Part(
    units=(z, 1 + k_1, 1 + k_1 * x**2),
    definitions={
        delta: DELTA,
        n_2: 1 - delta,
        g: G.ordered("k_1 x y z"),
        g_1: G_1.ordered("g m_c k_1 z"),
        g_2: G_2.ordered("k_1 x y m_c z"),
        h_2: H_2.ordered("g_1 k_1 n_2"),
        slope: k_1**2 * x * y,
    },
)
# The shift, psi and its rate without what they are made of, so that little has to be reduced.
ABSTRACT = Part(
    (rho, k_1, x, y, z, psi_0, mu, t, s, c, d),
    units=(1 - n * s**2,),
    relations=(
        *(rho**2 - 1, y**2 - 1 - x**2, z**2 - 1 - (k_1 * x) ** 2),
        *(c**2 + s**2 - 1, d**2 + k_1**2 * s**2 - 1),
    ),
    definitions={
        m_c: 1 - k_1**2,
        n: POLE,
        kappa: KAPPA,
        psi_rate: 2 * HALF_RATE,
        Lambda: psi_0 / 2 + rho * g * mu,
    },
    rates={t: 1, s: mu * c * d, c: -mu * s * d, d: -mu * k_1**2 * s * c},
)
# T is the unit vector whose angle is the arctangent's, but for the sign -rho.
NEAR = Part(
    {L: "elliptic_j(u_1, n_2, 1 - m_c)"},
    units=(1 - n_2 * s**2,),
    definitions={T_rate: T_RATE},
    rates={L: mu * s**2 / (1 - n_2 * s**2)},
)
ARCTANGENT = Part(
    (T_size,),
    units=(T_size,),
    relations=(T_size**2 - z**2 * d**2 - slope**2 * s**2 * c**2,),
    definitions={
        name: side.ordered("rho slope z d s c")
        for name, side in parts("T", (z * d - I * rho * slope * s * c) / T_size).items()
    },
    rates={T_size: (moving(LENGTH) / (2 * T_size)).expand()},
    nonnegative=(T_size,),
)
# The same in a motion, R and V being T_size and its parts without denominators.
HEIGHT = K - B_a + k_1 * (K + B_a)
REAL, IMAGINARY = C_b * (K + B_a) * d, -rho * k_1 * B_d * HEIGHT * s * c
SCALED = Part(
    (R,),
    units=(R,),
    relations=(R**2 - V_re**2 - V_im**2,),
    definitions={
        **{V_re: REAL, V_im: IMAGINARY, T_re: V_re / R, T_im: V_im / R},
        T_size: R / (Y * (K + B_a)),
    },
    rates={R: (V_re * moving(REAL) + V_im * moving(IMAGINARY)) / R},
    nonnegative=(R, T_size),
)
COMPLETE = Part(
    (K_1, j),
    definitions={alpha: ALPHA.ordered("g K_1 k_1 n j")},
    reading={"K_1": "elliptic_k(1 - m_c)", **MEAN.reading},
)
FAR = Part(
    {L: "elliptic_j(elliptic_k(1 - m_c) - u_1, n_2, 1 - m_c)"},
    units=(d, 1 - k_1),
    definitions=OF_V,
    rates={L: FAR_RATE.subs(c**2 + z**2 * s**2, 1 - n * s**2)},
)
MATCHED = "an ansatz; its coefficients are what makes it hold"


def turning(rate: Any) -> Part:
    """Return a point X on the unit circle that turns at a rate."""
    return Part(
        (X_re, X_im),
        relations=(X_re**2 + X_im**2 - 1,),
        rates={X_re: -rate * X_im, X_im: rate * X_re},
    )


def half_turned(half: dict[str, Computation]) -> Part:
    """Return definitions of cos and sin of psi/2, and the rate H/K on the saddle."""
    real, imaginary = half.values()
    return Part(
        definitions={
            Lambda: H / K,
            cos_half_psi: real,
            sin_half_psi: imaginary,
            "cos_psi": DOUBLED["psi_re"],
            "sin_psi": DOUBLED["psi_im"],
        }
    )


def derive(builder: LedgerBuilder) -> None:
    """Prove the rest, then psi from the saddle and from both ends of a quarter period."""
    here = Proofs.open(builder, "pi_form", *MOTION, half_angle("psi", "psi_rate"), MEAN)
    here.model("descended")
    names = {LAMBDA.value: Lambda, REST.value: rest, REST_0.value: rest_0}
    total = (LAMBDA * t + REST - REST_0).subs(names)
    here.claim("psi", {psi / 2: total}, 33, 34, 36)
    for claims in (_abstract, _near, _far):
        claims(builder)


def _abstract(builder: LedgerBuilder) -> None:
    """Open a context on the rate of psi with few names."""
    here = Proofs.open(builder, "arctangent", ABSTRACT, SADDLE, NEAR, ARCTANGENT)
    saddle = Lambda - rho * g * mu * GAP.subs(k_1**2 * x**2, -n)
    here.claim("saddle", {psi_rate / 2: saddle}, 33, 34, 36)
    here.root(T_size, SQUARE.ordered("z n delta s c"), 36)
    turned = parts("D", I * T_rate * whole("T")).values()
    turn = {rate_of(x): side for x, side in zip((T_re, T_im), turned, strict=True)}
    here.claim("turn", turn, 36)
    phase = guess("Lambda + T_rate - rho*(g_1*mu + g_2*D(L))", MATCHED)
    here.claim("phase", {psi_rate / 2: phase}, 33, 34, 36)
    here = Proofs.open(builder, "other_end", ABSTRACT, SADDLE, FAR)
    below = c_v_squared + delta * s_v**2
    above = (FAR_RATE * compute(below).subs(OF_V).subs(delta, DELTA)).factor().subs(c, s_v * d)
    here.claim("path", {rate_of(L) * below: above}, 36)
    phase = guess("Lambda - rho*(g_1*mu - h_2*D(L))", MATCHED)
    here.claim("phase", {psi_rate / 2: phase}, 33, 34, 36)


def _near(builder: LedgerBuilder) -> None:
    """Prove the motion with psi/2 by an angle X and the arctangent."""
    half = half_turned(parts("half", whole("X") * whole("T")))
    turn = turning(psi_rate / 2 - T_rate)
    here = Proofs.open(
        builder, "pi_near", *MOTION, SHIFT, SADDLE, NEAR, SCALED, COMPLETE, turn, half
    )
    here.model("arctangent")
    here.carry("arctangent", *("saddle", "T_size", "turn", "phase"))
    here.model("descended", "turn")
    here.carry("descended", "solution")
    whole_turn = g * (u_1 - (k_1 - n) * J)
    grown = alpha * u_1 + TURNED.coeff(J_periodic).subs(slower, k_1 - n) * (J - j * u_1)
    here.claim("grown", {K_1 * whole_turn: grown}, 36)
    slope_of_turn = g * mu * (1 - slower * FACTOR).cancel().subs(slower, k_1 - n)
    here.claim("slope", {rate_of(whole_turn): slope_of_turn}, 33, 34, 36)


def _far(builder: LedgerBuilder) -> None:
    """Prove the motion with psi/2 by an angle X alone."""
    half = half_turned({"re": compute(X_re), "im": compute(X_im)})
    here = Proofs.open(builder, "pi_far", *MOTION, SHIFT, SADDLE, FAR, turning(psi_rate / 2), half)
    here.model("other_end")
    here.carry("other_end", "path", "phase")
    here.model("descended")
    here.carry("descended", "solution")
