"""Functions that run the commands `codegen` and `trace`."""

import sys
from argparse import Namespace
from pathlib import Path

from rigidsym._cli.output import say, say_written
from rigidsym.errors import InputError


def codegen(options: Namespace) -> int:
    """Generate a numeric module, and write, print or check it.

    With --check, returns 1 if it differs from the files on disk.
    """
    import rigidsym.generated
    from rigidsym._cli.proofs import replayed
    from rigidsym._codegen import generate
    from rigidsym._codegen.seal import seal, seal_text
    from rigidsym._codegen.targets import builder
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
    directory = options.output or Path(rigidsym.generated.__path__[0])
    if options.check:
        return _differences(generated.texts(), directory)
    say_written(generated.write(directory))
    return 0


def _differences(texts: dict[str, str], directory: Path) -> int:
    """Print the differences between generated texts and the files in a directory.

    Returns 1 if there are any.
    """
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


def trace(options: Namespace) -> int:
    """Print the proved facts behind a generated line, or the lines derived from an equation."""
    from rigidsym._codegen.trace import TraceError, lines_of_equation, told
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
