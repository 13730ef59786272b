"""SU(2), its Lie algebra, and the unit quaternions: equations (1) to (4).

A matrix of the form (1) is unitary with determinant one; the map F of (2) turns the quaternion
product into the matrix product; the basis (4) has the brackets that make the Lie bracket the cross
product; and under F the kinematics (3) is the familiar q' = (1/2) q (0, Omega).
"""

from rigidsym.proof.algebra import Book, Part, equal, join, names
from rigidsym.proof.algebra.quaternion import product
from rigidsym.proof.algebra.su2 import basis, combination, commutator, from_quaternion

UNIT_QUATERNION = Part(
    witness={"q0": "1", "q1": "0", "q2": "0", "q3": "0"},
    relations=("q3**2 + q2**2 + q1**2 + q0**2 - 1",),
    reading={f"q{k}": f"component {k} of a unit quaternion" for k in range(4)},
)
PAIR = Part(
    witness=dict.fromkeys(
        ["q0", "q1", "q2", "q3", "p0", "p1", "p2", "p3", "Omega1", "Omega2", "Omega3"], "0"
    ),
    reading={
        **{f"{name}{k}": f"component {k} of a quaternion" for name in "qp" for k in range(4)},
        **{f"Omega{k}": f"body rate about axis {k}" for k in (1, 2, 3)},
    },
)


def derive(book: Book) -> None:
    """(1): R is in SU(2).  (2): F is a homomorphism.  (4): brackets.  (3): the kinematics."""
    ring = book.open(join("SU2", UNIT_QUATERNION, static=True))
    R = from_quaternion(names(ring, "q0 q1 q2 q3"))
    identity = from_quaternion([ring.element(k) for k in (1, 0, 0, 0)])
    book.claim("SU2.unitary", equal(R @ R.dagger(), identity), source=["1"])
    determinant = R.determinant()
    book.claim("SU2.special", [(determinant.real, 1), (determinant.imag, 0)], source=["1"])

    ring = book.open(join("quaternions", PAIR, static=True))
    p, q = names(ring, "p0 p1 p2 p3"), names(ring, "q0 q1 q2 q3")
    F = from_quaternion
    book.claim("quaternions.product", equal(F(product(p, q)), F(p) @ F(q)), source=["2"])

    A1, A2, A3 = basis(ring)
    brackets = [
        *equal(commutator(A1, A2), A3),
        *equal(commutator(A2, A3), A1),
        *equal(commutator(A1, A3), A2 * -1),
    ]
    book.claim("quaternions.brackets", brackets, source=["4"])

    rates = names(ring, "Omega1 Omega2 Omega3")
    half_turn = [component / 2 for component in product(q, (ring.element(0), *rates))]
    book.claim("quaternions.kinematics", equal(F(half_turn), F(q) @ combination(rates)), ["3"])
