"""Helpers for tests of ledgers: proofs of facts, unchecked ledgers, and tampering."""

import json
from collections.abc import Iterable
from functools import cache
from typing import Any

import pytest

from rigidsym.io.ledger import ledger_text
from rigidsym.language._expression import (
    Call,
    Expression,
    Number,
    Operation,
    children,
    parse,
    rebuild,
    to_text,
)
from rigidsym.proof._mutants import Edit, Forger, sign, turn
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.checker import Refused, check
from rigidsym.proof.kernel import Context, Fact, KernelError, Ledger, replay

# The sealed ledger.  Tests leave these as they are; for changes they take `json.loads(TEXT)`.
TEXT = ledger_text()
LEDGER = json.loads(TEXT)
CONTEXTS = {context["name"]: context for context in LEDGER["contexts"]}
FACTS = {fact["id"]: fact for fact in LEDGER["facts"]}


def defined(context: str, *names: str) -> list[tuple[str, str]]:
    """Return definitions of a context, each with its name."""
    return [(name, CONTEXTS[context]["definitions"][name]) for name in names]


# What an outside attack changed together; `forger().forge(OUTSIDE[name])` is the forged ledger.
OUTSIDE: dict[str, list[Edit]] = {
    "step": [*map(sign, defined("step", "f", "g"))],
    "doubling": [*map(sign, defined("doubling", "X_next", "Y_next"))],
    "second_half": [turn(*defined("second_half", "V_re", "V_im"))],
    "kick": [*map(sign, defined("kick", "v1", "v2", "v3"))],
    "thirds": [turn(*defined("thirds", "cos_half_psi", "sin_half_psi"))],
}


@cache
def forger() -> Forger:
    """Return a forger of ledgers from the sealed one."""
    return Forger(TEXT)


def prove(ledger: Ledger, fact: Fact) -> Fact:
    """Add an identity to a ledger, with cofactors computed as the builder does."""
    builder = LedgerBuilder()
    builder.ledger = ledger
    return builder.decide(fact)


def written(data: Any) -> str:
    """Return data as JSON text in the format of ledgers."""
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def unchecked(contexts: Iterable[Context], facts: Iterable[Fact]) -> str:
    """Return the text of a ledger from contexts and facts that nothing has checked."""
    return Ledger(
        contexts={context.name: context for context in contexts},
        facts={fact.id: fact for fact in facts},
    ).to_text()


def hollow() -> Any:
    """Return the sealed ledger with every formula of a fact it publishes replaced by x = 1*x."""
    ledger = json.loads(TEXT)
    entries = [x for group in ("sequences", "forms") for x in ledger["published"][group].values()]
    named = {entry["fact"] for sequence in entries for entry in sequence if "fact" in entry}
    for fact in ledger["facts"]:
        if fact["id"] in named and fact["kind"] == "equal":
            fact["rhs"] = [f"1*{x}" for x in fact["lhs"]]
    return ledger


@cache
def doubled_meanings() -> dict[str, Any]:
    """Return a ledger for each published meaning, with the first argument of its calls doubled."""
    published = LEDGER["published"]
    entries = [x for group in ("sequences", "forms") for x in published[group].values()]
    named = [(e["context"], e["reading"]) for x in entries for e in x if "reading" in e]
    found = {}
    for context, name in named:
        text = CONTEXTS[context]["reading"][name]
        changed = _doubled(parse(text))
        if changed != parse(text):
            ledger = {**LEDGER, "contexts": [*LEDGER["contexts"]]}
            place = ledger["contexts"].index(CONTEXTS[context])
            reading = {**CONTEXTS[context]["reading"], name: to_text(changed)}
            ledger["contexts"][place] = {**CONTEXTS[context], "reading": reading}
            found[f"{context}.{name}"] = ledger
    return found


def _doubled(expression: Expression) -> Expression:
    """Double the first argument of the innermost calls of an expression."""
    parts = tuple(map(_doubled, children(expression)))
    changed = rebuild(expression, parts)
    if parts == children(expression) and isinstance(expression, Call) and parts:
        first = Operation("*", Number(2), parts[0])
        return Call(expression.function, (first, *parts[1:]))
    return changed


GONE = object()


def tampered(text: str, path: str, value: Any) -> str:
    """Return the text of a ledger with one entry changed.

    The entry at the path is replaced by a value, removed (GONE), or copied to the end of its list
    (+).
    """
    data = place = json.loads(text)
    *outer, last = [int(key) if key.isdigit() else key for key in path.split("/")]
    for key in outer:
        place = place[key]
    if value is GONE:
        del place[last]
    elif last == "+":
        place.append(place[value])
    else:
        assert not isinstance(last, str) or place.get(last, GONE) != value
        place[last] = value
    return written(data)


def both_refuse(text: str, match: str | None = None) -> str:
    """Assert that kernel and second checker reject a ledger; return the checker's message.

    Both messages are one line of printable ASCII.
    """
    with pytest.raises(KernelError, match=match) as first:
        replay(text)
    with pytest.raises(Refused, match=match) as second:
        check(text)
    for refusal in (first, second):
        assert str(refusal.value).isascii()
        assert str(refusal.value).isprintable()
    return str(second.value)


# No names of contexts and quantities: D is d/dt, and the rest are other letters or none.
NO_NAMES = [
    *("", " ", "x ", "x y", "x-y", "1x", "x#", "x\n", "\x1b[2Kx", "x\u200b", "\u202ex"),
    *("\U0001d431", "\u0445", "\uff58", "\ufb01", "x\u0301", "if", "True", "lambda", "D"),
    *("\u00b2", "x\u0661"),
]
# What the grammar of `rigidsym.proof.kernel._language` refuses, though Python, or one of two
# readers, may take it for x, a number or a name; x is a name wherever these are read.
NOT_EXPRESSIONS = [
    *("x # **2 + 5", "x #", "\U0001d431", "\uff58", "\u0445", "x\u0661", "\u0661", "1_000", "0x10"),
    *("0b1", "0o7", "00", "01", "1.", "1e1", "1j", "1x", "x**True", "x**-1", "x**+1", "x**1_0"),
    *("x**x", "x**(2)", "x**2**3", "x**1.0", "+x", "x + +x", "x//1", "x***2", "x* *2", "x/ /2"),
    *(" x", "x ", "\tx", "x\t+ x", "(x\n+ x)", "x\\\n+ x", "x\r", "x\x0c", "x\x00", "x\u00a0"),
    *("x;", "D(x,)", "D(x, x)", "D()", "(D)(x)", "(D(x)", "D(x))", "D(*x)", "D(x=x)", "D(x)(x)"),
    *("x(x)", "(x, x)", "(x,)", "x, x", "()", "", " ", "x y", "1 0", "x 1", "(x)(x)", "x(", "True"),
    *("if", "lambda", "None", "not x", "x if x else x", "x and x", "x is x", "[x]", "{x}", "x.x"),
    *("x[0]", "'x'", "x!", "x == x", "x := x", "(x := x)", "x @ x", "x % x", "x ^ x", "x | x"),
    *("~x", "$x", "x +", "x.real", "1.0", "x < x", "lambda: x", "x()", "x**1.5", "2**10**9"),
    *(
        "x**(1 + 1)",
        "\x00",
        "\ud800",
        "1" * 5000,
        "(" * 1000,
        "-" * 100_000 + "x",
        "x" + "+x" * 100_000,
    ),
    *("(" * 51 + "x" + ")" * 51, "-" * 51 + "x", "-(" * 26 + "x" + ")" * 26, "9" * 1001),
    "x" + " + x" * 5000,
]
# What the grammar takes, and what has no meaning where x is a quantity without a value.
MEANINGLESS = [
    *("abs(x)", "D", "unknown", "1/0", "1/(x - x)", "x/(x - 1)", "0**0", "x**0"),
]
# What both readers take, up to the limits.
EXPRESSIONS = [
    *(
        "x",
        "x + x",
        "x+x",
        "x  -  x",
        "(x)",
        "((x))",
        "-x",
        "--x",
        "- x",
        "x - -x",
        "x*-x",
        "-x**2",
    ),
    *("D(x)", "D (x)", "D( x )", "x**64", "x ** 2", "0", "10", "2/3", "x*x*x"),
    *("(" * 50 + "x" + ")" * 50, "-" * 50 + "x", "9" * 1000, "x" + " + x" * 4999),
]
