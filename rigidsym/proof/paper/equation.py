"""What a printed equation is made of: text, readings, conditions, flaws and the facts behind them.

These are values.  Nothing here says what is true: `rigidsym.proof.paper.verdicts` asks the ledger.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from rigidsym.view.html.printed import equation_html


class Flaw(StrEnum):
    """What can be wrong with a printed line, whether or not it is false."""

    VARIABLE = "roots of another variable"
    MODULUS = "parameter read as modulus"
    LEFT_SIDE = "wrong left side"
    UNDEFINED = "undefined symbol"
    TWICE = "number or symbol used twice"
    TWO_WAYS = "condition stated two ways"
    WEAK = "condition too weak"
    SIGNS = "signs that cannot be constant"
    IMAGINARY = "imaginary on real motions"
    BRANCH = "branch not named"
    ORDER = "factors in another order"
    COMPONENT = "component equated with a matrix"
    REASON = "wrong reason"
    REFERENCE = "wrong reference"


@dataclass(frozen=True, slots=True)
class Condition:
    """What has to be so: the units of the proofs that it speaks for, and why it cannot go.

    `needed_by` names facts: without the condition a denominator is zero, or there is a
    counterexample.
    """

    text: str
    units: tuple[str, ...] = ()
    needed_by: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read the print, what follows from it, and the facts that say so.

    A reading fails where a fact refutes the print so read; `proved_by` backs what it implies.
    """

    text: str
    implies: str
    proved_by: tuple[str, ...] = ()
    refuted_by: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Equation:
    """One printed equation: its number, LaTeX, how it is read, and the facts that decide it.

    `repair` is what mends it, `repair_form` the same as the repair search writes it.
    """

    number: str
    latex: str
    reading: str
    proved_by: tuple[str, ...] = ()
    refuted_by: tuple[str, ...] = ()
    conditions: tuple[Condition, ...] = ()
    repair: str = ""
    repair_form: str = ""
    readings: tuple[Reading, ...] = ()
    flaws: Mapping[Flaw, str] = field(default_factory=dict)

    @property
    def needed_by(self) -> tuple[str, ...]:
        """The facts that show the conditions necessary."""
        return tuple(dict.fromkeys(name for c in self.conditions for name in c.needed_by))

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"

    def _repr_html_(self) -> str:
        return equation_html(self)
