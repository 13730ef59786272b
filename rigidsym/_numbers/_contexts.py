"""Contexts of functions, which have to have a point: a motion at which all that they say holds.

The kernel has a rational witness for each context.  Where names are declared to be theta functions,
or are read as standard functions, a witness says nothing: the functions may not have such values.
Here they have the values of a motion.  Quantities without a meaning are found from definitions.
Rates are compared with divided differences.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from types import CodeType
from typing import Any

from flint import acb, arb

from rigidsym._numbers._values import Values, by_complement, number
from rigidsym.errors import LedgerError
from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    by_products,
    children,
    names,
    parse,
    to_text,
)

# Differences are taken over so long a time; rates agree to so many digits.
SHORT, AGREE = arb(2) ** -20, arb(10) ** -8
# Values of a motion at a time.
World = Callable[[arb], Values]
# Sets a name from values that are known.
Rule = tuple[str, Callable[[Mapping[str, Any]], Any]]


class Contexts:
    """The contexts of a ledger that declare functions, or whose readings numbers rest on."""

    def __init__(self, ledger: Mapping[str, Any], functions: Mapping[str, Any]) -> None:
        sequences = ledger["published"].get("sequences", {}).values()
        published = {entry.get("context") for x in sequences for entry in x if "reading" in entry}
        self.contexts = {
            context["name"]: context
            for context in ledger["contexts"]
            if context["thetas"] or context["name"] in published
        }
        real = {"re": lambda z: acb(z).real, "im": lambda z: acb(z).imag}
        self.functions = {**functions, **real, "__builtins__": {}}
        self.inhabited: set[str] = set()
        self._codes: dict[str, tuple[CodeType, frozenset[str]] | None] = {}
        self._plans: dict[tuple[str, str], list[Rule]] = {}

    def inhabit(self, worlds: Mapping[str, World], time: arb, motion: object) -> None:
        """Check that the contexts which some of the worlds are about have a point there."""
        moments = (time, time - SHORT, time + SHORT)
        known = {
            world: [{x: number(y) for x, y in values(moment).items()} for moment in moments]
            for world, values in worlds.items()
        }
        for name, context in self.contexts.items():
            unlike = broken = ""
            for world, points in known.items():
                if not (rules := self._plan(name, world, points[0])):
                    continue
                try:
                    completed = [self._completed(context, x, rules) for x in points]
                except LedgerError as error:  # it may be about another world
                    unlike = unlike or str(error)
                    continue
                broken = self._broken(context, completed)
                if not broken:
                    self.inhabited.add(name)
                    break
            else:
                if told := broken or unlike:
                    raise LedgerError(f"ledger: context {name}: {told}, for {motion}")

    def _broken(self, context: Mapping[str, Any], points: Sequence[Mapping[str, Any]]) -> str:
        """Return the first part of a context that does not hold at a point.

        points: the point, one before and one after it.
        """
        here, before, after = points
        for text in context["relations"]:
            if not _is_zero(self._value(text, here)):
                return f"{text} = 0 does not hold"
        for text in context["units"]:
            if _is_zero(self._value(text, here)):
                return f"{text} may be zero"
        for text in context["nonnegative"]:
            if self._value(text, here) < -AGREE:
                return f"{text} is negative"
        rates = context["rates"]
        for generator in context["generators"] if rates is not None else ():
            text = rates.get(generator, "0")
            if text != "?":
                slope = (after[generator] - before[generator]) / (2 * SHORT)
                rate = number(self._value(text, here))
                if not abs(slope - rate) < AGREE * (1 + abs(rate)):
                    return f"{generator}' = {text} is not its derivative"
        return ""

    def _value(self, text: str, values: Mapping[str, Any]) -> Any:
        found = self._code(text)
        if found is None:
            raise LedgerError(f"{text} is no expression")
        code, used = found
        if missing := sorted(used - {*values}):
            raise LedgerError(f"no value of {', '.join(missing)}")
        try:
            return eval(code, self.functions, dict(values))
        except (NameError, TypeError, ZeroDivisionError) as error:
            raise LedgerError(f"{text}: {error}") from None

    def _code(self, text: str) -> tuple[CodeType, frozenset[str]] | None:
        """Return an expression's code and names, None for a text in words."""
        if text not in self._codes:
            self._codes[text] = None
            with suppress(ValueError, SyntaxError):
                tree = by_complement(parse(text))
                if {*_calls(tree)} <= {*self.functions}:
                    code = compile(to_text(by_products(tree)), "<context>", "eval")
                    self._codes[text] = code, frozenset(names(tree)) - {"pi", "I"}
        return self._codes[text]

    def _plan(self, name: str, world: str, known: Mapping[str, Any]) -> list[Rule]:
        """Return rules by which all names of a context follow from known ones.

        There are none where some do not.
        """
        if (name, world) not in self._plans:
            context, rules, have = self.contexts[name], [], {*known}
            while rule := next((x for x in self._rules(context, have) if x[0] not in have), None):
                rules.append(rule)
                have.add(rule[0])
            wanted = {*context["generators"], *context["definitions"]}
            self._plans[name, world] = rules if wanted <= have else []
        return self._plans[name, world]

    def _rules(self, context: Mapping[str, Any], have: set[str]) -> Iterator[Rule]:
        """Yield rules for names that follow from known ones."""
        for name, text in self._texts(context, have):
            yield name, lambda values, text=text: self._value(text, values)
        for name, text in context["definitions"].items():
            tree = parse(text)
            unknown = [x for x in names(tree) if x not in have]
            if name in have and len(unknown) == 1:
                yield unknown[0], self._inverse(name, tree)

    def _texts(
        self, context: Mapping[str, Any], have: set[str] | Mapping[str, Any]
    ) -> Iterator[tuple[str, str]]:
        """Yield names with texts that have a value."""
        for column in ("thetas", "reading", "definitions"):
            for name, text in context[column].items():
                found = self._code(text)
                if found is not None and all(x in have for x in found[1]):
                    yield name, text

    def _inverse(self, name: str, tree: Expression) -> Callable[[Mapping[str, Any]], Any]:
        return lambda values: self._solved(tree, values[name], values)

    def _solved(self, tree: Expression, goal: Any, values: Mapping[str, Any]) -> Any:
        """Return the value of the one unknown name with which an expression has a value."""
        match tree:
            case Name():
                return goal
            case Call("neg", (operand,)):
                return self._solved(operand, -goal, values)
            case Operation("**", base, Number(2)):
                return self._solved(base, goal.sqrt(), values)
            case Operation(operator, left, right):
                first = all(x in values for x in names(right))
                other = number(self._value(to_text(right if first else left), values))
                back = {
                    "+": lambda: goal - other,
                    "-": lambda: goal + other if first else other - goal,
                    "*": lambda: goal / other,
                    "/": lambda: goal * other if first else other / goal,
                }
                return self._solved(left if first else right, back[operator](), values)
        raise LedgerError(f"no value of what is in {to_text(tree)}")

    def _completed(
        self, context: Mapping[str, Any], known: Mapping[str, Any], rules: list[Rule]
    ) -> dict[str, Any]:
        """Return values of all names; raise LedgerError where two ways to one differ."""
        values = dict(known)
        for name, rule in rules:
            values[name] = rule(values)
        for name, text in self._texts(context, values):
            if not _is_zero(number(values[name]) - self._value(text, values)):
                raise LedgerError(f"{name} = {text} does not hold")
        return values


def _calls(tree: Expression) -> Iterator[str]:
    if isinstance(tree, Call) and tree.function != "neg":
        yield tree.function
    for part in children(tree):
        yield from _calls(part)


def _is_zero(value: Any) -> bool:
    return acb(value).contains(0)
