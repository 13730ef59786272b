"""Sensitivities of the attitude, column by column: the small turn in space, for numbers.

delta R = [eta] R, and with L = R M, l = L/K^2, dM the change of I omega in the body and s the share
of eta along L, times K,

    eta = l x (dL - R dM) + s l,    s = t dH - (dc_1 I_1 + dc_2 I_2 + dc_3 I_3)/2

dL = R dM at t = 0.  So eta' = R d omega, which is the variation of (3) seen in space.  A column is
this for one rate at t = 0 or one moment of inertia; `excess` is I_k less what it is without motion.
"""

from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._quaternion import kinematics

AXES = (1, 2, 3)
CHANGES = tuple(f"{x}{k}" for x in ("Omega", "c") for k in AXES)


def matrix(name: str, q: str) -> dict[str, str]:
    """Return the entries of the rotation matrix of a unit quaternion."""
    entries = {}
    for i in AXES:
        j, k = i % 3 + 1, (i + 1) % 3 + 1
        entries[f"{name}{i}{i}"] = f"1 - 2*({q}{j}**2 + {q}{k}**2)"
        entries[f"{name}{i}{j}"] = f"2*({q}{i}*{q}{j} - {q}0*{q}{k})"
        entries[f"{name}{j}{i}"] = f"2*({q}{i}*{q}{j} + {q}0*{q}{k})"
    return dict(sorted(entries.items()))


def _across(name: str, of: str, momentum: dict[int, str]) -> dict[str, str]:
    """Return l x a column of a matrix, for each column, as the matrix times l x e_k in the body.

    Near a spin about axis k, l x e_k is small in both components.
    """
    return {
        f"{name}{i}{k}": f"{of}{i}{j}*{momentum[h]} - {of}{i}{h}*{momentum[j]}"
        for k, j, h in ((1, 2, 3), (2, 3, 1), (3, 1, 2))
        for i in AXES
    }


START = {
    "K_squared": "(c1*Omega1_0)**2 + (c2*Omega2_0)**2 + (c3*Omega3_0)**2",
    "per_K2": "1/K_squared",
    **matrix("P", "p"),
    **{f"n{k}_0": f"c{k}*Omega{k}_0*per_K2" for k in AXES},
    **{f"l{i}": f"P{i}1*n1_0 + P{i}2*n2_0 + P{i}3*n3_0" for i in AXES},
    **_across("B", "P", {k: f"n{k}_0" for k in AXES}),
}
MOVING = {
    **matrix("R", "q"),
    **{f"n{k}": f"c{k}*Omega{k}*per_K2" for k in AXES},
    **_across("X", "R", {k: f"n{k}" for k in AXES}),
    **{f"Y{i}{k}": f"c{k}*X{i}{k}" for i in AXES for k in AXES},
}


def _columns() -> dict[str, str]:
    columns = {}
    for y in CHANGES:
        k = y[-1]
        for i in AXES:
            seen = " + ".join(f"Y{i}{j}*Omega{j}_by_{y}" for j in AXES)
            columns[f"eta{i}_by_{y}"] = (
                f"c{k}*B{i}{k} - ({seen}) + t*(c{k}*Omega{k}_0)*l{i}"
                if y.startswith("Omega")
                else f"Omega{k}_0*B{i}{k} - ({seen} + Omega{k}*X{i}{k}) - excess{k}*l{i}/2"
            )
    return columns


COLUMNS = _columns()
BODY = Part(
    witness={"c1": "3", "c2": "2", "c3": "1"},
    units=("c1", "c2", "c3"),
    reading={f"c{k}": f"moment of inertia {k}, kg m^2" for k in AXES},
)
RATES_AT_START = Part(
    witness={"Omega1_0": "1", "Omega2_0": "0", "Omega3_0": "0"},
    reading={f"Omega{k}_0": f"Omega{k} at t = 0" for k in AXES},
)


def _euler(k: int) -> tuple[str, str, str]:
    """Return the coefficient of Omega_k' in Euler's equations, and the other two rates."""
    i, j = k % 3 + 1, (k + 1) % 3 + 1
    return f"(c{i} - c{j})/c{k}", f"Omega{i}", f"Omega{j}"


RATES = Part(
    witness={f"Omega{k}": str(int(k == 1)) for k in AXES},
    rates={f"Omega{k}": "*".join(_euler(k)) for k in AXES},
    reading={f"Omega{k}": f"body rate about axis {k}, rad/s" for k in AXES},
)
# Differences of moments by names of their own: numbers have them from before rounding.
DIFFERENCES = {"c12": "c1 - c2", "c13": "c1 - c3", "c23": "c2 - c3"}
MOVED = {
    "Omega1_by_t": "c23/c1*Omega2*Omega3",
    "Omega2_by_t": "-c13/c2*Omega3*Omega1",
    "Omega3_by_t": "c12/c3*Omega1*Omega2",
}
BY_TIME = {
    **DIFFERENCES,
    **{f"eta{i}_by_t": f"R{i}1*Omega1 + R{i}2*Omega2 + R{i}3*Omega3" for i in AXES},
    **MOVED,
}


def _energy(y: str) -> str:
    """Return what vanishes when a column has the right change of the energy."""
    k = y[-1]
    seen = " + ".join(f"c{j}*Omega{j}*Omega{j}_by_{y}" for j in AXES)
    begun = f"c{k}*Omega{k}_0" if y.startswith("Omega") else f"(Omega{k}_0**2 - Omega{k}**2)/2"
    return f"{seen} - {begun}"


def _varied(k: int, y: str) -> str:
    """Return the variation of Euler's equations for a column."""
    _, one, other = _euler(k)
    i, j = one[-1], other[-1]
    products = f"{one}_by_{y}*{other} + {one}*{other}_by_{y}"
    moved = {
        f"c{k}": f" - (c{i} - c{j})/c{k}**2*{one}*{other}",
        f"c{i}": f" + {one}*{other}/c{k}",
        f"c{j}": f" - {one}*{other}/c{k}",
    }.get(y, "")
    return f"(c{i} - c{j})/c{k}*({products}){moved}"


def _witness(y: str) -> dict[str, str]:
    """Return the column at t = 0 of the spin about axis 1."""
    return {f"Omega{k}_by_{y}": str(int(y == f"Omega{k}")) for k in AXES}


VARIED = Part(
    witness={name: x for y in CHANGES for name, x in _witness(y).items()},
    rates={f"Omega{k}_by_{y}": _varied(k, y) for y in CHANGES for k in AXES},
    relations=tuple(map(_energy, CHANGES)),
    reading={
        f"Omega{k}_by_{y}": f"what Omega{k} changes by with {y}" for y in CHANGES for k in AXES
    },
)
EXCESS = Part(
    witness={"t": "0", **{f"excess{k}": "0" for k in AXES}},
    rates={"t": "1", **{f"excess{k}": f"Omega{k}**2 - Omega{k}_0**2" for k in AXES}},
    reading={
        "t": "time, s",
        **{f"excess{k}": f"the integral of Omega{k}^2 - Omega{k}_0^2 from 0 to t" for k in AXES},
    },
)
AT_TIME = {**MOVING, **COLUMNS, **BY_TIME}
# The momentum over its square, seen in space: constant, as at t = 0.
DIRECTION = {
    "K_squared": "(c1*Omega1)**2 + (c2*Omega2)**2 + (c3*Omega3)**2",
    "per_K2": "1/K_squared",
    **{
        f"l{i}": f"(R{i}1*(c1*Omega1) + R{i}2*(c2*Omega2) + R{i}3*(c3*Omega3))*per_K2" for i in AXES
    },
}
ARMS = Part(
    witness={f"B{i}{k}": "0" for i in AXES for k in AXES},
    reading={f"B{i}{k}": f"component {i} of l x R e_{k} at t = 0" for i in AXES for k in AXES},
)
TURNING = kinematics("q0 q1 q2 q3", "Omega1 Omega2 Omega3")
ATTITUDE = Part(
    witness={f"q{k}": str(int(k == 0)) for k in range(4)},
    rates={name[2:-1]: str(text) for name, text in TURNING.items()},
    relations=("q3**2 + q2**2 + q1**2 + q0**2 - 1",),
    reading={f"q{k}": f"component {k} of the attitude" for k in range(4)},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that the columns, that of the time too, satisfy the variation of (3) and start at 0."""
    defined = {**matrix("R", "q"), **DIRECTION, **AT_TIME}
    parts = (BODY, RATES_AT_START, RATES, EXCESS, ARMS, VARIED, ATTITUDE)
    units = Part(definitions=defined, units=("K_squared",))
    builder.open(join("turned_columns", *parts, units))
    builder.claim("turned_columns.momentum", {f"D(l{i})": "0" for i in AXES}, ["6"])
    for y in CHANGES:
        builder.claim(f"turned_columns.by_{y}", _turning(y), ["3"])
    builder.claim("turned_columns.by_t", _by_time(), ["3", "5"])
    _start(builder)


def _turning(y: str) -> dict[str, str]:
    """Prove that eta' is the change of the rates, seen in space."""
    return {f"D(eta{i}_by_{y})": " + ".join(f"R{i}{k}*Omega{k}_by_{y}" for k in AXES) for i in AXES}


def _by_time() -> dict[str, str]:
    """Prove R' = [eta_t] R, and Euler's equations for the rates."""
    turned = {
        f"D(R{i}{k})": f"eta{i % 3 + 1}_by_t*R{(i + 1) % 3 + 1}{k}"
        f" - eta{(i + 1) % 3 + 1}_by_t*R{i % 3 + 1}{k}"
        for i in AXES
        for k in AXES
    }
    return turned | {f"D(Omega{k})": f"Omega{k}_by_t" for k in AXES}


def _start(builder: LedgerBuilder) -> None:
    """Prove that all columns of the attitude are zero at t = 0."""
    still = [Part(x.witness, x.units, reading=x.reading) for x in (BODY, RATES_AT_START, EXCESS)]
    attitude = Part(
        witness={f"p{k}": str(int(k == 0)) for k in range(4)},
        relations=("p3**2 + p2**2 + p1**2 + p0**2 - 1",),
        reading={f"p{k}": f"component {k} of the attitude at t = 0" for k in range(4)},
    )
    begun = Part(
        definitions={
            **START,
            **{f"q{k}": f"p{k}" for k in range(4)},
            **{f"Omega{k}": f"Omega{k}_0" for k in AXES},
            **{f"Omega{k}_by_{y}": str(int(y == f"Omega{k}")) for y in CHANGES for k in AXES},
            **AT_TIME,
        },
        units=("K_squared",),
        relations=tuple(EXCESS.witness),
    )
    builder.open(join("turned_columns_start", *still, attitude, begun, static=True))
    zero = {f"eta{i}_by_{y}": "0" for y in CHANGES for i in AXES}
    builder.claim("turned_columns_start.turn", zero, ["37"])
