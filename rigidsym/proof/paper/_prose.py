"""Claims that the paper makes in words, with our verdicts on them.

Such a verdict is called a judgement.  It rests on facts of the ledger, or on numbers that a command
prints.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from rigidsym.proof.paper import _section4 as section4
from rigidsym.proof.paper._answers import Answers, Data, ids
from rigidsym.proof.paper._equation import Equation, Sense
from rigidsym.proof.paper._proof import PROOF
from rigidsym.proof.paper._shared import ACROSS, OFF_AXIS
from rigidsym.proof.paper._verdicts import EQUATIONS

COMPARE = "rigidsym compare"


@dataclass(frozen=True, slots=True)
class Prose:
    """A claim that the paper makes in words, with our judgement and its reason.

    `senses` pairs numbers of lines with senses that facts decide; `commands` measure the rest.
    """

    claim: str
    where: str
    judgement: str
    reason: str
    senses: tuple[tuple[str, Sense], ...] = ()
    commands: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Judged:
    """A claim in words, together with the facts that decide it.

    It is open if a fact is missing.
    """

    prose: Prose
    facts: tuple[str, ...]
    decided: bool

    @property
    def judgement(self) -> str:
        """The judgement, or "open" if a fact is missing."""
        return self.prose.judgement if self.decided else "open"

    def to_json(self) -> dict[str, Any]:
        """Return the judged claim as JSON data."""
        return {
            "claim": self.prose.claim,
            "where": self.prose.where,
            "judgement": self.judgement,
            "reason": self.prose.reason,
            "facts": list(self.facts),
            "measured_by": list(self.prose.commands),
        }


(_TURNS,) = (("25", sense) for e in PROOF if e.number == "25" for sense in e.senses)
PROSE = (
    Prose(
        "an attitude representation which is not Euler-angle-like",
        "abstract, sections I and V",
        "no",
        "phi1, phi2, phi3 of (25) are proper Euler angles, about the axes 1, 2, 1, and (18) is "
        "made of their half angles; that no inverse trigonometric function is printed is all",
        (_TURNS, ("18", section4.EIGHTEEN)),
    ),
    Prose(
        "elegant and compact form",
        "abstract, sections I and V",
        "not for longer than half a period",
        "F1 to F4 need signs that follow c3 Omega3, with jumps where it changes",
        (("19", section4.ANY_OUTER_SIGNS), ("19", section4.CONTINUOUS)),
    ),
    Prose(
        "they constitute a non-singular set of variables",
        "section V",
        "the quaternions do, the formulas for them do not",
        "(18) is a unit quaternion throughout; (32) and (33) divide by zero where the momentum "
        "is along axis 1, y of (19) where Omega3 = 0",
        (
            ("footnote 3", section4.FRAME),
            *(("32", sense) for sense in OFF_AXIS.needed_by),
            ("29", ACROSS),
        ),
    ),
    Prose(
        "reaction wheels track the natural motion",
        "section V, in the simulation",
        "not the motion of the paper",
        "wheels keep the momentum that they take: while they turn, the body moves as a gyrostat, "
        "and where they have all of the momentum it coasts about a fixed axis",
        (),
        (COMPARE,),
    ),
    Prose(
        "reasonably close to the minimum-fuel one",
        "section V",
        "for thrusters; not for wheels",
        "two bursts with a coast between them cost about the least fuel where something outside "
        "is pushed against, and more than a turn about the eigenaxis where wheels turn the body",
        (),
        (COMPARE,),
    ),
)


def judged(ledger: Data, equations: Sequence[Equation] = EQUATIONS) -> list[Judged]:
    """Judge all claims in words by the facts of a ledger.

    The ledger is JSON data.
    """
    answers = Answers(ledger, equations)
    ruled = []
    for prose in PROSE:
        found = [answers.to(answers.printed[number].latex, sense) for number, sense in prose.senses]
        decided = all(answer.fact is not None for answer in found)
        ruled.append(Judged(prose, (*ids(found, "equal"), *ids(found, "unequal")), decided))
    return ruled
