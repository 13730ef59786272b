"""The rules `theta` and `start` in both checkers, and attempts to prove false facts by them."""

from dataclasses import replace

import mpmath as mp
import pytest

from derivations.theta_laws import ARGUMENTS, CIRCULAR, HYPERBOLIC, LAWS, RIEMANN, Family, prove
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._computation import plain
from rigidsym.proof.checker import Refused, check
from rigidsym.proof.checker._theta import zero
from rigidsym.proof.kernel import Context, Fact, KernelError, Ledger
from rigidsym.proof.kernel._theta import vanishing

# Watson's identities, a step of Landen's, a Wronskian, and products over halves of the nome.
WATSON = "theta4(a + c, q**2)*theta4(a - c, q**2) + theta1(a + c, q**2)*theta1(a - c, q**2)"
TRUE = [
    f"{WATSON} - theta4(a, q)*theta3(c, q)",
    "theta2(a + c, q)*theta2(a - c, q) + theta1(a + c, q)*theta1(a - c, q)"
    " - 2*theta3(2*a, q**2)*theta2(2*c, q**2)",
    "theta3(a + c, q)*theta4(a - c, q) - theta4(2*a, q**2)*theta4(2*c, q**2)"
    " + theta1(2*a, q**2)*theta1(2*c, q**2)",
    "dtheta1(a + c, q**2)*theta4(a - c, q**2) - theta1(a + c, q**2)*dtheta4(a - c, q**2)"
    " - (theta1(a, q)*dtheta2(c, q) + theta2(a, q)*dtheta1(c, q))/2",
    "theta1(-a, q) + theta1(a, q)",
    "ddtheta3(2*a, q**3) - ddtheta3(-2*a, q**3)",
    "theta3(a, q) - theta3(2*a, q**4) - theta2(2*a, q**4)",
    *(family.riemann(top) for family in (CIRCULAR, HYPERBOLIC) for top in RIEMANN),
]
FALSE = {
    "a sign": f"{WATSON} + theta4(a, q)*theta3(c, q)",
    "a sign between": f"{WATSON} - theta4(a, q)*theta3(c, q)".replace(") + ", ") - "),
    "a factor": f"{WATSON} - 2*theta4(a, q)*theta3(c, q)",
    "another function": f"{WATSON} - theta4(a, q)*theta4(c, q)",
    "another nome": f"{WATSON} - theta4(a, q**3)*theta3(c, q)",
    "two nomes": f"{WATSON} - theta4(a, q)*theta3(c, p)",
    "an argument": f"{WATSON} - theta4(a, q)*theta3(a + c, q)",
    "an argument's factor": f"{WATSON} - theta4(2*a, q)*theta3(c, q)",
    "one missing": "theta4(a, q)*theta3(c, q)",
    "an order": f"{WATSON} - dtheta4(a, q)*theta3(c, q)",
    "orders that differ by a term": TRUE[3].replace("dtheta2(c", "theta2(c"),
    "the weight of an order": TRUE[3].replace("/2", ""),
    "a wrong Wronskian": TRUE[3].replace("- theta1(a + c", "+ theta1(a + c"),
    "even": "theta1(-a, q) - theta1(a, q)",
    "odd": "dtheta4(-a, q) - dtheta4(a, q)",
    "an order of one": "dtheta3(a, q) - ddtheta3(a, q)",
    "the other coset": "theta3(a, q) - theta2(a, q)",
    "half a sum": "theta3(a, q) - theta3(2*a, q**4)",
}
UNREADABLE = {
    "dependent arguments": "theta3(a, q)**2 - theta3(a, q)**2 + theta1(a, q)*theta1(-a, q)",
    "too few": "theta3(a + c, q) - theta3(a + c, q) + theta3(a + 2*c, q)",
    "constants": "theta3(0, q) - theta4(0, q)",
    "a number": "theta3(a, q) - theta3(a, q) + 1",
    "no theta": "a - a",
    "a name": f"{TRUE[0]} + x0",
    "the letter of an atom": "theta3(a, q) - x0",
    "an affine argument": "theta3(a + 1, q) - theta3(a, q)",
    "a square": "theta3(a**2, q) - theta3(a**2, q) + theta3(-a**2, q)",
    "the unit": "theta3(I*a, q) - theta3(-I*a, q)",
    "no nome": "theta3(a) - theta3(-a)",
    "a nome that is a number": "theta3(a, 2) - theta3(-a, 2)",
    "an index": "theta5(a, q) - theta5(-a, q)",
    "a digit": "theta3(a, q)0 - theta3(-a, q)",
    "many classes": "theta3(a/9973 + c/9967, q)*theta3(a - c/9949, q)"
    " - theta3(-a/9973 - c/9967, q)*theta3(c/9949 - a, q)",
}


@pytest.mark.parametrize("text", TRUE)
def test_identities_hold_in_both(text):
    assert vanishing(text)
    assert zero(text)


@pytest.mark.parametrize("text", [*FALSE.values(), *UNREADABLE.values()], ids=[*FALSE, *UNREADABLE])
def test_what_is_false_or_cannot_be_read_is_refused_by_both(text):
    with pytest.raises(KernelError):
        vanishing(text)
    with pytest.raises(Refused):
        zero(text)


def value(text: str, **names: complex) -> complex:
    """Return the numerical value of an identity by mpmath's theta functions."""
    functions = {
        f"{'d' * order}theta{index}": lambda z, q, i=index, d=order: mp.jtheta(i, z, q, d)
        for order in range(3)
        for index in (1, 2, 3, 4)
    }
    return eval(text, {}, functions | names)


@pytest.mark.parametrize("text", [*TRUE, *FALSE.values()])
def test_numbers_agree_with_the_verdict(text):
    at = {"a": 0.3 + 0.2j, "b": 0.7 - 0.1j, "c": -0.4 + 0.15j, "d": 0.1 + 0.3j, "p": 0.4}
    at |= {"q": 0.2, "nome_m": 0.45, "nome_c": 0.2}
    assert (abs(value(text, **at)) < 1e-12) == (text in TRUE)


@pytest.mark.parametrize("family", [CIRCULAR, HYPERBOLIC])
@pytest.mark.parametrize("top", RIEMANN)
def test_derivatives_of_relations_hold_too(family: Family, top: str):
    text = family.riemann(top, *ARGUMENTS[2:])
    assert vanishing(text)
    assert zero(text)


# A context whose names are theta functions, and what can be said of them.
TURN = Context(
    name="turn",
    generators=("q", "v", "b", "x", "y", "z", "n", "dx"),
    witness=dict.fromkeys(("q", "v", "b", "x", "y", "z", "n", "dx"), "1"),
    rates={"v": "2", "x": "2*dx", "y": "?", "z": "?", "dx": "?"},
    thetas={
        "x": "re(theta4(v, q))",
        "dx": "re(dtheta4(v, q))",
        "y": "re(theta4(v - I*b, q**2))",
        "z": "im(theta4(v - I*b, q**2))",
        "n": "re(theta3(I*b, q))",
    },
)
SUM = "theta4(a + c, q**2)*theta4(a - c, q**2) + theta1(a + c, q**2)*theta1(a - c, q**2)"
NORM = Context(
    name="norm",
    generators=("q", "v", "b", "x", "y", "z", "s", "t", "n"),
    witness=dict.fromkeys(("q", "v", "b", "x", "y", "z", "s", "t", "n"), "1"),
    thetas={
        **{name: TURN.thetas[name] for name in "xyzn"},
        "s": "re(theta1(v - I*b, q**2))",
        "t": "im(theta1(v - I*b, q**2))",
    },
)
AT = {"a": "v", "c": "I*b"}
RIGHT = "y**2 + z**2 + s**2 + t**2"


def stated(rhs: str, identity: str = f"{SUM} - theta4(a, q)*theta3(c, q)", **forms: str) -> Fact:
    certificate = {"identity": identity, "forms": {**AT, **forms}}
    return Fact("norm.f", "norm", "equal", ("x*n",), (rhs,), "theta", certificate=certificate)


def verdicts(fact: Fact, *contexts: Context) -> tuple[bool, bool]:
    """Return whether kernel and second checker accept a fact."""
    ledger = Ledger()
    for context in contexts:
        ledger.open(context)
    try:
        ledger.add(fact)
        first = True
    except KernelError:
        first = False
    ledger.facts[fact.id] = fact
    try:
        second = check(ledger.to_text()) == 1
    except Refused:
        second = False
    return first, second


def test_a_product_of_thetas_is_a_sum_of_squares():
    assert verdicts(stated(RIGHT), NORM) == (True, True)


@pytest.mark.parametrize(
    "fact",
    [
        *map(stated, ("y**2 + z**2 - s**2 - t**2", "y**2 - z**2 + s**2 - t**2", f"2*({RIGHT})")),
        *(stated(RIGHT, c=form) for form in ("b", "2*I*b")),
        *(stated(RIGHT, a=form) for form in ("b", "v + 1")),
        stated(RIGHT, SUM),
        *(replace(stated(RIGHT), kind=kind) for kind in ("root", "nonnegative")),
        replace(stated(RIGHT), certificate={}),
        replace(stated(RIGHT), rule="identity"),
    ],
)
def test_what_the_identity_does_not_say_is_refused(fact):
    assert verdicts(fact, NORM) == (False, False)


@pytest.mark.parametrize("name", sorted(NORM.thetas))
def test_each_declaration_is_needed(name):
    others = {other: text for other, text in NORM.thetas.items() if other != name}
    for thetas in (others, others | {name: "re(theta2(v, q))"}):
        context = replace(NORM, thetas=thetas)
        assert verdicts(stated(RIGHT), context) == (False, False)


def opens(context: Context) -> tuple[bool, bool]:
    """Return whether kernel and second checker accept a context."""
    ledger = Ledger()
    try:
        context.open()
        first = True
    except (KernelError, KeyError):
        first = False
    ledger.contexts[context.name] = context
    try:
        check(ledger.to_text())
    except Refused:
        return first, False
    return first, True


def test_rates_of_theta_functions():
    assert opens(TURN) == (True, True)
    assert opens(replace(TURN, rates=None)) == (True, True)


@pytest.mark.parametrize(
    "changed",
    [
        *({"rates": TURN.rates | {"x": rate}} for rate in ("dx", "-2*dx", "0")),
        *({"rates": TURN.rates | {"q": rate}} for rate in ("1", "?")),
        *({"rates": TURN.rates | {name: "1"}} for name in ("v", "n", "b")),
        *({"rates": TURN.rates | rates} for rates in ({"y": "dx"}, {"dx": "x"})),
        {"thetas": {"w": "re(theta4(v, q))"}},
        *({"thetas": {"x": f"re({text})"}} for text in ("theta4(w, q)", "theta4(v, w)")),
        *({"thetas": {"x": f"re({text})"}} for text in ("2*theta4(v, q)", "theta4(v*b, q)")),
        *({"thetas": {"x": text}} for text in ("theta4(v, q)", "abs(theta4(v, q))")),
        *({"thetas": {"x": text}} for text in ("re(theta4(v, q)) + 1", "re(theta4(v, -q))")),
    ],
    ids=str,
)
def test_what_theta_functions_do_not_do_is_refused(changed):
    assert opens(replace(TURN, **changed)) == (False, False)


def test_rational_points_refute_nothing_about_functions():
    """A true identity fails at the witness, which is no value of the functions."""
    fact = Fact("norm.f", "norm", "unequal", ("x*n",), ("0",), "counterexample")
    fact = replace(fact, certificate={"point": dict(NORM.witness)})
    assert verdicts(fact, NORM) == (False, False)
    assert verdicts(fact, replace(NORM, thetas={})) == (True, True)


def test_a_model_declares_the_same_functions():
    other = replace(NORM, name="other")
    bridge = Fact("other.m", "other", "model", (), ("norm",), "model")
    assert verdicts(bridge, NORM, other) == (True, True)
    for thetas in ({}, {**NORM.thetas, "x": "re(theta3(v, q))"}):
        assert verdicts(bridge, NORM, replace(other, thetas=thetas)) == (False, False)


# --- what holds at the start
CLOCK = Context(
    name="clock",
    generators=("s", "c", "p", "r"),
    witness={"s": "0", "c": "1", "p": "0", "r": "-1"},
    rates={"s": "c", "c": "-s", "p": "-r", "r": "p"},
    start=("s", "c - 1", "p", "r + 1"),
)


def begun(lhs: tuple[str, ...], rhs: tuple[str, ...]) -> Fact:
    return Fact("clock.f", "clock", "equal", lhs, rhs, "start")


def test_what_starts_alike_and_moves_alike_is_alike():
    assert verdicts(begun(("p", "r"), ("s", "-c")), CLOCK) == (True, True)
    assert verdicts(begun(("s**2 + c**2",), ("1",)), CLOCK) == (True, True)


@pytest.mark.parametrize(
    ("fact", "context"),
    [
        (begun(("p", "r"), ("-s", "-c")), CLOCK),  # not closed under d/dt
        (begun(("p", "r"), ("s", "c")), CLOCK),  # not so at the start
        (begun(("p",), ("s",)), CLOCK),  # closed only with the other component
        (begun(("s",), ("0",)), CLOCK),
        (begun(("s**2 + c**2",), ("2",)), CLOCK),
        (begun(("p", "r"), ("s", "-c")), replace(CLOCK, start=())),
        (begun(("p", "r"), ("s", "-c")), replace(CLOCK, start=("s", "c - 1", "p"))),
        (replace(begun(("p", "r"), ("s", "-c")), kind="root"), CLOCK),
        (
            Fact("clock.f", "clock", "unequal", ("s",), ("0",), "counterexample",
                 certificate={"point": {"s": "3/5", "c": "4/5", "p": "0", "r": "0"}}),
            CLOCK,
        ),
    ],
)  # fmt: skip
def test_what_does_not_follow_from_a_start_is_refused(fact, context):
    assert verdicts(fact, context) == (False, False)


def test_a_context_starts_at_its_witness_and_in_time():
    assert opens(CLOCK) == (True, True)
    assert opens(replace(CLOCK, start=("s - 1",))) == (False, False)
    assert opens(replace(CLOCK, rates=None)) == (False, False)


def test_a_model_starts_where_the_other_does():
    other = replace(CLOCK, name="other")
    bridge = Fact("other.m", "other", "model", (), ("clock",), "model")
    assert verdicts(bridge, CLOCK, other) == (True, True)
    assert verdicts(bridge, CLOCK, replace(other, start=("s",))) == (False, False)


@pytest.fixture(scope="module")
def laws() -> LedgerBuilder:
    """Return a ledger with one family of theta functions and its laws."""
    names = ("v", "b", "nome_m", *CIRCULAR.declared())
    builder = LedgerBuilder()
    builder.open(Context("laws", names, dict.fromkeys(names, "1"), thetas=CIRCULAR.declared()))
    prove(builder, "laws", CIRCULAR)
    return builder


def test_both_families_have_the_same_laws():
    circular, hyperbolic = (
        {name: plain(equations) for name, (_, equations) in family.laws.items()}
        for family in (CIRCULAR, HYPERBOLIC)
    )
    assert circular == hyperbolic == plain(LAWS)


@pytest.mark.parametrize("name", LAWS)
def test_each_law_holds_with_its_signs_alone(laws, name):
    fact = laws.ledger.facts[f"laws.{name}"]
    again = replace(fact, id="laws.again", rhs=tuple(f"-({text})" for text in fact.rhs))
    with pytest.raises(KernelError, match="the identity does not give"):
        laws.ledger.add(again)
