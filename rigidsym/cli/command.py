"""The `rigidsym` command: parses, calls, prints.  Heavy modules are imported by the commands.

Exit status: 0 success; 1 a claim, certificate, comparison or bound fails; 2 bad input or usage.
"""

import argparse
import gc
import sys
from collections.abc import Callable, Sequence

from rigidsym._version import __version__
from rigidsym.cli import (
    code,
    errata,
    fits,
    manoeuvres,
    proofs,
    reproduction,
    states,
    templates,
    validation,
)
from rigidsym.cli.arguments import Help, Parser
from rigidsym.cli.output import BARS, discard_output, prepare_output
from rigidsym.errors import InputError, LedgerError, PrecisionError

# In the order of the help.
_GROUPS = (reproduction, errata, proofs, code, validation, states, manoeuvres, fits, templates)
_FIRST = """to begin with:
  rigidsym propagate paper            states of the paper's spacecraft
  rigidsym init motion.toml           a file for a body of your own
  rigidsym COMMAND --help             all about one command, with an example"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit status."""
    prepare_output()
    # A proof makes millions of tuples and few cycles: looking for these took a tenth of its time.
    gc.set_threshold(100_000, 50, 50)
    options = parser().parse_args(arguments)
    try:
        with BARS:
            status = options.run(options)
        sys.stdout.flush()
        return status
    except (InputError, LedgerError, PrecisionError) as error:
        print(f"rigidsym {options.command}: {error}", file=sys.stderr)
        return 1 if isinstance(error, PrecisionError) else 2
    except BrokenPipeError:  # the reader went away, as `head` does
        discard_output()
        return 0
    except OSError as error:
        print(f"rigidsym {options.command}: output: {error.strerror}", file=sys.stderr)
        discard_output()
        return 2
    except KeyboardInterrupt as stopped:
        print(f"rigidsym {options.command}: {str(stopped) or 'interrupted'}", file=sys.stderr)
        return 130


def parser() -> argparse.ArgumentParser:
    """All commands and their arguments."""
    whole = Parser(
        prog="rigidsym",
        description="Exact torque-free motion of a rigid body.",
        epilog=_FIRST,
        formatter_class=Help,
    )
    whole.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    commands = whole.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def command(
        name: str, run: Callable[[argparse.Namespace], int], summary: str, example: str
    ) -> argparse.ArgumentParser:
        added = commands.add_parser(
            name,
            help=summary,
            description=summary,
            epilog=f"example:\n  rigidsym {example}",
            formatter_class=Help,
        )
        added.set_defaults(run=run)
        return added

    for group in _GROUPS:
        group.add(command)
    # For what speaks of all commands.
    whole.set_defaults(whole=whole)
    return whole
