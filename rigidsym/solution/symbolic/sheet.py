"""A calculation on symbols: formulas of the ledger worked through, and what they were by name."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from rigidsym.solution.formulas import Formula, sealed
from rigidsym.solution.symbolic.constant import Constant
from rigidsym.solution.symbolic.symbols import named
from rigidsym.solution.symbolic.translation import sympified


@dataclass
class Sheet:
    """What is known by name, the constants in order, and the facts they rest on.

    `exact`: constants are numbers that have a name; else later ones have their symbols, but for
    those that are a number whatever the motion.
    """

    exact: bool
    known: dict[str, Any] = field(default_factory=dict)
    constants: dict[Any, Any] = field(default_factory=dict)
    facts: dict[str, None] = field(default_factory=dict)

    def name(self, name: str, value: Any, rename: str = "") -> None:
        """A constant, by its symbol."""
        symbol = named(rename or name)
        self.constants[symbol] = value
        plain = symbol if not self.exact else Constant(rename or name, value)
        self.known[name] = value if value.is_Rational else plain

    def compute(
        self,
        sequence: str,
        only: Iterable[str] | None = None,
        rename: Mapping[str, str] | None = None,
    ) -> None:
        """Constants by a sequence, of it what is needed for `only` and not known yet."""
        for formula in _needed(sequence, only):
            if formula.name not in self.known:
                self._note(formula)
                value = sympified(formula.expression, self.known)
                self.name(formula.name, value, (rename or {}).get(formula.name, ""))

    def work_out(
        self, sequence: str, known: Mapping[str, Any], constant: Collection[str] = ()
    ) -> dict[str, Any]:
        """The quantities of a sequence, each put into those after it, but for those known to be
        constant; nothing is kept but facts.
        """
        found = {**self.known, **known}
        for formula in sealed().sequences[sequence]:
            if formula.name in constant:
                continue
            self._note(formula)
            found[formula.name] = sympified(formula.expression, found)
        return found

    def _note(self, formula: Formula) -> None:
        self.facts[formula.fact] = None


def _needed(sequence: str, only: Iterable[str] | None) -> Iterable[Formula]:
    formulas = sealed().sequences[sequence]
    if only is None:
        return formulas
    wanted = {name for name, _ in sealed().evaluated[sequence].up_to(frozenset(only)).formulas}
    return [formula for formula in formulas if formula.name in wanted]


def used(*sequences: str) -> frozenset[str]:
    """The names that sequences use."""
    return frozenset[str]().union(*(sealed().evaluated[name].used for name in sequences))
