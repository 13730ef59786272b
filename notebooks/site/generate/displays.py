"""All that the paper prints, in its order, on one page; each display leads to its verdict."""

from collections.abc import Iterator

from generate.errata import badge, display, label, title
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.proof.paper import Verdict, verdicts
from rigidsym.proof.paper._table import counted

_HEAD = """# The paper, display by display

All that the paper prints, in its order and as it is printed, mistakes included. The word beside a
number is the verdict, and leads to what is said of it. What is known of the paper itself: [the
paper and the sources](bibliography.md).
"""


def page() -> str:
    """How many of each verdict, then all displays."""
    ruled = verdicts(ledger_data(ledger_text()))
    return "\n".join([_HEAD, f"In all, {counted(ruled)}.\n", *map(_entry, ruled)])


def _entry(verdict: Verdict) -> str:
    return "\n\n".join(_parts(verdict)) + "\n"


def _parts(verdict: Verdict) -> Iterator[str]:
    yield f"**{title(verdict)}** [{badge(verdict.ruling)}](#{label(verdict)})"
    yield display(verdict.equation.latex)
