"""Search for the facts of the ledger that decide the paper's printed lines.

A question consists of definitions and equations in a context.  The fact with the same texts
answers it.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from rigidsym.language import _expression
from rigidsym.language._expression import Call, Expression, Name
from rigidsym.proof.paper._equation import Equation, Sense
from rigidsym.proof.paper._printed import Display, PrintError, Statement, parse, translate
from rigidsym.proof.paper._printed.interpreter import defined

Texts = Mapping[str, str]
# The same texts are parsed for every line that a context decides.
parse_text = lru_cache(maxsize=4096)(_expression.parse)


@dataclass(frozen=True, slots=True)
class Question:
    """The equations of one printed line, to be decided by a fact of the ledger.

    `definitions` are the definitions that the print gives in the context.
    """

    context: str
    definitions: Texts
    lhs: tuple[str, ...]
    rhs: tuple[str, ...]


def question(latex: str, sense: Sense, printed: Mapping[str, Equation]) -> Question:
    """Translate a printed line to equations and definitions in a context.

    `sense` says how.
    Raises PrintError if the vocabulary lacks a word, or if the line states nothing.
    """
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


def without_trivial(whole: Question, definitions: Texts, rates: Texts) -> Question:
    """Drop the trivial equations of a question.

    Definitions of its context are trivial, too.
    """
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
    """Return the statements of a displayed formula that define one of the given names."""
    return tuple(
        piece
        for piece in display
        if isinstance(piece, Statement) and defined(piece.sides[0]) in defines
    )


def asked(equation: Equation) -> Iterator[tuple[str, Sense]]:
    """Yield all translations of a printed equation that the ledger has to decide.

    Each is a pair of LaTeX and sense.
    """
    yield from ((equation.latex, sense) for sense in equation.senses)
    for reading in equation.readings:
        yield from ((equation.latex, sense) for sense in reading.senses)
    yield from ((equation.repair, sense) for sense in equation.mended)
    for senses in equation.with_mended.values():
        yield from ((equation.latex, sense) for sense in senses)
    for condition in equation.conditions:
        yield from ((equation.latex, sense) for sense in condition.needed_by)


Data = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Answer:
    """A question with the fact of a ledger that decides it.

    The fact is None if the question is open.
    """

    question: Question
    fact: Data | None

    @property
    def holds(self) -> bool | None:
        """True if the equations hold, False if not, and None if they are undecided."""
        return None if self.fact is None else self.fact["kind"] == "equal"


class Answers:
    """Index of a ledger's proved equations and counterexamples.

    The keys are context and sides.
    """

    def __init__(self, ledger: Data, equations: Iterable[Equation]) -> None:
        self.contexts = {context["name"]: context for context in ledger["contexts"]}
        self.printed = {equation.number: equation for equation in equations}
        self._all = ledger["facts"]
        self.facts = {
            (fact["context"], *map(tuple, (fact["lhs"], fact["rhs"]))): fact
            for fact in ledger["facts"]
            if fact["kind"] in ("equal", "unequal") and fact["grade"] == "PROVED"
            if fact["id"].startswith(fact["context"] + ".")
        }

    def citing(self, number: str) -> list[str]:
        """Return the ids of the facts that cite a printed equation as their source."""
        return [fact["id"] for fact in self._all if number in fact["source"]]

    def to(self, latex: str, sense: Sense) -> Answer:
        """Return the ledger's answer to a printed line.

        `sense` says how to translate the line.
        """
        asked = question(latex, sense, self.printed)
        context = self.contexts.get(asked.context)
        if context is None or not asked.definitions.items() <= context["definitions"].items():
            return Answer(asked, None)
        asked = without_trivial(asked, context["definitions"], context["rates"] or {})
        return Answer(asked, self.facts.get((asked.context, asked.lhs, asked.rhs)))


def all_hold(answers: Iterable[Answer]) -> bool | None:
    """Return whether all equations hold, or None if one is undecided."""
    held = [answer.holds for answer in answers]
    return None if None in held else all(held)


def ids(answers: Iterable[Answer], kind: str) -> tuple[str, ...]:
    """Return the distinct ids of all facts of a given kind in the answers."""
    facts = [answer.fact for answer in answers if answer.fact is not None]
    return tuple(dict.fromkeys(fact["id"] for fact in facts if fact["kind"] == kind))
