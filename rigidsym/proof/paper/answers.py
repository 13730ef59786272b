"""What a ledger answers: the fact that says what a line says, found by its texts."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rigidsym.proof.paper.equation import Equation, Sense
from rigidsym.proof.paper.questions import Question, question, telling

Data = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Answer:
    """A question, and the fact of a ledger that decides it; None where no fact does."""

    question: Question
    fact: Data | None

    @property
    def holds(self) -> bool | None:
        """Whether the equations hold; None where that is open."""
        return None if self.fact is None else self.fact["kind"] == "equal"


class Answers:
    """The facts of a ledger by what they say."""

    def __init__(self, ledger: Data, equations: Iterable[Equation]) -> None:
        self.contexts = {context["name"]: context for context in ledger["contexts"]}
        self.printed = {equation.number: equation for equation in equations}
        self._all = ledger["facts"]
        self.facts = {
            (fact["context"], *map(tuple, (fact["lhs"], fact["rhs"]))): fact
            for fact in ledger["facts"]
            if fact["kind"] in ("equal", "unequal") and _sound(fact)
        }

    def citing(self, number: str) -> list[str]:
        """The facts that name a line as their source."""
        return [fact["id"] for fact in self._all if number in fact["source"]]

    def to(self, latex: str, sense: Sense) -> Answer:
        """The answer to a line as a sense puts it."""
        asked = question(latex, sense, self.printed)
        context = self.contexts.get(asked.context)
        if context is None or not asked.definitions.items() <= context["definitions"].items():
            return Answer(asked, None)
        asked = telling(asked, context["definitions"], context["rates"] or {})
        return Answer(asked, self.facts.get((asked.context, asked.lhs, asked.rhs)))


def _sound(fact: Data) -> bool:
    return fact["grade"] == "PROVED" and fact["id"].startswith(fact["context"] + ".")


def together(answers: Iterable[Answer]) -> bool | None:
    """Whether all hold: one that fails is enough to fail, one that is open leaves the rest open."""
    held = [answer.holds for answer in answers]
    return None if None in held else all(held)


def ids(answers: Iterable[Answer], kind: str) -> tuple[str, ...]:
    """The facts of a kind behind answers, each once."""
    facts = [answer.fact for answer in answers if answer.fact is not None]
    return tuple(dict.fromkeys(fact["id"] for fact in facts if fact["kind"] == kind))
