"""Start of a process in which Node.js runs the module."""

import shutil
from importlib.resources.abc import Traversable
from pathlib import Path

from rigidsym._codegen.forms import split
from rigidsym._codegen.targets.javascript.module import FILES
from rigidsym.errors import InputError


def command(name: str, home: Traversable, cache: Path) -> list[str]:
    """Return the command that starts the process.

    name: the key of the module, for example "javascript-pi".  home: the folder of generated files.
    Raises InputError without Node.js.
    """
    node = shutil.which("node")
    if node is None:
        raise InputError("engine", name, "needs Node.js (node) on the path")
    module = home.joinpath(FILES[split(name)[1]])
    return [node, str(Path(__file__).with_suffix(".mjs")), str(module)]
