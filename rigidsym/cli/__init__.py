"""The `rigidsym` command."""

from rigidsym.cli.command import main, parser

__all__ = ["main", "parser"]
