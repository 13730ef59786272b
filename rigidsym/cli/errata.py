"""The command `errata`."""

import json
from argparse import Namespace
from collections.abc import Sequence
from typing import TYPE_CHECKING

from rigidsym.cli.arguments import Command
from rigidsym.cli.output import entries_text, page, table_text
from rigidsym.errors import InputError

if TYPE_CHECKING:
    from rigidsym.proof.paper import Verdict
    from rigidsym.proof.paper.prose import Judged

SCHEMA = "rigidsym.errata/2"
_RULINGS = ("holds", "holds-if", "misprint", "ambiguous", "open")


def add(command: Command) -> None:
    """Give the command line its command about the paper."""
    errata = command(
        "errata", _errata, "the verdict on each printed equation", "errata --verdict misprint"
    )
    errata.add_argument(
        "equations",
        metavar="EQUATION",
        nargs="*",
        help="all of these: 10, 'Lemma 1'; a table of all by default",
    )
    errata.add_argument("--verdict", choices=_RULINGS, help="only these; all by default")
    errata.add_argument("--json", action="store_true", help="to stdout alone")


def _errata(options: Namespace) -> int:
    from rigidsym.cli.proofs import replayed
    from rigidsym.io.ledger import ledger_data
    from rigidsym.proof.paper import judged, verdicts

    ledger = ledger_data(replayed())
    ruled = _chosen(verdicts(ledger), options)
    chosen = bool(options.equations or options.verdict)
    prose = [] if chosen else judged(ledger)
    if options.json:
        data = {
            "schema": SCHEMA,
            "equations": [verdict.to_json() for verdict in ruled],
            "prose": [claim.to_json() for claim in prose],
        }
        print(json.dumps(data, indent=1))
    elif options.equations:
        page("\n".join(map(_whole, ruled)))
    else:
        page(_overview(ruled, prose))
    return 0


def _chosen(ruled: "Sequence[Verdict]", options: Namespace) -> "list[Verdict]":
    """Those that are asked for; InputError for an equation that is not printed."""
    numbers = {verdict.equation.number.lower(): verdict for verdict in ruled}
    wanted = [name.strip("()").lower() for name in options.equations]
    for name, given in zip(wanted, options.equations, strict=True):
        if name not in numbers:
            known = ", ".join(verdict.equation.number for verdict in ruled)
            raise InputError("equation", given, f"must be one of: {known}")
    found = [numbers[name] for name in wanted] if wanted else [*ruled]
    ruling = (options.verdict or "").replace("-", " ")
    return [verdict for verdict in found if not ruling or verdict.ruling == ruling]


def _whole(verdict: "Verdict") -> str:
    from rigidsym.proof.paper.table import details

    return entries_text(f"({verdict.equation.number})", list(details(verdict)))


def _overview(ruled: "Sequence[Verdict]", prose: "Sequence[Judged]") -> str:
    from rigidsym.proof.paper.table import COLUMNS, counted, row

    parts = [
        f"{counted(ruled)}; all about one of them: rigidsym errata 10\n",
        table_text("rigidsym errata", COLUMNS, [row(verdict) for verdict in ruled]),
    ]
    if prose:
        columns = ("claim in words", "judgement", "reason", "decided by")
        parts.append(table_text("in the paper's prose", columns, [_prose(x) for x in prose]))
    return "".join(parts)


def _prose(found: "Judged") -> tuple[str, str, str, str]:
    decided_by = (*found.facts, *(f"`{command}`" for command in found.prose.commands))
    return found.prose.claim, found.judgement, found.prose.reason, "\n".join(decided_by)
