"""Motions with constant rates: rest, pure spin about any axis, the sphere, and the equatorial spin
of a symmetric body.  There M and Omega commute, and the attitude is one exponential.
"""

from dataclasses import replace

from sympy import Add

from derivations.euler_lax import INERTIA, RATES, Dynamics
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.algebra._quaternion import product
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbol, symbols

CONSTANT = Part(
    ("Omega1", "Omega2", "Omega3"),
    relations=("(c2 - c3)*Omega2*Omega3", "(c3 - c1)*Omega3*Omega1", "(c1 - c2)*Omega1*Omega2"),
)
OMEGA = symbol("omega")
LENGTH = OMEGA**2 - Add(*(rate**2 for rate in RATES))
SIZE = compute(LENGTH).solve_for(OMEGA**2)
SPIN = Part(
    {"omega": "|Omega|, rad/s", "t": "time, s"},
    units=("omega",),
    relations=(LENGTH,),
    definitions={"theta": "omega*t"},
    rates={"t": "1"},
    nonnegative=("omega",),
    reading={"theta": "angle turned, rad"},
)
AXIS = Part(
    {f"p{k}": f"component {k} of the attitude at t = 0" for k in range(4)},
    definitions={f"axis{k}": f"Omega{k}/omega" for k in (1, 2, 3)},
    relations=("p3**2 + p2**2 + p1**2 + p0**2 - 1",),
)
START = Part(relations=("t", "cos_half_theta - 1", "sin_half_theta"))
# exp(t Omega) is cos(theta/2) + sin(theta/2) axis, and q is its product with the attitude p.
COSINE, SINE = symbols("cos_half_theta sin_half_theta")
P, Q, R = symbols("p0 p1 p2 p3"), symbols("q0 q1 q2 q3"), symbols("r1 r2 r3")
TURNED = compute(P).apply(product, (COSINE, *R))
PULL_BACK = Part(
    definitions={
        **{r: SINE * axis for r, axis in zip(R, symbols("axis1 axis2 axis3"), strict=True)},
        **{q: side.ordered(f"p0 p{k}") for k, (q, side) in enumerate(zip(Q, TURNED, strict=True))},
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, |q| = 1 and q' = q (0, Omega)/2 for q = p exp(t Omega)."""
    turn = replace(half_angle("theta", "omega"), definitions={})
    body = builder.result(Dynamics).body
    here = Proofs.open(builder, "steady", INERTIA, CONSTANT, SPIN, AXIS, turn, PULL_BACK)
    euler = {f"D(Omega{k})": body.rates[f"Omega{k}"] for k in (1, 2, 3)}
    here.claim("euler", euler, 5)
    here.evaluate("norm", [Add(*(q**2 for q in Q))], 1)
    velocity = compute(Q).apply(product, (0, *RATES))
    turning = {rate_of(q): side / 2 for q, side in zip(Q, velocity, strict=True)}
    here.claim("solution", turning, 3)
    here.evaluate("theta_is_the_angle", ["D(theta)"], 3)
    here.root(OMEGA, SIZE, 3, fact="omega")
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that q = p at t = 0."""
    rates = Part(CONSTANT.names)
    attitude = Part(AXIS.names, definitions=AXIS.definitions)
    turn = half_angle("theta")
    angle = Part(turn.names, reading=turn.reading)
    parts = (INERTIA, rates, SPIN, attitude, angle, PULL_BACK, START)
    here = Proofs.open(builder, "steady_start", *parts, static=True)
    here.root(OMEGA, SIZE, 3, fact="omega")
    here.evaluate("attitude", ["theta", *Q], 37)
