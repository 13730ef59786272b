"""Normal forms: cofactors multiply out, and no nonzero polynomial reduces to zero."""

from fractions import Fraction
from random import Random

import pytest

from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._normal_form import divide, nested, quotients
from rigidsym.proof.kernel import Context, KernelError
from rigidsym.proof.kernel._ring import at

# The last relation leads with w*y, which the first reduces: w*x**2 hides from plain division.
HIDDEN = Context(
    "hidden",
    ("x", "y", "w"),
    {"x": "2", "y": "4", "w": "1/4"},
    relations=("y - x**2", "w*y - 1"),
)
SINGLE = Context("single", ("x", "y"), {"x": "3/5", "y": "4/5"}, relations=("y**2 + x**2 - 1",))
FREE = Context("free", ("x", "y"), {"x": "1", "y": "1"})
RINGS = {context.name: context.open() for context in (HIDDEN, SINGLE, FREE)}


def multiplied_out(ring, cofactors):
    return sum((c * r for c, r in zip(cofactors, ring.relations, strict=True)), ring.poly(0))


def some_polynomial(ring, random, degree=3):
    total = ring.poly(0)
    for _ in range(5):
        term = ring.poly(Fraction(random.randint(-9, 9), random.randint(1, 5)))
        for generator in ring.poly.gens:
            term *= generator ** random.randint(0, degree)
        total += term
    return total


@pytest.mark.parametrize("name", RINGS)
@pytest.mark.parametrize("seed", range(12))
def test_a_polynomial_is_its_cofactors_and_its_remainder(name, seed):
    ring = RINGS[name]
    polynomial = some_polynomial(ring, Random(seed))
    cofactors, remainder = divide(ring, polynomial)
    assert polynomial == multiplied_out(ring, cofactors) + remainder


# The second relation makes y**2*z**2 of y*z**3, which both relations divide: the first one has to.
TURNED = Context(
    "turned",
    ("x", "y", "z"),
    {"x": "1", "y": "1", "z": "1"},
    relations=("y**2 - x", "3*z**2 - 3*y*z"),
)


@pytest.mark.parametrize("context", [HIDDEN, SINGLE, TURNED], ids=lambda context: context.name)
@pytest.mark.parametrize("seed", range(12))
def test_division_is_that_of_sympy_term_by_term(context, seed):
    ring = context.open()
    polynomial = some_polynomial(ring, Random(seed))
    assert quotients(polynomial, ring.relations) == polynomial.div(list(ring.relations))


@pytest.mark.parametrize("name", ["hidden", "single"])
@pytest.mark.parametrize("seed", range(12))
def test_what_relations_generate_is_zero_and_the_cofactors_say_how(name, seed):
    ring, random = RINGS[name], Random(seed)
    made = sum(some_polynomial(ring, random) * relation for relation in ring.relations)
    cofactors, remainder = divide(ring, made)
    assert not remainder
    assert multiplied_out(ring, cofactors) == made


@pytest.mark.parametrize("name", RINGS)
@pytest.mark.parametrize("seed", range(12))
def test_a_nested_text_is_its_polynomial(name, seed):
    ring = RINGS[name]
    polynomial = some_polynomial(ring, Random(seed), degree=1 + seed % 3)
    for each in (polynomial, -polynomial, polynomial * ring.poly.gens[0], polynomial - polynomial):
        assert ring.read(nested(each)).numerator == each


def test_plain_division_misses_what_reduced_relations_find():
    ring = RINGS["hidden"]
    polynomial = ring.read("w*x**2 - 1").numerator
    assert ring.remainder(polynomial)
    cofactors, remainder = divide(ring, polynomial)
    assert not remainder
    assert multiplied_out(ring, cofactors) == polynomial
    builder = LedgerBuilder()
    builder.open(HIDDEN)
    assert builder.claim("hidden.found", {"w*x**2": "1"}).certificate["cofactors"] == [
        [str(cofactor) for cofactor in cofactors]
    ]


@pytest.mark.parametrize("name", RINGS)
@pytest.mark.parametrize("seed", range(25))
def test_what_is_not_zero_at_a_point_of_the_context_is_never_zero(name, seed):
    ring = RINGS[name]
    context = next(c for c in (HIDDEN, SINGLE, FREE) if c.name == name)
    point = context.check_point(ring, context.witness)
    polynomial = some_polynomial(ring, Random(seed))
    if at(polynomial, point):
        assert divide(ring, polynomial)[1]
    polynomial -= ring.poly(at(polynomial, point)) - 1
    assert divide(ring, polynomial)[1]


@pytest.mark.parametrize(
    ("equation", "name"), [({"x": "y + 1"}, "hidden"), ({"x": "y"}, "single"), ({"x": "y"}, "free")]
)
def test_a_false_equation_is_refused(equation, name):
    builder = LedgerBuilder()
    for context in (HIDDEN, SINGLE, FREE):
        builder.open(context)
    with pytest.raises(KernelError, match="undecided"):
        builder.claim(f"{name}.false", equation)


def test_zero_is_zero_with_and_without_relations():
    for ring in RINGS.values():
        cofactors, remainder = divide(ring, ring.poly(0))
        assert not remainder
        assert not any(cofactors)


def test_rings_of_the_same_names_are_not_mixed_up():
    first = Context("a", ("x", "y"), {"x": "1", "y": "1"}, relations=("x**2 - 1", "y - x")).open()
    second = Context("b", ("x", "y"), {"x": "2", "y": "2"}, relations=("x**2 - 4", "y - x")).open()
    assert not divide(first, first.read("x*y - 1").numerator)[1]
    assert divide(second, second.read("x*y - 1").numerator)[1]
    assert not divide(second, second.read("x*y - 4").numerator)[1]


def test_redundant_relations_leave_a_false_claim_undecided():
    builder = LedgerBuilder()
    relations = ("x**2 - 1", "x**2 - 1", "y - x")
    builder.open(Context("d", ("x", "y"), {"x": "1", "y": "1"}, relations=relations))
    with pytest.raises(KernelError, match="undecided"):
        builder.claim("d.f", {"x": "y + 1"})
