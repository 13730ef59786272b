"""No random edit that changes what a specified theorem says is accepted, by either checker.

A checker is its replay and what it requires: an edited ledger has to be refused by one of the two.
"""

from collections import Counter

import pytest
from document_texts import words
from edits import edited
from ledgers import LEDGER, TEXT, written

from rigidsym._cli import proofs
from rigidsym.io.ledger import specification_text
from rigidsym.language._specification import Unproved, require
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.checker import Refused, check
from rigidsym.proof.checker import require as require_again
from rigidsym.proof.kernel import KernelError, replay

SPECIFICATION = specification_text()
MANY = 2000


def by_the_kernel(ledger):
    """Decide as `rigidsym check` does, the quick part first."""
    require(SPECIFICATION, ledger)
    replay(written(ledger), encloses)


def by_the_other(ledger):
    """Decide as `rigidsym check --independent` does, the quick part first."""
    require_again(SPECIFICATION, ledger)
    check(written(ledger), SPECIFICATION)


REFUSALS = {by_the_kernel: (Unproved, KernelError), by_the_other: (Refused, LookupError)}


def accepted(seeds):
    """Describe the edits that a checker accepts."""
    found = []
    for seed in seeds:
        told, ledger = edited(TEXT, SPECIFICATION, seed)
        for decide, refusals in REFUSALS.items():
            try:
                decide(ledger)
            except refusals:
                continue
            found.append(f"{decide.__name__}: {told}")
    return found


@pytest.mark.usefixtures("replayed_once")
def test_the_ledger_itself_is_accepted(sealed_ledger):
    """Check the ledger as it is; kernel and second checker decide it once in this process."""
    require(SPECIFICATION, LEDGER)
    require_again(SPECIFICATION, LEDGER)
    assert sealed_ledger.to_text() == written(LEDGER) == proofs.replayed()


def test_edits_are_of_all_kinds():
    kinds = Counter(edited(TEXT, SPECIFICATION, seed)[0].split()[2] for seed in range(150))
    assert {"relations", "units", "nonnegative", "rates", "generators"} <= {*kinds}
    assert len(kinds) > 20


def test_no_random_edit_is_accepted():
    assert not accepted(range(24))


@pytest.mark.slow
@pytest.mark.parametrize("block", range(20))
def test_no_random_edit_of_many_is_accepted(block):
    each = MANY // 20
    assert not accepted(range(block * each, (block + 1) * each))


def test_the_page_says_how_many():
    assert f"A campaign makes {MANY} random edits" in words("trust.md")
