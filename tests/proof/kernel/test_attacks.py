"""Attempts to get something false past the kernel."""

import re
import signal
from contextlib import contextmanager
from fractions import Fraction

import pytest
from ledgers import EXPRESSIONS, prove
from sympy.polys.domains import QQ

from rigidsym.proof.kernel import Context, Fact, KernelError, Ledger, replay
from rigidsym.proof.kernel._ring import at

CIRCLE = Context(
    name="circle",
    generators=("w", "s", "c"),
    witness={"w": "2", "s": "0", "c": "1"},
    units=("w",),
    definitions={"double": "2*s*c"},
    relations=("c**2 + s**2 - 1",),
    rates={"s": "w*c", "c": "-w*s"},
    nonnegative=("w",),
)


def line(name: str = "line", *generators: str, **fields) -> Context:
    generators = generators or ("x",)
    witness = fields.pop("witness", dict.fromkeys(generators, "1"))
    return Context(name, generators, witness, **fields)


def equation(fact_id: str, context: str, lhs: str, rhs: str, rule: str = "identity", **fields):
    return Fact(fact_id, context, "equal", (lhs,), (rhs,), rule, **fields)


class StillBusy(BaseException):
    """Timeout that no `except Exception` can take for a refusal."""


@contextmanager
def within(seconds: int):
    """Raise StillBusy after some seconds of processor time."""

    def stop(*_):
        raise StillBusy(f"after {seconds} s")

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


@pytest.mark.parametrize("text", [t for t in EXPRESSIONS if len(t) < 2000], ids=lambda t: t[:16])
def test_python_reads_an_expression_in_the_same_way(text):
    ring = Ledger().open(line(rates={"x": "3*x"}))
    whole = re.sub(r"\b(\d+)\b", r"Fraction(\1)", text)
    value = eval(whole, {"D": lambda x: 3 * x, "x": Fraction(7, 2), "Fraction": Fraction})
    assert at(ring.read(text).numerator, [QQ(7, 2)]) == QQ(value.numerator, value.denominator)


@pytest.mark.parametrize("cofactor", ["1/w", "w/w", "0/w", "1 + w/w**2"])
def test_a_cofactor_is_a_polynomial(cofactor):
    """The sum that has to give the difference ignores denominators of cofactors."""
    ledger = Ledger()
    ledger.open(CIRCLE)
    sides = "(c**2 + s**2)*w", "w"
    ledger.add(equation("honest", "circle", *sides, certificate={"cofactors": [["w"]]}))
    with pytest.raises(KernelError, match="a cofactor is no polynomial"):
        ledger.add(equation("e", "circle", *sides, certificate={"cofactors": [[cofactor]]}))


@pytest.mark.parametrize("premises", [("first",), ("first", "first")])
def test_an_identity_rests_on_no_premise(premises):
    ledger = Ledger()
    ledger.open(line())
    prove(ledger, equation("first", "line", "3*x", "x + 2*x"))
    with pytest.raises(KernelError, match="premises"):
        prove(ledger, equation("second", "line", "2*x", "x + x", premises=premises))


@pytest.mark.parametrize(
    "text",
    ["(x + 1)**100000", "3**100000000", "(((x + 1)**60)**60)**60"],
)
def test_expressions_that_would_not_end_are_refused(text):
    ledger = Ledger()
    ledger.open(line())
    with within(2), pytest.raises(KernelError):
        prove(ledger, equation("e", "line", text, text))


@pytest.mark.parametrize("value", ["1e999999999", "1/0", "nan", "inf", "", "x", None])
def test_a_witness_is_a_rational_number(value):
    with within(2), pytest.raises(KernelError):
        Ledger().open(line(witness={"x": value}))


@pytest.mark.parametrize(
    "context",
    [
        line(witness={}),
        line(witness={"x": "1", "y": "1"}),
        line(relations=("x - 2",)),
        line(relations=("x - 1", "x - 2")),
        line(relations=("1",)),
        line(units=("x - 1",)),
        line(units=("0",)),
        line(units=("2*x - 2",), relations=("x - 1",)),
        line(nonnegative=("-x",)),
        line(nonnegative=("-1/x",), units=("x",)),
        line(definitions={"x": "1"}),
        line(relations=("1/x - 1",)),
        line(relations=("x - 1",), rates={"x": "1"}),
        line(relations=("x - 1",), rates={"x": "?"}),
        line(relations=("D(x)",), rates={}),
        line(rates={"x": "D(x)"}),
        line(rates={"x": "y"}),
        line(rates={"typo": "1"}),
        line("line", "x", "x"),
        line("line", "x y"),
    ],
    ids=lambda context: f"{context.relations or context.units or context.rates or context}"[:40],
)
def test_a_context_must_be_inhabited_closed_and_readable(context):
    with pytest.raises(KernelError):
        Ledger().open(context)


def test_a_relation_in_motion_may_be_closed_by_the_others():
    witness = {"x": "1", "y": "0"}
    relations = ("x - 1", "y")
    Ledger().open(line("line", "x", "y", witness=witness, relations=relations, rates={"x": "y"}))
    with pytest.raises(KernelError, match="not closed"):
        Ledger().open(
            line("line", "x", "y", witness=witness, relations=relations[:1], rates={"x": "y"})
        )


def test_rates_belong_to_generators_only():
    """A rate for `H = x` would be a second rate for x, hidden from `model`: 1 = D(x) = 0."""

    def forge():
        ledger = Ledger()
        ledger.open(line("source", units=("H",), definitions={"H": "x"}, rates={"H": "1"}))
        ledger.open(line("target", units=("H",), definitions={"H": "x"}, rates={}))
        prove(ledger, equation("one", "source", "D(x)", "1"))
        ledger.add(Fact("bridge", "target", "model", (), ("source",), "model"))
        premises = ("one", "bridge")
        return ledger.add(equation("forged", "target", "D(x)", "1", "transfer", premises=premises))

    with pytest.raises(KernelError):
        forge()


def test_a_transferred_statement_must_be_readable_where_it_goes():
    def forge():
        ledger = Ledger()
        ledger.open(line("source", "x", "ghost"))
        ledger.open(line("target", "x"))
        prove(ledger, equation("fact", "source", "x*ghost", "ghost*x"))
        ledger.add(Fact("bridge", "target", "model", (), ("source",), "model"))
        premises = ("fact", "bridge")
        ledger.add(equation("out", "target", "x*ghost", "ghost*x", "transfer", premises=premises))

    with pytest.raises(KernelError):
        forge()


@pytest.mark.parametrize(("lhs", "rhs"), [((), ("a", "b")), (("0",), ("a",)), ((), ())])
def test_a_model_fact_says_one_context_and_nothing_else(lhs, rhs):
    ledger = Ledger()
    for name in "abc":
        ledger.open(line(name, relations=() if name == "a" else ("x - 1",)))
    with pytest.raises(KernelError):
        ledger.add(Fact("bridge", "c", "model", lhs, rhs, "model"))


def test_hypotheses_smuggled_into_a_ring_do_not_survive_replay():
    ledger = Ledger()
    ring = ledger.open(line())
    ring.relations = (ring.read("x").numerator,)
    prove(ledger, equation("forged", "line", "x", "0"))
    with pytest.raises(KernelError):
        replay(ledger.to_text())
