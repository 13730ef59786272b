"""The attitude without sign functions: a turn about the momentum, then the shortest rotation.

Axes are named by what they do: a is the axis the rates circulate about, b the middle axis, d the
third; epsilon = +1 when (a, b, d) is right-handed, -1 when not, and sigma is the sign of Omega_a.
R = exp(psi sigma A_a) S, where S is the shortest rotation that takes M/K to sigma e_a.  Then
R' = R Omega is solved for psi'.  Its denominator never falls below K, so nothing here has an edge:
whatever the motion, and whatever the order of the axes, this R satisfies (3).  It is the regular
form of Theorem 1.
"""

from collections.abc import Iterable
from typing import Any

from sympy import Add, S, Symbol, factor, factor_terms, rem

from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle, named, sign
from rigidsym.proof.algebra._computation import Computation, compute, plain
from rigidsym.proof.algebra._quaternion import conjugate, product
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbols

epsilon, sigma, nu, K, H, psi_rate = symbols("epsilon sigma nu K H psi_rate")
MOMENTS = symbols("c_a c_b c_d")
OMEGA = Omega_a, Omega_b, Omega_d = symbols("Omega_a Omega_b Omega_d")
M = M_a, M_b, M_d = symbols("M_a M_b M_d")
# Names in the order of evaluation that numbers follow.
NAMES = "epsilon sigma K cos_half_psi sin_half_psi s_0 s_b s_d " + " ".join(
    f"{q}_{x}" for q in ("p", "q", "qbar") for x in "0abd"
)


def quaternion(name: str) -> tuple[Symbol, ...]:
    """Return the components of a quaternion on the axes (a, b, d)."""
    return symbols(" ".join(f"{name}_{x}" for x in "0abd"))


def times(left: Iterable[Any], right: Iterable[Any]) -> Computation:
    """Return the product of two quaternions on axes (a, b, d) of either handedness."""
    return compute(tuple(left)).apply(product, tuple(right), epsilon)


def components(name: str, sides: Iterable[Computation]) -> dict[str, Computation]:
    """Return definitions of the components of a quaternion."""
    table = named(quaternion(name), sides)
    return {str(x): side.ordered(NAMES) for x, side in table.items()}


def squares(names: Iterable[Any]) -> Any:
    """Return the sum of the squares."""
    return sum(x**2 for x in names)


def unsigned(expression: Computation) -> Computation:
    """Replace the squares of both signs by 1."""
    return expression.expand().subs({epsilon**2: 1, sigma**2: 1})


# The energy is where all begins; M is its gradient (8), and M' = [M, Omega] are Euler's equations.
ENERGY = factor(Add(*(c * w**2 / 2 for c, w in zip(MOMENTS, OMEGA, strict=True))))
GRADIENT = {m: compute(ENERGY).diff(w) for m, w in zip(M, OMEGA, strict=True)}
BRACKET = [side.subs(GRADIENT) for side in times((0, *M), (0, *OMEGA))][1:]
EULER = {w: (side / c).factor() for w, c, side in zip(OMEGA, MOMENTS, BRACKET, strict=True)}
SIZE = squares(M)


def rate(expression: Any) -> Computation:
    """Return the time derivative of an expression in the rates."""
    whole = compute(expression).subs(GRADIENT)
    return sum((whole.diff(w) * turning for w, turning in EULER.items()), compute(S.Zero))


# The shortest rotation is 1 - sigma e_a M/K, divided by its length nu/K.
ALONG = (0, sigma, 0, 0)
UNSCALED = [x - side for x, side in zip((K, 0, 0, 0), times(ALONG, (0, *M)), strict=True)]
NU_SQUARED = unsigned(squares(UNSCALED)).subs(M_d**2, K**2 - M_a**2 - M_b**2).factor()
BY_NU = compute(nu**2 - NU_SQUARED).solve_for(M_a)


def turning_rate() -> Computation:
    """Solve R' = R Omega for psi', and put H and K in the place of two rates.

    The component along a: psi' turns about M/K in the body, and S^-1 S' is added to it.
    """
    own = times(conjugate(UNSCALED), map(rate, UNSCALED))[1]
    invariants = [ENERGY - H, SIZE.subs(plain(GRADIENT)) - K**2]
    others = compute(invariants).solve_for(Omega_b**2, Omega_d**2)
    known = unsigned(own.subs(GRADIENT)).subs(others)
    along = Omega_a - psi_rate * M_a / K - 2 * known / NU_SQUARED
    found = along.subs(GRADIENT).solve_for(psi_rate).factor()
    return found.subs(GRADIENT[M_a].value, M_a).ordered("K sigma")


PSI_RATE = turning_rate()

INERTIA = Part(
    {
        "c_a": "moment of inertia about the circulation axis, kg m^2",
        "c_b": "the middle moment of inertia, kg m^2",
        "c_d": "the remaining moment of inertia, kg m^2",
    },
    units=MOMENTS,
)
HANDEDNESS = sign("epsilon", "+1 when the axes (a, b, d) are right-handed, -1 when not")
SENSE = sign("sigma", "the sign of Omega_a")
RATES = Part(
    {f"Omega_{x}": f"body rate about axis {x}, rad/s" for x in "abd"},
    definitions={**GRADIENT, H: ENERGY},
    rates=EULER,
)
SHORTEST = Part(
    {K: "|M|, kg m^2 rad/s", nu: "length of (K + sigma M_a, M x sigma e_a)"},
    units=(K, K + sigma * MOMENTS[0] * Omega_a, nu),
    definitions={
        "s_0": (UNSCALED[0].subs(M_a, BY_NU) / nu).cancel(),
        **{f"s_{x}": (UNSCALED[k] / nu).ordered("sigma") for k, x in ((2, "b"), (3, "d"))},
    },
    relations=(K**2 - SIZE, compute(nu**2 - NU_SQUARED)),
    rates={nu: rate(NU_SQUARED) / (2 * nu)},
    nonnegative=(K, nu),
)
# exp(psi sigma A_a), and the shortest rotation, which is about an axis across e_a.
cos_half_psi, sin_half_psi, s_0, s_b, s_d = symbols("cos_half_psi sin_half_psi s_0 s_b s_d")
ABOUT_A = (cos_half_psi, sigma * sin_half_psi, 0, 0)
TURN = Part(
    definitions={"psi_rate": PSI_RATE, **components("qbar", times(ABOUT_A, (s_0, 0, s_b, s_d)))},
)
# (37): a constant unit quaternion in front of the particular solution.
Q, P, QBAR = map(quaternion, ("q", "p", "qbar"))
PULL_BACK = Part(
    {f"p_{x}": f"component {x} of R(0) Rbar(0)^-1, constant" for x in "0abd"},
    definitions=components("q", times(P, QBAR)),
    relations=(squares(P) - 1,),
)
INVERSE = components("p", times(Q, conjugate(QBAR)))
# At the start psi is zero.
UNTURNED = Part(relations=(cos_half_psi - 1, sin_half_psi))
ATTITUDE = (
    HANDEDNESS,
    SENSE,
    INERTIA,
    RATES,
    SHORTEST,
    half_angle("psi", "psi_rate"),
    TURN,
    PULL_BACK,
)


def momentum() -> dict[str, Computation]:
    """Return the momentum in the body by (24), R^-1 (K sigma e_a) R, for either handedness."""
    turned = times(times(conjugate(QBAR), [K * x for x in ALONG]), QBAR)
    forms = (side.expand().apply(rem, epsilon**2 - 1, epsilon) for side in turned[1:])
    factored = (form.apply(factor_terms, sign=False).ordered(NAMES) for form in forms)
    return named(map(str, M), factored)


MOMENTUM = momentum()


def kinematics(builder: LedgerBuilder, q: tuple[Symbol, ...]) -> dict[Any, Any]:
    """Return |q| = 1 and q' = q (0, Omega)/2 on axes (a, b, d) of either handedness."""
    velocity = times(q, (0, *OMEGA))
    turning = {rate_of(x): side / 2 for x, side in zip(q, velocity, strict=True)}
    return {squares(q): builder.value("attitude", squares(q)), **turning}


def derive(builder: LedgerBuilder) -> None:
    """Prove the invariants without cancellation, the attitude, and the pull-back (37)."""
    here = Proofs.open(builder, "attitude", *ATTITUDE)
    here.evaluate("conserved", [rate_of(H), rate_of(K**2)], 6)
    here.root(K, compute(K**2 - SIZE).solve_for(K**2), 6, 15)
    here.formulas({w: (GRADIENT[m] - m).solve_for(w) for m, w in zip(M, OMEGA, strict=True)}, 8)
    here.root(nu, NU_SQUARED, 27)

    here.formulas(INVERSE, 37)
    here.claim("particular", kinematics(builder, QBAR), 3, 23)
    for name, form in MOMENTUM.items():
        here.claim(f"{name}_of_attitude", {name: form}, 24)
    here.claim("solution", kinematics(builder, Q), 3, 37)
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that with p by (37) q starts at the given attitude, and that p is a unit quaternion."""
    given = Part(
        (*Q, *QBAR),
        definitions=INVERSE,
        relations=(squares(Q) - 1, squares(QBAR) - 1),
    )
    here = Proofs.open(builder, "attitude_start", HANDEDNESS, given, static=True)
    here.claim("attitude", PULL_BACK.definitions, 37)
    here.evaluate("turn", [squares(P)], 37)
    here = Proofs.open(builder, "attitude_begun", *ATTITUDE, UNTURNED, static=True)
    here.evaluate("units", [squares(Q), squares(QBAR)], 37)
    here.formulas(INVERSE, 37)
    premises = [f"attitude_begun.{name}" for name in ("units", *INVERSE)]
    builder.model("attitude_begun", "attitude_start", premises)
