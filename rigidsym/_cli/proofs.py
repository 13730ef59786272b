"""Functions that run the commands `derive`, `check`, `export`, `audit` and `errata`."""

import json
import sys
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidsym._cli.commands import SETTING
from rigidsym._cli.output import entries_text, page, progress, say, table, table_text
from rigidsym.errors import InputError, LedgerError, unknown
from rigidsym.io import ledger as stored
from rigidsym.io._files import read_text, write_text

if TYPE_CHECKING:
    from rigidsym.proof._coq import Export
    from rigidsym.proof._mutants import Checks
    from rigidsym.proof.derivation import Derivation
    from rigidsym.proof.kernel import Fact
    from rigidsym.proof.paper import Verdict
    from rigidsym.proof.paper._prose import Judged

ERRATA_SCHEMA = "rigidsym.errata/2"


def derive(options: Namespace) -> int:
    """Derive chapters, print a summary of them, and write the ledger.

    Returns 1 if a proof fails.
    """
    from derivations.setting import setting_of
    from rigidsym.proof.derivation import DerivationError, derive, sealed_counts

    if options.in_place and (options.chapters or any(getattr(options, x) for x in SETTING)):
        raise InputError("in-place", "given", "is for all chapters of the paper's derivation")
    chosen = {name: value for name in SETTING if (value := getattr(options, name)) is not None}
    reading = options.show or options.format is not None
    if reading and options.json:
        raise InputError("json", "given", "is not for --show and --format")
    try:
        setting = setting_of(chosen) if chosen else None
        sealed = "" if options.mutants or options.in_place else sealed_counts()
        derivation = derive(options.chapters, progress("derive"), setting, sealed)
    except DerivationError as error:
        say(f"rigidsym derive: {error}")
        return 1
    if reading:
        return _article(derivation, options.format or "text", options.output)
    if options.json:
        print(derivation.to_json(), end="")
    elif options.guesses:
        _guesses(derivation)
    else:
        _chapters(derivation)
    sys.stdout.flush()
    _mutants(derivation)
    _seal(derivation, options, sealed=setting is None and not options.chapters)
    return 0


def _chapters(derivation: "Derivation") -> None:
    """Print how many facts of each chapter were computed, and the same for what is published."""
    from rigidsym.proof.algebra._computation import Standing

    rows: list[tuple[str, ...]] = []
    for chapter in derivation.chapters:
        counts = [str(chapter.standings[kind] or "") for kind in Standing]
        if chapter.facts:
            rows.append((chapter.name, chapter.title, *counts, f"{chapter.seconds:.2f} s"))
    for kind, standings in derivation.published.items():
        if standings:
            counts = [str(standings[kind] or "") for kind in Standing]
            rows.append(("", f"published {kind}", *counts, ""))
    table("rigidsym derive", ("chapter", "", *Standing, "time"), rows)
    with_typed = [fact.id for fact, _ in _joined(derivation)]
    if with_typed:
        here = len(derivation.formulas.intersection(with_typed))
        say(
            f"computed: in {len(with_typed)} of these facts, {here} of them published, arithmetic "
            "puts a typed expression beside the computed one (--guesses lists them)"
        )


def _joined(derivation: "Derivation") -> list[tuple["Fact", tuple[Any, ...]]]:
    """Return the computed facts that contain typed expressions, each with these expressions."""
    from rigidsym.proof.algebra._computation import joined

    facts = (fact for chapter in derivation.chapters for fact in chapter.facts)
    return [(fact, typed) for fact in facts if (typed := joined(fact))]


_REASONS = {"guessed": "no reason is given", "stated": "refuted at a point"}


def _guesses(derivation: "Derivation") -> None:
    """Print the facts whose statements were typed, under the reasons: guesses, then laws.

    Equations of matrices are printed as such.  Last come the computed facts with a typed part.
    """
    from rigidsym.proof.algebra._computation import Standing, reasons, standing
    from rigidsym.proof.derivation import statement

    facts = [fact for chapter in derivation.chapters for fact in chapter.facts]
    steps = (step for chapter in derivation.chapters for step in chapter.steps)
    lines = {x.fact.id: "; ".join("{} = {}".format(*y.args) for y in x.shown) for x in steps}
    for kind in (Standing.GUESSED, Standing.STATED):
        by_reason: dict[str, list[str]] = {}
        for fact in (fact for fact in facts if standing(fact) == kind):
            why = "; ".join(reasons(fact)) or _REASONS[kind]
            by_reason.setdefault(why, []).append(
                f"    {fact.id}: {lines.get(fact.id) or statement(fact)}"
            )
        for why, said in by_reason.items():
            print(f"{kind}: {why}", *said, sep="\n")
    if found := _joined(derivation):
        print("computed, beside an expression that was typed:")
    for fact, typed in found:
        print(f"    {fact.id}: {', '.join(map(str, typed))}")


def _mutants(derivation: "Derivation") -> None:
    """Print the number of mutants, and how many facts were not tested again in this run."""
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
    from rigidsym.view._article import article

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
    """Write the ledger to the user's file or, with --in-place, into the package."""
    from rigidsym.proof.derivation import sealed_path

    if options.output is not None:
        say(f"ledger: {write_text(options.output, derivation.ledger)}")
    elif not sealed:
        say("the ledger is sealed by all chapters together: not written")
    elif options.in_place:
        path = write_text(sealed_path(), derivation.ledger)
        write_text(path.with_name(stored.SEAL), stored.seal(derivation.ledger))
        say(f"ledger: {path}")
    else:
        say(f"{_compared(derivation.ledger)}: not written (-o FILE, or --in-place)")


def _compared(ledger: str) -> str:

    try:
        same = ledger == stored.ledger_text()
    except LedgerError:
        same = False
    return f"the ledger is {'the one that is' if same else 'NOT the one that is'} sealed"


def check(options: Namespace) -> int:
    """Check the proofs in a ledger, and print how many facts have each grade.

    Returns 1 if the ledger is not accepted.
    """

    if options.mutants:
        return _mutants_noticed(_ledger_text(options.ledger))
    grades = _independent_grades if options.independent else _kernel_grades
    specification = "" if options.facts else stored.specification_text()
    text = _ledger_text(options.ledger)
    found = grades(text, specification)
    if found is None:
        return 1
    if specification and not options.independent and not _numbers(text):
        return 1
    counts = ", ".join(f"{count} {grade}" for grade, count in found.items())
    print(
        f"{counts} facts: accepted{', and they prove the specification' if specification else ''}"
    )
    if assumed := found.get("ASSUMED"):
        say(f"rigidsym check: {assumed} ASSUMED: facts must be ENCLOSED at least")
    return 1 if assumed else 0


def checks(text: str) -> "Checks":
    """Return what decides about mutants of a ledger: all that `check` decides by."""
    from rigidsym._numbers import check_numbers
    from rigidsym.language import _specification as first
    from rigidsym.proof import checker as second
    from rigidsym.proof._mutants import Checks

    readers, refusals = (first.require, second.require), (first.Unproved, second.Refused)
    specification = stored.specification_text()
    return Checks(text, specification, readers, check_numbers, (*refusals, LedgerError))


def _mutants_noticed(text: str) -> int:
    """Print how many mutants of a ledger each check notices.

    Returns 1 if one goes unnoticed.
    """
    from rigidsym.proof._mutants import FATES, run
    from rigidsym.validate._executors import local

    with local() as place:
        tally = run(checks(text), place.submit)
    rows = [
        (kind, *(str(fates[fate]) for fate in FATES), str(fates.total()))
        for kind, fates in tally.counts.items()
    ]
    table("rigidsym check --mutants", ("changed", *FATES, "in all"), rows)
    for told in tally.unnoticed:
        say(f"unnoticed: {told}")
    return 1 if tally.unnoticed else 0


def _kernel_grades(text: str, specification: str) -> dict[str, int] | None:
    from collections import Counter

    from rigidsym.language._specification import Unproved, require
    from rigidsym.proof.algebra._enclosures import encloses
    from rigidsym.proof.kernel import KernelError, replay

    try:
        ledger = replay(text, encloses)
        require(specification, json.loads(text))
    except (KernelError, Unproved) as error:
        say(f"rigidsym check: refused: {error}{_concerning(error, text, specification)}")
        return None
    return dict(Counter(str(fact.grade) for fact in ledger.facts.values()).most_common())


def _numbers(text: str) -> bool:
    """Compare the published formulas with the equations of motion, and print how many there are."""
    from rigidsym._numbers import check_numbers

    try:
        motions, formulas = check_numbers(text)
    except LedgerError as error:
        say(f"rigidsym check: refused by numbers: {error}")
        return False
    print(
        f"{formulas} published formulas: they agree with the equations of motion, {motions} motions"
    )
    return True


def _independent_grades(text: str, specification: str) -> dict[str, int] | None:
    from rigidsym.proof.checker import Refused, grades

    try:
        return grades(text, specification)
    except Refused as error:
        told = f"{error}{_concerning(error, text, specification)}"
        say(f"rigidsym check: refused by the independent checker: {told}")
        return None


def _concerning(error: Exception, text: str, specification: str) -> str:
    """Return which theorem rests on the context in which a checker refuses something."""
    from rigidsym.language._specification import Proved, theorems

    kind, _, name = str(error).partition(":")[0].partition(" ")
    if kind not in ("fact", "context"):
        return ""
    try:
        ledger = Proved(json.loads(text))
    except (LookupError, TypeError, AttributeError):
        return ""
    for theorem in theorems(specification).values():
        if name.partition(".")[0] in ledger.modelled(theorem.name):
            return f" (theorem {theorem.name} rests on it: {theorem.title})"
    return ""


def replayed() -> str:
    """Check the sealed ledger by the independent checker, and return its text.

    Raises LedgerError if the checker refuses it.
    """
    from rigidsym.proof.checker import Refused, check

    text = _ledger_text(None)
    try:
        check(text, stored.specification_text())
    except Refused as error:
        raise LedgerError(f"ledger: refused by the independent checker: {error}") from None
    return text


def _ledger_text(path: Path | None) -> str:
    """Return the text of a user's ledger, or of the sealed one.

    Raises InputError or LedgerError for a file that is no ledger.
    """
    try:
        text = stored.ledger_text() if path is None else read_text("ledger", path)
    except InputError as error:
        step = "write a ledger by `rigidsym derive -o FILE`"
        raise InputError(error.field, error.value, error.rule, next_step=step) from None
    stored.ledger_data(text)
    return text


def export(options: Namespace) -> int:
    """Translate a ledger to Coq theorems, and write them to files.

    With --check, runs Coq on them.
    """
    from rigidsym.proof._coq import export
    from rigidsym.proof.algebra._enclosures import encloses
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
    """Print how many facts of each rule were exported to Coq, and which were left out."""
    from rigidsym.proof._coq import SUPPOSED

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
    """Run Coq on the exported theorems by `make`.

    Returns 1 if Coq refuses a theorem or is not installed.
    """
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


def audit(options: Namespace) -> int:
    """Print the assumptions that each theorem rests on."""
    from dataclasses import asdict

    from rigidsym._codegen import TARGETS
    from rigidsym._codegen.lines import beside
    from rigidsym.proof._audit import audit, totals

    audits = audit(stored.specification_text(), stored.ledger_data(replayed()))
    counts, lines = totals(audits), {target: beside(target) for target in TARGETS}
    own = deciding()
    if options.json:
        theorems = [asdict(one) for one in audits]
        data = {
            "schema": "rigidsym.audit/1",
            "theorems": theorems,
            "totals": counts,
            "lines": lines,
            "deciding": own,
        }
        print(json.dumps(data, indent=1))
        return 0
    for one in audits:
        print(f"{one.theorem}: {one.title}")
        for kind, things in one.trusted.items():
            print("".join(f"  {kind}: {thing}\n" for thing in things), end="")
    print("in all: " + ", ".join(f"{count} {kind}" for kind, count in counts.items()))
    print("deciding: " + ", ".join(f"{count} lines of {name}" for name, count in own.items()))
    print("by hand: " + ", ".join(f"{count} lines beside {name}" for name, count in lines.items()))
    return 0


def deciding() -> dict[str, int]:
    """Count the lines that decide what is proved, without blank lines and comments."""
    from importlib import resources

    from rigidsym._codegen.lines import code_lines

    places = {
        "the kernel": "rigidsym.proof.kernel",
        "the second checker": "rigidsym.proof.checker",
        "the first reader of specifications": "rigidsym.language",
    }
    counts = {}
    for what, package in places.items():
        files = [file for file in resources.files(package).iterdir() if file.name.endswith(".py")]
        if package == "rigidsym.language":
            files = [file for file in files if file.name in ("_notation.py", "_specification.py")]
        counts[what] = sum(code_lines(file.read_text("utf-8"), "numpy") for file in files)
    return counts | {"the specification": code_lines(stored.specification_text(), "numpy")}


def errata(options: Namespace) -> int:
    """Print the verdicts on the paper's equations and on claims in its prose."""
    from rigidsym.proof.paper import judged, verdicts
    from rigidsym.proof.paper._table import details

    ledger = stored.ledger_data(replayed())
    ruled = _chosen(verdicts(ledger), options)
    chosen = bool(options.equations or options.verdict)
    prose = [] if chosen else judged(ledger)
    if options.json:
        data = {
            "schema": ERRATA_SCHEMA,
            "equations": [verdict.to_json() for verdict in ruled],
            "prose": [claim.to_json() for claim in prose],
        }
        print(json.dumps(data, indent=1))
    elif options.equations:
        numbers = (f"({verdict.equation.number})" for verdict in ruled)
        entries = (list(details(verdict)) for verdict in ruled)
        page("\n".join(map(entries_text, numbers, entries)))
    else:
        page(_overview(ruled, prose))
    return 0


def _chosen(ruled: "Sequence[Verdict]", options: Namespace) -> "list[Verdict]":
    """Select the verdicts that the user's options ask for.

    Raises InputError for an unknown equation.
    """
    numbers = {verdict.equation.number.lower(): verdict for verdict in ruled}
    wanted = [name.strip("()").lower() for name in options.equations]
    for name, given in zip(wanted, options.equations, strict=True):
        if name not in numbers:
            known = (verdict.equation.number for verdict in ruled)
            raise unknown("equation", given, known, plain=True)
    found = [numbers[name] for name in wanted] if wanted else [*ruled]
    ruling = (options.verdict or "").replace("-", " ")
    return [verdict for verdict in found if not ruling or verdict.ruling == ruling]


def _overview(ruled: "Sequence[Verdict]", prose: "Sequence[Judged]") -> str:
    from rigidsym.proof.paper._table import COLUMNS, counted, explained, row

    parts = [
        f"{counted(ruled)}; all about one of them: rigidsym errata 10\n",
        f"{why}\n" if (why := explained(ruled)) else "",
        table_text("rigidsym errata", COLUMNS, [row(verdict) for verdict in ruled]),
    ]
    rows = []
    for one in prose:
        decided_by = (*one.facts, *(f"`{command}`" for command in one.prose.commands))
        rows.append((one.prose.claim, one.judgement, one.prose.reason, "\n".join(decided_by)))
    if rows:
        columns = ("claim in words", "judgement", "reason", "decided by")
        parts.append(table_text("in the paper's prose", columns, rows))
    return "".join(parts)
