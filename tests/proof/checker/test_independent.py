"""The second checker accepts what is in order, refuses what is not, and shares no code."""

import ast
import json
import re
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path
from typing import Any

import pytest
from ledgers import prove, written

import rigidsym.proof.checker
from rigidsym.proof.checker import Refused, check
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, Ledger, replay

HOME = Path(rigidsym.proof.checker.__file__).parent
SEALED = (HOME.parents[2] / "derivations" / "ledger.json").read_text(encoding="utf-8")
GONE = object()


def tampered(text: str, path: str, value: Any) -> str:
    """The ledger with the entry at this path replaced, removed (GONE) or appended (+)."""
    data = place = json.loads(text)
    *outer, last = [int(key) if key.isdigit() else key for key in path.split("/")]
    for key in outer:
        place = place[key]
    if value is GONE:
        del place[last]
    elif last == "+":
        place.append(place[value])
    else:
        place[last] = value
    return written(data)


def refusal(text: str) -> str:
    """The line with which this checker refuses; the kernel must refuse as well."""
    with pytest.raises(KernelError):
        replay(text)
    with pytest.raises(Refused) as caught:
        check(text)
    return str(caught.value)


def small_ledger() -> str:
    """One fact of every rule."""
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

TAMPERED = [
    ("contexts/0/relations/0", "c**2 + s**2 - 2", "context circle"),  # no such witness
    ("contexts/0/relations/0", "c - 1", "context circle"),  # not closed under d/dt
    ("contexts/0/relations/0", GONE, "fact rate"),
    ("contexts/1/relations/0", GONE, "fact length"),
    ("contexts/0/relations/0", "c**2 + u**2 - 1", "context circle"),
    ("contexts/0/rates", {"s": "w*c"}, "context circle"),
    ("contexts/0/rates", {"s": "w*c", "c": "?"}, "context circle"),
    ("contexts/0/rates", None, "fact rate"),
    ("contexts/0/rates/double", "1", "context circle"),
    ("contexts/1/rates/w", "1", "context point"),
    ("contexts/0/units/0", GONE, "context circle"),
    ("contexts/0/units/0", "s", "context circle"),
    ("contexts/0/witness/s", "1", "context circle"),
    ("contexts/0/witness/w", "-2", "context circle"),
    ("contexts/0/witness/w", "2/0", "context circle"),
    ("contexts/0/witness/w", GONE, "context circle"),
    ("contexts/0/witness/v", "4", "context circle"),
    ("contexts/0/definitions/s", "1", "context circle"),
    ("contexts/0/definitions/double", "double", "context circle"),
    ("contexts/1/definitions/double", "3*s*c", "fact bridge"),
    ("contexts/1/definitions", {"double": "2*s*c"}, "fact bridge"),
    ("contexts/1/nonnegative/0", GONE, "fact length"),
    ("contexts/0/generators", "wsc", "context circle"),
    ("contexts/0/generators/+", 0, "context circle"),
    ("contexts/0/reading", GONE, "context circle"),
    ("contexts/+", 0, "context circle"),
    ("facts/0/rhs/0", "2*(1 - 3*s**2)", "fact rate"),
    ("facts/0/rhs/1", GONE, "fact rate"),
    ("facts/0/rhs/1", "s + (w+1)**100000", "fact rate"),
    ("facts/0/rhs/1", "s/c", "fact rate"),
    ("facts/0/lhs/1", "s + s", "fact rate"),
    ("facts/0/rhs/1", "2 * (s)", "fact rate"),
    ("facts/0/lhs/1", "D(s, c)", "fact rate"),
    ("facts/0/certificate/cofactors/0/0", "4*w", "fact rate"),
    ("facts/0/certificate/cofactors/0/0", GONE, "fact rate"),
    ("facts/0/certificate/cofactors/1", GONE, "fact rate"),
    ("facts/0/certificate", {}, "fact rate"),
    ("facts/0/rule", "trust me", "fact rate"),
    ("facts/0/rule", "root", "fact rate"),
    ("facts/0/context", "nowhere", "fact rate"),
    ("facts/0/grade", "ENCLOSED", "fact rate"),
    ("facts/0/premises", ["hoped"], "fact rate"),
    ("facts/1/lhs/0", "-w", "fact length"),
    ("facts/2/certificate/point/s", "0", "fact apart"),
    ("facts/2/certificate/point", {"w": "2", "s": "0", "c": "1"}, "fact apart"),
    ("facts/3/grade", "PROVED", "fact hoped"),
    ("facts/3/certificate/reference", "", "fact hoped"),
    ("facts/4/context", "circle", "fact rate2"),
    ("facts/4/rhs", ["circle", "point"], "fact bridge"),
    ("facts/4/rhs", ["nowhere"], "fact bridge"),
    ("facts/5/premises/0", "hoped", "fact rate2"),
    ("facts/5/premises", ["bridge", "rate"], "fact rate2"),
    ("facts/5/premises/0", "rate2", "fact rate2"),
    ("facts/6/grade", "PROVED", "fact hoped2"),
    ("facts/6/premises/0", "rate", "fact hoped2"),
    ("facts/+", 0, "fact rate"),
    ("contexts/1/definitions/unused", "no such name", "context point"),
    ("facts/0/id", 1, "fact 1"),
    ("published", ["rate"], "ledger"),
    ("schema", "rigidsym.ledger/1", "ledger"),
    ("published", GONE, "ledger"),
    ("extra", [], "ledger"),
]

HARMLESS = [
    ("contexts/0/reading", {"s": "a sine"}),
    ("contexts/1/rates/w", "0"),
    ("contexts/0/witness", {"w": "3", "s": "-4/5", "c": "3/5"}),
    ("facts/6/id", "renamed"),
    ("facts/2/certificate/point/w", "1/7"),
    ("facts/6", GONE),
    ("published", {"sequences": {"rates": [{"fact": "rate"}]}}),
]

# Things that the kernel lets pass, or may: they prove nothing false, but are not in order.
STRICTER = [
    ("facts/0/certificate/cofactors/1", "0", "fact rate"),
    ("facts/0/source", [["1"]], "fact rate"),
]


def test_accepts_the_sealed_ledger():
    assert check(SEALED) == len(json.loads(SEALED)["facts"]) > 100


@pytest.mark.parametrize(("path", "value", "culprit"), TAMPERED)
def test_both_checkers_refuse(path, value, culprit):
    line = refusal(tampered(SMALL, path, value))
    assert line.startswith(f"{culprit}: ")
    assert "\n" not in line


@pytest.mark.parametrize(("path", "value"), HARMLESS)
def test_both_checkers_accept(path, value):
    text = tampered(SMALL, path, value)
    assert check(text) == len(replay(text).facts)


@pytest.mark.parametrize(("path", "value", "culprit"), STRICTER)
def test_refuses_what_has_the_wrong_shape(path, value, culprit):
    with pytest.raises(Refused, match=f"^{culprit}: "):
        check(tampered(SMALL, path, value))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "[" * 100_000,
        SMALL[:-1],
        SMALL[:-200],
        SMALL + SMALL,
        written(json.loads(SMALL)).replace("\n ", "\n  "),
        SMALL.replace('"schema"', '"schema": "rigidsym.ledger/4",\n "schema"'),
        SMALL.replace('"s": "0"', '"s": "0",\n    "s": "0"'),
    ],
    ids=range(9),
)
def test_both_checkers_refuse_a_damaged_file(text):
    assert refusal(text).startswith("ledger: ")


def test_a_cofactor_may_carry_a_unit():
    """Its numerators need not be the kernel's: gap * w is as good as the gap where w != 0."""
    text = tampered(SMALL, "facts/1/certificate/cofactors/0/1", "-w")
    assert check(text) == len(json.loads(text)["facts"])


@pytest.fixture(scope="module")
def excerpt() -> str:
    """Three contexts of the sealed ledger with their facts; the kernel needs 0.4 s for it."""
    data, names = json.loads(SEALED), ("body", "attitude", "regular")
    data["contexts"] = [context for context in data["contexts"] if context["name"] in names]
    facts = [fact for fact in data["facts"] if fact["context"] in names]
    data["facts"] = [fact for fact in facts if fact["kind"] != "model" and not fact["premises"]]
    return written(data)


def test_both_checkers_accept_the_excerpt(excerpt):
    assert check(excerpt) == len(replay(excerpt).facts) > 30


@pytest.mark.parametrize("k", range(1, 31, 3))
def test_both_checkers_refuse_a_changed_statement(excerpt, k):
    fact = json.loads(excerpt)["facts"][k]
    text = tampered(excerpt, f"facts/{k}/rhs/0", f"{fact['rhs'][0]} + 1")
    assert refusal(text).startswith(f"fact {fact['id']}: ")


@pytest.mark.parametrize(
    "path",
    [f"contexts/{k}/{part}/0" for k in (1, 2) for part in ("generators", "units", "relations")]
    + ["contexts/0/units/2", "contexts/1/nonnegative/0", "contexts/2/nonnegative/1"],
)
def test_both_checkers_refuse_a_dropped_hypothesis(excerpt, path):
    refusal(tampered(excerpt, path, GONE))


def test_its_modules_import_each_other_without_circles():
    """Imports that are there for types alone count as well."""
    rests_on = {
        path.stem: {
            *re.findall(r"from rigidsym\.proof\.checker\.(\w+) import", path.read_text("utf-8"))
        }
        for path in HOME.glob("*.py")
    }
    assert [*TopologicalSorter(rests_on).static_order()][-1] == "__init__"


def test_imports_neither_sympy_nor_the_rest_of_rigidsym():
    """Neither in its own text nor, by way of something else, when it runs."""
    allowed = sys.stdlib_module_names | {"flint", "rigidsym.proof.checker"}
    for file in HOME.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import | ast.ImportFrom):
                names = [alias.name for alias in node.names]
                for name in names if isinstance(node, ast.Import) else [str(node.module)]:
                    depth = 3 if name.startswith("rigidsym") else 1
                    assert ".".join(name.split(".")[:depth]) in allowed
    program = "import sys, rigidsym.proof.checker; print(*sys.modules)"
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    ours = {name for name in run.stdout.split() if name.split(".")[0] == "rigidsym"}
    around = ([], ["_version"], ["proof"], ["proof", "checker"])
    assert all(name.split(".")[1:3] in around for name in ours)
    assert not {"sympy", "mpmath", "numpy"} & {*run.stdout.split()}
