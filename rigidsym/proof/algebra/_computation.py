"""Expressions on their way: SymPy's methods, with a record of what was typed and what was done.

    >>> from sympy import symbols
    >>> x, y = symbols("x y")
    >>> whole = compute(x**2 - y**2)
    >>> whole.computed
    False
    >>> found = (whole / (x - y)).cancel()
    >>> found, found.computed
    (<x + y by cancel>, True)

What such an expression becomes as text of a ledger is a `Computed`, a string that carries it.  So a
fact or a definition tells by its type whether it was computed, printed in the paper, or guessed.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

import sympy

from rigidsym.proof.algebra import _rational
from rigidsym.proof.kernel import Fact


@dataclass(frozen=True, slots=True, repr=False)
class Computation:
    """An expression, a matrix or several of them, with the operations that made it.

    Methods, items and arithmetic are those of the value, and their results are computations, too.
    `typed` are the expressions that it began with and the arguments of its operations; `joined` are
    those among them that arithmetic put beside what was computed, after the last operation.
    `solved` are answers that equations such as x - answer = 0 had typed before they were solved.
    `order` are the names that come first when it is printed.
    """

    value: Any
    operations: tuple[str, ...] = ()
    typed: tuple[Any, ...] = ()
    order: tuple[str, ...] = ()
    joined: tuple[Any, ...] = ()
    solved: tuple[Any, ...] = ()

    # SymPy leaves arithmetic between its expressions and this one to this one.
    _op_priority = 1e6

    @property
    def computed(self) -> bool:
        """Whether an operation led to the value, and the value was not put in by hand.

        A number as factor makes no other value of what was put in.
        """
        return bool(self.operations) and not self._is_one_of((*self.typed, *self.solved))

    @property
    def restates(self) -> bool:
        """Whether the value is that of an equation that was solved before SymPy solved it."""
        return bool(self.operations) and self._is_one_of(self.solved)

    def _is_one_of(self, expressions: Iterable[Any]) -> bool:
        value = _without_number(self.value)
        return any(same(value, _without_number(x)) for x in expressions)

    def ordered(self, names: str) -> "Computation":
        """Return the same with names that come first when it is printed, as numbers need it."""
        return replace(self, order=tuple(names.split()))

    def held(self) -> "Computation":
        """Return the same as a part that is worked out by itself, as numbers need it."""
        return replace(self, value=sympy.UnevaluatedExpr(self.value))

    def apply(self, function: Callable[..., Any], *given: Any, **options: Any) -> Any:
        """Return the result of a function of the value, such as `sympy.apart`.

        Raises ValueError for a lambda, which has no name to record and may hold an answer.
        """
        _require_names(function, *given)
        name = str(getattr(function, "__name__", "a function"))
        found = self._after(name, function(self.value, *plain(given), **options), given)
        return found._knowing(self._answers(*given)) if function is sympy.solve else found

    def solve_for(self, *unknowns: Any) -> Any:
        """Return the only value of an unknown for which this is zero, with factors cancelled.

        For several unknowns return their values by unknown, for which all of these are zero.
        Raises ValueError if there is none, or more than one.
        """
        first, *more = plain(unknowns)
        if not more and (linear := _rational.root(self.value, first)) is not None:
            found = [{first: linear}]
        else:
            found = sympy.solve(self.value, first, *more, simplify=False, dict=True)
        if len(found) != 1 or not {first, *more} <= {*found[0]}:
            asked = ", ".join(map(str, unknowns))
            raise ValueError(f"{asked}: {len(found)} solutions of {self.value} = 0")
        values = {
            x: self._after("solve", _rational.cancel(found[0][plain(x)]), ()) for x in unknowns
        }
        if more:
            return values
        return values[unknowns[0]]._knowing(self._answers(*unknowns))

    def factor(self) -> "Computation":
        """Return the same as a product of factors."""
        return self._after("factor", _rational.factor(self.value), ())

    def cancel(self) -> "Computation":
        """Return the same as a fraction in lowest terms."""
        return self._after("cancel", _rational.cancel(self.value), ())

    def _answers(self, unknown: Any, *_: Any) -> tuple[Any, ...]:
        """Return the value of an unknown that an equation such as unknown - value = 0 types."""
        sought, whole = plain(unknown), self.value
        if not (isinstance(sought, sympy.Expr) and isinstance(whole, sympy.Expr)):
            return ()
        factor = sum(x.coeff(sought) for x in sympy.Add.make_args(whole))
        rest = whole - factor * sought
        return (-rest / factor,) if factor.is_Number and factor and not rest.has(sought) else ()

    def _knowing(self, answers: tuple[Any, ...]) -> "Computation":
        return replace(self, solved=(*self.solved, *answers))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = getattr(self.value, name)
        if not callable(found):
            return found

        def operation(*given: Any, **options: Any) -> Any:
            _require_names(*given)
            known = plain(given)
            if name == "subs" and (by := _independent(self.value, *known)):
                return self._after(name, self.value.xreplace(by), given)
            return self._after(name, found(*known, **options), given)

        return operation

    def __getitem__(self, key: Any) -> Any:
        return self._with(self.value[plain(key)])

    def __iter__(self) -> Any:
        return map(self._with, self.value)

    def __len__(self) -> int:
        return len(self.value)

    def _with(self, value: Any) -> Any:
        known = replace(self, value=value, order=())
        return known if _is_algebra(value) else value

    def _after(self, operation: str, value: Any, given: Any) -> Any:
        """Return a result of an operation with the record of its arguments."""
        if not _is_algebra(value):
            return value
        changed = () if same(value, self.value) else (operation,)
        before = [*_inside(given)]
        done = [self.operations, *(x.operations for x in before), changed]
        typed = [self.typed, *(x.typed for x in before), [*_plain_inside(given)]]
        # To put something in, or to change nothing, leaves what was joined as it is.
        kept = not changed or operation in ("subs", "xreplace", "replace")
        joined = _once([x.joined for x in (self, *before)]) if kept else ()
        operations = tuple(dict.fromkeys(sum(map(tuple, done), ())))
        solved = _once(x.solved for x in (self, *before))
        return Computation(value, operations, _once(typed), joined=joined, solved=solved)

    def _arithmetic(self, other: Any, value: Any) -> "Computation":
        both = [self, *([*_inside(other)] or [Computation(other, (), (other,))])]
        operations = tuple(dict.fromkeys(sum((x.operations for x in both), ())))
        joined = [x.joined if x.computed else _sums(x.value) for x in both]
        typed, solved = (_once(getattr(x, kind) for x in both) for kind in ("typed", "solved"))
        return Computation(value, operations, typed, joined=_once(joined), solved=solved)

    def __add__(self, other: Any) -> "Computation":
        return self._arithmetic(other, self.value + plain(other))

    def __radd__(self, other: Any) -> "Computation":
        return self._arithmetic(other, plain(other) + self.value)

    def __sub__(self, other: Any) -> "Computation":
        return self._arithmetic(other, self.value - plain(other))

    def __rsub__(self, other: Any) -> "Computation":
        return self._arithmetic(other, plain(other) - self.value)

    def __mul__(self, other: Any) -> "Computation":
        return self._arithmetic(other, self.value * plain(other))

    def __rmul__(self, other: Any) -> "Computation":
        return self._arithmetic(other, plain(other) * self.value)

    def __truediv__(self, other: Any) -> "Computation":
        return self._arithmetic(other, self.value / plain(other))

    def __rtruediv__(self, other: Any) -> "Computation":
        return self._arithmetic(other, plain(other) / self.value)

    def __pow__(self, other: Any) -> "Computation":
        return self._arithmetic(other, self.value ** plain(other))

    def __neg__(self) -> "Computation":
        return self._with(-self.value)

    def __repr__(self) -> str:
        how = ", ".join(self.operations)
        return f"<{self.value} by {how}>" if how else f"<{self.value}>"


class Computed(str):
    """Text of an expression that was computed; `origin` has the operations."""

    origin: Computation


class Printed(str):
    """Text that the paper prints: an input to be judged."""


class Guess(str):
    """Text that was typed as the answer, with the reason why it was not computed."""

    why: str


class Solved(Guess):
    """Text of an equation that SymPy solved, but that had its unknown on one side already."""

    why = "an equation with the name on one side, before SymPy solved it"


class Restated(str):
    """Text of a relation of the context, solved for a name: a hypothesis that is said again."""


class Law(Guess):
    """Text of a law that results are held against, with the reason why it is one."""


class Standing(StrEnum):
    """Where the statement of a fact, or the text of a definition, comes from.

    Chosen are names, and hypotheses that are said again, such as K = sqrt(M_a^2 + M_b^2 + M_d^2).
    Stated are laws that computed results are held against, such as Euler's equations, and
    statements that a point refutes: neither has an answer to compute.
    """

    COMPUTED = "computed"
    CHOSEN = "chosen"
    PRINTED = "printed"
    STATED = "stated"
    GUESSED = "guessed"


def standing(fact: Fact) -> Standing:
    """Return where the statement of a fact comes from, by the types of its texts.

    An equation is computed if each of its lines has a computed side.  That a context is a model of
    another, or is split into cases, has no formula: such a statement is chosen.
    """
    if fact.kind in ("model", "partition"):
        return Standing.CHOSEN
    lines = [*zip(fact.lhs, fact.rhs, strict=True)]
    if all(map(_found, lines)):
        return Standing.COMPUTED
    if all(isinstance(side, Printed) for line in lines for side in line):
        return Standing.PRINTED
    if all(_found(line) or isinstance(line[1], Restated) for line in lines):
        return Standing.CHOSEN
    if fact.kind == "unequal" or all(_found(line) or isinstance(line[1], Law) for line in lines):
        return Standing.STATED
    return Standing.GUESSED


def _found(line: tuple[str, str]) -> bool:
    """Return whether one side of a line was computed."""
    return any(isinstance(side, Computed) for side in line)


def explained(fact: Fact, law: str = "", why: str = "") -> Fact:
    """Return a fact whose typed lines have a reason: they are laws, or were not computed.

    Raises ValueError for a law of the form name = expression: that is an answer.
    """
    reason, kind = (law, Law) if law else (why, Guess)
    if not reason:
        return fact
    rhs = []
    for line in zip(fact.lhs, fact.rhs, strict=True):
        if law and not _found(line) and line[0].isidentifier():
            raise ValueError(f"{fact.id}: {line[0]} = {line[1]} is an answer and no law")
        rhs.append(line[1] if _found(line) else _told(kind, line[1], reason))
    return replace(fact, rhs=tuple(rhs))


def restated(fact: Fact, lines: Iterable[bool]) -> Fact:
    """Return a fact whose typed lines say, where `lines` tells so, a hypothesis again."""
    sides = zip(fact.lhs, fact.rhs, lines, strict=True)
    plain = (again and type(y) in (str, Solved) and not _found((x, y)) for x, y, again in sides)
    rhs = (Restated(y) if again else y for y, again in zip(fact.rhs, plain, strict=True))
    return replace(fact, rhs=tuple(rhs))


def reasons(fact: Fact) -> tuple[str, ...]:
    """Return why the typed lines of a fact were not computed."""
    return tuple(dict.fromkeys(x.why for x in (*fact.lhs, *fact.rhs) if isinstance(x, Guess)))


def joined(fact: Fact) -> tuple[Any, ...]:
    """Return the typed expressions that arithmetic put beside the computed values of a fact."""
    sides = (x for x in (*fact.lhs, *fact.rhs) if isinstance(x, Computed))
    return _once(x.origin.joined for x in sides) if standing(fact) == Standing.COMPUTED else ()


def compute(value: Any) -> Computation:
    """Begin a computation with typed expressions, or go on with several computations at once."""
    if isinstance(value, Computation):
        return value
    if not (before := [*_inside(value)]):
        return Computation(value, (), (value,))
    done = dict.fromkeys(name for x in before for name in x.operations)
    typed = _once([*(x.typed for x in before), [*_plain_inside(value)]])
    return Computation(plain(value), tuple(done), typed)


def ordered(names: str, table: Mapping[Any, Any]) -> dict[Any, Computation]:
    """Return the expressions of a table with names that come first when they are printed."""
    return {name: compute(form).ordered(names) for name, form in table.items()}


def computed(text: str, origin: Any) -> str:
    """Return text as computed where it is that of a computation which computes."""
    if not isinstance(origin, Computation):
        return text
    if not origin.computed:
        return Solved(text) if origin.restates else text
    found = Computed(text)
    found.origin = origin
    return found


def guess(text: str, why: str) -> Guess:
    """Return typed text as a guess with a reason: why SymPy does not find it by itself."""
    return _told(Guess, text, why)


def _told(kind: type[Guess], text: str, why: str) -> Guess:
    found = kind(text)
    found.why = why
    return found


def plain(value: Any) -> Any:
    """Return the value of computations, also inside of lists, tuples and mappings."""
    match value:
        case Computation():
            return plain(value.value)
        case Mapping():
            return {plain(key): plain(entry) for key, entry in value.items()}
        case list() | tuple():
            return type(value)(map(plain, value))
    return value


def _without_number(value: Any) -> Any:
    """Return an expression without a number as factor, a sign included, and evaluated anew."""
    if not isinstance(value, sympy.Expr) or value.is_Atom:
        return value
    whole = value.func(*value.args) if isinstance(value, (sympy.Add, sympy.Mul)) else value
    rest = whole.primitive()[1]
    return -rest if rest.could_extract_minus_sign() else rest


def _require_names(*given: Any) -> None:
    """Raise ValueError for a lambda among the arguments of an operation."""
    if any(getattr(x, "__name__", "") == "<lambda>" for x in given):
        raise ValueError("a function of a computation needs a name: use one of SymPy's, or def")


def _sums(value: Any) -> tuple[Any, ...]:
    """Return a typed expression if it says more than a name, a number and their product."""
    return (value,) if isinstance(value, sympy.Expr) and len(value.free_symbols) > 1 else ()


def same(one: Any, other: Any) -> bool:
    """Return whether two expressions have the same structure."""
    return type(one) is type(other) and one == other


def _independent(value: Any, by: Any, *_: Any) -> dict[sympy.Symbol, sympy.Basic]:
    """Return what is to be put in for names, if all at once gives the same as one by one."""
    if not (isinstance(by, Mapping) and isinstance(value, sympy.Expr)):
        return {}
    found = {x: sympy.sympify(form) for x, form in by.items() if isinstance(x, sympy.Symbol)}
    chained = any(form.free_symbols & found.keys() for form in found.values())
    bound = value.has(sympy.Integral, sympy.Derivative)
    return {} if chained or bound or len(found) < len(by) else found


def _is_algebra(value: Any) -> bool:
    match value:
        case sympy.Basic() | sympy.MatrixBase():
            return not isinstance(value, sympy.logic.boolalg.BooleanAtom)
        case Mapping():
            return True
        case list() | tuple():
            return all(map(_is_algebra, value))
    return isinstance(value, Computation)


def _inside(given: Any) -> Any:
    """Yield the computations among arguments."""
    match given:
        case Computation():
            yield given
        case Mapping():
            for entry in (*given.keys(), *given.values()):
                yield from _inside(entry)
        case list() | tuple():
            for entry in given:
                yield from _inside(entry)


def _plain_inside(given: Any) -> Any:
    """Yield the typed expressions among arguments, but for single names and numbers."""
    match given:
        case Mapping():
            for entry in given.values():
                yield from _plain_inside(entry)
        case list() | tuple():
            for entry in given:
                yield from _plain_inside(entry)
        case sympy.Expr() if not given.is_Atom:
            yield given


def _once(lists: Any) -> tuple[Any, ...]:
    found: dict[Any, Any] = {}
    for entry in (x for entries in lists for x in entries):
        known = isinstance(entry, sympy.Basic)
        found.setdefault((type(entry), entry if known else id(entry)), entry)
    return tuple(found.values())
