"""Check of the option -o: a directory for several files, and a file for one."""

import shlex
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from rigidsym._cli.commands import Command
from rigidsym.errors import InputError

# Names that end so are of files.  Others may be of directories, with or without a dot.
_ENDINGS = {
    *(".aem", ".c", ".csv", ".h", ".html", ".ipynb", ".jpg", ".js", ".json", ".md", ".mjs", ".npz"),
    *(".pdf", ".png", ".py", ".rs", ".svg", ".tex", ".toml", ".ts", ".txt", ".v", ".zip"),
}
_ARTICLES = {"text": ".txt", "markdown": ".md", "latex": ".tex", "html": ".html"}


def destination(command: Command, options: Namespace, arguments: Sequence[str]) -> Path:
    """Return the path that -o gives to a command.

    Raises InputError for a file where the command writes several files, and for a directory where
    it writes one.  The message has the right command.
    """
    given: str = options.output
    path = Path(given)
    if command.output == "DIR":
        is_file = path.exists() or path.is_symlink() or path.suffix.lower() in _ENDINGS
        if path.is_dir() or not is_file:
            return path
        rule, instead = "several files, to a directory", path.with_suffix("")
        if path.exists() and not path.is_file():  # a device or a pipe
            instead = Path(command.name)
        elif instead.exists() and not instead.is_dir():
            instead = path.with_name(f"{path.stem}-files")
    else:
        if not (path.is_dir() or given.endswith("/")):
            return path
        rule, instead = "one file", path / _file(command, options)
    kind = "a file" if command.output == "DIR" else "a directory"
    right = shlex.join(["rigidsym", *(_put(one, given, str(instead)) for one in arguments)])
    raise InputError("output", given, f"is {kind}: `{command.name}` writes {rule}: use `{right}`")


def _file(command: Command, options: Namespace) -> Path:
    """Return a name for the one file that a command writes."""
    if command.name == "init":
        return Path(options.template)
    form = getattr(options, "format", None)
    if form in _ARTICLES:
        return Path(f"article{_ARTICLES[form]}")
    found = Path(command.example.rpartition(" ")[2])
    return found.with_suffix(f".{form}") if form else found


def _put(argument: str, given: str, instead: str) -> str:
    """Replace the value of -o in one argument of the command line."""
    for before in ("", "-o", "-o=", "--output="):
        if argument == f"{before}{given}":
            return f"{before}{instead}"
    return argument
