"""The commands `derive`, `check`, `export` and `audit`."""

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from rigidsym.cli.arguments import Command, as_path
from rigidsym.cli.output import progress, say, table
from rigidsym.errors import InputError, LedgerError

if TYPE_CHECKING:
    from rigidsym.proof.coq import Export
    from rigidsym.proof.derivation import Derivation


def add(command: Command) -> None:
    """Give the command line its commands about proofs."""
    derive = command(
        "derive", _derive, "prove the claims and write the ledger", "derive -o ledger.json"
    )
    derive.add_argument("chapters", metavar="CHAPTER", nargs="*", help="all, unless some are named")
    where = derive.add_mutually_exclusive_group()
    where.add_argument(
        "-o", "--output", metavar="FILE", type=as_path, help="for the ledger, or the article"
    )
    where.add_argument(
        "--in-place", action="store_true", help="into the package itself: seals the ledger anew"
    )
    derive.add_argument("--json", action="store_true", help="to stdout alone")
    derive.add_argument(
        "--mutants",
        action="store_true",
        help="count all mutants again; by default, and unless --in-place is given, those of facts "
        "that are as sealed keep the counts of the sealed ledger",
    )
    derive.add_argument("--show", action="store_true", help="line by line, in the terminal")
    forms = ("text", "markdown", "latex", "html")
    derive.add_argument("--format", choices=forms, help="an article, to stdout or --output")
    _add_setting(derive)

    check = command(
        "check",
        _check,
        "replay the certificates of a ledger in a fresh kernel",
        "check --independent",
    )
    check.add_argument(
        "ledger", metavar="LEDGER", nargs="?", type=as_path, help="the sealed one by default"
    )
    check.add_argument("--independent", action="store_true", help="by the checker on python-flint")
    check.add_argument(
        "--facts", action="store_true", help="no specification: of another derivation"
    )

    export = command("export", _export, "write a ledger for another prover", "export coq -o coq")
    export.add_argument("prover", metavar="PROVER", choices=("coq",), help="coq")
    export.add_argument(
        "-o", "--output", metavar="DIR", type=as_path, required=True, help="for its files"
    )
    export.add_argument(
        "--ledger", metavar="LEDGER", type=as_path, help="the sealed one by default"
    )
    export.add_argument(
        "--check", action="store_true", help="let it decide: runs make, for minutes"
    )

    audit = command("audit", _audit, "what is trusted and not decided, theorem by theorem", "audit")
    audit.add_argument("--json", action="store_true", help="to stdout alone")


def _add_setting(derive: ArgumentParser) -> None:
    """Another derivation, as far as Theorem 1: nothing of it touches the sealed ledger."""
    other = derive.add_argument_group("another derivation, up to Theorem 1")
    other.add_argument("--sequence", metavar="I-J-I", help="axes of the turns; 1-2-1 by default")
    other.add_argument(
        "--axis", metavar="I", help="where the momentum is turned; the outer axis by default"
    )
    other.add_argument(
        "--factor", metavar="F", help="of the basis (4): 1/2, which is the default, or 1"
    )
    other.add_argument(
        "--sign", metavar="S", help="of the basis (4): 1, which is the default, or -1"
    )
    other.add_argument("--order", metavar="I-J-K", help="of i, j, k in the basis; 1-2-3 by default")
    other.add_argument("--lagrangian", metavar="L", help="with wheels: ... + h1*Omega1")


def _derive(options: Namespace) -> int:
    from derivations.setting import setting_of
    from rigidsym.proof.derivation import DerivationError, derive, sealed_counts

    names = ("sequence", "axis", "factor", "sign", "order", "lagrangian")
    if options.in_place and (options.chapters or any(getattr(options, x) for x in names)):
        raise InputError("in-place", "given", "is for all chapters of the paper's derivation")
    chosen = {name: value for name in names if (value := getattr(options, name)) is not None}
    reading = options.show or options.format is not None
    if reading and options.json:
        raise InputError("json", "given", "is not for --show and --format")
    try:
        setting = setting_of(chosen) if chosen or reading else None
        sealed = "" if options.mutants or options.in_place else sealed_counts()
        derivation = derive(options.chapters, progress("derive"), setting, sealed)
    except DerivationError as error:
        say(f"rigidsym derive: {error}")
        return 1
    if reading:
        return _article(derivation, options.format or "text", options.output)
    if options.json:
        print(derivation.to_json(), end="")
    else:
        _chapters(derivation)
    sys.stdout.flush()
    _mutants(derivation)
    _seal(derivation, options, sealed=setting is None and not options.chapters)
    return 0


def _chapters(derivation: "Derivation") -> None:
    """Each chapter with its facts: how many a step computed, and how many were guessed."""
    rows = []
    for chapter in derivation.chapters:
        facts, computed = len(chapter.facts), chapter.computed
        if not facts:
            continue
        counts = (str(computed), str(facts - computed), f"{chapter.seconds:.2f} s")
        rows.append((chapter.name, chapter.title, *counts))
    table("rigidsym derive", ("chapter", "", "computed", "guessed", "time"), rows)


def _mutants(derivation: "Derivation") -> None:
    """Say how many mutants are counted, and which counts are not of this run."""
    facts = derivation.mutants
    if not facts:
        return
    mutants = sum(sum(fates.values()) for fates in facts.values())
    kept = len(facts) - derivation.recounted
    counted = f"{mutants} of {len(facts)} facts are counted"
    if kept:
        counted += f", {kept} facts as sealed and not again (--mutants counts all)"
    say(f"mutants: {counted}")


def _article(derivation: "Derivation", form: str, output: Path | None) -> int:
    from rigidsym.io.files import write_text
    from rigidsym.view.article import article

    try:
        text = article(derivation.chapters, form)
    except ImportError as error:
        say(f"rigidsym derive: --format {form} needs {error.name}: pip install 'rigidsym[docs]'")
        return 1
    if output is None:
        print(text, end="")
    else:
        say(f"article: {write_text(output, text)}")
    return 0


def _seal(derivation: "Derivation", options: Namespace, sealed: bool) -> None:
    """Write the ledger: of all chapters to its place, else where the user says."""
    from rigidsym.io.files import write_text
    from rigidsym.io.ledger import SEAL, seal
    from rigidsym.proof.derivation import sealed_path

    if options.output is not None:
        say(f"ledger: {write_text(options.output, derivation.ledger)}")
    elif not sealed:
        say("the ledger is sealed by all chapters together: not written")
    elif options.in_place:
        path = write_text(sealed_path(), derivation.ledger)
        write_text(path.with_name(SEAL), seal(derivation.ledger))
        say(f"ledger: {path}")
    else:
        say(f"{_compared(derivation.ledger)}: not written (-o FILE, or --in-place)")


def _compared(ledger: str) -> str:
    from rigidsym.io.ledger import ledger_text

    try:
        same = ledger == ledger_text()
    except LedgerError:
        same = False
    return f"the ledger is {'the one that is' if same else 'NOT the one that is'} sealed"


def _check(options: Namespace) -> int:
    """Facts by grade; 1 where the ledger is refused, or a fact rests on a reference alone."""
    from rigidsym.io.ledger import specification_text

    grades = _independent_grades if options.independent else _kernel_grades
    specification = "" if options.facts else specification_text()
    found = grades(_ledger_text(options.ledger), specification)
    if found is None:
        return 1
    counts = ", ".join(f"{count} {grade}" for grade, count in found.items())
    print(
        f"{counts} facts: accepted{', and they prove the specification' if specification else ''}"
    )
    if assumed := found.get("ASSUMED"):
        say(f"rigidsym check: {assumed} ASSUMED: facts must be ENCLOSED at least")
    return 1 if assumed else 0


def _kernel_grades(text: str, specification: str) -> dict[str, int] | None:
    import json
    from collections import Counter

    from rigidsym.language.specification import Unproved, require
    from rigidsym.proof.algebra.suppositions import encloses
    from rigidsym.proof.kernel import KernelError, replay

    try:
        ledger = replay(text, encloses)
        require(specification, json.loads(text))
    except (KernelError, Unproved) as error:
        say(f"rigidsym check: refused: {error}")
        return None
    return dict(Counter(str(fact.grade) for fact in ledger.facts.values()).most_common())


def _independent_grades(text: str, specification: str) -> dict[str, int] | None:
    from rigidsym.proof.checker import Refused, grades

    try:
        return grades(text, specification)
    except Refused as error:
        say(f"rigidsym check: refused by the independent checker: {error}")
        return None


def replayed() -> str:
    """The sealed ledger, if the independent checker accepts it; LedgerError where it does not."""
    from rigidsym.io.ledger import specification_text
    from rigidsym.proof.checker import Refused, check

    text = _ledger_text(None)
    try:
        check(text, specification_text())
    except Refused as error:
        raise LedgerError(f"ledger: refused by the independent checker: {error}") from None
    return text


def _ledger_text(path: Path | None) -> str:
    from rigidsym.io.files import read_text
    from rigidsym.io.ledger import ledger_text

    return ledger_text() if path is None else read_text("ledger", path)


def _export(options: Namespace) -> int:
    from rigidsym.io.files import write_text
    from rigidsym.proof.algebra.suppositions import encloses
    from rigidsym.proof.coq import export
    from rigidsym.proof.kernel import KernelError, replay

    try:
        ledger = replay(_ledger_text(options.ledger), encloses)
    except KernelError as error:
        say(f"rigidsym export: refused by the kernel, nothing is written: {error}")
        return 1
    written = export(ledger)
    for name, text in written.files.items():
        write_text(options.output / name, text)
    say(f"wrote {len(written.files)} files to {options.output}")
    _exported(written)
    return _make(options.output) if options.check else 0


def _exported(written: "Export") -> None:
    """How many facts of each rule are theorems there, and what is not."""
    from rigidsym.proof.coq import SUPPOSED

    total = sum(written.exported.values())
    counts = ", ".join(f"{count} {rule}" for rule, count in sorted(written.exported.items()))
    print(f"{total} facts are stated in Coq: {counts}")
    if supposed := {rule: n for rule, n in written.exported.items() if rule in SUPPOSED}:
        rules = ", ".join(sorted(supposed))
        print(f"{sum(supposed.values())} are hypotheses there of all that rests on them: {rules}")
    reasons: dict[str, list[str]] = {}
    for fact, reason in written.left_out.items():
        reasons.setdefault(reason, []).append(fact)
    for reason, facts in reasons.items():
        print(f"{len(facts)} are not: {reason}: {', '.join(facts)}")


def _make(directory: Path) -> int:
    """Let Coq decide all of it; 1 where it refuses, or is not here."""
    from os import cpu_count
    from shutil import which
    from subprocess import run

    missing = [tool for tool in ("make", "coqc", "coq_makefile") if which(tool) is None]
    if missing:
        package = "make" if missing == ["make"] else "coq libcoq-coquelicot"
        say(f"rigidsym export: --check needs {missing[0]} (Debian: apt-get install {package})")
        return 1
    done = run(["make", "-C", str(directory), "-j", str(cpu_count() or 1)], check=False)
    say("accepted by Coq" if done.returncode == 0 else "rigidsym export: refused by Coq")
    return min(done.returncode, 1)


def _audit(options: Namespace) -> int:
    import json
    from dataclasses import asdict

    from rigidsym.codegen.lines import RUNTIMES, handwritten
    from rigidsym.io.ledger import ledger_data, specification_text
    from rigidsym.proof.audit import audit, totals

    audits = audit(specification_text(), ledger_data(replayed()))
    counts, lines = totals(audits), {target: handwritten(target) for target in RUNTIMES}
    if options.json:
        theorems = [asdict(one) for one in audits]
        data = {
            "schema": "rigidsym.audit/1",
            "theorems": theorems,
            "totals": counts,
            "lines": lines,
        }
        print(json.dumps(data, indent=1))
        return 0
    for one in audits:
        print(f"{one.theorem}: {one.title}")
        for kind, things in one.trusted.items():
            print("".join(f"  {kind}: {thing}\n" for thing in things), end="")
    print("in all: " + ", ".join(f"{count} {kind}" for kind, count in counts.items()))
    print("by hand: " + ", ".join(f"{count} lines beside {name}" for name, count in lines.items()))
    return 0
