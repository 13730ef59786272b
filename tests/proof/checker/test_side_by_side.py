"""Kernel and second checker agree on signs, grammar, models, partitions and grades."""

import json
from dataclasses import replace
from random import Random

import pytest
from ledgers import (
    EXPRESSIONS,
    MEANINGLESS,
    NO_NAMES,
    NOT_EXPRESSIONS,
    both_refuse,
    unchecked,
    written,
)

from rigidsym.proof.checker import Refused, check
from rigidsym.proof.checker._language import Forms
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, replay
from rigidsym.proof.kernel._language import parse


def accepted(contexts, facts) -> None:
    text = unchecked(contexts, facts)
    assert len(replay(text).facts) == check(text) == len(facts)


def refused(contexts, facts) -> None:
    """Assert that both refuse the last fact and accept those before it."""
    accepted(contexts, facts[:-1])
    both_refuse(unchecked(contexts, facts), facts[-1].id)


# Signs.

SIGNS = Context(
    "signs",
    ("x", "y", "z", "xx"),
    {"x": "1", "y": "2", "z": "-1", "xx": "3"},
    units=("x", "y", "z"),
    definitions={
        "good": "x + z**2/y",
        "odd": "z**3",
        "difference": "x - y",
        "named": "good*x",
        "by_bad": "x + odd",
    },
    nonnegative=("x", "y", "-z"),
)


def signed(form: str, kind: str = "nonnegative") -> Fact:
    """Return the fact 0 + form = form >= 0, or form = sqrt(form**2)."""
    lhs, rhs = (f"0 + {form}", form) if kind == "nonnegative" else (form, f"({form})**2")
    return Fact("f", "signs", kind, (lhs,), (rhs,), "identity", certificate={"cofactors": [[]]})


@pytest.mark.parametrize("kind", ["nonnegative", "root"])
@pytest.mark.parametrize(
    "form",
    [
        *("0", "7", "x", "-z", "x + y", "x*y", "x/y", "x**3", "z**2", "(z - 3)**2", "(x*z)**4"),
        *("good", "named", "named*good**3", "x*(-z)", "1/(x*y)"),
        *("odd**2", "difference**2*x", "xx**2 + 1/2"),
    ],
)
def test_a_visible_sign(form, kind):
    accepted([SIGNS], [signed(form, kind)])


@pytest.mark.parametrize("kind", ["nonnegative", "root"])
@pytest.mark.parametrize(
    "form",
    [
        *("z", "-1", "-x", "z**3", "odd", "x - y", "y - x", "x + z", "x*z", "x/z", "z/x", "x + -1"),
        *("difference", "by_bad", "xx", "0 - 1", "(z**3)**3", "-z**2", "x*-1", "0*z", "z*z"),
        *("-(z)*z", "x**3 - y", "z**1", "(x - y)**3", "--1"),
    ],
)
def test_an_invisible_sign(form, kind):
    refused([SIGNS], [signed(form, kind)])


@pytest.mark.parametrize(
    "form", ["x**-2", "x**0", "x**2.0", "x**y", "abs(x)", "True", "'x'", "1e1"]
)
def test_what_only_looks_like_a_sign(form):
    refused([SIGNS], [signed(form)])


@pytest.mark.parametrize("name", ["-1", "(w)", "w#", "w\n", "x - w", "\ufb01"], ids=ascii)
def test_a_definition_cannot_rename_what_is_no_name(name):
    """A definition of the text "-1" as 1 would make the sign of -1 visible."""
    names = ("w", "x", "fi")
    context = Context("c", names, dict.fromkeys(names, "1"), definitions={name: "1"})
    both_refuse(unchecked([context], []))


def test_a_sign_needs_its_equation():
    wrong = replace(signed("x"), lhs=("0 + y",))
    refused([SIGNS], [wrong])
    refused([SIGNS], [replace(wrong, kind="equal")])


def test_every_component_of_a_sign_is_looked_at():
    both = Fact("f", "signs", "nonnegative", ("0 + x", "0 + z"), ("x", "z"), "identity")
    refused([SIGNS], [replace(both, certificate={"cofactors": [[], []]})])


def test_definitions_that_double_are_seen_in_no_time():
    doubling = {"a0": "1", **{f"a{k + 1}": f"a{k}*a{k}" for k in range(60)}}
    context = Context("signs", ("x",), {"x": "1"}, definitions=doubling)
    text = unchecked([context], [signed("a60")])
    assert check(text) == 1


# The grammar.

PLAIN = Context("plain", ("x",), {"x": "1"}, rates={"x": "3*x"})


def read(text: str) -> Fact:
    """Return the fact that a text is not 1/7 at x = 1, true for every listed expression."""
    point = {"point": {"x": "1"}}
    return Fact("f", "plain", "unequal", (text,), ("1/7",), "counterexample", certificate=point)


def zero(text: str) -> Fact:
    """Return the fact text - text = 0."""
    lhs, certificate = f"{text} - {text}", {"cofactors": [[]]}
    return Fact("f", "plain", "equal", (lhs,), ("0",), "identity", certificate=certificate)


@pytest.mark.parametrize("text", EXPRESSIONS, ids=lambda text: ascii(text[:16]))
def test_both_read_an_expression(text):
    accepted([PLAIN], [read(text)])


@pytest.mark.parametrize(
    "text", [*NOT_EXPRESSIONS, *MEANINGLESS], ids=lambda text: ascii(text[:16])
)
def test_neither_reads_anything_else(text):
    """Python's parser drops comments, folds letters and takes 1_000; ledger readers do not."""
    refused([PLAIN], [read(text)])
    if text in NOT_EXPRESSIONS:
        with pytest.raises(KernelError, match=r"not an expression|not a text|no meaning"):
            PLAIN.open().read(text)


TOKENS = ["x", "y", "D", "if", "2", "0", "10", "1_0", *"+-*/(),", "**", " ", "  ", "#", "."]


def by_the_kernel(text: str):
    """Return the kernel's tree of a text in the other checker's form; None if it refuses."""
    try:
        return binary(parse(text))
    except KernelError:
        return None


def binary(tree):
    match tree:
        case int() | str():
            return tree
        case ("-", operand):
            return "-", binary(operand)
        case (base, "**", int(exponent)):
            return "**", binary(base), exponent
        case (function, "(", *arguments):
            return ("call", function, *map(binary, arguments))
    form = binary(tree[0])
    for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
        form = (operator, form, binary(operand))
    return form


def by_the_other(text: str):
    try:
        return Forms().read(text)
    except Refused:
        return None


def test_both_read_random_texts_in_the_same_way():
    random = Random(16)
    texts = ["".join(random.choices(TOKENS, k=random.randint(1, 7))) for _ in range(30_000)]
    forms = [by_the_kernel(text) for text in texts]
    assert sum(form is not None for form in forms) > 1000
    assert forms == [by_the_other(text) for text in texts]


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
def test_neither_takes_what_is_no_name(field, name):
    value = {"name": name, "generators": ("x", name), "definitions": {name: "x"}}[field]
    witness = dict.fromkeys(("x", name) if field == "generators" else ("x",), "1")
    both_refuse(unchecked([replace(PLAIN, witness=witness, rates=None, **{field: value})], []))


@pytest.mark.parametrize("name", [name for name in NO_NAMES if name != "D"], ids=ascii)
@pytest.mark.parametrize("field", ["id", "context", "rule"])
def test_neither_takes_an_id_that_is_not_made_of_names(field, name):
    for value in (name, f"plain.{name}"):
        both_refuse(unchecked([PLAIN], [replace(zero("x"), **{field: value})]))


@pytest.mark.parametrize(
    ("nonnegative", "rates", "inhabited"),
    [
        (("x", "-x"), {"x": "1"}, False),  # no motion has it for longer than an instant
        (("x",), {"x": "1"}, False),  # nor did it before
        (("x",), {"x": "x*y"}, False),  # true, and not seen
        (("x", "-x"), {"y": "1"}, True),
        (("x", "-x"), None, True),
        (("y",), {"x": "1", "y": "-1"}, True),
    ],
    ids=str,
)
def test_a_moving_context_is_inhabited_by_a_motion(nonnegative, rates, inhabited):
    moving = Context("c", ("x", "y"), {"x": "0", "y": "1"}, rates=rates, nonnegative=nonnegative)
    if inhabited:
        accepted([moving], [])
    else:
        both_refuse(unchecked([moving], []), "context c")
        still = replace(moving, relations=("x",), rates={"x": "x*y"})
        accepted([still], [])


def test_neither_lets_an_identity_rest_on_premises():
    refused([PLAIN], [zero("x"), replace(zero("2*x"), id="g", premises=("f",))])


# A fact says more than its context.

MOVING = Context(
    "moving",
    ("x", "y", "c", "w"),
    {"x": "1", "y": "2", "c": "1", "w": "1"},
    definitions={"E": "x**2 + y**2/2", "twice": "2*E"},
    rates={"x": "(-y)*c", "y": "x", "w": "?"},
    nonnegative=("w",),
)
STILL = replace(MOVING, rates=None)


def stated(lhs, rhs, kind="equal"):
    lhs, rhs = ((side,) if isinstance(side, str) else side for side in (lhs, rhs))
    rows = {"cofactors": [[]] * len(lhs)}
    return Fact("f", "moving", kind, lhs, rhs, "identity", certificate=rows)


RESTATED = [
    *(("x", "x"), ("0", "0"), ("x + y", "(x + (y))"), ("D(x)", "D( x )"), ("-x", "-(x)")),
    *(("E", "x**2 + y**2/2"), ("E", "((x)**2) + (y**2)/2"), ("twice", "2*E"), ("twice", "2 * (E)")),
    *(("D(x)", "-y*c"), ("D (x)", "(-(y))*c"), ("D(y)", "x"), ("D(c)", "0"), ("D((c))", "(0)")),
]


@pytest.mark.parametrize("turned", [False, True], ids=["", "turned"])
@pytest.mark.parametrize(("lhs", "rhs"), RESTATED, ids=str)
def test_what_says_no_more_than_its_context_is_no_fact(lhs, rhs, turned):
    sides = (rhs, lhs) if turned else (lhs, rhs)
    refused([MOVING], [stated(*sides)])
    told = (sides[0], "x - x"), (sides[1], "0")
    refused([MOVING], [stated(*told)])
    refused([MOVING], [stated(*(column[::-1] for column in told))])


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        *(("x", "1*x"), ("x - x", "0"), ("x + y", "y + x"), ("E", "y**2/2 + x**2")),
        *(("twice", "E*2"), ("twice", "2*x**2 + y**2"), ("twice", "2*(x**2 + y**2/2)")),
        *(("D(x)", "-c*y"), ("D(x)", "-(y*c)"), ("2*D(y)", "2*x"), ("D(D(y))", "-y*c")),
        *(("D(E)", "(1 - 2*c)*x*y"), ("D(c*y)", "c*x"), ("D(c)", "x - x"), ("D(2)", "0")),
    ],
    ids=str,
)
def test_what_has_to_be_decided_is_a_fact(lhs, rhs):
    accepted([MOVING], [stated(lhs, rhs)])
    accepted([MOVING], [stated(rhs, lhs)])


def test_a_root_or_a_sign_of_a_thing_itself_is_no_fact():
    refused([MOVING], [stated("0", "0", "root")])
    refused([MOVING], [stated("w", "w", "nonnegative")])
    accepted([MOVING], [stated("w", "w**2", "root")])
    accepted([MOVING], [stated("2*w - w", "w", "nonnegative")])


def test_without_time_there_are_no_rates_to_read_back():
    refused([STILL], [stated("D(c)", "0")])
    refused([STILL], [stated("E", "x**2 + y**2/2")])
    accepted([STILL], [stated("2*E", "2*x**2 + y**2")])


@pytest.mark.parametrize("rule", ["assumption", "transfer"])
def test_what_is_assumed_or_transferred_says_more_too(rule):
    definition = Fact("a", "moving", "equal", ("E",), ("x**2 + y**2/2",), "assumption")
    definition = replace(definition, grade=Grade.ASSUMED, certificate={"reference": "a book"})
    if rule == "assumption":
        refused([MOVING], [definition])
    else:
        free = Context("free", (*MOVING.generators, "E"), {**MOVING.witness, "E": "3"})
        there = replace(definition, context="free")
        bridge = Fact("b", "moving", "model", (), ("free",), "model")
        carried = replace(definition, id="h", rule="transfer", premises=("a", "b"), certificate={})
        refused([free, MOVING], [there, bridge, carried])


def test_a_counterexample_may_have_components_that_agree():
    """One component that differs refutes all of them together."""
    point = {"point": {**MOVING.witness}}
    apart = Fact("f", "moving", "unequal", ("x", "y"), ("x", "x"), "counterexample")
    accepted([MOVING], [replace(apart, certificate=point)])
    refused([MOVING], [replace(apart, lhs=("x",), rhs=("x",), certificate=point)])


# Models and what is transferred by them.

ROOTED = Context("rooted", ("x", "r"), {"x": "3", "r": "3"}, ("r",), relations=("r - x",))
FREE = Context("free", ("x", "r"), {"x": "3", "r": "4"}, ("r",))
BOOK = {"reference": "a book"}
ASSUMED = Fact("e", "free", "equal", ("r",), ("x",), "assumption", Grade.ASSUMED, certificate=BOOK)
BRIDGE = Fact("m", "free", "model", (), ("rooted",), "model", Grade.ASSUMED, ("e",))
THERE = Fact("s", "rooted", "nonnegative", ("r*x",), ("r**2",), "identity")
THERE = replace(THERE, certificate={"cofactors": [["-r"]]})
CARRIED = {"id": "h", "context": "free", "rule": "transfer", "premises": ("s", "m")}
HERE = replace(THERE, grade=Grade.ASSUMED, certificate={}, **CARRIED)
BOTH = [ROOTED, FREE]


def test_a_model_by_a_premise_carries_a_sign():
    accepted(BOTH, [ASSUMED, BRIDGE, THERE, HERE])


@pytest.mark.parametrize("grade", [grade for grade in Grade if grade != Grade.ASSUMED])
def test_neither_a_model_nor_what_it_carries_is_better_than_its_premises(grade):
    better = [replace(fact, grade=grade) for fact in (ASSUMED, BRIDGE, HERE)]
    for facts in (better[:1], [ASSUMED, better[1]], [ASSUMED, BRIDGE, THERE, better[2]]):
        refused(BOTH, facts)
        both_refuse(unchecked(BOTH, facts), "earned ASSUMED")


@pytest.mark.parametrize(
    "change",
    [
        *({"kind": kind} for kind in ("equal", "root", "unequal")),
        *({"premises": premises} for premises in (("m", "s"), ("s", "e"), ("s",))),
        *({"rhs": ("x**2",)}, {"lhs": ("x*r",)}, {"context": "rooted"}),
    ],
    ids=str,
)
def test_only_the_statement_itself_is_carried(change):
    refused(BOTH, [ASSUMED, BRIDGE, THERE, replace(HERE, **change)])


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [("r**2", "x**2"), ("r", "-x"), ("r + x", "0"), ("x", "x + 0*r"), ("r*x", "x**2"), ("r", "2")],
)
def test_a_premise_that_does_not_suffice(lhs, rhs):
    refused(BOTH, [replace(ASSUMED, lhs=(lhs,), rhs=(rhs,)), BRIDGE])


def test_a_model_needs_the_premise():
    refused(BOTH, [ASSUMED, replace(BRIDGE, premises=(), grade=Grade.PROVED)])


def test_a_premise_from_another_context():
    other = replace(ASSUMED, context="other")
    refused([*BOTH, replace(FREE, name="other")], [other, BRIDGE])
    theirs = Fact("e", "rooted", "equal", ("r",), ("x",), "identity")
    proved = replace(BRIDGE, grade=Grade.PROVED)
    refused(BOTH, [replace(theirs, certificate={"cofactors": [["1"]]}), proved])


@pytest.mark.parametrize(
    ("kind", "lhs", "rhs", "rule", "certificate"),
    [
        ("root", "r", "r**2", "identity", {"cofactors": [[]]}),
        ("nonnegative", "2*r - r", "r", "identity", {"cofactors": [[]]}),
        ("unequal", "r", "x", "counterexample", {"point": {"x": "3", "r": "4"}}),
    ],
)
def test_a_premise_that_is_no_equation(kind, lhs, rhs, rule, certificate):
    contexts = [ROOTED, replace(FREE, nonnegative=("r",))]
    premise = Fact("e", "free", kind, (lhs,), (rhs,), rule, certificate=certificate)
    refused(contexts, [premise, replace(BRIDGE, grade=Grade.PROVED)])


def test_a_premise_makes_no_unit_and_no_sign():
    """The premise r = x gives neither 1/r nor the sign of r if x has none."""
    refused([replace(ROOTED, units=("x",)), FREE], [ASSUMED, BRIDGE])
    refused([replace(ROOTED, nonnegative=("r",)), FREE], [ASSUMED, BRIDGE])
    accepted(
        [replace(ROOTED, nonnegative=("r",)), replace(FREE, nonnegative=("r",))],
        [ASSUMED, BRIDGE],
    )


def test_premises_may_give_definitions_and_rates():
    theirs = Context("rooted", ("x",), {"x": "3"}, definitions={"r": "x"}, rates={"x": "x"})
    ours = Context("free", ("x", "r"), {"x": "3", "r": "4"}, rates={"x": "r"})
    accepted([theirs, ours], [ASSUMED, BRIDGE])
    refused([theirs, replace(ours, rates={"x": "-r"})], [ASSUMED, BRIDGE])
    refused([theirs, replace(ours, rates={"x": "?"})], [ASSUMED, BRIDGE])


def test_premises_stand_together():
    theirs = Context("rooted", ("x", "y", "z"), dict.fromkeys("xyz", "1"), relations=("x - z",))
    ours = Context("free", ("x", "y", "z"), dict.fromkeys("xyz", "1"))
    first = replace(ASSUMED, id="e1", lhs=("x",), rhs=("y",))
    second = replace(ASSUMED, id="e2", lhs=("y",), rhs=("z",))
    accepted([theirs, ours], [first, second, replace(BRIDGE, premises=("e1", "e2"))])
    refused([theirs, ours], [first, second, replace(BRIDGE, premises=("e1",))])


# Partitions.

WHOLE = Context(
    "whole",
    ("x", "y"),
    {"x": "1", "y": "1"},
    definitions={"w": "x - y"},
    relations=("y**2 - 1",),
    rates={},
    nonnegative=("y",),
    reading={"x": "first"},
)
ZERO = replace(WHOLE, name="zero", witness={"x": "0", "y": "1"}, relations=("y**2 - 1", "x"))
PLUS = replace(WHOLE, name="plus", units=("x",), nonnegative=("y", "x"))
MINUS = replace(
    WHOLE, name="minus", witness={"x": "-1", "y": "1"}, units=("x",), nonnegative=("y", "-x")
)
CASES = ("zero", "plus", "minus")
SPLIT = Fact("p", "whole", "partition", ("x",), CASES, "partition", certificate={"cases": [*CASES]})
FOUR = [WHOLE, ZERO, PLUS, MINUS]


def split(*cases: str, **fields) -> Fact:
    return replace(SPLIT, rhs=cases, certificate={"cases": [*cases]}, **fields)


def test_a_partition():
    accepted(FOUR, [SPLIT])


@pytest.mark.parametrize(
    "fact",
    [
        split("zero", "plus"),  # x >= 0 is not seen
        *(split("zero", "minus"), split("plus", "minus"), split("zero"), split()),
        *(split("plus", "zero", "minus"), split("zero", "minus", "plus")),
        *(split("zero", "plus", "plus"), split("zero", "plus", "minus", "minus")),
        *(split("whole", "plus", "minus"), split("zero", "plus", "nowhere")),
        *(replace(SPLIT, rhs=rhs) for rhs in ((), ("whole",), ("zero", "plus"))),
        *(replace(SPLIT, rhs=(*rhs, "plus")) for rhs in (CASES, ("zero", "minus"))),
        *(replace(SPLIT, lhs=lhs) for lhs in ((), ("y",), ("w",), ("-x",), ("x", "x"))),
        *(replace(SPLIT, certificate=x) for x in ({}, {"cases": "zero plus minus"})),
        replace(SPLIT, certificate={"cases": None}),
        replace(SPLIT, context="zero"),
        replace(SPLIT, kind="model"),
        replace(SPLIT, grade=Grade.ENCLOSED),
        replace(SPLIT, rule="identity", certificate={"cofactors": [[]]}),
    ],
    ids=lambda fact: f"{fact.lhs} {fact.rhs} {fact.certificate}",
)
def test_a_wrong_partition(fact):
    refused(FOUR, [fact])


@pytest.mark.parametrize(
    "change",
    [
        # Dropped, in another order, said otherwise, said twice, less.
        *({"nonnegative": signs} for signs in (("x",), ("x", "y"), ("y",), ("y", "1*x"))),
        *({"nonnegative": signs} for signs in (("y", "x", "x"), ("y", "x - 1"))),
        *({"units": units} for units in ((), ("y",), ("x", "y"))),
        *({"relations": x} for x in ((), ("y**2 - 1", "x - 1"), ("y - 1",))),
        *({"rates": rates} for rates in (None, {"x": "?"})),
        *({"definitions": texts} for texts in ({"w": "y - x"}, {})),
        {"reading": {}},
        {"generators": ("y", "x")},
        {"generators": ("x", "y", "z"), "witness": dict.fromkeys("xyz", "1")},
    ],
    ids=str,
)
def test_a_case_with_another_hypothesis(change):
    refused([WHOLE, ZERO, replace(PLUS, **change), MINUS], [SPLIT])


@pytest.mark.parametrize("sign", ["- x", "-(x)", "-1*x", "-x + 0", "y", "0"])
def test_a_negative_case_with_another_sign(sign):
    refused([WHOLE, ZERO, PLUS, replace(MINUS, nonnegative=("y", sign))], [SPLIT])


def test_by_an_expression():
    zero = replace(ZERO, witness={"x": "1", "y": "1"}, relations=("y**2 - 1", "x - y"))
    plus = replace(PLUS, witness={"x": "2", "y": "1"}, units=("x - y",), nonnegative=("y", "x - y"))
    minus = replace(MINUS, units=("x - y",), nonnegative=("y", "-x - y"))
    refused([WHOLE, zero, plus, minus], [replace(SPLIT, lhs=("x - y",))])


def test_by_a_defined_name():
    zero = replace(ZERO, witness={"x": "1", "y": "1"}, relations=("y**2 - 1", "w"))
    plus = replace(PLUS, witness={"x": "2", "y": "1"}, units=("w",), nonnegative=("y", "w"))
    minus = replace(MINUS, units=("w",), nonnegative=("y", "-w"))
    accepted([WHOLE, zero, plus, minus], [replace(SPLIT, lhs=("w",))])
    refused([WHOLE, zero, plus], [split("zero", "plus", lhs=("w",))])


def test_two_cases_where_the_sign_is_visible():
    declared = {"nonnegative": ("y", "x")}
    whole, zero = replace(WHOLE, **declared), replace(ZERO, **declared)
    plus = replace(PLUS, nonnegative=("y", "x", "x"))
    accepted([whole, zero, plus], [split("zero", "plus")])
    refused([whole, zero, plus], [split("zero")])
    refused([whole, zero, plus], [split("plus", "zero")])


def test_what_moves_through_zero_has_no_cases():
    moving = replace(WHOLE, rates={"x": "y"})
    for case in (replace(ZERO, rates=moving.rates), replace(ZERO, rates={"x": "?"})):
        both_refuse(unchecked([replace(moving, rates=case.rates), case], []))


FINER = [
    replace(PLUS, name="plus0", witness={"x": "1", "y": "1"}, relations=("y**2 - 1", "v")),
    replace(PLUS, name="plus1", units=("x", "v"), nonnegative=("y", "x", "v")),
    replace(PLUS, name="plus2", units=("x", "v"), nonnegative=("y", "x", "-v")),
]


def refined() -> tuple[list[Context], Fact, Fact]:
    """Return contexts and facts that split the case `plus` by the sign of v = x - 1."""
    with_v = {"definitions": {"v": "x - 1"}}
    below = {"x": "1/2", "y": "1"}
    first, second, third = (replace(context, **with_v) for context in FINER)
    second = replace(second, witness={"x": "2", "y": "1"})
    contexts = [replace(context, **with_v) for context in FOUR]
    contexts += [first, second, replace(third, witness=below)]
    inner = ("plus0", "plus1", "plus2")
    fine = Fact("q", "plus", "partition", ("v",), inner, "partition")
    fine = replace(fine, certificate={"cases": [*inner]})
    whole = replace(SPLIT, rhs=("zero", *inner, "minus"), premises=("q",))
    return contexts, fine, whole


def test_a_partition_of_a_case():
    contexts, fine, whole = refined()
    accepted(contexts, [fine, whole])
    accepted(contexts, [fine, replace(SPLIT, id="r")])


@pytest.mark.parametrize(
    "change",
    [
        *({"premises": premises} for premises in ((), ("p",))),
        {"rhs": ("zero", "plus0", "plus1", "minus")},
        {"rhs": ("zero", "plus0", "plus1", "plus1", "minus")},
        {"rhs": ("zero", "plus0", "plus1", "plus2", "plus2", "minus")},
        *({"rhs": rhs} for rhs in (CASES, ("zero", "minus", "plus0", "plus1", "plus2"))),
        {"rhs": ("zero", "plus", "plus0", "plus1", "plus2", "minus")},
    ],
    ids=str,
)
def test_wrong_leaves(change):
    contexts, fine, whole = refined()
    refused(contexts, [fine, replace(whole, **change)])


def test_a_premise_about_another_context_splits_nothing():
    contexts, fine, whole = refined()
    twin = [replace(context, name=f"{context.name}_") for context in contexts]
    names = [f"{name}_" for name in fine.rhs]
    other = replace(fine, context="plus_", rhs=tuple(names), certificate={"cases": names})
    refused([*contexts, *twin], [other, whole])
    refused([*contexts, *twin], [other, replace(whole, rhs=CASES)])


# What is written may be changed afterwards.

HONEST = unchecked([*BOTH, *refined()[0]], [ASSUMED, BRIDGE, THERE, HERE, *refined()[1:]])


@pytest.mark.parametrize(
    ("fact", "change"),
    [
        *(("s", {"certificate": {"cofactors": [[x]]}}) for x in ("r", "-2*r")),
        *(("s", change) for change in ({"rhs": ["2*r**2"]}, {"lhs": ["r"]}, {"rule": "sign"})),
        *(("m", {"grade": grade}) for grade in ("PROVED", "ENCLOSED")),
        *(("m", {"premises": premises}) for premises in (["s"], [])),
        ("h", {"grade": "PROVED"}),
        *(("h", {"premises": premises}) for premises in (["s", "s"], ["e", "m"])),
        *(("e", change) for change in ({"grade": "ENCLOSED"}, {"certificate": {"points": []}})),
        *(("p", change) for change in ({"rhs": [*CASES]}, {"premises": []})),
        ("q", {"certificate": {"cases": ["plus0", "plus1"]}}),
    ],
    ids=str,
)
def test_both_refuse_a_tampered_fact(fact, change):
    assert check(HONEST) == len(replay(HONEST).facts) == 6
    data = json.loads(HONEST)
    (entry,) = (entry for entry in data["facts"] if entry["id"] == fact)
    assert {**entry, **change} != entry
    entry |= change
    both_refuse(written(data))


def _dropped():
    for k, context in enumerate(json.loads(HONEST)["contexts"]):
        for field in ("units", "relations", "nonnegative"):
            yield from ((k, field, place) for place in range(len(context[field])))


# No fact of this ledger rests on these.
IDLE = {(0, "units", 0)}


@pytest.mark.parametrize(("k", "field", "place"), sorted({*_dropped()} - IDLE))
def test_both_refuse_a_dropped_hypothesis(k, field, place):
    data = json.loads(HONEST)
    del data["contexts"][k][field][place]
    both_refuse(written(data))
