"""How values look in a notebook: facts, printed equations, verdicts, motions and reports.

Most show themselves.  The kernel knows nothing of this: `claims` gives the facts of a ledger with
their hypotheses, and `%load_ext rigidsym.view.html` lets bare facts and ledgers be shown as well.
"""

from typing import Any

from rigidsym.language.latex import latex
from rigidsym.proof.claims import Claim, Claims, claims, fact_html

__all__ = ["Claim", "Claims", "claims", "latex", "load_ipython_extension"]


def load_ipython_extension(ipython: Any) -> None:
    """Let IPython show the kernel's facts and ledgers."""
    html = ipython.display_formatter.formatters["text/html"]
    html.for_type_by_name("rigidsym.proof.kernel.statement", "Fact", fact_html)
    html.for_type_by_name(
        "rigidsym.proof.kernel.ledger", "Ledger", lambda x: claims(x)._repr_html_()
    )
