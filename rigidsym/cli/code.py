"""The commands `codegen` and `trace`."""

import sys
from argparse import Namespace
from pathlib import Path

from rigidsym.cli.arguments import Command, as_path
from rigidsym.cli.output import say, say_written
from rigidsym.errors import InputError


def add(command: Command) -> None:
    """Give the command line its commands about generated code."""
    codegen = command("codegen", _codegen, "write a numeric module", "codegen c -o attitude")
    codegen.add_argument("target", metavar="TARGET", help="numpy or c")
    codegen.add_argument(
        "--form", metavar="FORM", default="theta", help="theta, or the paper's: pi"
    )
    where = codegen.add_mutually_exclusive_group()
    where.add_argument("-o", "--output", metavar="DIR", type=as_path, help="for the files")
    where.add_argument(
        "--in-place",
        action="store_true",
        help="into the package itself, whose modules they replace",
    )
    instead = codegen.add_mutually_exclusive_group()
    instead.add_argument(
        "--check", action="store_true", help="compare with what is in DIR, or in the package"
    )
    instead.add_argument("--stdout", action="store_true", help="print the module")

    trace = command(
        "trace",
        _trace,
        "a generated line's facts and equations; an equation's lines",
        "trace --equation 34",
    )
    trace.add_argument("place", metavar="FILE[:LINE]", nargs="?", help="of a generated file")
    trace.add_argument("--equation", metavar="NUMBER", help="as the paper numbers it")


def _codegen(options: Namespace) -> int:
    from rigidsym.cli.proofs import replayed
    from rigidsym.codegen import generate
    from rigidsym.codegen.seal import seal, seal_text
    from rigidsym.codegen.targets import builder
    from rigidsym.solution import sealed

    builder(options.target)
    if not (options.output or options.in_place or options.check or options.stdout):
        rule = "give -o DIR (. for here), --stdout, --check, or --in-place for the package itself"
        raise InputError("output", "missing", rule)
    replayed()
    generated = generate(options.target, form=options.form)
    seal(sealed(), options.form)
    seal_text(generated, sealed())
    if options.stdout:
        print("".join(generated.files.values()), end="")
        return 0
    directory = options.output or _generated_directory()
    if options.check:
        return _differences(generated.texts(), directory)
    say_written(generated.write(directory))
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


def _trace(options: Namespace) -> int:
    from rigidsym.codegen.trace import TraceError, lines_of_equation, told
    from rigidsym.proof.paper import EQUATIONS

    if (options.place is None) == (options.equation is None):
        given = options.place or options.equation or "nothing"
        raise InputError("trace", given, "takes either FILE:LINE, FILE, or --equation NUMBER")
    try:
        if options.place is not None:
            found = told(options.place)
        else:
            found = lines_of_equation(options.equation, [e.number for e in EQUATIONS])
    except TraceError as error:
        say(f"rigidsym trace: {error}")
        return 1
    for line in found:
        print(line)
    return 0
