"""A body with equal moments: its rates are a cosine and a sine, and its precession is regular.

The rate about the axis of symmetry k is constant.  The other two turn at nu = Omega_i'/Omega_j.
Where k is the last axis of the turns, the angle phi2 stays and the other two grow evenly, phi1 as
K/c t.
"""

import sympy

from derivations.conjugacy import MOMENTUM, PHI
from derivations.euler_lax import RATES, Dynamics
from derivations.kinematics import UNKNOWN, Phi1
from derivations.lie_algebra import Algebra
from derivations.setting import AXES
from rigidsym.proof.algebra import LedgerBuilder, Part, part_of
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import Scope, differentiate, integrate, rate_of, rewrite
from rigidsym.proof.steps._names import symbols

NU, AMPLITUDE, COSINE, SINE, T = symbols("nu amplitude cosine sine t")


def symmetric(builder: LedgerBuilder, axis: int) -> None:
    """Prove the rates of a body with equal moments across an axis, and how its angles turn."""
    setting = builder.result(Algebra).setting
    if not setting.alike(*AXES):
        _harmonic(builder, axis)
    rate = builder.result(Phi1).by_invariants
    if rate.has(*RATES):
        return  # the turns end about another axis
    motion = Scope(builder, builder.ledger.contexts["three_angle_motion"], {})
    tilt, why = sympy.cos(2 * setting.factor * PHI[1]), "the tilt of the axis stays"
    differentiate(motion, "tilt", tilt, why, [27])
    why = "and the turn about it is even"
    differentiate(motion, "spin", UNKNOWN[2], why, [28])
    time = Part({T: "time, s"}, rates={T: 1})
    scope = Scope.open(builder, "precession", builder.result(Dynamics).parameters, MOMENTUM, time)
    why = "the precession is regular"
    integrate(scope, "phi1", rate, {T: sympy.S.One}, why, [33, 36])


def _harmonic(builder: LedgerBuilder, axis: int) -> None:
    """Prove the second derivative of a rate across the axis, and the solution of both."""
    dynamics = builder.result(Dynamics)
    first, second = (RATES[k - 1] for k in AXES if k != axis)
    body = part_of(builder.ledger.contexts["body"], *map(str, RATES))
    scope = Scope.open(builder, "symmetric", dynamics.parameters, body)
    slopes = [scope.rate(rate) for rate in (first, second)]
    why = "a rate across the axis of symmetry swings evenly"
    differentiate(scope, "swing", slopes[0], why, [5])
    nu, wave = (compute(slopes[0]) / second).apply(sympy.cancel), AMPLITUDE * COSINE
    other = compute(wave).diff(COSINE) * (-NU * SINE) / NU  # from Omega_i' = nu Omega_j
    turning = Part(
        (RATES[axis - 1], AMPLITUDE, COSINE, SINE),
        definitions={NU: nu, first: wave, second: other},
        relations=(SINE**2 + COSINE**2 - 1,),
        rates={COSINE: -NU * SINE, SINE: NU * COSINE},
        reading={
            RATES[axis - 1]: "body rate about the axis of symmetry, rad/s",
            NU: "rate of the swing, rad/s",
            COSINE: "cos(nu*t + gamma)",
            SINE: "sin(nu*t + gamma)",
        },
    )
    scope = Scope.open(builder, "swinging", dynamics.parameters, turning)
    for rate, slope in zip((first, second), slopes, strict=True):
        form, why = compute(slope).factor(), "a cosine and a sine solve Euler's equations"
        rewrite(scope, f"swinging.{rate}", rate_of(rate), form, why, [5], "differentiate")
