"""The same laws for unit quaternions and for SU(2), as identities over a free ring."""

import pytest
from sympy import sqrt

from rigidsym.proof.algebra import equal, names
from rigidsym.proof.algebra.quaternion import conjugate, kinematics, product, rotated
from rigidsym.proof.algebra.su2 import (
    Complex,
    basis,
    combination,
    commutator,
    exponential,
    from_quaternion,
)
from rigidsym.proof.kernel import Context, Ledger

# q' of (3) as in textbooks, row by row.
TEXTBOOK = {
    "D(q0)": "(-Omega1*q1 - Omega2*q2 - Omega3*q3)/2",
    "D(q1)": "(Omega1*q0 + Omega3*q2 - Omega2*q3)/2",
    "D(q2)": "(Omega2*q0 - Omega3*q1 + Omega1*q3)/2",
    "D(q3)": "(Omega3*q0 + Omega2*q1 - Omega1*q2)/2",
}
GENERATORS = tuple(f"{name}{k}" for name in "pqr" for k in range(4))


@pytest.fixture(scope="module")
def ring():
    witness = dict.fromkeys(GENERATORS, "0")
    return Ledger().open(Context("free", GENERATORS, witness))


@pytest.fixture(scope="module")
def pqr(ring):
    return [names(ring, f"{name}0 {name}1 {name}2 {name}3") for name in "pqr"]


def holds(lhs, rhs):
    return not any((x - y).numerator for x, y in equal(lhs, rhs))


QUATERNIONS = (lambda q: q, product, conjugate)
MATRICES = (from_quaternion, lambda x, y: x @ y, lambda x: x.inverse())
both = pytest.mark.parametrize("group", [QUATERNIONS, MATRICES], ids=["quaternions", "SU(2)"])


@both
def test_product_is_associative_but_not_commutative(group, pqr):
    embed, times, _ = group
    p, q, r = map(embed, pqr)
    assert holds(times(times(p, q), r), times(p, times(q, r)))
    assert not holds(times(p, q), times(q, p))


@both
def test_inverse_is_two_sided_up_to_the_squared_norm(group, pqr):
    embed, times, inverse = group
    p = embed(pqr[0])
    norm = sum(x * x for x in pqr[0])
    scaled = embed([norm, norm * 0, norm * 0, norm * 0])
    assert holds(times(p, inverse(p)), scaled)
    assert holds(times(inverse(p), p), scaled)


@both
def test_inverse_reverses_products(group, pqr):
    embed, times, inverse = group
    p, q, _ = map(embed, pqr)
    assert holds(inverse(times(p, q)), times(inverse(q), inverse(p)))
    assert not holds(inverse(times(p, q)), times(inverse(p), inverse(q)))


@both
def test_one_is_neutral(group, ring, pqr):
    embed, times, _ = group
    one = embed([ring.element(k) for k in (1, 0, 0, 0)])
    p = embed(pqr[0])
    assert holds(times(one, p), p)
    assert holds(times(p, one), p)


def test_norm_is_multiplicative(pqr):
    p, q, _ = pqr
    norms = [sum(x * x for x in a) for a in (p, q, product(p, q))]
    assert holds([norms[0] * norms[1]], [norms[2]])


def test_F_is_a_homomorphism_and_no_antihomomorphism(pqr):
    p, q, _ = pqr
    assert holds(from_quaternion(product(p, q)), from_quaternion(p) @ from_quaternion(q))
    assert not holds(from_quaternion(product(p, q)), from_quaternion(q) @ from_quaternion(p))


def test_F_takes_conjugate_to_dagger_and_norm_to_determinant(pqr):
    p = pqr[0]
    determinant = from_quaternion(p).determinant()
    assert holds(from_quaternion(conjugate(p)), from_quaternion(p).dagger())
    assert holds([determinant.real, determinant.imag], [sum(x * x for x in p), p[0] * 0])


def test_the_lie_bracket_is_the_cross_product(pqr):
    _, *x = pqr[0]
    _, *y = pqr[1]
    pairs = ((1, 2), (2, 0), (0, 1))
    cross = [x[j] * y[k] - x[k] * y[j] for j, k in pairs]
    assert holds(commutator(combination(x), combination(y)), combination(cross))


def test_the_basis_is_half_the_imaginary_quaternions(ring):
    halves = [[ring.element(j == k) / 2 for j in range(4)] for k in (1, 2, 3)]
    for matrix, half in zip(basis(ring), halves, strict=True):
        assert holds(matrix, from_quaternion(half))


@pytest.mark.parametrize("axis", [1, 2, 3])
def test_exponential_turns_about_its_axis_and_adds_angles(ring, pqr, axis):
    (c, s, *_), (C, S, *_), _ = pqr
    one, other = exponential(axis, c, s), exponential(axis, C, S)
    assert holds(one @ other, exponential(axis, c * C - s * S, s * C + c * S))
    fixed = basis(ring)[axis - 1]
    assert holds(one @ fixed, fixed @ one)


def test_complex_numbers_have_i_squared_minus_one(ring, pqr):
    zero, one = ring.element(0), ring.element(1)
    square = Complex(zero, one) * Complex(zero, one)
    assert holds([square.real, square.imag], [ring.element(-1), zero])
    a, b = Complex(*pqr[0][:2]), Complex(*pqr[1][:2])
    left, right = (a * b).conjugate(), a.conjugate() * b.conjugate()
    assert holds([left.real, left.imag], [right.real, right.imag])


def test_matrix_rate_obeys_leibniz_in_order():
    context = Context(
        "moving",
        ("a", "b", "f", "g"),
        dict.fromkeys("abfg", "1"),
        rates={"a": "f", "b": "g", "f": "?", "g": "?"},
    )
    ring = Ledger().open(context)
    zero = ring.element(0)
    a, b = names(ring, "a b")
    X, Y = from_quaternion((a, b, zero, zero)), from_quaternion((b, zero, a, zero))
    assert holds((X @ Y).rate(), X.rate() @ Y + X @ Y.rate())
    assert not holds((X @ Y).rate(), X.rate() @ Y + Y.rate() @ X)


def test_kinematics_are_those_of_textbooks_and_texts_that_the_kernel_reads():
    found = kinematics("q0 q1 q2 q3", "Omega1 Omega2 Omega3")
    names = ("q0", "q1", "q2", "q3", "Omega1", "Omega2", "Omega3")
    ring = Ledger().open(Context("textbook", names, dict.fromkeys(names, "0")))
    assert found.keys() == TEXTBOOK.keys()
    for rate, side in found.items():
        assert not (ring.read(str(side)) - ring.read(TEXTBOOK[rate])).numerator


def test_axes_of_the_other_handedness_turn_the_other_way(pqr):
    """With an axis turned round, i and its coefficient change sign; the product is the same one."""
    p, q, _ = pqr
    mirrored = [[x[0], x[1] * -1, x[2], x[3]] for x in (p, q)]
    whole, left = product(*mirrored), product(p, q, -1)
    assert holds((whole[0], whole[1] * -1, *whole[2:]), left)


def test_a_quarter_turn_about_the_third_axis_takes_the_first_to_the_second():
    half = sqrt(2) / 2
    assert rotated((half, 0, 0, half), (1, 0, 0)) == [0, 1, 0]
    assert rotated((half, 0, 0, half), (1, 0, 0), -1) == [0, -1, 0]
