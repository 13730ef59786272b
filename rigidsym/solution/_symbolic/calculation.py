"""Symbolic evaluation of the ledger's formulas in SymPy, and its conditions."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from types import MappingProxyType
from typing import Any

from sympy import Eq, Ge, I, Ne, asin, atanh, elliptic_f, pi
from sympy.logic.boolalg import Boolean

from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.language._expression import Expression, names, parse
from rigidsym.language.functions._translation import BY_COMPLEMENT, sympified
from rigidsym.solution._formulas import sealed
from rigidsym.solution._polhode import Polhode
from rigidsym.solution._symbolic.symbols import Constant, named
from rigidsym.solution._symbolic.value import Dynamics, Symbolic, column

_CONSTANTS = {"pi": pi, "I": I}


@dataclass(frozen=True, slots=True)
class ExactMotion:
    """Moments, initial state and regime of a motion, in exact SymPy numbers.

    exact: moments and rates as fractions.
    """

    inertia: tuple[Any, ...]
    omega0: tuple[Any, ...]
    attitude0: tuple[Any, ...]
    polhode: Polhode
    exact: tuple[Sequence[Fraction], Sequence[Fraction]]

    def numbers(self, axes: Sequence[int] = (0, 1, 2)) -> list[Any]:
        """List the moments, rates and quaternion at t = 0, with the axes in a given order."""
        columns = (self.inertia, self.omega0, self.attitude0[1:])
        moments, rates, vector = ([values[k] for k in axes] for values in columns)
        return [*moments, *rates, self.attitude0[0], *vector]


@dataclass
class Calculation:
    """A symbolic calculation with its known quantities, its constants and the facts it used.

    With the numbers of a motion, constants are numbers with a name.  Otherwise later constants
    contain the symbols of earlier ones, except for those that are a number whatever the motion.
    """

    form: str
    given: ExactMotion | None
    known: dict[str, Any] = field(default_factory=dict)
    constants: dict[Any, Any] = field(default_factory=dict)
    facts: dict[str, None] = field(default_factory=dict)

    def solution(
        self,
        attitude: Iterable[Any],
        rates: Iterable[Any],
        conditions: Iterable[Boolean],
        choices: Mapping[str, str],
        quantities: Mapping[str, Any],
        dynamics: Dynamics,
    ) -> Symbolic:
        """Return the solution with the constants and facts of this calculation."""
        return Symbolic(
            form=self.form,
            regime=self.given.polhode.regime if self.given else None,
            constants=MappingProxyType(self.constants),
            conditions=nontrivial(conditions),
            choices=MappingProxyType({named(name): text for name, text in choices.items()}),
            facts=tuple(self.facts),
            quantities=MappingProxyType(dict(quantities)),
            attitude=column(attitude),
            rates=column(rates),
            dynamics=dynamics,
        )

    def values(self, *names: str) -> tuple[Any, ...]:
        """Return the values of known quantities."""
        return tuple(self.known[name] for name in names)

    def begin(self, names: Sequence[str], numbers: Iterable[Any]) -> None:
        """Set the inputs of the solution to free symbols or to a motion's numbers."""
        if self.given is None:
            self.known |= {name: named(name) for name in names}
        else:
            for name, value in zip(names, numbers, strict=True):
                self.name(name, value)

    def name(self, name: str, value: Any, rename: str = "") -> None:
        """Add a named constant to the calculation."""
        symbol = named(rename or name)
        self.constants[symbol] = value
        plain = Constant(rename or name, value) if self.given else symbol
        self.known[name] = value if value.is_Rational else plain

    def compute(
        self,
        sequence: str,
        only: Iterable[str] | None = None,
        rename: Mapping[str, str] | None = None,
    ) -> None:
        """Compute the constants of a formula sequence that are not known yet.

        If `only` is given, compute only the constants that these names need.
        """
        solution = sealed()
        needed = solution.evaluated[sequence].up_to(frozenset(only)).formulas if only else ()
        wanted = {name for name, _ in needed}
        for formula in solution.sequences[sequence]:
            if formula.name not in self.known and (only is None or formula.name in wanted):
                self.facts[formula.fact] = None
                value = evaluated(formula.expression, self.known)
                self.name(formula.name, value, (rename or {}).get(formula.name, ""))

    def work_out(
        self, sequence: str, known: Mapping[str, Any], constant: Collection[str] = ()
    ) -> dict[str, Any]:
        """Evaluate a formula sequence and substitute each quantity into the later ones.

        Those in `constant` are skipped.  Only the facts are added to the calculation.
        """
        found = {**self.known, **known}
        for formula in sealed().sequences[sequence]:
            if formula.name in constant:
                continue
            self.facts[formula.fact] = None
            found[formula.name] = evaluated(formula.expression, found)
        return found


def evaluated(expression: Expression, known: Mapping[str, Any]) -> Any:
    """Evaluate an expression of the ledger in SymPy, given the values of its names."""

    def argument(sn: Any, cn: Any, dn: Any) -> Any:
        """Return the argument u at which Jacobi's function sn(u, m) has a given value.

        cn >= 0 is assumed.
        """
        m = known["m"]
        return atanh(sn) if m == 1 else elliptic_f(asin(sn), m)

    def value_of(name: str) -> Any:
        return _CONSTANTS[name] if name in _CONSTANTS else known[name]

    return sympified(expression, value_of, {**BY_COMPLEMENT, "jacobi_argument": argument})


def used(*sequences: str) -> frozenset[str]:
    """Return the names that occur in the expressions of formula sequences."""
    return frozenset[str]().union(*(sealed().evaluated[name].used for name in sequences))


@cache
def _contexts() -> dict[str, Mapping[str, Any]]:
    return {context["name"]: context for context in ledger_data(ledger_text())["contexts"]}


def conditions_of(
    context: str, known: Mapping[str, Any], given: Iterable[str] = ()
) -> tuple[Boolean, ...]:
    """Return the hypotheses of a context that concern known names only."""
    ledger, inputs = _contexts()[context], {*given}
    clauses = (("units", Ne, {*known}), ("nonnegative", Ge, {*known}), ("relations", Eq, inputs))
    found = (
        relation(evaluated(parse(text), known), 0)
        for column, relation, about in clauses
        for text in ledger[column]
        if {*names(parse(text))} <= about
    )
    return nontrivial(found)


def nontrivial(conditions: Iterable[Any]) -> tuple[Boolean, ...]:
    """Return the distinct conditions that are not trivially true."""
    return tuple(dict.fromkeys(c for c in conditions if c is not True and c != True))  # noqa: E712
