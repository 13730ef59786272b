"""What the seal decides: that something printed is what was derived."""

from dataclasses import dataclass

from rigidsym.codegen.ir import Let
from rigidsym.codegen.seal.equality import is_equal
from rigidsym.errors import InputError
from rigidsym.language.expression import Expression

DIFFERS = "what is printed is not what was derived"


@dataclass(frozen=True, slots=True)
class Claim:
    """That what is printed for a formula, at a place, equals what was derived."""

    place: str
    formula: str
    derived: Expression
    printed: Expression

    def decide(self) -> None:
        """Raises InputError, naming place and formula, unless both are equal."""
        if not is_equal(self.derived, self.printed):
            raise InputError(self.place, self.formula, DIFFERS)


def formulas_of(lets: tuple[Let, ...]) -> dict[str, Expression]:
    """Expressions by what they set, where that is one name."""
    return {let.targets[0]: let.expression for let in lets if len(let.targets) == 1}
