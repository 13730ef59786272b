"""Target languages of code generation, with one folder for each.

The folder of a target `x` has

    module.py      build(functions, constants, form).  Input: functions of lets, the numbers they
                   name, and the form of the solution that they are.  Output: the module, its files
                   and the let behind each derived line.
    read_back.py   check(files, functions, constants, form).  Input: the files as printed, and what
                   they print.  Output: how many lines read back as their lets.

    server.py      command(module, home, cache), of targets that compute states in a process of
                   their own.  Input: the key of a module, for example "javascript-pi", the folder
                   of generated files, and one for what is compiled.  Output: the command that
                   starts the process, which answers as `rigidsym._engines.piped` says.

and whatever these use: a printer, and text written by hand.  TARGETS lists it.
"""

from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.resources.abc import Traversable
from pathlib import Path
from types import ModuleType

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.forms import FORMS
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.lines import Module
from rigidsym.errors import InputError, unknown

Build = Callable[[tuple[Function, ...], tuple[Constant, ...], str], Module]
Check = Callable[[Mapping[str, str], tuple[Function, ...], tuple[Constant, ...], str], int]
Command = Callable[[str, Traversable, Path], list[str]]

TARGETS = ["numpy", "c", "javascript", "c_single", "rust"]
# Sets of files for C that are more than modules: code, unit tests, checks and records.
PROFILES = ("flight",)


def known(target: str) -> str:
    """Check the name of a target, and return it unchanged.

    Raises InputError for an unknown target.
    """
    if not isinstance(target, str) or target not in TARGETS:
        raise unknown("target", target, TARGETS, plain=True)
    return target


def builder(target: str) -> Build:
    """Return the function that builds the module of a target.

    Raises InputError for an unknown target.
    """
    return import_module(f"{__name__}.{known(target)}.module").build


def format_of(target: str) -> Format:
    """Return the floating-point format that a target computes in.

    It is that which its module names FORMAT, by default binary64.
    """
    return getattr(import_module(f"{__name__}.{known(target)}.module"), "FORMAT", BINARY64)


def forms_of(target: str) -> tuple[str, ...]:
    """Return the forms of the solution that a target has.

    They are those which its module names FORMS, by default all.
    """
    return getattr(import_module(f"{__name__}.{known(target)}.module"), "FORMS", tuple(FORMS))


def reader(target: str) -> Check:
    """Return the function that reads a target's printed files back and checks them.

    Raises InputError for a target that has none.
    """
    return _module(target, "read_back", "it cannot be sealed").check


def server(target: str) -> Command:
    """Return the function that gives the command of a target's process.

    Raises InputError for a target that has none.
    """
    return _module(target, "server", "it computes no states").command


def _module(target: str, part: str, lack: str) -> ModuleType:
    """Import a module of a target's folder; raise InputError where the folder does not have it."""
    name = f"{__name__}.{target}.{part}"
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        # A package that the module itself imports may be missing instead.
        if error.name not in (name, f"{__name__}.{target}"):
            raise
        raise InputError("target", target, f"has no {part}.py: {lack}") from None
