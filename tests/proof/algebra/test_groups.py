"""Group laws of unit quaternions and of SU(2) as polynomial identities."""

import pytest
import sympy
from sympy import ImmutableMatrix, sqrt

from derivations.conjugacy import exponential
from derivations.lie_algebra import from_quaternion
from derivations.setting import Setting
from rigidsym.proof.algebra._quaternion import conjugate, kinematics, product, rotated
from rigidsym.proof.kernel import Context, Ledger
from rigidsym.proof.steps._names import symbols

# q' of (3) as in textbooks, row by row.
TEXTBOOK = {
    "D(q0)": "(-Omega1*q1 - Omega2*q2 - Omega3*q3)/2",
    "D(q1)": "(Omega1*q0 + Omega3*q2 - Omega2*q3)/2",
    "D(q2)": "(Omega2*q0 - Omega3*q1 + Omega1*q3)/2",
    "D(q3)": "(Omega3*q0 + Omega2*q1 - Omega1*q2)/2",
}
PQR = tuple(symbols(" ".join(f"{name}{k}" for k in range(4))) for name in "pqr")
BASIS = Setting().basis()


def matrix(q):
    """Return the chapter's matrix F of a quaternion."""
    return from_quaternion("p").subs(dict(zip(PQR[0], q, strict=True)), simultaneous=True)


def combination(x):
    return sum((a * v for a, v in zip(BASIS, x, strict=True)), sympy.zeros(2))


def holds(lhs, rhs):
    return all(sympy.expand(x - y) == 0 for x, y in zip(lhs, rhs, strict=True))


QUATERNIONS = (lambda q: q, product, conjugate)
MATRICES = (matrix, lambda x, y: x * y, lambda x: x.H)
both = pytest.mark.parametrize("group", [QUATERNIONS, MATRICES], ids=["quaternions", "SU(2)"])


@both
def test_product_is_associative_but_not_commutative(group):
    embed, times, _ = group
    p, q, r = map(embed, PQR)
    assert holds(times(times(p, q), r), times(p, times(q, r)))
    assert not holds(times(p, q), times(q, p))


@both
def test_inverse_is_two_sided_up_to_the_squared_norm(group):
    embed, times, inverse = group
    p, norm = embed(PQR[0]), sum(x * x for x in PQR[0])
    scaled = embed([norm, 0, 0, 0])
    assert holds(times(p, inverse(p)), scaled)
    assert holds(times(inverse(p), p), scaled)


@both
def test_inverse_reverses_products(group):
    embed, times, inverse = group
    p, q, _ = map(embed, PQR)
    assert holds(inverse(times(p, q)), times(inverse(q), inverse(p)))
    assert not holds(inverse(times(p, q)), times(inverse(p), inverse(q)))


@both
def test_one_is_neutral(group):
    embed, times, _ = group
    one, p = embed([1, 0, 0, 0]), embed(PQR[0])
    assert holds(times(one, p), p)
    assert holds(times(p, one), p)


def test_norm_is_multiplicative():
    p, q, _ = PQR
    norms = [sum(x * x for x in a) for a in (p, q, product(p, q))]
    assert holds([norms[0] * norms[1]], [norms[2]])


def test_F_is_a_homomorphism_and_no_antihomomorphism():
    p, q, _ = PQR
    assert holds(matrix(product(p, q)), matrix(p) * matrix(q))
    assert not holds(matrix(product(p, q)), matrix(q) * matrix(p))


def test_F_takes_conjugate_to_dagger_and_norm_to_determinant():
    p = PQR[0]
    assert holds(matrix(conjugate(p)), matrix(p).H)
    assert holds([matrix(p).det()], [sum(x * x for x in p)])


def test_the_lie_bracket_is_the_cross_product():
    x, y = (PQR[k][1:] for k in (0, 1))
    cross = ImmutableMatrix(x).cross(ImmutableMatrix(y))
    X, Y = combination(x), combination(y)
    assert holds(X * Y - Y * X, combination(cross))


def test_the_basis_is_half_the_imaginary_quaternions():
    for k, found in enumerate(BASIS, 1):
        assert holds(found, matrix([sympy.Rational(int(j == k), 2) for j in range(4)]))


@pytest.mark.parametrize("axis", [1, 2, 3])
def test_exponential_turns_about_its_axis_and_adds_angles(axis):
    a, b = symbols("a b")
    one, other, both_turns = (exponential(Setting(), axis, x) for x in (a, b, a + b))
    gap = (one * other - both_turns).applyfunc(lambda x: sympy.expand_trig(x).expand())
    assert gap.is_zero_matrix
    fixed = BASIS[axis - 1]
    assert holds(one * fixed, fixed * one)


def test_kinematics_are_those_of_textbooks_and_texts_that_the_kernel_reads():
    found = kinematics("q0 q1 q2 q3", "Omega1 Omega2 Omega3")
    names = ("q0", "q1", "q2", "q3", "Omega1", "Omega2", "Omega3")
    ring = Ledger().open(Context("textbook", names, dict.fromkeys(names, "0")))
    assert found.keys() == TEXTBOOK.keys()
    for rate, side in found.items():
        assert not (ring.read(str(side)) - ring.read(TEXTBOOK[rate])).numerator


def test_axes_of_the_other_handedness_turn_the_other_way():
    """Reversing an axis changes the sign of i and of its coefficient, but not the product."""
    p, q, _ = PQR
    mirrored = [[x[0], x[1] * -1, x[2], x[3]] for x in (p, q)]
    whole, left = product(*mirrored), product(p, q, -1)
    assert holds((whole[0], whole[1] * -1, *whole[2:]), left)


def test_a_quarter_turn_about_the_third_axis_takes_the_first_to_the_second():
    half = sqrt(2) / 2
    assert rotated((half, 0, 0, half), (1, 0, 0)) == [0, 1, 0]
    assert rotated((half, 0, 0, half), (1, 0, 0), -1) == [0, -1, 0]
