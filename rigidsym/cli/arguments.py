"""Arguments of commands, and how they are refused: in one line."""

import argparse
import re
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

# Adds a command: its name, what runs it, what its help says first, and an example of it.
Command = Callable[..., argparse.ArgumentParser]
_MOST = 999_999_999


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        """Leave with status 2, and say where to read on."""
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")


class Help(argparse.RawDescriptionHelpFormatter):
    """Says what is so by default, where an option has a value by itself."""

    def _get_help_string(self, action: argparse.Action) -> str | None:
        silent = action.default in (None, argparse.SUPPRESS) or isinstance(action.default, bool)
        return action.help if silent else f"{action.help} (default: %(default)s)"


def as_path(text: str) -> Path:
    """The type of a file or directory."""
    if not text:
        raise argparse.ArgumentTypeError("'' must name a file or directory")
    return Path(text)


def as_count(text: str) -> int:
    """The type of a whole number above zero."""
    if not re.fullmatch(r"[0-9]+(_[0-9]+)*", text) or not 1 <= int(text[:20]) <= _MOST:
        rule = f"must be a whole number, at least 1 and at most {_MOST}"
        raise argparse.ArgumentTypeError(f"{text!r:.40} {rule}")
    return int(text)


def as_seconds(text: str) -> float:
    """The type of a time that is above zero."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r:.40} must be a positive number of seconds")
    return seconds
