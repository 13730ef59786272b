"""What stands around the lines of one function in C."""

from dataclasses import dataclass

from rigidsym.codegen.ir import Function


@dataclass(frozen=True, slots=True)
class Frame:
    """A function as C has it, and the statements before and after its lines.

    number: what begins the names of operations on its extended numbers.
    """

    name: str
    function: Function
    number: str
    before: tuple[str, ...]
    after: tuple[str, ...]
