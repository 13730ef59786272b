"""Printed lines, the lets behind them, and how many lines are of each kind, in any language."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib import resources
from typing import TypedDict

from rigidsym._codegen.forms import STEP, THETA, split
from rigidsym._codegen.ir import KINDS, Function, Let

# And what the theta form has beside them.
SENSITIVITIES = {"numpy": "targets/numpy/sensitivity.py", "c": "targets/c/sensitivity.c"}
_COMMENT = {"numpy": r"#[^\n]*", "c": r"/\*.*?\*/"}
MEANINGS = {
    "fact": "follow facts of the ledger, each named on its line",
    "classical": "follow classical formulas, each with its reference",
    "arithmetic": "are arithmetic: sums, products, quotients, roots, reductions",
    "runtime": "are the runtime, written by hand",
}


class Place(TypedDict):
    """A derived line, counted from 1: what it is, its equations and facts, as JSON has them."""

    line: int
    kind: str
    equations: list[str]
    facts: list[str]


@dataclass(frozen=True, slots=True)
class Lines:
    """A piece of a module, and the let behind each line that derives from one, by its number."""

    text: tuple[str, ...]
    lets: Mapping[int, Let]

    @classmethod
    def plain(cls, text: str) -> "Lines":
        """Make a piece of underived text; a line feed at its end ends the last line."""
        return cls(tuple(text.removesuffix("\n").split("\n")), {})

    def kinds(self) -> Iterator[str]:
        """Yield the kind of each derived line."""
        return (let.kind for let in self.lets.values())


def joined(pieces: Iterable[Lines]) -> Lines:
    """Join pieces, one after the other."""
    text: list[str] = []
    lets: dict[int, Let] = {}
    for piece in pieces:
        lets |= {len(text) + number: let for number, let in piece.lets.items()}
        text += piece.text
    return Lines(tuple(text), lets)


@dataclass(frozen=True, slots=True)
class Module:
    """The files of a target, the lets behind the lines of each, and the digest of it all."""

    files: Mapping[str, str]
    lets: Mapping[str, Mapping[int, Let]]
    digest: str

    def places(self) -> dict[str, list[Place]]:
        """Return the derived lines of each file, counted from 1, with equations and facts."""
        return {
            name: [
                {
                    "line": number + 1,
                    "kind": let.kind,
                    "equations": list(let.source),
                    "facts": list(let.facts),
                }
                for number, let in sorted(lets.items())
            ]
            for name, lets in self.lets.items()
        }


def comment(let: Let) -> str:
    """Return the comment of a let: its kind, its facts, then equations and references."""
    return note(let.kind, let.facts, let.source)


def note(kind: str, facts: Iterable[str], source: Iterable[str]) -> str:
    """Return the comment of a line; equations of the paper are in brackets.

    >>> note("fact", ["definition attitude.M_a", "attitude.K"], ["8", "15"])
    'fact: definition attitude.M_a, attitude.K; (8), (15)'
    """
    equations = ", ".join(f"({s})" if s[0].isdigit() else s for s in source)
    said = "; ".join(filter(None, (", ".join(facts), equations)))
    return f"{kind}: {said}" if said else kind


def flat_results(function: Function) -> list[str]:
    """Return the results of a function as doubles, two where one is split."""
    return [
        flat
        for name in function.results
        for flat in ((f"{name}_hi", f"{name}_lo") if name in function.split else (name,))
    ]


def _of_c(names: str) -> tuple[str, ...]:
    return tuple(f"targets/c/{name}.c" for name in names.split())


# Written by hand, and run with what is generated: files of `rigidsym._codegen`, by target.
RUNTIMES = {
    "numpy": ("targets/numpy/runtime.py", "targets/numpy/double_double.py"),
    "numpy-step": ("targets/numpy/step.py", "targets/numpy/double_double.py"),
    "c": _of_c("runtime bodies exact arithmetic rounding quotients double_double"),
    "c-step": _of_c("step kick bodies step_arithmetic rounding quotients double_double"),
}


def shares(kinds: Iterable[str], module: str) -> str:
    """Return how many lines of a module, given by its key, are of each kind, a row each."""
    found = Counter(kinds)
    counts = {kind: found[kind] for kind in KINDS} | {"runtime": handwritten(module)}
    whole = sum(counts.values())
    rows = (
        f"  {count:5} {round(100 * count / whole):3} %  {MEANINGS[kind]}"
        for kind, count in counts.items()
    )
    return "\n".join(["Lines of code:", *rows])


def handwritten(module: str) -> int:
    """Count the lines that a module has from runtimes, without blank lines and comments."""
    target, form = split(module)
    names = RUNTIMES.get(module if form == STEP else target, ())
    if form == THETA and target in SENSITIVITIES:
        names = (*names, SENSITIVITIES[target])
    return sum(_lines_of_code(name, _COMMENT[target]) for name in names)


def _lines_of_code(name: str, comment: str) -> int:
    whole = resources.files("rigidsym._codegen").joinpath(name).read_text("utf-8")
    code = re.sub(comment, "", whole, flags=re.DOTALL)
    # Other files, where this one names them, are counted by themselves.
    code = re.sub(r"@\w+\.c@", "", code)
    return sum(bool(line.strip()) for line in code.splitlines())
