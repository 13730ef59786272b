"""Faults: small changes of a generated text, each where it says and nowhere else."""

import re
from dataclasses import dataclass

from rigidsym.codegen.forms import STEP, split

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
}
FILES = {
    "numpy": "torque_free.py",
    "c": "torque_free.c",
    "numpy-pi": "torque_free_pi.py",
    "c-pi": "torque_free_pi.c",
    "numpy-step": "torque_free_step.py",
    "c-step": "torque_free_step.c",
}
# A fault in the head of a loop, or one that makes a loop, might never end.
_LOOPS = re.compile(r"\b(for|while|do|goto)\b")


class StaleFaultError(ValueError):
    """A fault whose place is not in the generated text, or not just once."""


@dataclass(frozen=True, slots=True)
class Fault:
    """`old` made `new` in the paragraph of a target's module that begins with `paragraph`.

    A paragraph ends with the next empty line.  `options` are the compiler's, beyond the usual ones.
    in_sensitivities: states show nothing of it.
    """

    target: str
    kind: str
    name: str
    paragraph: str
    old: str
    new: str
    options: tuple[str, ...] = ()
    in_sensitivities: bool = False

    @property
    def shown_in(self) -> str:
        """What shows it: states, sensitivities, or steps."""
        of_states = "steps" if split(self.target)[1] == STEP else "states"
        return "sensitivities" if self.in_sensitivities else of_states

    def __post_init__(self) -> None:
        if self.target not in FILES or self.kind not in KINDS:
            raise ValueError(f"{self.line}: no such target or kind")
        if self.old == self.new or _LOOPS.search(self.old) or _LOOPS.search(self.new):
            raise ValueError(f"{self.line}: must change something, and no loop")

    @property
    def line(self) -> str:
        """Target and name."""
        return f"{self.target}: {self.name}"

    def applied(self, text: str) -> str:
        """The faulty text; raises StaleFaultError where the text is not what the fault was for."""
        begin = self._only(text, self.paragraph, FILES[self.target])
        end = text.find("\n\n", begin)
        place = text[begin : end if end >= 0 else len(text)]
        at = begin + self._only(place, self.old, f"the paragraph of {self.paragraph!r}")
        return text[:at] + self.new + text[at + len(self.old) :]

    def _only(self, text: str, part: str, where: str) -> int:
        """Where the one occurrence of a part begins."""
        if (count := text.count(part)) != 1:
            raise StaleFaultError(f"{self.line}: {part!r} is {count} times in {where}, not once")
        return text.index(part)
