"""Values of a context's expressions modulo a prime, for many mutants of its definitions at once.

An equation that a context proves holds at all its points, also modulo a prime that divides no
denominator in the proof.  So one point at which both sides differ refutes the equation, and no
proof has to be tried.  Each entry of an array belongs to one mutant.
"""

from collections.abc import Mapping, Sequence
from functools import reduce
from typing import Any, TypeAlias

import numpy as np

from rigidsym.proof.kernel import Context, KernelError
from rigidsym.proof.kernel._language import Tree, parse

PRIME = 2**31 - 1
TRIES = 60  # draws of a point for a mutant
ENOUGH, MANY = 16, 2**17  # points of a context that are kept, and the most that are drawn
Array: TypeAlias = Any  # of int64, from 0 to PRIME - 1
# For each changed name: texts, each with its factors, whose sum is the name's new definition.
Changes: TypeAlias = Mapping[str, Sequence[tuple[str, Array]]]


def power(base: Array, exponent: int) -> Array:
    """Return a power modulo the prime."""
    result, square = np.ones_like(base), base
    while exponent:
        if exponent & 1:
            result = result * square % PRIME
        square, exponent = square * square % PRIME, exponent >> 1
    return result


class Values:
    """Values and time derivatives of expressions at given values of the generators.

    `defined` marks the entries at which no expression has been divided by zero.
    """

    def __init__(self, context: Context, changes: Changes, point: Mapping[str, Array]) -> None:
        self.context, self.changes = context, changes
        self.known: dict[str, Array] = dict(point)
        self.slopes: dict[str, Array] = {}
        self.defined: Array = np.True_

    def keep(self, chosen: Array) -> None:
        """Forget all mutants but the chosen ones."""
        self.changes = _chosen(self.changes, chosen)
        for table in (self.known, self.slopes):
            for name, values in table.items():
                table[name] = values[chosen] if values.size > 1 else values
        self.defined = self.defined[chosen] if self.defined.size > 1 else self.defined

    def value(self, tree: Tree) -> Array:
        """Return the values of an expression."""
        match tree:
            case int():
                return np.array([tree % PRIME])
            case str():
                return self._name(tree)
            case ("-", operand):
                return -self.value(operand) % PRIME
            case ("/", operand):
                return self._inverse(operand)
            case ("D", "(", argument):
                return self.rate(argument)
            case (_, "(", *_):
                raise KernelError(f"{tree[0]}(...) has no value")
            case (base, "**", int(exponent)):
                return power(self.value(base), exponent)
        total = self.value(tree[0])
        for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
            other = self._inverse(operand) if operator == "/" else self.value(operand)
            total = _combined(operator, total, other)
        return total

    def rate(self, tree: Tree) -> Array:
        """Return the time derivatives of an expression."""
        match tree:
            case int():
                return np.array([0])
            case str():
                return self._slope(tree)
            case ("-", operand):
                return -self.rate(operand) % PRIME
            case (base, "**", int(exponent)):
                slope = power(self.value(base), exponent - 1) * exponent % PRIME
                return slope * self.rate(base) % PRIME
            case (_, "(", *_):
                raise KernelError("second derivatives are not evaluated")
        total, slope = self.value(tree[0]), self.rate(tree[0])
        for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
            other, change = self.value(operand), self.rate(operand)
            if operator in "+-":
                slope = _combined(operator, slope, change)
            else:
                if operator == "/":  # D(1/x) = -D(x)/x**2
                    other = self._inverse(operand)
                    change = -change * (other * other % PRIME) % PRIME
                slope = (slope * other % PRIME + total * change % PRIME) % PRIME
            total = _combined(operator if operator in "+-" else "*", total, other)
        return slope

    def _inverse(self, tree: Tree) -> Array:
        value = self.value(tree)
        self.defined = self.defined & (value != 0)
        return power(value, PRIME - 2)

    def _name(self, name: str) -> Array:
        if name not in self.known:
            self.known[name] = self._sum(name, self.value)
        return self.known[name]

    def _sum(self, name: str, of: Any) -> Array:
        """Return what a definition, as it was or as it is changed, says of a name."""
        if name not in self.context.definitions:
            raise KernelError(f"{name!r} has no value here")
        if name not in self.changes:
            return of(parse(self.context.definitions[name]))
        terms = (of(parse(text)) * factors % PRIME for text, factors in self.changes[name])
        return reduce(lambda total, term: (total + term) % PRIME, terms)

    def _slope(self, name: str) -> Array:
        if name not in self.slopes:
            rates = self.context.rates
            if rates is None:
                raise KernelError("this context has no time derivative")
            if name not in self.context.generators:
                self.slopes[name] = self._sum(name, self.rate)
            elif rates.get(name) == "?":
                raise KernelError(f"D({name}) is not known")
            else:
                self.slopes[name] = self.value(parse(rates.get(name, "0")))
        return self.slopes[name]


def _chosen(changes: Changes, chosen: Array) -> Changes:
    return {x: [(text, n[chosen]) for text, n in terms] for x, terms in changes.items()}


def _combined(operator: str, x: Array, y: Array) -> Array:
    if operator in "+-":
        return (x + y if operator == "+" else x - y) % PRIME
    return x * y % PRIME


def leaders(context: Context) -> list[tuple[str, Tree]]:
    """Return the relations of a context, in order, each with the name that it is solved for.

    Raises KernelError if they cannot be solved one after the other.
    """
    trees = [parse(text) for text in context.relations]
    found: dict[str, Tree] = {}
    for tree in trees:
        names = _mentioned(tree, context)
        free = [x for x in context.generators if x in names and x not in found]
        if not free:
            raise KernelError(f"context {context.name}: its relations determine no point")
        found[free[-1]] = tree
    waiting, order = dict(found), []
    while waiting:
        for name, tree in waiting.items():
            if not (_mentioned(tree, context) & waiting.keys()) - {name}:
                order.append((name, waiting.pop(name)))
                break
        else:
            raise KernelError(f"context {context.name}: its relations determine each other")
    return order


def _mentioned(tree: Tree, context: Context) -> set[str]:
    """Return the generators in an expression and in the definitions that it uses."""
    waiting: list[Any] = [tree]
    seen: set[str] = set()
    while waiting:
        match waiting.pop():
            case str(name) if name not in seen:
                seen.add(name)
                if name in context.definitions:
                    waiting.append(parse(context.definitions[name]))
            case (*parts,):
                waiting += parts
    return seen & {*context.generators}


class Points:
    """Points of a context and of its mutants.

    Names that no relation determines take random values, and the relations give the others.  Roots
    exist for half of all values only, so `free` keeps values for which the context has a point.
    """

    def __init__(self, context: Context, seed: int) -> None:
        self.context, self.random = context, np.random.default_rng(seed)
        self.order: list[tuple[str, Tree]] = []
        try:
            self.order = leaders(context)
        except KernelError:  # its witness is the only point that is known
            at = Values(context, {}, {})
            self.free = {x: at.value(parse(context.witness[x])) for x in context.generators}
            return
        self.names = [x for x in context.generators if x not in dict(self.order)]
        size, valid, point = 512, np.zeros(1), {}
        while valid.sum() < ENOUGH and size < MANY:
            size *= 2
            point, valid = self._solved({}, self._any(size), size)
        self.free = {x: point[x][valid] for x in self.names}

    def of(self, changes: Changes, size: int) -> tuple[dict[str, Array], Array]:
        """Return a point of each mutant, and the mutants for which one was found."""
        point = {x: np.zeros(size, np.int64) for x in self.context.generators}
        left = np.arange(size)
        for turn in range(TRIES):
            free = self._any(len(left)) if turn % 2 and self.order else self._known(len(left))
            trial, valid = self._solved(_chosen(changes, left), free, len(left))
            for x, values in point.items():
                values[left[valid]] = trial[x][valid]
            left = left[~valid]
            if not len(left):
                break
        return point, ~np.isin(np.arange(size), left)

    def _known(self, size: int) -> dict[str, Array]:
        chosen = self.random.integers(max(map(len, self.free.values()), default=1), size=size)
        return {x: values[chosen] for x, values in self.free.items()}

    def _any(self, size: int) -> dict[str, Array]:
        return {x: self.random.integers(2, PRIME, size) for x in self.names}

    def _solved(
        self, changes: Changes, free: dict[str, Array], size: int
    ) -> tuple[dict[str, Array], Array]:
        """Solve the relations, and tell for which entries that was possible."""
        point, valid = dict(free), np.ones(size, bool)
        for name, tree in self.order:
            root, solved = _root(self.context, changes, point, name, tree)
            point[name], valid = root + np.zeros(size, np.int64), valid & solved
        if not self.order:
            values = Values(self.context, changes, point)
            for text in self.context.relations:
                valid &= values.value(parse(text)) == 0
        return point, valid


def _root(
    context: Context, changes: Changes, trial: Mapping[str, Array], name: str, tree: Tree
) -> tuple[Array, Array]:
    """Solve a relation of at most second degree for one name."""
    at = []
    for x in (0, 1, PRIME - 1):
        values = Values(context, changes, {**trial, name: np.array([x])})
        at.append(values.value(tree))
    half = (PRIME + 1) // 2
    constant = at[0]
    linear = (at[1] - at[2]) * half % PRIME
    square = ((at[1] + at[2]) * half - constant) % PRIME
    beneath = (linear * linear - 4 * (square * constant % PRIME)) % PRIME
    root = power(beneath, (PRIME + 1) // 4)
    straight = -constant * power(linear, PRIME - 2) % PRIME
    curved = (root - linear) * power(2 * square % PRIME, PRIME - 2) % PRIME
    solution = np.where(square == 0, straight, curved)
    values = Values(context, changes, {**trial, name: solution})
    return solution, (values.value(tree) == 0) & values.defined
