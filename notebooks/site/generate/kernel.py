"""The page of rules and assumptions: what every proof rests on, from the code and the ledger."""

from generate.text import code, fenced, plain, table
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.proof.kernel._rules import RULES

_HEAD = """# Rules and assumptions

What [every fact](../trust.md) rests on.

## The eight rules

As the docstrings of `rigidsym.proof.kernel._rules` draw them: premises above the line, conclusion
below.
"""
_ASSUMED = """## The assumptions

Classical identities, which no polynomial decides. All that is graded ENCLOSED rests on these.
"""


def page() -> str:
    """The rules, then what is assumed."""
    return "\n".join([_HEAD, rules(), _ASSUMED, assumptions()])


def assumptions() -> str:
    """The assumptions with their references, and at how many points both sides were enclosed."""
    rows = [
        (code(fact["id"]), plain(fact["certificate"]["reference"]),
         str(len(fact["certificate"]["points"])))
        for fact in ledger_data(ledger_text())["facts"]
        if fact["rule"] == "assumption"
    ]  # fmt: skip
    return table(("assumption", "reference", "points"), rows)


def rules() -> str:
    """Each rule of inference as its docstring draws it."""
    parts = []
    for name, (_, _, rule) in RULES.items():
        lines = (rule.__doc__ or "").strip("\n").splitlines()
        drawn = "\n".join(line[4:] for line in lines)
        parts.append(f"{code(name)}\n\n{fenced('text', drawn)}")
    return "\n".join(parts)
