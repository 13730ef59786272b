"""What the page on trust takes from the code: numbers, grades and rules."""

from collections import Counter
from typing import Any

from generate.text import code, fenced, plain, table
from rigidsym.kernel.rules import RULES
from rigidsym.paper import Ruling, verdicts
from rigidsym.seal import seal
from rigidsym.solution import ledger_data, ledger_text, sealed
from rigidsym.validate.faults.tables import FAULTS
from rigidsym.validate.strata import STRATA


def numbers() -> dict[str, Any]:
    """Counts by the names that pages use for them."""
    ledger = ledger_data(ledger_text())
    grades = Counter(fact["grade"] for fact in ledger["facts"])
    rules = Counter(fact["rule"] for fact in ledger["facts"])
    rulings = Counter(verdict.ruling for verdict in verdicts(ledger))
    return {
        "facts": len(ledger["facts"]),
        "contexts": len(ledger["contexts"]),
        "proved": grades["PROVED"],
        "enclosed": grades["ENCLOSED"],
        "assumptions": rules["assumption"],
        "misprints": rulings[Ruling.MISPRINT],
        "decisions": seal(sealed()),
        "strata": len(STRATA),
        "faults": len(FAULTS),
    }


def assumptions() -> str:
    """The suppositions that everything ENCLOSED rests on, with their references."""
    rows = [
        (code(fact["id"]), plain(fact["certificate"]["reference"]),
         str(len(fact["certificate"]["points"])))
        for fact in ledger_data(ledger_text())["facts"]
        if fact["rule"] == "assumption"
    ]  # fmt: skip
    return table(("supposition", "reference", "points"), rows)


def rules() -> str:
    """Each rule of inference as its docstring draws it."""
    parts = []
    for name, (_, rule) in RULES.items():
        lines = (rule.__doc__ or "").strip("\n").splitlines()
        drawn = "\n".join(line[4:] for line in lines)
        parts.append(f"{code(name)}\n\n{fenced('text', drawn)}")
    return "\n".join(parts)
