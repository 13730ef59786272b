"""Counterexamples to printed equations, with the motions in which they occur."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from rigidsym.language._expression import Call, Expression, Name, Number, Operation, parse
from rigidsym.proof.paper._answers import Answer, Data

# The names that contexts give to moments of inertia and rates, in the order of the axes.
NAMED = (
    (("c1", "c2", "c3"), ("Omega1", "Omega2", "Omega3")),
    (("c_i", "c_j", "c_k"), ("Omega_i", "Omega_j", "Omega_k")),
)
MOMENTA = ("M1", "M2", "M3")


@dataclass(frozen=True, slots=True)
class Motion:
    """Principal moments of inertia and body rates of a motion.

    They are about axes 1, 2 and 3; those of Lemma 1 are about axes i, j and k.
    """

    inertia: tuple[Fraction, Fraction, Fraction]
    omega: tuple[Fraction, Fraction, Fraction]

    def to_json(self) -> dict[str, Any]:
        """Return the motion as JSON data."""
        return {"inertia": [*map(str, self.inertia)], "omega": [*map(str, self.omega)]}

    def __str__(self) -> str:
        inertia, omega = (", ".join(map(str, values)) for values in (self.inertia, self.omega))
        return f"c = ({inertia}), Omega = ({omega})"


# The motion at the points of contexts that name amplitudes, a rate and a parameter.  Its first
# axis, i in Lemma 1, is the middle one.
ABOUT_MIDDLE = Motion(
    (Fraction(16, 25), Fraction(3600, 6409), Fraction(1)),
    (Fraction(53, 64), Fraction(-6409, 6000), Fraction(24, 25)),
)
BY_AMPLITUDES = {
    *("printed_sine", "printed_sine_divided", "printed_under_root", "printed_20", "printed_21"),
    *("printed_35", "printed_36", "printed_36_of_modulus"),
}


def motion_at(context: str, values: "Instant") -> Motion | None:
    """Return the rigid-body motion at a point of a context.

    Returns None if the context names no motion.
    If it names only the momentum, the body has the moments 2, 3, 5/2.
    """
    if context in BY_AMPLITUDES:
        return ABOUT_MIDDLE
    for moments, rates in NAMED:
        if {*moments, *rates} <= values.names:
            c, omega = (tuple(map(values.of, names)) for names in (moments, rates))
            return Motion((c[0], c[1], c[2]), (omega[0], omega[1], omega[2]))
    if {*MOMENTA} <= values.names:
        c = (Fraction(2), Fraction(3), Fraction(5, 2))
        m = [values.of(name) for name in MOMENTA]
        return Motion(c, (m[0] / c[0], m[1] / c[1], m[2] / c[2]))
    return None


LONG = 80


@dataclass(frozen=True, slots=True)
class Counterexample:
    """A point where an equation fails, with the values of both sides.

    `motion` is the body and its rates at this point, if the context has names for them.
    """

    fact: str
    point: Mapping[str, str]
    lhs: str
    rhs: str
    left: Fraction
    right: Fraction
    motion: Motion | None

    @property
    def sides(self) -> tuple[str, str]:
        """Both sides of the equation with their values, as text.

        "left side" and "right side" stand for long expressions.
        """
        left = self.lhs if len(self.lhs) < LONG else "left side"
        right = self.rhs if len(self.rhs) < LONG else "right side"
        return f"{left} = {self.left}", f"{right} = {self.right}"

    def to_json(self) -> dict[str, Any]:
        """Return the counterexample as JSON data."""
        return {
            "fact": self.fact,
            "point": dict(self.point),
            "lhs": self.lhs,
            "rhs": self.rhs,
            "left": str(self.left),
            "right": str(self.right),
            "motion": self.motion.to_json() if self.motion else None,
        }


def counterexample(answer: Answer, contexts: Mapping[str, Data]) -> Counterexample | None:
    """Return the counterexample to an equation, or None if there is none.

    It is for the first component that fails.
    """
    if answer.fact is None or answer.holds:
        return None
    point = answer.fact["certificate"]["point"]
    instant = Instant(contexts[answer.question.context], point)
    for lhs, rhs in zip(answer.fact["lhs"], answer.fact["rhs"], strict=True):
        left, right = instant.value(parse(lhs)), instant.value(parse(rhs))
        if left != right:
            motion = motion_at(answer.question.context, instant)
            return Counterexample(answer.fact["id"], point, lhs, rhs, left, right, motion)
    return None


class Instant:
    """A rational point at which a context's expressions are evaluated exactly.

    Time derivatives are evaluated, too.
    """

    def __init__(self, context: Data, point: Mapping[str, str]) -> None:
        self.context, self.point = context, point
        self._known: dict[str, Fraction] = {}

    @cached_property
    def names(self) -> set[str]:
        """The names of quantities that have a value at the point."""
        return {*self.point, *self.context["definitions"]}

    def of(self, name: str) -> Fraction:
        """Return the value of a name at the point."""
        if name not in self._known:
            text = self.point[name] if name in self.point else self.context["definitions"][name]
            self._known[name] = self.value(parse(text))
        return self._known[name]

    def value(self, tree: Expression) -> Fraction:
        """Return the value of an expression at the point."""
        match tree:
            case Number(value):
                return Fraction(value)
            case Name(name):
                return self.of(name)
            case Call("neg", (inner,)):
                return -self.value(inner)
            case Call("D", (inner,)):
                return self.value(self.rate(inner))
            case Operation("**", base, Number(exponent)):
                return self.value(base) ** exponent
            case Operation(operator, left, right):
                x, y = self.value(left), self.value(right)
                return {"+": x + y, "-": x - y, "*": x * y}[operator] if operator != "/" else x / y
        raise ValueError(f"{tree} has no value")

    def rate(self, tree: Expression) -> Expression:
        """Differentiate an expression with respect to time."""
        match tree:
            case Number():
                return Number(0)
            case Name(name):
                text = self.context["definitions"].get(name)
                if text is not None:
                    return self.rate(parse(text))
                return parse((self.context["rates"] or {}).get(name, "0"))
            case Call("neg", (inner,)):
                return Call("neg", (self.rate(inner),))
            case Call("D", (inner,)):
                return self.rate(self.rate(inner))
            case Operation("**", base, Number(exponent)):
                slope = Operation(
                    "*", Number(exponent), Operation("**", base, Number(exponent - 1))
                )
                return Operation("*", slope, self.rate(base))
            case Operation("*", left, right):
                first = Operation("*", self.rate(left), right)
                return Operation("+", first, Operation("*", left, self.rate(right)))
            case Operation("/", left, right):
                above = Operation("-", self.rate(left), Operation("*", tree, self.rate(right)))
                return Operation("/", above, right)
            case Operation(operator, left, right):
                return Operation(operator, self.rate(left), self.rate(right))
        raise ValueError(f"{tree} has no rate")
