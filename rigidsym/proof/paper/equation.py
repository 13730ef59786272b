"""What a printed equation is made of: text, readings, conditions, flaws, and how it is put.

These are values.  Nothing here says what is true: `rigidsym.proof.paper.verdicts` asks the ledger.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from rigidsym.proof.paper.printed import PLAIN, Vocabulary
from rigidsym.view.html.proofs import equation_html


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
    JUDGEMENT = "a judgement"
    JUMP = "sign of q jumps"


class Root(StrEnum):
    """The independent slips that the misprints come from."""

    SCALE = "(14) and (10) to (12) take the roots in different variables"
    HALF_ANGLE = "y* serves one sign of c3 Omega3, and the signs are constant"
    MODULUS = "mu^2 is printed for mu"
    DOT = "phi1' is printed for phi1"


@dataclass(frozen=True, slots=True)
class Sense:
    """How a line is put into the language of a context, where the ledger decides it.

    `defines` says what the line defines, as printed and in the context; `says` is what the text
    says about it.  `given` are other displays whose definitions it takes as they are printed,
    `mended` those it takes as they are repaired.  The line `of` another number, or `latex`, is
    asked in place of the line itself, or `only` some of its statements; `texts` is in the language
    of the context already.
    `differentiated` lets both sides grow alike.
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
    """What has to be so: the units of the proofs that it speaks for, and why it cannot go.

    `needed_by` is what shows it: without the condition a denominator is zero, or the line fails.
    """

    text: str
    units: tuple[str, ...] = ()
    needed_by: tuple[Sense, ...] = ()


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read the print, what it implies, and how it is put so that it can be decided."""

    text: str
    implies: str
    senses: tuple[Sense, ...]


@dataclass(frozen=True, slots=True)
class Equation:
    """One printed equation: its number, LaTeX, how it is read, and how that is put.

    `repair` is what mends it, put as `mended`; `roots` are the slips that it comes from, and
    `with_mended` is how it is put where another line is repaired and this one is not.
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
