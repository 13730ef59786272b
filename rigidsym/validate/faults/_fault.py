"""Faults as replacements of text in generated modules, with a table of hand-written faults."""

import re
import tomllib
from dataclasses import dataclass
from importlib import resources

from rigidsym._codegen.forms import STEP, split

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
    """Error for a fault whose old text is not in the generated text exactly once."""


@dataclass(frozen=True, slots=True)
class Fault:
    """Replacement of a piece of text in one paragraph of a generated module.

    old, new: the text before and after.  The paragraph is the one that begins with `paragraph`; it
    ends with the next empty line.  options: of the compiler, beyond the usual ones.
    in_sensitivities: states do not show the fault.  change: for a drawn fault, what is changed, as
    HARMLESS names it.
    """

    target: str
    kind: str
    name: str
    paragraph: str
    old: str
    new: str
    options: tuple[str, ...] = ()
    in_sensitivities: bool = False
    change: str = ""

    @property
    def shown_in(self) -> str:
        """The kind of results that the fault changes: states, sensitivities or steps."""
        of_states = "steps" if split(self.target)[1] == STEP else "states"
        return "sensitivities" if self.in_sensitivities else of_states

    def __post_init__(self) -> None:
        if self.target not in FILES or self.kind not in KINDS:
            raise ValueError(f"{self.line}: no such target or kind")
        if self.old == self.new or _LOOPS.search(self.old) or _LOOPS.search(self.new):
            raise ValueError(f"{self.line}: must change something, and no loop")

    @property
    def line(self) -> str:
        """The target and the name of the fault as one line of text."""
        return f"{self.target}: {self.name}"

    def applied(self, text: str) -> str:
        """Return the text of a module after this fault is injected.

        Raises StaleFaultError if `old` is not there exactly once.
        """
        begin = self._only(text, self.paragraph, FILES[self.target])
        end = text.find("\n\n", begin)
        place = text[begin : end if end >= 0 else len(text)]
        at = begin + self._only(place, self.old, f"the paragraph of {self.paragraph!r}")
        return text[:at] + self.new + text[at + len(self.old) :]

    def _only(self, text: str, part: str, where: str) -> int:
        """Return the position of the only occurrence of a part in a text."""
        if (count := text.count(part)) != 1:
            raise StaleFaultError(f"{self.line}: {part!r} is {count} times in {where}, not once")
        return text.index(part)


_TABLE = resources.files("rigidsym.validate.faults").joinpath("by_hand.toml").read_text("utf-8")
# Faults in hand-written runtime text, and faults that no change of one place of a tree makes.
BY_HAND = tuple(
    Fault(target, kind, name, paragraph, old, new, tuple(options))
    for target, kinds in tomllib.loads(_TABLE).items()
    for kind, faults in kinds.items()
    for name, (paragraph, old, new, *options) in faults.items()
)
