"""The commands `init` and `completion`: files to begin with."""

from argparse import Namespace
from importlib import resources
from pathlib import Path

from rigidsym.cli.arguments import Command, as_path
from rigidsym.cli.output import say_written
from rigidsym.errors import InputError, package

TEMPLATES = ("motion.toml", "slew.toml", "observations.csv", "observations.toml")
SHELLS = ("bash", "zsh", "tcsh")


def add(command: Command) -> None:
    """Give the command line its commands about files to begin with."""
    init = command("init", _init, "write a file to begin with, with comments", "init motion.toml")
    init.add_argument("template", metavar="TEMPLATE", choices=TEMPLATES, help=", ".join(TEMPLATES))
    init.add_argument(
        "-o", "--output", metavar="FILE", type=as_path, help="TEMPLATE, here, by default"
    )

    completion = command(
        "completion",
        _completion,
        "a script by which a shell completes this command",
        "completion bash > ~/.local/share/bash-completion/completions/rigidsym",
    )
    completion.add_argument("shell", metavar="SHELL", choices=SHELLS, help=", ".join(SHELLS))


def _init(options: Namespace) -> int:
    from rigidsym.io.files import write_text

    path = options.output or Path(options.template)
    if path.exists():
        raise InputError("output", path, "is there already: give -o FILE")
    text = resources.files("rigidsym.io").joinpath("templates", options.template).read_text("utf-8")
    say_written([write_text(path, text)])
    return 0


def _completion(options: Namespace) -> int:
    try:
        shtab = package("shtab", "rigidsym completion", "completion")
    except ImportError as error:
        raise InputError("packages", "shtab", str(error)) from None
    print(shtab.complete(options.whole, options.shell))
    return 0
