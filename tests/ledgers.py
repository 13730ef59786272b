"""Ledgers for tests: facts decided in any ledger, and ledgers written without asking the kernel."""

import json
from collections.abc import Iterable
from typing import Any

from rigidsym.algebra import Book
from rigidsym.kernel import Context, Fact, Ledger


def prove(ledger: Ledger, fact: Fact) -> Fact:
    """Admit an identity with the cofactors of its normal form, as a book does."""
    book = Book()
    book.ledger = ledger
    return book._decide(fact)


def written(data: Any) -> str:
    """JSON as ledgers are spelled."""
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def unchecked(contexts: Iterable[Context], facts: Iterable[Fact]) -> str:
    """The text of a ledger that nobody has checked."""
    return Ledger(
        contexts={context.name: context for context in contexts},
        facts={fact.id: fact for fact in facts},
    ).to_text()
