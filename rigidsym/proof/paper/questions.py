"""What the ledger is asked about a printed line: definitions and equations in a context's texts."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from rigidsym.language.expression import Call, Expression, Name
from rigidsym.language.expression import parse as parse_text
from rigidsym.proof.paper.equation import Equation, Sense
from rigidsym.proof.paper.printed import Display, PrintError, Statement, parse, translate
from rigidsym.proof.paper.printed.translation import defined

Texts = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Question:
    """Whether equations hold in a context that has some definitions from the print."""

    context: str
    definitions: Texts
    lhs: tuple[str, ...]
    rhs: tuple[str, ...]


def question(latex: str, sense: Sense, printed: Mapping[str, Equation]) -> Question:
    """A line as a sense puts it; PrintError where it has no word for it, or it says nothing."""
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
    if not equations:
        raise PrintError(f"{line}: says nothing in {sense.context}")
    lhs, rhs = zip(*equations, strict=True)
    return Question(sense.context, found.definitions, lhs, rhs)


def telling(whole: Question, definitions: Texts, rates: Texts) -> Question:
    """A question without equations that say nothing, or no more than its context does."""
    known: dict[Expression, Expression] = {
        Name(name): parse_text(text) for name, text in definitions.items()
    }
    known |= {Call("D", (Name(name),)): parse_text(t) for name, t in rates.items() if t != "?"}

    def is_told(left: str, right: str) -> bool:
        x, y = parse_text(left), parse_text(right)
        return x == y or known.get(x) == y or known.get(y) == x

    pairs = [p for p in zip(whole.lhs, whole.rhs, strict=True) if not is_told(*p)]
    if not pairs:
        raise PrintError(
            f"{whole.lhs[0]} = {whole.rhs[0]}: what {whole.context} defines, and no more"
        )
    lhs, rhs = zip(*pairs, strict=True)
    return replace(whole, lhs=lhs, rhs=rhs)


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
