"""One step from any state by its elapsed time alone: no phase, no regime, and no modulus.

Two functions of the elapsed time carry everything,

    X' = Y,    Y' = -e_1 X + 2 e_2 X^3,    starting at 0, 1,    e_1 = p - r/2,  e_2 = h^2,  h = r/4

with p and r of the addition form: X is sn(mu t | k_1^2)/mu after Landen's descent, but its modulus
is not asked for.  They double by rational functions (`doubling`), and S, C and D of the addition
form are rational in them.

The momentum over its size is a point n of a sphere; z = (n_d + i n_b)/(1 + n_a), its stereographic
projection, moves as an elliptic function of order two does, so that with G = 1 + h z^2 X^2

    z at t = (z Y + z' X)/G,    psi/2 = (psi_0/2) t - Im(arg G/2 + h z z' J),    J' = X^2/G

where z, z' and psi_0 are those at the start (`turn`).  The first two terms are of a Pi whose
parameter is complex, and J is small with t^3.  By G alone the second half of a time follows from
the first (`second_half`), whatever J is: psi needs J for the shortest of times.
"""

from collections.abc import Iterable, Sequence
from typing import Any

from sympy import I, S, Symbol, conjugate, factorial, rcollect, solve

from derivations import addition_form
from derivations.addition_form import ALPHA, FORCES, GIVEN, OMEGA_0
from derivations.attitude import (
    ENERGY,
    EULER,
    HANDEDNESS,
    INERTIA,
    MOMENTS,
    OMEGA,
    PSI_RATE,
    PULL_BACK,
    RATES,
    SENSE,
    SHORTEST,
    TURN,
    M,
    Omega_a,
    unsigned,
)
from derivations.landen_step import BELOW, CN, DN, GROWTH, KC, SN, c_next, d_next, k_next, s_next
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbol, symbols

# The names of the addition form, of the attitude, of the point and of the body.
alpha_a, alpha_b, alpha_d = ALPHA
p, r, g_a, g_d, below, S_t, C_t, D_t = symbols("p r g_a g_d below S_t C_t D_t")
epsilon, sigma, nu, K, H, psi_rate = symbols("epsilon sigma nu K H psi_rate")
(M_a, M_b, M_d), (c_a, c_b, c_d) = M, MOMENTS
n_a0, n_b0, n_d0 = N_0 = symbols("n_a0 n_b0 n_d0")
n_a, n_b, n_d = N_T = symbols("n_a n_b n_d")
h_a, h_b, h_d = H_N = symbols("h_a h_b h_d")
i_a, i_b, i_d = I_N = symbols("i_a i_b i_d")
M_a0, M_b0, M_d0 = M_0 = symbols("M_a0 M_b0 M_d0")
c_ab, c_ad, c_bd, l_a, l_b, l_d, psi_0, H_0 = symbols("c_ab c_ad c_bd l_a l_b l_d psi_0 H_0")
# Those of the step.
X, Y, X_next, Y_next, inside, mu = symbols("X Y X_next Y_next inside mu")
h, f, g, room, e_1, e_2, even, odd = symbols("h f g room e_1 e_2 even odd")
one, one_0, other, before, after, turn_0 = symbols("one one_0 other before after turn_0")
square, R, N, J_rate, G_rate = symbols("square R N J_rate G_rate")
cos_half_psi, sin_half_psi = symbols("cos_half_psi sin_half_psi")


z_re, z_im, zr_re, zr_im, w_re, w_im = symbols("z_re z_im zr_re zr_im w_re w_im")
G_re, G_im, G_re_rate, G_im_rate = symbols("G_re G_im G_re_rate G_im_rate")
T_re, T_im, E_re, E_im, W_re, W_im = symbols("T_re T_im E_re E_im W_re W_im")
V_re, V_im = symbols("V_re V_im")
z, zr, nu_, rate, G, F, T, E, U, W, P = (
    symbol(f"{name}_re") + I * symbol(f"{name}_im")
    for name in ("z", "zr", "nu", "rate", "G", "F", "T", "E", "U", "W", "P")
)


def _parts(name: str, value: Any) -> dict[Symbol, Computation]:
    """Return the real and the imaginary part of what is to have a complex name."""
    parts = compute(value).expand().as_real_imag()
    return named(symbols(f"{name}_re {name}_im"), parts)


def _imaginary(value: Any) -> Computation:
    return compute(value).expand().as_real_imag()[1]


def _over(parts: dict[Symbol, Computation], divisor: Symbol) -> dict[Symbol, Computation]:
    return {name: part / divisor for name, part in parts.items()}


def _slope(value: Any, rates: Any) -> Computation:
    """Return the time derivative by the chain rule."""
    return sum(compute(value).diff(name) * rate for name, rate in rates.items())


# Landen's step of the functions of the addition form, with s = mu X, c d = Y and h = k_1 mu^2.
LAMBDA = GROWTH * mu
RATIO = {k_next * mu**2: h}
F_OF_X = compute(BELOW).subs(s_next, mu * X).subs(RATIO)
G_OF_X = (DN * BELOW).cancel().subs(s_next, mu * X).subs(RATIO)
BY_ELAPSED = {
    name: form.subs({s_next: mu * X, d_next: Y / c_next}).subs(RATIO)
    for name, form in {S_t: SN / LAMBDA, C_t: CN, D_t: DN}.items()
}
BY_F_AND_G = {F_OF_X: f, G_OF_X: g}
# X' has the square (1 - mu^2 X^2)(1 - k_1^2 mu^2 X^2), and p = lambda^2, r = k^2 lambda^2.
CURVE = compute((1 - mu**2 * X**2) * (1 - k_next**2 * mu**2 * X**2)).expand()
TWICE_H = (-CURVE.coeff(X, 2) - LAMBDA**2 * KC**2).factor().subs(RATIO)
MODULI = {
    h: (((1 - KC**2) * LAMBDA**2).factor().subs(RATIO) - r).solve_for(h),
    e_1: TWICE_H + p - r,
    e_2: CURVE.coeff(X, 4).subs(mu**2 * k_next, h),
}
# The rates at t, where the denominators of S_t, C_t and D_t are multiplied out.
ADDED = addition_form.RATES.definitions
ROOM = (ADDED[below].subs(BY_ELAPSED).xreplace(BY_F_AND_G) * f**2).expand()
MOVED_RATES = {
    w: ((ADDED[w] * below).subs(BY_ELAPSED).xreplace(BY_F_AND_G) * f**2).expand() / room
    for w in OMEGA
}
CONSTANTS = {g_a: GIVEN.definitions[g_a], g_d: GIVEN.definitions[g_d]}
CONSTANTS |= {x: GIVEN.definitions[x].subs(CONSTANTS) for x in (p, r)}


def _by(value: Any, rates: Iterable[Any], forces: Iterable[Any]) -> Computation:
    """Return a formula of the addition form for other quantities with equations like Euler's."""
    return compute(value).xreplace(named((*OMEGA_0, *ALPHA), (*rates, *forces)))


def _moduli(rates: Iterable[Any], forces: Iterable[Any]) -> dict[Symbol, Computation]:
    """Return h, e_1 and e_2."""
    known = (tuple(rates), tuple(forces))
    quarter, rest = (
        _by(form.subs(CONSTANTS).factor(), *known).factor().subs(epsilon**2, 1)
        for form in (MODULI[h], compute(p - r))
    )
    return {h: quarter, e_1: TWICE_H + rest, e_2: MODULI[e_2]}


# The momentum has equations like Euler's for the inverse moments.
BY_MOMENTUM = {w: i * m for w, i, m in zip(OMEGA, I_N, M, strict=True)}
BY_INVERSE = {c: 1 / i for c, i in zip(MOMENTS, I_N, strict=True)}
FORCES_OF_M = [
    (EULER[w] * c).subs(BY_MOMENTUM).subs(BY_INVERSE).factor() * m / (M_a * M_b * M_d)
    for w, c, m in zip(OMEGA, MOMENTS, M, strict=True)
]


def _projected(zr: Symbol, z: Symbol, above: Any, below: Any, rates: Any) -> Computation:
    """Solve for the time derivative of the projection z = above/below."""
    moved = _slope(z * below - above, {**rates, z: zr})
    return unsigned(moved).solve_for(zr).factor()


# n_a, n_b, n_d are sigma M_a/K, sigma epsilon M_b/K and M_d/K: Euler's equations without signs.
OF_POINT = named(N_0, (h_a * n_b0 * n_d0, h_b * n_d0 * n_a0, h_d * n_a0 * n_b0))
POINTING = {M_a: sigma * K * n_a, M_b: sigma * epsilon * K * n_b, M_d: K * n_d}
BY_K = {n_a: sigma * M_a / K, n_b: sigma * epsilon * M_b / K, n_d: M_d / K}
DIFFERENCES = {i_b: i_a + h_d / K, i_d: i_a - h_b / K}
ENERGY_OF_M = compute(ENERGY).subs(BY_MOMENTUM).subs(BY_INVERSE)


def _half_turn() -> Computation:
    """Return half of what psi' is beyond K i_a, by the point."""
    beyond = (PSI_RATE - K * i_a).subs({H: ENERGY_OF_M, Omega_a: i_a * M_a})
    parts = beyond.together().as_numer_denom()
    above, under = (unsigned(part.subs(DIFFERENCES).subs(POINTING)) for part in parts)
    return (above.subs(n_a**2, 1 - n_b**2 - n_d**2) / under / 2).factor()


HALF_TURN = _half_turn()


def _half_turn_at(point: Sequence[Symbol], one: Any) -> Computation:
    """Return half of what psi' is beyond K i_a, at a point."""
    return HALF_TURN.subs(named(N_T, point)).xreplace({1 + point[0]: one})


POINT = Part(
    (h_a, h_d, n_d0, n_b0, n_a0),
    units=(1 + n_a0,),
    relations=(n_a0**2 + n_b0**2 + n_d0**2 - 1,),
    definitions={
        h_b: -h_a - h_d,
        **_moduli(N_0, H_N),
        z_re: compute(n_d0 / (1 + n_a0)),
        z_im: compute(n_b0 / (1 + n_a0)),
        zr_re: _projected(zr_re, z_re, n_d0, 1 + n_a0, OF_POINT),
        zr_im: _projected(zr_im, z_im, n_b0, 1 + n_a0, OF_POINT),
        turn_0: _half_turn_at(N_0, 1 + n_a0),
    },
    reading={
        h_a: "(1/c_d - 1/c_b) K, 1/s",
        h_d: "(1/c_b - 1/c_a) K, 1/s",
        **{f"n_{x}0": f"component {x} of M/K at t = 0, but for signs" for x in "abd"},
    },
)
ELAPSED = Part(
    {
        X: "sn(mu t | k_1^2)/mu with mu^2 and k_1^2 mu^2 the roots of x^2 - e_1 x + e_2",
        Y: "X', cn dn of the same",
    },
    relations=(Y**2 - 1 + e_1 * X**2 - e_2 * X**4,),
    rates={X: Y, Y: -e_1 * X + 2 * e_2 * X**3},
)
# What the start alone decides of psi: nu X^2 is 1 - G, and rate is half of nu'.
NU = {name: part.collect(h) for name, part in _parts("nu", -h * z**2).items()}
RATE = {name: part.collect(h) for name, part in _parts("rate", -h * z * zr).items()}
START = Part(definitions={**NU, **RATE})
G_PARTS = _parts("G", 1 - nu_ * X**2)
G_SLOPES = named((G_re_rate, G_im_rate), (_slope(part, ELAPSED.rates) for part in G_PARTS.values()))
SQUARE = compute(G * conjugate(G)).expand()
# The rate of the angle of G is the imaginary part of G'/G.
TURN_OF_G = _imaginary((I * G_im_rate + G_re_rate) * conjugate(G)) / square
FACTOR = Part(
    units=(square,),
    definitions={
        **G_PARTS,
        square: SQUARE,
        **G_SLOPES,
        J_rate: _imaginary(rate * conjugate(G)).ordered("rate_re rate_im") * X**2 / square,
        G_rate: (TURN_OF_G * square).subs(G_SLOPES).subs(G_PARTS).expand() / square,
    },
)
PARITY = {even: room + n_a0 * f * g, odd: h_a * n_b0 * n_d0 * X * Y, one_0: 1 + n_a0}
PLACES = Part(
    units=(room,),
    definitions={f: F_OF_X, g: G_OF_X, room: _by(ROOM, N_0, H_N), **PARITY},
)


def _moved(point: str, time: Any, one: Symbol, turn: Symbol) -> Part:
    """Return the point after a time, or before it, and half of psi's rate there."""
    moved = symbols(" ".join(f"{point}_{axis}" for axis in "abd"))
    places = (_by(MOVED_RATES[w], N_0, H_N).subs(X, time) for w in OMEGA)
    return Part(
        units=(one,),
        definitions={
            **named(moved, places),
            one: 1 + moved[0],
            turn: _half_turn_at(moved, one),
        },
    )


STEP = (POINT, ELAPSED, START, FACTOR, PLACES, _moved("n", X, one, after))
BEFORE = _moved("o", -X, other, before)
# The projection at t.
QUOTIENT = Part(
    definitions={
        **_parts("F", z * Y + zr * X),
        **_over(_parts("w", F * conjugate(G)), square),
    },
)
# The rate of psi/2 as a share of that at the start; then its even and its odd part.
SHARE = Part(
    (one_0, one, square, even, odd, turn_0),
    units=(one_0, one, square),
    relations=(one * (even - odd) - one_0**2 * square,),
    definitions={after: turn_0 * one_0 / one},
)
EARLIER = Part(
    (other,),
    units=(other,),
    relations=(other * (even + odd) - one_0**2 * square,),
    definitions={before: turn_0 * one_0 / other},
)
BY_PRODUCT = {
    turn: compute(shared).subs(point, compute(product).solve_for(point))
    for turn, shared, point, product in (
        (after, SHARE.definitions[after], one, SHARE.relations[0]),
        (before, EARLIER.definitions[before], other, EARLIER.relations[0]),
    )
}
PARTS = Part(
    (one_0, square, even, odd, turn_0),
    units=(one_0, square),
    definitions={
        after: BY_PRODUCT[after],
        G_rate: (BY_PRODUCT[before] - BY_PRODUCT[after]).factor(),
    },
)
EVEN = Part(definitions={J_rate: turn_0 * even / (one_0 * square) - turn_0})
BACK = Part(definitions={before: BY_PRODUCT[before]})
# R is the modulus of G; V is what the turn W of the first half becomes in the second.
MODULUS = compute(R**2 - square).subs(square, SQUARE)
R_RATE = _slope(SQUARE, {G_re: G_re_rate, G_im: G_im_rate}) / (2 * R)
HALVES = Part(
    (W_re, W_im, R),
    units=(R,),
    relations=(W_im**2 + W_re**2 - 1, R**2 - square),
    rates={W_re: -before * W_im, W_im: before * W_re, R: R_RATE},
    nonnegative=(R,),
    definitions=_over(_parts("V", W * conjugate(G)), R),
    reading={W_re: "cos of psi/2 from -t to 0", W_im: "sin of psi/2 from -t to 0"},
)
# Of the turn of G alone, whatever G is, and psi's.
ANY_G = Part(
    (G_re, G_im, G_re_rate, G_im_rate),
    units=(square,),
    rates={G_re: G_re_rate, G_im: G_im_rate, G_re_rate: "?", G_im_rate: "?"},
    definitions={square: SQUARE, G_rate: TURN_OF_G},
)
ANY_BEFORE = Part((before,), rates={before: "?"}, definitions={after: before - G_rate})
ANY_J = Part((J_rate,), rates={J_rate: "?"}, definitions={psi_rate: psi_0 + 2 * J_rate - G_rate})
CONSTANT = Part((psi_0,))


# psi/2 by three turns: T at the start's rate, E at that of J, and U, by half the angle of G: R + G
# halves the angle, and N is its modulus.
N_SQUARED = compute((R + G) * (R + conjugate(G))).expand().subs(G_im**2, R**2 - G_re**2).factor()
N_SQUARED = N_SQUARED.ordered("R")
THIRDS = Part(
    {
        T_re: "cos(psi_0*t/2)",
        T_im: "sin(psi_0*t/2)",
        E_re: "cos of the integral of J_rate",
        E_im: "sin of the integral of J_rate",
        R: "the modulus of G",
        N: "sqrt(2*R*(R + G_re))",
    },
    units=(R, N, R + G_re),
    relations=(
        *(T_im**2 + T_re**2 - 1, E_im**2 + E_re**2 - 1),
        *(R**2 - square, (N**2 - N_SQUARED).ordered("R")),
    ),
    rates={
        **{T_re: -(psi_0 / 2) * T_im, T_im: (psi_0 / 2) * T_re},
        **{E_re: -J_rate * E_im, E_im: J_rate * E_re},
        R: R_RATE,
        N: _slope(N_SQUARED, {R: R_RATE, G_re: G_re_rate}) / (2 * N),
    },
    nonnegative=(R, N),
    definitions={
        **_over(_parts("U", R + conjugate(G)), N),
        **_parts("P", T * E),
        **named((cos_half_psi, sin_half_psi), _parts("P", P * U).values()),
    },
)
# A body and its start, by the inverse moments and the momentum.
BELOW_Z = K + sigma * M_a0
BY_DIFFERENCE = {c_a - c_b: c_ab, c_a - c_d: c_ad, c_b - c_d: c_bd}
ALPHAS = {name: FORCES[str(name)].subs(BY_DIFFERENCE) for name in ALPHA}
PRODUCTS = {l_a: -alpha_b * alpha_d, l_b: alpha_a * alpha_d, l_d: -alpha_a * alpha_b}
AT_START = named((*OMEGA, *M, *N_T, H), (*OMEGA_0, *M_0, *N_0, H_0))
POINTED_START = {n.subs(AT_START): form.subs(AT_START) for n, form in BY_K.items()}
MOMENTUM_RATES = named(
    M_0, (x * M_a0 * M_b0 * M_d0 / m for x, m in zip(FORCES_OF_M, M_0, strict=True))
)
# Names in the order of evaluation that numbers follow.
ORDER = "alpha_a alpha_b alpha_d Omega_a0 Omega_b0 Omega_d0 f g X Y"
STARTED = Part(
    (i_a, i_b, i_d, M_d0, M_b0, M_a0, K),
    units=(i_a, i_b, i_d, K, BELOW_Z),
    relations=(K**2 - M_a0**2 - M_b0**2 - M_d0**2,),
    nonnegative=(K,),
    definitions={
        **BY_INVERSE,
        **{w: i * m for w, i, m in zip(OMEGA_0, I_N, M_0, strict=True)},
        **{name: difference for difference, name in BY_DIFFERENCE.items()},
        **ALPHAS,
        **{name: unsigned(compute(form).subs(ALPHAS)) for name, form in PRODUCTS.items()},
        H_0: compute(ENERGY).subs(AT_START).factor(),
        psi_0: PSI_RATE.subs(AT_START).ordered("K sigma"),
        **_moduli(M_0, FORCES_OF_M),
        **{x: POINT.definitions[x].subs(POINTED_START).cancel() for x in (z_re, z_im)},
        zr_re: _projected(zr_re, z_re, M_d0, BELOW_Z, MOMENTUM_RATES),
        zr_im: _projected(zr_im, z_im, sigma * epsilon * M_b0, BELOW_Z, MOMENTUM_RATES),
    },
    reading={
        K: "|M|, kg m^2 rad/s",
        **named(I_N, (f"1/{c}" for c in MOMENTS)),
        **{f"M_{x}0": f"the momentum about axis {x} at t = 0, kg m^2 rad/s" for x in "abd"},
    },
)
MOVED = Part(
    units=(room,),
    definitions={
        f: F_OF_X,
        g: G_OF_X,
        room: unsigned(_by(ROOM, M_0, FORCES_OF_M)),
        **{m: _by(MOVED_RATES[w], M_0, FORCES_OF_M) for m, w in zip(M, OMEGA, strict=True)},
        **BY_MOMENTUM,
    },
)
# The names of `turn` in a body's, and what `attitude` says of psi.
POINTED_FORCES = {h_a: K * (i_d - i_b), h_d: K * (i_b - i_a), h_b: -h_a - h_d}
POINTED = Part(
    definitions={
        **POINTED_FORCES,
        **BY_K,
        **POINTED_START,
        **PARITY,
        one: 1 + n_a,
        turn_0: _half_turn_at(N_0, one_0),
    },
)
TURNING = Part(
    units=(K + sigma * M_a,),
    definitions={after: _half_turn_at(N_T, one), H: ENERGY_OF_M, psi_rate: PSI_RATE},
)
DIRECTION = Part(
    (i_a, i_b, i_d, M_d, M_b, M_a, K),
    units=(K,),
    relations=(K**2 - M_a**2 - M_b**2 - M_d**2,),
    definitions={Omega_a: i_a * M_a, **POINTED_FORCES, **BY_K, one: 1 + n_a},
)


# A body by i_a, K and h_a, h_d; its start by the direction of the momentum.
AIMED = Part(
    (i_a, K, h_a, h_d),
    units=(K, i_a, i_b, i_d),
    definitions={
        i_b: i_a + h_d / K,
        i_d: i_b + h_a / K,
        **named(M_0, (form.subs(AT_START) for form in POINTING.values())),
    },
    nonnegative=(K,),
    reading={K: STARTED.reading[K]},
)
# The shortest rotation that takes the momentum to its axis.
SHORTEST_TURN = Part(
    (nu,),
    (nu,),
    SHORTEST.definitions,
    SHORTEST.relations[1:],
    SHORTEST.rates,
    (nu,),
    reading={nu: SHORTEST.reading[nu]},
)
# What the turn by thirds has for J's rate: psi's, less that at the start.
RATE_OF_J = Part(
    definitions={
        **named(I_N, (1 / c for c in MOMENTS)),
        **{name: form for name, form in DIRECTION.definitions.items() if name != Omega_a},
        after: TURNING.definitions[after],
        turn_0: psi_0 / 2 - K * i_a / 2,
        J_rate: after - turn_0 + G_rate / 2,
    },
)
CIRCLE = "a point of the unit circle that turns at a rate"
# At the start no time has passed, and nothing has turned.
ELAPSED_START = (X, Y - 1)
TURN_START = (W_re - 1, W_im, R - 1)
THIRDS_START = (T_re - 1, T_im, E_re - 1, E_im, R - 1, N - 2)


def derive(builder: LedgerBuilder) -> None:
    """Find the doubling, the turn, the second half of a time, and the motion by these."""
    for claims in (_doubling, _turn, _halves, _psi, _body, _motion):
        claims(builder)


def _doubled() -> dict[Symbol, Any]:
    """Match 2 X Y/(1 + x X^2 + y X^4) with the series of X at 2 t; Y there is half the slope."""
    x, y, t = symbols("x y t")
    series, derivative = compute(S.Zero), compute(X)
    for n in range(6):
        series += derivative.subs({X: 0, Y: 1}) * t**n / factorial(n)
        derivative = _slope(derivative, ELAPSED.rates)
    below = 1 + x * X**2 + y * X**4
    miss = series.subs(t, 2 * t) * compute(below).subs(X, series) - 2 * series * series.diff(t)
    miss = miss.expand()
    found = compute([miss.coeff(t, 3), miss.coeff(t, 5)]).apply(solve, [x, y])
    below = compute(below).subs(found)
    slope = _slope(2 * X * Y / below, ELAPSED.rates) / 2 - 1
    slope = slope.together().subs(Y**2, 1 - e_1 * X**2 + e_2 * X**4).factor()
    return {
        inside: below,
        X_next: 2 * X * Y / compute(below).subs(below, inside),
        Y_next: 1 + slope.xreplace({-below: -inside}).apply(rcollect, e_1),
    }


def _doubling(builder: LedgerBuilder) -> None:
    """Prove that X and Y at 2 t are the functions of 2 t, by their rates and their start."""
    doubled = _doubled()
    free = Part(
        (e_1, e_2, *ELAPSED.names),
        units=(1 - e_2 * X**4,),
        relations=ELAPSED.relations,
        rates=ELAPSED.rates,
        definitions=doubled,
    )
    builder.open(join("doubling", free))
    moved = {
        rate_of(X_next): 2 * Y_next,
        rate_of(Y_next): 2 * (-e_1 * X_next + 2 * e_2 * X_next**3),
    }
    law = "X and Y of the double time satisfy the equations of X and Y"
    builder.claim("doubling.rates", moved, ["DLMF 22.6.5"], law=law)
    curve = {Y_next**2: 1 - e_1 * X_next**2 + e_2 * X_next**4}
    builder.claim("doubling.curve", curve, ["DLMF 22.6.5"], law=law)
    builder.begin("doubling", ELAPSED_START, "", [X_next, Y_next], "DLMF 22.6.5")


def _turn(builder: LedgerBuilder) -> None:
    """Prove Euler's equations for the point, its projection, and psi's rate."""
    builder.open(join("turn", *STEP, QUOTIENT))
    euler = {
        rate_of(n_a): h_a * n_b * n_d,
        rate_of(n_b): h_b * n_d * n_a,
        rate_of(n_d): h_d * n_a * n_b,
    }
    law = "Euler's equations for the direction of the momentum"
    builder.claim("turn.euler", euler, ["5", "10"], law=law)
    builder.evaluate("turn.point", [n_a**2 + n_b**2 + n_d**2], ["6", "15"])
    projected = {w_re * (1 + n_a): n_d, w_im * (1 + n_a): n_b}
    law = "w is the stereographic projection of the direction of the momentum"
    builder.claim("turn.projection", projected, ["27"], law=law)
    _shared(builder, "share", "turn", SHARE)
    builder.open(join("parts", PARTS, EVEN, static=True))
    by_J = compute(J_rate - EVEN.definitions[J_rate]).solve_for(even)
    by_G = (G_rate - PARTS.definitions[G_rate]).solve_for(odd)
    by_rates = BY_PRODUCT[after].subs({even: by_J, odd: by_G}).expand()
    builder.claim("parts.psi", {after: by_rates}, ["33", "34", "36"])
    parts = {J_rate: EVEN.definitions[J_rate], G_rate: PARTS.definitions[G_rate]}
    even_part = "J is chosen: its rate is the even part of psi's, less that at the start"
    builder.claim("turn.parts", parts, ["36"], why=even_part)
    builder.model("turn", "parts", ["turn.after", "turn.parts"])
    builder.carry("turn", ["parts.psi"])


def _shared(builder: LedgerBuilder, name: str, context: str, *shares: Part) -> None:
    """Prove the rates as shares of the energy, and by 1 + n_a at t and -t."""
    products = {after: one * (even - odd), before: other * (even + odd)}
    defined = {turn: form for share in shares for turn, form in share.definitions.items()}
    builder.open(join(name, *shares, static=True))
    for turn in defined:
        builder.claim(f"{name}.{turn}", {turn: BY_PRODUCT[turn]}, ["36"])
    constant = "psi's rate times 1 + n_a is a sum of two invariants: found by hand"
    builder.claim(f"{context}.conserved", defined, ["6"], why=constant)
    known = {products[turn]: one_0**2 * square for turn in defined}
    why = "1 + n_a at t and -t have a product without a square root, found by hand"
    builder.claim(f"{context}.product", known, ["36"], why=why)
    builder.model(context, name, [f"{context}.conserved", f"{context}.product"])
    builder.carry(context, [f"{name}.{turn}" for turn in defined])


def _halves(builder: LedgerBuilder) -> None:
    """Prove that the second half of a time turns as the first, times the conjugate of G."""
    builder.open(join("halves", *STEP, BEFORE, HALVES))
    _shared(builder, "shares", "halves", SHARE, EARLIER)
    builder.open(join("difference", PARTS, BACK, static=True))
    gap = "G's rate was computed as the difference of the other two"
    builder.claim("difference.rates", {after: before - G_rate}, ["33", "34", "36"], why=gap)
    builder.claim("halves.odd", {G_rate: PARTS.definitions[G_rate]}, ["36"])
    builder.model("halves", "difference", [f"halves.{x}" for x in ("after", "before", "odd")])
    builder.carry("halves", ["difference.rates"])
    builder.open(join("second_half", ANY_G, ANY_BEFORE, HALVES))
    builder.root("second_half.R", R, MODULUS.solve_for(R**2), ["36"])
    later = {rate_of(V_re): -after * V_im, rate_of(V_im): after * V_re, V_re**2 + V_im**2: 1}
    builder.claim("second_half.turn", later, ["33", "34", "36"], law=CIRCLE)
    builder.model("halves", "second_half", ["halves.rates"])
    builder.carry("halves", ["second_half.turn", "second_half.R"])
    start = (G_re - 1, G_im, *TURN_START)
    builder.begin("second_half", start, "R", [V_re, V_im], "33", "34")
    builder.begin("halves", (*ELAPSED_START, *TURN_START), "R", [V_re, V_im], "33", "34")


def _psi(builder: LedgerBuilder) -> None:
    """Prove that psi/2 is the angle of a product of three turns."""
    builder.open(join("thirds", ANY_G, CONSTANT, ANY_J, THIRDS))
    builder.root("thirds.R", R, MODULUS.solve_for(R**2), ["36"])
    builder.root("thirds.N", N, N_SQUARED, ["36"])
    turn = {
        rate_of(cos_half_psi): -psi_rate / 2 * sin_half_psi,
        rate_of(sin_half_psi): psi_rate / 2 * cos_half_psi,
        cos_half_psi**2 + sin_half_psi**2: 1,
    }
    builder.claim("thirds.turn", turn, ["33", "34", "36"], law=CIRCLE)
    start = (G_re - 1, G_im, *THIRDS_START)
    builder.begin("thirds", start, "R N", [cos_half_psi, sin_half_psi], "33", "34")


def _body(builder: LedgerBuilder) -> None:
    """Prove Euler's equations for the rates of a body, and psi' as in `attitude`."""
    signs = (HANDEDNESS, SENSE)
    builder.open(join("direction", *signs, DIRECTION, TURNING, static=True))
    twice, why = {psi_rate: K * i_a + 2 * after}, "what `after` was computed as half of"
    builder.claim("direction.psi_rate_of_point", twice, ["33", "34"], why=why)
    parts = (*signs, STARTED, ELAPSED, START, FACTOR, MOVED, POINTED, TURNING, QUOTIENT)
    builder.open(join("step", *parts))
    builder.claim("step.euler", {rate_of(w): rate for w, rate in EULER.items()}, ["5", "10"])
    for w, i, c, m in zip(OMEGA_0, I_N, MOMENTS, M_0, strict=True):
        momentum = compute(w - i * m).solve_for(m).subs(i, 1 / c)
        builder.claim(f"step.{m}", {m: momentum}, ["8"])
    law = "the size of the momentum stays what it is"
    builder.claim("step.momentum", {M_a**2 + M_b**2 + M_d**2: K**2}, ["6", "15"], law=law)
    builder.claim("step.energy", {H: H_0}, ["6"], why="the energy stays what it is at the start")
    size = compute(STARTED.relations[0]).solve_for(K**2).ordered("M_a0 M_b0")
    builder.root("step.K", K, size, ["6", "15"])
    half = {turn_0: psi_0 / 2 - K * i_a / 2}
    builder.claim("step.turn_0", half, ["33", "34"], why=why)
    builder.model("step", "direction", ["step.momentum"])
    builder.carry("step", ["direction.psi_rate_of_point"])
    builder.model("step", "turn")
    builder.carry("step", ["turn.psi"])
    _numbers(builder)


def _numbers(builder: LedgerBuilder) -> None:
    """Find the step by moments and rates, with sums of nonnegative terms where signs decide."""
    by_product = {alpha_a * alpha_d: l_b, alpha_a * alpha_b: -l_d, alpha_b * alpha_d: -l_a}
    found = {name: form.subs(CONSTANTS).expand().subs(by_product) for name, form in MODULI.items()}
    rates = {
        m: (EULER[w] * c).subs(BY_DIFFERENCE).subs(AT_START)
        for m, w, c in zip(M_0, OMEGA, MOMENTS, strict=True)
    }
    projected = {
        zr_re: _projected(zr_re, z_re, M_d0, BELOW_Z, rates),
        zr_im: _projected(zr_im, z_im, sigma * epsilon * M_b0, BELOW_Z, rates),
    }
    builder.claim("step.h", {h: found[h].factor()}, ["10"])
    builder.claim("step.e_1", {e_1: found[e_1].subs(h, found[h]).expand()}, ["10"])
    # Between f^2 and g^2 is 4 h X^2.
    between = compute(f**2 - g**2).subs({f: F_OF_X, g: G_OF_X}).expand().subs(h, found[h])
    places = g**2 + (between + ROOM.subs(by_product) - f**2).expand()
    places = places.ordered("l_d Omega_d0")
    builder.claim("step.room", {room: places}, ["10"])
    for w, form in MOVED_RATES.items():
        builder.claim(f"step.{w}", {w: form.ordered(ORDER)}, ["5", "10"])
    for name, form in projected.items():
        builder.claim(f"step.{name}", {name: form}, ["27"])


def _motion(builder: LedgerBuilder) -> None:
    """Prove that rates and attitude of the whole step are the motion.

    Its variables are those of the point, by which psi's rate is short enough to be compared.
    """
    signs = (HANDEDNESS, SENSE)
    turned = (*signs, INERTIA, RATES, SHORTEST, ANY_G, CONSTANT, RATE_OF_J)
    angle = Part(definitions=half_angle("psi").definitions)
    builder.open(join("turned_by_thirds", *turned, THIRDS, TURN, angle, PULL_BACK))
    turning = {psi_rate: psi_0 + 2 * J_rate - G_rate}
    builder.claim("turned_by_thirds.rate", turning, ["33", "34"], why="how J was chosen")
    builder.model("turned_by_thirds", "thirds", ["turned_by_thirds.rate"])
    builder.carry("turned_by_thirds", ["thirds.turn", "thirds.R", "thirds.N"])
    builder.model("turned_by_thirds", "attitude", ["turned_by_thirds.turn"])
    builder.carry("turned_by_thirds", ["attitude.solution", "attitude.nu"])
    body = Part(definitions={**STARTED.definitions, **MOVED.definitions, **TURNING.definitions})
    step = (*signs, AIMED, body, *STEP, QUOTIENT, THIRDS, SHORTEST_TURN)
    builder.open(join("step_motion", *step, TURN, angle, PULL_BACK))
    builder.model("step_motion", "turn")
    builder.carry("step_motion", ["turn.psi"])
    builder.model("step_motion", "step")
    builder.carry("step_motion", ["step.euler", "step.momentum"])
    premises = [f"step_motion.{name}" for name in ("psi", "euler", "momentum")]
    builder.model("step_motion", "turned_by_thirds", premises)
    builder.carry("step_motion", [f"turned_by_thirds.{name}" for name in ("R", "N", "nu")])
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that the step starts at its rates and its attitude."""
    published = "M_a0 M_b0 M_d0 K h e_1 zr_re zr_im room Omega_a Omega_b Omega_d"
    builder.begin("step", ELAPSED_START, published, OMEGA, "5", "10")
    begun, start = (*OMEGA, cos_half_psi, sin_half_psi), (*ELAPSED_START, *THIRDS_START)
    builder.begin("step_motion", start, "R N nu", begun, "33", "34", "37")
    for context in ("step_start", "attitude_begun"):
        builder.model("step_motion_start", context)
