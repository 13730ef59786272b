"""The Lie-Poisson form: the Lax equation is the flow of H by the bracket {M_i, M_j}.

Functions of the momentum have the bracket {F, G} = -M([dF, dG]).  So {M_i, M_j} is minus the sum of
f_ijk M_k, where [A_i, A_j] is the sum of f_ijk A_k, and it obeys Jacobi's identity because the
commutator does.  A function G has the flow F' = {F, G}.  In the flow of each M_j, K^2 is constant,
so it is a Casimir, and H' is {H, M_j} by the chain rule.  M_j' = {M_j, H}, the flow of H, is the
Lax equation M' = [M, Omega].
"""

import sympy
from sympy import MatAdd

from derivations.euler_lax import FREE_MOMENTUM, MOMENTA, Dynamics, H, K_squared
from derivations.lie_algebra import MOMENTUM_MATRIX, VELOCITY, A, Algebra, M, Omega, commutator
from derivations.setting import AXES
from rigidsym.proof.algebra import LedgerBuilder, Part, named
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import SIZE, Rate, Scope, differentiate, multiply
from rigidsym.proof.steps._names import read


def derive(builder: LedgerBuilder) -> None:
    """Prove Jacobi's identity, the Casimir, {H, M_j}, and that the flow of H is (7)."""
    algebra, given = builder.result(Algebra), builder.result(Dynamics).parameters
    scope = Scope.open(builder, "lie_bracket", matrices=algebra.basis, static=True)
    cyclic = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
    terms = (commutator(commutator(A[i], A[j]), A[k]) for i, j, k in cyclic)
    total, why = MatAdd(*terms, evaluate=False), "Jacobi's identity, by the commutator's"
    multiply(scope, "jacobi", total, sympy.ZeroMatrix(SIZE, SIZE), why, [4])

    body = _momenta(builder)
    rates = {}
    for j, momentum in zip(AXES, MOMENTA, strict=True):
        along = Part(rates=named(MOMENTA, (_bracket(algebra, i, j) for i in AXES)))
        scope = Scope.open(builder, f"poisson{j}", given, body, along)
        why = f"in the flow of M{j}, with M{j} in the place of H, K^2 is constant: a Casimir"
        differentiate(scope, "casimir", K_squared, why, [6, 7])
        why = f"and the rate of H is the bracket of H and M{j}, by the chain rule"
        rates[momentum] = -differentiate(scope, "energy", H, why, [8]).found
    matrices = {**algebra.basis, **MOMENTUM_MATRIX, **VELOCITY}
    velocity = Part(definitions=builder.result(Dynamics).velocities)
    scope = Scope.open(builder, "flow", given, body, velocity, Part(rates=rates), matrices=matrices)
    why = "the flow of H is the Lax equation"
    multiply(scope, "lax", Rate(M), commutator(M, Omega), why, [5, 7])


def _momenta(builder: LedgerBuilder) -> Part:
    """Return free momenta with H and K^2 as their functions."""
    dynamics = builder.result(Dynamics)
    energy = compute(read(dynamics.body.definitions[H])).subs(dynamics.velocities)
    square = dynamics.body.definitions[K_squared]
    known = {H: energy.expand().factor(), K_squared: square}
    return Part(MOMENTA, definitions=known, reading=FREE_MOMENTUM.reading)


def _bracket(algebra: Algebra, i: int, j: int) -> sympy.Expr:
    """Return {M_i, M_j}, of [A_i, A_j] = sum f_ijk A_k."""
    terms = zip(algebra.constants[i - 1][j - 1], MOMENTA, strict=True)
    return -sympy.Add(*(f * m for f, m in terms))
