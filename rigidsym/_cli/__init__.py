"""The `rigidsym` command: its argument parser and its exit status.

Exit status: 0 success; 1 a claim, certificate, comparison or bound fails; 2 bad input or usage.
"""

import argparse
import gc
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import Any, NoReturn

from rigidsym._cli.commands import COMMANDS, Argument
from rigidsym._cli.destination import destination
from rigidsym._cli.output import BARS, discard_output, prepare_output
from rigidsym._version import __version__
from rigidsym.errors import InputError, LedgerError, PrecisionError, nearest

_FIRST = """to begin with:
  rigidsym propagate paper            states of the paper's spacecraft
  rigidsym init motion.toml           a template for a body of your own
  rigidsym COMMAND --help             all about one command, with an example"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit status."""
    prepare_output()
    # A proof makes millions of tuples and few cycles: looking for these took a tenth of its time.
    gc.set_threshold(100_000, 50, 50)
    options = parser().parse_args(arguments)
    try:
        if getattr(options, "output", None) is not None:
            command = next(one for one in COMMANDS if one.name == options.command)
            given = sys.argv[1:] if arguments is None else arguments
            options.output = destination(command, options, given)
        module, _, function = options.run.partition(":")
        with BARS:
            status = getattr(import_module(f"rigidsym._cli.{module}"), function)(options)
        sys.stdout.flush()
        return status
    except (InputError, LedgerError, PrecisionError, ImportError) as error:
        if isinstance(error, ImportError):  # of a package that is not installed
            if (error.name or "").partition(".")[0] == "rigidsym":
                raise
            error = InputError("packages", error.name or "missing", str(error))
        print(f"rigidsym {options.command}: {error}", file=sys.stderr)
        return 1 if isinstance(error, PrecisionError) else 2
    except BrokenPipeError:  # the reader of a pipe has closed it, as `head` does
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
    """Build the argument parser from the table of commands."""
    whole = _Parser(
        prog="rigidsym",
        description="Exact torque-free motion of a rigid body.",
        epilog=_FIRST,
        formatter_class=_Help,
    )
    whole.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    commands = whole.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for command in COMMANDS:
        added = commands.add_parser(
            command.name,
            help=command.summary,
            description=command.summary,
            epilog=f"example:\n  rigidsym {command.example}",
            formatter_class=_Help,
        )
        added.set_defaults(run=command.run)
        for entry in command.arguments:
            if isinstance(entry, Argument):
                added.add_argument(*entry.names, **entry.keywords)
                continue
            titled = added.add_argument_group(entry.title) if entry.title else None
            group = titled or added.add_mutually_exclusive_group()
            for one in entry.arguments:
                group.add_argument(*one.names, **one.keywords)
    return whole


class _Parser(argparse.ArgumentParser):
    """A parser that reports errors in one line."""

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse arguments; report an unknown option with the nearest option of this command."""
        found, others = super().parse_known_args(args, namespace)
        for other in others:
            name = other.partition("=")[0]
            near = nearest(name, self._option_string_actions) if name.startswith("-") else ""
            self.error(f"unknown argument {other}{near and f': did you mean {near}?'}")
        return found, others

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Raise ArgumentError with the nearest choice for a value that is none of the choices."""
        if action.choices is not None and value not in action.choices:
            known = [str(choice) for choice in action.choices]
            near = nearest(value, known)
            hint = f" (did you mean {near}?)" if near else ""
            raise argparse.ArgumentError(
                action, f"{value!r:.40} must be one of: {', '.join(known)}{hint}"
            )

    def error(self, message: str) -> NoReturn:
        """Print one line that points to the help, and exit with status 2."""
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")


class _Help(argparse.RawDescriptionHelpFormatter):
    """Formatter that appends default values to the help texts of options."""

    def _get_help_string(self, action: argparse.Action) -> str | None:
        silent = action.default in (None, argparse.SUPPRESS) or isinstance(action.default, bool)
        return action.help if silent else f"{action.help} (default: %(default)s)"
