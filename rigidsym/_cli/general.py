"""Functions that run the commands `reproduce`, `init` and `completion`."""

from argparse import Namespace
from importlib import resources
from pathlib import Path

from rigidsym._cli.output import progress, say, say_written, table
from rigidsym.errors import InputError, package
from rigidsym.io._files import probe, write_text


def reproduce(options: Namespace) -> int:
    """Reproduce all results of the package, and print a table of the stages.

    Returns 1 if a stage fails.
    """
    from rigidsym._reproduce import reproduce
    from rigidsym.proof.derivation import DerivationError

    probe(options.output)
    rows: list[tuple[str, str, str, str]] = []

    def tell(stage: str, found: str, seconds: float, passed: bool) -> None:
        say(f"{stage}: {found} ({seconds:.1f} s)")
        rows.append((stage, found, f"{seconds:.1f} s", "ok" if passed else "FAILED"))

    try:
        result = reproduce(options.output, tell, progress)
    except DerivationError as error:
        say(f"rigidsym reproduce: {error}")
        return 1
    table("rigidsym reproduce", ("stage", "result", "time", ""), rows)
    print(f"report: {options.output / 'report.html'}, and as text report.md")
    return 0 if result.passed else 1


def init(options: Namespace) -> int:
    """Write a commented template of an input file."""
    path = options.output or Path(options.template)
    if path.exists():
        raise InputError("output", path, "is there already: give -o FILE")
    text = resources.files("rigidsym.io").joinpath("templates", options.template).read_text("utf-8")
    say_written([write_text(path, text)])
    return 0


def completion(options: Namespace) -> int:
    """Print a script that completes `rigidsym` commands in a shell."""
    from rigidsym._cli import parser

    shtab = package("shtab", "rigidsym completion", "completion")
    print(shtab.complete(parser(), options.shell))
    return 0
