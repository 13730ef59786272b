"""Printed lines and the lets behind them, whatever the language."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TypedDict

from rigidsym.codegen.ir import Function, Let


class Place(TypedDict):
    """A derived line, counted from 1, with its equations and facts, as JSON has them."""

    line: int
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
                {"line": number + 1, "equations": list(let.source), "facts": list(let.facts)}
                for number, let in sorted(lets.items())
            ]
            for name, lets in self.lets.items()
        }


def comment(let: Let) -> str:
    """The equations and facts behind a let."""
    equations = ", ".join(f"({s})" if s[0].isdigit() else s for s in let.source)
    return "; ".join(filter(None, (equations, " ".join(let.facts))))


def flat_results(function: Function) -> list[str]:
    """The results of a function as doubles: those that are split as two."""
    return [
        flat
        for name in function.results
        for flat in ((f"{name}_hi", f"{name}_lo") if name in function.split else (name,))
    ]
