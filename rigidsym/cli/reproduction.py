"""The command `reproduce`, which runs the main job and tells of its stages."""

from argparse import Namespace

from rigidsym.cli.arguments import Command, as_path
from rigidsym.cli.output import progress, say, table


def add(command: Command) -> None:
    """Give the command line its main command."""
    reproduce = command(
        "reproduce",
        _reproduce,
        "derive, check, generate, validate and report",
        "reproduce -o reproduce",
    )
    reproduce.add_argument(
        "-o", "--output", metavar="DIR", default="reproduce", type=as_path, help="for the results"
    )


def _reproduce(options: Namespace) -> int:
    from rigidsym.io.files import probe
    from rigidsym.proof.derivation import DerivationError
    from rigidsym.reproduce import reproduce

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
