"""Euler's equations, the Hamiltonian and the Lax pair: equations (5) to (9) and (22).

In the basis (4) the matrix equation M' = [M, Omega] is Euler's equations, so the spectrum of M,
that is K, cannot change; H is conserved as well, and its gradient in the momenta is Omega.  With
the kinematics (3) the matrix R M R^-1 is constant.  It equals M(0), as (9) and (22) say, because
motions start at R(0) = e: for another start it is R(0) M(0) R(0)^-1, as the counterexample shows.
"""

from derivations.lie_algebra import UNIT_QUATERNION
from rigidsym.proof.algebra import Book, Part, equal, join, names, text
from rigidsym.proof.algebra.quaternion import product
from rigidsym.proof.algebra.su2 import combination, commutator, from_quaternion

INERTIA = Part(
    witness={"c1": "1", "c2": "2", "c3": "5/2"},
    units=("c1", "c2", "c3"),
    reading={f"c{k}": f"principal moment of inertia {k}, kg m^2" for k in (1, 2, 3)},
)
BODY = Part(
    witness={"Omega1": "1", "Omega2": "2", "Omega3": "3"},
    definitions={
        "delta1": "(c2 - c3)/c1",
        "delta2": "(c3 - c1)/c2",
        "delta3": "(c1 - c2)/c3",
        "M1": "c1*Omega1",
        "M2": "c2*Omega2",
        "M3": "c3*Omega3",
        "H": "(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2)/2",
        "K_squared": "c1**2*Omega1**2 + c2**2*Omega2**2 + c3**2*Omega3**2",
    },
    rates={
        "Omega1": "delta1*Omega2*Omega3",
        "Omega2": "delta2*Omega1*Omega3",
        "Omega3": "delta3*Omega1*Omega2",
    },
    reading={f"Omega{k}": f"body rate about axis {k}, rad/s" for k in (1, 2, 3)},
)
ATTITUDE = Part(
    rates={
        "q0": "(-q1*Omega1 - q2*Omega2 - q3*Omega3)/2",
        "q1": "(q0*Omega1 + q2*Omega3 - q3*Omega2)/2",
        "q2": "(q0*Omega2 + q3*Omega1 - q1*Omega3)/2",
        "q3": "(q0*Omega3 + q1*Omega2 - q2*Omega1)/2",
    },
)


def derive(book: Book) -> None:
    """(5) to (9) and (22), in the paper's order."""
    body = book.open(join("body", INERTIA, BODY))
    M = combination(names(body, "M1 M2 M3"))
    Omega = combination(names(body, "Omega1 Omega2 Omega3"))
    book.claim(
        "body.euler",
        equal(
            combination(
                names(
                    body, "c1*delta1*Omega2*Omega3 c2*delta2*Omega1*Omega3 c3*delta3*Omega1*Omega2"
                )
            ),
            commutator(M, Omega),
        ),
        ["5", "7"],
    )
    book.claim("body.conserved", {"D(H)": "0", "D(K_squared)": "0"}, ["6", "15"])
    book.claim("body.lax", equal(M.rate(), commutator(M, Omega)), ["7"])
    square = M @ M
    trace = square.a + square.d
    book.claim("body.spectrum", [(trace.real, "-K_squared/2"), (trace.imag, 0)], ["7"])
    _gradient(book)
    _conjugation(book)


def _gradient(book: Book) -> None:
    """(8): dH/dM_i = Omega_i, with d/dt read as the derivative along one momentum."""
    momenta = Part(
        witness={"M1": "1", "M2": "1", "M3": "1"},
        definitions={"H": "(M1**2/c1 + M2**2/c2 + M3**2/c3)/2"},
        reading={f"M{k}": f"body momentum along axis {k}" for k in (1, 2, 3)},
    )
    for k in (1, 2, 3):
        context = f"gradient{k}"
        book.open(join(context, INERTIA, momenta, Part(rates={f"M{k}": "1"})))
        book.claim(f"{context}.rate", {"D(H)": f"M{k}/c{k}"}, ["7", "8"])


def _conjugation(book: Book) -> None:
    """(9), (22): R M R^-1 is constant; at R = e it is M, elsewhere it need not be."""
    moving = book.open(join("moving_body", INERTIA, BODY, UNIT_QUATERNION, ATTITUDE))
    q, rates = names(moving, "q0 q1 q2 q3"), names(moving, "Omega1 Omega2 Omega3")
    R, M = from_quaternion(q), combination(names(moving, "M1 M2 M3"))
    kinematics = [x / 2 for x in product(q, (moving.element(0), *rates))]
    book.claim("moving_body.kinematics", equal(R.rate(), R @ combination(rates)), ["3"])
    book.claim("moving_body.quaternion", equal(map(moving.rate, q), kinematics), ["3"])
    conjugated = R @ M @ R.inverse()
    constant = [(f"D({text(entry)})", 0) for entry in conjugated]
    book.claim("moving_body.momentum_is_constant", constant, ["9", "22"])
    quarter_turn = {"q0": "3/5", "q2": "4/5"}
    book.refute("moving_body.any_start", equal(conjugated, M), quarter_turn, ["9", "22"])

    start = Part(relations=("q0 - 1", "q1", "q2", "q3"))
    at_rest = Part(witness={f"q{k}": str(int(k == 0)) for k in range(4)})
    ring = book.open(join("identity_start", INERTIA, at_rest, BODY, start, static=True))
    R = from_quaternion(names(ring, "q0 q1 q2 q3"))
    M = combination(names(ring, "M1 M2 M3"))
    book.claim("identity_start.momentum", equal(R @ M @ R.inverse(), M), ["9", "22"])
