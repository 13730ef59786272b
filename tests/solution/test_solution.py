"""The formulas as data: read from the ledger, refused where it does not prove them."""

import ast
import json
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import rigidsym
from rigidsym.errors import LedgerError
from rigidsym.language.expression import (
    Call,
    Name,
    Number,
    Operation,
    complement,
    evaluate,
    parse,
    to_text,
)
from rigidsym.solution import ledger_text, load, sealed

PACKAGE = Path(rigidsym.__path__[0])
LEDGER = json.loads(ledger_text())

leaves = st.one_of(st.integers(0, 9).map(Number), st.sampled_from("abc").map(Name))
expressions = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.builds(Operation, st.sampled_from("+-*/"), inner, inner),
        st.builds(lambda base, n: Operation("**", base, Number(n)), inner, st.integers(0, 4)),
        st.builds(lambda x: Call("neg", (x,)), inner),
        st.builds(lambda x, y: Call("f", (x, y)), inner, inner),
    ),
    max_leaves=12,
)


@given(expressions)
def test_text_and_tree_are_inverse(expression):
    assert parse(to_text(expression)) == expression


def test_evaluation_is_exact_over_rationals():
    values = {"a": Fraction(1, 3), "b": Fraction(2)}
    assert evaluate(parse("(a - b)**2/-a"), values, {}) == Fraction(-25, 3)


@pytest.mark.parametrize(
    "text", ["a if b else c", "a.b", "a[0]", "a == b", "f(x=1)", "1.5", "lambda: 1"]
)
def test_nothing_else_is_an_expression(text):
    with pytest.raises(ValueError, match="not part of an expression"):
        parse(text)


def test_complements_are_taken_off_not_computed():
    assert complement(parse("1 - m_c")) == Name("m_c")
    assert complement(Name("m")) == parse("1 - m")


def test_every_formula_is_a_proved_fact_or_a_reading():
    facts = {fact["id"]: fact for fact in LEDGER["facts"]}
    readings = {
        f"reading {context['name']}.{name}"
        for context in LEDGER["contexts"]
        for name in context["reading"]
    }
    for formulas in sealed().programmes.values():
        for formula in formulas:
            assert formula.fact in readings or facts[formula.fact]["grade"] == "PROVED"
            assert formula.source


def changed(**programmes):
    """The ledger with programmes of these facts."""
    listed = {name: [{"fact": fact} for fact in ids] for name, ids in programmes.items()}
    published = LEDGER["published"]
    programmes = {**published["programmes"], **listed}
    return json.dumps({**LEDGER, "published": {**published, "programmes": programmes}})


def unmodelled(context):
    """The ledger without what says that a context has models."""
    told = [f for f in LEDGER["facts"] if (f["kind"], f["rhs"]) != ("model", [context])]
    return json.dumps({**LEDGER, "facts": told})


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "not readable"),
        ("[]", "not readable"),
        ('{"facts": []}', "not readable"),
        (changed(state=["no.such"]), "not readable"),
        ('{"facts": [], "contexts": [], "published": {}}', "not readable"),
        (
            '{"facts": [], "contexts": [], "published": {"programmes": {}}}',
            "does not publish the programme plan",
        ),
        (ledger_text().replace("jacobi_argument(sn, cn, dn)", "2*sn"), "reading is not the one"),
        (
            ledger_text().replace("-gc*dtheta2(gc*beta", "g*dtheta2(gc*beta"),
            "hyperbolic_form:zeta: its reading is not the one",
        ),
        (unmodelled("regular"), "plan: no context is a model of all"),
        (unmodelled("theta_form"), "hyperbolic: no context is a model of all"),
        (changed(state=["regular.sn"]), "state: sn needs Omega_b"),
        (changed(state=["regular.euler"]), "not one proved formula"),
        (changed(state=["amplitude.printed"]), "not one proved formula"),
        (ledger_text().replace('"PROVED"', '"ASSUMED"'), "not one proved formula"),
    ],
)
def test_a_ledger_that_proves_less_is_refused(text, message):
    with pytest.raises(LedgerError, match=message):
        load(text)


NUMBER_WING = ("solution", "precise", "codegen", "validate", "generated", "engines", "pictures",
               "export", "manoeuvre")  # fmt: skip
ALLOWED = {
    "kernel": {"kernel"},
    "algebra": {"algebra", "kernel"},
    "display": {"display", "solution", "inputs", "errors"},
    "paper": {"paper", "display"},
    "export": {"export", "motion", "errors"},
    "manoeuvre": {"manoeuvre", "motion", "engines", "pictures", "solution", "quaternions"}
    | {"display", "errors", "executors", "export", "files", "inputs", "packages", "toml_file"},
    "pictures": {
        "pictures",
        "motion",
        "precise",
        "solution",
        "errors",
        "inputs",
        "packages",
        "quaternions",
    },
    "solution": {"solution", "errors"},
    "precise": {"precise", "solution", "errors", "inputs"},
    "codegen": {"codegen", "solution", "errors", "files"},
    "generated": set(),
    "engines": {"engines", "generated", "solution", "errors", "inputs", "files"},
    "validate": {"validate", "codegen", "engines", "motion", "precise", "solution", "generated"}
    | {"cases", "display", "errors", "executors", "files", "inputs", "plot"},
    "independent": {"independent"},
}


def imports(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)


@pytest.mark.parametrize("room", ALLOWED)
def test_imports_run_downwards_only(room):
    for path in (PACKAGE / room).rglob("*.py"):
        used = {name.split(".")[1] for name in imports(path) if name.startswith("rigidsym.")}
        assert used <= ALLOWED[room], path


@pytest.mark.parametrize("room", [*NUMBER_WING, "display"])
def test_the_number_wing_does_not_import_sympy_or_the_proofs(room):
    for path in (PACKAGE / room).rglob("*.py"):
        top = {name.split(".")[0] for name in imports(path)}
        assert not top & {"sympy", "derivations"}, path
