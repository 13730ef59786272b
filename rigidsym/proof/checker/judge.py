"""The verdict: every context opens, and every fact follows by its rule from what is before it."""

from collections.abc import Generator
from contextlib import contextmanager

from rigidsym.proof.checker.language import is_name
from rigidsym.proof.checker.records import Claim, Hypotheses, Refused, fill, load
from rigidsym.proof.checker.rules import RULES, Accepted, check_news
from rigidsym.proof.checker.specification import Catalogue
from rigidsym.proof.checker.theory import Theory

WORST_TO_BEST = ["ASSUMED", "ENCLOSED", "PROVED"]


def check(text: str, specification: str = "") -> int:
    """The number of facts of a ledger, all of them accepted; Refused if anything is amiss."""
    return sum(grades(text, specification).values())


def grades(text: str, specification: str = "") -> dict[str, int]:
    """How many facts of a ledger have each grade; Refused if one is amiss, or a theorem missing."""
    with _blaming("ledger"):
        contexts, claims, published = load(text)
    judge = Judge()
    for entry in contexts:
        with _blaming("context", entry, "name"):
            judge.open(fill(Hypotheses, entry))
    for entry in claims:
        with _blaming("fact", entry, "id"):
            judge.accept(fill(Claim, entry))
    given = {name: theory.given for name, theory in judge.theories.items()}
    with _blaming("specification"):
        Catalogue(given, judge.facts, published).require(specification)
    found = [fact.grade for fact in judge.facts.values()]
    return {grade: found.count(grade) for grade in reversed(WORST_TO_BEST) if grade in found}


class Judge(Accepted):
    """Who accepts contexts and facts, one after the other."""

    def open(self, given: Hypotheses) -> None:
        """Accept a context of a new name."""
        if given.name in self.theories:
            raise Refused("this name is taken")
        self.theories[given.name] = Theory(given)

    def accept(self, fact: Claim) -> None:
        """Accept a fact of a new id whose rule holds, at the grade of its weakest support."""
        if not all(map(is_name, fact.id.split("."))):
            raise Refused("this id is not made of names")
        if fact.id in self.facts or not {*fact.premises} <= self.facts.keys():
            raise Refused("this id is taken, or a premise is not a fact so far")
        if fact.context not in self.theories or fact.rule not in RULES:
            raise Refused(f"no context {fact.context!a} or no rule {fact.rule!a}")
        kinds, premises, rule = RULES[fact.rule]
        if fact.kind not in kinds or not fact.rhs or len(fact.premises) not in premises:
            raise Refused(f"rule {fact.rule} does not make this of {len(fact.premises)} premises")
        if fact.kind in ("equal", "root", "nonnegative"):
            check_news(self, fact)
        grades = [rule(self, fact), *(self.facts[premise].grade for premise in fact.premises)]
        if fact.grade != (earned := min(grades, key=WORST_TO_BEST.index)):
            raise Refused(f"claims {fact.grade}, has earned {earned}")
        self.facts[fact.id] = fact


@contextmanager
def _blaming(kind: str, entry: object = None, key: str = "") -> Generator[None]:
    """Whatever goes wrong inside is a refusal, told in one line that names the culprit."""
    try:
        yield
    except (ValueError, ArithmeticError, LookupError, RecursionError, MemoryError) as error:
        name = entry.get(key) if isinstance(entry, dict) else ""
        printable = name if str(name).isascii() and str(name).isprintable() else ascii(name)
        culprit = f"{kind} {printable}" if name != "" else kind
        reason = str(error) or type(error).__name__
        raise Refused(" ".join(f"{culprit}: {reason}".split())) from None
