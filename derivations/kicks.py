"""Torques by a direction in space: the kicks of splitting methods.

A vector u that stays in space is v = conj(q) u q in body axes; by Rodrigues' formula with q = (q0,
r) that is u + q0 w + w x r, w = 2 u x r.  A potential of it, linear and quadratic,

    U = v Q v / 2 - m v,    g = dU/dv,    T = v x g,

loses what T gains: of gravity gradient Q is the inertia and u of length sqrt(3 mu/r^3), of a dipole
m in a field u there is m alone.  Beside it are a torque b that stays in the body, and k u in space.
"""

from typing import Any

from sympy import Matrix, Symbol, factor_terms, symbols
from sympy.solvers.solvers import solve_undetermined_coeffs

from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.algebra._quaternion import conjugate, product, rotated
from rigidsym.proof.steps import rate_of


def _vectors(names: str) -> Any:
    return [Matrix(symbols(f"{name}1:4")) for name in names.split()]


q0, k = symbols("q0 k")
r, u, v, w, g, b, m, T, Omega, eta = _vectors("q u v w g b m T Omega eta")
Q11, Q22, Q33, Q23, Q13, Q12 = SQUARED = symbols("Q11 Q22 Q33 Q23 Q13 Q12")
Q = Matrix([[Q11, Q12, Q13], [Q12, Q22, Q23], [Q13, Q23, Q33]])
U = compute(v.dot(Q * v) / 2 - m.dot(v)).expand()
TURNED = compute(conjugate((q0, *r))).apply(rotated, u).apply(Matrix)
# w = 2 u x r is what is linear in q0.
ABOUT = [x.coeff(q0).apply(factor_terms, sign=False) for x in TURNED]


def _seen() -> Computation:
    """Return conj(q) u q by u, w and w x r: the product of quaternions, matched with an ansatz."""
    along, across = symbols("along across")
    ansatz = compute(u + along * w + across * w.cross(r))
    miss = ansatz[0].subs(named(w, ABOUT)) - TURNED[0]
    miss = miss.expand().subs(q0**2, 1 - r.dot(r)).expand()
    return ansatz.subs(miss.apply(solve_undetermined_coeffs, [along, across], *r, *u))


# A small turn eta of the body changes v by v x eta and U by g (v x eta): the torque takes this off.
GAINED = compute(g.dot(v.cross(eta)))
TORQUE = [b[i] + k * v[i] - GAINED.diff(eta[i]) for i in range(3)]
SEEN = named(w, ABOUT) | named(v, _seen())
EXERTED = named(g, [U.diff(x).ordered("v1 v2 v3") for x in v]) | named(T, TORQUE)
TURNING = Part(
    (q0, *r, *Omega, *u, *b, k, *m, *SQUARED),
    relations=(q0**2 + r.dot(r) - 1,),
    rates={
        **named((q0, *r), (rate / 2 for rate in product((q0, *r), (0, *Omega)))),
        **dict.fromkeys(Omega, "?"),
    },
    definitions=SEEN | EXERTED | {"U": U},
    reading={
        **{x: f"component {i} of a vector in space" for i, x in enumerate(u, 1)},
        **{x: f"component {i} of a torque that stays in the body" for i, x in enumerate(b, 1)},
        **{x: f"component {i} of what the potential is linear by" for i, x in enumerate(m, 1)},
        k: "how much of the vector is a torque itself",
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove how a fixed direction turns in the body, and that the torque conserves energy."""
    here = Proofs.open(builder, "kick", TURNING)
    law = "a fixed direction turns in the body by its cross product with the rates"
    here.claim("fixed", named(map(rate_of, v), v.cross(Omega)), 3, law=law)
    here.evaluate("size", [v.dot(v)], 3)
    work, law = -Omega.dot(T - b - k * v), "the potential falls by the work of its torque"
    here.claim("work", {rate_of(Symbol("U")): work}, 3, law=law)
    here.begin((q0 - 1, *r), "", v, 3)
