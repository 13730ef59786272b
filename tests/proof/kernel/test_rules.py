"""Each rule accepts a right instance and refuses a wrong one."""

from dataclasses import replace

import pytest
from ledgers import prove

from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, Ledger

PLANE = Context(
    name="plane",
    generators=("x", "y", "r"),
    witness={"x": "3", "y": "4", "r": "5"},
    units=("r", "x - y"),
    definitions={"cosine": "x/r", "sine": "y/r"},
    relations=("r**2 - x**2 - y**2",),
    rates={"x": "-y", "y": "x"},
    nonnegative=("r",),
)


@pytest.fixture
def ledger() -> Ledger:
    admitted = Ledger()
    admitted.open(PLANE)
    return admitted


def fact(kind: str, lhs: str, rhs: str, rule: str, **fields) -> Fact:
    return Fact("fact", fields.pop("context", "plane"), kind, (lhs,), (rhs,), rule, **fields)


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        ("cosine**2 + sine**2", "1"),
        ("(x**2 - y**2)/(x - y)", "x + y"),
        ("1/(2*r*(x - y))", "r/(2*r**2*(x - y))"),
        ("1/(x**2 + y**2 - r**2 + r)", "1/r"),
        ("D(r**2)", "0"),
        ("D(cosine)", "-sine"),
        ("D(1/(x - y))", "(x + y)/(x - y)**2"),
    ],
)
def test_identity_accepts(ledger, lhs, rhs):
    assert prove(ledger, fact("equal", lhs, rhs, "identity")).grade == Grade.PROVED


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        ("cosine**2 - sine**2", "1"),
        ("(x**2 - y**2)/(x - y)", "x - y"),
        ("r", "x + y"),
        ("D(cosine)", "sine"),
        ("D(1/(x - y))", "-(x + y)/(x - y)**2"),
        ("0", "1"),
    ],
)
def test_identity_refuses(ledger, lhs, rhs):
    with pytest.raises(KernelError, match="undecided"):
        prove(ledger, fact("equal", lhs, rhs, "identity"))
    zero = {"cofactors": [["0"]]}
    with pytest.raises(KernelError, match="cofactors"):
        ledger.add(fact("equal", lhs, rhs, "identity", certificate=zero))


@pytest.mark.parametrize("below", ["x", "x + y", "x*r", "cosine", "x - x", "r**2 - x**2 - y**2"])
def test_division_needs_a_declared_unit(ledger, below):
    with pytest.raises(KernelError, match="declared units"):
        prove(ledger, fact("equal", f"({below})/({below})", "1", "identity"))


@pytest.mark.parametrize(
    ("name", "radicand", "accepted"),
    [
        ("r", "x**2 + y**2", True),
        ("r", "x**2 - y**2", False),
        ("r", "(x**2 + y**2)**2", False),
        ("x", "x**2", False),
        ("-r", "r**2", False),
        ("-1", "1", False),
        ("x - x", "0", False),
        ("0", "x - x", True),
        ("0", "0", False),  # says nothing
        ("r*r", "r**4", True),
        ("r - 1 + 1", "r**2", False),
    ],
)
def test_root_needs_the_square_and_the_sign(ledger, name, radicand, accepted):
    root = fact("root", name, radicand, "identity")
    if accepted:
        assert prove(ledger, root).grade == Grade.PROVED
    else:
        with pytest.raises(KernelError):
            prove(ledger, root)


def test_no_counterexample_to_what_is_proved(ledger):
    prove(ledger, fact("equal", "cosine**2 + sine**2", "1", "identity"))
    refuted = fact("unequal", "cosine**2 + sine**2", "1", "counterexample")
    with pytest.raises(KernelError, match="agree"):
        ledger.add(replace(refuted, id="other", certificate={"point": PLANE.witness}))


UNIT_CIRCLE = Context(
    name="circle",
    generators=("x", "y"),
    witness={"x": "3/5", "y": "4/5"},
    units=("x - y",),
    definitions={"r": "1", "cosine": "x", "sine": "y"},
    relations=("x**2 + y**2 - 1",),
    rates={"x": "-y", "y": "x"},
    nonnegative=("r",),
)
BRIDGE = Fact("bridge", "circle", "model", (), ("plane",), "model")


def test_model_accepts_a_special_case(ledger):
    ledger.open(UNIT_CIRCLE)
    assert ledger.add(BRIDGE).grade == Grade.PROVED


@pytest.mark.parametrize(
    "change",
    [
        {"relations": ()},
        {"units": ()},
        {"nonnegative": (), "definitions": {"r": "-1", "cosine": "-x", "sine": "-y"}},
        {"rates": {}},
        {"rates": {"x": "y", "y": "-x"}},
        {"rates": None},
        {"definitions": {"r": "1", "cosine": "x"}},
        {"definitions": {"r": "1", "cosine": "x", "sine": "-y"}},
        {"definitions": {"r": "1 + x - x**2", "cosine": "x", "sine": "y"}},
    ],
    ids=str,
)
def test_model_refuses_another_theory(ledger, change):
    ledger.open(replace(UNIT_CIRCLE, **change))
    with pytest.raises(KernelError):
        ledger.add(BRIDGE)


def test_a_counterexample_is_not_transferred(ledger):
    ledger.open(UNIT_CIRCLE)
    point = {"point": {"x": "6", "y": "8", "r": "10"}}
    ledger.add(fact("unequal", "r", "1", "counterexample", certificate=point))
    ledger.add(BRIDGE)
    there = replace(ledger.facts["fact"], id="there", context="circle", rule="transfer")
    with pytest.raises(KernelError):
        ledger.add(replace(there, premises=("fact", "bridge")))


@pytest.mark.parametrize("certificate", [{}, {"reference": ""}, {"reason": "obvious"}])
def test_an_assumption_needs_a_reference(ledger, certificate):
    assumed = fact("equal", "x", "y", "assumption", grade=Grade.ASSUMED, certificate=certificate)
    with pytest.raises(KernelError, match="reference"):
        ledger.add(assumed)


def test_an_unknown_rate_is_never_used(ledger):
    ledger.open(Context("free", ("x", "y"), {"x": "1", "y": "1"}, rates={"y": "?"}))
    prove(ledger, fact("equal", "D(x**2)", "0", "identity", context="free"))
    with pytest.raises(KernelError, match="not known"):
        prove(ledger, fact("equal", "D(x*y)", "D(x*y)", "identity", context="free"))
