"""From the kinematics to phi1: the unnumbered display of R^-1 R', and equations (30) to (33).

The chapter ends with what the paper leaves to the reader: with phi1' by (32), phi2 and phi3 by
(27) and (28), the angles move so that R = exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) satisfies (3) and
the rates satisfy Euler's equations (5).
"""

from derivations.conjugacy import ANGLES, MOMENTUM, RATES, phase, rotation
from derivations.euler_lax import INERTIA
from rigidsym.proof.algebra import Book, Part, equal, join, names
from rigidsym.proof.algebra.su2 import Complex, Matrix, combination
from rigidsym.proof.kernel import Element, Ring

BODY_RATES = Part(
    witness={"Omega1": "0", "Omega2": "0", "Omega3": "0"},
    rates={f"Omega{k}": "?" for k in (1, 2, 3)},
    reading={f"Omega{k}": f"body rate about axis {k}, rad/s" for k in (1, 2, 3)},
)
# With M on the sphere of radius K, phi1' is regular even where sin(phi2) = 0.
MOTION = Part(
    definitions={
        "Omega1": "K*cos_phi2/c1",
        "Omega2": "K*sin_phi2*sin_phi3/c2",
        "Omega3": "K*sin_phi2*cos_phi3/c3",
        "H": "(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2)/2",
        "phi1_rate": "K*(sin_phi3**2/c2 + cos_phi3**2/c3)",
        "phi2_rate": "Omega2*cos_phi3 - Omega3*sin_phi3",
        "phi3_rate": "Omega1 - phi1_rate*cos_phi2",
    },
)


MOTION_RATES = {key: MOTION.definitions[key] for key in ("Omega1", "Omega2", "Omega3", "H")}
ON_CIRCLES = ("cos_phi2**2 + sin_phi2**2 - 1", "sin_phi3**2 + cos_phi3**2 - 1")


def derive(book: Book) -> None:
    """The display, (30), (31), (32), (33), and that they add up to a motion."""
    ring = book.open(join("turning", RATES, BODY_RATES, *ANGLES))
    R = rotation(ring)
    velocity = R.inverse() @ R.rate()
    book.claim("turning.display", equal(velocity, _display(ring)), ["R^-1 dR/dt"])
    Omega = combination(names(ring, "Omega1 Omega2 Omega3"))
    gap = Omega - velocity
    book.claim(
        "turning.off_diagonal",
        equal((gap.b.real * 2, gap.b.imag * 2), _parts(_equation_30(ring)[0])),
        ["30"],
    )
    book.claim(
        "turning.companion",
        equal((gap.c.real * 2, gap.c.imag * 2), _parts(_equation_30(ring)[1])),
        ["30"],
    )
    _divided(book, ring)
    _phi1_rate(book)
    _poles(book)
    _motion(book)


def _display(ring: Ring) -> Matrix:
    """The right side of the unnumbered display."""
    cosine, sine = names(ring, "cos_phi2 sin_phi2")
    first, second, third = names(ring, "phi1_rate/2 phi2_rate/2 phi3_rate/2")
    zero, one = ring.element(0), ring.element(1)
    nil, i, unit = Complex(zero, zero), Complex(zero, one), phase(ring)
    return (
        Matrix(i * cosine, i * unit.conjugate() * sine, i * unit * sine, -(i * cosine)) * first
        + Matrix(nil, unit.conjugate(), -unit, nil) * second
        + Matrix(i, nil, nil, -i) * third
    )


def _parts(value: Complex) -> tuple[Element, Element]:
    return value.real, value.imag


def _equation_30(ring: Ring) -> tuple[Complex, Complex]:
    """Left minus right side of the two equations (30)."""
    O2, O3, p1, p2, sine = names(ring, "Omega2 Omega3 phi1_rate phi2_rate sin_phi2")
    i, unit = Complex(ring.element(0), ring.element(1)), phase(ring)
    first = Complex(O2, O3) - i * unit.conjugate() * (p1 * sine) - unit.conjugate() * p2
    second = Complex(O2 * -1, O3) - i * unit * (p1 * sine) + unit * p2
    return first, second


def _divided(book: Book, ring: Ring) -> None:
    """(31) is (30) times the phase that makes its right side free of phi3; then their sum."""
    O2, O3, p1, p2, sine = names(ring, "Omega2 Omega3 phi1_rate phi2_rate sin_phi2")
    unit = phase(ring)
    first, second = _equation_30(ring)
    zero = ring.element(0)
    first_31 = Complex(O2, O3) * unit - Complex(p2, p1 * sine)
    second_31 = Complex(O2 * -1, O3) * unit.conjugate() - Complex(p2 * -1, p1 * sine)
    equations = [
        *equal(_parts(first * unit), _parts(first_31)),
        *equal(_parts(second * unit.conjugate()), _parts(second_31)),
    ]
    book.claim("turning.divided", equations, ["31"])
    both = first_31 + second_31
    total = ring.read("Omega2*sin_phi3 + Omega3*cos_phi3 - phi1_rate*sin_phi2")
    book.claim("turning.sum", equal(_parts(both), (zero, total * 2)), ["31", "32"])


def _phi1_rate(book: Book) -> None:
    """(31) summed and (28) give (32), where sin(phi2) is not zero; (6) turns it into (33)."""
    angles = Part(
        witness={
            "sin_phi2": "4/5",
            "cos_phi2": "3/5",
            "cos_phi3": "1",
            "sin_phi3": "0",
            "phi1_rate": "2/5",
        },
        units=("sin_phi2",),
        definitions=MOTION_RATES,
        relations=(
            *ON_CIRCLES,
            "c2*c3*sin_phi2*phi1_rate - K*sin_phi2*(c3*sin_phi3**2 + c2*cos_phi3**2)",
        ),
        reading={"phi1_rate": "d phi1/dt where (31) holds: its sum times c2 c3 is a relation"},
    )
    book.open(join("line32", INERTIA, MOMENTUM, angles, static=True))
    book.claim(
        "line32.sum_of_31", {"phi1_rate*sin_phi2": "Omega2*sin_phi3 + Omega3*cos_phi3"}, ["31"]
    )
    quotient = "K*(c2*Omega2**2 + c3*Omega3**2)/((c2*Omega2)**2 + (c3*Omega3)**2)"
    book.claim("line32.rate", {"phi1_rate": quotient}, ["32"])
    quotient = "K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2)"
    book.claim("line32.by_invariants", {"phi1_rate": quotient}, ["33"])


def _poles(book: Book) -> None:
    """Where sin(phi2) or cos(phi3) vanish, so do the denominators of (29), (32) and (33)."""
    on_axis = Part(
        witness={"sin_phi2": "0", "cos_phi2": "1", "cos_phi3": "1", "sin_phi3": "0"},
        definitions=MOTION_RATES,
        relations=("sin_phi2",),
    )
    book.open(join("on_axis", INERTIA, MOMENTUM, on_axis, Part(relations=ON_CIRCLES), static=True))
    book.claim(
        "on_axis.denominators",
        {
            "c3*Omega3": "0",
            "(c2*Omega2)**2 + (c3*Omega3)**2": "0",
            "K**2 - (c1*Omega1)**2": "0",
        },
        ["29", "32", "33"],
    )
    across = Part(
        witness={"cos_phi2": "0", "sin_phi2": "1", "cos_phi3": "0", "sin_phi3": "1"},
        definitions=MOTION_RATES,
        relations=("cos_phi3",),
    )
    book.open(join("across", INERTIA, MOMENTUM, across, Part(relations=ON_CIRCLES), static=True))
    book.claim("across.denominator", {"c3*Omega3": "0"}, ["29"])


def _motion(book: Book) -> None:
    """The angles that move by (32) and (30) carry a solution of (3) and (5)."""
    ring = book.open(join("three_angle_motion", INERTIA, MOMENTUM, *ANGLES, MOTION))
    R, Omega = rotation(ring), combination(names(ring, "Omega1 Omega2 Omega3"))
    book.claim("three_angle_motion.kinematics", equal(R.rate(), R @ Omega), ["3", "25"])
    book.claim(
        "three_angle_motion.euler",
        {
            "c1*D(Omega1)": "(c2 - c3)*Omega2*Omega3",
            "c2*D(Omega2)": "(c3 - c1)*Omega3*Omega1",
            "c3*D(Omega3)": "(c1 - c2)*Omega1*Omega2",
        },
        ["5"],
    )
