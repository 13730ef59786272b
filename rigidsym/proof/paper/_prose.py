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
from rigidsym.proof.paper._shared import ACROSS, OFF_AXIS, stated
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


def _printed(*numbers: str) -> tuple[tuple[str, Sense], ...]:
    """Return the senses of printed lines, each with its number."""
    lines = {equation.number: equation for equation in EQUATIONS}
    return tuple((number, sense) for number in numbers for sense in lines[number].senses)


def _stated(number: str, context: str, **texts: str) -> tuple[tuple[str, Sense], ...]:
    """Return senses that state equations of a context, one by one, about a printed line."""
    return tuple((number, stated(context, {left: right})) for left, right in texts.items())


# Half a period later, the rates about two axes have the other sign, and psi has grown.
_LATER = (
    {
        "sigma*A_a*dn_later": "Omega_a",
        "chi*A_b*sn_later": "-Omega_b",
        "chi*A_d*tau*cn_later": "-Omega_d",
    },
    {"psi_later - psi": "period*(psi_0 + J_c*mu*kappa/K_1)/2"},
)
PROSE = (
    Prose(
        "an attitude representation which is not Euler-angle-like",
        "abstract, sections I and V",
        "no",
        "phi1, phi2, phi3 of (25) are proper Euler angles, about the axes 1, 2, 1, and (18) is "
        "made of their half angles; that no inverse trigonometric function is printed is all",
        (*_printed("25"), ("18", section4.EIGHTEEN)),
    ),
    Prose(
        "independently of theta functions",
        "sections I, IV and V",
        "yes, but theta functions are faster",
        "by (34), phi1 is an elliptic integral of the third kind, which Carlson's R_J evaluates; "
        "as code, this form takes longer than that by theta functions, and is as accurate",
        _printed("34"),
        ("rigidsym codegen c --form pi", "rigidsym compare-forms"),
    ),
    Prose(
        "simpler solutions [of tops] can be obtained when SU(2) is used",
        "section II, of Klein",
        "true of the free body; tops are not decided",
        "each component of the quaternion is the real or imaginary part of one theta function over "
        "a square root; those of a rotation matrix are sums of products of two.  No fact is about "
        "a body in a field, or about who discovered it",
        (
            *_stated("18", "theta_form", qbar_0="P4_re/N", qbar_a="sigma*P4_im/N"),
            *_stated("18", "theta_form", qbar_b="chi*P1_im/N"),
            *_stated("18", "theta_form", qbar_d="-epsilon*sigma*chi*P1_re/N"),
            *_stated("24", "theta_form", M_b="2*sigma*K*(qbar_a*qbar_b - epsilon*qbar_0*qbar_d)"),
        ),
    ),
    Prose(
        "quaternions depending only on the angular velocities",
        "section V",
        "no: the rates fix the attitude up to a turn about the momentum",
        "(27) and (29) give phi2 and phi3 by the rates, but phi1 of (33) is an integral over time; "
        "after a period the rates are the same, and the attitude has turned about the momentum",
        (*_printed("27", "29", "33"), *(("33", stated("period", texts)) for texts in _LATER)),
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
        "low computational",
        "section V",
        "yes for thrusters; for wheels the eigenaxis needs no search",
        "the closed form finds all natural motions that arrive in milliseconds, in a tenth of the "
        "time that integrated motions take; wheels do best near a turn about the eigenaxis, which "
        "one formula gives",
        (),
        ("python tests/benchmarks/manoeuvres.py --shooting 40", COMPARE),
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
