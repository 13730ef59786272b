"""Natural motions between two attitudes: facts that the planner of manoeuvres uses.

Such a motion turns the body by p, a unit quaternion; R is p as a matrix.  The momentum stays where
it is in space: it is M in the body axes of the start and N = R^T M in those of the target.  The
energy stays, too, so that M lies on the cone M^T A M = 0, A = R J R^T - J, with the inverse
moments J.  At a time when the momentum is N, what is left of the attitude is a turn about M.  Where
A = 0, that is where the turn is a symmetry of the body, motions that arrive come in rings.

Not here: that motions with the same rates and attitude at one time are the same, which is a
theorem on all such equations; and when the turn that is left is a whole one, which is for numbers.
"""

from collections.abc import Iterable

from sympy import Expr, symbols

from derivations.attitude import INERTIA as AXES
from derivations.euler_lax import INERTIA, Dynamics
from derivations.lie_algebra import UNIT_QUATERNION, Algebra
from derivations.regular_form import BY_RATES, DIFFERENCES
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._quaternion import conjugate, kinematics, product, rotated

CYCLES = ((1, 2, 3), (2, 3, 1), (3, 1, 2))
PAIRS = [(j, k) for j in (1, 2, 3) for k in (1, 2, 3)]
ACROSS = [(j, k) for j, k in PAIRS if j != k]


def total(term: str) -> str:
    """Return the sum of a term over the three axes; ? stands for their numbers."""
    return " + ".join(term.replace("?", k) for k in "123")


def matrix(name: str, q: str) -> dict[str, str]:
    """Return the entries of the rotation matrix of q: its columns are q e_k q^-1."""
    columns = (rotated(symbols(f"{q}:4"), [int(j == k) for j in (1, 2, 3)]) for k in (1, 2, 3))
    return {
        f"{name}{j}{k}": str(entry)
        for k, column in enumerate(columns, 1)
        for j, entry in enumerate(column, 1)
    }


def components(name: str, quaternion: Iterable[Expr]) -> dict[str, str]:
    """Return definitions of the components of a quaternion."""
    return {f"{name}{k}": str(component) for k, component in enumerate(quaternion)}


# What q and Omega are at the time s t: everything moves s times as fast.
FASTER = Part(
    witness={"s": "2"},
    definitions={f"W{k}": f"s*Omega{k}" for k in (1, 2, 3)},
    reading={
        "s": "constant: the other names stand for a motion at the time s t",
        **{f"W{k}": f"rate about axis {k} in the time t, rad/s" for k in (1, 2, 3)},
    },
)
TURN = Part(
    witness=dict.fromkeys(("p0", "p1", "p2", "p3"), "1/2"),
    definitions=matrix("R", "p"),
    relations=("p3**2 + p2**2 + p1**2 + p0**2 - 1",),
    reading={f"p{k}": f"component {k} of the turn from start to target" for k in range(4)},
)
MOMENTUM = Part(
    witness={"M1": "2", "M2": "3", "M3": "6", "K": "7"},
    definitions={f"N{k}": total(f"R?{k}*M?") for k in (1, 2, 3)},
    relations=("K**2 - M1**2 - M2**2 - M3**2",),
    nonnegative=("K",),
    reading={
        **{f"M{k}": f"momentum along body axis {k} of the start" for k in (1, 2, 3)},
        **{f"N{k}": f"momentum along body axis {k} of the target" for k in (1, 2, 3)},
        "K": "|M|, kg m^2 rad/s",
    },
)
CONE = Part(
    definitions={f"A{j}{k}": total(f"R{j}?*R{k}?/c?") + f" - 1/c{k}" * (j == k) for j, k in PAIRS},
)
# The attitude q takes N to L; z is what is left of it after the turn, q = z p.
LEFT = Part(
    definitions={
        **matrix("S", "q"),
        **{f"L{k}": total(f"S{k}?*N?") for k in (1, 2, 3)},
        **components("z", product(symbols("q:4"), conjugate(symbols("p:4")))),
        "along": total("z?*M?"),
    },
    reading={
        **{f"q{k}": f"component {k} of the attitude, 1 at the start" for k in range(4)},
        "along": "K sin(x/2), where z is a turn about M by x, and z0 is cos(x/2)",
    },
)
# The planes that E_b = 0 consists of, by the roots of the differences of inverse moments.
PLANES = Part(
    witness={"i_a": "1", "across": "1", "along": "1", "M_a": "1", "M_b": "0", "M_d": "1"},
    units=("i_a", "i_a + across**2", "i_a + across**2 + along**2"),
    definitions={
        "c_a": "1/i_a",
        "c_b": "1/(i_a + across**2)",
        "c_d": "1/(i_a + across**2 + along**2)",
        **{f"Omega_{x}": f"M_{x}/c_{x}" for x in "abd"},
        **DIFFERENCES,
        **{name: BY_RATES[name] for name in ("H", "E_b")},
    },
    nonnegative=("across", "along"),
    reading={
        **AXES.reading,
        "i_a": "1/c_a; a is the axis of the largest moment",
        **{f"M_{x}": f"momentum along axis {x}, kg m^2 rad/s" for x in "abd"},
    },
)
# With p constant, the motion that has the rates W at the attitude x = q p.
BESIDE = Part(
    witness={"c1": "2", "c2": "2", "c3": "1", "p0": "3/5", "p1": "0", "p2": "0", "p3": "4/5"},
    definitions={
        **{f"W{k}": total(f"R?{k}*Omega?") for k in (1, 2, 3)},
        **{f"P{k}": total(f"R?{k}*M?") for k in (1, 2, 3)},
        **components("x", product(symbols("q:4"), symbols("p:4"))),
    },
    reading={f"W{k}": f"rate about axis {k} of the motion beside, rad/s" for k in (1, 2, 3)},
)
# Axes j and k have one moment, or the turn does not mix them: R_jk = R_kj = 0, these being
# 2 (p_j p_k -+ p_0 p_i).
SYMMETRY = Part(
    relations=tuple(f"(c{j} - c{k})*{x}" for i, j, k in CYCLES for x in (f"p{j}*p{k}", f"p0*p{i}")),
)


def derive(builder: LedgerBuilder) -> None:
    """Prove scaling of time, the cone, the bursts, planes, peaks, rings and a bound."""
    _faster(builder)
    _cone(builder)
    _left(builder)
    _planes(builder)
    _peaks(builder)
    _ring(builder)
    _bound(builder)


def _faster(builder: LedgerBuilder) -> None:
    """Prove that q(s t) and s Omega(s t) are a motion, with momentum s M and energy s^2 H."""
    body, attitude = builder.result(Dynamics).body, builder.result(Algebra).attitude
    rates = {name: f"s*({rate})" for name, rate in {**body.rates, **attitude.rates}.items()}
    faster = Part(rates=rates)
    builder.open(join("faster", INERTIA, body, UNIT_QUATERNION, attitude, FASTER, faster))
    builder.claim("faster.kinematics", kinematics("q0 q1 q2 q3", "W1 W2 W3"), ["3"])
    euler = {f"c{i}*D(W{i})": f"(c{j} - c{k})*W{j}*W{k}" for i, j, k in CYCLES}
    builder.claim("faster.euler", euler, ["5"])
    builder.claim(
        "faster.invariants",
        {
            **{f"c{k}*W{k}": f"s*M{k}" for k in (1, 2, 3)},
            total("(c?*W?)**2"): "s**2*K_squared",
            f"({total('c?*W?**2')})/2": "s**2*H",
        },
        ["6", "8", "15"],
    )


def _cone(builder: LedgerBuilder) -> None:
    """Prove that energies at both ends differ by a traceless form, zero on the turn's axis."""
    builder.open(join("manoeuvre", INERTIA, TURN, MOMENTUM, CONE, static=True))
    form = " + ".join(f"A{j}{k}*M{j}*M{k}" for j, k in PAIRS)
    builder.claim("manoeuvre.cone", {f"{total('N?**2/c?')} - ({total('M?**2/c?')})": form}, ["6"])
    builder.claim("manoeuvre.trace", {total("A??"): "0"})
    axis = " + ".join(f"A{j}{k}*p{j}*p{k}" for j, k in PAIRS)
    builder.claim("manoeuvre.axis", {total(f"R{k}?*p?"): f"p{k}" for k in (1, 2, 3)} | {axis: "0"})
    # From rest to rest the bursts are M and -N in the body axes.
    builder.root("manoeuvre.first_burst", "K", "M1**2 + M2**2 + M3**2", ["6"])
    builder.root("manoeuvre.last_burst", "K", "N1**2 + N2**2 + N3**2", ["6"])
    # A R = R J - J R: A = 0 where R does not mix axes of different moments.
    mixed = {total(f"A{j}?*R?{k}"): f"R{j}{k}*(1/c{k} - 1/c{j})" for j, k in ACROSS}
    builder.claim("manoeuvre.symmetry", mixed)


def _left(builder: LedgerBuilder) -> None:
    """Prove that q = z p takes N to M exactly for z a turn about M."""
    builder.open(join("arrival", TURN, MOMENTUM, UNIT_QUATERNION, LEFT, static=True))
    builder.claim("arrival.turn", {total(f"R{k}?*N?"): f"M{k}" for k in (1, 2, 3)})
    builder.claim("arrival.left", components("q", product(symbols("z:4"), symbols("p:4"))))
    cross = " + ".join(f"(z{j}*M{k} - z{k}*M{j})**2" for _, j, k in CYCLES)
    builder.claim("arrival.gap", {total("(L? - M?)**2"): f"4*({cross})"})
    builder.claim("arrival.angle", {f"(K*z0)**2 + along**2 + {cross}": "K**2"})


def _planes(builder: LedgerBuilder) -> None:
    """Prove that K^2 - 2 H c_b vanishes on two planes through axis b."""
    builder.open(join("separatrix_planes", PLANES, static=True))
    builder.root("separatrix_planes.across", "across", "(c_a - c_b)/(c_a*c_b)")
    builder.root("separatrix_planes.along", "along", "(c_b - c_d)/(c_b*c_d)")
    builder.claim(
        "separatrix_planes.E_b",
        {
            "M_a**2 + M_b**2 + M_d**2 - 2*H*c_b": "E_b",
            "E_b": "M_a**2*(c_a - c_b)/c_a - M_d**2*(c_b - c_d)/c_d",
        },
        ["6"],
    )
    product = "c_b*(across*M_a - along*M_d)*(across*M_a + along*M_d)"
    builder.claim("separatrix_planes.planes", {"E_b": product})


def _peaks(builder: LedgerBuilder) -> None:
    """Prove that |Omega|^2 is linear in sn^2, so stationary where sn, cn or dn vanishes."""
    square = "Omega_a**2 + Omega_b**2 + Omega_d**2"
    slope = "(A_b**2 - A_d**2 - m*A_a**2)"
    builder.claim("regular.speed", {square: f"A_a**2 + A_d**2 + {slope}*sn**2"}, ["10"])
    builder.claim("regular.speed_rate", {f"D({square})": f"2*lambda_*{slope}*sn*cn*dn"}, ["10"])


def _ring(builder: LedgerBuilder) -> None:
    """Prove that x = q p and W = R^T Omega are a motion if the turn preserves J.

    A motion from q = 1 that is at p at the time T has the rates W there: it goes on as x and W do,
    so that q(T + t) = q(t) p, and from whatever q(t) it is at, it turns by p in the time T.
    """
    body, attitude = builder.result(Dynamics).body, builder.result(Algebra).attitude
    motion = (INERTIA, TURN, body, UNIT_QUATERNION, attitude)
    builder.open(join("ring", *motion, BESIDE, SYMMETRY))
    builder.claim("ring.symmetry", {f"R{j}{k}*(1/c{k} - 1/c{j})": "0" for j, k in ACROSS})
    builder.claim("ring.kinematics", kinematics("x0 x1 x2 x3", "W1 W2 W3"), ["3"])
    builder.claim("ring.momentum", {f"P{k}": f"c{k}*W{k}" for k in (1, 2, 3)}, ["8"])
    euler = {f"c{i}*D(W{i})": f"P{j}*W{k} - P{k}*W{j}" for i, j, k in CYCLES}
    builder.claim("ring.euler", euler, ["5", "7"])


def _bound(builder: LedgerBuilder) -> None:
    """Prove K^2 <= 2 H c for the largest moment c."""
    forms = {"2*H*c_1 - K_squared": "c_2*c_12*Omega_2**2 + c_3*c_13*Omega_3**2"}
    builder.sign("sorted_body.most_momentum", forms, ["6", "15"])
