"""Torques by a direction in space: the kicks of splitting methods.

A vector u that stays in space is v = conj(q) u q in body axes; by Rodrigues' formula with q = (q0,
r) that is u + q0 w + w x r, w = 2 u x r.  A potential of it, linear and quadratic,

    U = v Q v / 2 - m v,    T = v x g,    g = Q v - m,

loses what T gains: of gravity gradient Q is the inertia and u of length sqrt(3 mu/r^3), of a dipole
m in a field u there is m alone.  Beside it are a torque b that stays in the body, and k u in space.
"""

from rigidsym.proof.algebra import LedgerBuilder, Part, join

_NEXT = {1: (2, 3), 2: (3, 1), 3: (1, 2)}
_ROWS = {1: ("Q11", "Q12", "Q13"), 2: ("Q12", "Q22", "Q23"), 3: ("Q13", "Q23", "Q33")}
_GIVEN = (
    *("u1", "u2", "u3", "b1", "b2", "b3", "k", "m1", "m2", "m3"),
    *("Q11", "Q22", "Q33", "Q23", "Q13", "Q12"),
)
SEEN = {
    **{f"w{i}": f"2*(u{j}*q{k} - u{k}*q{j})" for i, (j, k) in _NEXT.items()},
    **{f"v{i}": f"u{i} + q0*w{i} + (w{j}*q{k} - w{k}*q{j})" for i, (j, k) in _NEXT.items()},
}
TORQUE = {
    **{
        f"g{i}": " + ".join(f"{x}*v{j}" for j, x in enumerate(row, 1)) + f" - m{i}"
        for i, row in _ROWS.items()
    },
    **{f"T{i}": f"b{i} + k*v{i} + (v{j}*g{k} - v{k}*g{j})" for i, (j, k) in _NEXT.items()},
}
TURNING = Part(
    witness={
        **{"q0": "1", "q1": "0", "q2": "0", "q3": "0"},
        **dict.fromkeys(("Omega1", "Omega2", "Omega3"), "1"),
        **dict.fromkeys(_GIVEN, "1"),
    },
    relations=("q0**2 + q1**2 + q2**2 + q3**2 - 1",),
    rates={
        "q0": "-(Omega1*q1 + Omega2*q2 + Omega3*q3)/2",
        **{
            f"q{i}": f"(Omega{i}*q0 + q{j}*Omega{k} - q{k}*Omega{j})/2"
            for i, (j, k) in _NEXT.items()
        },
        **dict.fromkeys(("Omega1", "Omega2", "Omega3"), "?"),
    },
    definitions=SEEN
    | TORQUE
    | {
        "U": "(Q11*v1**2 + Q22*v2**2 + Q33*v3**2)/2 + Q23*v2*v3 + Q13*v1*v3 + Q12*v1*v2"
        " - m1*v1 - m2*v2 - m3*v3"
    },
    reading={
        **{f"u{i}": f"component {i} of a vector in space" for i in _NEXT},
        **{f"b{i}": f"component {i} of a torque that stays in the body" for i in _NEXT},
        **{f"m{i}": f"component {i} of what the potential is linear by" for i in _NEXT},
        "k": "how much of the vector is a torque itself",
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove how a fixed direction turns in the body, and that the torque conserves energy."""
    builder.open(join("kick", TURNING))
    back = {f"D(v{i})": f"v{j}*Omega{k} - v{k}*Omega{j}" for i, (j, k) in _NEXT.items()}
    builder.claim("kick.fixed", back, ["3"])
    builder.claim("kick.size", {"v1**2 + v2**2 + v3**2": "u1**2 + u2**2 + u3**2"}, ["3"])
    others = (f"b{i} - k*v{i}" for i in _NEXT)
    work = " + ".join(f"Omega{i}*(T{i} - {rest})" for i, rest in zip(_NEXT, others, strict=True))
    builder.claim("kick.work", {"D(U)": f"-({work})"}, ["3"])
    start = {f"v{i}": f"u{i}" for i in _NEXT}
    builder.begin("kick", ("q0 - 1", "q1", "q2", "q3"), "", start, "3")
