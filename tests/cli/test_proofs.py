"""Ledgers that `check`, `export` and `audit` refuse, and what they say of them."""

import json

import pytest
from document_texts import rows
from ledgers import written

from rigidsym._cli.proofs import deciding
from rigidsym.io.ledger import ledger_text

NO_LEDGERS = {
    "": "it is empty",
    "{": "it is not JSON",
    "\x00\x01": "it is not JSON",
    "[" * 100_000: "it is not JSON",
    "[]": "no object with contexts and facts",
    "{}": "no list of contexts",
    '{"contexts": [], "published": {}}': "no list of facts",
    '{"contexts": [], "facts": [], "published": []}': "no table of what is published",
    '{"contexts": [], "facts": [1], "published": {}}': "facts[0] has no id",
    '{"schema": "rigidsym.ledger/1"}': "its schema is 'rigidsym.ledger/1'",
}


@pytest.mark.parametrize(("text", "reason"), NO_LEDGERS.items(), ids=range(len(NO_LEDGERS)))
def test_a_file_that_is_no_ledger_is_one_line(text, reason, tmp_path, run, monkeypatch):
    path = tmp_path / "ledger.json"
    path.write_text(text)
    monkeypatch.setattr("rigidsym.io.ledger.ledger_text", lambda: text)
    for command in (
        ("check", path),
        ("check", path, "--independent"),
        ("export coq -o", tmp_path / "coq", "--ledger", path),
        ("audit",),
    ):
        (line,) = run(*command, status=2).err.splitlines()
        assert reason in line
        assert "rigidsym derive -o FILE" in line
    assert not (tmp_path / "coq").exists()


def test_a_file_that_cannot_be_read_comes_with_the_next_step(tmp_path, run):
    (tmp_path / "binary").write_bytes(b"\xff\xfe\x00")
    for name in ("nowhere", ".", "binary"):
        (line,) = run("check", tmp_path / name, status=2).err.splitlines()
        assert "rigidsym derive -o FILE" in line


@pytest.mark.parametrize("checker", [[], ["--independent"]])
def test_a_refused_ledger_names_the_theorem(checker, tmp_path, run):
    path = tmp_path / "ledger.json"
    for change in (
        {"rhs": ["0"]},
        {"certificate": {}},
        {"premises": ["no.such"]},
        {"rule": "none"},
    ):
        data = json.loads(ledger_text())
        fact = next(fact for fact in data["facts"] if fact["id"] == "regular.E_a")
        fact |= change
        path.write_text(written(data))
        *_, line = run("check", path, *checker, status=1).err.splitlines()
        assert "fact regular.E_a: " in line
        assert " (theorem " in line
        assert "Error" not in line


def test_the_page_counts_the_lines_that_decide():
    """Compare with `rigidsym audit`: its counts are at most those of the page."""
    said = {row[0]: int(row[1]) for row in rows("trust.md") if len(row) == 2 and row[1].isdigit()}
    for what, count in deciding().items():
        assert 0 < count <= said[f"lines of {what}"], what
