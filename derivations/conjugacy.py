"""Reducing the momentum to K A1: equations (22) to (29).

With R = exp(phi1 A1) exp(phi2 A2) exp(phi3 A1), the matrix K R^-1 A1 R does not see phi1; compared
with M of (8) it gives the angles phi2 and phi3.
"""

from derivations.euler_lax import INERTIA
from rigidsym.proof.algebra import Book, Part, equal, half_angle, join, names
from rigidsym.proof.algebra.su2 import (
    Complex,
    Matrix,
    basis,
    combination,
    commutator,
    exponential,
    from_quaternion,
)
from rigidsym.proof.kernel import Element, Ring

MOMENTUM = Part(witness={"K": "1"}, units=("K",), reading={"K": "|M|, kg m^2 rad/s"})
ANGLES = (
    half_angle("phi1", "phi1_rate"),
    half_angle("phi2", "phi2_rate"),
    half_angle("phi3", "phi3_rate"),
)
RATES = Part(
    witness={f"phi{k}_rate": "1" for k in (1, 2, 3)},
    rates={f"phi{k}_rate": "?" for k in (1, 2, 3)},
    reading={f"phi{k}_rate": f"d phi{k}/dt, rad/s" for k in (1, 2, 3)},
)


def rotation(ring: Ring) -> Matrix:
    """(25): exp(phi1 A1) exp(phi2 A2) exp(phi3 A1)"""
    half = [names(ring, f"cos_half_phi{k} sin_half_phi{k}") for k in (1, 2, 3)]
    first, second, third = (exponential(a, *h) for a, h in zip((1, 2, 1), half, strict=True))
    return first @ second @ third


def phase(ring: Ring) -> Complex:
    """e^(i phi3)"""
    return Complex(*names(ring, "cos_phi3 sin_phi3"))


def reduced_momentum(ring: Ring) -> Matrix:
    """The right side of (26)."""
    K, cosine, sine = names(ring, "K cos_phi2 sin_phi2")
    i = Complex(ring.element(0), ring.element(1))
    diagonal = i * (K * cosine / 2)
    off = K * sine / 2
    turn = phase(ring)
    return Matrix(diagonal, i * turn.conjugate() * off, i * turn * off, -diagonal)


def derive(book: Book) -> None:
    """(22); (25), (26) for free angles; (23), (24), (27) to (29) with the momentum put in."""
    _start(book)
    ring = book.open(join("three_angles", MOMENTUM, RATES, *ANGLES))
    A1, K = basis(ring)[0], ring.read("K")
    R = rotation(ring)
    turn = exponential(1, *names(ring, "cos_half_phi1 sin_half_phi1"))
    book.claim(
        "three_angles.exponential", equal(turn.rate(), (A1 @ turn) * ring.read("phi1_rate")), ["25"]
    )
    book.claim("three_angles.stabiliser", equal(turn @ A1 @ turn.inverse(), A1), ["25"])
    book.claim(
        "three_angles.momentum", equal((R.inverse() @ A1 @ R) * K, reduced_momentum(ring)), ["26"]
    )

    body = Part(
        definitions={
            "Omega1": "K*cos_phi2/c1",
            "Omega2": "K*sin_phi2*sin_phi3/c2",
            "Omega3": "K*sin_phi2*cos_phi3/c3",
            "M1": "c1*Omega1",
            "M2": "c2*Omega2",
            "M3": "c3*Omega3",
        },
    )
    ring = book.open(join("reduced", INERTIA, MOMENTUM, *ANGLES, body, static=True))
    A1, K = basis(ring)[0], ring.read("K")
    R, M = rotation(ring), combination(names(ring, "M1 M2 M3"))
    book.claim("reduced.conjugate", equal(R @ M @ R.inverse(), A1 * K), ["23"])
    book.claim("reduced.momentum", equal(M, (R.inverse() @ A1 @ R) * K), ["24"])
    book.claim("reduced.form", equal(M, reduced_momentum(ring)), ["26"])
    book.claim("reduced.phi2", {"c1*Omega1": "K*cos_phi2"}, ["27"])
    book.claim("reduced.phi3", _off_diagonal(ring), ["28"])
    _converse(book)
    _tangent(book, body)


def _start(book: Book) -> None:
    """R M R^-1 = M, at t = 0 the claim of (9) and (22), says that R M = M R: no more, no less."""
    ring = book.ledger.rings["moving_body"]
    R, M = from_quaternion(names(ring, "q0 q1 q2 q3")), combination(names(ring, "M1 M2 M3"))
    gap = R @ M @ R.inverse() - M
    book.claim("moving_body.start", equal(gap @ R, commutator(R, M)), ["9", "22"])


def _off_diagonal(ring: Ring) -> list[tuple[Element, Element]]:
    """(28): c2 Omega2 + i c3 Omega3 = i K e^(-i phi3) sin phi2, and its companion."""
    M2, M3, radius = names(ring, "M2 M3 K*sin_phi2")
    up = Complex(ring.element(0), radius) * phase(ring)
    down = Complex(ring.element(0), radius) * phase(ring).conjugate()
    return [(M2, down.real), (M3, down.imag), (M2 * -1, up.real), (M3, up.imag)]


def _converse(book: Book) -> None:
    """(26) minus (8), entry by entry, is (27) and (28): nothing is lost in the comparison."""
    free = Part(witness={"M1": "0", "M2": "0", "M3": "0"})
    ring = book.open(join("compared", MOMENTUM, free, *ANGLES, static=True))
    M = combination(names(ring, "M1 M2 M3"))
    gap = M - reduced_momentum(ring)
    M1, M2, M3, K, cosine, sine = names(ring, "M1 M2 M3 K cos_phi2 K*sin_phi2")
    down = Complex(ring.element(0), sine) * phase(ring).conjugate()
    book.claim(
        "compared.entries",
        [
            (gap.a.real, 0),
            (gap.a.imag * 2, M1 - K * cosine),
            (gap.b.real * 2, M2 - down.real),
            (gap.b.imag * 2, M3 - down.imag),
        ],
        ["27", "28"],
    )


def _tangent(book: Book, body: Part) -> None:
    """(29) where the division is allowed: K sin(phi2) cos(phi3) = c3 Omega3 is not zero."""
    angles = Part(
        witness={"sin_phi2": "1", "cos_phi2": "0", "cos_phi3": "4/5", "sin_phi3": "3/5"},
        units=("sin_phi2", "cos_phi3"),
        relations=("cos_phi2**2 + sin_phi2**2 - 1", "sin_phi3**2 + cos_phi3**2 - 1"),
    )
    book.open(join("tangent", INERTIA, MOMENTUM, angles, body, static=True))
    book.claim("tangent.phi3", {"sin_phi3/cos_phi3": "c2*Omega2/(c3*Omega3)"}, ["29"])
