"""`seal_text(generated, solution)`: printed files read back, all of their text."""

from rigidsym.codegen.forms import split
from rigidsym.codegen.functions import constants, functions
from rigidsym.codegen.generate import Generated
from rigidsym.codegen.seal import digests, places
from rigidsym.codegen.targets import reader
from rigidsym.solution import Solution


def seal_text(generated: Generated, solution: Solution) -> int:
    """Read the files of a module back; returns how many derived lines there are.

    Raises InputError, naming function or line, where one is not what the lets say or the map tells,
    where what is written by hand is not what the package brings, and where a digest is that of
    other files.
    """
    target, form = split(generated.manifest["target"])
    decided = reader(target)(generated.files, functions(solution, form), constants(), form)
    digests.check(generated)
    places.check(generated)
    return decided
