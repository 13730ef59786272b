"""LaTeX of the ledger's expressions: read back it has the same value, and renderers read it."""

import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from ledgers import CONTEXTS
from matplotlib.mathtext import MathTextParser
from values import value_of

from rigidsym.language._expression import Call, Name, Number, Operation, children, parse, rebuild
from rigidsym.language._latex import (
    MOST_TERMS,
    condition,
    hypotheses,
    latex,
    of,
    statements,
    symbol,
)
from rigidsym.proof.claims import claims
from rigidsym.proof.paper import EQUATIONS

VALUES = {"a": Fraction(3, 7), "c_b": Fraction(-5, 2), "Omega1": Fraction(11, 3)}
VALUES |= {"sn": Fraction(2, 9), "y_star": Fraction(1, 6), "K_squared": Fraction(8, 5)}
BY_LATEX = {symbol(name).latex: value for name, value in VALUES.items()}
TOKEN = re.compile(
    r"\\left\(|\\right\)|\\frac|\\cdot|\\,|[+^{} -]|\d+|"
    + "|".join(map(re.escape, sorted(BY_LATEX, key=len, reverse=True)))
)
IN_PYTHON = {r"\left(": "(", r"\right)": ")", "{": "(", "}": ")", "^": "**", r"\frac": ""}


def evaluated(text):
    """Evaluate LaTeX of names with values: factors stand side by side, }{ is in a fraction."""
    tokens = TOKEN.findall(text)
    assert "".join(tokens) == text
    code, before = "", ""
    for token in tokens:
        if token in (" ", r"\,", r"\cdot"):
            continue
        is_number = token in BY_LATEX or token.isdigit()
        after_factor = before in (r"\right)", "}") or before in BY_LATEX or before.isdigit()
        if token == "{" and before == "}":
            code += "/"
        elif after_factor and (is_number or token in (r"\left(", r"\frac")):
            code += "*"
        code += f"values[{token!r}]" if is_number else IN_PYTHON.get(token, token)
        before = token
    values = BY_LATEX | {token: Fraction(token) for token in tokens if token.isdigit()}
    # Exponents are whole numbers; Fraction knows these as such.
    return eval(code, {"values": values})


leaves = st.one_of(st.integers(0, 9).map(Number), st.sampled_from([*VALUES]).map(Name))
expressions = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.builds(Operation, st.sampled_from("+-*/"), inner, inner),
        st.builds(lambda base, n: Operation("**", base, Number(n)), inner, st.integers(1, 4)),
        st.builds(lambda x: Call("neg", (x,)), inner),
    ),
    max_leaves=MOST_TERMS,
)


def exact(expression):
    """Replace whole numbers by names, so that quotients are exact; return their values, too."""
    if isinstance(expression, Number):
        name = f"number_{expression.value}"
        return Name(name), {name: Fraction(expression.value)}
    parts = [exact(part) for part in children(expression)]
    meaning = {name: number for _, known in parts for name, number in known.items()}
    return rebuild(expression, tuple(part for part, _ in parts)), meaning


@given(expressions)
def test_latex_says_what_the_expression_says(expression):
    named, meaning = exact(expression)
    try:
        found = value_of(named, VALUES | meaning)
    except ZeroDivisionError:
        return
    assert evaluated(of(expression)) == found


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("-1/2*q3**2*Omega1*c1", r"-\frac{1}{2} q_{3}^{2} c_{1} \Omega_{1}"),
        ("c1**1", "c_{1}"),
        ("D(Omega1)", r"\dot{\Omega}_{1}"),
        ("D(K_squared)", r"\frac{d}{dt} K^{2}"),
        ("D(a - b)", r"\frac{d}{dt}\left(a - b\right)"),
        ("K_squared**2", r"\left(K^{2}\right)^{2}"),
        ("sin_phi2**2*c1", r"c_{1} \sin^{2} \phi_{2}"),
        ("lambda_", r"\lambda"),
        ("lambda__squared", r"\lambda^{2}"),
        ("qbar_0", r"\bar{q}_{0}"),
        ("phi1_rate", r"\dot{\phi}_{1}"),
        ("P4_im", r"\operatorname{Im} P_{4}"),
        ("y_star", r"y^{\star}"),
        ("minus_s_i*2", r"2 \left(-s_{i}\right)"),
        ("am(u, m)", r"\mathrm{am}\left(u, m\right)"),
    ],
)  # fmt: skip
def test_examples(text, shown):
    assert latex(text) == shown


def test_long_sums_are_shown_in_part_and_say_so():
    long = latex(" + ".join(f"a*q{k}" for k in range(40)))
    assert r"\cdots" in long
    assert long.count("+") == MOST_TERMS - 1
    assert long.endswith("q_{39}")


@pytest.mark.parametrize("context", CONTEXTS)
def test_in_a_context_no_two_names_look_alike(context):
    names = [*CONTEXTS[context]["generators"], *CONTEXTS[context]["definitions"]]
    assert len({symbol(name).latex for name in names}) == len(names)


def parts(text):
    """Yield the parts of a formula that stand side by side."""
    begin = depth = 0
    for found in re.finditer(r"\\left\b|\\right\b|[{} ]", text):
        depth += {"\\left": 1, "{": 1, "\\right": -1, "}": -1}.get(found[0], 0)
        if found[0] == " " and depth == 0:
            yield text[begin : found.start()]
            begin = found.end()
    yield text[begin:]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"\frac{a b}{c} + x^{2 n}", [r"\frac{a b}{c}", "+", "x^{2 n}"]),
        (r"\left(a + b\right)^{2} c", [r"\left(a + b\right)^{2}", "c"]),
    ],
)
def test_parts(text, expected):
    assert [*parts(text)] == expected


def test_what_facts_state_and_suppose_can_be_rendered():
    reader, formulas = MathTextParser("path"), set()
    for claim in claims().values():
        formulas |= {*statements(claim.fact)}
        formulas |= {text for texts in hypotheses(claim.context).values() for text in texts}
    found = {part for text in formulas for part in parts(text) if len(part) < 250}
    # Every fourth, and of whole texts every twentieth: neighbours in this order are much alike.
    for part in sorted(found)[::4]:
        reader.parse(f"${part}$")
    for whole in sorted(text for text in formulas if len(text) < 250)[::20]:
        reader.parse(f"${whole}$")
    assert len(formulas) > 1000
    assert all(text.count("{") == text.count("}") for text in formulas)
    assert all(
        len(re.findall(r"\\left\b", t)) == len(re.findall(r"\\right\b", t)) for t in formulas
    )


def test_conditions_are_formulas_or_words():
    texts = [c.text for e in EQUATIONS for c in e.conditions]
    reader = MathTextParser("path")
    for text in texts:
        found = condition(text)
        assert found is None or reader.parse(f"${found}$")
    assert condition("c_i != c_j") == r"c_{i} \neq c_{j}"
    assert condition("R(0) M(0) = M(0) R(0)") is None
    assert condition("somewhere") is None


def test_what_is_no_expression_is_refused():
    with pytest.raises(ValueError, match="not part of an expression"):
        latex("a if b else c")
    with pytest.raises(TypeError, match="not an expression"):
        of(None)


def test_numbers_before_parsing_are_exact():
    assert parse("1/3") == Operation("/", Number(1), Number(3))
    assert latex("1/3") == r"\frac{1}{3}"
