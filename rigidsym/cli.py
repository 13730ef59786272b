"""The `rigidsym` command: parses, calls, prints.  Heavy modules are imported by the commands.

Exit status: 0 success; 1 a claim, certificate, comparison or bound fails; 2 bad input or usage.
"""

import argparse
import io
import os
import re
import signal
import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, NoReturn

from rigidsym.errors import InputError, LedgerError, PrecisionError

_MOST = 999_999_999
# Progress bars that are shown; leaving takes them from the terminal.
_BARS = ExitStack()
# The arguments of `rigidsym.export.aem` that are text.
_MESSAGE = {
    "epoch": ("EPOCH", "when t is 0, YYYY-MM-DDThh:mm:ss[.d…]; needed"),
    "time-system": ("T", "UTC, TAI, TT or GPS; UTC by default"),
    "object-name": ("NAME", "UNKNOWN by default"),
    "object-id": ("ID", "such as 2000-052A; UNKNOWN by default"),
    "originator": ("NAME", "who makes the message; RIGIDSYM by default"),
    "creation-date": ("DATE", "UTC; the epoch by default"),
    "ref-frame-a": ("FRAME", "the inertial one, EME2000 by default"),
    "ref-frame-b": ("FRAME", "the axes of the body, SC_BODY_1 by default"),
}


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message}\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    _prepare_output()
    options = _parser().parse_args(arguments)
    try:
        with _BARS:
            status = options.run(options)
        sys.stdout.flush()
        return status
    except (InputError, LedgerError, PrecisionError) as error:
        print(f"rigidsym {options.command}: {error}", file=sys.stderr)
        return 1 if isinstance(error, PrecisionError) else 2
    except BrokenPipeError:  # the reader went away, as `head` does
        _discard_output()
        return 0
    except OSError as error:
        print(f"rigidsym {options.command}: output: {error.strerror}", file=sys.stderr)
        _discard_output()
        return 2
    except KeyboardInterrupt as stopped:
        print(f"rigidsym {options.command}: {str(stopped) or 'interrupted'}", file=sys.stderr)
        return 130


def _prepare_output() -> None:
    """Closed streams and encodings without our letters are no reason to fail."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, io.StringIO())
        elif isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def _discard_output() -> None:
    """What is still buffered goes nowhere, so that leaving does not fail again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="rigidsym", description="Exact torque-free motion of a rigid body.")
    parser.add_argument("--version", action="version", version=f"%(prog)s {_version()}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def command(name: str, run: Callable[[Any], int], summary: str) -> argparse.ArgumentParser:
        added = commands.add_parser(name, help=summary, description=summary)
        added.set_defaults(run=run)
        return added

    reproduce = command("reproduce", _reproduce, "derive, check, generate, validate and report")
    reproduce.add_argument(
        "-o", "--output", metavar="DIR", default="reproduce", type=_path, help="for the results"
    )

    derive = command("derive", _derive, "prove the claims and write the ledger")
    derive.add_argument("chapters", metavar="CHAPTER", nargs="*", help="all, unless some are named")
    derive.add_argument("-o", "--output", metavar="LEDGER", type=_path, help="where to write it")
    derive.add_argument("--json", action="store_true", help="to stdout alone")

    check = command("check", _check, "replay the certificates of a ledger in a fresh kernel")
    check.add_argument("ledger", metavar="LEDGER", nargs="?", type=_path, help="the sealed one")
    check.add_argument("--independent", action="store_true", help="by the checker on python-flint")

    errata = command("errata", _errata, "the verdict on each printed equation")
    errata.add_argument("--json", action="store_true", help="to stdout alone")

    codegen = command("codegen", _codegen, "write a numeric module")
    codegen.add_argument("target", metavar="TARGET", help="numpy or c")
    codegen.add_argument("-o", "--output", metavar="DIR", type=_path, help="the package itself")
    instead = codegen.add_mutually_exclusive_group()
    instead.add_argument("--check", action="store_true", help="compare with what is there")
    instead.add_argument("--stdout", action="store_true", help="print the module")

    trace = command("trace", _trace, "a generated line's equations; an equation's generated lines")
    trace.add_argument("place", metavar="FILE:LINE", nargs="?", help="of a generated file")
    trace.add_argument("--equation", metavar="NUMBER", help="as the paper numbers it")

    validate = command("validate", _validate, "measure generated modules against the derivation")
    validate.add_argument("targets", metavar="TARGET", nargs="*", help="numpy, c; both by default")
    validate.add_argument("--cases", metavar="N", type=_positive, help="samples of each stratum")
    validate.add_argument("--digits", metavar="D", type=_positive, help="digits of the oracle")
    validate.add_argument("--seed", metavar="S", type=int, help="of the cases")
    validate.add_argument(
        "--stratum", metavar="NAME", action="append", help="only this; repeatable"
    )
    validate.add_argument("--peer", metavar="NAME", action="append", help="heyoka, dop853, lsoda…")
    instead = validate.add_mutually_exclusive_group()
    instead.add_argument("--case", metavar="CASE", help="STRATUM:INDEX or FILE.toml, at each time")
    instead.add_argument("--faults", action="store_true", help="which injected faults are noticed")
    instead.add_argument("--resume", action="store_true", help="go on with the campaign in -o DIR")
    where = validate.add_mutually_exclusive_group()
    where.add_argument("--workers", metavar="W", type=_positive, help="processes; all cores")
    where.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster, tcp://…")
    validate.add_argument("-o", "--output", metavar="DIR", type=_path, help="JSON, Markdown, HTML")
    validate.add_argument("--json", action="store_true", help="to stdout alone")
    validate.add_argument("--record", action="store_true", help="for the heads of the modules")

    propagate = command("propagate", _propagate, "states of one motion")
    propagate.add_argument("case", metavar="CASE.toml", help="a case file, or `paper`")
    propagate.add_argument("--digits", metavar="D", type=_positive, help="significant, all certain")
    propagate.add_argument("--enclose", action="store_true", help="balls: middles and radii")
    propagate.add_argument("--method", metavar="M", help="theta, carlson, landen or quadrature")
    propagate.add_argument("--max-seconds", metavar="S", type=_seconds, help="for all the digits")
    propagate.add_argument(
        "--format",
        choices=("csv", "json", "npz", "aem"),
        default="csv",
        help="npz holds doubles, aem is the CCSDS attitude ephemeris message",
    )
    propagate.add_argument("-o", "--output", metavar="FILE", type=_path, help="instead of stdout")
    propagate.add_argument("--allow-nonphysical", action="store_true", help="any body")
    message = propagate.add_argument_group("of --format aem")
    for name, (metavar, summary) in _MESSAGE.items():
        message.add_argument(f"--{name}", metavar=metavar, help=summary)
    message.add_argument(
        "--no-rates", dest="rates", action="store_false", default=None, help="quaternions only"
    )

    methods = command("methods", _methods, "cost and accuracy of the methods for many digits")
    methods.add_argument("case", metavar="CASE", nargs="?", default="paper", help="a case file")
    methods.add_argument("--digits", metavar="D", type=_positive, nargs="+", help="to compare at")
    methods.add_argument("-o", "--output", metavar="DIR", type=_path, help="JSON and a plot")
    methods.add_argument("--json", action="store_true", help="to stdout alone")
    methods.add_argument("--allow-nonphysical", action="store_true", help="any body")

    from rigidsym.manoeuvre import commands as manoeuvres

    manoeuvres.add(command, manoeuvres.Tools(_path, _positive, _table, _progress, _say))
    return parser


def _version() -> str:
    import rigidsym

    return rigidsym.__version__


def _path(text: str) -> Path:
    if not text:
        raise argparse.ArgumentTypeError("'' must name a file or directory")
    return Path(text)


def _positive(text: str) -> int:
    if not re.fullmatch(r"[0-9]+(_[0-9]+)*", text) or not 1 <= int(text[:20]) <= _MOST:
        rule = f"must be a whole number, at least 1 and at most {_MOST}"
        raise argparse.ArgumentTypeError(f"{text!r:.40} {rule}")
    return int(text)


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r:.40} must be a positive number of seconds")
    return seconds


def _progress(label: str) -> Callable[[int, int], None]:
    """A progress bar with the time left on a terminal, silence elsewhere; called with what is done
    and the total."""
    if not sys.stderr.isatty():
        return lambda done, total: None
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn())
    bar = Progress(*columns, console=Console(stderr=True), transient=True)
    task = bar.add_task(label)
    bar.start()
    _BARS.callback(bar.stop)

    def show(done: int, total: int) -> None:
        bar.update(task, completed=done, total=total)
        if done == total:
            bar.stop()

    return show


def _table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(title=title, title_justify="left")
    for column in columns:
        table.add_column(column, overflow="fold")
    for row in rows:
        table.add_row(*map(Text, row))
    console = Console(width=None if sys.stdout.isatty() else 120)
    with console.capture() as text:
        console.print(table)
    sys.stdout.write(text.get())


def _say(message: str) -> None:
    print(message, file=sys.stderr)


def _reproduce(options: Any) -> int:
    from rigidsym.derive import DerivationError
    from rigidsym.files import probe
    from rigidsym.reproduce import reproduce

    probe(options.output)
    rows: list[tuple[str, str, str, str]] = []

    def say(stage: str, found: str, seconds: float, passed: bool) -> None:
        _say(f"{stage}: {found} ({seconds:.1f} s)")
        rows.append((stage, found, f"{seconds:.1f} s", "ok" if passed else "FAILED"))

    try:
        result = reproduce(options.output, say, _progress)
    except DerivationError as error:
        _say(f"rigidsym reproduce: {error}")
        return 1
    _table("rigidsym reproduce", ("stage", "result", "time", ""), rows)
    print(f"report: {options.output / 'report.md'}")
    return 0 if result.passed else 1


def _derive(options: Any) -> int:
    from rigidsym.derive import DerivationError, derive, sealed_path
    from rigidsym.files import write_text

    try:
        derivation = derive(options.chapters, _progress("derive"))
    except DerivationError as error:
        _say(f"rigidsym derive: {error}")
        return 1
    if options.json:
        print(derivation.to_json(), end="")
    else:
        rows = [
            (chapter.name, chapter.title, str(len(chapter.facts)), f"{chapter.seconds:.2f} s")
            for chapter in derivation.chapters
        ]
        _table("rigidsym derive", ("chapter", "", "facts", "time"), rows)
    sys.stdout.flush()
    if options.chapters and options.output is None:
        _say("the ledger is sealed by all chapters together: not written")
    else:
        _say(f"ledger: {write_text(options.output or sealed_path(), derivation.ledger)}")
    return 0


def _check(options: Any) -> int:
    if options.independent:
        return _check_independently(options.ledger)
    from collections import Counter

    from rigidsym.algebra.enclosures import encloses
    from rigidsym.kernel import KernelError, replay

    try:
        ledger = replay(_ledger_text(options.ledger), encloses)
    except KernelError as error:
        _say(f"rigidsym check: refused: {error}")
        return 1
    grades = Counter(fact.grade for fact in ledger.facts.values())
    counts = ", ".join(f"{count} {grade}" for grade, count in grades.most_common())
    print(f"{counts} facts in {len(ledger.contexts)} contexts: accepted")
    return 0


def _check_independently(path: Path | None) -> int:
    from rigidsym.independent import Refused, check

    try:
        facts = check(_ledger_text(path))
    except Refused as error:
        _say(f"rigidsym check: refused by the independent checker: {error}")
        return 1
    print(f"{facts} facts: accepted by the independent checker")
    return 0


def _ledger_text(path: Path | None) -> str:
    from rigidsym.files import read_text
    from rigidsym.solution import ledger_text

    return ledger_text() if path is None else read_text("ledger", path)


def _errata(options: Any) -> int:
    import json

    from rigidsym.paper import row, verdicts
    from rigidsym.solution import ledger_data

    ruled = verdicts(ledger_data(_ledger_text(None)))
    if options.json:
        data = {"schema": "rigidsym.errata/1", "equations": [v.to_json() for v in ruled]}
        print(json.dumps(data, indent=1))
        return 0
    columns = ("equation", "verdict", "repair, or how it is read", "counterexample")
    _table("rigidsym errata", columns, [row(verdict) for verdict in ruled])
    return 0


def _codegen(options: Any) -> int:
    from rigidsym.codegen import generate
    from rigidsym.seal import seal, seal_text
    from rigidsym.solution import sealed

    generated = generate(options.target)
    seal(sealed())
    seal_text(generated, sealed())
    if options.stdout:
        print("".join(generated.files.values()), end="")
        return 0
    directory = options.output or _generated_directory()
    if options.check:
        return _differences(generated.texts(), directory)
    for path in generated.write(directory):
        _say(f"wrote {path}")
    return 0


def _generated_directory() -> Path:
    import rigidsym.generated

    return Path(rigidsym.generated.__path__[0])


def _differences(texts: dict[str, str], directory: Path) -> int:
    """Print a diff against the files that are there; 1 where there is one."""
    from difflib import unified_diff

    status = 0
    for name, text in texts.items():
        path = directory / name
        there = path.read_text("utf-8", errors="replace") if path.is_file() else ""
        if there != text:
            status = 1
            lines = unified_diff(there.splitlines(True), text.splitlines(True), str(path), "new")
            sys.stdout.writelines(lines)
    print("differs" if status else "current", file=sys.stderr)
    return status


def _trace(options: Any) -> int:
    from rigidsym.trace import TraceError, lines_of_equation, origin_of_line

    if (options.place is None) == (options.equation is None):
        given = options.place or options.equation or "nothing"
        raise InputError("trace", given, "takes either FILE:LINE or --equation NUMBER")
    try:
        found = (
            lines_of_equation(options.equation)
            if options.place is None
            else origin_of_line(options.place)
        )
    except TraceError as error:
        _say(f"rigidsym trace: {error}")
        return 1
    for line in found:
        print(line)
    return 0


def _validate(options: Any) -> int:
    from rigidsym.files import probe
    from rigidsym.validate import session

    names = {"targets": "targets", "peer": "peers", "stratum": "strata"}
    names |= {name: name for name in ("cases", "digits", "seed")}
    given = {name: getattr(options, option) for option, name in names.items()}
    chosen = {name: value for name, value in given.items() if value not in (None, [])}
    mode = "case" if options.case else "faults" if options.faults else ""
    for name in _NOT_WITH.get(mode, ()):
        if getattr(options, name) not in (None, False):
            raise InputError(name, "given", f"is not for --{mode}")
    if options.output and not options.resume:
        probe(options.output)
    # What a batch system sends is an interrupt, too.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    whole, done = session.begin(chosen, None if mode else options.output, options.resume)
    if options.case:
        return _validate_case(whole, options)
    return _validate_faults(whole, options) if options.faults else _campaign(whole, done, options)


# Options of a campaign that mean nothing elsewhere.
_NOT_WITH = {
    "case": ("cases", "stratum", "workers", "scheduler", "record"),
    "faults": ("peer", "workers", "scheduler", "record"),
}


def _campaign(whole: Any, done: Any, options: Any) -> int:
    from rigidsym.validate import checkpoint, executors, session, tables, validation
    from rigidsym.validate.record import record

    place = (
        executors.local(options.workers)
        if options.scheduler is None
        else executors.cluster(options.scheduler)
    )
    kept = checkpoint.Checkpoint(options.output, whole, done) if options.output else None
    report = validation.conduct(whole, done, place, _progress("validate"), kept)
    if kept:
        _say(f"report: {session.write(report, options.output)}")
        kept.remove()
    if options.record:
        _say(f"recorded: {record(report)}")
    run = report.run
    _say(
        f"{run['enclosed states']} states in {run['seconds']} s, "
        f"{run['enclosed states a second']} a second, {run['place']}"
    )
    for complaint in report.complaints:
        _say(f"broken: {complaint}")
    title = f"{report.command}: worst errors in units of 2^-53"
    with _reader_may_leave():
        if options.json:
            print(report.to_json(), end="", flush=True)
        else:
            _table(title, *tables.summary(report))
    return 0 if report.passed else 1


@contextmanager
def _reader_may_leave() -> Generator[None]:
    """Printing to a reader that goes away, as `head` does, changes no exit status."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        _discard_output()


def _validate_case(whole: Any, options: Any) -> int:
    import json

    from rigidsym.validate import case_file, session, tables

    finding = session.replay(options.case, whole)
    if options.output:
        path = options.output / case_file.file_name(finding.sample)
        _say(f"case: {case_file.write(path, finding.sample)}")
    with _reader_may_leave():
        if options.json:
            print(json.dumps(finding.to_data(), indent=1, sort_keys=True))
        else:
            print(case_file.toml(finding.sample), end="")
            _table(f"{options.case}, {finding.reference.regime.value}", *tables.case(finding))
    return 0 if max(map(finding.share, whole.targets)) <= 1 else 1


def _validate_faults(whole: Any, options: Any) -> int:
    from rigidsym.files import write_text
    from rigidsym.validate.faults import inject

    drawn = (whole.targets, whole.cases, whole.digits, whole.seed)
    report = inject(*drawn, progress=_progress("validate --faults"), strata=whole.strata)
    if options.output:
        write_text(options.output / "faults.json", report.to_json())
        write_text(options.output / "faults.md", report.to_markdown())
    for fault in report.missed:
        _say(f"not caught: {fault.target}: {fault.name}")
    with _reader_may_leave():
        print(report.to_json() if options.json else report.to_markdown(), end="", flush=True)
    return 0 if report.passed else 1


def _propagate(options: Any) -> int:
    from rigidsym.files import write_bytes
    from rigidsym.states import FORMATS

    certain = options.digits or options.enclose
    if options.format == "npz" and (options.output is None or certain):
        rule = "holds doubles and goes to a file: give -o FILE, no --digits and no --enclose"
        raise InputError("format", "npz", rule)
    for name in ("method", "max_seconds"):
        if getattr(options, name) is not None and not certain:
            rule = "is for many digits: give --digits D or --enclose"
            raise InputError(name.replace("_", "-"), getattr(options, name), rule)
    heading = _heading(options)
    if options.format == "aem":
        data = _message(_case(options), heading)
    else:
        data = FORMATS[options.format](_states(_case(options), options))
    if options.output:
        write_bytes(options.output, data)
    else:
        sys.stdout.write(data.decode())
    return 0


def _heading(options: Any) -> dict[str, Any]:
    """The options that a message takes, by name; another format takes none of them."""
    names = [name.replace("-", "_") for name in _MESSAGE]
    given = {name: getattr(options, name) for name in (*names, "rates")}
    given = {name: value for name, value in given.items() if value is not None}
    if options.format != "aem":
        for name in given:
            option = "no-rates" if name == "rates" else name.replace("_", "-")
            value = "given" if name == "rates" else given[name]
            raise InputError(option, value, "is for --format aem")
    elif options.digits or options.enclose:
        rule = "has 16 digits by its standard: no --digits and no --enclose"
        raise InputError("format", "aem", rule)
    elif "epoch" not in given:
        rule = "--format aem needs --epoch YYYY-MM-DDThh:mm:ss[.d...]"
        raise InputError("epoch", "missing", rule)
    return given


def _message(case: Any, heading: dict[str, Any]) -> bytes:
    from rigidsym import inputs
    from rigidsym.export import aem, sampled

    track = sampled(case.motion, inputs.doubles("times", case.times))
    names = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
    whole: dict[str, Any] = {**names, **heading}
    return aem(track, **whole).encode()


def _case(options: Any) -> Any:
    from rigidsym.cases import load_case, paper_case

    if options.case == "paper":
        return paper_case()
    return load_case(options.case, options.allow_nonphysical)


def _states(case: Any, options: Any) -> Any:
    from rigidsym import states

    given = {"method": options.method, "max_seconds": options.max_seconds}
    how = {name: value for name, value in given.items() if value is not None}
    if options.enclose:
        return states.balls(case, options.digits or 50, **how)
    if options.digits:
        return states.decimals(case, options.digits, **how)
    return states.doubles(case)


def _methods(options: Any) -> int:
    from rigidsym.comparison import DIGITS, compare
    from rigidsym.files import probe, write_text

    if options.output:
        probe(options.output)
    found = compare(_case(options), options.digits or DIGITS, _progress("methods"))
    if options.json:
        print(found.to_json(), end="")
    else:
        columns = ("method", "first state", "one more", "error below", "radius")
        rows = [m.row(str(m.digits)) for m in found.by_digits]
        _table("rigidsym methods", ("digits", *columns), rows)
        if found.by_distance:
            rows = [m.row(str(m.distance)) for m in found.by_distance]
            _table("rigidsym methods: near the separatrix", ("distance", *columns), rows)
    if options.output:
        write_text(options.output / "methods.json", found.to_json())
        write_text(options.output / "methods.svg", found.to_svg())
    return 0
