"""The option -o: a directory for commands that write several files, a file for others."""

import shlex
from pathlib import Path

import pytest

from rigidsym._cli import parser
from rigidsym._cli.commands import COMMANDS
from rigidsym._cli.destination import destination
from rigidsym.errors import InputError

WRITING = [command for command in COMMANDS if command.output]
# What else a command line needs.
NEEDED = {"export": "coq", "codegen": "c", "propagate": "paper", "plan": "paper", "track": "paper",
          "fit": "toutatis", "init": "motion.toml", "methods": "paper"}  # fmt: skip


def given(command, path, *more):
    """Return the path that -o gives to a command."""
    line = [command.name, *shlex.split(NEEDED.get(command.name, "")), "-o", str(path), *more]
    return destination(command, parser().parse_args(line), line)


def right_command(error):
    """Return the arguments that a message proposes."""
    return shlex.split(str(error.value).split("`")[-2])[1:]


def test_each_command_says_what_it_writes():
    kinds = {command.name: command.output for command in WRITING}
    of_one = {name for name, kind in kinds.items() if kind == "FILE"}
    assert of_one == {"derive", "propagate", "init"}
    assert {*kinds.values()} == {"DIR", "FILE"}


@pytest.mark.parametrize("command", WRITING, ids=lambda command: command.name)
def test_names_that_contradict_are_refused_with_the_right_command(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder.json").mkdir()
    if command.output == "DIR":
        good, bad = ["new", "new.1", "folder", "folder.json"], ["file", "new.json", "torque_free.c"]
    else:
        good, bad = ["new", "new.json", "file", "/dev/null"], ["folder", "folder.json", "new/"]
    for name in good:
        assert given(command, name) == Path(name)
    for name in bad:
        with pytest.raises(InputError, match=f"^output = {name}: is a ") as error:
            given(command, name)
        arguments = right_command(error)
        options = parser().parse_args(arguments)
        assert options.command == command.name
        assert destination(command, options, arguments) == Path(options.output)


@pytest.mark.parametrize(
    ("line", "right"),
    [
        ("codegen c -o torque_free.c", "codegen c -o torque_free"),
        ("codegen c --output=a.h --check", "codegen c --output=a --check"),
        ("codegen c -oa.h", "codegen c -oa"),
        ("propagate paper --format npz -o new/", "propagate paper --format npz -o new/states.npz"),
        ("derive --format latex -o new/", "derive --format latex -o new/article.tex"),
        ("derive -o new/", "derive -o new/ledger.json"),
        ("init slew.toml -o new/", "init slew.toml -o new/slew.toml"),
        ("methods -o /dev/null", "methods -o methods"),
    ],
)
def test_the_right_command_keeps_the_other_arguments(line, right, refused):
    assert f"use `rigidsym {right}`" in refused(line)
