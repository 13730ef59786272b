"""Natural motions between two attitudes: facts that the planner of manoeuvres uses.

Such a motion turns the body by p, a unit quaternion; R is p as a matrix.  The momentum stays where
it is in space: it is M in the body axes of the start and N = R^T M in those of the target.  The
energy stays, too, so that M lies on the cone M^T A M = 0, A = R J R^T - J, with the inverse
moments J.  At a time when the momentum is N, what is left of the attitude is a turn about M.  Where
A = 0, that is where the turn is a symmetry of the body, motions that arrive come in rings.

Not here: that motions with the same rates and attitude at one time are the same, which is a
theorem on all such equations; and when the turn that is left is a whole one, which is for numbers.
"""

from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Integer, diag, factor

from derivations.attitude import INERTIA as AXES
from derivations.euler_lax import INERTIA, Dynamics
from derivations.lie_algebra import UNIT_QUATERNION, Algebra
from derivations.regimes import BY_RATES as SORTED
from derivations.regimes import E_1, EXCESSES
from derivations.regular_form import BY_RATES, DIFFERENCES, H, by_sn
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.algebra._computation import Computation, compute, guess
from rigidsym.proof.algebra._quaternion import conjugate, product, rotated
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import expressions, symbol, symbols

CYCLES = ((1, 2, 3), (2, 3, 1), (3, 1, 2))
K, K_squared, s, along, across, i_a = symbols("K K_squared s along across i_a")
Q, P, X, Z = (symbols(f"{q}0 {q}1 {q}2 {q}3") for q in "qpxz")


def vector(name: str) -> Any:
    """Return a vector by the names of its components."""
    return ImmutableMatrix(symbols(f"{name}1 {name}2 {name}3"))


def entries(name: str) -> Any:
    """Return a matrix by the names of its entries."""
    return ImmutableMatrix(3, 3, lambda j, k: symbol(f"{name}{j + 1}{k + 1}"))


def defined(names: Any, sides: Computation) -> dict[Expr, Computation]:
    """Return definitions or equations, one for each entry of a vector or a matrix."""
    return dict(zip(names, sides, strict=True))


OMEGA, W, M, N, L = map(vector, ("Omega", "W", "M", "N", "L"))
BESIDE_M = vector("P")
C = symbols("c1 c2 c3")
J = diag(*(1 / c for c in C))
R, S, A = map(entries, "RSA")


def times(left: Any, right: Any) -> Computation:
    """Return the product of two quaternions."""
    return compute(tuple(left)).apply(product, tuple(right))


def turn(name: Any, q: tuple[Expr, ...]) -> dict[Expr, Computation]:
    """Return the entries of the rotation matrix of q: its columns are q e_k q^-1."""
    columns = [compute(q).apply(rotated, [int(j == k) for j in range(3)]) for k in range(3)]
    return {name[j, k]: columns[k][j] for j in range(3) for k in range(3)}


def turning(q: tuple[Expr, ...], rates: Any) -> dict[Expr, Computation]:
    """Return q' = q (0, Omega)/2."""
    sides = times(q, (0, *rates))
    return {rate_of(x): side / 2 for x, side in zip(q, sides, strict=True)}


def euler(momenta: Any, rates: Any) -> dict[Expr, Computation]:
    """Return Euler's equations c W' = P x W."""
    sides = compute(momenta).cross(rates)
    return {c * rate_of(w): side for c, w, side in zip(C, rates, sides, strict=True)}


# What q and Omega are at the time s t: everything moves s times as fast.
FASTER = Part(
    {s: "constant: the other names stand for a motion at the time s t"},
    definitions={w: s * omega for w, omega in zip(W, OMEGA, strict=True)},
    reading={f"W{k}": f"rate about axis {k} in the time t, rad/s" for k in (1, 2, 3)},
)
TURN = Part(
    P,
    definitions=turn(R, P),
    relations=(sum(x**2 for x in P) - 1,),
    reading={f"p{k}": f"component {k} of the turn from start to target" for k in range(4)},
)
MOMENTUM = Part(
    ("M1", "M2", "M3", K),
    definitions=defined(N, compute(R.T).multiply(M)),
    relations=(K**2 - M.dot(M),),
    nonnegative=(K,),
    reading={
        **{f"M{k}": f"momentum along body axis {k} of the start" for k in (1, 2, 3)},
        **{f"N{k}": f"momentum along body axis {k} of the target" for k in (1, 2, 3)},
        "K": "|M|, kg m^2 rad/s",
    },
)
# Twice what the energy gains is a quadratic form of M.
GAIN = N.dot(J * N) - M.dot(J * M)
BY_START = compute(GAIN).subs(MOMENTUM.definitions)
CONE = Part(
    definitions={A[j, k]: BY_START.diff(M[j], M[k]) / 2 for j in range(3) for k in range(3)},
)
# The attitude q takes N to L; z is what is left of it after the turn, q = z p.
ALONG = ImmutableMatrix(Z[1:]).dot(M)
LEFT = Part(
    definitions={
        **turn(S, Q),
        **defined(L, compute(S).multiply(N)),
        **dict(zip(Z, times(Q, conjugate(P)), strict=True)),
        along: ALONG,
    },
    reading={
        **{f"q{k}": f"component {k} of the attitude, 1 at the start" for k in range(4)},
        "along": "K sin(x/2), where z is a turn about M by x, and z0 is cos(x/2)",
    },
)
# The planes that E_b = 0 consists of, by the roots of the differences of inverse moments.
c_a, c_b, c_d = symbols("c_a c_b c_d")
M_a, M_b, M_d = symbols("M_a M_b M_d")
INVERSE = {c_a: i_a, c_b: i_a + across**2, c_d: i_a + across**2 + along**2}
PLANES = Part(
    (i_a, across, along, M_a, M_b, M_d),
    units=tuple(INVERSE.values()),
    definitions={
        **{c: 1 / inverse for c, inverse in INVERSE.items()},
        **{f"Omega_{x}": symbol(f"M_{x}") / symbol(f"c_{x}") for x in "abd"},
        **DIFFERENCES,
        **{name: BY_RATES[name] for name in ("H", "E_b")},
    },
    nonnegative=(across, along),
    reading={
        **AXES.reading,
        "i_a": "1/c_a; a is the axis of the largest moment",
        **{f"M_{x}": f"momentum along axis {x}, kg m^2 rad/s" for x in "abd"},
    },
)
# With p constant, the motion that has the rates W at the attitude x = q p.
BESIDE = Part(
    ("c1", "c2", "c3", "p0", "p1", "p2", "p3"),
    definitions={
        **defined(W, compute(R.T).multiply(OMEGA)),
        **defined(BESIDE_M, compute(R.T).multiply(M)),
        **dict(zip(X, times(Q, P), strict=True)),
    },
    reading={f"W{k}": f"rate about axis {k} of the motion beside, rad/s" for k in (1, 2, 3)},
)
# Axes j and k have one moment, or the turn does not mix them: R_jk = R_kj = 0, these being
# 2 (p_j p_k -+ p_0 p_i).
SYMMETRY = Part(
    relations=tuple(
        (C[j - 1] - C[k - 1]) * mixed for i, j, k in CYCLES for mixed in (P[j] * P[k], P[0] * P[i])
    ),
)
# R J - J R, which is 0 where R does not mix axes of different moments.
MIXED = compute(R * J - J * R).applyfunc(factor)
ACROSS = [(j, k) for j in range(3) for k in range(3) if j != k]


def derive(builder: LedgerBuilder) -> None:
    """Prove scaling of time, the cone, the bursts, planes, peaks, rings and a bound."""
    _faster(builder)
    _cone(builder)
    _left(builder)
    _planes(builder)
    _peaks(Proofs(builder, "regular"))
    _ring(builder)
    # K^2 <= 2 H c for the largest moment c.
    Proofs(builder, "sorted_body").sign("most_momentum", {EXCESSES[E_1]: SORTED[E_1]}, 6, 15)


def _faster(builder: LedgerBuilder) -> None:
    """Prove that q(s t) and s Omega(s t) are a motion, with momentum s M and energy s^2 H."""
    body, attitude = builder.result(Dynamics).body, builder.result(Algebra).attitude
    moving = expressions({**body.rates, **attitude.rates})
    faster = Part(rates={name: s * rate for name, rate in moving.items()})
    here = Proofs.open(builder, "faster", INERTIA, body, UNIT_QUATERNION, attitude, FASTER, faster)
    here.claim("kinematics", turning(Q, W), 3)
    momenta: Any = diag(*C) * W
    here.claim("euler", euler(momenta, W), 5)
    slow = {w: s * omega for w, omega in zip(W, OMEGA, strict=True)}
    names = {c * omega: m for c, omega, m in zip(C, OMEGA, M, strict=True)}
    sides = [*momenta, momenta.dot(momenta), momenta.dot(W) / 2]
    energy = sum(c * omega**2 for c, omega in zip(C, OMEGA, strict=True))
    square = sum((c * omega) ** 2 for c, omega in zip(C, OMEGA, strict=True))
    named = {energy: 2 * H, square: K_squared, **names}
    found = [compute(side).subs(slow).factor().subs(named) for side in sides]
    here.claim("invariants", zip(sides, found, strict=True), 6, 8, 15)


def _cone(builder: LedgerBuilder) -> None:
    """Prove that energies at both ends differ by a traceless form, zero on the turn's axis."""
    here = Proofs.open(builder, "manoeuvre", INERTIA, TURN, MOMENTUM, CONE, static=True)
    form = compute(A).multiply(M).dot(M).expand()
    here.claim("cone", {GAIN: form}, 6)
    here.evaluate("trace", [A.trace()])
    axis = ImmutableMatrix(P[1:])
    here.evaluate("axis", [*(R * axis), axis.dot(A * axis)])
    # From rest to rest the bursts are M and -N in the body axes.
    for burst, momentum in (("first", M), ("last", N)):
        square = compute(momentum).dot(momentum)
        here.root(K, square, 6, fact=f"{burst}_burst")
    # A R = R J - J R: A = 0 where R does not mix axes of different moments.
    here.claim("symmetry", {(A * R)[entry]: MIXED[entry] for entry in ACROSS})


def _left(builder: LedgerBuilder) -> None:
    """Prove that q = z p takes N to M exactly for z a turn about M."""
    here = Proofs.open(builder, "arrival", TURN, MOMENTUM, UNIT_QUATERNION, LEFT, static=True)
    here.evaluate("turn", R * N)
    here.claim("left", dict(zip(Q, times(Z, P), strict=True)))
    cross = ImmutableMatrix(Z[1:]).cross(M)
    chord = guess(
        f"4*({cross.dot(cross)})", "a chord by its angle, which has no short form expanded"
    )
    here.claim("gap", {(L - M).dot(L - M): chord})
    here.evaluate("angle", [(K * Z[0]) ** 2 + along**2 + cross.dot(cross)])


def _planes(builder: LedgerBuilder) -> None:
    """Prove that K^2 - 2 H c_b vanishes on two planes through axis b."""
    here = Proofs.open(builder, "separatrix_planes", PLANES, static=True)
    inverse = {i_a: 1 / c_a, across**2: 1 / c_b - 1 / c_a}
    squares = {
        root: compute(1 / c - INVERSE[c]).solve_for(root**2).subs(inverse).factor()
        for root, c in ((across, c_b), (along, c_d))
    }
    for root, square in squares.items():
        here.root(root, square)
    energy = sum(m**2 / c for m, c in ((M_a, c_a), (M_b, c_b), (M_d, c_d)))
    excess = M_a**2 + M_b**2 + M_d**2 - energy * c_b
    whole = compute(excess).expand()
    form = sum((whole.coeff(m**2).factor() * m**2 for m in (M_a, M_d)), compute(Integer(0)))
    E_b = symbol("E_b")
    claims = {excess: form, E_b: form}
    here.claim("E_b", claims, 6)
    # c_a - c_b is across^2 c_a c_b, and c_b - c_d is along^2 c_b c_d.
    gaps = {c_a - c_b: across**2 * c_a * c_b, c_b - c_d: along**2 * c_b * c_d}
    here.claim("planes", {E_b: form.subs(gaps).factor()})


def _peaks(here: Proofs) -> None:
    """Prove that |Omega|^2 is linear in sn^2, so stationary where sn, cn or dn vanishes."""
    square = Add(*(symbol(f"Omega_{x}") ** 2 for x in "abd"))
    sn, cn, dn, lambda_ = symbols("sn cn dn lambda_")
    constant, slope = by_sn(square)
    speed = constant + slope * sn**2
    here.claim("speed", {square: speed}, 10)
    change = speed.diff(sn) * lambda_ * cn * dn
    here.claim("speed_rate", {rate_of(square): change}, 10)


def _ring(builder: LedgerBuilder) -> None:
    """Prove that x = q p and W = R^T Omega are a motion if the turn preserves J.

    A motion from q = 1 that is at p at the time T has the rates W there: it goes on as x and W do,
    so that q(T + t) = q(t) p, and from whatever q(t) it is at, it turns by p in the time T.
    """
    body, attitude = builder.result(Dynamics).body, builder.result(Algebra).attitude
    motion = (INERTIA, TURN, body, UNIT_QUATERNION, attitude)
    here = Proofs.open(builder, "ring", *motion, BESIDE, SYMMETRY)
    here.evaluate("symmetry", [MIXED[entry] for entry in ACROSS])
    here.claim("kinematics", turning(X, W), 3)
    # R^T commutes with the inertia.
    momenta = compute(diag(*C)).multiply(W)
    here.claim("momentum", defined(BESIDE_M, momenta), 8)
    here.claim("euler", euler(BESIDE_M, W), 5, 7)
