"""Vectors, quaternions and complex numbers of a specification, and residues of expressions.

Both parse by the grammar of ledgers.  `rigidsym.language._notation` defines the notation.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from hashlib import sha256
from itertools import product
from typing import Any, TypeAlias

from flint import fmpz_mod, fmpz_mod_ctx

from rigidsym.proof.checker._language import Form, Language
from rigidsym.proof.checker._records import Refused

# An expression, or the list of components of a vector, a quaternion, a complex number or a matrix.
Value: TypeAlias = Any
FIELD = fmpz_mod_ctx(2**127 - 1)


@dataclass(slots=True)
class Components(Language[Value]):
    """Parser of a block's expressions into components."""

    axes: list[str] = field(default_factory=lambda: ["1", "2", "3"])
    gap: str = ""
    hand: Form = 1
    named: dict[str, Value] = field(default_factory=lambda: {"i": [0, 1]})
    # What a quantity changes by with an input, or with none in particular.
    columns: dict[tuple[Form, str], Form] = field(default_factory=dict)
    # The input that d_x is about.
    x: str = ""

    def take(self, other: "Components") -> None:
        """Add the names of another block, and its axes if they are not 1, 2 and 3."""
        if other.axes != ["1", "2", "3"]:
            self.axes, self.gap, self.hand = other.axes, other.gap, other.hand
        self.named, self.columns = self.named | other.named, self.columns | other.columns

    def declare(self, word: str, rest: str) -> None:
        """Read one of the clauses that declare names."""
        if word == "derivatives":
            self._depend(rest.split(":")[1])
            return
        if word == "write":
            for name, text in (item.split(" = ", 1) for item in rest.split(";")):
                self.named[name.strip()] = self.read(text.strip())
            return
        names, _, axes = rest.partition(" along ")
        if axes:
            self.axes, self.hand = axes.split()[:3], [*axes.split(), 1][3]
            self.gap, self.axes = "_" * (axes[0] != "1"), [x.strip("_") for x in self.axes]
        for name in names.split():
            along = {"vectors": self.axes, "quaternions": ["0", *self.axes]}
            if word == "complex":
                self.named[name] = [f"{name}_re", f"{name}_im"]
            elif word == "matrices":
                self.named[name] = [[f"{name}{j}{k}" for k in self.axes] for j in self.axes]
            else:
                self.named[name] = [self._part(name, axis) for axis in along[word]]

    def _part(self, name: str, axis: str) -> str:
        end = len(re.split(r"[^A-Za-z]", name)[0])
        return name[:end] + self.gap + axis + name[end:]

    def _depend(self, items: str) -> None:
        for item in items.split(";"):
            what, _, value = item.partition(" = ")
            outputs, _, inputs = what.partition(" by ")
            for y, x in product(self.parts(outputs), [*self.parts(inputs)] or [""]):
                # Where Omega_a0 is an input, it is called Omega_a; Omega1_0 is called Omega1.
                word = x.removesuffix("0").removesuffix("_")
                called = y[:-1] + word if y.endswith("_t") else f"{y}_by_{word}"
                self.columns[y, x] = int(value) if value else called if x else f"d{y}"

    def parts(self, names: str) -> Iterator[str]:
        """Yield names, or their components."""
        for name in names.split():
            yield from flat(self.named.get(name, name))

    def inputs(self, item: str) -> list[str]:
        """Return the inputs that an item is about one after the other."""
        return [*dict.fromkeys(x for _, x in self.columns if x)] if "d_x(" in item else [""]

    def number(self, number: int) -> Value:
        """Return a number."""
        return number

    def name(self, name: str) -> Value:
        """Return a name or its components."""
        return self.named.get(name, name)

    def negative(self, operand: Value) -> Value:
        """Return the negative of each component."""
        return each(lambda part: part and ("-", part), operand)

    def power(self, base: Value, exponent: int) -> Value:
        """Return a power; of several components, the square."""
        return self.combine("*", base, base) if isinstance(base, list) else ("**", base, exponent)

    def combine(self, operator: str, left: Value, right: Value) -> Value:
        """Return a sum, difference, product or quotient by components."""
        sizes = [len(value) if isinstance(value, list) else 1 for value in (left, right)]
        if operator in "+-" and sorted(sizes) == [1, 2]:
            left, right = (x if isinstance(x, list) else [x, 0] for x in (left, right))
        elif operator == "*" and sizes == [3, 3] and isinstance(left[0], list):
            return [self.call("dot", [row, right]) for row in left]
        elif operator == "*" and sizes in ([2, 2], [4, 4], [4, 3]):
            return self._product(left, right if len(right) != 3 else [0, *right])
        elif operator == "/" and sizes == [2, 2]:
            over = self.call("dot", [right, right])
            return self.combine("/", self._product(left, self.call("conj", [right])), over)
        if isinstance(left, list) and isinstance(right, list):
            return [self.combine(operator, *pair) for pair in zip(left, right, strict=True)]
        if isinstance(left, list):
            return [self.combine(operator, part, right) for part in left]
        if isinstance(right, list):
            return [self.combine(operator, left, part) for part in right]
        if left == 0 or right == 0:
            return _with_zero(operator, left, right)
        if operator == "*" and left == 1:
            return right
        return operator, left, right

    def _product(self, left: list[Value], right: list[Value]) -> Value:
        """Return a product of complex numbers or quaternions, by the table of their units."""
        found: list[Value] = [0] * len(left)
        for j, x in enumerate(left):
            for k, y in enumerate(right):
                product = self.combine("*", x, y)
                if j and k and j != k:
                    product = self.combine("*", self.hand, product)
                # i j = k and i i = -1, in this order of the units.
                falls = j and k and (j == k or j % 3 + 1 != k)
                found[j ^ k] = self.combine("-" if falls else "+", found[j ^ k], product)
        return found

    def call(self, function: str, arguments: list[Value]) -> Value:
        """Return a function of components."""
        match function, arguments:
            case "conj", [[real, *rest]]:
                return [real, *map(self.negative, rest)]
            case "dot", [left, right]:
                total: Value = 0
                for x, y in zip(left, right, strict=True):
                    total = self.combine("+", total, self.combine("*", x, y))
                return total
            case "cross", [u, v]:
                sides = [[(u[j], v[k]), (u[k], v[j])] for j, k in ((1, 2), (2, 0), (0, 1))]
                return [
                    self.combine("-", *(self.combine("*", *pair) for pair in pairs))
                    for pairs in sides
                ]
            case "cis", [str(angle)]:
                return [f"cos_{angle}", f"sin_{angle}"]
            case "d" | "d_x", [value]:
                return each(lambda part: self._derivative(function, part), value)
            case _, [value]:
                return each(lambda part: ("call", function, part), value)
        raise Refused(f"specification: {function!a} of {len(arguments)}")

    def _derivative(self, function: str, form: Form) -> Form:
        """Return the derivative of a name as a name, and others with those of all names in it."""
        if isinstance(form, tuple) and form[:2] == ("call", "D"):
            return "call", "D", self._derivative(function, form[2])
        if not isinstance(form, str):
            return (
                "by",
                form,
                tuple(
                    (name, self._derivative(function, name)) for name in sorted(names_in([form]))
                ),
            )
        return self.columns.get((form, self.x if function == "d_x" else ""), int(form == self.x))


def _with_zero(operator: str, left: Value, right: Value) -> Value:
    if operator in "*/":
        return 0
    return left if right == 0 else right if operator == "+" else ("-", right)


def each(function: Callable[[Form], Value], value: Value) -> Value:
    """Apply a function to each component."""
    return [each(function, part) for part in value] if isinstance(value, list) else function(value)


def flat(value: Value) -> list[Any]:
    """Return the components as one list."""
    return [x for part in value for x in flat(part)] if isinstance(value, list) else [value]


def names_in(forms: Iterable[Any]) -> set[str]:
    """Return the names in some expressions."""
    found, waiting = set[str](), [*forms]
    while waiting:
        form = waiting.pop()
        if isinstance(form, tuple) and form[0] == "by":
            waiting += form[1], *(slope for _, slope in form[2])
        elif isinstance(form, tuple):
            waiting += form[2:] if form[0] == "call" else form[1:]
        elif isinstance(form, set):
            waiting += form
        elif isinstance(form, str):
            found.add(form)
    return found


class Residues:
    """Residues of expressions modulo a prime, where free names are drawn from a seed."""

    def __init__(
        self, seed: str, free: list[str], meanings: dict[str, Form], rates: dict[str, Form] | None
    ) -> None:
        self.seed, self.rates = seed, rates
        self.meanings = {name: form for name, form in meanings.items() if name not in free}
        self.unread = {**self.meanings}
        self.found = {name: self._draw(name) for name in free}
        self.moves: dict[str, fmpz_mod] = {}

    def _draw(self, name: str) -> fmpz_mod:
        return FIELD(int.from_bytes(sha256(f"{name}|{self.seed}".encode()).digest()))

    def of(self, form: Any) -> fmpz_mod:
        """Return the residue of an expression, or raise LookupError if it has none."""
        match form:
            case int():
                return FIELD(form)
            case str():
                if form not in self.found:
                    self.found[form] = self.of(self.unread.pop(form))
                return self.found[form]
            case ("-", operand):
                return -self.of(operand)
            case ("by", operand, slopes):
                return self.slope(operand, {name: self.of(x) for name, x in slopes}.__getitem__)
            case ("call", "D", operand):
                return self.slope(operand, self._rate)
            case ("**", base, exponent):
                return self.of(base) ** exponent
            case (operator, left, right):
                x, y = self.of(left), self.of(right)
                match operator:
                    case "+":
                        return x + y
                    case "-":
                        return x - y
                    case "*":
                        return x * y
                    case "/":
                        return x / y
        raise LookupError(f"{form} has no residue")

    def said(self, said: tuple[str, Form, Form]) -> Any:
        """Return the residues of a statement; of an equation, that of its difference squared."""
        relation, left, right = said
        if relation == "=":
            return (self.of(left) - self.of(right)) ** 2
        return relation, self.of(left), self.of(right)

    def slope(self, form: Any, by: Callable[[str], fmpz_mod]) -> fmpz_mod:
        """Return the residue of a derivative, by those of the names."""
        match form:
            case int():
                return FIELD(0)
            case str():
                return by(form)
            case ("-", operand):
                return -self.slope(operand, by)
            case ("**", base, exponent):
                return exponent * self.of(base) ** (exponent - 1) * self.slope(base, by)
            case ("+" | "-" | "*" | "/" as operator, left, right):
                x, y = self.slope(left, by), self.slope(right, by)
                if operator in "+-":
                    return x + y if operator == "+" else x - y
                if operator == "*":
                    return x * self.of(right) + self.of(left) * y
                return (x - self.of(form) * y) / self.of(right)
        raise LookupError(f"{form} has no derivative")

    def _rate(self, name: str) -> fmpz_mod:
        if name not in self.moves:
            self.of(name)
            if name in self.meanings:
                self.moves[name] = self.slope(self.meanings[name], self._rate)
            elif self.rates is None:
                raise LookupError("this context has no time derivative")
            else:
                rate = self.rates.get(name, 0)
                self.moves[name] = self._draw(f"{name}'") if rate == "unknown" else self.of(rate)
        return self.moves[name]
