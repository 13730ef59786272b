"""Printed lines and the lets behind them, whatever the language."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TypedDict

from rigidsym.codegen.ir import Function, Let


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
        """Text that no let stands behind; a line feed at its end ends the last line."""
        return cls(tuple(text.removesuffix("\n").split("\n")), {})

    def kinds(self) -> Iterator[str]:
        """What each derived line is."""
        return (let.kind for let in self.lets.values())


def joined(pieces: Iterable[Lines]) -> Lines:
    """One piece after the other."""
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
        """For each file, the derived lines (counted from 1) with their equations and facts."""
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
    """What a let is, the facts behind it, and equations and references."""
    return note(let.kind, let.facts, let.source)


def note(kind: str, facts: Iterable[str], source: Iterable[str]) -> str:
    """The comment of a line; equations of the paper are in brackets.

    >>> note("fact", ["definition attitude.M_a", "attitude.K"], ["8", "15"])
    'fact: definition attitude.M_a, attitude.K; (8), (15)'
    """
    equations = ", ".join(f"({s})" if s[0].isdigit() else s for s in source)
    said = "; ".join(filter(None, (", ".join(facts), equations)))
    return f"{kind}: {said}" if said else kind


def flat_results(function: Function) -> list[str]:
    """The results of a function as doubles: those that are split as two."""
    return [
        flat
        for name in function.results
        for flat in ((f"{name}_hi", f"{name}_lo") if name in function.split else (name,))
    ]
