"""Motions with constant rates: rest, pure spin about any axis, the sphere, and the equatorial spin
of a symmetric body.  There M and Omega commute, and the attitude is one exponential.
"""

from dataclasses import replace

from derivations.euler_lax import INERTIA, Dynamics
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join
from rigidsym.proof.algebra._quaternion import kinematics

CONSTANT = Part(
    witness={"Omega1": "1", "Omega2": "0", "Omega3": "0"},
    relations=("(c2 - c3)*Omega2*Omega3", "(c3 - c1)*Omega3*Omega1", "(c1 - c2)*Omega1*Omega2"),
)
SPIN = Part(
    witness={"omega": "1", "t": "0"},
    units=("omega",),
    relations=("omega**2 - Omega1**2 - Omega2**2 - Omega3**2",),
    definitions={"theta": "omega*t"},
    rates={"t": "1"},
    nonnegative=("omega",),
    reading={"omega": "|Omega|, rad/s", "t": "time, s", "theta": "angle turned, rad"},
)
AXIS = Part(
    witness={f"p{k}": str(int(k == 0)) for k in range(4)},
    definitions={f"axis{k}": f"Omega{k}/omega" for k in (1, 2, 3)},
    relations=("p3**2 + p2**2 + p1**2 + p0**2 - 1",),
    reading={f"p{k}": f"component {k} of the attitude at t = 0" for k in range(4)},
)
START = Part(relations=("t", "cos_half_theta - 1", "sin_half_theta"))
PULL_BACK = Part(
    definitions={
        "r1": "sin_half_theta*axis1",
        "r2": "sin_half_theta*axis2",
        "r3": "sin_half_theta*axis3",
        "q0": "p0*cos_half_theta - p1*r1 - p2*r2 - p3*r3",
        "q1": "p0*r1 + p1*cos_half_theta + p2*r3 - p3*r2",
        "q2": "p0*r2 + p2*cos_half_theta + p3*r1 - p1*r3",
        "q3": "p0*r3 + p3*cos_half_theta + p1*r2 - p2*r1",
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, |q| = 1 and q' = q (0, Omega)/2 for q = p exp(t Omega)."""
    turn = replace(half_angle("theta", "omega"), definitions={})
    body = builder.result(Dynamics).body
    builder.open(join("steady", INERTIA, CONSTANT, SPIN, AXIS, turn, PULL_BACK))
    euler = {f"D(Omega{k})": body.rates[f"Omega{k}"] for k in (1, 2, 3)}
    builder.claim("steady.euler", euler, ["5"])
    builder.claim("steady.norm", {"q0**2 + q1**2 + q2**2 + q3**2": "1"}, ["1"])
    turning = kinematics("q0 q1 q2 q3", "Omega1 Omega2 Omega3")
    builder.claim("steady.solution", turning, ["3"])
    builder.claim("steady.theta_is_the_angle", {"D(theta)": "omega"}, ["3"])
    builder.root("steady.omega", "omega", "Omega1**2 + Omega2**2 + Omega3**2", ["3"])
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that q = p at t = 0."""
    rates = Part(witness=CONSTANT.witness)
    attitude = Part(witness=AXIS.witness, definitions=AXIS.definitions)
    turn = half_angle("theta")
    angle = Part(turn.witness, reading=turn.reading)
    parts = (INERTIA, rates, SPIN, attitude, angle, PULL_BACK, START)
    builder.open(join("steady_start", *parts, static=True))
    builder.root("steady_start.omega", "omega", "Omega1**2 + Omega2**2 + Omega3**2", ["3"])
    start = {"theta": "0"} | {f"q{k}": f"p{k}" for k in range(4)}
    builder.claim("steady_start.attitude", start, ["37"])
