"""Vectors, quaternions, complex numbers and derivatives of the specification, by components.

A name may stand for several components: a vector for three, a quaternion for four, a complex number
for its real and imaginary part, and a matrix for its three rows.  Operations are those of physics:

    c*v, v/c      of a vector and a number: each component of v times c, or divided by it
    u*v, u/v      of two vectors: component by component, as a diagonal matrix acts
    p*q, q*v      of quaternions; a vector v is the quaternion (0, v)
    z*w, z/w, i   of complex numbers; i is the imaginary unit
    R*v           of a matrix and a vector
    dot(u, v), cross(u, v), conj(z)
    cis(psi)      cos psi + i sin psi, whose parts are called cos_psi and sin_psi
    d(x), d_x(y)  a small change of x, and the derivative of y by each input x

Axes may be left-handed.  The sign of their handedness is a factor of the cross products in products
of quaternions; in `cross` it is not.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from itertools import product
from typing import Any, TypeAlias

from rigidsym.language._expression import Call, Expression, Name, Number, Operation, to_text

# An expression, or the components of a vector, a quaternion, a complex number or a matrix.
Value: TypeAlias = Any
ZERO, ONE = Number(0), Number(1)


def plus(left: Value, right: Value) -> Value:
    """Return the sum of two values."""
    if isinstance(left, tuple) and isinstance(right, tuple):
        return tuple(plus(x, y) for x, y in zip(left, right, strict=True))
    if isinstance(left, tuple) or isinstance(right, tuple):  # x + z is the complex (x, 0) + z.
        (real, *rest), other = (left, right) if isinstance(left, tuple) else (right, left)
        if len(rest) != 1:
            raise ValueError("a number is added to a vector")
        return plus(real, other), *rest
    if ZERO in (left, right):
        return left if right == ZERO else right
    match right:
        case Call("neg", (operand,)):
            return Operation("-", left, operand)
    return Operation("+", left, right)


def minus(value: Value) -> Value:
    """Return a value with the opposite sign."""
    match value:
        case tuple():
            return tuple(map(minus, value))
        case Number(0):
            return value
        case Call("neg", (operand,)):
            return operand
    return Call("neg", (value,))


def times(left: Value, right: Value, hand: Expression = ONE) -> Value:
    """Return the product of two values along axes of a handedness."""
    if not isinstance(left, tuple):
        if isinstance(right, tuple):
            return tuple(times(left, part) for part in right)
        if ZERO in (left, right):
            return ZERO
        return right if left == ONE else left if right == ONE else Operation("*", left, right)
    if not isinstance(right, tuple):
        return tuple(times(part, right) for part in left)
    if isinstance(left[0], tuple):
        return tuple(dot(row, right) for row in left)
    match len(left), len(right):
        case 2, 2:
            (a, b), (x, y) = left, right
            return plus(times(a, x), minus(times(b, y))), plus(times(a, y), times(b, x))
        case 4, 3:
            return times(left, (ZERO, *right), hand)
        case 4, 4:
            (s, *u), (t, *v) = left, right
            along = plus(times(s, tuple(v)), times(t, tuple(u)))
            sides = plus(along, times(hand, cross(tuple(u), tuple(v))))
            return plus(times(s, t), minus(dot(tuple(u), tuple(v)))), *sides
    return tuple(times(x, y) for x, y in zip(left, right, strict=True))


def over(left: Value, right: Value) -> Value:
    """Return the quotient of two values."""
    if isinstance(left, tuple) and isinstance(right, tuple):
        if len(left) == len(right) == 2:
            return over(times(left, conj(right)), dot(right, right))
        return tuple(over(x, y) for x, y in zip(left, right, strict=True))
    if isinstance(left, tuple):
        return tuple(over(part, right) for part in left)
    return ZERO if left == ZERO else Operation("/", left, right)


def dot(left: Value, right: Value) -> Value:
    """Return the sum of the products of components."""
    total: Value = ZERO
    for x, y in zip(left, right, strict=True):
        total = plus(total, times(x, y))
    return total


def cross(left: Value, right: Value) -> Value:
    """Return the cross product along right-handed axes; `right` may be a matrix of rows."""
    u, v = left, right
    turns = ((1, 2), (2, 0), (0, 1))
    return tuple(plus(times(u[j], v[k]), minus(times(u[k], v[j]))) for j, k in turns)


def conj(value: Value) -> Value:
    """Return the conjugate of a complex number or of a quaternion."""
    return value[0], *map(minus, value[1:])


def derivative(expression: Expression, by: Callable[[str], Expression]) -> Expression:
    """Return the derivative of an expression, given the derivatives of the names in it."""

    def of(part: Expression) -> Expression:
        match part:
            case Name(name):
                return by(name)
            case Call("neg", (operand,)):
                return minus(of(operand))
            case Operation("+", a, b):
                return plus(of(a), of(b))
            case Operation("-", a, b):
                return plus(of(a), minus(of(b)))
            case Operation("*", a, b):
                return plus(times(of(a), b), times(a, of(b)))
            case Operation("/", a, b):
                return over(plus(of(a), minus(times(over(a, b), of(b)))), b)
            case Operation("**", a, Number(n)):
                power = a if n == 2 else Operation("**", a, Number(n - 1))
                return times(times(Number(n), power), of(a))
            case Number():
                return ZERO
            case Call("D", (a,)):
                return Call("D", (of(a),))
        raise ValueError(f"{part}: no derivative is known")

    return of(expression)


@dataclass(slots=True)
class Notation:
    """The names of one block that stand for several components, and those that depend on inputs."""

    axes: tuple[str, ...] = ("1", "2", "3")
    gap: str = ""
    hand: Expression = ONE
    named: dict[str, Value] = field(default_factory=lambda: {"i": (ZERO, ONE)})
    # What a name changes by with each input; "" is the input of small changes d.
    columns: dict[tuple[str, str], Expression] = field(default_factory=dict)

    def include(self, other: "Notation") -> None:
        """Add the names of another block, and its axes if it declares any."""
        self.named |= other.named
        self.columns |= other.columns
        if other.gap:
            self.axes, self.gap, self.hand = other.axes, other.gap, other.hand

    def declare(self, kind: str, content: str) -> None:
        """Read a clause that declares names: `vectors c Omega along a b d epsilon`, for example."""
        names, _, axes = content.partition(" along ")
        if axes:
            self.gap = "" if axes[0].isdigit() else "_"
            self.axes = tuple(axis.removeprefix("_") for axis in axes.split()[:3])
            self.hand = Name(axes.split()[3]) if len(axes.split()) > 3 else ONE
        for name in names.split():
            if kind == "complex":
                self.named[name] = Name(f"{name}_re"), Name(f"{name}_im")
            elif kind == "vectors":
                self.named[name] = tuple(Name(self._component(name, x)) for x in self.axes)
            elif kind == "quaternions":
                self.named[name] = tuple(Name(self._component(name, x)) for x in ("0", *self.axes))
            else:
                rows = (self._component(name, x) for x in self.axes)
                self.named[name] = tuple(tuple(Name(f"{x}{y}") for y in self.axes) for x in rows)

    def _component(self, name: str, axis: str) -> str:
        """Return a component: of Omega0 that along a is Omega_a0, of n_0 that along 1 is n1_0."""
        stem = re.split(r"[^A-Za-z]", name)[0]
        return f"{stem}{self.gap}{axis}{name.removeprefix(stem)}"

    def derive(self, content: str) -> None:
        """Read a clause on derivatives: `d: c Omega`, or `d_x: Omega by Omega_0 c; p by k = 1`.

        That of y by the input Omega_a0 is y_by_Omega_a, and that of y_t is y_Omega_a.
        """
        _, _, rest = content.partition(":")
        for item in rest.split(";"):
            names, _, inputs = item.partition("=")[0].partition(" by ")
            for y, x in product(self.all_of(names), [*self.all_of(inputs)] or [""]):
                by = re.sub("_?0$", "", x)
                called = f"{y[:-1]}{by}" if y.endswith("_t") else f"{y}_by_{by}"
                self.columns[y, x] = ONE if "=" in item else Name(called if x else f"d{y}")

    def all_of(self, names: str) -> Iterator[str]:
        """Yield names, and the components of those that have any."""
        for name in names.split():
            yield from map(to_text, _flat(self.named.get(name, Name(name))))

    @property
    def inputs(self) -> list[str]:
        """The inputs of all columns."""
        return [*dict.fromkeys(x for _, x in self.columns if x)]

    def value(self, tree: Expression, x: str = "") -> Value:
        """Return an expression by its components; `x` is the input that `d_x` is about."""
        match tree:
            case Name(name):
                return self.named.get(name, tree)
            case Call("neg", (operand,)):
                return minus(self.value(operand, x))
            case Operation("**", base, Number(2)) if isinstance(self.value(base, x), tuple):
                return times(self.value(base, x), self.value(base, x), self.hand)
            case Operation(symbol, left, right):
                a, b = self.value(left, x), self.value(right, x)
                match symbol:
                    case "+":
                        return plus(a, b)
                    case "-":
                        return plus(a, minus(b))
                    case "*":
                        return times(a, b, self.hand)
                    case "/":
                        return over(a, b)
                return Operation(symbol, a, b)
            case Call("dot" | "cross" | "conj" as function, arguments):
                return _FUNCTIONS[function](*(self.value(part, x) for part in arguments))
            case Call("cis", (Name(angle),)):
                return Name(f"cos_{angle}"), Name(f"sin_{angle}")
            case Call("d" | "d_x" as function, (argument,)):
                by = partial(self._column, x if function == "d_x" else "")
                return _each(lambda part: derivative(part, by), self.value(argument, x))
            case Call(function, (argument,)):
                return _each(lambda part: Call(function, (part,)), self.value(argument, x))
        return tree

    def _column(self, x: str, name: str) -> Expression:
        return self.columns.get((name, x), ONE if name == x else ZERO)


_FUNCTIONS: dict[str, Callable[..., Value]] = {"dot": dot, "cross": cross, "conj": conj}


def _each(function: Callable[[Expression], Expression], value: Value) -> Value:
    if isinstance(value, tuple):
        return tuple(_each(function, part) for part in value)
    return function(value)


def _flat(value: Value) -> Iterator[Expression]:
    if isinstance(value, tuple):
        for part in value:
            yield from _flat(part)
    else:
        yield value


def pairs(left: Value, right: Value) -> Iterable[tuple[Expression, Expression]]:
    """Yield the components of two values side by side; one expression may stand for all."""
    one = [*_flat(left)]
    other = [*_flat(right)] if isinstance(right, tuple) else [right] * len(one)
    return zip(one, other, strict=True)
