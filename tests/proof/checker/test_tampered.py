"""Kernel and second checker refuse a small ledger with one place changed."""

import json
from typing import Any

import pytest
from ledgers import GONE, both_refuse, prove, tampered, written

from rigidsym.proof.checker import Refused, check
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, Ledger, replay


def small_ledger() -> str:
    """Return a ledger with a fact of every rule."""
    fields = {"units": ("w",), "definitions": {"double": "2*s*c", "w1": "1/w"}}
    fields |= {"rates": {"s": "w*c", "c": "-w*s"}, "nonnegative": ("w",)}
    at, circle = {"w": "2", "s": "0", "c": "1"}, "c**2 + s**2 - 1"
    ledger = Ledger()
    ledger.open(Context("circle", tuple(at), at, relations=(circle,), **fields))
    names, point = (*at, "v"), {**at, "v": "4"}
    ledger.open(Context("point", names, point, relations=(circle, "v - w**2"), **fields))
    statement = (("D(double)*w1", "2*s"), ("2*(1 - 2*s**2)", "s + s"))
    prove(ledger, Fact("rate", "circle", "equal", *statement, "identity"))
    prove(ledger, Fact("length", "point", "root", ("w",), ("v",), "identity"))
    apart = {"point": {"w": "2", "s": "3/5", "c": "4/5"}}
    differ = ("unequal", ("s",), ("0",), "counterexample")
    ledger.add(Fact("apart", "circle", *differ, certificate=apart))
    reference, hope = {"reference": "a book"}, ("equal", ("s",), ("c",))
    ledger.add(Fact("hoped", "circle", *hope, "assumption", Grade.ASSUMED, certificate=reference))
    ledger.add(Fact("bridge", "point", "model", (), ("circle",), "model"))
    carried = ("rate", "bridge")
    ledger.add(Fact("rate2", "point", "equal", *statement, "transfer", premises=carried))
    hoped = ("hoped", "bridge")
    ledger.add(Fact("hoped2", "point", *hope, "transfer", Grade.ASSUMED, premises=hoped))
    return ledger.to_text()


SMALL = small_ledger()
DATA = json.loads(SMALL)
TAMPERED: dict[str, list[Any]] = {
    # No such witness; not closed under d/dt.
    "contexts/0/relations/0": [*("c**2 + s**2 - 2", "c - 1", "c**2 + u**2 - 1", "c**2 - s**2 - 1")],
    "contexts/0/relations": [["c**2 + s**2 - 1", "s"], ["1"]],
    "contexts/0/units": [["w", "s"], ["w", "c**2 + s**2 - 1"], ["w", "0"]],
    "contexts/0/units/0": [GONE, "s"],
    "contexts/0/rates": [{"s": "w*c"}, {"s": "w*c", "c": "?"}],
    "contexts/0/rates/c": ["w*s"],
    "contexts/0/rates/double": ["1"],
    "contexts/1/rates/w": ["1"],
    "contexts/0/nonnegative": [["s - 1", "w"]],
    "contexts/0/witness/s": ["1"],
    "contexts/0/witness/w": ["-2", "2/0", GONE],
    "contexts/0/witness/c": ["1/0"],
    "contexts/0/witness/v": ["4"],
    "contexts/0/definitions": [{"double": "other", "other": "double"}],
    "contexts/0/definitions/s": ["1"],
    "contexts/0/definitions/w": ["1"],
    "contexts/0/definitions/double": ["double"],
    "contexts/1/definitions/unused": ["no such name"],
    "contexts/0/generators": ["wsc"],
    "contexts/0/generators/+": [0],
    "contexts/0/generators/2": [GONE],
    "contexts/0/reading": [GONE],
    "contexts/1/units": [[]],
    "facts/0/lhs": [[], ["D(double)*w1", "2*s", "w"]],
    "facts/0/lhs/0": ["D(double)"],
    "facts/0/lhs/1": ["s + s", "D(s, c)"],
    "facts/0/rhs/0": ["2*(1 - 3*s**2)"],
    "facts/0/rhs/1": [GONE, "s + (w+1)**100000", "s/c", "2 * (s)"],
    "facts/0/certificate": [{}],
    "facts/0/certificate/cofactors": [[]],
    "facts/0/certificate/cofactors/0": [["0"], ["3"], [None]],
    "facts/0/certificate/cofactors/0/0": ["4*w", GONE],
    "facts/0/certificate/cofactors/1": [GONE],
    "facts/0/kind": ["unequal", "theorem"],
    "facts/0/rule": ["trust me", "root", "transfer", "circle"],
    "facts/0/context": ["nowhere"],
    "facts/0/grade": ["ENCLOSED", "ASSUMED", "proved"],
    "facts/0/premises": [["hoped"], ["length"]],
    "facts/1/lhs/0": ["-w", "v"],
    "facts/1/rhs/0": ["w"],
    "facts/1/kind": ["nonnegative"],
    "facts/1/certificate": [{"cofactors": [["0", "1"]]}],
    "facts/2/rhs/0": ["3/5"],
    "facts/2/kind": ["equal"],
    "facts/2/certificate": [{}],
    "facts/2/certificate/point": [{"w": "2", "s": "0", "c": "1"}],
    "facts/2/certificate/point/s": ["0", "1/5", "3/0"],
    "facts/2/certificate/point/w": ["-2", "0"],
    "facts/2/certificate/point/c": [GONE],
    "facts/3/grade": ["PROVED", "ENCLOSED"],
    "facts/3/rule": ["identity"],
    "facts/3/certificate": [{}],
    "facts/3/certificate/reference": [""],
    "facts/3/certificate/points": [[{}]],
    "facts/4/rhs": [["circle", "point"], ["nowhere"]],
    "facts/5/rhs/0": ["2*(1 - 3*s**2)"],
    "facts/5/premises/0": ["hoped", "rate2"],
    "facts/5/premises": [
        *(["bridge", "rate"], ["rate", "rate"], ["rate"], ["rate", "rate2"]),
        ["rate", "bridge", "hoped"],
    ],
    "facts/6/grade": ["PROVED", "ENCLOSED"],
    "facts/6/premises/0": ["rate"],
    "published": [["rate"], GONE],
    "schema": ["rigidsym.ledger/1", "rigidsym.ledger/3", GONE],
    "extra": [[]],
    "contexts": [GONE],
    "facts": [GONE],
}
# Changes that another entry shows, or that change the name of their own.
SHOWN_ELSEWHERE = [
    ("contexts/0/relations/0", GONE, "fact rate"),
    ("contexts/1/relations/0", GONE, "fact length"),
    ("contexts/1/relations", [], "fact length"),
    ("contexts/0/rates", None, "fact rate"),
    ("contexts/0/definitions", {}, "fact rate"),
    ("contexts/0/definitions/double", "s*c", "fact rate"),
    ("contexts/1/definitions/double", "3*s*c", "fact bridge"),
    ("contexts/1/definitions", {"double": "2*s*c"}, "fact bridge"),
    ("contexts/1/nonnegative/0", GONE, "fact length"),
    ("contexts/0/name", "point", "context point"),
    ("contexts/+", 0, "context circle"),
    ("facts/0", GONE, "fact rate2"),
    ("facts/0/id", "length", "fact length"),
    ("facts/0/id", 1, "fact 1"),
    ("facts/3", GONE, "fact hoped2"),
    ("facts/4", GONE, "fact rate2"),
    ("facts/4/context", "circle", "fact rate2"),
    ("facts/4/rhs", ["point"], "fact rate2"),
    ("facts/+", 0, "fact rate"),
]
HARMLESS = [
    ("contexts/0/reading", {"s": "a sine"}),
    ("contexts/1/rates/w", "0"),
    ("contexts/0/witness", {"w": "3", "s": "-4/5", "c": "3/5"}),
    ("facts/6/id", "renamed"),
    ("facts/2/certificate/point/w", "1/7"),
    *((f"facts/{k}", GONE) for k in (1, 2, 6)),
    ("published", {"sequences": {"rates": [{"fact": "rate"}]}}),
]
# Things that the kernel lets pass, or may: they prove nothing false, but are not in order.
STRICTER = [
    ("facts/0/certificate/cofactors/1", "0", "fact rate"),
    ("facts/0/source", [["1"]], "fact rate"),
]


def culprit(path: str) -> str:
    """Return the name by which refusals call the entry at a path."""
    section, *rest = path.split("/")
    if not rest:
        return "ledger"
    entry = DATA[section][int(rest[0])]
    return f"fact {entry['id']}" if section == "facts" else f"context {entry['name']}"


EVERY = [(path, value, culprit(path)) for path, values in TAMPERED.items() for value in values]


@pytest.mark.parametrize(("path", "value", "culprit"), [*EVERY, *SHOWN_ELSEWHERE])
def test_both_checkers_refuse(path, value, culprit):
    assert both_refuse(tampered(SMALL, path, value)).startswith(f"{culprit}: ")


@pytest.mark.parametrize(("path", "value"), HARMLESS)
def test_both_checkers_accept(path, value):
    text = tampered(SMALL, path, value)
    assert check(text) == len(replay(text).facts)
    assert replay(text).to_text() == text


@pytest.mark.parametrize(("path", "value", "culprit"), STRICTER)
def test_refuses_what_has_the_wrong_shape(path, value, culprit):
    with pytest.raises(Refused, match=f"^{culprit}: "):
        check(tampered(SMALL, path, value))


@pytest.mark.parametrize(
    "text",
    [
        *("null", "[]", "1", '"x"', "{}", "[" * 100_000, '{"schema": NaN}', "\x00"),
        *(SMALL[:end] for end in (0, 1, 100, len(SMALL) // 2, -1, -2, -100, -200)),
        SMALL + SMALL,
        written(DATA).replace("\n ", "\n  "),
        written({"summary": "all equations proved", **DATA}),
        # A key given twice: JSON readers differ in which of the two they take.
        SMALL.replace('"schema"', '"schema": "rigidsym.ledger/4",\n "schema"'),
        SMALL.replace('"s": "0"', '"s": "0",\n    "s": "0"'),
        SMALL.replace('"lhs": [', '"lhs": ["0"], "lhs": [', 1),
    ],
    ids=range(22),
)
def test_both_checkers_refuse_a_damaged_file(text):
    assert both_refuse(text).startswith("ledger: ")


def test_another_schema_is_named():
    with pytest.raises(KernelError, match="schema"):
        replay(tampered(SMALL, "schema", "rigidsym.ledger/3"))


def test_replay_gives_back_the_same_text():
    assert replay(SMALL).to_text() == SMALL == written(DATA)


def test_premises_must_come_first():
    assert both_refuse(written({**DATA, "facts": DATA["facts"][::-1]})).startswith("fact hoped2: ")


def test_a_cofactor_may_carry_a_unit():
    """A cofactor of gap * w proves the gap as well, since w is a unit."""
    text = tampered(SMALL, "facts/1/certificate/cofactors/0/1", "-w")
    assert check(text) == len(json.loads(text)["facts"])


TEXTS = ["lhs", "rhs", "premises"], ["generators", "units", "relations", "nonnegative"]
ODD = [None, True, 1, 1.5, [None], [1], [["w"]], "w", {"w": "w"}, {"w": None}]
ODD_TYPES = [
    *(("facts", field, odd) for field in TEXTS[0] for odd in ODD),
    *(("contexts", field, odd) for field in TEXTS[1] for odd in ODD),
    *(
        ("contexts", field, odd)
        for field in ("witness", "definitions", "rates")
        for odd in [*ODD[1:7], {"w": ["w"]}, {"w": None}]
    ),
]


@pytest.mark.parametrize(("section", "field", "odd"), ODD_TYPES)
def test_json_of_another_type_is_refused(section, field, odd):
    ledger = Ledger()
    ledger.open(Context("line", ("w",), {"w": "1"}, definitions={"z": "w"}, rates={}))
    prove(ledger, Fact("e", "line", "equal", ("w + z",), ("2*w",), "identity"))
    both_refuse(tampered(ledger.to_text(), f"{section}/0/{field}", odd))


def test_a_string_is_not_taken_for_a_column_of_letters():
    """Sides "xy" and "ab" would be checked as x = a, y = b, but read as xy = ab."""
    names = ("x", "y", "a", "b", "xy", "ab")
    witness = dict.fromkeys(names, "1") | {"ab": "2"}
    ledger = Ledger()
    ledger.open(Context("line", names, witness, relations=("x - a", "y - b")))
    prove(ledger, Fact("e", "line", "equal", ("x", "y"), ("a", "b"), "identity"))
    text = tampered(ledger.to_text(), "facts/0/lhs", "xy")
    both_refuse(tampered(text, "facts/0/rhs", "ab"))
