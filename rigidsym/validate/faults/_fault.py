"""Faults as changes of one place of what a module is printed from."""

import re
from dataclasses import dataclass

from rigidsym._codegen.forms import STEP, split
from rigidsym._engines import EVERY, STEPPERS
from rigidsym.validate._singles import TARGETS as SINGLES

KINDS = {
    "constant": "a constant off by one part in 1e12, or by its last digits",
    "precision": "a number rounded to single precision",
    "series": "a term dropped from a series",
    "ladder": "a step of Landen's ladder dropped or wrong",
    "axis": "two axes swapped",
    "sign": "a sign that is never, or always, turned",
    "branch": "the wrong regime, branch or decision",
    "winding": "whole turns or periods lost",
    "quadrant": "a wrong sign or angle in some quadrants",
    "double_cover_sign": "the other double-cover sign of an attitude",
    "pair": "the digits beyond a double lost",
    "scale": "a power of two forgotten",
    "attitude": "a wrong product of quaternions, or a wrong length",
    "steady": "a wrong state of a motion with constant rates",
    "special": "no number, or a wrong one, in a special case",
    "callers": "the caller's memory kept, or one body's refusal mistaken for another's",
    "entry_points": "a wrong state by one entry point of several",
    "build": "a build by options that reorder or approximate, and that asks nothing of itself",
    "ulps": "an error of some units in the last place",
    "torques": "a wrong torque, orbit, or order of drifts and kicks",
}
TARGETS = (*EVERY, *STEPPERS, *SINGLES)
# Text of a target that might not end: a fault must not make or change it.
_LOOPS = re.compile(r"\b(for|while|do|goto)\b")
# A loop of the runtime ends, unless a bound falls below zero or its step is zero.
_ENDLESS = re.compile(r"range\([^)]*(-|, 0\))")
# The file of the runtime, and the derived function, that only motions under torques show.
_OF_TORQUES = ("kick", "step_kick")
# A place in the representation: of a derived function and its assignment, of a file of the runtime
# and a routine there, or a named number.
_PLACE = re.compile(r"\w+(\.\w+)?")


class StaleFaultError(ValueError):
    """Error for a fault whose old text is not in the generated text exactly once."""


@dataclass(frozen=True, slots=True)
class Fault:
    """Change of a piece of text in one place of the representation, or of a target's own text.

    place: where `old` stands once, and `new` takes its place.  "circular_constants.h" is the
    expression that a derived function assigns to h, "motion.begin" the routine `begin` in a file of
    the runtime, and "over_3" a named number.  Other places are paragraphs of text that is written
    by hand for the target: they begin with `place`, and end with the next empty line.
    options: of the compiler, beyond the usual ones.  in_sensitivities: states do not show the
    fault.  change: for a drawn fault, what is changed, as HARMLESS names it.
    """

    target: str
    kind: str
    name: str
    place: str
    old: str
    new: str
    options: tuple[str, ...] = ()
    in_sensitivities: bool = False
    change: str = ""

    @property
    def shown_in(self) -> str:
        """What shows the fault: states, steps (of floats: "in singles"), sensitivities, torques."""
        if self.place.partition(".")[0] in _OF_TORQUES:
            return "torques"
        of_states = "steps" if split(self.target)[1] == STEP else "states"
        if self.target in SINGLES:
            return f"{of_states} in singles"
        return "sensitivities" if self.in_sensitivities else of_states

    @property
    def is_of_text(self) -> bool:
        """True if text that is written by hand for the target is changed."""
        return not _PLACE.fullmatch(self.place)

    def __post_init__(self) -> None:
        if self.target not in TARGETS or self.kind not in KINDS:
            raise ValueError(f"{self.line}: no such target or kind")
        is_endless = _LOOPS.search(f"{self.old} {self.new}") if self.is_of_text else None
        if self.old == self.new or is_endless or _ENDLESS.search(self.new):
            raise ValueError(f"{self.line}: must change something, and make no endless loop")

    @property
    def line(self) -> str:
        """The target and the name of the fault as one line of text."""
        return f"{self.target}: {self.name}"

    def applied(self, text: str) -> str:
        """Return the text of the place after the change.

        Raises StaleFaultError if `old` is not there exactly once.
        """
        begin, end, where = 0, len(text), self.place
        if self.is_of_text:
            begin = self._only(text, self.place, "the module")
            end = text.find("\n\n", begin) if "\n\n" in text[begin:] else end
            where = f"the paragraph of {self.place!r}"
        at = begin + self._only(text[begin:end], self.old, where)
        return text[:at] + self.new + text[at + len(self.old) :]

    def _only(self, text: str, part: str, where: str) -> int:
        """Return the position of the only occurrence of a part in a text."""
        if (count := text.count(part)) != 1:
            raise StaleFaultError(f"{self.line}: {part!r} is {count} times in {where}, not once")
        return text.index(part)
