"""Attempts to get something false, or something malformed, past the kernel."""

import json
import re
import signal
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction

import pytest
from ledgers import EXPRESSIONS, NO_NAMES, NOT_EXPRESSIONS, prove, written
from sympy.polys.domains import QQ

from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, Ledger, replay
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
POINT = Context(
    name="point",
    generators=("w", "s", "c", "v"),
    witness={"w": "2", "s": "0", "c": "1", "v": "4"},
    units=("w",),
    definitions={"double": "2*s*c"},
    relations=("c**2 + s**2 - 1", "v - w**2"),
    rates={"s": "w*c", "c": "-w*s"},
    nonnegative=("w",),
)


def line(name: str = "line", *generators: str, **fields) -> Context:
    generators = generators or ("x",)
    witness = fields.pop("witness", dict.fromkeys(generators, "1"))
    return Context(name, generators, witness, **fields)


def equation(fact_id: str, context: str, lhs: str, rhs: str, rule: str = "identity", **fields):
    return Fact(fact_id, context, "equal", (lhs,), (rhs,), rule, **fields)


@pytest.fixture(scope="module")
def honest() -> str:
    """A small ledger with one fact of every rule."""
    ledger = Ledger()
    ledger.open(CIRCLE)
    ledger.open(POINT)
    prove(ledger, equation("rate", "circle", "D(double)/w", "2*(1 - 2*s**2)"))
    prove(ledger, Fact("length", "point", "root", ("w",), ("v",), "identity"))
    point = {"point": {"w": "2", "s": "3/5", "c": "4/5"}}
    ledger.add(
        Fact("apart", "circle", "unequal", ("s",), ("0",), "counterexample", certificate=point)
    )
    reference = {"reference": "a book"}
    ledger.add(
        equation(
            "hoped", "circle", "s", "c", "assumption", grade=Grade.ASSUMED, certificate=reference
        )
    )
    ledger.add(Fact("bridge", "point", "model", (), ("circle",), "model"))
    ledger.add(
        replace(
            ledger.facts["rate"],
            id="rate2",
            context="point",
            rule="transfer",
            premises=("rate", "bridge"),
            certificate={},
        )
    )
    ledger.add(
        replace(
            ledger.facts["hoped"],
            id="hoped2",
            context="point",
            rule="transfer",
            premises=("hoped", "bridge"),
            certificate={},
        )
    )
    return ledger.to_text()


class StillBusy(BaseException):
    """Not an Exception, so that nothing on the way can take it for a refusal."""


@contextmanager
def within(seconds: int):
    """Raise StillBusy after so many seconds of the processor."""

    def stop(*_):
        raise StillBusy(f"after {seconds} s")

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def test_replay_gives_back_the_same_text(honest):
    assert replay(honest).to_text() == honest
    assert written(json.loads(honest)) == honest


FACTS = {"rate": 0, "length": 1, "apart": 2, "hoped": 3, "bridge": 4, "rate2": 5, "hoped2": 6}
TAMPERED_FACTS = [
    ("rate", "rhs", ["2*(1 - 3*s**2)"]),
    ("rate", "lhs", ["D(double)"]),
    ("rate", "lhs", []),
    ("rate", "lhs", ["D(double)/w", "w"]),
    ("rate", "kind", "unequal"),
    ("rate", "kind", "theorem"),
    ("rate", "rule", "transfer"),
    ("rate", "rule", "believe"),
    ("rate", "rule", "root"),
    ("rate", "rule", "circle"),
    ("rate", "context", "nowhere"),
    ("rate", "premises", ["length"]),
    ("rate", "certificate", {}),
    ("rate", "certificate", {"cofactors": []}),
    ("rate", "certificate", {"cofactors": [[]]}),
    ("rate", "certificate", {"cofactors": [["0"]]}),
    ("rate", "certificate", {"cofactors": [["3"]]}),
    ("rate", "certificate", {"cofactors": [[None]]}),
    ("rate", "grade", "ASSUMED"),
    ("rate", "grade", "proved"),
    ("rate", "id", "length"),
    ("length", "rhs", ["w"]),
    ("length", "lhs", ["v"]),
    ("length", "lhs", ["-w"]),
    ("length", "kind", "nonnegative"),
    ("length", "certificate", {"cofactors": [["0", "1"]]}),
    ("apart", "rhs", ["3/5"]),
    ("apart", "certificate", {}),
    ("apart", "certificate", {"point": {"w": "2", "s": "1/5", "c": "4/5"}}),
    ("apart", "certificate", {"point": {"w": "-2", "s": "3/5", "c": "4/5"}}),
    ("apart", "certificate", {"point": {"w": "0", "s": "3/5", "c": "4/5"}}),
    ("apart", "certificate", {"point": {"w": "2", "s": "3/5"}}),
    ("apart", "certificate", {"point": {"w": "2", "s": "3/0", "c": "4/5"}}),
    ("apart", "kind", "equal"),
    ("hoped", "grade", "PROVED"),
    ("hoped", "grade", "ENCLOSED"),
    ("hoped", "certificate", {}),
    ("hoped", "certificate", {"reference": "a book", "points": [{}]}),
    ("hoped", "rule", "identity"),
    ("bridge", "rhs", ["point"]),
    ("bridge", "rhs", ["nowhere"]),
    ("bridge", "context", "circle"),
    ("rate2", "rhs", ["2*(1 - 3*s**2)"]),
    ("rate2", "premises", ["hoped", "bridge"]),
    ("rate2", "premises", ["bridge", "rate"]),
    ("rate2", "premises", ["rate", "rate"]),
    ("rate2", "premises", ["rate"]),
    ("rate2", "premises", ["rate", "rate2"]),
    ("rate2", "premises", ["rate", "bridge", "hoped"]),
    ("hoped2", "grade", "PROVED"),
    ("hoped2", "grade", "ENCLOSED"),
    ("hoped2", "premises", ["rate", "bridge"]),
]
TAMPERED_CONTEXTS = [
    ("relations", []),
    ("relations", ["c**2 + s**2 - 2"]),
    ("relations", ["c**2 - s**2 - 1"]),
    ("relations", ["c**2 + s**2 - 1", "s"]),
    ("relations", ["1"]),
    ("units", []),
    ("units", ["w", "s"]),
    ("units", ["w", "c**2 + s**2 - 1"]),
    ("units", ["w", "0"]),
    ("rates", {"s": "w*c"}),
    ("rates", {"s": "w*c", "c": "w*s"}),
    ("rates", {"s": "w*c", "c": "?"}),
    ("rates", None),
    ("nonnegative", ["s - 1", "w"]),
    ("witness", {"w": "2", "s": "1", "c": "1"}),
    ("witness", {"w": "2", "s": "0"}),
    ("witness", {"w": "2", "s": "0", "c": "1", "z": "1"}),
    ("witness", {"w": "2", "s": "0", "c": "1/0"}),
    ("definitions", {}),
    ("definitions", {"double": "s*c"}),
    ("definitions", {"double": "2*s*c", "w": "1"}),
    ("definitions", {"double": "double"}),
    ("definitions", {"double": "other", "other": "double"}),
    ("generators", ["w", "s"]),
    ("name", "point"),
]


@pytest.mark.parametrize(("fact", "field", "value"), TAMPERED_FACTS)
def test_a_tampered_fact_is_refused(honest, fact, field, value):
    data = json.loads(honest)
    assert data["facts"][FACTS[fact]][field] != value
    data["facts"][FACTS[fact]][field] = value
    with pytest.raises(KernelError):
        replay(written(data))


@pytest.mark.parametrize(("field", "value"), TAMPERED_CONTEXTS)
def test_a_tampered_context_is_refused(honest, field, value):
    data = json.loads(honest)
    assert data["contexts"][0][field] != value
    data["contexts"][0][field] = value
    with pytest.raises(KernelError):
        replay(written(data))


@pytest.mark.parametrize("field", ["relations", "units", "nonnegative"])
def test_a_model_must_declare_what_the_source_assumes(honest, field):
    data = json.loads(honest)
    data["contexts"][1][field] = []
    with pytest.raises(KernelError):
        replay(written(data))


@pytest.mark.parametrize("end", [0, 1, 100, -2, -100])
def test_a_cut_off_file_is_refused(honest, end):
    with pytest.raises(KernelError):
        replay(honest[:end])


@pytest.mark.parametrize("fact", range(5))
def test_a_fact_that_others_rest_on_cannot_be_dropped(honest, fact):
    data = json.loads(honest)
    needed = data["facts"][fact]["id"] in {p for f in data["facts"] for p in f["premises"]}
    del data["facts"][fact]
    if needed:
        with pytest.raises(KernelError):
            replay(written(data))
    else:
        assert len(replay(written(data)).facts) == len(FACTS) - 1


def test_premises_must_come_first(honest):
    data = json.loads(honest)
    data["facts"].reverse()
    with pytest.raises(KernelError):
        replay(written(data))


@pytest.mark.parametrize("twice", ["facts", "contexts"])
def test_nothing_is_admitted_twice(honest, twice):
    data = json.loads(honest)
    data[twice].append(data[twice][0])
    with pytest.raises(KernelError):
        replay(written(data))


@pytest.mark.parametrize("key", ["schema", "contexts", "facts", "published"])
def test_every_section_must_be_there(honest, key):
    data = json.loads(honest)
    del data[key]
    with pytest.raises(KernelError):
        replay(written(data))


def test_another_schema_is_refused(honest):
    with pytest.raises(KernelError, match="schema"):
        replay(honest.replace("rigidsym.ledger/4", "rigidsym.ledger/3"))


TEXTS = ["lhs", "rhs", "premises"], ["generators", "units", "relations", "nonnegative"]
MAPPINGS = [], ["witness", "definitions", "rates"]
ODD = [None, True, 1, 1.5, [None], [1], [["w"]], "w", {"w": "w"}, {"w": None}]


def _odd_types():
    for section, k in (("facts", 0), ("contexts", 1)):
        for field in TEXTS[k]:
            yield from ((section, field, odd) for odd in ODD)
        for field in MAPPINGS[k]:
            yield from ((section, field, odd) for odd in [*ODD[1:7], {"w": ["w"]}, {"w": None}])


@pytest.mark.parametrize(("section", "field", "odd"), list(_odd_types()))
def test_json_of_another_type_is_refused(section, field, odd):
    ledger = Ledger()
    ledger.open(line("line", "w", definitions={"z": "w"}, rates={}))
    prove(ledger, equation("e", "line", "w + z", "2*w"))
    data = json.loads(ledger.to_text())
    data[section][0][field] = odd
    with pytest.raises(KernelError):
        replay(written(data))


@pytest.mark.parametrize(
    "text", ["null", "[]", "1", '"x"', "{}", "[" * 100_000, '{"schema": NaN}', "\x00"]
)
def test_other_json_is_refused(text):
    with pytest.raises(KernelError):
        replay(text)


@pytest.mark.parametrize(
    "text",
    [
        *("", " ", "x +", "x y", "x, x", "[x]", "x[0]", "x.real", "'x'", "1.0", "1j", "True"),
        *("None", "+x", "~x", "x // 1", "x % 1", "x @ x", "x < x", "x if x else x", "(x := x)"),
        *("lambda: x", "abs(x)", "D()", "D(x, x)", "D(*x)", "D(x=x)", "D", "x()", "unknown"),
        *("x**x", "x**-1", "x**1.5", "x**(1 + 1)", "2**10**9", "1/0", "1/(x - x)", "x/(x - 1)"),
        *("\x00", "\ud800", "1" * 5000, "(" * 1000, "-" * 100_000 + "x", "x" + "+x" * 100_000),
        "0**0",
    ],
    ids=lambda text: ascii(text[:16]),
)
def test_what_is_not_an_expression_is_refused(text):
    ledger = Ledger()
    ledger.open(line(rates={}))
    with pytest.raises(KernelError):
        prove(ledger, equation("e", "line", text, text))


@pytest.mark.parametrize("text", NOT_EXPRESSIONS, ids=lambda text: ascii(text[:16]))
def test_a_text_is_read_by_the_grammar_alone(text):
    """Python's parser drops comments, folds letters and takes 1_000; readers of a ledger do not."""
    ring = Ledger().open(line(rates={}))
    with pytest.raises(KernelError, match=r"not an expression|not a text|no meaning"):
        ring.read(text)


@pytest.mark.parametrize("text", [t for t in EXPRESSIONS if len(t) < 2000], ids=lambda t: t[:16])
def test_python_reads_an_expression_in_the_same_way(text):
    ring = Ledger().open(line(rates={"x": "3*x"}))
    whole = re.sub(r"\b(\d+)\b", r"Fraction(\1)", text)
    value = eval(whole, {"D": lambda x: 3 * x, "x": Fraction(7, 2), "Fraction": Fraction})
    assert at(ring.read(text).numerator, [QQ(7, 2)]) == QQ(value.numerator, value.denominator)


@pytest.mark.parametrize(
    ("field", "name"),
    [
        (field, name)
        for field in ("name", "generators", "definitions")
        for name in NO_NAMES
        if (field, name) != ("name", "D")
    ],
    ids=ascii,
)
def test_what_is_no_name_names_nothing(field, name):
    fields = {"name": "line", "generators": ("x",), "definitions": {}}
    fields[field] = {"name": name, "generators": ("x", name), "definitions": {name: "x"}}[field]
    with pytest.raises(KernelError):
        Ledger().open(Context(witness=dict.fromkeys(fields["generators"], "1"), **fields))


@pytest.mark.parametrize("fact_id", [name for name in NO_NAMES if name != "D"], ids=ascii)
@pytest.mark.parametrize("prefix", ["", "line."])
def test_an_id_is_made_of_names(prefix, fact_id):
    """An id that looks like another, or that moves the cursor, would show as what it is not."""
    ledger = Ledger()
    ledger.open(line())
    with pytest.raises(KernelError) as refusal:
        prove(ledger, equation(prefix + fact_id, "line", "2*x", "x + x"))
    assert str(refusal.value).isascii()
    assert str(refusal.value).isprintable()


@pytest.mark.parametrize("cofactor", ["1/w", "w/w", "0/w", "1 + w/w**2"])
def test_a_cofactor_is_a_polynomial(cofactor):
    """Denominators of cofactors are nowhere in the sum that has to give the difference."""
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
    """A rate for `H = x` would be a second rate for x, which `model` does not see: 1 = D(x) = 0."""

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


def test_a_string_is_not_taken_for_a_column_of_letters():
    """lhs "xy", rhs "ab" would be checked as x = a, y = b, and be read as xy = ab."""
    names = ("x", "y", "a", "b", "xy", "ab")
    witness = dict.fromkeys(names, "1") | {"ab": "2"}
    ledger = Ledger()
    ledger.open(line("line", *names, witness=witness, relations=("x - a", "y - b")))
    prove(ledger, Fact("e", "line", "equal", ("x", "y"), ("a", "b"), "identity"))
    data = json.loads(ledger.to_text())
    data["facts"][0] |= {"lhs": "xy", "rhs": "ab"}
    with pytest.raises(KernelError):
        replay(written(data))


def test_a_key_written_twice_is_refused(honest):
    """JSON readers differ in which of two equal keys they take."""
    with pytest.raises(KernelError):
        replay(honest.replace('"lhs": [', '"lhs": ["0"], "lhs": [', 1))


def test_sections_the_kernel_does_not_know_are_refused(honest):
    data = json.loads(honest)
    with pytest.raises(KernelError):
        replay(written({"summary": "all equations proved", **data}))


def test_hypotheses_smuggled_into_a_ring_do_not_survive_replay():
    ledger = Ledger()
    ring = ledger.open(line())
    ring.relations = (ring.read("x").numerator,)
    prove(ledger, equation("forged", "line", "x", "0"))
    with pytest.raises(KernelError):
        replay(ledger.to_text())
