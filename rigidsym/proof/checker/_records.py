"""Parser of ledger files into records of contexts and facts.

A ledger file is JSON of one exact shape and spelling.
"""

import json
from dataclasses import dataclass, fields
from typing import Any, TypeVar

SCHEMA = "rigidsym.ledger/4"
KEYS = ["schema", "contexts", "facts", "published"]


class Refused(ValueError):  # noqa: N818 (a verdict rather than an error)
    """Error for a ledger that the checker refuses.

    The message says in one line where the ledger is wrong and why.
    """


@dataclass(frozen=True, slots=True)
class Hypotheses:
    """The names and hypotheses of a context, as recorded in a ledger file."""

    name: str
    generators: list[str]
    witness: dict[str, str]
    units: list[str]
    definitions: dict[str, str]
    relations: list[str]
    rates: dict[str, str] | None
    nonnegative: list[str]
    start: list[str]
    thetas: dict[str, str]
    reading: dict[str, str]


@dataclass(frozen=True, slots=True)
class Claim:
    """A fact that a ledger file claims, with its rule, premises and certificate.

    The rule decides what its certificate must hold.
    """

    id: str
    context: str
    kind: str
    lhs: list[str]
    rhs: list[str]
    rule: str
    grade: str
    premises: list[str]
    source: list[str]
    certificate: dict[str, Any]


Record = TypeVar("Record", Hypotheses, Claim)


def fits(value: object, kind: object) -> bool:
    """Return whether a JSON value has the type of a given record field."""
    if kind == list[str]:
        return isinstance(value, list) and all(isinstance(item, str) for item in value)
    if kind == dict[str, str]:
        return isinstance(value, dict) and fits([*value.values()], list[str])
    if kind == dict[str, str] | None:
        return value is None or fits(value, dict[str, str])
    return isinstance(value, str if kind is str else dict)


def fill(kind: type[Record], entry: object) -> Record:
    """Convert a JSON entry to a record.

    Raises Refused unless the fields and their types match exactly.
    """
    if not isinstance(entry, dict) or [*entry] != [field.name for field in fields(kind)]:
        raise Refused("not the fields that the schema gives it")
    if wrong := [field.name for field in fields(kind) if not fits(entry[field.name], field.type)]:
        raise Refused(f"{wrong[0]} has the wrong type")
    return kind(**entry)


def load(text: str) -> tuple[list[object], list[object], dict[str, Any]]:
    """Load a ledger file and check its JSON format.

    Returns the contexts and facts as JSON data, and the published index.
    """
    data = json.loads(text, object_pairs_hook=_once)
    if not isinstance(data, dict) or [*data] != KEYS or data["schema"] != SCHEMA:
        raise Refused(f"not a ledger of schema {SCHEMA}")
    lists = data["contexts"], data["facts"]
    if not isinstance(data["published"], dict):
        raise Refused("published is not an index")
    if not all(isinstance(entries, list) for entries in lists):
        raise Refused("contexts and facts are not lists")
    if json.dumps(data, indent=1, ensure_ascii=False) + "\n" != text:
        raise Refused("not spelled as ledgers are")
    return *lists, data["published"]


def _once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    if len(table := dict(pairs)) < len(pairs):
        raise Refused("an object gives a key twice")
    return table
