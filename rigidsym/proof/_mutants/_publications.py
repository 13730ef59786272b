"""Mutants of what a ledger says besides definitions: meanings, rates, and publications.

Each is the ledger as data, with all facts left in place: the kernel might accept fewer of them.
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import combinations
from random import Random
from typing import Any

from rigidsym.language._expression import Call, Expression, Number, Operation, parse, to_text
from rigidsym.proof._mutants._edits import Edit, double, partners, sign

Ledger = Mapping[str, Any]
SEED, PAIRS = 33, 100


def meanings(ledger: Ledger) -> Iterator[tuple[str, Ledger]]:
    """Yield ledgers with another meaning of one published name, or of two, drawn by a seed.

    A function has twice its argument or the opposite sign, or two names exchange their functions.
    """
    contexts = {context["name"]: context for context in ledger["contexts"]}
    published: dict[str, dict[str, str]] = {}
    for _, entries in _sequences(ledger):
        for entry in entries:
            if name := entry.get("reading"):
                text = contexts[entry["context"]]["reading"][name]
                published.setdefault(entry["context"], {})[name] = text
    seen, found = set(), dict[int, list[Any]]({1: [], 2: []})
    for readings in published.values():
        changes = {f"2 in {x}": {(x, text): doubled(text)} for x, text in readings.items()}
        changes |= {f"- {x}": {(x, text): f"-({text})"} for x, text in readings.items()}
        for one in readings:
            for other, _ in partners(one, readings):
                pair = (one, readings[one]), (other, readings[other])
                changes[f"<-> {one}, {other}"] = {pair[0]: pair[1][1], pair[1]: pair[0][1]}
        for count in (1, 2):
            for chosen in combinations(changes, count):
                texts = {place: text for told in chosen for place, text in changes[told].items()}
                if (key := frozenset(texts.items())) not in seen:
                    seen.add(key)
                    found[count].append((", ".join(chosen), texts))
    for told, texts in (*found[1], *Random(SEED).sample(found[2], PAIRS)):
        yield told, _rewritten(ledger, "reading", texts)


def rates(ledger: Ledger, names: Iterable[str]) -> Iterator[tuple[Edit, Ledger]]:
    """Yield changes of a time derivative in the named contexts, with the ledgers."""
    contexts = [context for context in ledger["contexts"] if context["name"] in {*names}]
    found = {pair for context in contexts for pair in (context["rates"] or {}).items()}
    for name, text in sorted(found):
        if text not in ("0", "?"):
            for edit in (sign((f"D({name})", text)), double((f"D({name})", text))):
                (changed,) = edit.texts.values()
                yield edit, _rewritten(ledger, "rates", {(name, text): changed})


def publications(ledger: Ledger) -> Iterator[tuple[str, Ledger]]:
    """Yield ledgers that do not publish an entry, or publish x = 1*x in its place.

    That is one entry, all of a sequence, all at once, or two entries of a sequence drawn by a seed.
    No fact can say x = 1*x of a name that has a meaning and no place in the context.
    """
    every = [(name, range(len(entries))) for name, entries in _sequences(ledger)]
    single = [(name, (place,)) for name, places in every for place in places]
    whole = [(name, (*places,)) for name, places in every]
    pairs = [(name, pair) for name, places in every for pair in combinations(places, 2)]
    for name, places in (*single, *whole, *Random(SEED).sample(pairs, PAIRS)):
        for kind, change in (("without", _without), ("hollow", _hollow)):
            changed = change(ledger, {name: {*places}})
            if changed["published"] != ledger["published"]:
                yield f"{kind} {', '.join(map(str, places))} of {name}", changed
    yield "hollow, all", _hollow(ledger, {name: {*places} for name, places in every})


def doubled(text: str) -> str:
    """Double the first argument of the innermost function in a meaning, or the whole meaning.

    >>> doubled("re(theta1(g*u_1, nome_1))"), doubled("pi/2")
    ('re(theta1(2 * (g * u_1), nome_1))', '2 * (pi / 2)')
    """
    changed = _within(parse(text))
    return to_text(changed or Operation("*", Number(2), parse(text)))


def _within(tree: Expression) -> Expression | None:
    match tree:
        case Operation(sign, left, right):
            if other := _within(left):
                return Operation(sign, other, right)
            return Operation(sign, left, other) if (other := _within(right)) else None
        case Call("neg" | "re" | "im" | "sqrt" as name, (argument,)):
            return Call(name, (other,)) if (other := _within(argument)) else None
        case Call(name, (argument, *others)):
            return Call(name, (Operation("*", Number(2), argument), *others))
    return None


def _rewritten(ledger: Ledger, column: str, texts: Mapping[tuple[str, str], str]) -> Ledger:
    contexts = [
        {**x, column: {n: texts.get((n, t), t) for n, t in x[column].items()}} if x[column] else x
        for x in ledger["contexts"]
    ]
    return {**ledger, "contexts": contexts}


def _sequences(ledger: Ledger) -> list[tuple[str, list[Any]]]:
    groups = (ledger["published"][group] for group in ("sequences", "forms"))
    return [pair for group in groups for pair in group.items()]


def _without(ledger: Ledger, places: Mapping[str, set[int]]) -> Ledger:
    def kept(name: str, entries: list[Any]) -> list[Any]:
        return [x for k, x in enumerate(entries) if k not in places.get(name, ())]

    return _republished(ledger, kept)


def _hollow(ledger: Ledger, places: Mapping[str, set[int]]) -> Ledger:
    contexts = {context["name"]: context for context in ledger["contexts"]}
    facts = {fact["id"]: fact for fact in ledger["facts"]}
    more: dict[str, Any] = {}

    def said(entry: Mapping[str, Any]) -> Mapping[str, Any]:
        if "fact" in entry:
            fact = facts[entry["fact"]]
            context, name = fact["context"], fact["lhs"][0]
        else:
            context, name = entry["context"], entry.get("definition", entry.get("reading"))
        there = contexts[context]
        if name not in {*there["generators"], *there["definitions"]}:
            return entry
        zeros = ["0" for _ in there["relations"]]
        fact = {
            "id": f"{context}.hollow_{name}",
            **{"context": context, "kind": "equal", "lhs": [name], "rhs": [f"1*{name}"]},
            **{"rule": "identity", "grade": "PROVED", "premises": [], "source": []},
            "certificate": {"cofactors": [zeros]},
        }
        more[fact["id"]] = fact
        return {"fact": fact["id"]}

    def emptied(name: str, entries: list[Any]) -> list[Any]:
        return [said(x) if k in places.get(name, ()) else x for k, x in enumerate(entries)]

    published = _republished(ledger, emptied)
    return {**published, "facts": [*ledger["facts"], *more.values()]}


def _republished(ledger: Ledger, change: Any) -> Ledger:
    published = dict(ledger["published"])
    for group in ("sequences", "forms"):
        published[group] = {name: change(name, x) for name, x in published[group].items()}
    return {**ledger, "published": published}
