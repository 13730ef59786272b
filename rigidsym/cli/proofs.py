"""The commands `derive`, `check` and `errata`."""

import sys
from pathlib import Path
from typing import Any

from rigidsym.cli.arguments import Command, as_path
from rigidsym.cli.output import progress, say, table


def add(command: Command) -> None:
    """Give the command line its commands about proofs."""
    derive = command("derive", _derive, "prove the claims and write the ledger")
    derive.add_argument("chapters", metavar="CHAPTER", nargs="*", help="all, unless some are named")
    derive.add_argument("-o", "--output", metavar="LEDGER", type=as_path, help="where to write it")
    derive.add_argument("--json", action="store_true", help="to stdout alone")

    check = command("check", _check, "replay the certificates of a ledger in a fresh kernel")
    check.add_argument("ledger", metavar="LEDGER", nargs="?", type=as_path, help="the sealed one")
    check.add_argument("--independent", action="store_true", help="by the checker on python-flint")

    errata = command("errata", _errata, "the verdict on each printed equation")
    errata.add_argument("--json", action="store_true", help="to stdout alone")


def _derive(options: Any) -> int:
    from rigidsym.io.files import write_text
    from rigidsym.proof.derivation import DerivationError, derive, sealed_path

    try:
        derivation = derive(options.chapters, progress("derive"))
    except DerivationError as error:
        say(f"rigidsym derive: {error}")
        return 1
    if options.json:
        print(derivation.to_json(), end="")
    else:
        rows = [
            (chapter.name, chapter.title, str(len(chapter.facts)), f"{chapter.seconds:.2f} s")
            for chapter in derivation.chapters
        ]
        table("rigidsym derive", ("chapter", "", "facts", "time"), rows)
    sys.stdout.flush()
    if options.chapters and options.output is None:
        say("the ledger is sealed by all chapters together: not written")
    else:
        say(f"ledger: {write_text(options.output or sealed_path(), derivation.ledger)}")
    return 0


def _check(options: Any) -> int:
    if options.independent:
        return _check_independently(options.ledger)
    from collections import Counter

    from rigidsym.proof.algebra.enclosures import encloses
    from rigidsym.proof.kernel import KernelError, replay

    try:
        ledger = replay(_ledger_text(options.ledger), encloses)
    except KernelError as error:
        say(f"rigidsym check: refused: {error}")
        return 1
    grades = Counter(fact.grade for fact in ledger.facts.values())
    counts = ", ".join(f"{count} {grade}" for grade, count in grades.most_common())
    print(f"{counts} facts in {len(ledger.contexts)} contexts: accepted")
    return 0


def _check_independently(path: Path | None) -> int:
    from rigidsym.proof.checker import Refused, check

    try:
        facts = check(_ledger_text(path))
    except Refused as error:
        say(f"rigidsym check: refused by the independent checker: {error}")
        return 1
    print(f"{facts} facts: accepted by the independent checker")
    return 0


def _ledger_text(path: Path | None) -> str:
    from rigidsym.io.files import read_text
    from rigidsym.io.ledger import ledger_text

    return ledger_text() if path is None else read_text("ledger", path)


def _errata(options: Any) -> int:
    import json

    from rigidsym.io.ledger import ledger_data
    from rigidsym.proof.paper import judged, row, verdicts

    ledger = ledger_data(_ledger_text(None))
    ruled, prose = verdicts(ledger), judged(ledger)
    if options.json:
        data = {
            "schema": "rigidsym.errata/2",
            "equations": [verdict.to_json() for verdict in ruled],
            "prose": [claim.to_json() for claim in prose],
        }
        print(json.dumps(data, indent=1))
        return 0
    columns = ("equation", "verdict", "root cause", "repair, or how it is read", "counterexample")
    table("rigidsym errata", columns, [row(verdict) for verdict in ruled])
    columns = ("claim in words", "judgement", "reason", "decided by")
    table("in the paper's prose", columns, [_prose(claim) for claim in prose])
    return 0


def _prose(found: Any) -> tuple[str, str, str, str]:
    decided_by = (*found.facts, *(f"`{command}`" for command in found.prose.commands))
    return found.prose.claim, found.judgement, found.prose.reason, "\n".join(decided_by)
