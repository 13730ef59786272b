"""Sensitivities of the attitude, column by column: the small turn in space, for numbers.

delta R = [eta] R, and with L = R M, l = L/K^2, dM the change of I omega in the body and s the share
of eta along L, times K,

    eta = l x (dL - R dM) + s l,    s = t dH - (dc_1 I_1 + dc_2 I_2 + dc_3 I_3)/2

dL = R dM at t = 0.  So eta' = R d omega, which is the variation of (3) seen in space.  A column is
this for one rate at t = 0 or one moment of inertia; `excess` is I_k less what it is without motion.
With n = M/K^2, l x R v is R (n x v): near a spin about axis k, n x e_k is small.
"""

from typing import Any

from sympy import Matrix, Symbol, diag, eye, factor

from derivations.attitude_sensitivities import SQUARED
from derivations.rate_sensitivities import change, still
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.algebra._quaternion import product, rotated
from rigidsym.proof.steps._names import symbol, symbols

AXES = (1, 2, 3)
CHANGES = tuple(f"{x}{k}" for x in ("Omega", "c") for k in AXES)
_FORMS = ("c{}", "Omega{}", "Omega{}_0", "l{}", "n{}", "n{}_0", "excess{}")
VECTORS: Any = [Matrix(symbols(" ".join(map(form.format, AXES)))) for form in _FORMS]
C, OMEGA, OMEGA_0, L, N, N_0, EXCESSES = VECTORS
Q, Q_0 = symbols("q0 q1 q2 q3"), symbols("p0 p1 p2 p3")
K_squared, per_K2, t = symbols("K_squared per_K2 t")


def matrix(name: str) -> Any:
    """Return a matrix of names, such as R11 to R33."""
    return Matrix(3, 3, lambda i, k: symbol(f"{name}{i + 1}{k + 1}"))


R, P, B, X, Y = map(matrix, "RPBXY")


def by(name: Any, y: str) -> Symbol:
    """Return the name of what a quantity changes by with a rate at t = 0 or a moment."""
    return symbol(f"{name}_by_{y}")


def rotation(q: Any) -> Any:
    """Return the rotation matrix of a unit quaternion, without the square of its scalar part."""
    turned = Matrix([rotated(q, axis) for axis in eye(3).tolist()]).T
    square = 1 - sum(x**2 for x in q[1:])
    return eye(3) + (turned.subs(q[0] ** 2, square).expand() - eye(3)).applyfunc(factor)


def energy(rates: Any) -> Any:
    """Return the kinetic energy."""
    return sum(c * x**2 for c, x in zip(C, rates, strict=True)) / 2


def squared(rates: Any) -> Any:
    """Return K^2, a sum of the squares of the momenta: the slopes of the energy."""
    return sum(compute(energy(rates)).diff(x).held() ** 2 for x in rates)


def direction(rates: Any) -> Computation:
    """Return the momentum in the body over K^2."""
    return compute(Matrix([energy(rates)])).jacobian(rates).transpose() * per_K2


START = {
    K_squared: squared(OMEGA_0),
    per_K2: 1 / K_squared,
    **named(P, compute(Q_0).apply(rotation)),
    **named(N_0, direction(OMEGA_0)),
    **named(L, compute(P).multiply(N_0)),
    **named(B, compute(P).multiply(N_0.hat())),
}
MOVING = {
    **named(R, compute(Q).apply(rotation)),
    **named(N, direction(OMEGA)),
    **named(X, compute(R).multiply(N.hat())),
    **named(Y, compute(X).multiply(diag(*C))),
}


def _column(i: int, y: str) -> Computation:
    """Return a component of eta by an input: l x dL at the start, less l x R dM, and along l."""
    rates = {x: by(x, y) for x in OMEGA}
    inputs = {symbol(y): 1} if y.startswith("c") else {symbol(f"{y}_0"): 1}
    arms = {Y[i, k]: X[i, k] for k in range(3) if str(C[k]) == y}
    begun = change((B * diag(*C) * OMEGA_0)[i], inputs)
    seen = change((Y * OMEGA)[i], {**rates, **arms})
    work = change(t * energy(OMEGA_0) - C.dot(SQUARED) / 2, inputs).subs(INTEGRALS).expand()
    return (begun - seen.held()).held() + work * L[i]


INTEGRALS = named(SQUARED, EXCESSES + t * OMEGA_0.applyfunc(lambda x: x**2))
COLUMNS = {by(f"eta{i + 1}", y): _column(i, y) for y in CHANGES for i in range(3)}
# Differences of moments by names of their own: numbers have them from before rounding.
DIFFERENCES = {
    symbol(f"c{i}{j}"): symbol(f"c{i}") - symbol(f"c{j}") for i, j in ((1, 2), (1, 3), (2, 3))
}
# (c Omega)' = c Omega x Omega.
EULER = [x.factor() / c for x, c in zip(compute(diag(*C) * OMEGA).cross(OMEGA), C, strict=True)]
BY_TIME = {
    **DIFFERENCES,
    **named((by(f"eta{i}", "t") for i in AXES), compute(R).multiply(OMEGA)),
    **named(
        (by(x, "t") for x in OMEGA),
        (x.subs({value: name for name, value in DIFFERENCES.items()}) for x in EULER),
    ),
}
AT_TIME = {**MOVING, **COLUMNS, **BY_TIME}
BODY = Part(
    {f"c{k}": f"moment of inertia {k}, kg m^2" for k in AXES},
    units=tuple(C),
)
RATES_AT_START = Part({f"Omega{k}_0": f"Omega{k} at t = 0" for k in AXES})
RATES = Part(
    {f"Omega{k}": f"body rate about axis {k}, rad/s" for k in AXES},
    rates=named(OMEGA, EULER),
)


def _moved(y: str) -> dict[Any, Any]:
    """Return the changes of rates and of one input."""
    begun = {} if y.startswith("c") else {symbol(f"{y}_0"): 1}
    return {**{x: by(x, y) for x in OMEGA}, **{c: 1 for c in C if str(c) == y}, **begun}


# A column has the variation of Euler's equations, and the right change of the energy.
VARIED = Part(
    {by(x, y): f"what {x} changes by with {y}" for y in CHANGES for x in OMEGA},
    rates={
        by(x, y): change(rate, _moved(y))
        for y in CHANGES
        for x, rate in zip(OMEGA, EULER, strict=True)
    },
    relations=tuple(change(energy(OMEGA) - energy(OMEGA_0), _moved(y)) for y in CHANGES),
)
EXCESS = Part(
    {
        t: "time, s",
        **{f"excess{k}": f"the integral of Omega{k}^2 - Omega{k}_0^2 from 0 to t" for k in AXES},
    },
    rates={t: 1, **named(EXCESSES, (x**2 - y**2 for x, y in zip(OMEGA, OMEGA_0, strict=True)))},
)
# The momentum over its square, seen in space: constant, as at t = 0.
DIRECTION = {
    K_squared: squared(OMEGA),
    per_K2: 1 / K_squared,
    **named(L, compute(R).multiply(direction(OMEGA))),
}
ARMS = Part(
    {B[i - 1, k - 1]: f"component {i} of l x R e_{k} at t = 0" for i in AXES for k in AXES},
)
ATTITUDE = Part(
    {q: f"component {k} of the attitude" for k, q in enumerate(Q)},
    rates=named(Q, (x / 2 for x in product(Q, (0, *OMEGA)))),
    relations=(sum(q**2 for q in Q) - 1,),
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that the columns, that of the time too, satisfy the variation of (3) and start at 0."""
    defined = {**MOVING, **DIRECTION, **AT_TIME}
    parts = (BODY, RATES_AT_START, RATES, EXCESS, ARMS, VARIED, ATTITUDE)
    here = Proofs.open(
        builder, "turned_columns", *parts, Part(definitions=defined, units=(K_squared,))
    )
    here.evaluate("momentum", [f"D({x})" for x in L], 6)
    for y in CHANGES:
        turns = compute(R).multiply(Matrix([by(x, y) for x in OMEGA]))
        claims = named((f"D({by(f'eta{i}', y)})" for i in AXES), turns)
        here.claim(f"by_{y}", claims, 3)
    spin = Matrix([by(f"eta{i}", "t") for i in AXES])
    turned = named((f"D({x})" for x in R), compute(spin.hat()).multiply(R))
    turned |= {f"D({x})": by(x, "t") for x in OMEGA}
    law = "what changes with the time has its rate as change"
    here.claim("by_t", turned, 3, 5, law=law)
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that all columns of the attitude are zero at t = 0."""
    attitude = Part(
        {q: f"component {k} of the attitude at t = 0" for k, q in enumerate(Q_0)},
        relations=(sum(q**2 for q in Q_0) - 1,),
    )
    begun = Part(
        definitions={
            **START,
            **named(Q, Q_0),
            **named(OMEGA, OMEGA_0),
            **{by(x, y): int(str(x) == y) for y in CHANGES for x in OMEGA},
            **AT_TIME,
        },
        units=(K_squared,),
        relations=(t, *EXCESSES),
    )
    parts = (*still(BODY, RATES_AT_START, EXCESS), attitude, begun)
    here = Proofs.open(builder, "turned_columns_start", *parts, static=True)
    turns = [by(f"eta{i}", y) for y in CHANGES for i in AXES]
    here.evaluate("turn", turns, 37)
