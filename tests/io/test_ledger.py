"""Numbers are computed from the sealed ledger only."""

from importlib import resources

import pytest

from rigidsym._cli import main
from rigidsym.errors import LedgerError
from rigidsym.io.ledger import SEAL, ledger_text, seal, sealed_text
from rigidsym.solution import _formulas as formulas


@pytest.fixture
def changed(monkeypatch):
    """Change the sign of A_a in the ledger, which no checker would accept."""
    text = ledger_text().replace('"A_a": "B_a/c_a"', '"A_a": "-B_a/c_a"')
    assert text != ledger_text()
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
