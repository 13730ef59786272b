"""`seal_text(generated, solution)`: printed files read back as the lines they print."""

from rigidsym.codegen.functions import constants, functions
from rigidsym.codegen.generate import Generated
from rigidsym.codegen.targets import reader
from rigidsym.solution import Solution


def seal_text(generated: Generated, solution: Solution) -> int:
    """Read every derived line of a module back; returns how many there are.

    Raises InputError, naming function and line, where one is not what the lets say.
    """
    check = reader(str(generated.manifest["target"]))
    return check(generated.files, functions(solution), constants())
