"""The verdict: every context opens, and every fact follows by its rule from what is before it."""

from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

from flint import fmpq_mpoly

from rigidsym.independent.records import Claim, Hypotheses, Refused, fill, fits, load
from rigidsym.independent.ring import Quotient, Ring
from rigidsym.independent.theory import Theory

WORST_TO_BEST = ["REFUTED", "UNDECIDED", "ASSUMED", "SAMPLED", "ENCLOSED", "PROVED"]


def check(text: str) -> int:
    """The number of facts of a ledger, all of them accepted; Refused if anything is amiss."""
    with _blaming("ledger"):
        contexts, claims = load(text)
    judge = Judge()
    for entry in contexts:
        with _blaming("context", entry, "name"):
            judge.open(fill(Hypotheses, entry))
    for entry in claims:
        with _blaming("fact", entry, "id"):
            judge.accept(fill(Claim, entry))
    return len(judge.facts)


class Judge:
    """What has been accepted so far; a fact may rest on nothing else."""

    def __init__(self) -> None:
        self.theories: dict[str, Theory] = {}
        self.facts: dict[str, Claim] = {}

    def open(self, given: Hypotheses) -> None:
        """Accept a context of a new name."""
        if given.name in self.theories:
            raise Refused("this name is taken")
        self.theories[given.name] = Theory(given)

    def accept(self, fact: Claim) -> None:
        """Accept a fact of a new id whose rule holds, at the grade of its weakest support."""
        if fact.id in self.facts or not {*fact.premises} <= self.facts.keys():
            raise Refused("this id is taken, or a premise is not a fact so far")
        if fact.context not in self.theories or fact.rule not in RULES:
            raise Refused(f"no context {fact.context!r} or no rule {fact.rule!r}")
        kind, rule = RULES[fact.rule]
        if kind and (fact.kind != kind or fact.premises or not fact.rhs):
            raise Refused(f"rule {fact.rule} states {kind!r}, of something, without premises")
        rule(self, fact)
        grades = [self.facts[premise].grade for premise in fact.premises]
        grades.append("ASSUMED" if fact.rule == "assumption" else "PROVED")
        if fact.grade != (earned := min(grades, key=WORST_TO_BEST.index)):
            raise Refused(f"claims {fact.grade}, has earned {earned}")
        self.facts[fact.id] = fact


def identity(judge: Judge, fact: Claim) -> None:
    """lhs = rhs, since (lhs - rhs) * units = sum of cofactor * relation, for each component."""
    ring, gaps = judge.theories[fact.context].ring, _gaps(judge, fact)
    rows = fact.certificate.get("cofactors")
    if not isinstance(rows, list) or not all(fits(row, list[str]) for row in rows):
        raise Refused("the certificate holds no table of cofactors")
    for gap, row in _pairs(gaps, rows):
        if not _gives(ring, _combination(ring, row), gap):
            raise Refused("the cofactors do not give the difference of the sides")


def root(judge: Judge, fact: Claim) -> None:
    """lhs = +sqrt(rhs), since lhs**2 = rhs as above and the context says that lhs >= 0."""
    if not {*fact.lhs} <= {*judge.theories[fact.context].given.nonnegative}:
        raise Refused("the left side is not declared nonnegative")
    identity(judge, fact)


def counterexample(judge: Judge, fact: Claim) -> None:
    """lhs = rhs does not follow, since both sides differ at a point of the context."""
    values: Any = fact.certificate.get("point")
    if not fits(values, dict[str, str]):
        raise Refused("the certificate holds no point")
    at = judge.theories[fact.context].point(values)
    if not any(gap.above(*at) for gap in _gaps(judge, fact)):
        raise Refused("both sides agree at the point")


def model(judge: Judge, fact: Claim) -> None:
    """Every hypothesis of the context named in rhs holds in this one, where D reads the same."""
    if fact.lhs or len(fact.rhs) != 1 or fact.rhs[0] not in judge.theories:
        raise Refused("a model is of exactly one context")
    here, there = judge.theories[fact.context], judge.theories[fact.rhs[0]].given
    read, value, rate = here.ring.read, here.ring.value, here.ring.rate
    zeros = [value(name) - value(name) for name in there.generators]
    zeros += [*map(read, there.relations)]
    zeros += [value(name) - read(text) for name, text in there.definitions.items()]
    if there.rates is not None:
        rates = {**dict.fromkeys(there.generators, "0"), **there.rates}
        zeros += [rate(value(name)) - read(text) for name, text in rates.items() if text != "?"]
    if any(here.ring.remainder(zero.above) for zero in zeros):
        raise Refused("a relation, definition or rate does not carry over")
    for unit in there.units:
        here.ring.inverse(read(unit))
    if not {*there.nonnegative} <= {*here.given.nonnegative}:
        raise Refused("a sign does not carry over")


def transfer(judge: Judge, fact: Claim) -> None:
    """What holds in a context holds, word for word, in each model of it."""
    if len(fact.premises) != 2 or fact.kind not in ("equal", "root"):
        raise Refused("transfer takes an equation and a model")
    there, bridge = (judge.facts[premise] for premise in fact.premises)
    if (bridge.kind, bridge.context, bridge.rhs) != ("model", fact.context, [there.context]):
        raise Refused("the second premise does not make this context a model of the first's")
    if (fact.kind, fact.lhs, fact.rhs) != (there.kind, there.lhs, there.rhs):
        raise Refused("the statement is not that of the first premise")


def assumption(judge: Judge, fact: Claim) -> None:
    """Somebody else's result, which can at least be read here and says where it is from."""
    _gaps(judge, fact)
    if not isinstance(reference := fact.certificate.get("reference"), str) or not reference:
        raise Refused("an assumption needs a reference")


# The kind of statement that a rule makes from no premises, and the rule.
RULES: dict[str, tuple[str, Callable[[Judge, Claim], None]]] = {
    "identity": ("equal", identity),
    "root": ("root", root),
    "counterexample": ("unequal", counterexample),
    "model": ("model", model),
    "transfer": ("", transfer),
    "assumption": ("equal", assumption),
}


def _gaps(judge: Judge, fact: Claim) -> list[Quotient]:
    """lhs - rhs, or lhs**2 - rhs for a root, component by component."""
    read, power = judge.theories[fact.context].ring.read, 2 if fact.kind == "root" else 1
    return [read(lhs) ** power - read(rhs) for lhs, rhs in _pairs(fact.lhs, fact.rhs)]


def _combination(ring: Ring, row: list[str]) -> fmpq_mpoly:
    """The sum of cofactor * relation."""
    total = ring.one * 0
    for text, relation in _pairs(row, ring.relations):
        cofactor = ring.read(text)
        if cofactor.below != ring.one:
            raise Refused("a cofactor is not a polynomial")
        total += cofactor.above * relation
    return total


def _gives(ring: Ring, combination: fmpq_mpoly, gap: Quotient) -> bool:
    """Whether combination = gap * (a product of units), so that the gap vanishes with it."""
    if combination == gap.above or not combination or not gap.above:
        return combination == gap.above  # the product is gap.below
    factor, rest = divmod(combination * gap.below, gap.above)
    return not rest and ring.scale(factor) == 1


def _pairs(left: list[Any], right: list[Any]) -> list[tuple[Any, Any]]:
    if len(left) != len(right):
        raise Refused(f"{len(left)} items where {len(right)} are due")
    return list(zip(left, right, strict=True))


@contextmanager
def _blaming(kind: str, entry: Any = None, key: str = "") -> Generator[None]:
    """Whatever goes wrong inside is a refusal, told in one line that names the culprit."""
    try:
        yield
    except (ValueError, ArithmeticError, RecursionError, MemoryError) as error:
        culprit = f"{kind} {entry.get(key)}" if isinstance(entry, dict) else kind
        reason = str(error) or type(error).__name__
        raise Refused(" ".join(f"{culprit}: {reason}".split())) from None
