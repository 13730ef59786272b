"""Sensitivities of the attitude: a small turn by the integrals of Omega_k^2 alone.

L = R M is constant, so its change is; seen in the body it is l, with l' = l x Omega.  Let xi be the
small turn in the body, dR = R [xi], so that l = dM + xi x M, and s its component along M, times K.
Solved for xi,

    xi = (M x (l - dM) + s M)/K^2,    s = s_0 + t dH - (dc1 I1 + dc2 I2 + dc3 I3)/2

where I_k' = Omega_k^2.  The change of q is q (0, xi)/2.  Nothing divides by anything but K, and no
derivative of an elliptic integral of the third kind is asked for, whatever the motion.
"""

from collections.abc import Iterable
from typing import Any

import sympy
from sympy import Matrix, Symbol

from derivations.euler_lax import Dynamics
from derivations.rate_sensitivities import change, defined, moving, small, still
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.algebra._quaternion import product
from rigidsym.proof.steps._names import symbol, symbols

AXES = (1, 2, 3)
_NAMES = ("c", "Omega", "M", "l", "xi", "I", "eta")
VECTORS: Any = [Matrix(symbols(f"{x}1 {x}2 {x}3")) for x in _NAMES]
C, OMEGA, M, L, XI, SQUARED, ETA = VECTORS
Q = symbols("q0 q1 q2 q3")
K, s, s_0, t = symbols("K s s_0 t")


def varied(names: Iterable[Symbol]) -> Any:
    """Return the changes of quantities."""
    return Matrix([symbol(f"d{name}") for name in names])


def commutator(one: Any, other: Any) -> Computation:
    """Return the vector of [one] [other] - [other] [one]."""
    product = compute(one.hat()).multiply(other.hat())
    return (product - compute(other.hat()).multiply(one.hat())).expand().vee()


# (R [Omega])' = (R [xi])' has R [xi] [Omega] + R [dOmega] = R [Omega] [xi] + R [xi'].
TURNING = varied(OMEGA) + commutator(XI, OMEGA)
# l = dM + xi x M and s = xi . M are four equations A xi = b, and A^T A is K^2 times the identity.
_MATRIX, _GIVEN = compute([*XI.cross(M), XI.dot(M)]).apply(sympy.linear_eq_to_matrix, [*XI])
_SQUARE = _MATRIX.T.multiply(_MATRIX).expand().subs(M.dot(M), K**2)
SOLVED = _SQUARE.inv().multiply(_MATRIX.T.multiply(Matrix([*(L - varied(M)), s])))
STATE = Part(
    ("Omega1", "Omega2", "Omega3", K),
    units=(K,),
    relations=(K**2 - M.dot(M),),
    reading={K: "|M|, kg m^2 rad/s"},
)
MOMENTUM = Part(
    {f"l{k}": f"component {k} in the body of the change of L = R M" for k in AXES},
    relations=(M.dot(L - varied(M)),),
    rates=named(L, compute(L).cross(OMEGA)),
)
INTEGRALS = Part(
    {t: "time, s", **{f"I{k}": f"the integral of Omega{k}^2 from 0 to t" for k in AXES}},
    rates={t: 1, **named(SQUARED, OMEGA.applyfunc(lambda x: x**2))},
)
ALONG = {s: s_0 + t * symbol("dH") - varied(C).dot(SQUARED) / 2}
BEGUN = Part({s_0: "xi . M at t = 0"}, definitions=ALONG)
TURN = Part(
    definitions=named(XI, SOLVED),
    reading={f"xi{k}": f"component {k} of the small turn in the body" for k in AXES},
)
TURNED = named(Q, (x / 2 for x in product(Q, (0, *OMEGA))))
ATTITUDE = Part(
    Q,
    rates=TURNED,
    relations=(sum(q**2 for q in Q) - 1,),
    definitions=named(varied(Q), (x / 2 for x in compute(Q).apply(product, (0, *XI)))),
    reading={q: f"component {k} of the attitude" for k, q in enumerate(Q)},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that small turn and change of q satisfy the variation of (3) from given values."""
    dynamics = builder.result(Dynamics)
    given = (dynamics.parameters, dynamics.body)
    rates, quantities = moving(*given), defined(*given)
    # A body beside the one that moves: its moments, its rates and, in the body, its momentum.
    beside = Part(
        (*small(*C).names, *small(*OMEGA).names),
        definitions={f"d{x}": change(quantities[symbol(x)]) for x in ("M1", "M2", "M3", "H")},
        rates=named(varied(OMEGA), (change(rates[x]) for x in OMEGA)),
        reading={**small(*C, *OMEGA).reading, "dH": "change of the energy, constant"},
    )
    parts = (*given, STATE, beside, MOMENTUM, INTEGRALS, BEGUN, TURN)
    here = Proofs.open(builder, "turned", *parts)
    here.evaluate("energy", ["D(dH)"], 6)
    law = "s is the small turn along the momentum"
    here.claim("along", {XI.dot(M): s}, 6, law=law)
    claims = named((f"D({x})" for x in XI), TURNING)
    here.claim("variation", claims, 3)
    here = Proofs.open(builder, "turned_attitude", *parts, ATTITUDE)
    variation = {f"D(d{q})": change(rate) for q, rate in TURNED.items()}
    here.claim("variation", variation, 3)
    norm = sum(q * symbol(f"d{q}") for q in Q)
    here.evaluate("norm", [norm], 1)
    momenta = Part(definitions=named(M, (quantities[m] for m in M)))
    begun = Part(
        ETA,
        definitions={
            **named(L, varied(M) + compute(ETA).cross(M)),
            s_0: compute(ETA).dot(M),
            **ALONG,
        },
        relations=(t, *SQUARED),
        reading={x: f"component {k} of xi at t = 0" for k, x in enumerate(ETA, 1)},
    )
    parts = (dynamics.parameters, momenta, STATE, *still(INTEGRALS), beside, begun, TURN)
    here = Proofs.open(builder, "turned_start", *parts, static=True)
    here.evaluate("turn", XI, 37)
    _rest(builder)


def _rest(builder: LedgerBuilder) -> None:
    """Prove the case of a body at rest, where the small turn grows linearly."""
    begun = Part(
        (t, *ETA, *varied(OMEGA)),
        rates={t: 1},
        definitions={**dict.fromkeys(OMEGA, 0), **named(XI, ETA + t * varied(OMEGA))},
        reading={x: f"component {k} of xi at t = 0" for k, x in enumerate(ETA, 1)},
    )
    here = Proofs.open(builder, "turned_at_rest", begun)
    here.claim("variation", named((f"D({x})" for x in XI), TURNING), 3)
