"""The differential ring against SymPy's calculus, and the kernel's size and imports."""

import ast
import re
import sys
from pathlib import Path

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

import rigidsym.proof.kernel
from rigidsym.proof.algebra._builder import text as spelled
from rigidsym.proof.kernel import Context

RATES = {"x": "y/u", "y": "x**2 - u", "u": "-y"}
RING = Context(
    "motion",
    ("x", "y", "u", "k"),
    {"x": "1", "y": "2", "u": "3", "k": "5"},
    units=("u", "1 + x**2"),
    rates=RATES,
).open()
SYMBOLS = {name: sympy.Symbol(name) for name in "xyuk"}


def binary(left):
    pairs = st.tuples(left, left)
    return st.one_of(
        pairs.map(lambda p: f"({p[0]} + {p[1]})"),
        pairs.map(lambda p: f"({p[0]} - {p[1]})"),
        pairs.map(lambda p: f"({p[0]})*({p[1]})"),
        left.map(lambda a: f"({a})/u"),
        left.map(lambda a: f"({a})/(3*u*(1 + x**2))"),
        left.map(lambda a: f"(-({a}))**2"),
    )


leaves = st.sampled_from(list("xyuk")) | st.integers(-3, 3).map(lambda n: f"({n})")
texts = st.recursive(leaves, binary, max_leaves=5)
fixed = settings(max_examples=60, deadline=None, derandomize=True, database=None)


def by_sympy(text: str) -> sympy.Expr:
    return sympy.parse_expr(text, local_dict=SYMBOLS)


def same(element, expression) -> bool:
    """Return whether an element and an expression are one rational function, by SymPy."""
    return sympy.cancel(by_sympy(spelled(element)) - expression) == 0


@fixed
@given(texts)
def test_reading_agrees_with_sympy(text):
    assert same(RING.read(text), by_sympy(text))


@fixed
@given(texts)
def test_the_rate_is_the_chain_rule_of_sympy(text):
    expression = by_sympy(text)
    chain = sum(
        sympy.diff(expression, SYMBOLS[name]) * by_sympy(rate) for name, rate in RATES.items()
    )
    assert same(RING.read(f"D({text})"), chain)


@fixed
@given(texts, texts)
def test_the_rate_obeys_leibniz(a, b):
    assert not RING.read(f"D(({a})*({b})) - (D({a})*({b}) + ({a})*D({b}))").numerator


@fixed
@given(texts)
def test_printing_and_reading_again_changes_nothing(text):
    element = RING.read(text)
    again = RING.read(spelled(element))
    assert again.numerator == element.numerator
    assert again.below == (element.below if element.numerator else {})  # 0/u prints as 0


def test_elements_are_exact():
    assert not RING.read("(10**30 + 1)*(10**30 - 1) - (10**60 - 1)").numerator
    assert RING.read("1/3 - 3333333333333333/10000000000000000").numerator


FILES = sorted(Path(rigidsym.proof.kernel.__file__).parent.glob("*.py"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_kernel_imports_only_polynomials_and_the_standard_library(path):
    imported = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0
            imported.add(node.module or "")
    foreign = {
        module
        for module in imported
        if module.split(".")[0] not in sys.stdlib_module_names
        and not f"{module}.".startswith(("sympy.polys.", "rigidsym.proof.kernel."))
    }
    assert not foreign


def own(path):
    """Return the name of a kernel module without its underscore."""
    return path.stem if path.stem == "__init__" else path.stem.removeprefix("_")


def test_each_module_rests_on_those_that_are_read_before_it():
    """Imports for type checkers count as well."""
    order = re.findall(r"`(\w+)`", rigidsym.proof.kernel.__doc__.split("in this order:")[1])
    assert {*order, "__init__"} == {own(path) for path in FILES}
    for path in FILES:
        found = re.findall(
            r"^ *from rigidsym\.proof\.kernel\._(\w+) import", path.read_text("utf-8"), re.M
        )
        assert {*found} <= {*order[: [*order, "__init__"].index(own(path))]}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_kernel_runs_no_text_as_code(path):
    called = {
        node.func.id
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }
    assert not called & {"eval", "exec", "compile", "__import__", "sympify"}


def test_the_kernel_can_be_read_in_one_sitting():
    lines = {own(path): len(path.read_text("utf-8").splitlines()) for path in FILES}
    assert lines.pop("theta") <= 213
    assert sum(lines.values()) <= 658
