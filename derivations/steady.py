"""Motions with constant rates: rest, pure spin about any axis, the sphere, and the equatorial spin
of a symmetric body.  There M and Omega commute, and the attitude is one exponential.
"""

from dataclasses import replace

from sympy import Add

from derivations.euler_lax import INERTIA, RATES, Dynamics
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle, named, unit_quaternion
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.algebra._quaternion import product
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbols

omega, theta, t, cosine, sine = symbols("omega theta t cos_half_theta sin_half_theta")
P, Q, R, AXES = map(symbols, ("p0 p1 p2 p3", "q0 q1 q2 q3", "r1 r2 r3", "axis1 axis2 axis3"))
CONSTANT = Part(
    RATES,
    relations=("(c2 - c3)*Omega2*Omega3", "(c3 - c1)*Omega3*Omega1", "(c1 - c2)*Omega1*Omega2"),
)
LENGTH = omega**2 - Add(*(rate**2 for rate in RATES))
SIZE = compute(LENGTH).solve_for(omega**2)
SPIN = Part(
    {omega: "|Omega|, rad/s", t: "time, s"},
    units=(omega,),
    relations=(LENGTH,),
    definitions={theta: omega * t},
    rates={t: 1},
    nonnegative=(omega,),
    reading={theta: "angle turned, rad"},
)
BEGUN = unit_quaternion("p", "the attitude at t = 0")
AXIS = Part(definitions=named(AXES, (rate / omega for rate in RATES)))
START = Part(relations=(t, "cos_half_theta - 1", sine))
# exp(t Omega) is cos(theta/2) + sin(theta/2) axis, and q is its product with the attitude p.
TURNED = compute(P).apply(product, (cosine, *R))
PULL_BACK = Part(
    definitions={
        **named(R, (sine * axis for axis in AXES)),
        **{q: side.ordered(f"p0 {p}") for p, q, side in zip(P, Q, TURNED, strict=True)},
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, |q| = 1 and q' = q (0, Omega)/2 for q = p exp(t Omega)."""
    turn = replace(half_angle("theta", "omega"), definitions={})
    body = builder.result(Dynamics).body
    here = Proofs.open(builder, "steady", INERTIA, CONSTANT, SPIN, BEGUN, AXIS, turn, PULL_BACK)
    euler = {rate_of(w): body.rates[w] for w in RATES}
    here.claim("euler", euler, 5)
    here.evaluate("norm", [Add(*(q**2 for q in Q))], 1)
    velocity = compute(Q).apply(product, (0, *RATES))
    here.claim("solution", named(map(rate_of, Q), (side / 2 for side in velocity)), 3)
    here.evaluate("theta_is_the_angle", [rate_of(theta)], 3)
    here.root(omega, SIZE, 3)
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that q = p at t = 0."""
    turn = half_angle("theta")
    angle = Part(turn.names, reading=turn.reading)
    parts = (INERTIA, Part(RATES), SPIN, Part(P), AXIS, angle, PULL_BACK, START)
    here = Proofs.open(builder, "steady_start", *parts, static=True)
    here.root(omega, SIZE, 3)
    here.evaluate("attitude", [theta, *Q], 37)
