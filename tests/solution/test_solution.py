"""Formulas of the solution: read from the ledger, or refused where it does not prove them."""

import json
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from ledgers import CONTEXTS, FACTS, LEDGER, TEXT
from values import value_of

from rigidsym.errors import LedgerError
from rigidsym.language._expression import Call, Name, Number, Operation, complement, parse, to_text
from rigidsym.language._sequence import FormulaSequence
from rigidsym.language._specification import sequences
from rigidsym.solution import load, sealed

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
    assert value_of(parse("(a - b)**2/-a"), values, {}) == Fraction(-25, 3)


@pytest.mark.parametrize(
    "text", ["a if b else c", "a.b", "a[0]", "a == b", "f(x=1)", "1.5", "lambda: 1"]
)
def test_nothing_else_is_an_expression(text):
    with pytest.raises(ValueError, match="not part of an expression"):
        parse(text)


def test_inputs_are_the_names_that_are_used_and_not_set():
    formulas = FormulaSequence([("x", parse("a + pi")), ("y", parse("x*b + I"))])
    assert formulas.inputs == {"a", "b"}


def test_complements_are_taken_off_not_computed():
    assert complement(parse("1 - m_c")) == Name("m_c")
    assert complement(Name("m")) == parse("1 - m")


def test_every_formula_is_a_proved_fact_a_definition_a_reading_or_a_choice():
    kinds = set()
    for sequence, formula in ((n, f) for n, every in sealed().sequences.items() for f in every):
        kind, _, place = formula.fact.rpartition(" ")
        kinds.add(kind)
        context, name = place.split(".")
        assert formula.context == context
        assert formula.source or sequence == "decisions"
        if kind == "definition":
            assert formula.name == name
            assert formula.expression == parse(CONTEXTS[context]["definitions"][name])
        elif kind == "reading":
            assert name in CONTEXTS[context]["reading"]
        elif kind == "choice":
            assert any(text.startswith(f"{name}*") for text in CONTEXTS[context]["nonnegative"])
        else:
            assert FACTS[place]["grade"] == "PROVED"
            assert FACTS[place]["context"] == context
    assert kinds == {"", "definition", "reading", "choice"}


def test_no_published_fact_restates_a_definition():
    """Check that definitions of contexts are published as definitions, not as facts."""
    for entry in (e for entries in sequences(LEDGER).values() for e in entries if "fact" in e):
        fact = FACTS[entry["fact"]]
        (name,), (text,) = fact["lhs"], fact["rhs"]
        assert CONTEXTS[fact["context"]]["definitions"].get(name) != text, fact["id"]


def defined(context, name):
    """Return the published entry of a definition."""
    return {"context": context, "definition": name, "source": ["1"]}


def changed(**sequences):
    """Return the ledger with other formula sequences, of these facts or entries."""
    listed = {
        name: [{"fact": entry} if isinstance(entry, str) else entry for entry in entries]
        for name, entries in sequences.items()
    }
    published = LEDGER["published"]
    sequences = {**published["sequences"], **listed}
    return json.dumps({**LEDGER, "published": {**published, "sequences": sequences}})


def unmodelled(context):
    """Return the ledger without the facts that a context has models."""
    told = [f for f in LEDGER["facts"] if (f["kind"], f["rhs"]) != ("model", [context])]
    return json.dumps({**LEDGER, "facts": told})


EMPTY = '{"facts": [], "contexts": [], "published": %s}'
UNREADABLE = ["{", "[]", '{"facts": []}', changed(state=["no.such"])]
UNREADABLE += [
    changed(state=[entry])
    for entry in (
        defined("descended", "no_such"),
        defined("nowhere", "u_1"),
        {"context": "descended", "definition": "u_1"},
    )
]
UNPROVED = [changed(state=[fact]) for fact in ("regular.euler", "start.principal_value")]
UNPROVED.append(TEXT.replace('"PROVED"', '"ASSUMED"'))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        *((text, "not readable") for text in UNREADABLE),
        *((text, "not one proved formula") for text in UNPROVED),
        *(
            (EMPTY % published, "does not publish the formula sequence constants")
            for published in ("{}", '{"sequences": {}}')
        ),
        (TEXT.replace("jacobi_argument(sn, cn, dn)", "2*sn"), "reading is not the one"),
        (
            TEXT.replace("-gc*dtheta2(gc*beta", "g*dtheta2(gc*beta"),
            "hyperbolic_form:zeta: its reading is not the one",
        ),
        (unmodelled("regular"), "constants: no context is a model of all"),
        (unmodelled("theta_form"), "hyperbolic: no context is a model of all"),
        (changed(state=["regular.sn"]), "state: sn needs Omega_b"),
        (changed(state=[defined("descended", "sn")]), "state: sn needs s"),
        (
            changed(state=[defined("descended", "u_1"), defined("any_motion", "c_ab")]),
            "state: no context is a model of all",
        ),
    ],
)
def test_a_ledger_that_proves_less_is_refused(text, message):
    with pytest.raises(LedgerError, match=message):
        load(text)
