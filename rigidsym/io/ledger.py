"""Functions that read the installed ledger of proofs, its seal and its specification."""

import hashlib
import json
from importlib import resources
from typing import Any

from rigidsym.errors import LedgerError

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

    Raises LedgerError unless it has facts and contexts.
    """
    try:
        data = json.loads(text)
        for part, key in (("facts", "id"), ("contexts", "name")):
            if any(not isinstance(entry[key], str) for entry in data[part]):
                raise LedgerError(f"ledger: {part} have no {key}")
    except (KeyError, TypeError, json.JSONDecodeError) as error:
        raise LedgerError(f"ledger: not readable as rigidsym.ledger/4: {error!r}") from None
    return data
