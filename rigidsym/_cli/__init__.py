"""The `rigidsym` command."""

from rigidsym._cli.command import main, parser

__all__ = ["main", "parser"]
