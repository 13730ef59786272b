"""Numbers are computed from the sealed ledger only."""

import json
from importlib import resources

import pytest

from rigidsym._cli import main
from rigidsym.errors import LedgerError
from rigidsym.io.ledger import SEAL, ledger_text, seal, sealed_text
from rigidsym.solution import _formulas as formulas


@pytest.fixture
def changed(monkeypatch):
    """Empty a proof in the ledger, which no checker would accept."""
    data = json.loads(ledger_text())
    (fact,) = (fact for fact in data["facts"] if fact["id"] == "attitude.solution")
    assert any(term != "0" for row in fact["certificate"]["cofactors"] for term in row)
    fact["certificate"]["cofactors"] = [["0" for _ in x] for x in fact["certificate"]["cofactors"]]
    text = json.dumps(data, indent=1)
    monkeypatch.setattr("rigidsym.io.ledger.ledger_text", lambda: text)
    formulas.sealed.cache_clear()
    yield text
    formulas.sealed.cache_clear()


def test_the_seal_is_of_this_ledger():
    assert sealed_text() == ledger_text()
    assert resources.files("derivations").joinpath(SEAL).read_text("utf-8") == seal(ledger_text())


def test_a_changed_ledger_proves_the_specification_for_all_that_a_reader_can_see(changed):
    """Only a replay or the seal detects the change."""
    assert formulas.load(changed).sequences["state"]


def test_a_changed_ledger_gives_no_numbers(changed, capsys):
    with pytest.raises(LedgerError, match="not the text that was sealed"):
        sealed_text()
    for more in (["--digits", "30"], ["--enclose"]):
        assert main(["propagate", "paper", *more]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        assert "ledger: not the text that was sealed: see `rigidsym check`" in line
