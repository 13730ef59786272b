"""`seal_text(generated, solution)`: printed files read back as the lines they print."""

from collections.abc import Callable, Mapping

from rigidsym.codegen.functions import constants, functions
from rigidsym.codegen.generate import Generated
from rigidsym.codegen.ir import Constant, Function
from rigidsym.codegen.targets.c import read_back as c_text
from rigidsym.codegen.targets.numpy import read_back as numpy_text
from rigidsym.errors import InputError
from rigidsym.solution import Solution

Reader = Callable[[Mapping[str, str], tuple[Function, ...], tuple[Constant, ...]], int]


def seal_text(generated: Generated, solution: Solution) -> int:
    """Read every derived line of a module back; returns how many there are.

    Raises InputError, naming function and line, where one is not what the lets say.
    """
    target = str(generated.manifest["target"])
    if target not in _READERS:
        raise InputError("target", target, "has no reader in rigidsym/seal: it cannot be sealed")
    reader = _READERS[target]
    return reader(generated.files, functions(solution), constants())


_READERS: dict[str, Reader] = {"numpy": numpy_text.check, "c": c_text.check}
