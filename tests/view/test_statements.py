"""Paragraphs say of a context all that it supposes, and of a fact where it comes from."""

import json

import pytest

from rigidsym.io.ledger import ledger_text
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._computation import compute, guess
from rigidsym.proof.kernel import Context
from rigidsym.proof.steps._names import symbols
from rigidsym.view._article import in_text
from rigidsym.view._statements import (
    _MOST_EXCEPTIONS,
    MOST_ROWS,
    described,
    introduction,
    items,
    stated,
    taken,
)


@pytest.fixture(scope="module")
def contexts():
    """Return the contexts of the sealed ledger."""
    return [
        Context(**{k: tuple(v) if isinstance(v, list) else v for k, v in context.items()})
        for context in json.loads(ledger_text())["contexts"]
    ]


def test_bases_exceptions_and_what_is_new_are_the_whole_context(contexts):
    by_bases = exceptions = 0
    for k, context in enumerate(contexts):
        found = described(context, contexts[:k])
        said = set(found.new)
        if found.bases:
            said |= taken(found.bases[0], found.names) - {*found.conditions}
            said |= {item for base in found.bases[1:] for item in items(base)}
        assert {*items(context)} <= said, context.name
        # At an instant, nothing is said of rates; a meaning may be that of the earlier context.
        for kind, *rest in said - {*items(context)}:
            at_rest = kind == "rate" and context.rates is None
            kept = kind == "meaning" and rest[0] not in context.reading
            assert at_rest or kept, (context.name, kind, rest)
        assert len(found.names) + len(found.conditions) <= _MOST_EXCEPTIONS
        by_bases += bool(found.bases)
        exceptions += bool(found.names or found.conditions)
    assert by_bases > 100
    assert exceptions > 20


def test_what_moves_here_and_was_constant_before_is_an_exception():
    point = dict.fromkeys("abcdefgh", "1")
    before = join("before", Part(witness=point, rates={"a": "b"}))
    after = join("after", Part(witness=point, rates={"a": "b", "c": "a"}))
    assert described(after, [before]).names == ("c",)
    assert ("rate", "c", "a") in described(after, [before]).new


def test_another_meaning_is_an_exception_and_a_missing_one_is_not():
    point = dict.fromkeys("abcdefgh", "1")
    before = join("before", Part(witness=point, reading={"a": "one thing"}))
    other = join("other", Part(witness=point, reading={"a": "another thing"}))
    silent = join("silent", Part(witness=point))
    assert described(other, [before]).names == ("a",)
    assert described(silent, [before]).names == ()


def told(context, *known):
    return "\n".join(
        " ".join(in_text(words) for words in (paragraph.sentence, *paragraph.entries))
        + "\n".join(["", *paragraph.texts, *map(in_text, paragraph.after)])
        for paragraph in introduction(context, known)
    )


def test_an_introduction_has_every_name_and_hypothesis():
    x, y = symbols("x y")
    part = Part(
        witness={"x": "2", "y": "1", "z": "1"},
        units=("x",),
        definitions={"double": compute(x + y).subs(y, x), "other": "x + 1"},
        relations=("y**2 - 1",),
        rates={"x": "y", "z": "?"},
        nonnegative=("x + y",),
        reading={"x": "length, m", "y": "cos(phi)"},
    )
    text = told(join("example", part))
    for said in (
        "x: length, m",
        "y = cos(phi)",
        "z and phi are arbitrary",
        "double = 2*x",
        "Computed: double by subs.",
        "y**2 - 1 = 0",
        "x != 0",
        "x + y >= 0",
        "D(x) = y",
        "Nothing is said on the rates of z",
    ):
        assert said in text, said
    assert "other by" not in text


def opened():
    builder = LedgerBuilder()
    part = Part(witness={"x": "1", "y": "1"}, relations=("y**2 - x**2",), nonnegative=("y",))
    builder.open(join("plane", part, static=True))
    return builder


def said_of(builder, fact):
    return stated(fact, builder.ledger.contexts[fact.context], set())


def test_a_fact_says_where_it_comes_from_and_what_it_uses():
    (x,) = symbols("x")
    builder = opened()
    computed = builder.claim("plane.a", {"(x + 1)**2": compute((x + 1) ** 2).expand()}, ["4"])
    typed = builder.claim("plane.b", {"y**2 + 1": "x**2 + 1"})
    why = guess("x**2 + 2", "no step finds it")
    guessed = builder.claim("plane.c", [("y**2 + 2", why)])
    false = builder.refute("plane.d", {"x": "2*x"}, {"x": "3", "y": "3"})
    assert in_text(said_of(builder, computed).sentence) == "Computed by expand:"
    assert said_of(builder, computed).numbers == "(4)"
    assert said_of(builder, computed).after == ()
    assert in_text(said_of(builder, typed).sentence) == "Proved:"
    assert in_text(said_of(builder, typed).after[0]) == "This uses y**2 - x**2 = 0."
    assert in_text(said_of(builder, guessed).sentence) == (
        "Typed, and then proved (no step finds it):"
    )
    assert in_text(said_of(builder, false).sentence) == "This does not hold:"
    assert in_text(said_of(builder, false).after[0]) == "It fails at x = 3, y = 3."
    assert said_of(builder, false).texts == ("x != 2*x",)


def test_more_components_than_fit_are_counted():
    builder = opened()
    pairs = {f"{k}*y**2": f"{k}*x**2" for k in range(1, MOST_ROWS + 6)}
    found = said_of(builder, builder.claim("plane.many", pairs))
    assert len(found.rows) == MOST_ROWS
    assert in_text(found.after[0]) == "And 5 more components."
