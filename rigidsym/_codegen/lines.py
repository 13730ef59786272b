"""Lines of generated code, their comments, and counts of lines by kind."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import TypedDict

from rigidsym._codegen.forms import split
from rigidsym._codegen.ir import KINDS, Function, Let

_COMMENTS = {True: r"#[^\n]*", False: r"/\*.*?\*/|//[^\n]*"}
MEANINGS = {
    "fact": "follow facts of the ledger, each named on its line",
    "classical": "follow classical formulas, each with its reference",
    "arithmetic": "are arithmetic: sums, products, quotients, roots, reductions",
    "runtime": "are the runtime, printed from its one representation",
    "by hand": "are written by hand",
}


class Place(TypedDict):
    """Entry of the line map: number, kind, equations and facts of a derived line.

    Numbers are from 1.
    """

    line: int
    kind: str
    equations: list[str]
    facts: list[str]


@dataclass(frozen=True, slots=True)
class Lines:
    """Lines of generated code, and the assignment behind each derived line.

    `lets` is keyed by the index of the line, from 0.
    """

    text: tuple[str, ...]
    lets: Mapping[int, Let]

    @classmethod
    def plain(cls, text: str) -> "Lines":
        """Split hand-written text into lines that have no assignments behind them."""
        return cls(tuple(text.removesuffix("\n").split("\n")), {})

    def kinds(self) -> Iterator[str]:
        """Yield the kind of each derived line."""
        return (let.kind for let in self.lets.values())


def joined(pieces: Iterable[Lines]) -> Lines:
    """Concatenate pieces of code, and renumber their derived lines."""
    text: list[str] = []
    lets: dict[int, Let] = {}
    for piece in pieces:
        lets |= {len(text) + number: let for number, let in piece.lets.items()}
        text += piece.text
    return Lines(tuple(text), lets)


@dataclass(frozen=True, slots=True)
class Module:
    """Printed module: its files, the assignments behind their lines, and the digest."""

    files: Mapping[str, str]
    lets: Mapping[str, Mapping[int, Let]]
    digest: str

    def places(self) -> dict[str, list[Place]]:
        """Return the entries of the line map for each file."""
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
    """Return the comment on an assignment: its kind, facts, equations and references."""
    return note(let.kind, let.facts, let.source)


def note(kind: str, facts: Iterable[str], source: Iterable[str]) -> str:
    """Format the comment on a line from its kind, facts and sources.

    Numbers of the paper's equations are put in brackets.

    >>> note("fact", ["definition attitude.M_a", "attitude.K"], ["8", "15"])
    'fact: definition attitude.M_a, attitude.K; (8), (15)'
    """
    equations = ", ".join(f"({s})" if s[0].isdigit() else s for s in source)
    said = "; ".join(filter(None, (", ".join(facts), equations)))
    return f"{kind}: {said}" if said else kind


def flat_results(function: Function) -> list[str]:
    """Return the names of the doubles that a function returns.

    A split result is two doubles, `<name>_hi` and `<name>_lo`.
    """
    return [
        flat
        for name in function.results
        for flat in ((f"{name}_hi", f"{name}_lo") if name in function.split else (name,))
    ]


def shares(kinds: Iterable[str], runtime: int, by_hand: int) -> str:
    """Format a table with the number and share of each kind of lines in a module.

    kinds: the kinds of the derived lines.  runtime: the number of lines that are printed from the
    one representation of the runtime.  by_hand: the number of those written for the target.
    """
    found = Counter(kinds)
    counts = {kind: found[kind] for kind in KINDS} | {"runtime": runtime, "by hand": by_hand}
    whole = sum(counts.values())
    rows = (
        f"  {count:5} {round(100 * count / whole):3} %  {MEANINGS[kind]}"
        for kind, count in counts.items()
    )
    return "\n".join(["Lines of code:", *rows])


def handwritten(text: str, target: str) -> int:
    """Count the hand-written lines in a module's text, without blank lines and comments."""
    return sum(code_lines(part, target) for part in texts_by_hand(target) if part in text)


def beside(target: str) -> int:
    """Count the hand-written lines beside what is generated, without blank lines and comments."""
    return sum(code_lines(text, target) for text in texts_by_hand(target))


@cache
def texts_by_hand(target: str) -> tuple[str, ...]:
    """Return all texts in the folder of a target that are written by hand, for its modules.

    The server of its process, and types of TypeScript, are not of a module.
    """
    home = resources.files("rigidsym._codegen.targets").joinpath(target)
    files = sorted((x for x in home.iterdir() if x.is_file()), key=lambda x: x.name)
    apart = re.compile(r"server\.\w+$|.*\.d\.mts$")
    files = [file for file in files if not apart.match(file.name)]
    # What stands above such a mark makes the file a module of Python, and is not printed.
    parts = (re.split(r"# --- [a-z-]+ ---\n", file.read_text("utf-8")) for file in files)
    named = ((file.name.endswith(".py"), part) for file, part in zip(files, parts, strict=True))
    return tuple(part[-1].strip() for is_module, part in named if len(part) > is_module)


def code_lines(text: str, module: str) -> int:
    """Count the lines of a text without blank lines and comments."""
    target, _ = split(module)
    bare = re.sub(_COMMENTS[target == "numpy"], "", text, flags=re.DOTALL)
    return sum(bool(line.strip()) for line in bare.splitlines())
