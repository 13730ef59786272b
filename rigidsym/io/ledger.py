"""Functions that read the installed ledger of proofs, its seal and its specification."""

import hashlib
import json
from importlib import resources
from typing import Any

from rigidsym.errors import LedgerError

SCHEMA = "rigidsym.ledger/4"
SEAL = "ledger.sha256"


def ledger_text() -> str:
    """Return the text of the installed ledger of proofs."""
    return _derived("ledger.json", "run `rigidsym derive --in-place` to write it")


def sealed_text() -> str:
    """Return the text of the installed ledger if it agrees with its seal.

    Certificates are not replayed for numbers: a digest that `rigidsym derive` leaves beside the
    ledger certifies that they were.  It detects accidental changes and edits by hand.  Raises
    LedgerError if the text and its seal disagree.
    """
    text = ledger_text()
    if seal(text) != _derived(SEAL, "run `rigidsym derive --in-place` to write it"):
        raise LedgerError(
            "ledger: not the text that was sealed: see `rigidsym check`, or write it again by "
            "`rigidsym derive --in-place`"
        )
    return text


def seal(text: str) -> str:
    """Return the text of a ledger's seal, which contains the ledger's SHA-256 digest."""
    return f"{hashlib.sha256(text.encode()).hexdigest()}  ledger.json\n"


def specification_text() -> str:
    """Return the text of the specification, which lists the theorems that a ledger must prove."""
    return _derived("specification.txt", "it comes with this package")


def _derived(name: str, advice: str) -> str:
    try:
        return resources.files("derivations").joinpath(name).read_text("utf-8")
    except (OSError, ModuleNotFoundError) as error:
        raise LedgerError(f"ledger: {error}: {advice}") from None


def ledger_data(text: str) -> dict[str, Any]:
    """Parse the text of a ledger.

    Raises LedgerError, with one line and the next step, for a text that is no ledger.  Whether its
    entries are in order is for checkers.
    """
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        raise _no_ledger("it is not JSON" if text.strip() else "it is empty") from None
    if not isinstance(data, dict):
        raise _no_ledger("it is JSON, but no object with contexts and facts")
    if data.get("schema", SCHEMA) != SCHEMA:
        raise _no_ledger(f"its schema is {data['schema']!a:.40}")
    for key, kind, what in (
        ("contexts", list, "list of contexts"),
        ("facts", list, "list of facts"),
        ("published", dict, "table of what is published"),
    ):
        if not isinstance(data.get(key), kind):
            raise _no_ledger(f"it has no {what}")
    for part, key in (("facts", "id"), ("contexts", "name")):
        for number, entry in enumerate(data[part]):
            if not isinstance(entry, dict) or not isinstance(entry.get(key), str):
                raise _no_ledger(f"{part}[{number}] has no {key}")
    return data


def _no_ledger(reason: str) -> LedgerError:
    told = f"ledger: not readable as {SCHEMA}: {reason}"
    return LedgerError(f"{told}: write one by `rigidsym derive -o FILE`")
