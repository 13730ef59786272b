"""Random edits of a ledger that change the meaning of a specified theorem.

An edit changes one expression to another, drops a hypothesis or adds one: in the contexts of the
theorems, in a definition wherever it stands, or in all facts that state what a theorem does.
"""

import json
import re
from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any

from rigidsym.language._specification import Proved, theorems
from rigidsym.proof.kernel import KernelError
from rigidsym.proof.kernel._language import parse

_TOKEN = re.compile(r"[A-Za-z_][A-Za-z_0-9]*|[0-9]+|\*\*|[-+*/()]")
_OTHER = {"+": "-", "-": "+", "*": "+", "/": "*"}
_LISTS = ("generators", "units", "relations", "nonnegative")


def edited(text: str, specification: str, seed: int) -> tuple[str, Any]:
    """Return a random edit of a ledger: its description, and the edited ledger as data."""
    random, data = Random(seed), json.loads(text)
    while True:
        kind = random.choice([_hypothesis, _meaning, _statement])
        if told := kind(data, specification, random):
            return f"seed {seed}: {told}", data


def changed(text: str, names: list[str], random: Random) -> str:
    """Return an expression with one name, number, sign, power or factor changed at random."""
    tokens = [*_TOKEN.finditer(text)]
    while True:
        token = random.choice(tokens)
        old, start, end = token[0], token.start(), token.end()
        if random.random() < 0.2:
            new = f"{random.choice(['2*', '-', '3 + '])}({text})"
        elif old.isdigit():
            new = f"{text[:start]}{int(old) + random.choice([1, 2, 7])}{text[end:]}"
        elif old in _OTHER:
            new = f"{text[:start]}{_OTHER[old]}{text[end:]}"
        elif old == "**":
            new = re.sub(r"\*\*\d+", "", text, count=1)
        else:
            new = f"{text[:start]}{random.choice(names)}{text[end:]}"
        if _another(text, new):
            return new


def _another(text: str, new: str) -> bool:
    try:
        return parse(new) != parse(text)
    except KernelError:
        return False


def _context(data: Any, specification: str, random: Random) -> Any:
    named = theorems(specification)
    return random.choice([entry for entry in data["contexts"] if entry["name"] in named])


def _hypothesis(data: Any, specification: str, random: Random) -> str:
    """Drop, add or change a hypothesis of a theorem."""
    context = _context(data, specification, random)
    field = random.choice([*_LISTS, "rates"])
    items, names = context[field], [*context["generators"], *context["definitions"]]
    if field == "rates":
        items = context["rates"] = items or {}
        name = random.choice(context["generators"])
        old = items.get(name, "0")
        items[name] = changed(old, names, random) if old != "?" else "0"
    elif not items or random.random() < 0.3:
        items.append(f"{random.choice(names)}_more" if field == "generators" else names[0] + " + 7")
    elif random.random() < 0.4:
        del items[random.randrange(len(items))]
    elif field == "generators":
        items[random.randrange(len(items))] += "_other"
    else:
        place = random.randrange(len(items))
        items[place] = changed(items[place], names, random)
    return f"{field} of {context['name']}"


def _meaning(data: Any, specification: str, random: Random) -> str:
    """Change a definition in all contexts that have it and in all facts that restate it."""
    context = _context(data, specification, random)
    if not context["definitions"]:
        return ""
    name, text = random.choice([*context["definitions"].items()])
    new = changed(text, context["generators"], random)
    for entry in data["contexts"]:
        if entry["definitions"].get(name) == text:
            entry["definitions"][name] = new
    _restate(data, lambda lhs, rhs: (lhs, new) if (lhs, rhs) == (name, text) else (lhs, rhs))
    return f"{name} = {new:.60}"


def _statement(data: Any, specification: str, random: Random) -> str:
    """Change one side of an equation of a theorem, in all facts that state the equation."""
    pairs = _required(json.dumps(data), specification)
    lhs, rhs = random.choice(pairs)
    names = [token for token in _TOKEN.findall(lhs + rhs) if token[0].isalpha() and token != "D"]
    new = (lhs, changed(rhs, [*names, "t"], random))
    _restate(data, lambda *pair: new if pair == (lhs, rhs) else pair)
    return f"{lhs:.40} = {new[1]:.60}"


@cache
def _required(text: str, specification: str) -> list[tuple[str, str]]:
    """Return both sides of the equations of facts that are equations of theorems."""
    ledger = Proved(json.loads(text))
    found = set()
    for theorem in theorems(specification).values():
        values = ledger.values(theorem)
        stated = {values.said(statement) for statement in theorem.then}
        places = ledger.modelled(theorem.name)
        for fact in ledger.proved:
            if fact["kind"] in ("equal", "root") and fact["context"] in places:
                relation = "sqrt" if fact["kind"] == "root" else "="
                for pair in zip(fact["lhs"], fact["rhs"], strict=True):
                    if values.said((relation, *pair)) in stated:
                        found.add(pair)
    return sorted(found)


def _restate(data: Any, change: Callable[[str, str], tuple[str, str]]) -> None:
    for fact in data["facts"]:
        if fact["kind"] in ("equal", "root"):
            pairs = [change(*pair) for pair in zip(fact["lhs"], fact["rhs"], strict=True)]
            fact["lhs"], fact["rhs"] = ([*side] for side in zip(*pairs, strict=True))
