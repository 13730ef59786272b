"""What the ledger is asked about a printed line: definitions and equations in a context's texts."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from rigidsym.language.expression import Expression
from rigidsym.language.expression import parse as expression
from rigidsym.proof.paper.equation import Equation, Sense
from rigidsym.proof.paper.printed import Display, Statement, parse, translate
from rigidsym.proof.paper.printed.translation import defined

Texts = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Question:
    """Whether equations hold in a context that has some definitions from the print."""

    context: str
    definitions: Mapping[str, str]
    lhs: Texts
    rhs: Texts


def question(latex: str, sense: Sense, printed: Mapping[str, Equation]) -> Question:
    """A line as a sense puts it; PrintError where the vocabulary has no word for it."""
    line = printed[sense.of].latex if sense.of else latex
    own = [parse(sense.latex if sense.latex is not None else line)]
    if sense.only:
        own = [tuple(own[0][k] for k in sense.only)]
    given = [parse(printed[number].latex) for number in sense.given]
    given += [parse(printed[number].repair) for number in sense.mended]
    displays = [_definitions(display, sense.defines) for display in given]
    said = [parse(text) for text in sense.says]
    found = translate(
        [*displays, *own, *said],
        sense.vocabulary,
        sense.defines,
        differentiated=sense.differentiated,
    )
    equations = [*found.equations, *sense.texts.items()]
    lhs, rhs = zip(*equations, strict=True) if equations else ((), ())
    return Question(sense.context, found.definitions, lhs, rhs)


def news(asked: Question, context: Mapping[str, Any]) -> tuple[Texts, Texts]:
    """Both sides of the equations that a context does not say itself, by definition or rate."""
    rates = {f"D({name})": text for name, text in (context["rates"] or {}).items()}
    told = {**context["definitions"], **rates}
    said = {frozenset(map(_tree, pair)) for pair in told.items() if pair[1] != "?"}
    pairs = [
        pair
        for pair in zip(asked.lhs, asked.rhs, strict=True)
        if len(sides := frozenset(map(_tree, pair))) > 1 and sides not in said
    ]
    lhs, rhs = zip(*pairs, strict=True) if pairs else ((), ())
    return lhs, rhs


def _tree(text: str) -> Expression:
    return expression(text)


def _definitions(display: Display, defines: Mapping[str, str]) -> Display:
    """The statements of a display that define something."""
    return tuple(
        piece
        for piece in display
        if isinstance(piece, Statement) and defined(piece.sides[0]) in defines
    )


def asked(equation: Equation) -> Iterator[tuple[str, Sense]]:
    """Everything that is asked about a line: what is put, and how."""
    yield from ((equation.latex, sense) for sense in equation.senses)
    for reading in equation.readings:
        yield from ((equation.latex, sense) for sense in reading.senses)
    yield from ((equation.repair, sense) for sense in equation.mended)
    for senses in equation.with_mended.values():
        yield from ((equation.latex, sense) for sense in senses)
    for condition in equation.conditions:
        yield from ((equation.latex, sense) for sense in condition.needed_by)
