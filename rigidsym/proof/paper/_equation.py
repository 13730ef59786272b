"""Data types for printed equations, with their translations, flaws and repairs.

A sense translates a line into a context; a reading is one way to understand the print.  Nothing
here states what is true: `rigidsym.proof.paper._verdicts` finds that in the ledger.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from rigidsym.proof.paper._printed import PLAIN, Vocabulary
from rigidsym.view._proofs import equation_html


class Flaw(StrEnum):
    """Kind of a flaw in a printed line.

    A flawed line may still be true.
    """

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
    JUDGEMENT = "a judgement"
    JUMP = "sign of q jumps"


class Root(StrEnum):
    """A root error of the paper; together, these errors explain all its misprints."""

    SCALE = "(14) and (10) to (12) take the roots in different variables"
    HALF_ANGLE = "y* serves one sign of c3 Omega3, and the signs are constant"
    MODULUS = "mu^2 is printed for mu"
    DOT = "phi1' is printed for phi1"


@dataclass(frozen=True, slots=True)
class Sense:
    """A translation of a printed line into the language of a context.

    A fact of this context decides the line.
    `defines` maps names that the line defines to the context's names; `says` are further equations
    from the paper's text.  `given` are other displays whose definitions are used as printed,
    `mended` those used as repaired.  The line `of` another number, or `latex`, replaces the line
    itself; `only` selects statements of it; `texts` are equations in the context's language.
    `differentiated` compares the time derivatives of both sides.
    """

    context: str
    vocabulary: Vocabulary = PLAIN
    defines: Mapping[str, str] = field(default_factory=dict)
    says: tuple[str, ...] = ()
    given: tuple[str, ...] = ()
    mended: tuple[str, ...] = ()
    of: str = ""
    latex: str | None = None
    only: tuple[int, ...] = ()
    texts: Mapping[str, str] = field(default_factory=dict)
    differentiated: bool = False


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition under which a printed line holds.

    `units` are the divisors that it covers.
    The senses `needed_by` show that without it a denominator is zero, or the line fails.
    """

    text: str
    units: tuple[str, ...] = ()
    needed_by: tuple[Sense, ...] = ()


@dataclass(frozen=True, slots=True)
class Reading:
    """One possible interpretation of an ambiguous printed line.

    `implies` says what follows from it, and the senses decide it.
    """

    text: str
    implies: str
    senses: tuple[Sense, ...]


@dataclass(frozen=True, slots=True)
class Equation:
    """A printed equation of the paper, with its translations and its repair.

    `reading` says it in words.  The `senses` decide it.
    `repair` is the mended line, with the senses `mended`; `roots` are the slips that it comes from,
    and `with_mended` are the senses where another line is repaired and this one is not.
    """

    number: str
    latex: str
    reading: str
    senses: tuple[Sense, ...]
    conditions: tuple[Condition, ...] = ()
    repair: str = ""
    mended: tuple[Sense, ...] = ()
    readings: tuple[Reading, ...] = ()
    flaws: Mapping[Flaw, str] = field(default_factory=dict)
    roots: tuple[Root, ...] = ()
    with_mended: Mapping[str, tuple[Sense, ...]] = field(default_factory=dict)

    def __repr__(self) -> str:
        return f"<Equation ({self.number}): {self.reading}>"

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"

    def _repr_html_(self) -> str:
        return equation_html(self)
